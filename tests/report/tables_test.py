#!/usr/bin/python3
"""The report's tables: figures that the records imply, marks and words."""

import unittest

from report_case import ReportTest, need
from synthetic import Suite

need()

from report import records, tables
from report.table import significant
from report.tables.temporal import split_spec


class TablesTest(ReportTest):

    def setUp(self):
        super().setUp()
        self.suite = Suite(self.folder)

    def tables(self):
        return {t.name: t for t in tables.build(records.load(self.folder))}

    def rows(self, name):
        return [[cell.text for cell in row]
                for row in self.tables()[name].rows]

    def three_encoders(self):
        """On scenes a to d; differences to half -0.02, -0.02, -0.02, 0.001.

        `weak` is 0.1 worse than half everywhere.
        """
        for index, scene in enumerate("abcd"):
            flip = 0.1 + 0.1 * index
            self.suite.quality(scene, "half", flip, rays=2)
            self.suite.quality(scene, "tiv",
                               flip + (0.001 if scene == "d" else -0.02),
                               rays=32)
            self.suite.quality(scene, "weak", flip + 0.1, rays=4)

    def test_flip_by_scene(self):
        self.three_encoders()
        table = self.tables()["flip-by-scene"]
        # Cheap encoders first.
        self.assertEqual([row[0].text for row in table.rows],
                         ["half", "weak", "tiv"])
        self.assertEqual([c.text for c in table.rows[0][1:]],
                         ["0.1000", "0.2000", "0.3000", "0.4000", "0.2500"])
        self.assertEqual([c.best for c in table.rows[2][1:5]],
                         [True, True, True, False])
        self.assertTrue(table.rows[0][4].best)

    def test_flip_summary(self):
        self.three_encoders()
        rows = {row[0]: row for row in self.rows("flip-summary")}
        self.assertEqual(list(rows), ["tiv", "half", "weak"])
        # Mean of -0.02 three times and 0.001: -0.01475. p: the signs of the
        # three large ones must agree and the small one is free: of 16 sign
        # vectors +++-, ---+ (|sum| 0.061) beat ++++ (0.059) and its mirror:
        # 4 / 16. Pairs: weak-half (2 / 16), tiv-half (4 / 16), weak-tiv
        # (2 / 16); Holm: 3 * 0.125, 2 * 0.125 -> 0.375, then 0.375.
        self.assertTrue(rows["tiv"][4].startswith("−0.0147 [")
                        or rows["tiv"][4].startswith("−0.0148 ["))
        self.assertEqual(rows["tiv"][5:7], ["0.375", "3 / 1 / 0"])
        self.assertEqual(rows["weak"][4:7],
                         ["0.1000 [0.1000, 0.1000]", "0.375", "0 / 0 / 4"])
        self.assertEqual(rows["half"][4:7], ["–"] * 3)
        # half against tiv is the same pair, turned round.
        self.assertEqual(rows["half"][8:10], ["0.375", "0 / 1 / 3"])
        # Ranks of half: 2, 2, 2, 1.
        self.assertEqual(rows["half"][3], "1.75")
        table = self.tables()["flip-summary"]
        self.assertIn("the 3 pairs", table.caption)
        self.assertIn("Friedman test over 3 encoders", table.notes[0])

    def test_a_missing_scene_has_no_mean(self):
        self.three_encoders()
        self.suite.quality("a", "rare", 0.01, rays=99)
        row = self.rows("flip-by-scene")[-1]
        self.assertEqual(row, ["rare", "0.0100", "–", "–", "–", "–"])
        rows = {row[0]: row for row in self.rows("flip-summary")}
        self.assertEqual(rows["rare"][1], "1")

    def test_ratios_are_geometric(self):
        for scene, mse in [("a", 0.01), ("b", 0.04)]:
            self.suite.quality(scene, "half", 0.1, mse=0.01)
            self.suite.quality(scene, "best", 0.1, mse=mse, rays=9)
        # Ratios 1 and 4: geometric mean 2.
        row = [r for r in self.rows("ratios") if r[:2] == ["MSE", "best"]][0]
        self.assertEqual(row[3:6], ["2.00 [–]", "1.000", "0 / 1 / 1"])

    def test_agreement_between_measures(self):
        # MSE ranks the encoders as FLIP does on a, the other way on b.
        for scene, sign in (("a", 1), ("b", -1)):
            for index in range(4):
                self.suite.quality(scene, f"e{index}", 0.1 + 0.1 * index,
                                   mse=0.1 + sign * 0.01 * index, rays=index)
        by_scene = {row[0]: row for row in self.rows("agreement-by-scene")}
        heads = [c.heading
                 for c in self.tables()["agreement-by-scene"].columns]
        column = heads.index("mse")
        self.assertEqual(by_scene["a"][column], "1.00")
        self.assertEqual(by_scene["b"][column], "−1.00")
        # SSIM is 1 - FLIP here: full agreement although higher is better.
        self.assertEqual(by_scene["b"][heads.index("ssim")], "1.00")
        rows = {row[0]: row for row in self.rows("agreement")}
        self.assertEqual(rows["flip"][1:3], ["1.00", "0.00"])
        # ms_ssim is null for this size.
        self.assertNotIn("ms_ssim", rows)

    def test_times_and_their_warnings(self):
        self.suite.quality("a", "half", 0.1)
        self.suite.quality("a", "tiv", 0.1)
        self.suite.timing("a", {
            "half": {"load": [9.0] * 3, "plan": [1.0] * 3,
                     "render": [2.0] * 3, "encode": [3.0] * 3},
            "tiv": {"render": [2.0, 4.0, 9.0], "encode": [1.0, 1.0, 1.0]}})
        rows = {row[1]: row for row in self.rows("times")}
        self.assertEqual(rows["half"][2:7],
                         ["3", "6.00 [6.00, 6.00]", "6.00", "0.0 %", "6.00"])
        self.assertEqual(rows["half"][7:], ["9.00", "1.00", "2.00", "3.00"])
        # 3, 5, 10: mean 6, deviation sqrt(26 / 2) = 3.606: 60.1 %.
        self.assertEqual(rows["tiv"][5], "60.1 %")
        table = self.tables()["times"]
        self.assertEqual([row[5].warn for row in table.rows], [False, True])

    def test_rays_a_second(self):
        counts = {"camera": 1000, "reflection": 200, "refraction": 0,
                  "scattered": 0, "shadow": 800}
        self.suite.quality("a", "half", 0.1, rays_=None)
        self.suite.timing("a", {"half": {"render": [2.0], "encode": [1.0]}})
        run = self.suite.run("a", "half")
        run["rays"] = counts
        run["ms"] = {"render": Suite.times([2.0]),
                     "encode": Suite.times([1.0])}
        self.suite.count = 1
        self.suite.record("timing", "a", ["half"], [run])
        # 2000 rays in 2 ms are a million a second.
        self.assertEqual(self.rows("rays")[0][2:], [
            "1000", "200", "0", "0", "800", "2000", "1.00"])

    def test_a_run_below_the_bound_is_marked(self):
        bound = {"glyphs": "half", "mse": 0.01, "gap": 1.25}
        self.suite.quality("a", "half", 0.1, mse=0.0125, bound=bound)
        self.suite.quality("a", "odd", 0.1, mse=0.005,
                           bound={**bound, "gap": 0.5})
        self.suite.quality("a", "free", 0.1, bound=None)
        table = self.tables()["optimality-gap"]
        self.assertEqual([[c.text for c in row] for row in table.rows],
                         [["half", "1.25", "1.25"], ["odd", "0.50", "0.50"]])
        self.assertEqual([row[1].warn for row in table.rows], [False, True])
        self.assertIn("measuring error", table.notes[0])

    def decomposed(self, total):
        return {"mse": {"render": 0.001, "sampling": 0.002,
                        "encoding": 0.006, "render_sampling": 0.0005,
                        "render_encoding": -0.001,
                        "sampling_encoding": 0.0015, "total": total,
                        "font": None},
                "flip": {"reference_converged": 0.01,
                         "converged_fragments": 0.02,
                         "fragments_grid": 0.03, "reference_grid": 0.05,
                         "oracle": 0.04},
                "inner": {"capacity": 0.004, "masks": 0.001,
                          "colors": 0.001}}

    def test_decomposition(self):
        self.suite.quality("a", "half", 0.1, mse=0.01,
                           decomposition=self.decomposed(0.01))
        self.assertEqual(self.rows("decomposition")[0][2:], [
            "10.0", "20.0", "60.0", "5.00", "−10.0", "15.0", "100", "–"])
        self.assertEqual(self.rows("decomposition-shares")[0][1:], [
            "10.0", "20.0", "60.0", "5.0", "−10.0", "15.0"])
        self.assertEqual(self.tables()["decomposition"].notes, [])
        self.assertEqual(self.rows("inside-the-encoder")[0][2:],
                         ["40.0", "10.0", "10.0"])
        self.assertEqual(self.rows("flip-distances")[0][2:], [
            "0.0100", "0.0200", "0.0300", "0.0500", "0.0400"])

    def test_terms_that_do_not_add_up_are_told(self):
        self.suite.quality("a", "half", 0.1, mse=0.01,
                           decomposition=self.decomposed(0.011))
        self.assertIn("do not add up",
                      self.tables()["decomposition"].notes[0])

    def test_specs_without_temporal(self):
        for spec, expected in [
                ("half", ("half", None)),
                ("half:temporal=3", ("half", "3")),
                ("half:temporal=0", ("half", None)),
                ("tiv:temporal=2:color=median", ("tiv:color=median", "2")),
                ("octant:atlas='a:temporal=1'", ("octant:atlas='a:temporal=1'",
                                                 None)),
                ("external:p -a:temporal=1", ("external:p -a:temporal=1",
                                              None))]:
            self.assertEqual(split_spec(spec), expected)

    def test_temporal_pairs(self):
        self.suite.temporal("moving", "half", churn=0.5, tde=0.04)
        self.suite.temporal("moving", "half:temporal=3", churn=0.1, tde=0.02)
        self.suite.temporal("moving", "tiv")
        rows = self.rows("temporal-effect")
        self.assertEqual(len(rows), 1)
        self.assertEqual(rows[0][:4], ["moving", "half", "3", "0.500"])
        self.assertEqual(rows[0][6], "0.200")
        self.assertEqual([row[3] for row in self.rows("temporal")],
                         ["off", "3", "off"])

    def test_live(self):
        self.suite.live("a", "half", 50)
        self.assertEqual(self.rows("live")[0][3:8],
                         ["direct", "50.0", "20.0", "40.0", "60.0"])

    def test_programs_failures_and_references(self):
        spec = "external:/opt/bin/chafa -w 9 {input}"
        self.suite.quality("a", spec, 0.1, encoder_version="1.12.4")
        self.suite.quality("a", "external:chafa {input}", 0.2)
        self.suite.failed("a", "external:tiv", "found no 'tiv'", "skipped")
        table = self.tables()["programs"]
        self.assertEqual([[c.text for c in row] for row in table.rows], [
            [spec, "1.12.4", "1"], ["external:chafa {input}", "unknown", "1"]])
        # In other tables the program alone; equal ones are numbered.
        flips = self.tables()["flip-by-scene"]
        self.assertEqual([row[0].text for row in flips.rows],
                         ["external:chafa", "external:chafa (2)"])
        self.assertEqual(flips.rows[0][0].raw, spec)
        row = self.rows("failures")[0]
        self.assertEqual(row[:4], ["skipped", "quality", "a", "external:tiv"])
        self.assertEqual(row[5:], ["encoder: found no 'tiv'", "install it"])
        self.assertEqual(self.rows("references")[0][:3], ["a", "0", "povray"])

    def test_significant_figures(self):
        for value, text in [(0, "0"), (1234, "1230"), (99.96, "100"),
                            (12.34, "12.3"), (-0.00123456, "−0.00123"),
                            (None, "–"), (float("nan"), "–")]:
            self.assertEqual(significant(value), text)


if __name__ == "__main__":
    unittest.main()
