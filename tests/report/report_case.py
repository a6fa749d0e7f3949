"""What the tests of the report share: its package, folders, programs."""

import importlib.util
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
MODULES = ("numpy", "scipy", "matplotlib", "PIL", "jinja2")

sys.path.insert(0, str(ROOT / "scripts"))


def need(*modules, programs=()):
    """Ends the test as skipped where something is missing."""
    lacking = [name for name in (*MODULES, *modules)
               if importlib.util.find_spec(name) is None]
    lacking += [name for name in programs if not shutil.which(name)]
    if lacking:
        print("skipped: missing " + ", ".join(lacking))
        sys.exit(77)


class ReportTest(unittest.TestCase):
    """A test case with a temporary folder of its own, `self.folder`."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="rtbench_report_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_close(self, found, expected, tolerance=1e-12):
        self.assertLess(abs(found - expected), tolerance, (found, expected))
