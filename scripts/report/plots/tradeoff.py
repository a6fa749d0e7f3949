"""Error against what it costs: rays, time or bytes, with the Pareto front."""

import math

from report import labels, matrix, statistics
from report.plots import Plot, style
from report.tables.times import frame_interval

BARS = ("Bars: the 95 % BCa interval of the paired difference to half, drawn "
        "around the mean; half itself has none. ")
FRONT = ("The line joins the Pareto front: the encoders that no other beats "
         "in both. ")


def kind_colors(encoders, front):
    return [style.FRONT if i in front else
            style.CONTROL if e in matrix.CONTROLS else style.MUTED
            for i, e in enumerate(encoders)]


def bar_of(figures, encoder):
    """(below, above) of an encoder's mean, or zeros."""
    if encoder == "half" or "half" not in figures.encoders:
        return 0.0, 0.0
    found = matrix.compare(figures, encoder, "half")
    if found is None or found.low is None:
        return 0.0, 0.0
    return found.mean - found.low, found.high - found.mean


def draw_front(axes, points, front, **style_of_line):
    """The front as stairs: what can be had at most at each cost."""
    axes.step([points[i][0] for i in front], [points[i][1] for i in front],
              where="post", color=style.FRONT, alpha=0.55, zorder=1,
              **style_of_line)


def draw_points(axes, encoders, points, bars, front, size=22):
    """Dots, diamonds for the controls, and bars; returns the dots' colors."""
    colors = kind_colors(encoders, front)
    controls = [encoder in matrix.CONTROLS for encoder in encoders]
    for color, control in dict.fromkeys(zip(colors, controls)):
        own = [i for i, kind in enumerate(zip(colors, controls))
               if kind == (color, control)]
        x, y = zip(*[points[i] for i in own])
        axes.scatter(x, y, size * (1.3 if control else 1), color=color,
                     zorder=3, linewidths=0, marker="D" if control else "o")
        axes.errorbar(x, y, list(zip(*[bars[i] for i in own])), ecolor=color,
                      elinewidth=0.8, fmt="none", alpha=0.5, zorder=2)
    return colors


def spread(errors):
    """Whether an outlier would flatten all others on a linear axis."""
    return len(errors) > 1 and min(errors) > 0 and max(errors) > 4 * min(errors)


def errors_of(figures, scene):
    found = [figures.get(encoder, scene) for encoder in figures.encoders]
    return [error for error in found if error is not None]


def scale_errors(axes):
    axes.set_yscale("log")
    style.plain_log(axes.yaxis)


def tradeoff(study, cost, name, axis, title, with_times=False):
    """Mean FLIP over scenes against the geometric mean of a cost."""
    from matplotlib import pyplot
    # Times may have been taken on some of the scenes alone.
    figures = study.flip.on(cost.scenes)
    cost = cost.on(figures.scenes)
    encoders = [e for e in figures.complete()
                if len(cost.row(e)) == len(figures.scenes)
                and cost.geometric_mean(e)]
    if len(encoders) < 2:
        return None
    points = [(cost.geometric_mean(e), figures.mean(e)) for e in encoders]
    front = statistics.pareto_front(points)
    figure, axes = pyplot.subplots(figsize=(style.WIDTH, 4.0))
    draw_front(axes, points, front)
    colors = draw_points(axes, encoders, points,
                         [bar_of(figures, e) for e in encoders], front)
    axes.set_xscale("log")
    axes.margins(x=0.12)
    style.plain_log(axes.xaxis)
    if spread([y for _, y in points]):
        scale_errors(axes)
    axes.set(xlabel=axis, ylabel=flip_axis(study, "mean FLIP"))
    names = study.names
    style.settle(figure)
    style.label_points(axes, points,
                       [labels.wrapped(names[e]) for e in encoders], colors,
                       front)
    lead = (f"Mean FLIP over scenes against {axis[0].lower()}{axis[1:]}; "
            f"lower left is better. {FRONT}{BARS}Diamonds: the controls.")
    return Plot(study.name(name), study.title(title),
                study.caption(lead, len(figures.scenes),
                              with_times=with_times), figure)


def flip_axis(study, words):
    width, height = study.view.raster
    return f"{words}, {study.view.ppd:g} PPD, {width} x {height}"


def rays(study):
    return tradeoff(study, study.rays, "error-rays",
                    "Rays a cell (geometric mean)", "Error against rays")


def time(study):
    return tradeoff(study, study.ms, "error-time",
                    "Milliseconds a frame (geometric mean of medians)",
                    "Error against time", with_times=True)


def bytes_(study):
    return tradeoff(study, study.kilobytes, "error-bytes",
                    "Kilobytes a frame of ANSI text (geometric mean)",
                    "Error against bytes")


def grid_of(count):
    columns = min(4, count)
    return math.ceil(count / columns), columns


def small_multiples(study, name, title, axis, lead, cost, bar,
                    with_times=False):
    """One panel a scene; cost(encoder, scene) and its bar."""
    from matplotlib import pyplot
    figures = study.flip
    figures = figures.on([s for s in figures.scenes if any(
        figures.get(e, s) is not None and cost(e, s)
        for e in figures.encoders)])
    if not figures.scenes:
        return None
    rows, columns = grid_of(len(figures.scenes))
    figure, panels = pyplot.subplots(
        rows, columns, figsize=(style.WIDTH * 1.15, 1.75 * rows + 0.3),
        squeeze=False, sharex=True)
    drawn = [draw_scene(panel, figures, scene, cost, bar)
             for panel, scene in zip(panels.flat, figures.scenes)]
    for panel in panels.flat[len(figures.scenes):]:
        panel.set_visible(False)
    # The lowest of each column has the figures.
    for panel in panels.flat[:len(figures.scenes)][-columns:]:
        panel.tick_params(labelbottom=True)
    figure.supxlabel(axis, fontsize=8)
    figure.supylabel(flip_axis(study, "FLIP"), fontsize=8)
    style.settle(figure)
    for panel, found in zip(panels.flat, drawn):
        label_scene(panel, study, *found)
    return Plot(study.name(name), study.title(title),
                study.caption(lead, len(figures.scenes),
                              with_times=with_times), figure)


def draw_scene(panel, figures, scene, cost, bar):
    """(encoders, points, front, colors)."""
    encoders = [e for e in figures.encoders
                if figures.get(e, scene) is not None and cost(e, scene)]
    points = [(cost(e, scene), figures.get(e, scene)) for e in encoders]
    panel.set_title(scene, loc="left", pad=3, fontsize=8)
    front = statistics.pareto_front(points)
    draw_front(panel, points, front, linewidth=0.9)
    colors = draw_points(panel, encoders, points, [(0, 0)] * len(points),
                         front, 9)
    for encoder, point, color in zip(encoders, points, colors):
        low, high = bar(encoder, scene) or (point[0], point[0])
        panel.plot([low, high], [point[1]] * 2, color=color, linewidth=0.8)
    panel.set_xscale("log")
    panel.margins(x=0.15, y=0.18)
    if any(spread(errors_of(figures, s)) for s in figures.scenes):
        scale_errors(panel)
    else:
        panel.set_ylim(bottom=0)
    panel.tick_params(labelsize=6.5)
    style.plain_log(panel.xaxis, 12)
    return encoders, points, front, colors


def label_scene(panel, study, encoders, points, front, colors):
    """Labels the front and the controls alone: panels are small."""
    kept = front + [i for i in range(len(points)) if i not in front
                    and encoders[i] in matrix.CONTROLS]
    style.label_points(panel, [points[i] for i in kept],
                       [labels.wrapped(study.names[encoders[i]], 14)
                        for i in kept], [colors[i] for i in kept],
                       range(len(front)), 5, points)


LABELED = "Labels on the front and on the controls (diamonds) alone. "


def by_scene(study):
    return small_multiples(
        study, "error-rays-by-scene", "Error against rays, scene by scene",
        "Rays a cell", "FLIP of each encoder on each scene with the scene's "
        f"own Pareto front. {LABELED}", study.rays.get, lambda e, s: None)


def time_by_scene(study):
    intervals = {}
    for run in study.timed:
        found = frame_interval(run)
        if found and run.time == 0:
            intervals[run.encoder, run.scene] = found[1:]
    return small_multiples(
        study, "error-time-by-scene", "Error against time, scene by scene",
        "Milliseconds a frame", "FLIP of each encoder on each scene against "
        "the median time of a frame with its 95 % bootstrap interval. "
        f"{LABELED}", study.ms.get,
        lambda e, s: intervals.get((e, s)), with_times=True)
