"""Textures: what stands in place of a material's color."""

import math

import arrays

# Properties of a sphere's object: where the unit sphere lies in the scene
# object's own coordinates.
CENTER, RADIUS = "rtb_center", "rtb_radius"

# How far along the normal a checker is looked up, in cells.
CHECKER_MOVE = 0.001


def object_position(graph):
    return graph.node("ShaderNodeTexCoord").outputs["Object"]


def sphere_normal(graph):
    """The unit sphere's outward normal, in its own coordinates."""
    return graph.vector("NORMALIZE", object_position(graph))


def outward(graph, normal):
    """Undoes that Cycles turns normals to the viewer."""
    backfacing = graph.geometry("Backfacing")
    return graph.scaled(normal, graph.math(
        "SUBTRACT", 1, graph.math("MULTIPLY", 2, backfacing)))


def own_position(graph, is_sphere):
    """The position in the coordinates of the scene's object."""
    if not is_sphere:
        return object_position(graph)

    def attribute(name, output):
        return graph.node("ShaderNodeAttribute", attribute_type="OBJECT",
                          attribute_name=name).outputs[output]
    return graph.vector(
        "ADD", attribute(CENTER, "Vector"),
        graph.scaled(sphere_normal(graph), attribute(RADIUS, "Fac")))


def own_normal(graph, is_sphere):
    if is_sphere:
        return sphere_normal(graph)
    geometric = outward(graph, graph.geometry("True Normal"))
    return graph.transformed(geometric, "NORMAL", "WORLD", "OBJECT")


def checker(graph, texture, is_sphere):
    size = texture["size"]
    cells = graph.vector("DIVIDE", own_position(graph, is_sphere),
                         (size, size, size))
    moved = graph.vector("ADD", cells, graph.scaled(
        own_normal(graph, is_sphere), CHECKER_MOVE))
    floors = graph.vector("DOT_PRODUCT", graph.vector("FLOOR", moved),
                          (1, 1, 1))
    half = graph.math("FRACT", graph.math("MULTIPLY", floors, 0.5))
    odd = graph.math("GREATER_THAN", half, 0.25)
    return graph.mix_colors(odd, texture["a"], texture["b"])


def sphere_uv(graph):
    x, y, z = graph.separate(sphere_normal(graph))
    around = graph.math("ARCTAN2", graph.math("MULTIPLY", z, -1), x)
    u = graph.math("ADD", 0.5, graph.math("DIVIDE", around, 2 * math.pi))
    v = graph.math("ADD", 0.5,
                   graph.math("DIVIDE", graph.math("ARCSINE", y), math.pi))
    return graph.combine(u, v, 0)


def image(graph, texture, is_sphere, images, interpolation="Linear"):
    uv = sphere_uv(graph) if is_sphere else graph.node(
        "ShaderNodeUVMap", uv_map="uv").outputs[0]
    scaled = graph.vector("MULTIPLY", uv, (*texture["scale"], 1))
    node = graph.node("ShaderNodeTexImage", {"Vector": scaled},
                      interpolation=interpolation, extension="REPEAT",
                      projection="FLAT")
    node.image = images.get(texture["image"])
    return node.outputs["Color"]


def displacement(graph, bump, is_sphere, images):
    """What bends the normals: a height in units of the world."""
    height = graph.node("ShaderNodeRGBToBW", {
        0: image(graph, bump, is_sphere, images, "Cubic")}).outputs[0]
    return graph.node("ShaderNodeDisplacement", {
        "Height": height, "Midlevel": 0, "Scale": bump["amount"]},
        space="WORLD").outputs[0]


class Images:
    """Blender's images, each made once."""

    def __init__(self, descriptions):
        self.descriptions = descriptions
        self.made = {}

    def get(self, index):
        if index not in self.made:
            self.made[index] = arrays.image(self.descriptions[index],
                                            f"image{index}")
        return self.made[index]
