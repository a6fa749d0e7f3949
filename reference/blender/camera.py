"""The pinhole camera."""

import bpy
import mathutils

# The lens may be 1 to 5000 mm long.
LENS = 50
SMALLEST_SENSOR, LARGEST_SENSOR = 1, 100


def frame(right, up, back, origin):
    """The matrix that maps the axes to these vectors."""
    return mathutils.Matrix((
        (right[0], up[0], back[0], origin[0]),
        (right[1], up[1], back[1], origin[1]),
        (right[2], up[2], back[2], origin[2]),
        (0, 0, 0, 1)))


def build(scene, description):
    data = bpy.data.cameras.new("camera")
    data.type = "PERSP"
    data.sensor_fit = "VERTICAL"
    height = 2 * LENS * description["tan_half_vfov"]
    data.sensor_height = min(max(height, SMALLEST_SENSOR), LARGEST_SENSOR)
    data.lens = data.sensor_height / (2 * description["tan_half_vfov"])
    data.clip_start = 1e-6
    data.clip_end = 1e18
    item = bpy.data.objects.new("camera", data)
    item.matrix_world = frame(description["right"], description["up"],
                              [-x for x in description["forward"]],
                              description["position"])
    scene.collection.objects.link(item)
    scene.camera = item
