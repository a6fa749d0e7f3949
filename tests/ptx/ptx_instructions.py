"""PTX's instructions, as C++ statements."""

import re

from ptx_operands import (TYPES, PtxError, address, function_name, get,
                          identifier, members, split_operands, value)
from ptx_tables import COMPARISONS, FLOATING, IGNORED, PLAIN, WHOLE, WIDER


class Instruction:
    """One instruction: its opcode's parts and its operands."""

    def __init__(self, text):
        self.text = text
        match = re.match(r"([a-z]\w*(?:[.:]+\w+)*)\s*(.*)$", text, re.S)
        if not match:
            raise PtxError(f"`{text}`")
        parts = match[1].replace("::", "@").split(".")
        self.name = parts[0]
        self.modifiers = [part.replace("@", "::") for part in parts[1:]]
        self.operands = split_operands(match[2])
        self.types = [m for m in self.modifiers if m in TYPES]
        self.type = self.types[-1] if self.types else None
        self.rest = [m for m in self.modifiers
                     if m not in TYPES and m not in IGNORED]

    def unknown(self):
        """The Error to raise."""
        return PtxError(f"instruction `{self.text}`")

    def take(self, *names):
        """The modifier among `names` that is there, which is thereby known."""
        for name in names:
            if name in self.rest:
                self.rest.remove(name)
                return name
        return None

    def finish(self, code):
        """`code`, when every modifier has been heeded."""
        if self.rest:
            raise self.unknown()
        return code

    def assign(self, expression, kind=None):
        """Assignment of an expression of a type to the first operand."""
        kind = TYPES[kind or self.type]
        return self.finish(f"PtxSet({identifier(self.operands[0])}, "
                           f"static_cast<{kind}>({expression}));")

    def fill(self, template):
        """The template's C++, with this instruction's operands."""
        def operand(match):
            return get(self.operands[1 + int(match[1])], self.type)
        return self.assign(re.sub(r"%(\d)", operand, template))


def is_floating(instruction):
    return instruction.type in ("f32", "f64")


def translate_multiply(i):
    """mul and mad of whole numbers."""
    kind, part = i.type, i.take("lo", "hi", "wide")
    a, b = (get(operand, kind) for operand in i.operands[1:3])
    if part == "wide":
        wide = TYPES[WIDER[kind]]
        product, kind = f"{wide}({a}) * {wide}({b})", WIDER[kind]
    elif part == "hi":
        product = f"PtxHigh({a}, {b})"
    elif part == "lo":
        product = f"PtxLow({a}, {b})"
    else:
        raise i.unknown()
    if i.name == "mad":
        product = f"{product} + {get(i.operands[3], kind)}"
    return i.assign(product, kind)


def translate_setp(i):
    """Comparisons, and their combination with a predicate."""
    boolean = i.take("and", "or", "xor")
    a, b = (get(operand, i.type) for operand in i.operands[1:3])
    name = i.take(*COMPARISONS, *(c + "u" for c in COMPARISONS), "num", "nan")
    if name is None:
        raise i.unknown()
    if name in ("num", "nan"):
        met = f"{'!' if name == 'num' else ''}PtxUnordered({a}, {b})"
    elif name in COMPARISONS:
        met = f"{a} {COMPARISONS[name]} {b}"
        if name == "ne" and is_floating(i):
            met = f"(!PtxUnordered({a}, {b}) && {met})"
    else:
        met = f"(PtxUnordered({a}, {b}) || {a} {COMPARISONS[name[:-1]]} {b})"
    if boolean:
        sign = {"and": "&&", "or": "||", "xor": "!="}[boolean]
        met = f"({met}) {sign} ({get(i.operands[3], 'pred')})"
    if "|" in i.operands[0]:
        raise i.unknown()
    return i.assign(met, "pred")


def translate_cvt(i):
    """Conversions."""
    to, source = i.types
    rounding = i.take("rni", "rzi", "rmi", "rpi", "rz", "rm", "rp") or "rn"
    saturate = i.take("sat")
    text = get(i.operands[1], source)
    if source in ("f32", "f64") and rounding.endswith("i"):
        function = {"rni": "std::nearbyint", "rzi": "std::trunc",
                    "rmi": "std::floor", "rpi": "std::ceil"}[rounding]
        text = f"{function}({text})"
        if to not in ("f32", "f64"):
            text = f"PtxWhole<{TYPES[to]}>({text})"
    elif rounding != "rn":
        raise i.unknown()
    if saturate:
        if to not in ("f32", "f64"):
            raise i.unknown()
        text = f"PtxSaturate({TYPES[to]}({text}))"
    return i.assign(text, to)


def translate_load(i):
    """ld, of one value or of several."""
    vector = i.take("v2", "v4")
    place = address(i.operands[1])
    code = [f"const uint64_t at = {place};"]
    for k, register in enumerate(members(i.operands[0])):
        code.append(f"PtxSet({identifier(register)}, "
                    f"PtxLoad<{TYPES[i.type]}>(at, {k}));")
    if vector is None and i.operands[0][0] == "{":
        raise i.unknown()
    return i.finish("{ " + " ".join(code) + " }")


def translate_store(i):
    """st, of one value or of several."""
    i.take("v2", "v4")
    code = [f"const uint64_t at = {address(i.operands[0])};"]
    for k, register in enumerate(members(i.operands[1])):
        code.append(f"PtxStore(at, {k}, {get(register, i.type)});")
    return i.finish("{ " + " ".join(code) + " }")


def translate_mov(i):
    """mov; of several registers it packs them into one, or unpacks it."""
    target, source = i.operands
    if target[0] == "{":
        halves = members(target)
        shift = int(i.type[1:]) // len(halves)
        code = [f"const uint64_t all = PtxGet<uint64_t>({value(source)});"]
        code += [f"PtxSet({identifier(r)}, "
                 f"uint{shift}_t(all >> {shift * k}));"
                 for k, r in enumerate(halves) if r != "_"]
        return i.finish("{ " + " ".join(code) + " }")
    if source[0] == "{":
        halves = members(source)
        shift = int(i.type[1:]) // len(halves)
        text = " | ".join(
            f"uint64_t(PtxGet<uint{shift}_t>({value(r)})) << {shift * k}"
            for k, r in enumerate(halves))
        return i.assign(text)
    return i.assign(get(source, i.type))


def translate_shift(i):
    """shl and shr: amounts past the width leave nothing."""
    function = {"shl": "PtxShiftLeft", "shr": "PtxShiftRight"}[i.name]
    return i.assign(f"{function}({get(i.operands[1], i.type)}, "
                    f"{get(i.operands[2], 'u32')})")


def translate_funnel(i):
    """shf: 32 bits out of 64."""
    side, mode = i.take("l", "r"), i.take("wrap", "clamp")
    low, high = (get(o, "u32") for o in i.operands[1:3])
    amount = get(i.operands[3], "u32")
    if mode is None or side is None:
        raise i.unknown()
    amount = f"({amount} & 31)" if mode == "wrap" else f"PtxMin({amount}, 32u)"
    both = f"(uint64_t({high}) << 32 | {low})"
    text = (f"{both} << {amount} >> 32" if side == "l"
            else f"{both} >> {amount}")
    return i.assign(f"uint32_t({text})")


def translate_fields(i):
    """bfe, bfi, prmt and selp."""
    names = {"bfi": "PtxInsert", "bfe": "PtxExtract", "prmt": "PtxPermute"}
    kinds = {"bfi": (i.type, i.type, "u32", "u32"),
             "bfe": (i.type, "u32", "u32"), "prmt": ("b32",) * 3}
    if i.name == "selp":
        a, b = (get(o, i.type) for o in i.operands[1:3])
        return i.assign(f"{get(i.operands[3], 'pred')} ? {a} : {b}")
    values = [get(o, k) for o, k in zip(i.operands[1:], kinds[i.name])]
    return i.assign(f"{names[i.name]}({', '.join(values)})")


def translate_toward_zero(i):
    """add, mul and fma rounded toward zero."""
    i.take("rz")
    values = [get(o, i.type) for o in i.operands[1:]]
    function = {"add": "PtxAddRz", "mul": "PtxMulRz",
                "fma": "PtxFmaRz"}.get(i.name)
    if function is None:
        raise i.unknown()
    return i.assign(f"{function}({', '.join(values)})")


def translate_testp(i):
    """testp: what kind of number it is."""
    name = i.take("finite", "infinite", "number", "notanumber")
    text = get(i.operands[1], i.type)
    functions = {"finite": "std::isfinite", "infinite": "std::isinf",
                 "number": "!std::isnan", "notanumber": "std::isnan"}
    if name is None:
        raise i.unknown()
    return i.assign(f"{functions[name]}({text})", "pred")


def translate_bfind(i):
    """bfind of an unsigned number: its highest bit, or the shift to it."""
    function = "PtxLeading" if i.take("shiftamt") else "PtxHighest"
    if i.type not in ("u32", "u64"):
        raise i.unknown()
    return i.assign(f"{function}({get(i.operands[1], i.type)})", "u32")


def translate_branch(i):
    return i.finish(f"goto {identifier(i.operands[0])};")


def translate_call(i):
    """call (result), function, (arguments): all are pointers to bytes."""
    operands, result = i.operands, []
    if operands[0][0] == "(":
        result = split_operands(operands[0][1:-1])
        operands = operands[1:]
    arguments = split_operands(operands[1][1:-1]) if len(operands) > 1 else []
    text = ", ".join(identifier(a) for a in result + arguments)
    return i.finish(f"{function_name(operands[0])}({text});")


def translate_return(i):
    return i.finish("return;")


SPECIFIC = {
    "setp": translate_setp, "cvt": translate_cvt, "ld": translate_load,
    "st": translate_store, "mov": translate_mov, "shl": translate_shift,
    "shr": translate_shift, "shf": translate_funnel, "bra": translate_branch,
    "call": translate_call, "ret": translate_return,
    "exit": translate_return, "testp": translate_testp,
    "bfind": translate_bfind,
    **{name: translate_fields for name in ("bfe", "bfi", "prmt", "selp")},
}


def translate_instruction(text):
    """One instruction, with its guard, as a C++ statement."""
    guard = re.match(r"@(!?)(%\w+)\s+(.*)$", text, re.S)
    if guard:
        inner = translate_instruction(guard[3])
        return f"if ({guard[1]}{identifier(guard[2])}) {inner}"
    i = Instruction(text)
    if i.name in SPECIFIC:
        return SPECIFIC[i.name](i)
    if is_floating(i) and "rz" in i.rest:
        return translate_toward_zero(i)
    if is_floating(i) and i.name in FLOATING:
        return i.fill(FLOATING[i.name])
    if i.name in ("mul", "mad"):
        return translate_multiply(i)
    if i.name in ("popc", "clz"):
        return i.assign(re.sub("%0", get(i.operands[1], i.type),
                               PLAIN[i.name]), "u32")
    if not is_floating(i) and i.name in WHOLE:
        return i.fill(WHOLE[i.name])
    if i.name in PLAIN:
        return i.fill(PLAIN[i.name])
    raise i.unknown()
