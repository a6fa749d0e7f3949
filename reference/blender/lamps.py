"""Lights without a shape: they are not seen."""

import math

import bpy
import mathutils

from camera import frame
from nodes import Graph


def set_color(data, color):
    """The color, its largest component 1, and the factor taken out."""
    largest = max(color)
    data.color = [x / largest if largest > 0 else 0 for x in color]
    return largest


def strength_graph(data, strength):
    """Multiplies the lamp's emission by what `strength(graph)` says."""
    graph = Graph(data)
    emission = graph.node("ShaderNodeEmission",
                          {"Color": (1, 1, 1), "Strength": strength(graph)})
    graph.node("ShaderNodeOutputLight", {"Surface": emission.outputs[0]})


def constant_falloff(graph):
    node = graph.node("ShaderNodeLightFalloff", {"Strength": 1, "Smooth": 0})
    return node.outputs["Constant"]


def spot_share(lamp):
    """1 within the cone, then a smoothstep in the angle down to 0."""
    def strength(graph):
        # The way from the lamp to what it lights.
        way = graph.geometry("Incoming")
        axis = lamp["direction"]
        across = graph.vector("LENGTH",
                              graph.vector("CROSS_PRODUCT", way, axis))
        angle = graph.math("ARCTAN2", across,
                           graph.vector("DOT_PRODUCT", way, axis))
        past = graph.math("SUBTRACT", angle, math.radians(lamp["cone"]))
        if lamp["penumbra"] == 0:
            return graph.math("LESS_THAN", past, 0)
        t = graph.node("ShaderNodeClamp", {
            "Value": graph.math("DIVIDE", past,
                                math.radians(lamp["penumbra"])),
            "Min": 0, "Max": 1}).outputs[0]
        rest = graph.math("SUBTRACT", 3, graph.math("MULTIPLY", 2, t))
        step = graph.math("MULTIPLY", graph.math("MULTIPLY", t, t), rest)
        return graph.math("SUBTRACT", 1, step)
    return strength


def point(lamp):
    data = bpy.data.lights.new(lamp["id"], "POINT")
    data.shadow_soft_size = 0
    # Intensity is power / (4 pi).
    data.energy = 4 * math.pi * set_color(data, lamp["intensity"])
    if lamp["type"] == "spot":
        strength_graph(data, spot_share(lamp))
    elif not lamp["inverse_square"]:
        strength_graph(data, constant_falloff)
    return data, mathutils.Matrix.Translation(lamp["position"])


def sun(lamp):
    data = bpy.data.lights.new(lamp["id"], "SUN")
    data.angle = 0
    data.energy = set_color(data, lamp["irradiance"])
    # It shines along its own -z.
    back = -mathutils.Vector(lamp["direction"])
    side = back.orthogonal().normalized()
    return data, frame(side, back.cross(side), back, (0, 0, 0))


def build(scene, lamps):
    for lamp in lamps:
        make = sun if lamp["type"] == "directional" else point
        data, matrix = make(lamp)
        data.cycles.max_bounces = 1024
        data.cycles.cast_shadow = True
        item = bpy.data.objects.new(lamp["id"], data)
        item.matrix_world = matrix
        scene.collection.objects.link(item)
