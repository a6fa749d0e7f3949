"""Plots as SVG inside the page, in the page's own colors."""

import io
import re

from report import plots
from report.plots import style

# Colors of style.py that follow the page, light or dark.
THEMED = {style.INK: "var(--ink)", style.LINE: "var(--line)",
          style.MUTED: "var(--muted)", style.FRONT: "var(--front)",
          style.CONTROL: "var(--control)", "#ffffff": "var(--surface)"}


def inline(plot):
    """{"title", "caption", "svg"} of a plot."""
    out = io.BytesIO()
    plots.save(plot, out)
    text = out.getvalue().decode("utf-8")
    text = text[text.index("<svg"):]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    # Its size is the figure's; two plots must not share ids.
    text = re.sub(r'(<svg[^>]*?) width="[^"]*"', r"\1", text, count=1)
    text = re.sub(r'(<svg[^>]*?) height="[^"]*"', r"\1", text, count=1)
    text = re.sub(r'id="([^"]+)"', rf'id="{plot.name}-\1"', text)
    text = re.sub(r'(url\(|href=")#([^")]+)', rf"\1#{plot.name}-\2", text)
    for color, name in THEMED.items():
        text = text.replace(color, name)
    label = plot.title.replace("&", "&amp;").replace('"', "&quot;")
    text = text.replace("<svg", f'<svg role="img" aria-label="{label}"', 1)
    # Without a fill of its own, text takes black.
    text = text.replace("<svg", '<svg style="fill:var(--ink)"', 1)
    text = "\n".join(line.strip() for line in text.splitlines()
                     if line.strip())
    return {"title": plot.title, "caption": plot.caption, "svg": text}
