"""Times: of each stage, of a frame, and rays a second."""

import numpy

from report import matrix, statistics
from report.provenance import MOST_CV
from report.table import (Cell, Column, NONE, Table, code, figure, interval,
                          number, significant, word)
from report.tables.flip import scene_table


def stages(study):
    """Every stage of every run: medians, spread and CPU time."""
    runs = sorted(study.timed, key=lambda r: (r.scene, r.time, r.encoder))
    table = Table(
        study.name("times"), study.title("Times by stage"),
        study.caption(
            "Milliseconds: median with its 95 % bootstrap interval, 95th "
            "percentile, coefficient of variation (over "
            f"{100 * MOST_CV:.0f} % marked: not to be compared), median of "
            "the CPU time.", len({run.scene for run in runs}), runs),
        [Column("scene", left=True), Column("encoder", left=True),
         Column("stage", left=True), Column("runs"), Column("median [95 %]"),
         Column("p95"), Column("CV"), Column("CPU")])
    for run in runs:
        for stage in matrix.STAGES:
            times = run.value("ms", stage)
            if times:
                table.rows.append([word(scene_at(run)), code(run.encoder),
                                   word(stage), *stage_cells(times)])
    return table


def scene_at(run):
    return run.scene if run.time == 0 else f"{run.scene} at {run.time:g} s"


def stage_cells(times):
    restless = times["cv"] > MOST_CV
    return [number(len(times["samples"]), 0),
            interval(times["median"], times["lo"], times["hi"], significant),
            figure(times["p95"]),
            Cell(f"{100 * times['cv']:.1f} %", times["cv"], warn=restless),
            figure(times.get("cpu_median"))]


def frames(study):
    """Milliseconds of a frame by scene."""
    figures = study.ms
    unsteady = {(run.encoder, run.scene) for run in study.timed
                if frame_cv(run) > MOST_CV}
    table = scene_table(
        study.name("frame-times-by-scene"), study.title("Time of a frame"),
        study.caption(
            "Median milliseconds of a frame: planning, rendering and "
            "encoding; marked where the coefficient of variation is over "
            f"{100 * MOST_CV:.0f} %.", len(figures.scenes), study.timed),
        figures, figure, ("geometric mean", figures.geometric_mean))
    for encoder, row in zip(figures.encoders, table.rows):
        for scene, cell in zip(figures.scenes, row[1:]):
            cell.warn = (encoder, scene) in unsteady
    return table


def frame_cv(run):
    samples = matrix.frame_samples(run)
    if not samples or len(samples) < 2:
        return 0.0
    return float(numpy.std(samples, ddof=1) / numpy.mean(samples))


def frame_interval(run):
    """(median, low, high) of a frame's milliseconds, or None."""
    samples = matrix.frame_samples(run)
    if samples is None:
        return None
    return (float(numpy.median(samples)),
            *statistics.median_interval(samples))


def rays(study):
    """Rays traced by kind, and how many a second."""
    runs = [run for run in study.timed or study.runs if run.value("rays")]
    if not runs:
        runs = [run for run in study.runs if run.value("rays")]
    seconds = {run.work: run.value("ms", "render", "median")
               for run in study.timed}
    kinds = list(dict.fromkeys(k for run in runs for k in run.value("rays")))
    table = Table(
        study.name("rays"), study.title("Rays by kind"),
        study.caption(
            "Rays of one frame by kind, and millions of them a second of the "
            "median time of rendering.", len({run.scene for run in runs}),
            runs),
        [Column("scene", left=True), Column("encoder", left=True)]
        + [Column(kind) for kind in kinds]
        + [Column("all"), Column("million / s")])
    for run in sorted(runs, key=lambda r: (r.scene, r.time, r.encoder)):
        if run.seed != min(r.seed for r in runs if r.work == run.work):
            continue
        counts = run.value("rays")
        total = sum(counts.values())
        ms = seconds.get(run.work)
        table.rows.append(
            [word(scene_at(run)), code(run.encoder)]
            + [number(counts[k], 0) if k in counts else word(NONE)
               for k in kinds]
            + [number(total, 0), figure(total / ms / 1e3 if ms else None)])
    return table
