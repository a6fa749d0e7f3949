"""The meshes of the scene `explore`, for scripts/make_explore.py. Meters, y up,
standing on y = 0; what moves faces +x.
"""

import math
import random

from make_meshes import cross, obj, subtract, tube, unit

MAKER = "make_explore.py"


def flat_obj(title, points, faces):
    """The text of an OBJ file without normals."""
    lines = [f"# {title}. Made by scripts/{MAKER}."]
    lines += ["v " + " ".join(f"{x:.3f}" for x in p) for p in points]
    lines += ["f " + " ".join(str(i + 1) for i in f) for f in faces]
    return "\n".join(lines).replace("-0.000", "0.000") + "\n"


def join(*parts):
    """Several (points, faces) as one."""
    points, faces = [], []
    for part_points, part_faces in parts:
        first = len(points)
        points += part_points
        faces += [[first + i for i in f] for f in part_faces]
    return points, faces


def move(part, offset):
    points, faces = part
    return [[x + d for x, d in zip(p, offset)] for p in points], faces


def skin(rings):
    """Closes a row of rings of equal size to a tube with both ends capped."""
    sides = len(rings[0])
    points = [p for ring in rings for p in ring]
    faces = []
    for i in range(len(rings) - 1):
        for j in range(sides):
            a, b = i * sides + j, i * sides + (j + 1) % sides
            faces += [[a, b, b + sides], [a, b + sides, a + sides]]
    for ring, turn in ((0, 1), (len(rings) - 1, 0)):
        points.append([sum(x) / sides for x in zip(*rings[ring])])
        for j in range(sides):
            a, b = ring * sides + j, ring * sides + (j + 1) % sides
            faces.append([b, a, len(points) - 1] if turn
                         else [a, b, len(points) - 1])
    return points, faces


def revolve(profile, sides):
    """A solid of revolution about y from (radius, y), from the bottom."""
    return skin([[[r * math.cos(-2 * math.pi * j / sides), y,
                   r * math.sin(-2 * math.pi * j / sides)]
                  for j in range(sides)] for r, y in profile])


def limb(a, b, thick, thin, sides=8):
    """A tapering rod from a to b."""
    along = unit(subtract(b, a))
    side = unit(cross(along, [0, 0, 1] if abs(along[2]) < 0.9 else [1, 0, 0]))
    up = cross(along, side)

    def ring(center, radius):
        return [[c + radius * (math.cos(2 * math.pi * j / sides) * s
                               + math.sin(2 * math.pi * j / sides) * u)
                 for c, s, u in zip(center, side, up)] for j in range(sides)]

    return skin([ring(a, thick), ring(b, thin)])


def direction(rng):
    """A direction of even spread."""
    y, angle = 2 * rng.random() - 1, 2 * math.pi * rng.random()
    r = math.sqrt(1 - y * y)
    return [r * math.cos(angle), y, r * math.sin(angle)]


def foliage(seed, leaves, radius, height, center):
    """Leaves, four-cornered, on the outside of a dozen and a half clumps."""
    rng = random.Random(seed)
    clumps = []
    for _ in range(18):
        d, r = direction(rng), 0.35 + 0.65 * rng.random()
        clumps.append([d[0] * radius * r, center + d[1] * height * r,
                       d[2] * radius * r])
    points, faces = [], []
    for i in range(leaves):
        d, r = direction(rng), radius * (0.3 + 0.25 * rng.random())
        middle = [c + r * x for c, x in zip(clumps[i % 18], d)]
        across = unit(cross(d, direction(rng)))
        along = unit(cross(across, [x + 0.7 * y for x, y
                                    in zip(d, direction(rng))]))
        size = radius * (0.055 + 0.04 * rng.random())
        first = len(points)
        points += [[m + size * (s * a + t * b)
                    for m, a, b in zip(middle, across, along)]
                   for s, t in ((0, -1.4), (0.7, 0), (0, 1.4), (-0.7, 0))]
        faces.append([first, first + 1, first + 2, first + 3])
    return points, faces


def trunk():
    rng = random.Random(5)
    parts = [limb([0, 0, 0], [0.05, 2.6, 0], 0.2, 0.13, 14)]
    for i in range(9):
        angle = 2.4 * i
        reach = 0.7 + 0.5 * rng.random()
        parts.append(limb([0.04, 1.7 + 0.1 * i, 0],
                          [reach * math.cos(angle), 3.2 + rng.random(),
                           reach * math.sin(angle)], 0.08, 0.03, 10))
    return join(*parts)


def hull(length, width, bottom, top, ends, stations=30, sides=24):
    """A rounded box along x whose roof falls off towards its ends."""
    def power(x, p):
        return math.copysign(abs(x) ** p, x)

    rings = []
    for i in range(stations):
        t = 2 * i / (stations - 1) - 1
        full = max(0.3, (1 - abs(t) ** ends) ** 0.5)
        middle, half = bottom + 0.5 * top * full, 0.5 * top * full
        rings.append([[0.5 * length * t,
                       middle + half * power(math.sin(a), 0.5),
                       0.5 * width * (0.7 + 0.3 * full)
                       * power(math.cos(a), 0.5)]
                      for a in (-2 * math.pi * j / sides
                                for j in range(sides))])
    return skin(rings)


def wheel(radius, thickness, rings=40, sides=8):
    def rim(t):
        angle = 2 * math.pi * t
        return [radius * math.cos(angle), radius * math.sin(angle), 0.0]

    return tube(rim, rings, sides, thickness)


def tire():
    return join(wheel(0.24, 0.09, 40, 12),
                limb([0, 0, -0.06], [0, 0, 0.06], 0.2, 0.2, 24))


def bicycle():
    parts = [move(wheel(0.33, 0.022), [x, 0.35, 0]) for x in (-0.52, 0.52)]
    for x in (-0.52, 0.52):
        parts += [limb([x, 0.35, 0],
                       [x + 0.32 * math.cos(a), 0.35 + 0.32 * math.sin(a), 0],
                       0.006, 0.006, 5)
                  for a in (2 * math.pi * k / 12 for k in range(12))]
    for a, b, r in (([-0.52, 0.35, 0], [-0.05, 0.32, 0], 0.018),
                    ([-0.52, 0.35, 0], [-0.15, 0.8, 0], 0.016),
                    ([-0.05, 0.32, 0], [-0.2, 0.95, 0], 0.02),
                    ([-0.05, 0.32, 0], [0.36, 0.82, 0], 0.022),
                    ([-0.15, 0.8, 0], [0.36, 0.82, 0], 0.02),
                    ([0.52, 0.35, 0], [0.34, 1, 0], 0.02),
                    ([0.3, 1.02, -0.28], [0.3, 1.02, 0.28], 0.018),
                    ([-0.34, 0.96, 0], [-0.06, 0.98, 0], 0.06)):
        parts.append(limb(a, b, r, r, 10))
    return join(*parts)


def legs():
    return join(limb([-0.22, 0, 0.1], [0, 0.9, 0.08], 0.07, 0.1, 12),
                limb([0.22, 0, -0.1], [0, 0.9, -0.08], 0.07, 0.1, 12))


def cobbles():
    """Three by three meters of cut stones, fifteen each way."""
    rng = random.Random(11)
    points, faces = [], []
    for i in range(15):
        for k in range(15):
            x, z, top = 0.2 * i, 0.2 * k, 0.02 * rng.random()
            tilt = [0.012 * (rng.random() - 0.5) for _ in range(4)]
            first = len(points)
            for inset, y in ((0.008, -0.05), (0.035, top)):
                for n, (a, b) in enumerate(((0, 0), (0, 1), (1, 1), (1, 0))):
                    points.append([x + (0.2 - inset if a else inset),
                                   y + (tilt[n] if inset > 0.01 else 0),
                                   z + (0.2 - inset if b else inset)])
            faces.append([first + n for n in (4, 5, 6, 7)])
            faces += [[first + n, first + (n + 1) % 4, first + 4 + (n + 1) % 4,
                       first + 4 + n] for n in range(4)]
    return points, faces


POST = [(0.2, 0), (0.2, 0.1), (0.16, 0.16), (0.14, 0.5), (0.09, 0.6),
        (0.07, 0.9), (0.06, 2), (0.05, 3.3), (0.08, 3.36), (0.05, 3.42),
        (0.05, 3.6), (0.13, 3.7), (0.15, 3.74)]
BALUSTER = [(0.06, 0), (0.06, 0.05), (0.03, 0.1), (0.055, 0.3), (0.05, 0.4),
            (0.025, 0.6), (0.03, 0.7), (0.055, 0.75), (0.055, 0.8)]
COAT = [(0.26, 0.55), (0.25, 0.7), (0.2, 1), (0.22, 1.25), (0.23, 1.4),
        (0.17, 1.5), (0.08, 1.56), (0.07, 1.62)]
PEDESTAL = [(1.7, 0), (1.7, 0.25), (1.3, 0.3), (1.3, 0.55), (0.75, 0.62),
            (0.6, 0.8), (0.6, 1.25), (0.8, 1.38), (0.8, 1.5), (0.3, 1.55)]


def meshes():
    """File name -> text."""
    smooth = {
        "trunk": ("The trunk and branches of a tree", trunk()),
        "car_body": ("The body of a car", hull(4.2, 1.75, 0.28, 0.64, 6)),
        "car_cabin": ("The windows and roof of a car",
                      hull(2.4, 1.5, 0.82, 0.58, 4)),
        "tire": ("A wheel of a car", tire()),
        "bicycle": ("A bicycle", bicycle()),
        "legs": ("Legs of someone who walks", legs()),
        "coat": ("A coat", revolve(COAT, 24)),
        "post": ("The post of a street lamp", revolve(POST, 24)),
        "baluster": ("A baluster of a balcony", revolve(BALUSTER, 10)),
        "pedestal": ("A round pedestal", revolve(PEDESTAL, 48)),
    }
    texts = {f"{name}.obj": obj(title, *part, maker=MAKER)
             for name, (title, part) in smooth.items()}
    texts["crown_a.obj"] = flat_obj("Leaves of a tree",
                                    *foliage(1, 5600, 1.9, 1.5, 4.1))
    texts["crown_b.obj"] = flat_obj("Leaves of a taller tree",
                                    *foliage(2, 5600, 1.7, 2.1, 4.6))
    texts["bush.obj"] = flat_obj("Leaves of a bush",
                                 *foliage(3, 1600, 0.6, 0.45, 0.55))
    texts["cobbles.obj"] = flat_obj("Cobblestones", *cobbles())
    return texts
