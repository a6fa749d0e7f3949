"""The outlines of glyphs, as SVG path data in a cell of 8 x 16.

Block elements, sextants, octants, wedges and shades by their definitions in
Unicode; all else from DejaVu Sans Mono, then DejaVu Sans (which matplotlib
brings), placed as the program's own decoding places it: the advance is the
cell's width, what ascender and descender leave of the height shared evenly.
"""

import unicodedata
from pathlib import Path

WIDTH, HEIGHT = 8, 16
FIRST_SEXTANT, FIRST_OCTANT = 0x1FB00, 0x1CD00

# Patterns (bit 0 top left, row by row) that older characters already fill.
QUADRANTS = {0x1: 0x2598, 0x2: 0x259D, 0x4: 0x2596, 0x6: 0x259E, 0x7: 0x259B,
             0x8: 0x2597, 0x9: 0x259A, 0xB: 0x259C, 0xD: 0x2599, 0xE: 0x259F}
OLDER_SEXTANTS = (0x00, 0x15, 0x2A, 0x3F)
OLDER_OCTANTS = {
    0x00: None, 0x01: 0x1CEA8, 0x02: 0x1CEAB, 0x03: 0x1FB82, 0x05: None,
    0x0A: None, 0x0F: None, 0x14: 0x1FBE6, 0x28: 0x1FBE7, 0x3F: 0x1FB85,
    0x40: 0x1CEA3, 0x50: None, 0x55: None, 0x5A: None, 0x5F: None,
    0x80: 0x1CEA0, 0xA0: None, 0xA5: None, 0xAA: None, 0xAF: None,
    0xC0: None, 0xF0: None, 0xF5: None, 0xFA: None, 0xFC: None, 0xFF: None}

# The points between which wedges are cut, clockwise, by their names.
BORDER = {"UPPER LEFT": (0, 0), "UPPER CENTRE": (4, 0),
          "UPPER RIGHT": (8, 0), "UPPER MIDDLE RIGHT": (8, 16 / 3),
          "LOWER MIDDLE RIGHT": (8, 32 / 3), "LOWER RIGHT": (8, 16),
          "LOWER CENTRE": (4, 16), "LOWER LEFT": (0, 16),
          "LOWER MIDDLE LEFT": (0, 32 / 3), "UPPER MIDDLE LEFT": (0, 16 / 3)}
CORNERS = ("UPPER LEFT", "UPPER RIGHT", "LOWER RIGHT", "LOWER LEFT")
TRIANGLES = {"LEFT": ((0, 16), (0, 0)), "UPPER": ((0, 0), (8, 0)),
             "RIGHT": ((8, 0), (8, 16)), "LOWER": ((8, 16), (0, 16))}


def figure(value):
    return f"{value:.2f}".rstrip("0").rstrip(".")


def polygon(points):
    return "M" + "L".join(f"{figure(x)} {figure(y)}" for x, y in points) + "Z"


def rectangle(left, top, right, bottom):
    return (f"M{figure(left)} {figure(top)}H{figure(right)}"
            f"V{figure(bottom)}H{figure(left)}Z")


def pattern(columns, rows, bits):
    """The sub-cells of a pattern, those side by side as one rectangle."""
    width, height = WIDTH / columns, HEIGHT / rows
    path = ""
    for row in range(rows):
        column = 0
        while column < columns:
            start = column
            while column < columns and bits >> (row * columns + column) & 1:
                column += 1
            if column > start:
                path += rectangle(start * width, row * height,
                                  column * width, (row + 1) * height)
            column += 1
    return path


def numbered(first, count, older):
    """{code point: pattern}: the patterns in binary order but for `older`."""
    left = [bits for bits in range(count) if bits not in older]
    return {first + index: bits for index, bits in enumerate(left)}


SEXTANTS = numbered(FIRST_SEXTANT, 64, OLDER_SEXTANTS)
OCTANTS = {**numbered(FIRST_OCTANT, 256, OLDER_OCTANTS),
           **{code: bits for bits, code in OLDER_OCTANTS.items() if code}}
BY_QUADRANTS = {code: bits for bits, code in QUADRANTS.items()}


def block(code):
    """U+2580-2595 but shades: one rectangle."""
    eighth, width = HEIGHT / 8, WIDTH / 8
    if code == 0x2580:
        return rectangle(0, 0, WIDTH, HEIGHT / 2)
    if code <= 0x2588:
        return rectangle(0, HEIGHT - (code - 0x2580) * eighth, WIDTH, HEIGHT)
    if code <= 0x258F:
        return rectangle(0, 0, (0x2590 - code) * width, HEIGHT)
    if code == 0x2590:
        return rectangle(WIDTH / 2, 0, WIDTH, HEIGHT)
    if code == 0x2594:
        return rectangle(0, 0, WIDTH, eighth)
    return rectangle(WIDTH - width, 0, WIDTH, HEIGHT)


def scan_line(code):
    """U+23BA-23BD: the first, third, seventh, ninth of nine rows."""
    row = {0x23BA: 0, 0x23BB: 2, 0x23BC: 6, 0x23BD: 8}[code]
    return rectangle(0, row * HEIGHT / 9, WIDTH, (row + 1) * HEIGHT / 9)


def along_border(begin, end):
    """Clockwise from one named point to another, with corners between."""
    names = list(BORDER)
    first, last = names.index(begin), names.index(end)
    path = [begin]
    step = (first + 1) % len(names)
    while step != last:
        if names[step] in CORNERS:
            path.append(names[step])
        step = (step + 1) % len(names)
    return path + [end]


def wedge(name):
    """`LOWER LEFT BLOCK DIAGONAL UPPER LEFT TO LOWER CENTRE` and its like."""
    corner, cut = name.split(" BLOCK DIAGONAL ")
    begin, end = cut.split(" TO ")
    side = along_border(begin, end)
    if corner not in side:
        side = along_border(end, begin)
    return polygon([BORDER[point] for point in side])


def triangles(name):
    """`UPPER AND RIGHT AND LOWER TRIANGULAR THREE QUARTERS BLOCK` etc."""
    sides = name.split(" TRIANGULAR ")[0].split(" AND ")
    return "".join(polygon([*TRIANGLES[side], (WIDTH / 2, HEIGHT / 2)])
                   for side in sides)


def geometric(code):
    """(path, opacity) by definition, or None."""
    if code in (0x20, 0xA0, 0x2800):
        return "", 1
    if 0x2591 <= code <= 0x2593:
        return rectangle(0, 0, WIDTH, HEIGHT), (code - 0x2590) / 4
    if code in BY_QUADRANTS:
        return pattern(2, 2, BY_QUADRANTS[code]), 1
    if 0x2580 <= code <= 0x2595:
        return block(code), 1
    if 0x23BA <= code <= 0x23BD:
        return scan_line(code), 1
    if code in SEXTANTS:
        return pattern(2, 3, SEXTANTS[code]), 1
    if code in OCTANTS:
        return pattern(2, 4, OCTANTS[code]), 1
    if 0x1FB3C <= code <= 0x1FB67:
        return wedge(unicodedata.name(chr(code))), 1
    if 0x1FB68 <= code <= 0x1FB6F:
        return triangles(unicodedata.name(chr(code))), 1
    return None


class Font:
    """Outlines of a font that matplotlib brings, in cells."""

    def __init__(self, name):
        import matplotlib
        from matplotlib import ft2font
        folder = Path(matplotlib.get_data_path()) / "fonts" / "ttf"
        self.font = ft2font.FT2Font(str(folder / name), hinting_factor=1)
        # Without scaling all is in the font's own units.
        self.flags = ft2font.LOAD_NO_SCALE

    def outline(self, code):
        """SVG path data, or None where the font lacks the character."""
        if self.font.get_char_index(code) == 0:
            return None
        glyph = self.font.load_char(code, flags=self.flags)
        scale = WIDTH / glyph.horiAdvance
        ascender = self.font.ascender * scale
        rest = HEIGHT - ascender + self.font.descender * scale
        baseline = rest / 2 + ascender
        # matplotlib takes the vertices for 26.6 fixed point numbers.
        vertices, codes = self.font.get_path()
        points = [(figure(x * 64 * scale), figure(baseline - y * 64 * scale))
                  for x, y in vertices]
        return svg_path(points, codes)


def svg_path(points, codes):
    """matplotlib's path codes as SVG's letters."""
    letters = {1: ("M", 1), 2: ("L", 1), 3: ("Q", 2), 4: ("C", 3)}
    parts, index = [], 0
    while index < len(codes):
        if codes[index] == 79:
            parts.append("Z")
            index += 1
            continue
        letter, count = letters[codes[index]]
        parts.append(letter + " ".join(
            f"{x} {y}" for x, y in points[index:index + count]))
        index += count
    return "".join(parts)


def outlines(characters):
    """{character: [path, opacity] or None}, None where nothing knows it."""
    fonts = [Font("DejaVuSansMono.ttf"), Font("DejaVuSans.ttf")]
    return {character: outline(character, fonts) for character in characters}


def outline(character, fonts):
    if len(character) != 1:
        return None
    shape = geometric(ord(character))
    if shape:
        return list(shape)
    for font in fonts:
        path = font.outline(ord(character))
        if path is not None:
            return [path, 1]
    return None
