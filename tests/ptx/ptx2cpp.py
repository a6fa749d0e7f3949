#!/usr/bin/python3
"""Translates PTX into C++ that runs on the CPU.

    ptx2cpp.py INPUT.ptx > OUTPUT.cc

Every function F of the input becomes a C++ function ptx_F that takes pointers
to its parameters (and first, if it returns anything, to the result).
Registers are unsigned integers of their width; what each instruction makes of
them says its type, as in PTX itself. Addresses of all state spaces are the
host's. ptx_machine.h holds what instructions do, and the thread's indices.

What is not known - barriers, atomics, warp intrinsics among it - is an error
that names the instruction, exit status 1. The meaning of each instruction is
that of "Parallel Thread Execution ISA", sections 9.7.1 to 9.7.13, but for
`.approx` ones, which are computed to full precision here.
"""

import re
import sys

from ptx_instructions import translate_instruction
from ptx_operands import (PtxError, function_name, identifier,
                          split_operands)

REGISTERS = {"pred": "bool", "b16": "uint16_t", "b32": "uint32_t",
             "b64": "uint64_t", "f32": "uint32_t", "f64": "uint64_t",
             "u16": "uint16_t", "u32": "uint32_t", "u64": "uint64_t",
             "s16": "uint16_t", "s32": "uint32_t", "s64": "uint64_t"}


def translate_declaration(text):
    """A directive inside a function as C++."""
    match = re.match(r"\.reg\s+\.(\w+)\s+(.*)$", text, re.S)
    if match:
        names = []
        for name in split_operands(match[2]):
            counted = re.fullmatch(r"%([a-z]+)<(\d+)>", name)
            names.append(f"R_{counted[1]}[{counted[2]}]" if counted
                         else identifier(name))
        text = ", ".join(names)
        return f"{REGISTERS[match[1]]} {text};"
    match = re.match(r"\.(?:param|local)\s+(?:\.align\s+\d+\s+)?\.(\w+)\s+"
                     r"([\w$]+)(?:\[(\d+)\])?$", text)
    if match:
        size = (int(match[3] or 1) * 8 if match[1] == "b64" or not match[3]
                else int(match[3]) * (int(match[1][1:]) // 8))
        return f"alignas(16) unsigned char {identifier(match[2])}[{size}];"
    if re.match(r"\.(loc|pragma|file)\b", text):
        return ""
    raise PtxError(f"directive `{text}`")


def translate_body(body):
    """The statements of a function."""
    lines = []
    for label, brace, statement in re.findall(
            r"\s*(?:([\w$]+):(?!:)|([{}])"
            r"|([^;{}]*(?:\{[^{}]*\}[^;{}]*)*);)", body):
        statement = statement.strip()
        if label:
            lines.append(f"{identifier(label)}:;")
        elif brace:
            lines.append(brace)
        elif statement.startswith("."):
            lines.append(translate_declaration(statement))
        elif statement:
            lines.append(translate_instruction(statement))
    return lines


def signature(name, result, parameters):
    """The C++ head of a function."""
    names = re.findall(r"\.param\s+(?:\.align\s+\d+\s+)?\.\w+\s+([\w$]+)",
                       (result or "") + "," + (parameters or ""))
    text = ", ".join(f"unsigned char* {identifier(n)}" for n in names)
    return f'extern "C" void {function_name(name)}({text})'


FUNCTION = re.compile(
    r"^(?:\.(?:visible|weak|extern)\s+)*\.(?:entry|func)\s*"
    r"(?:\((?P<result>[^)]*)\)\s*)?(?P<name>[\w$]+)\s*"
    r"\((?P<parameters>[^)]*)\)(?P<rest>[^;{]*)(?P<end>[;{])", re.M)
TABLE = re.compile(
    r"^(?:\.(?:visible|weak)\s+)*\.(?:global|const)\s+\.align\s+(\d+)\s+"
    r"\.b8\s+([\w$]+)\[(\d+)\](?:\s*=\s*\{([^}]*)\})?;", re.M)


def body_end(text, start):
    """Where the braces opened before `start` are closed."""
    depth = 1
    for match in re.finditer(r"[{}]", text[start:]):
        depth += 1 if match[0] == "{" else -1
        if depth == 0:
            return start + match.start()
    raise PtxError("a function without an end")


def translate(text):
    """A whole file as C++."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
    out = ['#include "tests/ptx/ptx_machine.h"', ""]
    for align, name, size, data in TABLE.findall(text):
        out.append(f"alignas({align}) static unsigned char "
                   f"{identifier(name)}[{size}] = {{{data}}};")
    heads, bodies = [], []
    for match in FUNCTION.finditer(text):
        head = signature(match["name"], match["result"], match["parameters"])
        if head not in heads:
            heads.append(head)
        if match["end"] == "{":
            body = text[match.end():body_end(text, match.end())]
            bodies.append("\n".join([head + " {", *translate_body(body), "}"]))
    if not bodies:
        raise PtxError("no function")
    return "\n".join(out + [head + ";" for head in heads] + bodies) + "\n"


def main():
    if len(sys.argv) != 2:
        print("usage: ptx2cpp.py INPUT.ptx > OUTPUT.cc", file=sys.stderr)
        return 2
    try:
        with open(sys.argv[1], encoding="utf-8") as source:
            sys.stdout.write(translate(source.read()))
    except PtxError as error:
        print(f"ptx2cpp.py: {sys.argv[1]}: unknown {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
