#!/usr/bin/python3
"""Checks scenes/scene.schema.json against the scenes of the repository.

Every scene must conform, and the schema must refuse what the format refuses.
Ends with status 77 (skipped, for ctest) where PyYAML or jsonschema is missing.
"""

import copy
import json
import sys
import unittest
from pathlib import Path

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

ROOT = Path(__file__).resolve().parents[2]
EVERY_KEY = ROOT / "tests" / "data" / "scenes" / "every_key.yaml"


def validator():
    schema = json.loads((ROOT / "scenes" / "scene.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def load(path):
    return yaml.safe_load(path.read_text())


class SchemaTest(unittest.TestCase):
    def test_every_scene_conforms(self):
        checked = 0
        for folder in ["scenes", "tests/data/scenes"]:
            for path in sorted((ROOT / folder).glob("*.yaml")):
                with self.subTest(scene=path.name):
                    errors = list(validator().iter_errors(load(path)))
                    self.assertEqual([e.message for e in errors], [])
                checked += 1
        self.assertGreaterEqual(checked, 3)

    def test_every_unknown_key_is_refused(self):
        """A key `bogus` in any map of the rich scene makes it invalid."""
        scene = load(EVERY_KEY)
        places = list(self.maps(scene, []))
        self.assertGreater(len(places), 30)
        for place in places:
            damaged = copy.deepcopy(scene)
            target = damaged
            for step in place:
                target = target[step]
            target["bogus"] = 1
            with self.subTest(place=place):
                self.assertFalse(validator().is_valid(damaged))

    def test_what_the_format_refuses(self):
        sphere = {"type": "sphere", "center": [0, 0, 0], "radius": 1}
        for key, value in [
            ("objects", [dict(sphere, radius=0)]),
            ("objects", [dict(sphere, type="ball")]),
            ("objects", [dict(sphere, scale=[1, 0, 1])]),
            ("settings", {"max_depth": 65}),
            ("background", {"type": "constant"}),
            ("materials", [{"id": "a b", "type": "mirror"}]),
            ("materials", [{"id": "a", "type": "lambertian"}]),
            ("paths", [{"id": "p", "points": [[0, 0, 0]]}]),
            ("name", "a/b"),
        ]:
            scene = dict(load(EVERY_KEY), **{key: value})
            with self.subTest(key=key, value=value):
                self.assertFalse(validator().is_valid(scene))

    @classmethod
    def maps(cls, node, place):
        """The places of all maps in a tree."""
        if isinstance(node, dict):
            yield place
            for key, value in node.items():
                yield from cls.maps(value, place + [key])
        elif isinstance(node, list):
            for index, value in enumerate(node):
                yield from cls.maps(value, place + [index])


if __name__ == "__main__":
    unittest.main()
