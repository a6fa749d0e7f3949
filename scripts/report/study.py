"""One view of the results (one grid, raster, reference, ...), as matrices."""

import functools

from report import matrix, provenance
from report.table import count


class Study:
    """What tables, plots and the page say of one view."""

    def __init__(self, results, view, first=True):
        self.results = results
        self.view = view
        self.first = first
        self.names = results.names
        self.runs = [run for run in results.scored() if run.view == view]
        self.timed = [run for run in results.timed()
                      if run.setting == view.setting]

    def name(self, base):
        """A name for a file: the first view's has no more to it."""
        return base if self.first else f"{base}-{self.view.slug()}"

    def title(self, base):
        return base if self.first else f"{base} ({self.view.label()})"

    @functools.lru_cache(maxsize=None)
    def metric(self, name):
        return matrix.build(self.runs, matrix.metric(name))

    @functools.cached_property
    def flip(self):
        return self.metric("flip")

    @functools.cached_property
    def rays(self):
        return matrix.build(self.runs, lambda r: r.value("rays_per_cell"))

    @functools.cached_property
    def bytes(self):
        """Bytes of a frame of ANSI text."""
        return matrix.build(self.runs, lambda r: r.value("bytes_per_frame"))

    @functools.cached_property
    def kilobytes(self):
        return matrix.build(self.runs, lambda r: thousandth(
            r.value("bytes_per_frame")))

    @functools.cached_property
    def ms(self):
        """Milliseconds of a frame: plan, render, encode."""
        return matrix.build(self.timed, matrix.frame_ms)

    @functools.cached_property
    def gap(self):
        return matrix.build(self.runs, matrix.gap)

    def decomposed(self, *path):
        return matrix.build(self.runs,
                            lambda r: r.value("decomposition", *path))

    def bounds_broken(self):
        """The runs below the bound: measuring errors."""
        return [run for run in self.runs if matrix.below_bound(run)]

    def flip_words(self):
        return f"FLIP {self.view.measured()}"

    def stated(self, measure):
        """What a CSV needs beside each row."""
        return {"measure": measure, "ppd": f"{self.view.ppd:g}",
                "raster": "{}x{}".format(*self.view.raster),
                "setting": self.view.slug()}

    def caption(self, lead, scenes, runs=None, with_times=False):
        """`lead`, what was measured how, n, machine and commit.

        with_times: the records of the times have a part in it too.
        """
        runs = self.runs if runs is None else runs
        seeds = {}
        times = {}
        for run in runs:
            seeds.setdefault(run.encoder, set()).add(run.seed)
            times.setdefault(run.scene, set()).add(run.time)
        most = max(map(len, seeds.values()), default=1)
        several = (f" Up to {most} seeds averaged first." if most > 1 else "")
        if any(len(found) > 1 for found in times.values()):
            several += (" Of a scene's times those that all its encoders have, "
                        "averaged first.")
        records = [run.record for run in runs]
        if with_times:
            records += [run.record for run in self.timed]
        return (f"{lead} n = {count(scenes, 'scene')}; "
                f"{self.view.setting.label()}; {self.flip_words()}; "
                f"references: {provenance.references(self.runs)}; "
                f"{provenance.origin(records)}.{several}")


def thousandth(value):
    return None if value is None else value / 1000


def studies(results):
    """A Study for each view, that of the most runs first."""
    return [Study(results, view, index == 0)
            for index, view in enumerate(results.views())]
