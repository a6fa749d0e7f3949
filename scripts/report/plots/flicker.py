"""Flicker of moving scenes, with and without `temporal`."""

from report import labels
from report.plots import Plot, style
from report.tables.temporal import caption, paired, runs_of, split_spec

SHOWN = {"static_flicker": "static flicker: share of cells",
         "churn": "churn: share of cells",
         "t_flip": "t-FLIP"}


def flicker(results):
    """One panel a measure; an arrow leads from without to with."""
    from matplotlib import pyplot
    runs = runs_of(results)
    if not runs:
        return None
    rows = list(dict.fromkeys((run.scene, split_spec(run.encoder)[0])
                              for run in runs))[::-1]
    heights = {row: height for height, row in enumerate(rows)}
    figure, panels = pyplot.subplots(
        1, len(SHOWN), sharey=True,
        figsize=(style.WIDTH, 0.2 * len(rows) + 1.2))
    for panel, (name, words) in zip(panels, SHOWN.items()):
        draw_measure(panel, results, runs, heights, name)
        panel.set_xlabel(words)
        panel.set_xlim(left=0)
        panel.grid(axis="y", visible=False)
        panel.tick_params(axis="y", length=0)
    panels[0].set_yticks(range(len(rows)), [
        f"{scene}: {labels.wrapped(labels.short(encoder), 30)}"
        for scene, encoder in rows], fontsize=6.5)
    style.legend_above(panels[0], 2)
    return Plot("flicker", "Flicker of moving scenes", caption(
        "Hollow: without `temporal`; filled: with. Static flicker compares "
        "two renders of one frame that differ in their seed alone; churn and "
        "t-FLIP follow the movement.", runs), figure)


def draw_measure(panel, results, runs, heights, name):
    for base, run in paired(results):
        row = heights[run.scene, split_spec(run.encoder)[0]]
        ends = [r.value("temporal", name) for r in (base, run)]
        if None not in ends:
            panel.plot(ends, [row, row], color=style.LINE, linewidth=2,
                       zorder=1)
    for label, has, face in (("without temporal", False, "white"),
                             ("with temporal", True, style.FRONT)):
        found = [(run.value("temporal", name),
                  heights[run.scene, split_spec(run.encoder)[0]])
                 for run in runs
                 if (split_spec(run.encoder)[1] is not None) == has
                 and run.value("temporal", name) is not None]
        if found:
            panel.scatter(*zip(*found), 18, edgecolors=style.FRONT,
                          facecolors=face, linewidths=1, label=label,
                          zorder=2)
