"""The scripts that make the scenes' assets write what is committed."""

import struct
import unittest
import zlib

try:
    import yaml
except ImportError:
    yaml = None

from script_case import ROOT, ScriptTest

SCENES = ROOT / "scenes"


def png_pixels(data):
    """The header and the filtered rows of a PNG: what two versions of zlib
    agree on."""
    place, header, packed = 8, b"", b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        header += body if kind == b"IHDR" else b""
        packed += body if kind == b"IDAT" else b""
        place += length + 12
    return header, zlib.decompress(packed)


def triangles_of(file):
    """How many triangles an OBJ file's faces have, as fans."""
    with open(file, encoding="utf-8") as lines:
        return sum(len(line.split()) - 3 for line in lines
                   if line.startswith("f "))


class MakeScenesTest(ScriptTest):

    def make(self, script, folder):
        """Runs a script and compares its files with the committed ones."""
        self.assert_passes(self.run_command(
            "/usr/bin/python3", "-B", ROOT / "scripts" / script,
            f"--out={self.tree / folder}"))
        made = {path.relative_to(self.tree)
                for path in self.tree.rglob("*") if path.is_file()}
        for name in sorted(made):
            with self.subTest(file=str(name)):
                self.assert_same((self.tree / name).read_bytes(),
                                 (SCENES / name).read_bytes(), name)
        return made

    def assert_same(self, made, committed, name):
        if name.suffix == ".png":
            made, committed = png_pixels(made), png_pixels(committed)
        self.assertTrue(made == committed, f"scenes/{name} differs")

    def committed(self, folder):
        return {path.relative_to(SCENES)
                for path in (SCENES / folder).rglob("*") if path.is_file()}

    def test_meshes(self):
        self.assertEqual(self.make("make_meshes.py", "meshes"),
                         self.committed("meshes"))

    def test_textures(self):
        self.assertEqual(self.make("make_textures.py", "textures"),
                         self.committed("textures"))

    def test_explore(self):
        made = self.make("make_explore.py", ".")
        scene = {path for path in made if path.name == "explore.yaml"}
        self.assertEqual(len(scene), 1)
        self.assertEqual(made - scene, self.committed("explore"))

    def test_stress(self):
        self.assertEqual(self.make("make_stress.py", "stress"),
                         self.committed("stress"))


@unittest.skipIf(yaml is None, "PyYAML is missing")
class ExploreTest(unittest.TestCase):
    """What the scene `explore` promises of its size."""

    @classmethod
    def setUpClass(cls):
        file = SCENES / "explore.yaml"
        cls.scene = yaml.safe_load(file.read_text(encoding="utf-8"))
        cls.known = {}
        cls.files = {}
        cls.note(cls.scene["objects"])

    @classmethod
    def note(cls, nodes):
        for node in nodes:
            cls.known[node.get("id")] = node
            cls.note(node.get("children", []))

    def count(self, node):
        """(objects, triangles of meshes) of a node, instances resolved."""
        if node["type"] == "instance":
            return self.count(self.known[node["of"]])
        if node["type"] == "mesh":
            file = node["file"]
            if file not in self.files:
                self.files[file] = triangles_of(SCENES / file)
            return 1, self.files[file]
        if node["type"] == "group":
            counts = [self.count(child) for child in node["children"]]
            return tuple(map(sum, zip(*counts)))
        return 1, 0

    def test_thousands_of_objects_and_over_a_million_triangles(self):
        objects, triangles = map(sum, zip(
            *(self.count(node) for node in self.scene["objects"])))
        self.assertGreater(objects, 5_000)
        self.assertLess(objects, 20_000)
        self.assertGreater(triangles, 1_000_000)

    def test_few_lights(self):
        """Each costs a shadow ray at every hit."""
        self.assertLessEqual(len(self.scene["lights"]), 8)

    def test_small_to_clone(self):
        """Under 6 MB in all, of which the YAML file under 1.5 MB."""
        text = (SCENES / "explore.yaml").stat().st_size
        assets = sum(path.stat().st_size
                     for path in (SCENES / "explore").iterdir())
        self.assertLess(text, 1_500_000)
        self.assertLess(text + assets, 6_000_000)


if __name__ == "__main__":
    unittest.main()
