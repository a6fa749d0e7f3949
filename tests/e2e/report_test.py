#!/usr/bin/python3
"""rtbench report, installed: from records of the main job to all formats."""

import json
import sys
import unittest

from program import ROOT, ProgramTest

sys.path.insert(0, str(ROOT / "tests" / "report"))
from report_case import need  # noqa: E402

need()

FORMATS = ("latex", "csv", "markdown", "html", "plots")


class ReportTest(ProgramTest):

    def record(self):
        """A folder with the main job's record, as it writes it."""
        self.succeed("--scene=cornell", "--encoder=half,tiv,quadrant",
                     "--grid=21x7", "--repeat=3", "--quiet", "--out=records")
        return json.loads((self.folder / "records" / "record.json")
                          .read_text())

    def test_all_formats(self):
        record = self.record()
        out = self.succeed("report", "records", "--out=deep/report")
        names = out.decode().split()
        for name in names:
            self.assertTrue((self.folder / name).stat().st_size > 0, name)
        for name in ("tables.tex", "tables.md", "runs.csv", "index.html",
                     "plots/error-rays.svg", "plots/error-time.pdf",
                     "tables/flip-summary.csv"):
            self.assertIn(f"deep/report/{name}", names)
        # The figure of the record, rounded.
        flip = record["runs"][0]["metrics"]["flip"]
        text = (self.folder / "deep/report/tables.md").read_text()
        self.assertIn(f"| `half` | **{flip:.4f}** |"
                      if flip == min(run["metrics"]["flip"]
                                     for run in record["runs"])
                      else f"| `half` | {flip:.4f} |", text)

    def test_one_format(self):
        self.record()
        self.succeed("report", "records", "--out=out", "--format=csv",
                     "--quiet")
        self.assertTrue((self.folder / "out" / "runs.csv").exists())
        self.assertFalse((self.folder / "out" / "tables.md").exists())

    def test_bad_arguments(self):
        (self.folder / "empty").mkdir()
        for arguments, words in [
                (("report", "none", "--out=o"), ["DIR", "'none'"]),
                (("report", "empty", "--out=o"), ["no records"]),
                (("report", "empty"), ["--out"]),
                (("report", "empty", "--out=o", "--format=pdf"),
                 ["--format", "'pdf'", "latex"])]:
            self.fail_with(2, *arguments, says=words)
        self.write("empty/a.json", "{")
        self.fail_with(2, "report", "empty", "--out=o", says="not a record")

    def test_where_nothing_can_be_written(self):
        self.record()
        self.write("file", "")
        self.fail_with(1, "report", "records", "--out=file/out",
                       "--format=csv", says="file/out")

    def test_a_missing_module_is_named(self):
        """A Python without Debian's folder of packages."""
        self.record()
        python = self.write("python", "#!/bin/sh\n"
                            "exec /usr/bin/python3 -I -S \"$@\"\n")
        python.chmod(0o755)
        process = self.run_program("report", "records", "--out=o",
                                   "--format=csv",
                                   env={"RTBENCH_PYTHON": str(python)})
        self.assertEqual(process.returncode, 3, process.stderr)
        self.assertIn(b"python3-scipy", process.stderr)
        self.assertEqual(process.stderr.count(b"\n"), 1)


if __name__ == "__main__":
    unittest.main()
