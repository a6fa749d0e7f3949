"""Shader nodes from expressions.

A value is a number, a tuple, or the output socket of another node.
"""

import bpy


class Graph:
    """The node tree of a material, a lamp or the world."""

    def __init__(self, owner):
        owner.use_nodes = True
        self.tree = owner.node_tree
        self.tree.nodes.clear()

    def node(self, kind, inputs=None, **properties):
        """A node; `inputs` by name or by number."""
        node = self.tree.nodes.new(kind)
        for name, value in properties.items():
            setattr(node, name, value)
        for key, value in (inputs or {}).items():
            self.set(node.inputs[key], value)
        return node

    def set(self, socket, value):
        if isinstance(value, bpy.types.NodeSocket):
            self.tree.links.new(value, socket)
        elif socket.type == "RGBA" and len(value) == 3:
            socket.default_value = (*value, 1)
        else:
            socket.default_value = value

    def math(self, operation, *values):
        node = self.node("ShaderNodeMath", dict(enumerate(values)),
                         operation=operation)
        return node.outputs[0]

    def vector(self, operation, *values):
        """A vector operation; those that give a number give that."""
        node = self.node("ShaderNodeVectorMath", dict(enumerate(values)),
                         operation=operation)
        number = operation in ("DOT_PRODUCT", "LENGTH")
        return node.outputs["Value" if number else "Vector"]

    def scaled(self, vector, factor):
        node = self.node("ShaderNodeVectorMath", {0: vector, "Scale": factor},
                         operation="SCALE")
        return node.outputs["Vector"]

    def separate(self, vector):
        node = self.node("ShaderNodeSeparateXYZ", {0: vector})
        return node.outputs[0], node.outputs[1], node.outputs[2]

    def combine(self, x, y, z):
        return self.node("ShaderNodeCombineXYZ",
                         {0: x, 1: y, 2: z}).outputs[0]

    def mix_colors(self, share, a, b):
        """a at share 0, b at share 1."""
        return self.node("ShaderNodeMixRGB",
                         {0: share, 1: a, 2: b}).outputs[0]

    def mix_shaders(self, share, a, b):
        return self.node("ShaderNodeMixShader",
                         {0: share, 1: a, 2: b}).outputs[0]

    def geometry(self, name):
        return self.node("ShaderNodeNewGeometry").outputs[name]

    def light_path(self, name):
        return self.node("ShaderNodeLightPath").outputs[name]

    def transformed(self, vector, kind, source, target):
        node = self.node("ShaderNodeVectorTransform", {0: vector},
                         vector_type=kind, convert_from=source,
                         convert_to=target)
        return node.outputs[0]

    def within_depth(self, depth, extra=0):
        """1, but 0 for light that a mirror or glass sends along a ray past the
        limit of bounces: the format sees black there, Cycles still looks what
        shines. Other rays past the limit belong to light sampling."""
        past = self.math("GREATER_THAN", self.light_path("Ray Depth"),
                         depth + extra + 0.5)
        singular = self.light_path("Is Singular Ray")
        return self.math("SUBTRACT", 1, self.math("MULTIPLY", past, singular))
