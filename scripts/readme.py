#!/usr/bin/python3
"""Makes the README's picture and table from a run of the main job, so that
they cannot drift from what the program does.

    scripts/readme.py            runs build/release/rtbench, rewrites both
    scripts/readme.py --check    says whether the README's figures still hold

The table is the program's own output. --check compares what does not depend on
the machine (rays, MSE, PSNR, SSIM, FLIP) and exits 1 when it differs.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
PICTURE = ROOT / "docs" / "images" / "whitted-octant.png"
JOB = ["--encoder=half,quadrant,search,tiv,sextant,octant,braille,optimal,"
       "adaptive", "--scene=cornell", "--quiet"]
TABLE = re.compile(r"(?<=<!-- table -->\n```\n).*?(?=```\n<!-- /table -->)",
                   re.DOTALL)


def run(program, *arguments):
    """What the program prints on standard output."""
    return subprocess.run([program, *arguments], check=True,
                          stdout=subprocess.PIPE, text=True).stdout


def table_of(output):
    """The first table, without warnings about a busy machine."""
    first = output.split("\n\n")[0].rstrip("\n") + "\n"
    return "".join(line for line in first.splitlines(keepends=True)
                   if not line.startswith("warning:"))


def lasting_figures(table):
    """Encoder -> the columns that are the same on every machine."""
    rows = [line.split() for line in table.splitlines()]
    return {row[0]: (row[1], *row[-4:]) for row in rows
            if len(row) > 6 and re.fullmatch(r"[\d.]+", row[-1])}


def make_picture(program):
    """Writes a decoded grid (left) beside its reference (right)."""
    # Here, so that --check runs without these packages.
    import matplotlib.image
    import numpy
    with tempfile.TemporaryDirectory() as folder:
        run(program, "--encoder=octant", "--scene=whitted", "--repeat=1",
            "--quiet", f"--out={folder}")
        grid, reference = (
            matplotlib.image.imread(f"{folder}/{name}.png")[..., :3]
            for name in ("octant", "reference"))
    PICTURE.parent.mkdir(parents=True, exist_ok=True)
    gap = numpy.ones((grid.shape[0], 16, 3), grid.dtype)
    matplotlib.image.imsave(PICTURE, numpy.hstack([grid, gap, reference]),
                            metadata={"Software": "rtbench"})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path,
                        default=ROOT / "build" / "release" / "rtbench")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    text = README.read_text()
    found = TABLE.search(text)
    if not found:
        sys.exit(f"{README}: no table between <!-- table --> marks")
    if options.check:
        fresh = lasting_figures(
            table_of(run(options.program, *JOB, "--repeat=1")))
        shown = lasting_figures(found.group())
        for name in sorted(fresh.keys() | shown.keys()):
            if fresh.get(name) != shown.get(name):
                sys.exit(f"{README}: {name} shows {shown.get(name)}, a run "
                         f"gives {fresh.get(name)}; run scripts/readme.py")
        return
    table = table_of(run(options.program, *JOB, "--repeat=30"))
    README.write_text(TABLE.sub(lambda _: table, text))
    make_picture(options.program)


if __name__ == "__main__":
    main()
