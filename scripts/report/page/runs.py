"""The rows of the page's table and what the viewer shows of each."""

import numpy

from report import matrix, shapes
from report.table import count

# key, heading, the list's heading (None: not there), what it is, decimals
# (None: three significant digits), value
COLUMNS = (
    ("flip", "FLIP", "FLIP", "Mean FLIP, the primary measure; lower is better",
     4, lambda run: run.value("metrics", "flip")),
    ("mse", "MSE × 10⁴", "MSE ×10⁴", "Mean squared error of sRGB values, "
     "times 10,000", None, lambda run: scaled(run.value("metrics", "mse"),
                                              1e4)),
    ("ssim", "SSIM", None, "Structural similarity of luma; higher is better",
     4, lambda run: run.value("metrics", "ssim")),
    ("rays", "rays a cell", "rays", "Rays that the encoder asked for, a cell",
     1, lambda run: run.value("rays_per_cell")),
    ("ms", "ms a frame", "ms", "Median milliseconds of a frame: planning, "
     "rendering, encoding", None, None),
    ("kb", "kB a frame", "kB", "Kilobytes of a frame as ANSI text", None,
     lambda run: scaled(run.value("bytes_per_frame"), 1e-3)))
LEFT_OUT = ("The pictures of this run are left out, so that the page stays "
            "below 25 MB.")
NOT_THERE = "The record names no pictures of this run."


def scaled(value, factor):
    return None if value is None else value * factor


def groups(results):
    """Runs by view, scene, time and encoder: the seeds of one row."""
    found = {}
    for run in results.scored():
        key = run.view, run.scene, run.time, run.encoder
        found.setdefault(key, []).append(run)
    return found


def mean_value(runs, value):
    known = [v for v in map(value, runs) if v is not None]
    return float(numpy.mean(known)) if known else None


def values(runs, times):
    """What the table shows of a row."""
    first = runs[0]
    scene = (first.scene if first.time == 0
             else f"{first.scene} at {first.time:g} s")
    row = {"scene": scene, "encoder": first.encoder}
    for key, *_, value in COLUMNS:
        row[key] = (mean_value(runs, value) if value
                    else times.get(first.work))
    return row


def note(runs):
    """Of which seed the picture is."""
    first = runs[0]
    words = [f"compared with {first.settings['reference']}"]
    if len(runs) > 1:
        words.append(f"figures are means of {count(len(runs), 'seed')}, the "
                     f"picture is of seed {first.seed}")
    if first.value("encoder_version"):
        words.append(f"version {first.value('encoder_version')}")
    return "; ".join(words) + "."


def page_row(runs, setting, times, names, store):
    """One row: its values, and the ids of its pictures."""
    # The pictures of one seed: the lowest of those that have any.
    runs = sorted(runs, key=lambda run: (not run.data.get("pictures"),
                                         run.seed))
    first = runs[0]
    files = first.data.get("pictures") or {}
    reference = store.picture(files.get("reference"), "reference")
    cells, size = store.grid(files.get("cells"))
    flip = store.picture(files.get("flip"), "flip")
    return {"setting": setting, "label": names[first.encoder],
            "values": values(runs, times), "note": note(runs),
            "renderer": first.settings["reference"], "reference": reference,
            "cells": cells, "grid": size, "flip": flip,
            "missing": LEFT_OUT if files.get("cells") else NOT_THERE}


def page_data(results, store):
    """Everything but the pictures themselves."""
    views = results.views()
    found = groups(results)
    blocks = {}
    for run in results.timed():
        blocks.setdefault(run.work, []).append(run)
    times = {work: mean_value(runs, matrix.frame_ms)
             for work, runs in blocks.items()}
    order = sorted(found, key=lambda key: (views.index(key[0]), *key[1:]))
    rows = [page_row(found[key], views.index(key[0]), times, results.names,
                     store) for key in order]
    characters = store.alphabet.characters()
    outlines = shapes.outlines(characters)
    several = len({view.reference for view in views}) > 1
    return {
        "rows": rows,
        "columns": [
            {"key": name, "heading": name, "listed": name, "text": True,
             "title": name.capitalize()} for name in ("scene", "encoder")]
        + [{"key": key, "heading": heading, "listed": listed, "title": title,
            "digits": digits, "text": False}
           for key, heading, listed, title, digits, _ in COLUMNS],
        "settings": [{"label": view.label() if several
                      else view.setting.label(),
                      "measured": view.measured()} for view in views],
        "first": first_row(rows),
        "alphabet": characters,
        "shapes": [outlines[character] for character in characters]}


def first_row(rows):
    """The row that is shown first, of those with pictures: the best of a
    scene that is neither the easiest nor the hardest."""
    best = {}
    for index, row in enumerate(rows):
        if not row["cells"] or not row["reference"] or row["setting"] != 0:
            continue
        scene, flip = row["values"]["scene"], row["values"]["flip"]
        if scene not in best or flip < best[scene][0]:
            best[scene] = flip, index
    order = sorted(best.values())
    return order[(len(order) - 1) // 2][1] if order else 0
