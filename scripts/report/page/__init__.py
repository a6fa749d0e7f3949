"""The results page: one HTML file that needs nothing else.

Figures, tables and plots stand in it as they are; grids, FLIP maps and
references as base64 texts that the page decodes when they are looked at.
"""

import json
from pathlib import Path

from report import provenance
from report.errors import BadInput
from report.page import pictures, runs, vectors

FOLDER = Path(__file__).resolve().parent
SCRIPTS = ("data.js", "grid.js", "divider.js", "table.js", "viewer.js",
           "main.js")
# Longer tables would make the page slow; they are in files of their own.
MOST_ROWS = 120


def embedded(value):
    """JSON that may stand inside a script element."""
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"),
                      allow_nan=False)
    return text.replace("<", "\\u003c")


def suites(results):
    """The names of the suites that the records belong to."""
    return ", ".join(sorted({record["unit"]["suite"] for record
                             in results.records if "unit" in record}))


def about(results):
    """(name, text) of where everything comes from."""
    programs = sorted({
        "rtbench {version}, {compiler}, {build_type}".format(
            **record["manifest"]["program"]) for record in results.records
        if "manifest" in record})
    dates = sorted(record["volatile"]["utc"] for record in results.records
                   if "volatile" in record)
    found = [("Suite", suites(results)),
             ("Commit", provenance.join(provenance.commits(results.records))),
             ("Machine", provenance.join(provenance.hosts(results.records))),
             ("Program", "; ".join(programs)),
             ("Measured", f"{dates[0]} to {dates[-1]}" if dates else ""),
             ("Records", f"{len(results.records)}, of which "
                         f"{len(results.failures)} failed or were skipped")]
    return [(name, text) for name, text in found if text]


def lead(results):
    """One line under the title."""
    scored = results.scored()
    scenes = {run.scene for run in scored}
    encoders = {run.encoder for run in scored}
    views = results.views()
    measured = f" FLIP is {views[0].measured()}." if views else ""
    return (f"{len(encoders)} encoders on {len(scenes)} scenes. Each draws "
            "a ray-traced picture in the character cells of a terminal; "
            f"FLIP says how far it looks from the reference.{measured}")


def write(folder, results, tables, plots, warnings):
    """index.html; returns the files written."""
    import jinja2
    if not results.scored():
        raise BadInput(f"{results.folder}: no record has a FLIP value, so "
                       "there is nothing for the page to show")
    store = pictures.Store(results.folder / "pictures")
    data = runs.page_data(results, store)
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(FOLDER), autoescape=True,
        trim_blocks=True, lstrip_blocks=True,
        undefined=jinja2.StrictUndefined)
    text = environment.get_template("page.html.j2").render(
        title=": ".join(filter(None, ["rtbench results", suites(results)])),
        lead=lead(results), warnings=warnings,
        css=(FOLDER / "page.css").read_text(encoding="utf-8"),
        js="\n".join((FOLDER / name).read_text(encoding="utf-8")
                     for name in SCRIPTS),
        plots=[vectors.inline(plot) for plot in plots],
        tables=[t for t in tables if len(t.rows) <= MOST_ROWS],
        long_tables=[f"{t.title} (tables/{t.name}.csv)" for t in tables
                     if len(t.rows) > MOST_ROWS],
        about=about(results), data=embedded(data), blobs=store.blobs())
    file = folder / "index.html"
    file.write_text(text, encoding="utf-8")
    return [file]
