"""Meshes and the objects that place them."""

import math

import bmesh
import bpy
import mathutils

import arrays
import materials

# 81,920 triangles.
SPHERE_SUBDIVISIONS = 7


def mesh_of(description, name):
    """A mesh; each triangle's corners have the texture coordinates and
    normals of its positions."""
    positions = arrays.floats(description["positions"])
    corners = arrays.integers(description["triangles"])
    count = len(corners) // 3
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(positions) // 3)
    mesh.vertices.foreach_set("co", positions)
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", range(0, 3 * count, 3))
    mesh.polygons.foreach_set("loop_total", [3] * count)
    if "uvs" in description:
        set_uvs(mesh, corners, arrays.floats(description["uvs"]))
    smooth = "normals" in description
    mesh.polygons.foreach_set("use_smooth", [smooth] * count)
    mesh.update(calc_edges=True)
    if smooth:
        set_normals(mesh, arrays.floats(description["normals"]))
    return mesh


def set_uvs(mesh, corners, uvs):
    pairs = [0.0] * (2 * len(corners))
    for axis in range(2):
        of_axis = uvs[axis::2]
        pairs[axis::2] = [of_axis[i] for i in corners]
    layer = mesh.uv_layers.new(name="uv", do_init=False)
    layer.data.foreach_set("uv", pairs)


def set_normals(mesh, normals):
    mesh.use_auto_smooth = True
    mesh.auto_smooth_angle = math.pi
    mesh.normals_split_custom_set_from_vertices(
        list(zip(normals[0::3], normals[1::3], normals[2::3])))


def unit_sphere():
    """A ball of triangles as large as the sphere: by Cauchy's formula its
    silhouette, averaged over all directions, is a quarter of its surface."""
    mesh = bpy.data.meshes.new("sphere")
    builder = bmesh.new()
    bmesh.ops.create_icosphere(builder, subdivisions=SPHERE_SUBDIVISIONS,
                               radius=1)
    area = sum(face.calc_area() for face in builder.faces)
    growth = math.sqrt(4 * math.pi / area)
    for vertex in builder.verts:
        vertex.co *= growth
    for face in builder.faces:
        face.smooth = True
    builder.to_mesh(mesh)
    builder.free()
    return mesh


class Meshes:
    """Meshes with their materials, each made once. Cycles shares a mesh
    between objects only where the mesh itself holds the material."""

    def __init__(self, description):
        self.description = description
        self.plain = {}
        self.with_material = {}
        self.maker = materials.Maker(description)

    def get(self, item):
        key = (item.get("mesh", "sphere"), item["material"],
               item.get("infinite", False))
        if key not in self.with_material:
            self.with_material[key] = self.make(*key)
        return self.with_material[key]

    def make(self, shape, material, infinite):
        if shape not in self.plain:
            mesh = unit_sphere() if shape == "sphere" else mesh_of(
                self.description["meshes"][shape], f"mesh{shape}")
            self.plain[shape] = mesh
        else:
            mesh = self.plain[shape].copy()
            mesh.materials.clear()
        kind = "sphere" if shape == "sphere" else (
            "infinite" if infinite else "finite")
        mesh.materials.append(self.maker.get(material, kind))
        return mesh


def matrix_of(numbers):
    x, y, z, origin = (numbers[i:i + 3] for i in range(0, 12, 3))
    return mathutils.Matrix((
        (x[0], y[0], z[0], origin[0]),
        (x[1], y[1], z[1], origin[1]),
        (x[2], y[2], z[2], origin[2]),
        (0, 0, 0, 1)))


def parent_of_all(scene):
    """Lets objects have any matrix. One that is given an object itself loses
    its shear, for it is kept as a position, angles and scales."""
    parent = bpy.data.objects.new("world", None)
    scene.collection.objects.link(parent)
    return parent


def build(scene, description):
    meshes = Meshes(description)
    parent = parent_of_all(scene)
    whitted = description["integrator"] == "whitted"
    for number, item in enumerate(description["objects"]):
        placed = bpy.data.objects.new(f"object{number}", meshes.get(item))
        placed.parent = parent
        placed.matrix_parent_inverse = matrix_of(item["matrix"])
        if "sphere" in item:
            placed[materials.CENTER] = item["sphere"][:3]
            placed[materials.RADIUS] = item["sphere"][3]
        material = description["materials"][item["material"]]
        if whitted and material["type"] != "light":
            # What shines, or has ambient light, lights nothing.
            placed.visible_diffuse = False
        scene.collection.objects.link(placed)
