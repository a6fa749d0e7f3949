"""PTX's types and operands, as C++."""

import re

TYPES = {"pred": "bool", "f32": "float", "f64": "double"}
for kind, prefix in {"b": "uint", "u": "uint", "s": "int"}.items():
    for bits in (8, 16, 32, 64):
        TYPES[f"{kind}{bits}"] = f"{prefix}{bits}_t"
SPECIAL = {f"%{name}.{axis}": f"ptx_{name}.{axis}"
           for name in ("tid", "ntid", "ctaid", "nctaid") for axis in "xyz"}


class PtxError(Exception):
    """What the translator does not know."""


def split_operands(text):
    """Operands at commas that no bracket holds."""
    parts, depth, part = [], 0, ""
    for char in text:
        depth += (char in "{[(") - (char in "}])")
        if char == "," and depth == 0:
            parts.append(part.strip())
            part = ""
        else:
            part += char
    if part.strip():
        parts.append(part.strip())
    return parts


def identifier(name):
    """A PTX name as a C++ one; registers are elements of an array, since
    compilers are slow at thousands of variables."""
    register = re.fullmatch(r"%([a-z]+)(\d+)", name)
    if register:
        return f"R_{register[1]}[{register[2]}]"
    return name.replace("%", "R_").replace("$", "L_")


def function_name(name):
    """A function's name in C++: not the kernel's own, which the host has."""
    return "ptx_" + identifier(name)


def value(operand):
    """C++ for the bits of a register, constant or symbol's address."""
    if operand in SPECIAL:
        return SPECIAL[operand]
    if operand in ("%SP", "%SPL"):
        return identifier(operand)
    if re.fullmatch(r"0[fF][0-9A-Fa-f]{8}", operand):
        return f"uint32_t{{0x{operand[2:]}u}}"
    if re.fullmatch(r"0[dD][0-9A-Fa-f]{16}", operand):
        return f"uint64_t{{0x{operand[2:]}ull}}"
    if re.fullmatch(r"-?(0x[0-9A-Fa-f]+|\d+)U?", operand):
        return f"int64_t({operand.rstrip('U')}ll)"
    if re.fullmatch(r"%\w+", operand):
        return identifier(operand)
    if operand in ("true", "false"):
        return operand
    if re.fullmatch(r"[\w$]+", operand):
        return f"PtxAddress({identifier(operand)})"
    match = re.fullmatch(r"([\w$]+)\+(\d+)", operand)
    if match:
        return f"(PtxAddress({identifier(match[1])}) + {match[2]})"
    raise PtxError(f"operand `{operand}`")


def address(operand):
    """C++ for the address in brackets."""
    match = re.fullmatch(r"\[\s*([%\w$]+)\s*(?:\+\s*(-?\d+))?\s*\]", operand)
    if not match:
        raise PtxError(f"address `{operand}`")
    return f"{value(match[1])} + ({match[2] or 0})"


def get(operand, kind):
    """C++ for an operand read as a type of PTX."""
    negated = operand.startswith("!")
    text = f"PtxGet<{TYPES[kind]}>({value(operand.lstrip('!'))})"
    return f"!{text}" if negated else text


def members(operand):
    """The registers of `{a, b}`, or of a single one; _ takes no value."""
    return split_operands(operand[1:-1]) if operand[0] == "{" else [operand]
