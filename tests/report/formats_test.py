#!/usr/bin/python3
"""CSV, Markdown and LaTeX: every field, every escape, and that it compiles."""

import csv
import shutil
import subprocess
import unittest

from report_case import ReportTest, need
from synthetic import Suite

need()

from report import command, records
from report.formats import latex, markdown
from report.table import Cell, Column, Table

NASTY = "a_b & 50% #1 $x {y} ^~\\ <|> \"'`* ⚠ ▄"


class FormatsTest(ReportTest):

    def suite(self):
        suite = Suite(self.folder / "sweep")
        for scene in ("a_b", "c#d"):
            for encoder in ("half", "tiv", "octant:dither=bayer",
                            f"external:x {NASTY}"):
                suite.quality(scene, encoder, 0.1 + 0.01 * len(encoder),
                              bytes_per_frame=1000)
        suite.timing("a_b", {"half": {"render": [1.0, 2.0],
                                      "encode": [1.0, 1.0]}})
        suite.failed("a_b", "external:tiv", NASTY, "skipped")
        suite.temporal("a_b", "half")
        suite.live("a_b", "half", 60)
        return self.write("latex", "csv", "markdown")

    def write(self, *formats):
        out = self.folder / "out"
        out.mkdir(exist_ok=True)
        command.write(records.load(self.folder / "sweep"), out, formats)
        return out

    def test_csv_has_every_field_of_every_run(self):
        out = self.suite()
        with (out / "runs.csv").open(encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 11)
        first = [r for r in rows if r["encoder"] == "half"
                 and r["scene"] == "a_b" and r["kind"] == "quality"][0]
        self.assertEqual(float(first["metrics.flip"]), 0.14)
        self.assertEqual(first["grid"], "20 10")
        self.assertEqual(first["settings.ppd"], "40.0")
        self.assertEqual(first["program.dirty"], "false")
        self.assertEqual(first["metrics.ms_ssim"], "")
        self.assertEqual(first["inputs.reference"],
                         "a_b.povray.exr " + "b" * 64)
        timed = [r for r in rows if r["kind"] == "timing"][0]
        self.assertEqual(timed["ms.render.samples"], "1.0 2.0")
        self.assertEqual(timed["volatile.host.cpu_model"], "Test CPU")
        with (out / "failures.csv").open(encoding="utf-8") as file:
            failure = next(csv.DictReader(file))
        self.assertEqual((failure["kind"], failure["what"]),
                         ("skipped", NASTY))

    def test_csv_of_a_flip_table_says_ppd_and_raster(self):
        out = self.suite()
        text = (out / "tables" / "flip-by-scene.csv").read_text()
        with (out / "tables" / "flip-by-scene.csv").open() as file:
            row = [r for r in csv.DictReader(file)
                   if r["encoder"] == "half"][0]
        self.assertEqual((row["ppd"], row["raster"], row["measure"]),
                         ("40", "160x160", "FLIP"))
        self.assertEqual(float(row["a_b"]), 0.14)
        self.assertIn(NASTY.replace('"', '""'), text)

    def test_markdown_escapes(self):
        text = markdown.table(Table("t", "T", "C", [Column("h|", left=True)],
                                    [[Cell(NASTY)], [Cell("x|`", code=True)],
                                     [Cell("9", best=True, warn=True)]]))
        lines = text.splitlines()
        self.assertEqual(lines[4:6], ["| h\\| |", "| --- |"])
        self.assertEqual(lines[6].count("|") - lines[6].count("\\|"), 2)
        self.assertEqual(lines[7], "| ``x\\|``` |")
        self.assertEqual(lines[8], "| **9** ⚠ |")

    def test_markdown_has_all_tables_and_no_flip_without_ppd(self):
        text = (self.suite() / "tables.md").read_text()
        self.assertIn("### Skipped and failed", text)
        for part in text.split("### ")[1:]:
            title = part.splitlines()[0]
            if "FLIP" in title:
                self.assertIn("40 PPD on a raster of 160 x 160", part, title)

    def test_latex_escapes(self):
        self.assertEqual(latex.escape("50% a_b & #1 $ {} ~^\\"),
                         r"50\% a\_b \& \#1 \$ \{\} \textasciitilde{}"
                         r"\textasciicircum{}\textbackslash{}")
        self.assertEqual(latex.escape("−0.1 ×"), r"$-$0.1 $\times$")
        self.assertEqual(latex.escape("▄é"), "U+2584é")

    def test_a_long_table_runs_over_pages(self):
        table = Table("t", "T", "C", [Column("h")],
                      [[Cell(str(i))] for i in range(latex.MOST_ROWS + 1)])
        self.assertIn("longtable", latex.table(table))

    def test_latex_compiles(self):
        if not shutil.which("pdflatex"):
            self.skipTest("no pdflatex")
        out = self.suite()
        run = subprocess.run(
            ["pdflatex", "-interaction=nonstopmode", "-halt-on-error",
             "tables.tex"], cwd=out, capture_output=True, check=False,
            timeout=120)
        log = run.stdout.decode("utf-8", "replace")
        self.assertEqual(run.returncode, 0, log[-3000:])
        self.assertNotIn("Overfull \\hbox", log)
        self.assertGreater((out / "tables.pdf").stat().st_size, 10_000)


if __name__ == "__main__":
    unittest.main()
