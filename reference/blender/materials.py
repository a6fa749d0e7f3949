"""Materials as shader nodes."""

import bpy

import textures
from nodes import Graph
from textures import CENTER, RADIUS  # noqa: F401 (the objects set them)

# The Principled shader of a metal goes from its color to white along the
# Fresnel curve of a dielectric. This one (index 1.63) is the nearest to
# Schlick's curve, at most 0.034 of the way off.
PRINCIPLED_SPECULAR = 0.719


class Shader:
    """One material for one kind of shape."""

    def __init__(self, material, kind, maker):
        self.material = material
        self.is_sphere = kind == "sphere"
        self.is_finite = kind != "infinite"
        self.maker = maker
        self.data = bpy.data.materials.new(material["id"])
        self.graph = Graph(self.data)
        self.whitted = maker.description["integrator"] == "whitted"

    def build(self):
        surface = getattr(self, self.material["type"])()
        output = self.graph.node("ShaderNodeOutputMaterial",
                                 {"Surface": surface})
        if "bump" in self.material:
            # A normal that comes from a displacement is the surface's own; one
            # that a node gives is shadowed where it leans away from that.
            self.graph.set(output.inputs["Displacement"],
                           textures.displacement(
                               self.graph, self.material["bump"],
                               self.is_sphere, self.maker.images))
            self.data.cycles.displacement_method = "BUMP"
        # An emissive object is a light for the path integrator alone; a point
        # of an infinite one cannot be chosen by its area.
        self.data.cycles.sample_as_light = self.material["type"] == "light" or (
            self.material["type"] == "emissive" and not self.whitted
            and self.is_finite)
        return self.data

    def color(self):
        texture = self.material.get("texture")
        if texture is None:
            return self.material["color"]
        if texture["type"] == "checker":
            return textures.checker(self.graph, texture, self.is_sphere)
        return textures.image(self.graph, texture, self.is_sphere,
                              self.maker.images)

    def normal(self):
        """The normal turned to the viewer, exact on spheres."""
        graph = self.graph
        if not self.is_sphere:
            return graph.geometry("Normal")
        world = graph.transformed(textures.sphere_normal(graph), "NORMAL",
                                  "OBJECT", "WORLD")
        return textures.outward(graph, world)

    def emission(self, color, strength):
        node = self.graph.node("ShaderNodeEmission",
                               {"Color": color, "Strength": strength})
        return node.outputs[0]

    def lambertian(self):
        graph, color = self.graph, self.color()
        diffuse = graph.node("ShaderNodeBsdfDiffuse",
                             {"Color": color, "Roughness": 0}).outputs[0]
        ambient = self.maker.description["ambient"]
        if not any(ambient):
            return diffuse
        light = graph.vector("MULTIPLY", color, ambient)
        depth = graph.within_depth(self.maker.description["max_depth"])
        return graph.node("ShaderNodeAddShader", {
            0: diffuse, 1: self.emission(light, depth)}).outputs[0]

    def glossy(self, color, normal):
        node = self.graph.node("ShaderNodeBsdfGlossy",
                               {"Color": color, "Normal": normal},
                               distribution="SHARP")
        return node.outputs[0]

    def mirror(self):
        return self.glossy(self.color(), self.normal())

    def metal(self):
        graph, color, normal = self.graph, self.color(), self.normal()
        if self.material["roughness"] > 0:
            return graph.node("ShaderNodeBsdfPrincipled", {
                "Base Color": color, "Metallic": 1,
                "Specular": PRINCIPLED_SPECULAR,
                "Roughness": self.material["roughness"],
                "Normal": normal}, distribution="MULTI_GGX").outputs[0]
        # Schlick, "An Inexpensive BRDF Model for Physically-based
        # Rendering", Computer Graphics Forum 13(3), 1994, equation 15.
        cosine = graph.vector("DOT_PRODUCT", graph.geometry("Incoming"),
                              normal)
        left = graph.math("MAXIMUM", 0, graph.math("SUBTRACT", 1, cosine))
        schlick = graph.math("POWER", left, 5)
        return self.glossy(graph.mix_colors(schlick, color, (1, 1, 1)),
                           normal)

    def dielectric(self):
        graph, normal = self.graph, self.normal()
        ior, tint = self.material["ior"], self.material["color"]
        through = graph.node("ShaderNodeBsdfRefraction", {
            "Color": tint, "IOR": ior, "Normal": normal},
            distribution="SHARP").outputs[0]
        fresnel = graph.node("ShaderNodeFresnel",
                             {"IOR": ior, "Normal": normal}).outputs[0]
        glass = graph.mix_shaders(fresnel, through,
                                  self.glossy((1, 1, 1), normal))
        if not self.whitted:
            return glass
        # Light comes straight through, tinted at each crossing.
        straight = graph.node("ShaderNodeBsdfTransparent", {"Color": tint})
        return graph.mix_shaders(graph.light_path("Is Shadow Ray"), glass,
                                 straight.outputs[0])

    def emissive(self):
        depth = self.graph.within_depth(self.maker.description["max_depth"])
        return self.emission(self.color(), depth)

    def light(self):
        """Glows on its front, and is black otherwise."""
        graph = self.graph
        front = graph.math("SUBTRACT", 1, graph.geometry("Backfacing"))
        depth = graph.within_depth(self.maker.description["max_depth"])
        return self.emission(self.material["color"],
                             graph.math("MULTIPLY", front, depth))


class Maker:
    """Blender's materials, each made once for every kind of shape: `sphere`,
    `finite` or `infinite`."""

    def __init__(self, description):
        self.description = description
        self.images = textures.Images(description["images"])
        self.made = {}

    def get(self, index, kind):
        key = index, kind
        if key not in self.made:
            material = self.description["materials"][index]
            self.made[key] = Shader(material, kind, self).build()
        return self.made[key]
