"""Bump maps, as displacements that bend normals and move nothing.

A normal that a node gives to a shader is darkened where it leans away from the
surface's; one that comes from a displacement is the surface's own. Cycles finds
that by the displacement's change from the hit point to two points a pixel away,
and so flattens what is finer. Here the displacement is made linear, with the
slope that the format gives at the hit point, so that nothing depends on the
size of pixels. The nodes of positions are evaluated at those points, too;
`Camera Data` alone stays at the hit point.
"""

import array

import textures

# Attributes of faces: u = dot(U_SLOPE, position) + the first of OFFSET.
U_SLOPE, V_SLOPE, OFFSET = "rtb_u_slope", "rtb_v_slope", "rtb_uv_offset"


def difference(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def triangle_slopes(points, values):
    """The gradient on a triangle of what is linear there, and the value at the
    origin of space."""
    e1 = difference(points[1], points[0])
    e2 = difference(points[2], points[0])
    normal = cross(e1, e2)
    area2 = dot(normal, normal)
    if area2 == 0:
        return (0, 0, 0), 0
    along1, along2 = cross(e2, normal), cross(normal, e1)
    rise1, rise2 = values[1] - values[0], values[2] - values[0]
    slope = tuple((rise1 * x + rise2 * y) / area2
                  for x, y in zip(along1, along2))
    return slope, values[0] - dot(slope, points[0])


def add_attributes(mesh, positions, corners, uvs):
    """Makes the texture coordinates a function of the position, face by face.
    """
    slopes = array.array("f"), array.array("f")
    offsets = array.array("f")
    for face in range(0, len(corners), 3):
        own = corners[face:face + 3]
        points = [positions[3 * i:3 * i + 3] for i in own]
        for axis in range(2):
            slope, offset = triangle_slopes(
                points, [uvs[2 * i + axis] for i in own])
            slopes[axis].extend(slope)
            offsets.append(offset)
        offsets.append(0)
    for name, values in ((U_SLOPE, slopes[0]), (V_SLOPE, slopes[1]),
                         (OFFSET, offsets)):
        layer = mesh.attributes.new(name, "FLOAT_VECTOR", "FACE")
        layer.data.foreach_set("vector", values)


def hit_position(graph):
    """Where the ray met the surface, in the object's coordinates."""
    node = graph.node("ShaderNodeCameraData")
    seen = graph.scaled(node.outputs["View Vector"],
                        node.outputs["View Distance"])
    return graph.transformed(seen, "POINT", "CAMERA", "OBJECT")


def face_attribute(graph, name):
    return graph.node("ShaderNodeAttribute", attribute_type="GEOMETRY",
                      attribute_name=name).outputs["Vector"]


def face_uv(graph, hit, position):
    """(u, v) at the hit, and how far that at the position is from it."""
    def of(vector, offset):
        u = graph.vector("DOT_PRODUCT", vector, face_attribute(graph, U_SLOPE))
        v = graph.vector("DOT_PRODUCT", vector, face_attribute(graph, V_SLOPE))
        uv = graph.combine(u, v, 0)
        return graph.vector("ADD", uv, offset)
    return (of(hit, face_attribute(graph, OFFSET)),
            of(graph.vector("SUBTRACT", position, hit), (0, 0, 0)))


def sphere_uv(graph, hit, position):
    at_hit = textures.sphere_uv(graph, graph.vector("NORMALIZE", hit))
    there = textures.sphere_uv(graph, graph.vector("NORMALIZE", position))
    apart = graph.vector("SUBTRACT", there, at_hit)
    # From one side of the seam to the other it is not once around.
    around = graph.vector("FLOOR", graph.vector("ADD", apart, (0.5, 0.5, 0)))
    return at_hit, graph.vector("SUBTRACT", apart, around)


def displacement(graph, bump, is_sphere, images):
    """A vector along the normal, in units of the world."""
    hit = hit_position(graph)
    uv, apart = (sphere_uv if is_sphere else face_uv)(
        graph, hit, textures.object_position(graph))
    picture = images.get(bump["image"])
    texels = graph.vector("MULTIPLY", uv, (*bump["scale"], 1))

    def height(x, y):
        moved = graph.vector("ADD", texels, (x, y, 0))
        color = textures.lookup(graph, picture, moved)
        return graph.separate(color)[0]

    def slope(axis):
        # By central differences over half a texel to each side.
        step = [0, 0]
        step[axis] = 0.5 / picture.size[axis]
        rise = graph.math("SUBTRACT", height(*step),
                          height(-step[0], -step[1]))
        return graph.math("MULTIPLY", rise,
                          picture.size[axis] * bump["scale"][axis])
    rise = graph.vector("DOT_PRODUCT", graph.combine(slope(0), slope(1), 0),
                        apart)
    return graph.node("ShaderNodeDisplacement", {
        "Height": rise, "Midlevel": 0, "Scale": bump["amount"]},
        space="WORLD").outputs[0]
