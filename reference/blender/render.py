"""Renders a scene that `rtbench export --format=blender` wrote, with Cycles.

    blender -b --factory-startup --python-exit-code 1 --python render.py -- \
        scene.json --output=image.exr [--width=960] [--height=640] [--spp=64]
        [--first=0] [--seed=0] [--pixel-centers]

Writes linear radiance as float EXR. Needs Blender 3.4 and the modules beside
this file; no numpy.
"""

import argparse
import json
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import camera  # noqa: E402
import lamps  # noqa: E402
import objects  # noqa: E402
import world  # noqa: E402


def arguments():
    own = sys.argv[sys.argv.index("--") + 1:]
    parser = argparse.ArgumentParser()
    parser.add_argument("scene", type=Path)
    parser.add_argument("--output", type=Path, required=True)
    parser.add_argument("--width", type=int, default=960)
    parser.add_argument("--height", type=int, default=640)
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--first", type=int, default=0,
                        help="where in the sequence of samples to begin")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--pixel-centers", action="store_true")
    return parser.parse_args(own)


def clear():
    """Removes what the factory settings put into the scene."""
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)


def set_sampling(cycles, args):
    """Plain path tracing: nothing that trades bias for noise."""
    cycles.device = "CPU"
    cycles.samples = args.spp
    cycles.sampling_pattern = "PROGRESSIVE_MULTI_JITTER"
    cycles.sample_offset = args.first
    cycles.seed = args.seed
    cycles.use_animated_seed = False
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.sample_clamp_direct = 0
    cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.light_sampling_threshold = 0
    cycles.caustics_reflective = True
    cycles.caustics_refractive = True
    cycles.time_limit = 0
    # Blackman-Harris obeys the width, the box is always a full pixel.
    cycles.pixel_filter_type = "BLACKMAN_HARRIS" if args.pixel_centers else "BOX"
    cycles.filter_width = 0.01 if args.pixel_centers else 1
    cycles.film_exposure = 1
    cycles.use_auto_tile = False


def set_bounces(cycles, scene):
    """`max_depth` bounces of any kind; the whitted integrator lets light be
    scattered once at most by a diffuse surface, as the last thing."""
    depth = scene["max_depth"]
    cycles.min_light_bounces = 0
    cycles.min_transparent_bounces = 0
    cycles.max_bounces = depth
    cycles.diffuse_bounces = 0 if scene["integrator"] == "whitted" else depth
    cycles.glossy_bounces = depth
    cycles.transmission_bounces = depth
    cycles.volume_bounces = 0
    cycles.transparent_max_bounces = 1024


def set_output(render, args):
    render.resolution_x = args.width
    render.resolution_y = args.height
    render.resolution_percentage = 100
    render.pixel_aspect_x = render.pixel_aspect_y = 1
    render.film_transparent = False
    render.dither_intensity = 0
    render.use_compositing = False
    render.use_sequencer = False
    render.use_file_extension = False
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_mode = "RGB"
    render.image_settings.color_depth = "32"
    render.image_settings.exr_codec = "ZIP"
    render.filepath = str(args.output.resolve())


def main():
    args = arguments()
    description = json.loads(args.scene.read_text(encoding="utf-8"))
    clear()
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    set_sampling(scene.cycles, args)
    set_bounces(scene.cycles, description)
    set_output(scene.render, args)
    camera.build(scene, description["camera"])
    world.build(scene, description)
    lamps.build(scene, description["lamps"])
    objects.build(scene, description)
    bpy.ops.render.render(write_still=True)


main()
