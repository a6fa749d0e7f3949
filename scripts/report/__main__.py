#!/usr/bin/python3
"""Tables, plots and a page from the records of a sweep.

    python3 scripts/report DIR --out=DIR [--format=latex,csv,...]

`rtbench report` runs this. It takes the first Python that has the modules it
needs: the one that runs it, python3 on PATH, Debian's; RTBENCH_PYTHON names
the one to take. Exit status: 0 success, 1 failure, 2 usage or bad input, 3 a
missing module.
"""

import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path

# Each module with the Debian package that brings it.
MODULES = {"numpy": "python3-numpy", "scipy": "python3-scipy",
           "matplotlib": "python3-matplotlib", "PIL": "python3-pil",
           "jinja2": "python3-jinja2"}
PROBE = ("import importlib.util, sys; "
         "sys.exit(any(importlib.util.find_spec(m) is None "
         "for m in sys.argv[1:]))")


def missing_here():
    return [name for name in MODULES if importlib.util.find_spec(name) is None]


def other_python():
    """Another interpreter that has all modules, or None."""
    if os.environ.get("RTBENCH_PYTHON"):
        return None
    for python in (shutil.which("python3"), "/usr/bin/python3"):
        if python and os.path.exists(python) and not os.path.samefile(
                python, sys.executable):
            probe = subprocess.run([python, "-c", PROBE, *MODULES],
                                   stderr=subprocess.DEVNULL, check=False)
            if probe.returncode == 0:
                return python
    return None


def main():
    missing = missing_here()
    if missing:
        python = other_python()
        if python:
            os.execv(python, [python, "-B", *sys.argv])
        print("no Python here has " + ", ".join(missing) + "; Debian's "
              "packages are " + ", ".join(MODULES[name] for name in missing),
              file=sys.stderr)
        return 3
    sys.path[0] = str(Path(__file__).resolve().parent.parent)
    from report.command import run
    return run(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
