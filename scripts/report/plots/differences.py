"""Paired differences to the controls, with their intervals."""

from report import labels, matrix
from report.plots import Plot, style
from report.tables.flip import shown_pair


def forest(study):
    """One panel a control: each scene as a dot, the mean with its interval."""
    from matplotlib import pyplot
    figures = study.flip
    pairs = matrix.against_controls(figures)
    controls = [c for c in matrix.CONTROLS if c in figures.encoders]
    if not controls or len(figures.encoders) < 2:
        return None
    order = sorted(figures.encoders, key=figures.mean, reverse=True)
    names = study.names
    figure, panels = pyplot.subplots(
        1, len(controls), sharey=True, squeeze=False,
        figsize=(style.WIDTH, 0.24 * len(order) + 1.0))
    for panel, control in zip(panels[0], controls):
        draw_control(panel, figures, pairs, order, control)
        panel.set_xlabel(f"FLIP − FLIP of {control}")
        panel.set_title(f"against {control}", loc="left")
    panels[0][0].set_yticks(range(len(order)),
                            [labels.wrapped(names[e], 34) for e in order])
    lead = ("Difference of FLIP to each control: a dot a scene, the mean "
            "with its 95 % BCa interval over scenes; left of the line is "
            "better than the control. Filled: p < 0.05 after Holm.")
    return Plot(study.name("differences"), study.title(
        "Differences to the controls"),
        study.caption(lead, len(figures.scenes)), figure)


def draw_control(panel, figures, pairs, order, control):
    panel.locator_params(axis="x", nbins=5)
    panel.axvline(0, color=style.INK, linewidth=0.8)
    panel.grid(axis="y", visible=False)
    panel.tick_params(axis="y", length=0)
    for height, encoder in enumerate(order):
        found = shown_pair(pairs, figures, encoder, control)
        if encoder == control or found is None:
            continue
        dots = [a - b for a, b in figures.pairs(encoder, control)]
        panel.scatter(dots, [height] * len(dots), 7, color=style.MUTED,
                      alpha=0.45, linewidths=0)
        better = found.mean < 0
        color = style.FRONT if better else style.CONTROL
        if found.low is not None:
            panel.plot([found.low, found.high], [height] * 2, color=color,
                       linewidth=1.6)
        sure = found.p_holm is not None and found.p_holm < 0.05
        panel.scatter(found.mean, height, 24, zorder=3,
                      marker="o" if better else "s", edgecolors=color,
                      facecolors=color if sure else "white", linewidths=1.1)
