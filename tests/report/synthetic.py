#!/usr/bin/python3
"""Records of sweeps that never ran, for tests: deterministic, of any size.

    tests/report/synthetic.py FOLDER     a suite of the thesis' size

Figures follow simple formulas, so that tests can derive what comes of them;
pictures have as much detail as rendered ones.
"""

import gzip
import json
import math
import sys
from dataclasses import dataclass, field
from pathlib import Path

GLYPHS = {"half": "▄", "tiv": "▁▂▃▄▅▆▇▊▌▎▖▗▘▚▝━┃", "braille": "⠁⠂⠃⡇⢸⣿"}
COMMIT = "0123456789abcdef0123456789abcdef01234567"


@dataclass
class Suite:
    """Writes units into a folder as a sweep does."""
    folder: Path
    grid: tuple = (20, 10)
    commit: str = COMMIT
    dirty: bool = False
    host: str = "Test CPU"
    count: int = field(default=0)

    def __post_init__(self):
        for name in ("units", "pictures"):
            (self.folder / name).mkdir(parents=True, exist_ok=True)

    def settings(self, **changes):
        own = {"backend": "embree", "device": "", "integrator": "whitted",
               "spp": 1, "max_depth": 8, "seed": 0, "time": 0.0,
               "exposure": 0.0, "cell": [8, 16], "reference": "povray",
               "color": "truecolor", "decode": "geometric", "blend": "srgb",
               "ppd": 40.0}
        return {**own, **changes}

    def record(self, kind, scene, encoders, runs, failure=None, **changes):
        """Writes one unit; returns its file."""
        self.count += 1
        settings = self.settings(**changes)
        code = f"{self.count:016x}"
        record = {
            "schema": 1,
            "manifest": {
                "program": {"version": "0.1.0", "commit": self.commit,
                            "dirty": self.dirty, "build_type": "Release",
                            "compiler": "GNU 12.2.0", "flags": "-O3"},
                "settings": settings,
                "inputs": [{"role": "scene", "name": f"{scene}.yaml",
                            "sha256": "a" * 64},
                           {"role": "reference",
                            "name": f"{scene}.povray.exr",
                            "sha256": "b" * 64}]},
            "runs": runs,
            "volatile": {
                "utc": "2026-01-31T12:34:56Z", "command": ["rtbench"],
                "threads": 0,
                "host": {"name": "test", "cpu_model": self.host, "cores": 2,
                         "os": "Debian", "kernel": "6.1", "load_1min": 0.1}},
            "unit": {"kind": kind, "suite": "test", "hash": code,
                     "configuration": {
                         "scene": scene, "time": settings["time"],
                         "grid": list(self.grid), "spp": settings["spp"],
                         "backend": settings["backend"],
                         "integrator": settings["integrator"],
                         "color": settings["color"], "reference": "",
                         "seed": settings["seed"], "encoders": encoders}}}
        if failure:
            record["failure"] = failure
        file = self.folder / "units" / f"{kind}-{code}.json"
        file.write_text(json.dumps(record), encoding="utf-8")
        return file

    def run(self, scene, encoder, rays=4.0, **more):
        columns, rows = self.grid
        return {"scene": scene, "encoder": encoder, "grid": list(self.grid),
                "rays_per_cell": rays, "raster": [8 * columns, 16 * rows],
                "reference_raster": [8 * columns, 16 * rows], "ms": {},
                "metrics": {}, **more}

    def quality(self, scene, encoder, flip, mse=None, rays=4.0, pictures=None,
                settings=None, **more):
        """One encoder scored on one scene."""
        mse = flip ** 2 / 4 if mse is None else mse
        run = self.run(scene, encoder, rays, **more)
        run["metrics"] = {
            "flip": flip, "flip_ppd30": flip, "flip_ppd67": flip,
            "flip_p95": min(1, 3 * flip), "mse": mse,
            "psnr": -10 * math.log10(mse), "rmse_linear": mse ** 0.5,
            "rel_mse": 2 * mse, "ssim": 1 - flip, "ms_ssim": None,
            "ciede2000": 40 * flip, "ciede2000_p95": 90 * flip}
        if pictures:
            run["pictures"] = pictures
        return self.record("quality", scene, [encoder], [run],
                           **settings or {})

    def timing(self, scene, times, settings=None):
        """times: {encoder: {stage: [milliseconds]}}."""
        runs = [self.run(scene, encoder, ms={
            stage: self.times(samples) for stage, samples in stages.items()})
            for encoder, stages in times.items()]
        return self.record("timing", scene, list(times), runs,
                           **settings or {})

    @staticmethod
    def times(samples):
        ordered = sorted(samples)
        mean = sum(samples) / len(samples)
        spread = sum((s - mean) ** 2 for s in samples)
        return {"median": ordered[len(ordered) // 2], "lo": ordered[0],
                "hi": ordered[-1], "p95": ordered[-1],
                "cv": math.sqrt(spread / max(1, len(samples) - 1)) / mean,
                "cpu_median": ordered[len(ordered) // 2],
                "cpu_samples": samples, "samples": samples}

    def temporal(self, scene, encoder, **figures):
        own = {"frames": 24, "fps": 24.0, "tde": 0.02, "t_flip": 0.01,
               "warp_error": 0.001, "churn": 0.5, "static_flicker": 0.4,
               "static_flicker_rms": 0.01, "bytes_per_frame": 9000.0}
        run = self.run(scene, encoder, temporal={**own, **figures})
        return self.record("temporal", scene, [encoder], [run])

    def live(self, scene, encoder, fps):
        run = self.run(scene, encoder, ms={"live": {
            "fps": fps, "frame_ms": {"p50": 1000 / fps, "p95": 2000 / fps,
                                     "p99": 3000 / fps},
            "bytes_per_frame": 9000.0, "cells_per_frame": 150.0,
            "present": "direct"}})
        return self.record("live", scene, [encoder], [run])

    def failed(self, scene, encoder, what, kind="failed"):
        return self.record("quality", scene, [encoder], [], {
            "kind": kind, "encoder": encoder, "place": "encoder",
            "what": what, "hint": "install it"})

    def write_grid(self, name, cells):
        """cells: [(glyph, foreground, background)]."""
        grid = {"columns": self.grid[0], "rows": self.grid[1],
                "cells": [list(cell) for cell in cells]}
        data = json.dumps(grid, ensure_ascii=False).encode("utf-8")
        (self.folder / "pictures" / name).write_bytes(
            gzip.compress(data, 1, mtime=0))
        return name

    def write_jpeg(self, name, pixels, quality=80):
        from PIL import Image
        Image.fromarray(pixels).save(self.folder / "pictures" / name, "JPEG",
                                     quality=quality)
        return name

    def copy_picture(self, name, new):
        pictures = self.folder / "pictures"
        (pictures / new).write_bytes((pictures / name).read_bytes())
        return new


def scene_pixels(number, size):
    """A picture with edges, slopes and grain, different for each number."""
    import numpy
    width, height = size
    y, x = numpy.mgrid[0:height, 0:width] / height
    random = numpy.random.default_rng(number)
    picture = numpy.stack([0.5 + 0.4 * numpy.sin(3 * x + 2 * y + k + number)
                           for k in range(3)], axis=-1)
    for _ in range(14):
        center, radius = random.uniform(0, 1.5, 2), random.uniform(0.05, 0.3)
        inside = ((x - center[0]) ** 2 + (y - center[1]) ** 2 < radius ** 2)
        shade = 0.4 + 0.6 * (1 - numpy.hypot(x - center[0], y - center[1])
                             / radius)
        color = random.uniform(0.1, 1, 3)
        picture = numpy.where(inside[..., None],
                              color * shade[..., None], picture)
    checks = (numpy.floor(10 * x) + numpy.floor(14 * y)) % 2 * (y > 0.7)
    picture *= (1 - 0.4 * checks)[..., None]
    picture += random.normal(0, 0.01, picture.shape)
    return (255 * numpy.clip(picture, 0, 1)).astype(numpy.uint8)


def cells_of(pixels, grid, glyphs, seed):
    """Cells whose two colors are those of the upper and the lower half."""
    import numpy
    columns, rows = grid
    halves = pixels.reshape(rows, 2, 8, columns, 8, 3).mean(axis=(2, 4))
    random = numpy.random.default_rng(seed)
    chosen = random.integers(0, len(glyphs), rows * columns)
    texts = [["#%02x%02x%02x" % tuple(color) for color in
              halves[:, side].reshape(-1, 3).astype(int)] for side in (1, 0)]
    return [(glyphs[number], *colors)
            for number, *colors in zip(chosen, *texts)]


def heat(pixels, cells_wide):
    """Something like a FLIP map at half size: what blocks cannot show."""
    import numpy
    gray = pixels.mean(axis=2)
    size = max(1, gray.shape[1] // cells_wide)
    blocks = gray[::size, ::size].repeat(size, 0).repeat(size, 1)
    rough = abs(gray - blocks[:gray.shape[0], :gray.shape[1]])[::2, ::2]
    value = numpy.clip(3 * rough, 0, 255).astype(numpy.uint8)
    return numpy.stack([value, value // 3, 128 - value // 3], axis=-1)


def thesis(folder, scenes=16, encoders=23, grids=((120, 40), (60, 20))):
    """A suite of the size of the thesis' main comparison, with pictures."""
    names = ["half", "tiv", "braille"] + [f"encoder{i}:option=value"
                                          for i in range(encoders - 3)]
    suite = Suite(Path(folder))
    for suite.grid in grids:
        for number in range(scenes):
            thesis_scene(suite, number, names)


def thesis_scene(suite, number, names):
    """All encoders on one scene, and their times."""
    scene, grid = f"scene-{number:02}", suite.grid
    octants = "".join(chr(0x1CD00 + i) for i in range(230))
    pixels = scene_pixels(number, (8 * grid[0], 16 * grid[1]))
    code = f"{scene}-{grid[0]}"
    reference = suite.write_jpeg(f"reference-{code}.jpg", pixels, 90)
    map_ = suite.write_jpeg(f"map-{code}.jpg", heat(pixels, grid[0]))
    times = {}
    for index, name in enumerate(names):
        flip = (0.05 + 0.01 * number) * (1 + 0.05 * index)
        cells = cells_of(pixels, grid, GLYPHS.get(name, octants), index)
        code = f"quality-{grid[0]}-{number:02}{index:02}.0"
        suite.quality(
            scene, name, flip, rays=2.0 + index, bytes_per_frame=90000,
            pictures={"cells": suite.write_grid(f"{code}.cells.json.gz",
                                                cells),
                      "flip": suite.copy_picture(map_, f"{code}.flip.jpg"),
                      "reference": reference})
        times[name] = {"plan": [0.1] * 30, "encode": [1.0 + index] * 30,
                       "render": [2.0 + 0.01 * k for k in range(30)]}
    suite.timing(scene, times)


if __name__ == "__main__":
    thesis(sys.argv[1])
