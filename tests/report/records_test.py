#!/usr/bin/python3
"""Reading units: what meets what, what is averaged, what is warned of."""

import json
import unittest

from report_case import ROOT, ReportTest, need
from synthetic import Suite

need()

from report import matrix, provenance, records, study
from report.errors import BadInput


class RecordsTest(ReportTest):

    def load(self):
        return records.load(self.folder)

    def test_synthetic_units_are_records(self):
        """What these tests read is what the schema allows."""
        try:
            import jsonschema
        except ImportError:
            self.skipTest("no jsonschema")
        suite = Suite(self.folder)
        suite.quality("a", "half", 0.1)
        suite.timing("a", {"half": {"render": [1.0, 2.0]}})
        suite.temporal("a", "half")
        suite.live("a", "half", 60)
        suite.failed("a", "chafa", "no library", "skipped")
        schema = json.loads(
            (ROOT / "results" / "record.schema.json").read_text())
        validator = jsonschema.Draft202012Validator(schema)
        for file in sorted((self.folder / "units").iterdir()):
            errors = validator.iter_errors(json.loads(file.read_text()))
            self.assertEqual([e.message for e in errors], [], file.name)

    def test_seeds_then_times_are_averaged(self):
        suite = Suite(self.folder)
        # Time 0: (1 + 3) / 2 = 2; time 1: 6; the scene: (2 + 6) / 2 = 4.
        for time, seed, flip in [(0, 1, 0.1), (0, 2, 0.3), (1, 1, 0.6)]:
            suite.quality("a", "search", flip,
                          settings={"time": float(time), "seed": seed})
        found = study.studies(self.load())[0].flip
        self.assert_close(found.get("search", "a"), 0.4)

    def test_times_that_one_encoder_lacks_do_not_count(self):
        suite = Suite(self.folder)
        for encoder, times in [("half", (0, 1)), ("tiv", (0,))]:
            for time in times:
                suite.quality("a", encoder, 0.1 + 0.2 * time,
                              settings={"time": float(time)})
        found = study.studies(self.load())[0].flip
        self.assert_close(found.get("half", "a"), 0.1)
        self.assert_close(found.get("tiv", "a"), 0.1)

    def test_without_a_shared_time_the_commonest_counts(self):
        self.assertEqual(matrix.shared_times(
            {"a": {0, 1}, "b": {1}, "c": {2}}), {1})

    def test_quality_and_timing_meet(self):
        suite = Suite(self.folder)
        suite.quality("a", "half", 0.1)
        # Frames: 1 + 2 + 3 = 6, 2 + 2 + 4 = 8, 1 + 5 + 3 = 9; median 8,
        # where the medians of the stages would add up to 6.
        suite.timing("a", {"half": {"plan": [1.0, 2.0, 1.0],
                                    "render": [2.0, 2.0, 5.0],
                                    "encode": [3.0, 4.0, 3.0]}})
        one = study.studies(self.load())[0]
        self.assertEqual(one.ms.get("half", "a"), 8)

    def test_the_default_reference_is_one_view(self):
        suite = Suite(self.folder)
        suite.quality("a", "half", 0.1)
        suite.quality("b", "half", 0.1, settings={"reference": "self"})
        suite.quality("b", "half", 0.1, settings={"spp": 4})
        views = self.load().views()
        self.assertEqual([view.setting.spp for view in views], [1, 4])
        caption = study.studies(self.load())[0].caption("Lead.", 2)
        self.assertIn("povray (1 scene), self (1 scene)", caption)

    def test_captions_say_what_was_measured(self):
        suite = Suite(self.folder)
        suite.quality("a", "half", 0.1)
        caption = study.studies(self.load())[0].caption("Lead.", 1)
        for words in ("Lead.", "n = 1 scene;", "20 x 10 cells", "40 PPD",
                      "160 x 160", "Test CPU, 2 threads", "0123456789",
                      "1 ray a sample"):
            self.assertIn(words, caption)

    def test_captions_of_times_name_their_commit_too(self):
        Suite(self.folder).quality("a", "half", 0.1)
        Suite(self.folder, commit="f" * 40, count=10).timing(
            "a", {"half": {"render": [1.0, 1.0]}})
        one = study.studies(self.load())[0]
        self.assertNotIn("ffffffffff", one.caption("Lead.", 1))
        self.assertIn("ffffffffff", one.caption("Lead.", 1, with_times=True))

    def test_mixed_origins_are_warned_of(self):
        Suite(self.folder).quality("a", "half", 0.1)
        self.assertEqual(provenance.warnings(self.load()), [])
        other = Suite(self.folder, commit="f" * 40, dirty=True, host="Other",
                      count=10)
        other.timing("a", {"half": {"render": [1.0, 9.0]}})
        text = "\n".join(provenance.warnings(self.load()))
        for words in ("2 commits", "uncommitted", "several machines",
                      "1 of the timed stages"):
            self.assertIn(words, text)

    def test_times_of_two_machines_are_warned_of(self):
        for index, host in enumerate(("One", "Two")):
            Suite(self.folder, host=host, count=10 * index).timing(
                "a", {"half": {"render": [1.0, 1.0]}})
        text = "\n".join(provenance.warnings(self.load()))
        self.assertIn("times come from 2 machines", text)

    def test_bad_folders(self):
        with self.assertRaisesRegex(BadInput, "no such folder"):
            records.load(self.folder / "none")
        with self.assertRaisesRegex(BadInput, "no records"):
            self.load()
        (self.folder / "broken.json").write_text("{")
        with self.assertRaisesRegex(BadInput, "broken.json: not a record"):
            self.load()
        (self.folder / "broken.json").write_text(
            '{"schema": 2, "manifest": {}}')
        with self.assertRaisesRegex(BadInput, "found 2"):
            self.load()

    def test_a_run_that_lacks_something(self):
        file = Suite(self.folder).quality("a", "half", 0.1)
        record = json.loads(file.read_text())
        del record["runs"][0]["raster"]
        file.write_text(json.dumps(record))
        with self.assertRaisesRegex(BadInput, "lacks 'raster'"):
            self.load()

    def test_records_of_the_main_job(self):
        """Plain records beside each other, without a sweep's folders."""
        file = Suite(self.folder / "sweep").quality("a", "half", 0.1)
        record = json.loads(file.read_text())
        del record["unit"]
        (self.folder / "record.json").write_text(json.dumps(record))
        (self.folder / "half.json").write_text('{"columns": 1}')
        results = self.load()
        self.assertEqual([run.kind for run in results.runs], ["bench"])
        self.assertEqual(len(results.views()), 1)


if __name__ == "__main__":
    unittest.main()
