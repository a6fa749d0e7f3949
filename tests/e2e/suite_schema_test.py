#!/usr/bin/python3
"""Checks suite.schema.json against what the program reads, and the records of
a sweep against record.schema.json.

Ends with status 77 (skipped, for ctest) where PyYAML or jsonschema is missing.
"""

import copy
import json
import sys
import unittest

from program import ROOT
from sweeps import SweepTest, records

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

# Every key of the format.
EVERY_KEY = {
    "rtbench_suite": 1, "name": "every-key", "description": "all", "repeat": 2,
    "kinds": ["quality", "timing"], "scenes": ["left.yaml"], "times": [0, 1.5],
    "encoders": ["half"], "grids": ["20x10"], "spp": [1, 2],
    "backends": ["embree"], "integrators": ["whitted", "path"],
    "colors": ["truecolor", 256, 16, "mono"],
    "references": ["auto", "self", "povray", "cycles", "reference.png"],
    "seeds": [0, 2**64 - 1], "pictures": False,
    "exclude": [{"kind": "timing", "scene": ["left.yaml"], "time": [0, 1],
                 "encoder": "half", "grid": "20x10", "spp": 2,
                 "backend": "embree", "integrator": "path", "color": 256,
                 "reference": "auto"}],
    "matrix": [{}, {"kinds": ["quality"], "scenes": ["right.yaml"],
                    "times": [1], "encoders": ["quadrant"], "grids": ["4x2"],
                    "spp": [1], "backends": ["embree"],
                    "integrators": ["whitted"], "colors": ["mono"],
                    "references": ["self"], "seeds": [1], "pictures": True,
                    "exclude": []}],
    "temporal": {"scenes": ["left.yaml"], "encoders": ["half"],
                 "grid": "20x10", "frames": 24, "fps": 12.5},
    "live": {"scenes": ["left.yaml"], "encoders": ["half"], "grid": "20x10",
             "frames": 5},
}

# (key, value) that neither may take.
REFUSED = [
    ("rtbench_suite", 2), ("name", "a/b"), ("repeat", 0), ("repeat", "2"),
    ("kinds", []), ("kinds", ["live"]), ("scenes", []), ("scenes", "left.yaml"),
    ("times", [-1]), ("times", ["0"]), ("encoders", [""]), ("grids", ["20"]),
    ("grids", ["0x4"]), ("spp", [0]), ("spp", [65537]), ("spp", [1.5]),
    ("integrators", ["light"]), ("colors", [8]), ("seeds", [-1]),
    ("pictures", "yes"), ("exclude", [{}]), ("exclude", [{"time": "now"}]),
    ("exclude", [{"scene": []}]), ("matrix", []), ("matrix", [[]]),
    ("temporal", {"scenes": ["left.yaml"]}),
    ("temporal", {"scenes": ["left.yaml"], "encoders": ["half"], "frames": 23}),
    ("live", {"scenes": ["left.yaml"], "encoders": ["half"], "fps": 60}),
]


def schema(path):
    loaded = json.loads((ROOT / path).read_text())
    jsonschema.Draft202012Validator.check_schema(loaded)
    return jsonschema.Draft202012Validator(loaded)


class SuiteSchemaTest(SweepTest):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.validator = schema("results/suites/suite.schema.json")

    def program_reads(self, suite):
        self.write("tried.yaml", yaml.safe_dump(suite, sort_keys=False))
        process = self.run_program("sweep", "tried.yaml", "--out=none",
                                   "--dry-run")
        self.assertIn(process.returncode, (0, 2), process.stderr)
        return process.returncode == 0

    def test_both_take_every_key(self):
        self.assertEqual([error.message for error
                          in self.validator.iter_errors(EVERY_KEY)], [])
        self.assertTrue(self.program_reads(EVERY_KEY))
        self.assertEqual(set(EVERY_KEY),
                         set(self.validator.schema["properties"]))

    def test_both_refuse_an_unknown_key_anywhere(self):
        places = [[], ["exclude", 0], ["matrix", 1], ["temporal"], ["live"]]
        for place in places:
            damaged = copy.deepcopy(EVERY_KEY)
            target = damaged
            for step in place:
                target = target[step]
            target["bogus"] = 1
            with self.subTest(place=place):
                self.assertFalse(self.validator.is_valid(damaged))
                self.assertFalse(self.program_reads(damaged))

    def test_both_refuse_the_same(self):
        for key, value in REFUSED:
            suite = dict(EVERY_KEY, **{key: value})
            with self.subTest(key=key, value=value):
                self.assertFalse(self.validator.is_valid(suite))
                self.assertFalse(self.program_reads(suite))

    def test_the_suites_of_the_repository_conform(self):
        paths = sorted((ROOT / "results" / "suites").glob("*.yaml"))
        self.assertGreaterEqual(len(paths), 2)
        for path in paths:
            errors = self.validator.iter_errors(yaml.safe_load(
                path.read_text()))
            self.assertEqual([error.message for error in errors], [], path)

    def test_records_conform(self):
        self.sweep("out")
        validator = schema("results/record.schema.json")
        for unit in records(self.folder / "out"):
            errors = [error.message for error in validator.iter_errors(unit)]
            self.assertEqual(errors, [], unit["unit"])


if __name__ == "__main__":
    unittest.main()
