"""How plots look: for print, for the color-blind, and restyled by the page.

Colors are Okabe and Ito's, chosen to be told apart with any color vision; the
named ones occur in no sequence, so that the page can put its own in their
place.
"""

import matplotlib

INK = "#1b1f24"
LINE = "#d0d4da"
MUTED = "#7a828c"
FRONT = "#0069a8"
CONTROL = "#c85400"
SEQUENCE = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00")
WIDTH = 6.3  # inches: the text of an A4 page

SETTINGS = {
    "font.family": "DejaVu Sans", "font.size": 8, "axes.titlesize": 9,
    "axes.labelsize": 8, "xtick.labelsize": 7.5, "ytick.labelsize": 7.5,
    "legend.fontsize": 7.5, "legend.frameon": False,
    "text.color": INK, "axes.labelcolor": INK, "axes.titlecolor": INK,
    "xtick.color": INK, "ytick.color": INK, "axes.edgecolor": INK,
    "axes.linewidth": 0.6, "axes.spines.top": False,
    "axes.spines.right": False, "axes.grid": True, "grid.color": LINE,
    "grid.linewidth": 0.5, "axes.axisbelow": True, "lines.linewidth": 1.2,
    "errorbar.capsize": 0, "figure.constrained_layout.use": True,
    "savefig.transparent": True, "svg.fonttype": "none",
    "pdf.fonttype": 42}


def use():
    """Sets the style; call before drawing."""
    matplotlib.use("Agg")
    matplotlib.rcParams.update(matplotlib.rcParamsDefault)
    matplotlib.use("Agg")
    matplotlib.rcParams.update(SETTINGS)


def plain_log(axis, dense_below=500):
    """Ticks of a logarithmic axis as plain figures, dense on a short one."""
    from matplotlib import ticker
    low, high = axis.get_view_interval()
    narrow = high / low < dense_below
    axis.set_major_locator(ticker.LogLocator(
        10, (1, 2, 5) if narrow else (1,), numticks=12))
    axis.set_major_formatter(ticker.FuncFormatter(lambda v, _: f"{v:g}"))
    axis.set_minor_locator(ticker.NullLocator())


def legend_above(axes, columns):
    """The legend of the labeled things, above the axes."""
    axes.legend(ncol=columns, loc="lower left", bbox_to_anchor=(0, 1.0),
                borderaxespad=0.3, borderpad=0, columnspacing=1.2,
                handlelength=1.4, handletextpad=0.4)


def settle(figure):
    """Lays a figure out for good: drawn again, it stays the same."""
    if figure.get_layout_engine() is not None:
        figure.draw_without_rendering()
        figure.set_layout_engine("none")


def overlap(a, b):
    """The area that two boxes (x0, y0, x1, y1) share."""
    width = min(a[2], b[2]) - max(a[0], b[0])
    height = min(a[3], b[3]) - max(a[1], b[1])
    return max(0, width) * max(0, height)


# Where a label may stand: direction and alignment, in the order of preference.
RIGHT_FIRST = ((1, 0, "left", "center"), (0.7, 0.7, "left", "bottom"),
               (0.7, -0.7, "left", "top"), (-1, 0, "right", "center"),
               (-0.7, 0.7, "right", "bottom"), (-0.7, -0.7, "right", "top"),
               (0, 1, "center", "bottom"), (0, -1, "center", "top"))
# Nothing lies to the lower left of a point on the front.
FRONT_FIRST = ((-0.7, -0.7, "right", "top"), (0, -1, "center", "top"),
               (-1, 0, "right", "center"), *RIGHT_FIRST)
REACHES = (5, 10, 17, 26, 38)  # points


def along(corners, step):
    """Small boxes along a line of corners, in pixels."""
    for (x0, y0), (x1, y1) in zip(corners, corners[1:]):
        count = int(max(abs(x1 - x0), abs(y1 - y0)) / step) + 1
        for i in range(count + 1):
            x = x0 + (x1 - x0) * i / count
            y = y0 + (y1 - y0) * i / count
            yield x - 1, y - 1, x + 1, y + 1


def stairs(points):
    """The corners of a front drawn as steps."""
    corners = list(points[:1])
    for (_, y), point in zip(points, points[1:]):
        corners += [(point[0], y), point]
    return corners


def places(prefers_front):
    for reach in REACHES:
        for dx, dy, ha, va in FRONT_FIRST if prefers_front else RIGHT_FIRST:
            yield dx * reach, dy * reach, ha, va


def label_points(axes, points, labels, colors, front=(), size=7, others=()):
    """Writes each label beside its point, where it covers least.

    Greedy: a label takes the place that hides the least of points (`others`
    too), the front's line and earlier labels, near ones first; far ones get a
    thin line to their point. `front`: indices of points. The figure must be
    settled.
    """
    figure = axes.figure
    renderer = figure.canvas.get_renderer()
    frame = axes.get_window_extent(renderer).extents
    to_pixels = axes.transData.transform
    taken = [(x - 4, y - 4, x + 4, y + 4)
             for x, y in to_pixels([*points, *others])]
    taken += along(to_pixels(stairs([points[i] for i in front])), 4)
    for index, (point, text) in enumerate(zip(points, labels)):
        note = axes.annotate(text, point, (0, 0), fontsize=size,
                             color=colors[index], linespacing=1.05,
                             textcoords="offset points")
        dx, dy, box = best_place(note, places(index in front), taken, frame,
                                 renderer, figure.dpi / 72)
        if max(abs(dx), abs(dy)) > 9:
            axes.annotate("", point, (dx, dy), textcoords="offset points",
                          arrowprops={"arrowstyle": "-", "color": MUTED,
                                      "lw": 0.5, "shrinkA": 0, "shrinkB": 3})
        taken.append(box)


def best_place(note, candidates, taken, frame, renderer, scale):
    """Puts a note where it costs least; returns its offset and its box."""
    best = None
    for dx, dy, ha, va in candidates:
        note.set(ha=ha, va=va, position=(dx, dy))
        box = tuple(note.get_window_extent(renderer).extents)
        hidden = sum(overlap(box, other) for other in taken)
        outside = overlap(box, box) - overlap(box, frame)
        cost = 5 * hidden + 5 * outside + 1.5 * scale * max(abs(dx), abs(dy))
        if best is None or cost < best[0]:
            best = cost, (dx, dy, ha, va), box
    dx, dy, ha, va = best[1]
    note.set(ha=ha, va=va, position=(dx, dy))
    return dx, dy, best[2]
