"""Buildings and street furniture of the scene `explore`, for
scripts/make_explore.py: each function gives the children of a group.
"""

BAY, STORY = 3.0, 3.4  # meters, the width of a bay and the height of a story


def fields(**values):
    """A flow mapping; numbers are rounded to millimeters."""
    return "{" + ", ".join(f"{k}: {text(v)}" for k, v in values.items()) + "}"


def text(value):
    """A value as YAML writes it."""
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(text(x) for x in value) + "]"
    if isinstance(value, float):
        # Adding zero turns -0 to 0.
        return f"{round(value, 3) + 0.0:.3f}".rstrip("0").rstrip(".")
    return str(value)


def shape(kind, coordinates, material, more):
    named = {"material": material} if material else {}
    return fields(type=kind, **coordinates, **named, **more)


def box(low, high, material=None, **more):
    return shape("box", {"min": low, "max": high}, material, more)


def quad(corner, right, up, material=None, **more):
    return shape("quad", {"corner": corner, "edges": [right, up]}, material,
                 more)


def sphere(center, radius, material=None, **more):
    return shape("sphere", {"center": center, "radius": radius}, material,
                 more)


def mesh(name, material=None, **more):
    return shape("mesh", {"file": f"explore/{name}.obj"}, material, more)


def wall():
    return [quad([-1.5, 0, 0], [BAY, 0, 0], [0, STORY, 0])]


def window(pane):
    """A bay of wall with a window."""
    frame = [([-0.69, 0.85, 0], [-0.6, 2.75, 0.12]),
             ([0.6, 0.85, 0], [0.69, 2.75, 0.12]),
             ([-0.6, 2.66, 0], [0.6, 2.75, 0.12]),
             ([-0.04, 0.9, 0], [0.04, 2.66, 0.09]),
             ([-0.6, 2.05, 0], [0.6, 2.12, 0.08])]
    return wall() + [quad([-0.6, 0.9, 0.04], [1.2, 0, 0], [0, 1.8, 0], pane)] \
        + [box(a, b, "trim") for a, b in frame] \
        + [box([-0.85, 0.72, 0], [0.85, 0.86, 0.24], "stone"),
           box([-0.85, 2.75, 0], [0.85, 3, 0.16], "stone"),
           box([-1.5, 0, 0], [1.5, 0.14, 0.1], "stone")]


def shutters(pane):
    return window(pane) + [
        box([-1.32, 0.86, 0], [-0.74, 2.74, 0.07], "shutter"),
        box([0.74, 0.86, 0], [1.32, 2.74, 0.07], "shutter")]


def balcony(pane):
    rail = [mesh("baluster", "stone", position=[-1.15 + 0.46 * i, 0.14, 0.82],
                 scale=[1.0, 0.95, 1.0]) for i in range(6)]
    return window(pane) + rail + [
        box([-1.3, -0.02, 0], [1.3, 0.14, 0.95], "stone"),
        box([-1.3, 0.9, 0.74], [1.3, 1, 0.92], "stone")]


def shop(goods):
    """A bay of shop window with goods before the light."""
    parts = [box([-1.5, 0, 0], [1.5, 0.5, 0.12], "wood"),
             box([-1.5, 2.7, 0], [1.5, STORY, 0.14], "wood"),
             box([-1.5, 0.5, 0], [-1.32, 2.7, 0.14], "wood"),
             box([1.32, 0.5, 0], [1.5, 2.7, 0.14], "wood"),
             box([-0.05, 0.5, 0.02], [0.05, 2.7, 0.1], "wood"),
             quad([-1.32, 0.5, 0.02], [2.64, 0, 0], [0, 2.2, 0], "shop_light")]
    for i in range(5):
        x = -1.05 + 0.52 * i
        parts.append(sphere([x, 0.68, 0.2], 0.17, "fruit") if goods else
                     box([x - 0.12, 0.5, 0.1], [x + 0.12, 1.1 + 0.1 * (i % 3),
                                                0.2], "book"))
    # An awning of stripes.
    for i in range(6):
        parts.append(quad([-1.5 + 0.5 * i, 2.55, 1.3], [0.5, 0, 0],
                          [0, 0.55, -1.2], "stripe" if i % 2 else "white"))
    return parts


def door():
    return wall() + [
        box([-0.75, 0, 0], [-0.6, 2.6, 0.16], "stone"),
        box([0.6, 0, 0], [0.75, 2.6, 0.16], "stone"),
        box([-0.75, 2.6, 0], [0.75, 2.85, 0.22], "stone"),
        box([-0.6, 0, 0], [0.6, 2.1, 0.06], "door"),
        quad([-0.6, 2.1, 0.05], [1.2, 0, 0], [0, 0.5, 0], "lit"),
        sphere([0.42, 1, 0.1], 0.05, "brass"),
        box([-0.9, 0, 0], [0.9, 0.12, 0.6], "stone")]


def lamp():
    return [mesh("post", "iron"), sphere([0, 3.92, 0], 0.22, "globe"),
            sphere([0, 4.16, 0], 0.06, "iron")]


def tree(crown):
    return [mesh("trunk", "bark"), mesh(crown, crown),
            box([-0.7, 0, -0.7], [0.7, 0.06, 0.7], "soil")]


def car():
    tires = [mesh("tire", "rubber", position=[x, 0.33, z])
             for x in (-1.3, 1.3) for z in (-0.78, 0.78)]
    return [mesh("car_body"), mesh("car_cabin", "car_glass",
                                   position=[-0.25, 0, 0])] + tires + [
        sphere([2.02, 0.62, z], 0.11, "headlight") for z in (-0.55, 0.55)] + [
        sphere([-2.02, 0.66, z], 0.09, "taillight") for z in (-0.6, 0.6)] + [
        box([1.98, 0.36, -0.7], [2.14, 0.46, 0.7], "chrome"),
        box([-2.14, 0.36, -0.7], [-1.98, 0.46, 0.7], "chrome")]


def person():
    return [mesh("coat"), mesh("legs", "trousers"),
            sphere([0, 1.75, 0], 0.13, "skin"),
            sphere([-0.02, 1.79, 0], 0.13, "hair")]


def planter():
    return [box([-0.9, 0, -0.4], [0.9, 0.5, 0.4], "wood"),
            mesh("bush", "crown_b", position=[-0.42, 0.25, 0]),
            mesh("bush", "crown_a", position=[0.42, 0.22, 0],
                 rotate=[0, 70, 0])]


def shelter():
    """A bus stop of glass."""
    posts = [box([x, 0, z], [x + 0.08, 2.5, z + 0.08], "iron")
             for x in (-1.8, 1.72) for z in (-0.7, 0.62)]
    return posts + [
        box([-2, 2.5, -0.9], [2, 2.6, 0.9], "chrome"),
        box([-1.7, 0.25, -0.68], [1.7, 2.3, -0.65], "glass"),
        box([-1.79, 0.25, -0.55], [-1.76, 2.3, 0.55], "glass"),
        box([-1.4, 0.42, -0.55], [1.4, 0.48, -0.15], "wood"),
        box([-1.2, 0, -0.4], [-1.1, 0.42, -0.3], "iron"),
        box([1.1, 0, -0.4], [1.2, 0.42, -0.3], "iron")]


def cafe_table():
    chairs = []
    for x, turn in ((-0.75, 0), (0.75, 180)):
        chairs.append(fields(type="box", min=[-0.2, 0.42, -0.2],
                             max=[0.2, 0.47, 0.2], material="wood",
                             position=[x, 0, 0]))
        back = x - 0.2 if turn == 0 else x + 0.16
        chairs += [box([back, 0.47, -0.2], [back + 0.04, 0.95, 0.2], "wood"),
                   box([x - 0.18, 0, -0.18], [x - 0.14, 0.42, 0.18], "iron"),
                   box([x + 0.14, 0, -0.18], [x + 0.18, 0.42, 0.18], "iron")]
    return chairs + [
        fields(type="disk", center=[0, 0.75, 0], normal=[0, 1, 0], radius=0.42,
               material="white"),
        box([-0.03, 0, -0.03], [0.03, 0.74, 0.03], "iron"),
        sphere([0.1, 0.82, 0.12], 0.07, "glass"),
        sphere([-0.16, 0.8, -0.06], 0.05, "fruit")]


PARTS = {
    "window_dark": lambda: window("pane"), "window_lit": lambda: window("lit"),
    "shutters_dark": lambda: shutters("pane"),
    "shutters_lit": lambda: shutters("lit"),
    "balcony_dark": lambda: balcony("pane"),
    "balcony_lit": lambda: balcony("lit"),
    "shop_fruit": lambda: shop(True), "shop_books": lambda: shop(False),
    "door": door, "lamp": lamp, "tree_a": lambda: tree("crown_a"),
    "tree_b": lambda: tree("crown_b"), "car": car, "person": person,
    "planter": planter, "shelter": shelter, "table": cafe_table,
    "cobbles": lambda: [mesh("cobbles", "cobble")],
    "bicycle": lambda: [mesh("bicycle")],
}
