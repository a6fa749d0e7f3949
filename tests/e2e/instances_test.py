#!/usr/bin/python3
"""Many instances of a large mesh cost little memory: 10,000 uses of 10,000
triangles are 100 million triangles, which would not fit if copied."""

import math
import subprocess
import sys
import unittest

from pictures import read_ppm
from program import ProgramTest

COLUMNS, ROWS = 100, 50  # of the mesh: 2 triangles for each
SIDE = 100  # instances in a row of a square
LIMIT = 1 << 30  # bytes of resident memory

# Runs a command and prints the most memory that it held resident, in bytes.
WATCH = """
import resource, subprocess, sys
status = subprocess.run(sys.argv[1:]).returncode
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024)
sys.exit(status)
"""


def torus():
    """The OBJ text of a torus of 2 * COLUMNS * ROWS triangles."""
    lines = []
    for i in range(COLUMNS):
        for j in range(ROWS):
            a, b = 2 * math.pi * i / COLUMNS, 2 * math.pi * j / ROWS
            r = 0.3 + 0.12 * math.cos(b)
            lines.append(f"v {r * math.cos(a):.6f} {0.12 * math.sin(b):.6f} "
                         f"{r * math.sin(a):.6f}")
    for i in range(COLUMNS):
        for j in range(ROWS):
            k, m = (i + 1) % COLUMNS, (j + 1) % ROWS
            a, b = i * ROWS + j + 1, i * ROWS + m + 1
            c, d = k * ROWS + m + 1, k * ROWS + j + 1
            lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    return "\n".join(lines) + "\n"


def scene():
    """SIDE * SIDE rings on a floor, seen from above."""
    lines = [
        "rtbench_scene: 1",
        "name: rings",
        "camera: {position: [50, 120, 50], direction: [0, -1, 0],"
        " up: [0, 0, -1], vfov: 45}",
        "materials:",
        "  - {id: gold, type: lambertian, albedo: [0.9, 0.6, 0.1]}",
        "lights:",
        "  - {type: directional, direction: [0, -1, 0],"
        " irradiance: [3, 3, 3]}",
        "objects:",
        "  - {id: ring, type: mesh, file: ring.obj, material: gold,"
        " position: [0.5, 0, 0.5]}",
    ]
    for i in range(1, SIDE * SIDE):
        lines.append(f"  - {{type: instance, of: ring, position: "
                     f"[{i % SIDE + 0.5}, 0, {i // SIDE + 0.5}], "
                     f"rotate: [0, {i % 7 * 10}, 0]}}")
    return "\n".join(lines) + "\n"


class InstancesTest(ProgramTest):

    def test_a_hundred_million_triangles_fit_into_a_gibibyte(self):
        self.write("ring.obj", torus())
        self.write("rings.yaml", scene())
        process = subprocess.run(
            [sys.executable, "-c", WATCH, self.program, "render",
             "--scene=rings.yaml", "--size=400x400", "--quiet",
             "--output=a.ppm"],
            cwd=self.folder, stdout=subprocess.PIPE, timeout=300, check=True)
        self.assertLess(int(process.stdout), LIMIT)
        # pi ((0.42)^2 - (0.18)^2) = 0.452 of each square is ring; the picture
        # is 2 * 120 * tan(22.5 degrees) = 99.4 wide, so rings all over.
        picture = read_ppm((self.folder / "a.ppm").read_bytes())[2]
        share = sum(max(pixel) > 0 for pixel in picture) / len(picture)
        self.assertAlmostEqual(share, 0.452, delta=0.02)


if __name__ == "__main__":
    unittest.main()
