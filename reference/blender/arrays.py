"""Arrays and images that the JSON holds as base64."""

import array
import base64

import bpy


def floats(text):
    numbers = array.array("f")
    numbers.frombytes(base64.b64decode(text))
    return numbers


def integers(text):
    numbers = array.array("i")
    numbers.frombytes(base64.b64decode(text))
    return numbers


def image(description, name):
    """An image of linear colors, which nothing converts."""
    width, height = description["width"], description["height"]
    item = bpy.data.images.new(name, width, height, float_buffer=True,
                               is_data=True)
    rgb = floats(description["pixels"])
    rgba = array.array("f", [1.0]) * (4 * width * height)
    for channel in range(3):
        rgba[channel::4] = rgb[channel::3]
    item.pixels.foreach_set(rgba)
    item.update()
    return item
