#!/usr/bin/python3
"""Checks that no two types of the project share a name.

    scripts/check_names.py [--root=FOLDER]

Two classes of one name in one namespace, in different files, are undefined
behavior that no compiler reports: the linker keeps one of the two's inline
functions for both. Types in unnamed namespaces are free to share names.
"""

import argparse
import re
import sys
from pathlib import Path

FOLDERS = ["core", "encoders", "reference", "harness", "tests"]
SUFFIXES = {".h", ".cc", ".cu", ".cuh"}
# A definition at the margin, where everything of a namespace stands; a
# specialization (Name<...>) and a nested class (Outer::Name) are others.
TYPE = re.compile(r"^(?:struct|class|enum(?: class)?|union)\s+(\w+)"
                  r"\s*(?:final\s*)?(?:\{|:(?!:)|$)")


def definitions(text):
    """(line number, name) of each type defined in a named namespace."""
    unnamed = False
    for number, line in enumerate(text.split("\n"), 1):
        if line.startswith("namespace {"):
            unnamed = True
        elif line.startswith("}  // namespace") and unnamed:
            unnamed = False
        match = TYPE.match(line)
        if match and not unnamed:
            yield number, match.group(1)


def check(root):
    """All violations below `root`, as lines of text."""
    first, errors = {}, []
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in SUFFIXES or not path.is_file():
                continue
            name = path.relative_to(root).as_posix()
            for line, kind in definitions(path.read_text(encoding="utf-8")):
                place = f"{name}:{line}"
                if kind in first:
                    errors.append(f"{place}: {kind} is also the name of a "
                                  f"type at {first[kind]}")
                first.setdefault(kind, place)
    return errors


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--root", type=Path,
                        default=Path(__file__).resolve().parent.parent)
    errors = check(parser.parse_args().root)
    for error in errors:
        print(error)
    print(f"check_names: {len(errors)} violations", file=sys.stderr)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
