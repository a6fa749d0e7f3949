"""The command line: reads the records, writes what was asked for."""

import argparse
import sys
from pathlib import Path

from report.errors import BadInput

FORMATS = ("latex", "csv", "markdown", "html", "plots")


def formats(text):
    """`latex,csv` as a tuple, in the order of FORMATS."""
    given = text.split(",")
    unknown = [name for name in given if name not in FORMATS]
    if unknown:
        raise argparse.ArgumentTypeError(
            f"'{unknown[0]}' is not one of {', '.join(FORMATS)}")
    return tuple(name for name in FORMATS if name in given)


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="report", description="Tables, plots and a page from the "
        "records of a sweep.")
    parser.add_argument("folder", type=Path, help="what a sweep wrote")
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--format", type=formats, default=FORMATS)
    return parser.parse_args(arguments)


def write(results, out, wanted):
    """Writes every wanted format; returns (files, warnings)."""
    # Here, so that tables alone do not wait for matplotlib.
    from report import provenance, tables
    from report.formats import latex, markdown, tidy
    warnings = provenance.warnings(results)
    found = tables.build(results)
    files = []
    if "latex" in wanted:
        files += latex.write(out, found, warnings)
    if "csv" in wanted:
        files += tidy.write(out, results, found)
    if "markdown" in wanted:
        files += markdown.write(out, found, warnings)
    if "plots" in wanted or "html" in wanted:
        from report import plots
        drawn = plots.draw(results)
        if "plots" in wanted:
            files += plots.write(out, drawn)
        if "html" in wanted:
            from report import page
            files += page.write(out, results, found, drawn, warnings)
        plots.close(drawn)
    return files, warnings


def run(arguments):
    """The exit status."""
    from report import records
    options = parse(arguments)
    try:
        results = records.load(options.folder)
        options.out.mkdir(parents=True, exist_ok=True)
        files, warnings = write(results, options.out, options.format)
    except BadInput as error:
        print(error, file=sys.stderr)
        return 2
    except OSError as error:
        print(error, file=sys.stderr)
        return 1
    for warning in warnings:
        print(f"warning: {warning}", file=sys.stderr)
    for file in files:
        print(file)
    return 0
