"""A table, whatever it is written as, and how its figures look."""

import math
from dataclasses import dataclass, field

NONE = "–"
MINUS = "−"


@dataclass
class Cell:
    """A figure (or words) as shown, with the value behind it."""
    text: str
    raw: object = None
    best: bool = False
    warn: bool = False
    code: bool = False

    def value(self):
        return self.text if self.raw is None else self.raw


@dataclass
class Column:
    heading: str
    left: bool = False    # else to the right, as figures stand
    upright: bool = True  # else on its side where the format can do that


@dataclass
class Table:
    """rows of Cells; `total` of them, the last, summarize the others."""
    name: str
    title: str
    caption: str
    columns: list
    rows: list = field(default_factory=list)
    total: int = 0
    notes: list = field(default_factory=list)
    # What every row has in common, for formats that know no caption.
    stated: dict = field(default_factory=dict)

    def __bool__(self):
        return bool(self.rows)


def word(text, **more):
    return Cell(str(text), **more)


def code(text):
    return Cell(str(text), code=True)


def spec(encoder, names):
    """An encoder by its short label, the whole SPEC behind it."""
    return Cell(names.get(encoder, encoder), encoder, code=True)


def number(value, digits, **more):
    """With a fixed number of decimals."""
    if value is None or not math.isfinite(value):
        return Cell(NONE)
    return Cell(signed(f"{value:.{digits}f}"), value, **more)


def signed(text):
    """With a true minus sign, and no negative zero."""
    if text.startswith("-"):
        if not text.strip("-0."):
            return text[1:]
        return MINUS + text[1:]
    return text


def significant(value, digits=3):
    """A value as text with three significant digits, never as 1e5."""
    if value is None or not math.isfinite(value):
        return NONE
    if value == 0:
        return "0"
    # Rounded first: 99.96 is 100, which has its digits before the point.
    text = f"{value:.{digits - 1}e}"
    places = digits - 1 - int(text.split("e")[1])
    return signed(f"{float(text):.{max(0, places)}f}")


def figure(value, digits=3, **more):
    if value is None or not math.isfinite(value):
        return Cell(NONE)
    return Cell(significant(value, digits), value, **more)


def p_value(p):
    if p is None:
        return Cell(NONE)
    return Cell("< 0.001" if p < 0.001 else f"{p:.3f}", p)


def interval(mean, low, high, show):
    """`mean [low, high]`, each as show(value) gives it."""
    if mean is None:
        return Cell(NONE)
    if low is None:
        return Cell(f"{show(mean)} [{NONE}]", mean)
    return Cell(f"{show(mean)} [{show(low)}, {show(high)}]", mean)


def decimals(digits):
    return lambda value: signed(f"{value:.{digits}f}")


def record_of(comparison):
    """`wins / ties / losses`."""
    return word(f"{comparison.wins} / {comparison.ties} / "
                f"{comparison.losses}")


def count(number, noun):
    return f"{number} {noun}{'' if number == 1 else 's'}"
