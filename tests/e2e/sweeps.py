"""Suites for tests, and what a sweep's folder holds."""

import json
import os
import re

from program import ProgramTest

SCENE = """\
rtbench_scene: 1
name: {name}
camera: {{position: [0, 0, 5], look_at: [0, 0, 0], vfov: 40}}
background: {{type: gradient, bottom: [0.1, 0.2, 0.3], top: [0.7, 0.6, 0.9]}}
materials:
  - {{id: ball, type: lambertian, albedo: [0.8, 0.3, 0.2]}}
lights:
  - {{type: point, position: [3, 4, 5], intensity: [40, 40, 40]}}
objects:
  - {{type: sphere, material: ball, center: [{x}, 0, 0], radius: 1}}
"""

SUITE = """\
rtbench_suite: 1
name: small
repeat: 2
scenes: [left.yaml, right.yaml]
encoders: [half, quadrant, search, 'external:no-such-program {input}']
grids: [20x10]
seeds: [1, 2]
references: [reference.png]
"""

# 2 scenes x (half, quadrant, search twice, one that is missing), 2 blocks.
UNITS = 12


def stable_text(text):
    """A record's text without what may differ between two runs."""
    return re.sub(r'(?m)^( *)"(?:ms|volatile)": \{\n(?:.*\n)*?\1\},?\n', "",
                  text)


def contents(folder):
    """{name: stable content} of a sweep's folder."""
    found = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.name != ".lock":
            data = path.read_bytes()
            if path.suffix == ".json":
                data = stable_text(data.decode())
            found[path.relative_to(folder).as_posix()] = data
    return found


def records(folder):
    """All units' records."""
    return [json.loads(path.read_text())
            for path in sorted((folder / "units").glob("*.json"))]


class SweepTest(ProgramTest):
    """A working folder with a suite of two scenes and their reference."""

    def setUp(self):
        super().setUp()
        self.write("left.yaml", SCENE.format(name="left", x=-1))
        self.write("right.yaml", SCENE.format(name="right", x=1))
        self.suite = self.write("small.yaml", SUITE)
        self.succeed("render", "--scene=left.yaml", "--size=160x160",
                     "--output=reference.png")

    def environment(self):
        """Ours, with a cache that goes with the test."""
        return dict(os.environ, RTBENCH_CACHE=str(self.folder / "cache"))

    def run_program(self, *args, env=None, **more):
        # Nothing of an earlier test's, nothing left in the user's cache.
        return super().run_program(
            *args, env={"RTBENCH_CACHE": str(self.folder / "cache"),
                        **(env or {})}, **more)

    def sweep(self, folder, *args):
        """Its standard output; it must succeed."""
        return self.succeed("sweep", self.suite, f"--out={folder}",
                            *args).decode()
