"""All plots of a report, as matplotlib figures with their captions."""

from dataclasses import dataclass

from report import study
from report.formats import latex
from report.formats.markdown import escape
from report.plots import style


@dataclass
class Plot:
    name: str
    title: str
    caption: str
    figure: object


def draw(results):
    """The plots that the records have figures for."""
    from report.plots import causes, differences, flicker, tradeoff
    style.use()
    found = []
    for one in study.studies(results):
        found += [tradeoff.rays(one), tradeoff.time(one),
                  tradeoff.bytes_(one), differences.forest(one)]
        if one.first:
            found += [tradeoff.by_scene(one), tradeoff.time_by_scene(one),
                      causes.shares(one), causes.distances(one)]
    found.append(flicker.flicker(results))
    found = [plot for plot in found if plot]
    for plot in found:
        style.settle(plot.figure)
    return found


def save(plot, file):
    """One figure; the same bytes for the same figures."""
    import matplotlib
    # Ids in an SVG are hashed with this: those of two plots on a page differ.
    matplotlib.rcParams["svg.hashsalt"] = plot.name
    dates = {"svg": {"Date": None, "Title": plot.title,
                     "Description": plot.caption},
             "pdf": {"CreationDate": None, "Title": plot.title,
                     "Subject": plot.caption}}
    suffix = str(getattr(file, "suffix", ".svg"))[1:]
    plot.figure.savefig(file, format=suffix, metadata=dates[suffix])


def write(folder, plots):
    """plots/*.svg, *.pdf and their captions; returns the files."""
    folder = folder / "plots"
    folder.mkdir(exist_ok=True)
    files = []
    for plot in plots:
        for suffix in (".svg", ".pdf"):
            file = folder / (plot.name + suffix)
            save(plot, file)
            files.append(file)
    captions = folder / "captions.md"
    captions.write_text("\n".join(
        f"## {escape(plot.title)}\n\n![{escape(plot.title)}]"
        f"({plot.name}.svg)\n\n{escape(plot.caption)}\n" for plot in plots),
        encoding="utf-8")
    figures = folder / "plots.tex"
    figures.write_text("\n".join(
        "\\begin{figure}[!htbp]\n\\centering\n"
        f"\\includegraphics[width=\\linewidth]{{plots/{plot.name}.pdf}}\n"
        f"\\caption{{{latex.escape(f'{plot.title}. {plot.caption}')}}}\n"
        f"\\label{{fig:{plot.name}}}\n\\end{{figure}}\n" for plot in plots),
        encoding="utf-8")
    return [*files, captions, figures]


def close(plots):
    from matplotlib import pyplot
    for plot in plots:
        pyplot.close(plot.figure)
