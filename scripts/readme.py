#!/usr/bin/python3
"""Makes the README's picture and tables, so that they cannot drift from what
the program does and from the results that are kept.

    scripts/readme.py            runs build/release/rtbench, rewrites all
    scripts/readme.py --results  rewrites what comes from results/ alone
    scripts/readme.py --check    says whether the README's figures still hold

The first table is the main job's own output; --check compares what does not
depend on the machine (rays, MSE, PSNR, SSIM, FLIP). What stands between the
marks <!-- results --> and <!-- /results --> is results/report/overview.md, as
scripts/results wrote it; --check wants the very same text. Exits 1 when
something differs.
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


RESULTS = ROOT / "results" / "report" / "overview.md"
QUOTED = re.compile(r"(?<=<!-- results -->\n).*?(?=<!-- /results -->)",
                    re.DOTALL)


def with_results(text):
    """The README with the kept results' overview between its marks."""
    if not QUOTED.search(text):
        return text
    if not RESULTS.exists():
        sys.exit(f"{RESULTS} is missing; scripts/results makes it")
    overview = RESULTS.read_text(encoding="utf-8").strip()
    return QUOTED.sub(lambda _: f"\n{overview}\n\n", text)


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
    parser.add_argument("--results", action="store_true")
    options = parser.parse_args()
    text = README.read_text(encoding="utf-8")
    if options.results:
        README.write_text(with_results(text), encoding="utf-8")
        return
    found = TABLE.search(text)
    if not found:
        sys.exit(f"{README}: no table between <!-- table --> marks")
    if options.check:
        if with_results(text) != text:
            sys.exit(f"{README}: what stands between <!-- results --> marks "
                     f"is not {RESULTS}; run scripts/readme.py --results")
        fresh = lasting_figures(
            table_of(run(options.program, *JOB, "--repeat=1")))
        shown = lasting_figures(found.group())
        for name in sorted(fresh.keys() | shown.keys()):
            if fresh.get(name) != shown.get(name):
                sys.exit(f"{README}: {name} shows {shown.get(name)}, a run "
                         f"gives {fresh.get(name)}; run scripts/readme.py")
        return
    table = table_of(run(options.program, *JOB, "--repeat=30"))
    README.write_text(with_results(TABLE.sub(lambda _: table, text)),
                      encoding="utf-8")
    make_picture(options.program)


if __name__ == "__main__":
    main()
