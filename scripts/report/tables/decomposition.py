"""Where the error comes from: the bound, and the terms of MSE and FLIP."""

import numpy

from report.table import Cell, Column, Table, figure, number, spec, word
from report.tables.flip import scene_table

TERMS = ("render", "sampling", "encoding", "render_sampling",
         "render_encoding", "sampling_encoding")
TERM_NAMES = {
    "render": "rendering |b|²", "sampling": "sampling |s|²",
    "encoding": "encoding |e|²", "render_sampling": "2 b·s",
    "render_encoding": "2 b·e", "sampling_encoding": "2 s·e"}
DISTANCES = {
    "reference_converged": "R to converged",
    "converged_fragments": "converged to fragments",
    "fragments_grid": "fragments to grid",
    "reference_grid": "R to grid", "oracle": "oracle"}
INNER = {"capacity": "capacity", "masks": "masks", "colors": "colors"}
# How exactly the terms must add up, relative to the total.
SUM_TOLERANCE = 1e-9


def gap(study):
    """The optimality gap by scene, runs below the bound marked."""
    figures = study.gap
    table = scene_table(
        study, "optimality-gap", "Optimality gap by scene",
        "MSE over the least MSE that two unrounded colors a cell can reach "
        "with the encoder's glyphs on the reference's raster (1 is the "
        "bound).", figures, lambda v: number(v, 2),
        ("geometric mean", figures.geometric_mean))
    broken = study.bounds_broken()
    for run in broken:
        row = table.rows[figures.encoders.index(run.encoder)]
        row[1 + figures.scenes.index(run.scene)].warn = True
    if broken:
        table.notes.append("Marked: below the bound, which is a measuring "
                           "error.")
    return table


def terms_of(study):
    """{term: Matrix} of the MSE's terms, with total and font."""
    return {term: study.decomposed("mse", term)
            for term in (*TERMS, "total", "font")}


def sums_hold(study):
    """Whether the six terms of every run add up to its total."""
    for run in study.runs:
        found = run.value("decomposition", "mse")
        if found and None not in [found.get(t) for t in TERMS]:
            off = abs(sum(found[t] for t in TERMS) - found["total"])
            if off > SUM_TOLERANCE * max(1.0, abs(found["total"])):
                return False
    return True


def terms(study):
    """The six terms of the MSE, of every encoder and scene."""
    figures = terms_of(study)
    total = figures["total"]
    table = Table(
        study.name("decomposition"), study.title("MSE by its causes"),
        study.caption(
            "MSE × 10⁴ split into rendering (converged image against the "
            "reference), sampling (fragments against the converged image), "
            "encoding (grid against fragments) and the cross terms, which "
            "may be negative; all six add up to the total. Font: what a "
            "font's shapes add to it.", len(total.scenes)),
        [Column("scene", left=True), Column("encoder", left=True)]
        + [Column(TERM_NAMES[t]) for t in TERMS]
        + [Column("total"), Column("font")])
    for scene in total.scenes:
        for encoder in total.encoders:
            if total.get(encoder, scene) is None:
                continue
            row = [word(scene), spec(encoder, study.names)]
            for name in (*TERMS, "total", "font"):
                value = figures[name].get(encoder, scene)
                row.append(figure(None if value is None else value * 1e4))
            table.rows.append(row)
    if table and not sums_hold(study):
        table.notes.append("⚠ The terms of some runs do not add up to their "
                           "total: a measuring error.")
    return table


def mean_shares(study):
    """{encoder: {term: mean over scenes of term / total}}."""
    figures = terms_of(study)
    total = figures["total"]
    found = {}
    for encoder in total.encoders:
        shares = [[figures[t].get(encoder, s) / total.get(encoder, s)
                   for t in TERMS] for s in total.scenes
                  if total.get(encoder, s)
                  and None not in [figures[t].get(encoder, s)
                                   for t in TERMS]]
        if shares:
            found[encoder] = dict(zip(TERMS, numpy.mean(shares, axis=0)))
    return found


def shares(study):
    """The terms as shares of the total, averaged over scenes."""
    found = mean_shares(study)
    table = Table(
        study.name("decomposition-shares"),
        study.title("Shares of the MSE by cause"),
        study.caption("Each term as a share of the scene's own MSE in "
                      "percent, averaged over scenes; they add up to 100.",
                      len(study.decomposed("mse", "total").scenes)),
        [Column("encoder", left=True)]
        + [Column(TERM_NAMES[t]) for t in TERMS])
    for encoder, row in found.items():
        table.rows.append([spec(encoder, study.names)] + [
            Cell(number(100 * row[t], 1).text, row[t]) for t in TERMS])
    return table


def columns_by_scene(study, name, title, lead, group, keys, show):
    """Scene x encoder down, the keys of one group across."""
    figures = {key: study.decomposed(group, key) for key in keys}
    known = [found for found in figures.values() if found]
    table = Table(study.name(name), study.title(title),
                  study.caption(lead, len(known[0].scenes) if known else 0),
                  [Column("scene", left=True), Column("encoder", left=True)]
                  + [Column(heading) for heading in keys.values()])
    table.stated = study.stated(group)
    for scene in study.flip.scenes:
        for encoder in study.flip.encoders:
            row = [figures[key].get(encoder, scene) for key in keys]
            if any(value is not None for value in row):
                table.rows.append([word(scene), spec(encoder, study.names),
                                   *map(show, row)])
    return table


def distances(study):
    """FLIP is not additive: its distances along the way."""
    return columns_by_scene(
        study, "flip-distances", "FLIP along the way",
        "FLIP between reference, converged image, fragments and grid. FLIP "
        "is not additive. The oracle encodes the reference itself.", "flip",
        DISTANCES, lambda v: number(v, 4))


def inner(study):
    """The encoder's own MSE against the fragments."""
    return columns_by_scene(
        study, "inside-the-encoder", "Inside the encoder",
        "MSE × 10⁴ against the fragments' raster: what the glyph set can do "
        "at best (capacity), what the chosen masks and the chosen colors "
        "add.", "inner", INNER,
        lambda v: figure(None if v is None else v * 1e4))
