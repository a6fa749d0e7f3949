"""The materials of the scene `explore`, for scripts/make_explore.py."""

from explore_parts import fields

# Bricks of the small scenes' picture, which holds four by eight.
BRICK = ("{type: image, file: textures/brick.png, scale: [1.5, 2]}, "
         "bump: {file: textures/brick_height.png, amount: 0.02}")
PLASTER = "bump: {file: explore/plaster_height.png, amount: 0.03}"
SLAB = ("{type: image, file: explore/slab.png, scale: [%g, %g]}, "
        "bump: {file: explore/slab_height.png, amount: 0.01}")
IMAGE = "{type: image, file: explore/%s.png, scale: [%g, %g]}"
MATERIALS = [
    f"{{id: brick, type: lambertian, texture: {BRICK}}}",
    f"{{id: ocher, type: lambertian, albedo: [0.72, 0.52, 0.26], {PLASTER}}}",
    f"{{id: rose, type: lambertian, albedo: [0.66, 0.36, 0.3], {PLASTER}}}",
    f"{{id: cream, type: lambertian, albedo: [0.74, 0.68, 0.55], {PLASTER}}}",
    f"{{id: teal, type: lambertian, albedo: [0.3, 0.48, 0.48], {PLASTER}}}",
    f"{{id: paving, type: lambertian, texture: {SLAB % (1, 17)}}}",
    f"{{id: corner, type: lambertian, texture: {SLAB % (1, 1)}}}",
    "{id: asphalt, type: lambertian, texture: "
    f"{IMAGE % ('asphalt', 60, 60)}}}",
    f"{{id: roof, type: lambertian, texture: {IMAGE % ('roof', 4, 4)}}}",
    f"{{id: cafe_sign, type: lambertian, texture: {IMAGE % ('cafe', 1, 1)}}}",
    f"{{id: book_sign, type: lambertian, texture: {IMAGE % ('books', 1, 1)}}}",
    "{id: looking_glass, type: mirror, reflectance: [0.9, 0.9, 0.9]}",
    "{id: chrome, type: metal, albedo: [0.85, 0.86, 0.88], roughness: 0}",
    "{id: brass, type: metal, albedo: [0.9, 0.7, 0.35], roughness: 0.3}",
    "{id: glass, type: dielectric, ior: 1.5, tint: [0.93, 0.97, 0.95]}",
    "{id: pane, type: metal, albedo: [0.07, 0.08, 0.1], roughness: 0}",
    "{id: car_glass, type: metal, albedo: [0.06, 0.06, 0.07], roughness: 0}",
    "{id: red_paint, type: lambertian, albedo: [0.65, 0.03, 0.03]}",
    "{id: blue_paint, type: lambertian, albedo: [0.04, 0.14, 0.5]}",
    "{id: white_paint, type: lambertian, albedo: [0.8, 0.8, 0.78]}",
    "{id: yellow_paint, type: lambertian, albedo: [0.85, 0.6, 0.04]}",
]
DIFFUSE = {
    "trim": (0.75, 0.73, 0.68), "stone": (0.62, 0.58, 0.5),
    "shutter": (0.12, 0.3, 0.2), "wood": (0.28, 0.15, 0.07),
    "door": (0.08, 0.2, 0.32), "white": (0.8, 0.8, 0.78),
    "stripe": (0.7, 0.06, 0.06), "fruit": (0.85, 0.35, 0.04),
    "book": (0.12, 0.1, 0.3), "iron": (0.05, 0.05, 0.06),
    "bark": (0.2, 0.14, 0.09), "crown_a": (0.17, 0.36, 0.07),
    "crown_b": (0.34, 0.34, 0.06), "soil": (0.1, 0.07, 0.05),
    "rubber": (0.03, 0.03, 0.03), "skin": (0.6, 0.38, 0.27),
    "hair": (0.08, 0.05, 0.03), "trousers": (0.08, 0.09, 0.14),
    "cobble": (0.4, 0.38, 0.36), "mortar": (0.14, 0.13, 0.12),
    "lawn": (0.12, 0.24, 0.06), "red": (0.7, 0.07, 0.06),
    "blue": (0.1, 0.2, 0.6), "yellow": (0.85, 0.62, 0.1),
    "violet": (0.4, 0.15, 0.5)}
GLOWING = {"lit": (0.72, 0.38, 0.12), "shop_light": (0.64, 0.44, 0.2),
           "globe": (2.8, 2.1, 1.2), "headlight": (2, 1.9, 1.6),
           "taillight": (1, 0.03, 0.02)}


def materials():
    """A flow mapping for each material."""
    return MATERIALS + [
        fields(id=name, type="lambertian", albedo=list(albedo))
        for name, albedo in DIFFUSE.items()] + [
        fields(id=name, type="emissive", radiance=list(radiance))
        for name, radiance in GLOWING.items()]
