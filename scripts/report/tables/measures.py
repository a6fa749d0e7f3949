"""The other measures: by scene, as ratios, and how far they agree."""

import numpy

from report import matrix, statistics
from report.table import (Column, NONE, Table, figure, interval, number,
                          p_value, record_of, significant, spec, word)
from report.tables.flip import scene_table

# Those that are compared with each other; higher is better for the second.
LOWER = ("flip", "mse", "rmse_linear", "rel_mse", "ciede2000")
HIGHER = ("ssim", "ms_ssim")
MEASURES = LOWER + HIGHER


def by_scene(study):
    """MSE, CIEDE2000, rays and bytes by scene, whose means others show."""
    mse, color = study.metric("mse"), study.metric("ciede2000")
    shown = [
        ("mse", "MSE by scene", "Mean squared error × 10⁴ of sRGB values.",
         mse, lambda v: figure(None if v is None else v * 1e4),
         ("geometric mean", mse.geometric_mean)),
        ("ciede2000", "CIEDE2000 by scene", "Mean CIEDE2000.",
         color, lambda v: number(v, 2), ("mean", color.mean)),
        ("rays", "Rays a cell by scene",
         "Rays that the encoder asked for, a cell.", study.rays, figure,
         ("mean", study.rays.mean)),
        ("bytes", "Bytes a frame by scene", "Bytes of a frame as ANSI text.",
         study.bytes, lambda v: number(v, 0),
         ("geometric mean", study.bytes.geometric_mean))]
    return [scene_table(study, f"{name}-by-scene", title, lead, figures,
                        show, mean)
            for name, title, lead, figures, show, mean in shown if figures]


def ratios(study):
    """MSE, time and bytes against the controls, on logarithms."""
    columns = [Column("measure", left=True), Column("encoder", left=True),
               Column("n")]
    for control in matrix.CONTROLS:
        columns += [Column(f"/ {control} [95 %]"), Column("p"),
                    Column("w / t / l")]
    table = Table(
        study.name("ratios"), study.title("Ratios to the controls"),
        study.caption(
            "Geometric means over scenes of the ratio to the control, with "
            "95 % BCa bootstrap intervals and sign-flip p values, all on "
            "logarithms; below 1 is better. The p values are not adjusted: "
            "FLIP alone is tested, these describe. The figures by scene "
            "stand in tables of their own.", len(study.flip.scenes),
            with_times=True),
        columns)
    for name, figures in (("MSE", study.metric("mse")), ("time", study.ms),
                          ("bytes", study.bytes)):
        for encoder in figures.encoders:
            row = [word(name), spec(encoder, study.names),
                   number(len(figures.row(encoder)), 0)]
            for control in matrix.CONTROLS:
                row += ratio_cells(figures, encoder, control)
            table.rows.append(row)
    return table


def ratio_cells(figures, encoder, control):
    comparison = (matrix.compare_ratio(figures, encoder, control)
                  if encoder != control else None)
    if comparison is None:
        return [word(NONE)] * 3
    return [interval(comparison.mean, comparison.low, comparison.high,
                     significant),
            p_value(comparison.p), record_of(comparison)]


def present(study):
    """{measure: Matrix} of the measures that every run has."""
    found = {}
    for name in MEASURES:
        figures = study.metric(name)
        if figures and len(figures.complete()) == len(study.flip.encoders):
            found[name] = figures
    return found


def scene_taus(study, scene, figures):
    """{(measure, measure): tau-b over the encoders} of one scene.

    SSIM and its like are negated, so that 1 is full agreement.
    """
    encoders = [e for e in study.flip.encoders
                if study.flip.get(e, scene) is not None]
    rows = {name: [found.get(e, scene) * (-1 if name in HIGHER else 1)
                   for e in encoders] for name, found in figures.items()}
    return {(a, b): statistics.tau_b(rows[a], rows[b])
            for a in rows for b in rows}


def all_taus(study):
    figures = present(study)
    return figures, [scene_taus(study, scene, figures)
                     for scene in study.flip.scenes]


def agreement(study):
    """Kendall's tau-b between measures: per scene, then the mean."""
    figures, taus = all_taus(study)
    table = Table(
        study.name("agreement"), study.title("Agreement between measures"),
        study.caption(
            "Kendall's τ-b between the rankings of the encoders by two "
            "measures: computed for each scene, then averaged; 1 is the same "
            "ranking.", len(study.flip.scenes)),
        [Column("measure", left=True)] + [Column(name) for name in figures])
    if len(study.flip.encoders) < 3 or len(figures) < 2:
        return table
    for a in figures:
        row = [word(a)]
        for b in figures:
            known = [t[a, b] for t in taus if t[a, b] is not None]
            row.append(number(float(numpy.mean(known)) if known else None, 2))
        table.rows.append(row)
    return table


def agreement_by_scene(study):
    """The same of each measure with FLIP, scene by scene."""
    figures, taus = all_taus(study)
    others = [name for name in figures if name != "flip"]
    table = Table(
        study.name("agreement-by-scene"),
        study.title("Agreement with FLIP by scene"),
        study.caption("Kendall's τ-b of each measure with FLIP.",
                      len(study.flip.scenes)),
        [Column("scene", left=True)] + [Column(name) for name in others])
    if len(study.flip.encoders) < 3 or not others:
        return table
    for scene, found in zip(study.flip.scenes, taus):
        table.rows.append([word(scene)] + [number(found["flip", name], 2)
                                           for name in others])
    return table
