"""The background."""

import bpy

import arrays
from nodes import Graph

# Background shaders are asked with a depth one higher than surfaces.
BACKGROUND_DEPTH = 1


def color_of(graph, background, images):
    if background["type"] == "constant":
        return background["color"]
    # In a world these coordinates are the direction of the ray.
    direction = graph.node("ShaderNodeTexCoord").outputs["Generated"]
    x, y, z = graph.separate(direction)
    if background["type"] == "gradient":
        share = graph.math("MULTIPLY", 0.5, graph.math("ADD", y, 1))
        return graph.mix_colors(share, background["bottom"],
                                background["top"])
    # Blender's equirectangular images have +x at the center, -y to the right
    # of it and +z up; ours have -z, +x and +y there.
    turned = graph.combine(graph.math("MULTIPLY", z, -1),
                           graph.math("MULTIPLY", x, -1), y)
    texture = graph.node("ShaderNodeTexEnvironment", {"Vector": turned},
                         interpolation="Linear",
                         projection="EQUIRECTANGULAR")
    texture.image = arrays.image(images[background["image"]], "background")
    return texture.outputs["Color"]


def build(scene, description):
    world = bpy.data.worlds.new("world")
    scene.world = world
    graph = Graph(world)
    color = color_of(graph, description["background"], description["images"])
    strength = graph.within_depth(description["max_depth"], BACKGROUND_DEPTH)
    background = graph.node("ShaderNodeBackground",
                            {"Color": color, "Strength": strength})
    graph.node("ShaderNodeOutputWorld", {"Surface": background.outputs[0]})
    if description["integrator"] == "whitted":
        # The background is seen, and lights nothing.
        world.cycles.sampling_method = "NONE"
        world.cycles_visibility.diffuse = False
        return
    world.cycles.sampling_method = "MANUAL"
    world.cycles.sample_map_resolution = 1024
