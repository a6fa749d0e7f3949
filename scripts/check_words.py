#!/usr/bin/python3
"""Checks that no file speaks of unfinished work or of one person's machine.

    scripts/check_words.py [--root=FOLDER]

Looks through every text file that is not ignored by name: marks of unfinished
work, and absolute paths that exist on one machine only.
"""

import argparse
import re
import sys
from pathlib import Path

# Split, so that this file passes its own check. A string that begins or ends
# with such letters may be anything.
MARKS = re.compile(r"(?<![\w\"'])(" + "|".join(
    ["TO" + "DO", "FIX" + "ME", "X" + "XX", "HA" + "CK"]) + r")(?![\w\"'])")
# A temporary folder is asked for, never named.
PLACES = re.compile(r"(?<![\w.\-/$}{*])/(home|root|work|Users|mnt|scratch|tmp)"
                    r"/[\w.]")
SKIPPED = {"build", ".git", ".cache", "__pycache__"}
SUFFIXES = {".h", ".cc", ".cu", ".cuh", ".inc", ".in", ".py", ".sh", ".cmake",
            ".txt", ".md", ".json", ".yaml", ".yml", ".supp", ""}


def files(root):
    for path in sorted(root.iterdir()):
        if path.name in SKIPPED or path.is_symlink():
            continue
        if path.is_dir():
            if path.relative_to(path.parent.parent) != Path("results/local"):
                yield from files(path)
        elif path.suffix in SUFFIXES:
            yield path


def check(root):
    """All violations below `root`, as lines of text."""
    errors = []
    for path in files(root):
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue  # not text
        for number, line in enumerate(text.split("\n"), 1):
            for pattern, what in ((MARKS, "unfinished work"),
                                  (PLACES, "a place on one machine")):
                match = pattern.search(line)
                if match:
                    name = path.relative_to(root).as_posix()
                    errors.append(f"{name}:{number}: `{match.group(0)}`: "
                                  f"{what}")
    return errors


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--root", type=Path,
                        default=Path(__file__).resolve().parent.parent)
    errors = check(parser.parse_args().root.resolve())
    for error in errors:
        print(error)
    print(f"check_words: {len(errors)} violations", file=sys.stderr)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
