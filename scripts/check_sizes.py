#!/usr/bin/python3
"""Checks that files stay small enough to hold one concept.

    scripts/check_sizes.py [--root=FOLDER] [--functions]

A source file longer than 300 lines is a violation, unless it is a data table
(*_table.*) or scripts/size_allowances.txt names it with a reason. An allowance
that no file needs any more is a violation too. --functions lists functions
longer than 40 lines, as advice.
"""

import argparse
import re
import sys
from pathlib import Path

MAX_FILE = 300
MAX_FUNCTION = 40
FOLDERS = ["core", "encoders", "reference", "harness", "tests", "scripts"]
SUFFIXES = {".h", ".cc", ".cu", ".cuh", ".inc", ".py", ".sh"}
ALLOWANCES = "scripts/size_allowances.txt"

# A line that opens a function's body: `) {`, `) const {`, `: member_(x) {`.
OPENS = re.compile(r"\)[\w\s>&*:,-]*\{$")
CONTROL = re.compile(r"^\s*(\}|if|for|while|switch|do|namespace|else)\b|\[.*\]")
TEXT = re.compile(r'//.*|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])+\'')


def sources(root):
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if (path.is_file() and path.suffix in SUFFIXES
                    and not path.stem.endswith("_table")):
                yield path


def allowances(root):
    """{file: (line number, reason)} of the allowance file."""
    found = {}
    path = root / ALLOWANCES
    if path.is_file():
        for number, line in enumerate(path.read_text().split("\n"), 1):
            name, _, reason = line.partition(" ")
            if name and not name.startswith("#"):
                found[name] = (number, reason.strip())
    return found


def long_functions(lines):
    """(line of the opening brace, length) of functions that are too long."""
    start, depth = None, 0
    for number, line in enumerate(lines, 1):
        code = TEXT.sub("", line).rstrip()
        if start is None:
            if not OPENS.search(code) or CONTROL.search(code):
                continue
            start, depth = number, 0
        depth += code.count("{") - code.count("}")
        if depth <= 0:
            if number - start + 1 > MAX_FUNCTION:
                yield start, number - start + 1
            start = None


def check(root):
    """Violations as lines of text, and advice about functions."""
    errors, advice = [], []
    allowed = allowances(root)
    for name, (number, reason) in allowed.items():
        if not reason:
            errors.append(f"{ALLOWANCES}:{number}: {name} gives no reason")
    needed = set()
    for path in sources(root):
        name = path.relative_to(root).as_posix()
        lines = path.read_text(encoding="utf-8").rstrip("\n").split("\n")
        if len(lines) > MAX_FILE:
            needed.add(name)
            if name not in allowed:
                errors.append(f"{name}:{MAX_FILE + 1}: {len(lines)} lines; "
                              f"more than {MAX_FILE} need a reason in "
                              f"{ALLOWANCES}")
        if path.suffix in {".h", ".cc", ".cu", ".cuh"}:
            advice += [f"{name}:{first}: a function of {length} lines"
                       for first, length in long_functions(lines)]
    for name in sorted(set(allowed) - needed):
        errors.append(f"{ALLOWANCES}:{allowed[name][0]}: {name} needs no "
                      "allowance")
    return errors, advice


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--root", type=Path,
                        default=Path(__file__).resolve().parent.parent)
    parser.add_argument("--functions", action="store_true")
    arguments = parser.parse_args()
    errors, advice = check(arguments.root)
    for line in errors + (advice if arguments.functions else []):
        print(line)
    print(f"check_sizes: {len(errors)} violations, {len(advice)} functions "
          f"above {MAX_FUNCTION} lines", file=sys.stderr)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
