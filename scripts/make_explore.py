#!/usr/bin/python3
"""Writes the scene `explore`: a street corner in the evening.

    scripts/make_explore.py [--out=FOLDER]

Writes explore.yaml, and explore/ with its meshes, textures and sky, to the
folder, which is scenes/ unless given. Every run makes the same files.
"""

import argparse
import random
from pathlib import Path

from explore_materials import materials
from explore_meshes import meshes
from explore_parts import (BAY, PARTS, STORY, box, fields, mesh, quad, sphere,
                           text)
from explore_pictures import TO_SUN, pictures

ROOT = Path(__file__).resolve().parent.parent
CURB, FRONT = 4.5, 7.5  # half widths of a street, to the curb and the houses
HEAD = """\
# A street corner in the evening, to walk through. scripts/make_explore.py made
# this file and all that it names; change that, not this.
rtbench_scene: 1
name: explore
description: A street corner in the evening, of 1.6 million triangles

camera:
  position: [3.3, 1.7, 11.6]
  look_at: [-2.5, 3.3, -8]
  vfov: 51
  user_control: true
  speed: 4

background: {type: image, file: explore/sky.hdr}

settings:
  max_depth: 4
  ambient: [0.2, 0.2, 0.25]
  exposure: 0.5

materials:
"""


class Town:
    """The objects. A part stands in full where it is first used; all later
    uses are instances of it."""

    def __init__(self):
        self.lines = []
        self.known = set()
        self.rng = random.Random(1980)

    def add(self, line, depth=0):
        self.lines.append("  " * (depth + 1) + "- " + line)

    def use(self, part, position, turn=0, depth=0, children=None, **more):
        """One copy of a part, or of a new group that `children` fills."""
        place = {"position": position, "rotate": [0, turn, 0], **more}
        if part in self.known:
            self.add(fields(type="instance", of=part, **place), depth)
            return
        self.known.add(part)
        self.add("type: group", depth)
        indent = "  " * (depth + 2)
        self.lines += [f"{indent}{key}: {text(value)}" for key, value
                       in {"id": part, **place}.items()]
        self.lines.append(f"{indent}children:")
        if children:
            children(depth + 1)
            return
        for line in PARTS[part]():
            self.add(line, depth + 1)

    def bays(self, ground, stories, count, depth, right):
        """A front of bays; right(i) is the place and turn of the i-th."""
        kinds = ["window", "shutters", "balcony"]
        style = [kinds[self.rng.randrange(3)] for _ in range(stories)]
        for story in range(stories):
            for i in range(count):
                place, turn = right(i)
                light = "lit" if self.rng.random() < 0.4 else "dark"
                part = f"{style[story]}_{light}"
                if story == 0:
                    part = ground[i % len(ground)]
                self.use(part, [place[0], STORY * story, place[1]], turn, depth)

    def roof(self, low, high, top, depth):
        """A core behind the fronts, a cornice, a roof and chimneys."""
        self.add(box([low[0], 0, low[1]], [high[0], top, high[1]]), depth)
        self.add(box([low[0] - 0.5, top, low[1] - 0.5],
                     [high[0] + 0.5, top + 0.5, high[1] + 0.5], "stone"), depth)
        self.add(box([low[0] + 0.8, top + 0.5, low[1] + 0.8],
                     [high[0] - 0.8, top + 2.2, high[1] - 0.8], "roof"), depth)
        for i in range(3):
            x = low[0] + (high[0] - low[0]) * (0.2 + 0.3 * i)
            z = low[1] + (high[1] - low[1]) * (0.7 - 0.25 * i)
            self.add(box([x, top + 2.2, z], [x + 0.9, top + 4, z + 0.9],
                         "stone"), depth)

    def corner_house(self, ground, stories, sign):
        """Six bays along x and six along -z, the corner at the origin."""
        def fill(depth):
            self.bays(ground, stories, 6, depth,
                      lambda i: ([-1.5 - BAY * i, 0], 0))
            self.bays(ground, stories, 6, depth,
                      lambda i: ([0, -1.5 - BAY * i], 90))
            self.roof([-18, -18], [-0.02, -0.02], STORY * stories, depth)
            self.add(quad([-6.4, 2.8, 0.3], [5.6, 0, 0], [0, 1.2, 0], sign),
                     depth)
            self.add(quad([0.3, 2.8, -0.6], [0, 0, -5.6], [0, 1.2, 0], sign),
                     depth)
        return fill

    def row_house(self, ground, stories):
        """Five bays along -z that look to +x."""
        def fill(depth):
            self.bays(ground, stories, 5, depth,
                      lambda i: ([0, -1.5 - BAY * i], 90))
            self.roof([-12, -15], [-0.02, 0], STORY * stories, depth)
        return fill

    def houses(self):
        a = self.corner_house(["shop_fruit", "shop_fruit", "door"], 5,
                              "cafe_sign")
        b = self.corner_house(["shop_books", "door", "shop_books"], 4,
                              "book_sign")
        for part, fill, x, z, turn, wall in (
                ("house_a", a, -FRONT, -FRONT, 0, "brick"),
                ("house_b", b, FRONT, -FRONT, -90, "ocher"),
                ("house_b", b, -FRONT, FRONT, 90, "rose"),
                ("house_a", a, FRONT, FRONT, 180, "cream")):
            self.use(part, [x, 0, z], turn, material=wall, children=fill)
        rows = [("row_a", self.row_house(["door", "window_dark"], 4)),
                ("row_b", self.row_house(["shop_fruit", "door"], 5)),
                ("row_c", self.row_house(["window_lit", "door"], 3))]
        walls = ["cream", "teal", "brick", "rose", "ocher"]
        near, far = [25.5 + 15 * k for k in range(2)], 15
        places = [place for z in (25.5, 40.5, 55.5, 70.5)
                  for place in ((-FRONT, -z, 0), (FRONT, -z - far, 180))]
        places += [(-FRONT, z + far, 0) for z in near]
        places += [(FRONT, z, 180) for z in near]
        places += [(s * x - (far if s < 0 else 0), -FRONT, -90)
                   for s in (-1, 1) for x in near]
        places += [(s * x + (far if s > 0 else 0), FRONT, 90)
                   for s in (-1, 1) for x in near]
        for i, (x, z, turn) in enumerate(places):
            part, fill = rows[i % 3]
            self.use(part, [x, 0, z], turn, material=walls[3 * i % 5],
                     children=fill)

    def ground(self):
        self.add(fields(id="ground", type="quad", corner=[-150, -0.06, 150],
                        edges=[[300, 0, 0], [0, 0, -300]], material="asphalt"))
        self.add(quad([-CURB, -0.03, CURB], [2 * CURB, 0, 0],
                      [0, 0, -2 * CURB], "mortar"))
        for i in range(3):
            for k in range(3):
                self.use("cobbles", [-CURB + BAY * i, 0, -CURB + BAY * k],
                         scale=[1, 1, 1])
        for i in range(20):
            for k in range(3):
                self.use("cobbles", [-CURB + BAY * k, 0, -10.5 - BAY * i])
        # Zebra crossings, before the corners.
        for i in range(8):
            for x, z in ((-4.2 + 1.1 * i, 5), (-4.2 + 1.1 * i, -7.2)):
                self.add(box([x, -0.07, z], [x + 0.6, -0.04, z + 2.2], "white"))
        for sx in (-1, 1):
            for sz in (-1, 1):
                x, z = (min(s * CURB, s * FRONT) for s in (sx, sz))
                self.add(quad([x, 0.12, z + 3], [3, 0, 0], [0, 0, -3],
                              "corner"))
                self.add(box([x, -0.1, z], [x + 3, 0.115, z + 3], "stone"))
                for start, along in (((x, sz * 58.5), "z"), ((sx * 58.5, z),
                                                             "x")):
                    self.sidewalk(start, along, sx, sz)

    def sidewalk(self, start, along, sx, sz):
        """Paving of 51 meters from a corner, and the curb under it."""
        if along == "z":
            x, z = start[0], max(sz * FRONT, start[1])
            self.add(quad([x, 0.12, z], [3, 0, 0], [0, 0, -51], "paving"))
            self.add(box([x, -0.1, z - 51], [x + 3, 0.115, z], "stone"))
            return
        x, z = min(sx * FRONT, start[0]), start[1]
        self.add(quad([x, 0.12, z], [0, 0, 3], [51, 0, 0], "paving"))
        self.add(box([x, -0.1, z], [x + 51, 0.115, z + 3], "stone"))

    def monument(self):
        """In the middle of the crossing, a mirroring ball."""
        self.add(mesh("pedestal", "stone", id="pedestal"))
        self.add(sphere([0, 2.65, 0], 1.12, "looking_glass", id="ball"))
        self.add(fields(type="disk", center=[0, 0.06, 0], normal=[0, 1, 0],
                        radius=2.1, material="lawn"))

    def greenery(self):
        for i in range(13):
            for side in (-1, 1):
                part = "tree_a" if (i + side) % 3 else "tree_b"
                size = 0.85 + 0.3 * self.rng.random()
                self.use(part, [side * 5.3, 0.12, -16.0 - 7.5 * i],
                         360 * self.rng.random(), scale=size)
                self.use(part, [side * (17 + 7.5 * i), 0.12, 5.3 * side],
                         360 * self.rng.random(), scale=size)
        for i in range(30):
            x, z = -30 + 60 * self.rng.random(), -92 - 25 * self.rng.random()
            self.use(("tree_a", "tree_b")[i % 2], [x, 0, z],
                     360 * self.rng.random(),
                     scale=1.1 + 0.8 * self.rng.random())
        for x, z, turn in ((-6.9, -11, 90), (-6.9, -14.5, 90), (6.9, -18, 90),
                           (-12, -6.9, 0), (-16, -6.9, 0), (6.9, 11.5, 90)):
            self.use("planter", [x, 0.12, z], turn)

    def furniture(self):
        for i in range(8):
            for side in (-1, 1):
                self.use("lamp", [side * 4.9, 0.12, -8.6 - 13.0 * i])
                self.use("lamp", [side * (8.6 + 13.0 * i), 0.12, side * 4.9])
        for x, z, turn in ((-9, -5.9, 20), (-11.4, -5.8, -15),
                           (-6, -9.4, 70), (-6.1, -12.7, 100)):
            self.use("table", [x, 0.12, z], turn)
        self.use("shelter", [6, 0.12, -12.5], -90)
        self.use("shelter", [-6, 0.12, -30], 90)
        for i in range(16):
            side = (-1, 1)[i % 2]
            self.use("bicycle", [side * 6.6, 0.12, -18 - 1.1 * (i // 2)
                                 - (0 if side > 0 else 16)],
                     80 + 20 * self.rng.random(),
                     material=("red", "blue", "yellow", "iron")[i % 4])
        self.use("bicycle", [-5.1, 0.12, 5.6], 35, material="red")

    def traffic(self):
        paints = ["red_paint", "blue_paint", "white_paint", "yellow_paint"]
        for i, (x, z, turn) in enumerate((
                (-2.6, -11.5, -88), (2.4, -24, 90), (-3.4, -20, -90),
                (-3.4, -26, -90), (3.5, -33, 90), (-3.4, -38, -90),
                (3.5, -45, 90), (-11, 2.6, 2), (13, -2.4, 180),
                (20, 3.4, 0), (-22, -3.4, 180), (-30, -3.4, 180),
                (32, 3.4, 0), (3.5, -56, 90), (-3.4, -50, -90),
                (-3.4, 22, -90))):
            self.use("car", [x, -0.06 if abs(x) > CURB else 0, z], turn,
                     material=paints[i % 4])
        coats = ["red", "blue", "yellow", "violet", "white"]
        places = [(-5.4, -6.2), (-6.2, -10.8), (-4.6, -5.6), (-8, -6.6),
                  (0.9, 5.9), (-1.4, 6.4), (5.2, -6), (5.7, -11.6)]
        places += [((-1, 1)[i % 2] * (5.8 + 0.8 * self.rng.random()),
                    -16 - 3.0 * i) for i in range(14)]
        for i, (x, z) in enumerate(places):
            self.use("person", [x, 0.12 if abs(x) > CURB else -0.04, z],
                     360 * self.rng.random(), material=coats[i % 5],
                     scale=0.92 + 0.14 * self.rng.random())


def lights():
    """The sun, low over the cross street, and the nearest lamps."""
    made = [fields(id="sun", type="directional",
                   direction=[-x for x in TO_SUN], irradiance=[3.4, 2.3, 1.2])]
    for i, (x, z) in enumerate(((-4.9, -8.6), (4.9, -8.6), (-8.6, -4.9),
                                (8.6, 4.9), (-4.9, -21.6))):
        made.append(fields(id=f"lamp{i}", type="point", position=[x, 4.5, z],
                           intensity=[9, 6.2, 3]))
    made.append(fields(id="shop_spot", type="spot", position=[-3.6, 6.5, -3.6],
                       direction=[-0.6, -0.55, -0.6], intensity=[22, 18, 11],
                       cone=26, penumbra=14))
    return made


def scene():
    """The text of explore.yaml."""
    town = Town()
    for fill in (town.ground, town.monument, town.houses, town.greenery,
                 town.furniture, town.traffic):
        fill()
    return HEAD + "\n".join(
        [f"  - {m}" for m in materials()] + ["", "lights:"]
        + [f"  - {light}" for light in lights()] + ["", "objects:"]
        + town.lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=Path, default=ROOT / "scenes")
    folder = parser.parse_args().out
    assets = folder / "explore"
    assets.mkdir(parents=True, exist_ok=True)
    for name, content in meshes().items():
        (assets / name).write_text(content, encoding="utf-8")
    for name, content in pictures().items():
        (assets / name).write_bytes(content)
    (folder / "explore.yaml").write_text(scene(), encoding="utf-8")


if __name__ == "__main__":
    main()
