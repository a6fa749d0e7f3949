#!/usr/bin/python3
"""Writes the meshes of the small scenes, as Wavefront OBJ.

    scripts/make_meshes.py [--out=FOLDER]

The folder is scenes/meshes unless given. Every run writes the same bytes.
"""

import argparse
import math
from pathlib import Path

from picture import noise_at

ROOT = Path(__file__).resolve().parent.parent


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return [x / length for x in a]


def vertex_normals(points, triangles):
    """At each vertex the unit mean of its triangles' normals, by area."""
    sums = [[0.0, 0.0, 0.0] for _ in points]
    for triangle in triangles:
        a, b, c = (points[i] for i in triangle)
        normal = cross(subtract(b, a), subtract(c, a))
        for i in triangle:
            sums[i] = [x + y for x, y in zip(sums[i], normal)]
    return [unit(total) for total in sums]


def obj(title, points, triangles, maker="make_meshes.py"):
    """The text of an OBJ file with one smooth normal at each vertex."""
    lines = [f"# {title}. Made by scripts/{maker}."]
    lines += ["v " + " ".join(f"{x:.5f}" for x in p) for p in points]
    lines += ["vn " + " ".join(f"{x:.5f}" for x in n)
              for n in vertex_normals(points, triangles)]
    lines += ["f " + " ".join(f"{i + 1}//{i + 1}" for i in t)
              for t in triangles]
    return "\n".join(lines).replace("-0.00000", "0.00000") + "\n"


def tube(curve, rings, sides, radius):
    """A closed tube around curve(t), t in 0..1: points and triangles."""
    points, triangles = [], []
    for i in range(rings):
        t = i / rings
        center, ahead = curve(t), curve(t + 1e-4)
        tangent = unit(subtract(ahead, center))
        side = unit(cross(tangent, unit([sum(p) for p in zip(center, ahead)])))
        up = cross(side, tangent)
        for j in range(sides):
            angle = 2 * math.pi * j / sides
            points.append([c + radius * (math.cos(angle) * s
                                         + math.sin(angle) * u)
                           for c, s, u in zip(center, side, up)])
    for i in range(rings):
        for j in range(sides):
            a, b = i * sides + j, i * sides + (j + 1) % sides
            c, d = ((k + sides) % (rings * sides) for k in (b, a))
            triangles += [[a, c, b], [a, d, c]]
    return points, triangles


def knot(t):
    """The (2, 3) torus knot, around the z axis."""
    angle = 2 * math.pi * t
    distance = 1 + 0.45 * math.cos(3 * angle)
    return [distance * math.cos(2 * angle), distance * math.sin(2 * angle),
            0.45 * math.sin(3 * angle)]


def ring(t):
    angle = 2 * math.pi * t
    return [math.cos(angle), math.sin(angle), 0.0]


def star():
    """A cage: a cube each of whose faces is drawn out into a spike."""
    points = [[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    triangles = []
    for axis in range(3):
        for sign in (-1, 1):
            tip = [0.0, 0.0, 0.0]
            tip[axis] = sign * 4.0
            corners = [i for i, p in enumerate(points[:8]) if p[axis] == sign]
            corners = [corners[i] for i in (0, 1, 3, 2)]
            points.append(tip)
            for a, b in zip(corners, corners[1:] + corners[:1]):
                triangle = [a, b, len(points) - 1]
                p, q, r = (points[i] for i in triangle)
                normal = cross(subtract(q, p), subtract(r, p))
                outward = normal[axis] * sign > 0
                triangles.append(triangle if outward else [b, a, triangle[2]])
    return points, triangles


def leaf(place, heading, tilt, length):
    """A kite of four points that hangs from `place`, and its triangles."""
    along = [math.cos(heading) * math.cos(tilt), math.sin(tilt),
             math.sin(heading) * math.cos(tilt)]
    across = [-math.sin(heading), 0.0, math.cos(heading)]
    corners = [(0, 0), (0.45, 0.22), (1, 0), (0.45, -0.22)]
    points = [[p + length * (u * a + v * b)
               for p, a, b in zip(place, along, across)] for u, v in corners]
    return points, [[0, 1, 2], [0, 2, 3]]


def bush(leaves=1200):
    """Leaves scattered through a ball of radius 1, most of them near its
    surface."""
    points, triangles = [], []
    for i in range(leaves):
        a, b, c, d, e = (noise_at(i, k, 7) for k in range(5))
        distance, height = a ** 0.2, 2 * b - 1
        angle, level = 2 * math.pi * c, math.sqrt(1 - height * height)
        place = [distance * level * math.cos(angle), distance * height,
                 distance * level * math.sin(angle)]
        corners, faces = leaf(place, 2 * math.pi * d, 1.6 * e - 1.1,
                              0.12 + 0.1 * noise_at(i, 5, 7))
        triangles += [[len(points) + k for k in face] for face in faces]
        points += corners
    return points, triangles


MESHES = {
    "bush.obj": ("A ball of leaves", bush),
    "knot.obj": ("A torus knot", lambda: tube(knot, 180, 16, 0.22)),
    "ring.obj": ("A torus of radii 1 and 0.3", lambda: tube(ring, 72, 24, 0.3)),
    "star.obj": ("A cube with a spike on each face, a cage to subdivide",
                 star),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=Path, default=ROOT / "scenes" / "meshes")
    folder = parser.parse_args().out
    folder.mkdir(parents=True, exist_ok=True)
    for name, (title, make) in MESHES.items():
        (folder / name).write_text(obj(title, *make()), encoding="utf-8")


if __name__ == "__main__":
    main()
