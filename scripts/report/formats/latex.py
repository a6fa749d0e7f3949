"""Tables as LaTeX with booktabs: one file a table, and one that has all.

tables.tex compiles by itself; a paper inputs the files of tables/ and takes
over the packages and the three macros that tables.tex defines.
"""

SPECIAL = {"\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "#": r"\#",
           "$": r"\$", "%": r"\%", "&": r"\&", "_": r"\_",
           "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
           "<": r"\textless{}", ">": r"\textgreater{}", "|": r"\textbar{}",
           '"': r"\char34{}",
           "−": "$-$", "–": "--", "×": r"$\times$", "τ": r"$\tau$",
           "≤": r"$\leq$", "∞": r"$\infty$", "²": r"\textsuperscript{2}",
           "⁴": r"\textsuperscript{4}", "⚠": r"\rtbwarn{}", "χ": r"$\chi$",
           "·": r"$\cdot$", "→": r"$\rightarrow$", "Δ": r"$\Delta$"}
# Rows that a page holds; longer tables run over several.
MOST_ROWS = 40

HEAD = r"""\documentclass[10pt]{article}
\usepackage[utf8]{inputenc}
% Latin Modern where it is there: in T1 the default would be bitmaps.
\IfFileExists{lmodern.sty}{\usepackage[T1]{fontenc}\usepackage{lmodern}}{}
\usepackage{booktabs,longtable,graphicx,caption}
\usepackage[a4paper,landscape,margin=15mm]{geometry}
\captionsetup{font=small,justification=raggedright,singlelinecheck=false}
\setlength{\LTleft}{0pt}
\setlength{\tabcolsep}{4pt}
% A table as wide as it is, but never wider than the page.
\newsavebox{\rtbbox}
\newcommand{\rtbfit}[1]{\sbox{\rtbbox}{#1}%
  \ifdim\wd\rtbbox>\linewidth\resizebox{\linewidth}{!}{\usebox{\rtbbox}}%
  \else\usebox{\rtbbox}\fi}
\newcommand{\rtbwarn}{\textsuperscript{!}}
\newcommand{\rtbside}[1]{\rotatebox{90}{#1\,}}
\begin{document}
\footnotesize
"""


def escape(text):
    """Text for LaTeX; a character outside of Latin-1 becomes its number."""
    return "".join(SPECIAL.get(c) or (c if ord(c) < 256
                                      else f"U+{ord(c):04X}")
                   for c in str(text))


def cell(found):
    text = escape(found.text)
    if found.code:
        # May break after a colon, where it is set in a paragraph.
        text = r"\texttt{" + text.replace(":", r":\allowbreak{}") + "}"
    if found.best:
        text = r"\textbf{" + text + "}"
    return text + (r"\rtbwarn{}" if found.warn else "")


def heading(column):
    text = escape(column.heading)
    return text if column.upright else r"\rtbside{" + text + "}"


def body(table):
    """The rows, with a rule above those that summarize."""
    lines = []
    for index, row in enumerate(table.rows):
        if table.total and index == len(table.rows) - table.total:
            lines.append(r"\midrule")
        lines.append(" & ".join(map(cell, row)) + r" \\")
    return lines


def table(found):
    """A float, or a longtable when it is longer than a page."""
    columns = "".join("l" if c.left else "r" for c in found.columns)
    heads = " & ".join(map(heading, found.columns)) + r" \\"
    caption = escape(f"{found.title}. {found.caption}")
    notes = [r"\par\smallskip\parbox{\linewidth}{\raggedright "
             + escape(note) + "}" for note in found.notes]
    if len(found.rows) <= MOST_ROWS:
        lines = [r"\begin{table}[!htbp]", rf"\caption{{{caption}}}",
                 rf"\label{{tab:{found.name}}}",
                 rf"\rtbfit{{\begin{{tabular}}{{@{{}}{columns}@{{}}}}",
                 r"\toprule", heads, r"\midrule", *body(found),
                 r"\bottomrule", r"\end{tabular}}", *notes, r"\end{table}"]
    else:
        lines = [r"\begingroup\scriptsize",
                 rf"\begin{{longtable}}{{@{{}}{columns}@{{}}}}",
                 rf"\caption{{{caption}}}\label{{tab:{found.name}}}\\",
                 r"\toprule", heads, r"\midrule", r"\endfirsthead",
                 r"\toprule", heads, r"\midrule", r"\endhead",
                 *body(found), r"\bottomrule", r"\end{longtable}", *notes,
                 r"\endgroup"]
    return "\n".join(lines) + "\n"


def write(folder, tables, warnings):
    """tables/*.tex and tables.tex; returns the files written."""
    parts = [HEAD, r"\section*{Results}" + "\n"]
    if warnings:
        parts.append(r"\begin{itemize}" + "\n")
        parts += [r"\item[\rtbwarn] " + escape(w) + "\n" for w in warnings]
        parts.append(r"\end{itemize}" + "\n")
    files = []
    (folder / "tables").mkdir(exist_ok=True)
    for found in tables:
        file = folder / "tables" / f"{found.name}.tex"
        file.write_text(table(found), encoding="utf-8")
        files.append(file)
        parts.append(rf"\input{{tables/{found.name}.tex}}" + "\n"
                     + r"\clearpage" + "\n")
    parts.append(r"\end{document}" + "\n")
    whole = folder / "tables.tex"
    whole.write_text("".join(parts), encoding="utf-8")
    return [whole, *files]
