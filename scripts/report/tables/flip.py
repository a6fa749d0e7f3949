"""The primary measure: FLIP by scene, and its paired differences."""

import numpy

from report import matrix, statistics
from report.table import (Column, Table, decimals, interval, number,
                          p_value, record_of, spec, word)

DIGITS = 4


def scene_table(study, name, title, lead, figures, show, mean, runs=None):
    """Encoders down, scenes across; `mean` = (heading, function)."""
    columns = [Column("encoder", left=True)]
    columns += [Column(scene, upright=False) for scene in figures.scenes]
    columns.append(Column(mean[0], upright=False))
    table = Table(study.name(name), study.title(title),
                  study.caption(lead, len(figures.scenes), runs), columns)
    best = {scene: figures.best(scene) for scene in figures.scenes}
    for encoder in figures.encoders:
        row = [spec(encoder, study.names)]
        for scene in figures.scenes:
            value = figures.get(encoder, scene)
            cell = show(value)
            cell.best = value is not None and value == best[scene]
            row.append(cell)
        # A mean over other scenes than the others' would mislead.
        whole = len(figures.row(encoder)) == len(figures.scenes)
        row.append(show(mean[1](encoder) if whole else None))
        table.rows.append(row)
    if len(figures.complete()) < len(figures.encoders):
        table.notes.append("No mean where a scene is missing.")
    return table


def by_scene(study):
    figures = study.flip
    table = scene_table(
        study, "flip-by-scene", "FLIP by scene", "Mean FLIP (the primary "
        "measure, lower is better) of each encoder and scene.", figures,
        lambda v: number(v, DIGITS), ("mean", figures.mean))
    table.stated = study.stated("FLIP")
    return table


def by_time(study):
    """Scenes at several times, each for itself."""
    times = {}
    for run in study.runs:
        times.setdefault(run.scene, set()).add(run.time)
    runs = [run for run in study.runs if len(times[run.scene]) > 1]
    at = {}
    for run in runs:
        key = run.scene, run.encoder
        at.setdefault(key, {}).setdefault(run.time, []).append(
            run.value("metrics", "flip"))
    columns = sorted({run.time for run in runs})
    table = Table(
        study.name("flip-by-time"), study.title("FLIP at several times"),
        study.caption("Mean FLIP of the scenes that were measured at several "
                      "times; the other tables take the times that all "
                      "encoders of a scene have.", len({r.scene for r in runs}),
                      runs),
        [Column("scene", left=True), Column("encoder", left=True)]
        + [Column(f"{time:g} s") for time in columns],
        stated=study.stated("FLIP"))
    for (scene, encoder), found in sorted(at.items()):
        table.rows.append(
            [word(scene), spec(encoder, study.names)]
            + [number(numpy.mean(found[t]) if t in found else None, DIGITS)
               for t in columns])
    return table


def mean_ranks(figures):
    """({encoder: mean rank}, the Friedman test in words)."""
    encoders = figures.complete()
    found = statistics.friedman(figures.blocks())
    if found is None:
        return {}, ""
    chi_square, p, ranks = found
    shown = "< 0.001" if p < 0.001 else f"= {p:.3f}"
    return (dict(zip(encoders, ranks)),
            f"Friedman test over {len(encoders)} encoders with a figure for "
            f"all {len(figures.scenes)} scenes: χ² = {chi_square:.2f} with "
            f"{len(encoders) - 1} degrees of freedom, p {shown}.")


def difference_cells(comparison):
    """Difference with its interval, Holm's p, wins / ties / losses."""
    if comparison is None:
        return [word("–")] * 3
    return [interval(comparison.mean, comparison.low, comparison.high,
                     decimals(DIGITS)),
            p_value(comparison.p_holm), record_of(comparison)]


def summary(study):
    figures = study.flip
    pairs = matrix.against_controls(figures)
    ranks, friedman = mean_ranks(figures)
    columns = [Column("encoder", left=True), Column("n"),
               Column("mean FLIP"), Column("mean rank")]
    for control in matrix.CONTROLS:
        columns += [Column(f"− {control} [95 %]"), Column("p (Holm)"),
                    Column("w / t / l")]
    table = Table(
        study.name("flip-summary"), study.title("FLIP against the controls"),
        study.caption(
            "Mean paired differences of FLIP to the controls half and tiv "
            "over scenes (negative is better) with 95 % BCa bootstrap "
            f"intervals ({statistics.RESAMPLES:,} resamples); p of "
            f"{sign_flip_words(len(figures.scenes))}, adjusted by Holm over "
            f"the {len(pairs)} pairs of this table; wins / ties (within "
            f"{statistics.FLIP_TIE} FLIP) / losses.", len(figures.scenes)),
        columns, stated=study.stated("FLIP"))
    for encoder in sorted(figures.encoders, key=figures.mean):
        row = [spec(encoder, study.names), number(len(figures.row(encoder)), 0),
               number(figures.mean(encoder), DIGITS),
               number(ranks.get(encoder), 2)]
        for control in matrix.CONTROLS:
            row += difference_cells(shown_pair(pairs, figures, encoder,
                                               control))
        table.rows.append(row)
    if friedman:
        table.notes.append(friedman)
    return table


def sign_flip_words(scenes):
    if scenes <= statistics.EXACT_UP_TO:
        return "the exact sign-flip permutation test"
    return "the sign-flip permutation test over random signs"


def shown_pair(pairs, figures, encoder, control):
    """The pair as encoder - control, also where it was tested reversed."""
    if (encoder, control) in pairs:
        return pairs[encoder, control]
    if (control, encoder) in pairs:
        reverse = matrix.compare(figures, encoder, control)
        reverse.p_holm = pairs[control, encoder].p_holm
        return reverse
    return None
