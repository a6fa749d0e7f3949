"""Where the error comes from, as bars and as steps."""

import numpy

from report import labels
from report.plots import Plot, style
from report.plots.tradeoff import flip_axis
from report.tables.decomposition import (DISTANCES, TERM_NAMES, TERMS,
                                         mean_shares)

COLORS = dict(zip(TERMS, style.SEQUENCE))
CROSS_TERMS = TERMS[3:]


def shares(study):
    """Stacked bars of the mean shares; negative cross terms go left."""
    from matplotlib import pyplot
    found = mean_shares(study)
    if not found:
        return None
    encoders = list(found)[::-1]
    figure, axes = pyplot.subplots(
        figsize=(style.WIDTH, 0.27 * len(encoders) + 1.3))
    right = left = numpy.zeros(len(encoders))
    for term in TERMS:
        widths = numpy.array([100 * found[e][term] for e in encoders])
        starts = numpy.where(widths >= 0, right, left)
        bars = axes.barh(range(len(encoders)), widths, 0.7, starts,
                         color=COLORS[term], label=TERM_NAMES[term],
                         edgecolor="white", linewidth=0.4)
        if term in CROSS_TERMS:
            for bar in bars:
                bar.set_hatch("////")
        right = right + numpy.maximum(widths, 0)
        left = left + numpy.minimum(widths, 0)
    axes.axvline(0, color=style.INK, linewidth=0.8)
    axes.axvline(100, color=style.INK, linewidth=0.8, linestyle=(0, (3, 2)))
    names = study.names
    axes.set_yticks(range(len(encoders)),
                    [labels.wrapped(names[e], 34) for e in encoders])
    axes.grid(axis="y", visible=False)
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel("share of the scene's MSE in percent, mean over scenes")
    style.legend_above(axes, 6)
    scenes = study.decomposed("mse", "total").scenes
    lead = ("The MSE by its causes: rendering, sampling, encoding, and the "
            "cross terms (hatched), which are negative where two errors "
            "cancel; all add up to 100 % (dashed).")
    return Plot(study.name("decomposition"), study.title(
        "The error by its causes"), study.caption(lead, len(scenes)), figure)


def distances(study):
    """FLIP along the way, which does not add up: one mark a distance."""
    from matplotlib import pyplot
    figures = {key: study.decomposed("flip", key) for key in DISTANCES}
    encoders = [e for e in study.flip.complete()
                if all(len(f.row(e)) == len(study.flip.scenes)
                       for f in figures.values())]
    if not encoders:
        return None
    encoders.sort(key=figures["reference_grid"].mean, reverse=True)
    figure, axes = pyplot.subplots(
        figsize=(style.WIDTH, 0.24 * len(encoders) + 1.3))
    for height, encoder in enumerate(encoders):
        means = [f.mean(encoder) for f in figures.values()]
        axes.plot([min(means), max(means)], [height] * 2, color=style.LINE,
                  linewidth=2.5, zorder=1)
    for (key, words), color, marker in zip(DISTANCES.items(), style.SEQUENCE,
                                           "os^DX"):
        axes.scatter([figures[key].mean(e) for e in encoders],
                     range(len(encoders)), 22, color=color, marker=marker,
                     label=words, zorder=2, linewidths=0)
    names = study.names
    axes.set_yticks(range(len(encoders)),
                    [labels.wrapped(names[e], 34) for e in encoders])
    axes.set_xlim(left=0)
    axes.grid(axis="y", visible=False)
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel(flip_axis(study, "mean FLIP"))
    style.legend_above(axes, 3)
    lead = ("Mean FLIP between reference R, converged image, fragments and "
            "grid; FLIP is not additive. The oracle encodes the reference "
            "itself.")
    return Plot(study.name("flip-distances"), study.title(
        "FLIP along the way"),
        study.caption(lead, len(study.flip.scenes)), figure)
