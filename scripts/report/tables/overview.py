"""The figures to quote: what each encoder costs and how far it is off."""

from report import matrix
from report.table import Column, NONE, Table, figure, number, spec, word
from report.tables.flip import DIGITS, difference_cells, shown_pair


def overview(study):
    """One row an encoder, best first; the first view alone has it."""
    figures = study.flip
    pairs = matrix.against_controls(figures)
    table = Table(
        "overview", "Overview", study.caption(
            "Means over scenes (the tables by scene have each), best "
            "first: rays a cell, milliseconds a frame (geometric mean of "
            "medians), FLIP, and its paired differences to the controls with "
            "95 % BCa intervals (negative is better); p after Holm over the "
            f"{len(pairs)} pairs.", len(figures.scenes), with_times=True),
        [Column("encoder", left=True), Column("rays"), Column("ms"),
         Column("FLIP")], stated=study.stated("FLIP"))
    controls = [c for c in matrix.CONTROLS if c in figures.encoders]
    for control in controls:
        table.columns += [Column(f"− {control} [95 %]"), Column("p")]
    for encoder in sorted(figures.complete(), key=figures.mean):
        row = [spec(encoder, study.names),
               number(study.rays.mean(encoder), 1), cost(study.ms, encoder),
               number(figures.mean(encoder), DIGITS)]
        for control in controls:
            pair = shown_pair(pairs, figures, encoder, control)
            row += difference_cells(pair)[:2]
        table.rows.append(row)
    timed = study.ms.scenes
    if timed and len(timed) < len(figures.scenes):
        table.notes.append(f"Times are of {', '.join(timed)} alone.")
    rest = [e for e in figures.encoders if e not in figures.complete()]
    if rest:
        table.notes.append("Not on every scene, and so not here: "
                           + ", ".join(study.names[e] for e in rest) + ".")
    return table


def cost(figures, encoder):
    """The geometric mean, where every scene has a time."""
    if len(figures.row(encoder)) < max(1, len(figures.scenes)):
        return word(NONE)
    return figure(figures.geometric_mean(encoder))
