"""Times: of each stage, of a frame, and rays a second."""

import numpy

from report import matrix, statistics
from report.provenance import MOST_CV
from report.table import (Cell, Column, NONE, Table, figure, interval,
                          number, significant, spec, word)
from report.tables.flip import scene_table


def stages(study):
    """A frame of every run: median, spread, CPU time; medians by stage."""
    runs = sorted(study.timed, key=lambda r: (r.scene, r.time, r.encoder))
    stages_ = [stage for stage in matrix.STAGES
               if any(run.value("ms", stage) for run in runs)]
    table = Table(
        study.name("times"), study.title("Times"),
        study.caption(
            "Milliseconds of a frame (planning, rendering, encoding): median "
            "with its 95 % bootstrap interval, 95th percentile, coefficient "
            f"of variation (over {100 * MOST_CV:.0f} % marked: not to be "
            "compared), median of the CPU time; then the medians of the "
            "stages.", len({run.scene for run in runs}), runs),
        [Column("scene", left=True), Column("encoder", left=True),
         Column("runs"), Column("frame [95 %]"), Column("p95"), Column("CV"),
         Column("CPU")] + [Column(stage) for stage in stages_])
    for run in runs:
        if matrix.frame_samples(run):
            table.rows.append(
                [word(scene_at(run)), spec(run.encoder, study.names),
                 *frame_cells(run)]
                + [figure(run.value("ms", stage, "median"))
                   for stage in stages_])
    return table


def scene_at(run):
    return run.scene if run.time == 0 else f"{run.scene} at {run.time:g} s"


def frame_cells(run):
    samples = matrix.frame_samples(run)
    cpu = matrix.frame_samples(run, "cpu_samples")
    variation = frame_cv(run)
    return [number(len(samples), 0),
            interval(*frame_interval(run), significant),
            figure(float(numpy.percentile(samples, 95))),
            Cell(f"{100 * variation:.1f} %", variation,
                 warn=variation > MOST_CV),
            figure(float(numpy.median(cpu)) if cpu else None)]


def frames(study):
    """Milliseconds of a frame by scene."""
    figures = study.ms
    unsteady = {(run.encoder, run.scene) for run in study.timed
                if frame_cv(run) > MOST_CV}
    table = scene_table(
        study, "frame-times-by-scene", "Time of a frame", "Median "
        "milliseconds of a frame: planning, rendering and encoding; marked "
        "where the coefficient of variation is over "
        f"{100 * MOST_CV:.0f} %.", figures, figure,
        ("geometric mean", figures.geometric_mean), study.timed)
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
            [word(scene_at(run)), spec(run.encoder, study.names)]
            + [number(counts[k], 0) if k in counts else word(NONE)
               for k in kinds]
            + [number(total, 0), figure(total / ms / 1e3 if ms else None)])
    return table
