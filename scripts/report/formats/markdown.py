"""Tables as Markdown, all in one file; the first also alone, to quote."""

from report.table import NONE

OVERVIEW = "overview"


def escape(text):
    for mark in "\\`*_<>|[]":
        text = text.replace(mark, "\\" + mark)
    return text


def code(text):
    """Code, with a bar that does not end the cell."""
    fence = "``" if "`" in text else "`"
    return fence + text.replace("|", "\\|") + fence


def cell(found):
    text = code(found.text) if found.code else escape(found.text)
    if found.best:
        text = f"**{text}**"
    return text + (" ⚠" if found.warn else "")


def table(found):
    """One table under its heading."""
    return f"### {escape(found.title)}\n\n" + body(found)


def body(found):
    """Its caption, its rows, its notes."""
    lines = [escape(found.caption), "",
             "| " + " | ".join(escape(c.heading) for c in found.columns)
             + " |",
             "| " + " | ".join("---" if c.left else "---:"
                               for c in found.columns) + " |"]
    for row in found.rows:
        lines.append("| " + " | ".join(map(cell, row)) + " |")
    lines.append("")
    for note in found.notes:
        lines += [escape(note), ""]
    return "\n".join(lines)


def write(folder, tables, warnings):
    """tables.md, and overview.md for a page to quote; returns the files."""
    parts = ["# Results\n"]
    parts += [f"> ⚠ {escape(warning)}\n" for warning in warnings]
    parts.append(f"Figures that have no value show {NONE}; the best of a "
                 "column is bold; ⚠ marks figures that are not to be relied "
                 "on.\n")
    parts += map(table, tables)
    file = folder / "tables.md"
    file.write_text("\n".join(parts), encoding="utf-8")
    files = [file]
    for found in tables:
        if found.name == OVERVIEW:
            files.append(folder / f"{OVERVIEW}.md")
            files[-1].write_text(body(found), encoding="utf-8")
    return files
