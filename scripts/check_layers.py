#!/usr/bin/python3
"""Checks that the sources keep to the architecture's layers.

    scripts/check_layers.py [--root=FOLDER]

Every line of output is one violation, as file:line: what. Exit status 1 when
there are any. The rules are the tables below; docs/architecture.md explains
them.
"""

import argparse
import re
import sys
from pathlib import Path

# A top folder may include from itself and from these.
TOP = {
    "core": [],
    "encoders": ["core"],
    "reference": ["core"],
    "harness": ["core", "encoders", "reference"],
    "tests": ["core", "encoders", "reference", "harness"],
}

# Inside core, a folder may include from itself and from those before it.
CORE = ["base", "math", "color", "image", "scene", "accel", "shading",
        "render", "cuda"]

# Libraries that one folder alone may see: pattern of the header, folder. A name
# without a slash stands for every folder of that name.
PRIVATE = [
    (re.compile(r"(cuda|curand|thrust/|cub/|nvtx|device_launch)"),
     "cuda"),
    (re.compile(r"(ncursesw?/|ncurses|curses|term\.h|panel\.h)"),
     "harness/live"),
    (re.compile(r"embree\d*/"), "core/accel"),
]

# Printing and exiting is for these alone.
SPEAKERS = ("harness/commands/", "harness/main.cc")
# The last words of a failed check, said on the way to abort().
SPEAKING_EXCEPTIONS = ("core/base/check.cc",)
SPEECH = re.compile(
    r"std::(cout|cerr|clog|exit|quick_exit)\b"
    r"|(?<![\w.>])(printf|puts|putchar|exit|perror)\s*\("
    r"|\b(fprintf|fputs|fwrite|fputc)\s*\([^;]*\b(stdout|stderr)\b")

SUFFIXES = {".h", ".cc", ".cu", ".cuh", ".inc"}
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
# Comments, raw strings, strings and characters: what is not code. A digit
# before a quote makes it a separator, as in 1'000.
NOT_CODE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"'
    r'|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'', re.S)


def sources(root):
    """All source files below the top folders, by path from the root."""
    for top in TOP:
        for path in sorted((root / top).rglob("*")):
            if path.suffix in SUFFIXES and path.is_file():
                yield path.relative_to(root).as_posix()


def blank(match):
    """White space of the same number of lines; keeps string quotes."""
    return re.sub(r"[^\n]", " ", match.group(0))


def includes(text):
    """(line number, quote, name) of each #include."""
    for number, line in enumerate(text.split("\n"), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1), match.group(2)


def layer_error(source, target):
    """Why `source` may not include `target`, or None."""
    top, other = source.split("/")[0], target.split("/")[0]
    if other != top and other not in TOP[top]:
        return f"{top} may not include {target}"
    if top != "core":
        return None
    mine, theirs = source.split("/")[1], target.split("/")[1]
    for folder in (mine, theirs):
        if folder not in CORE:
            return f"core/{folder} is not in the order of core's folders"
    if CORE.index(theirs) > CORE.index(mine):
        return f"core/{mine} may not include {target}: {theirs} comes later"
    return None


def inside(source, folder):
    """Whether a source stands in that folder, or in one of that name."""
    if "/" in folder:
        return source.startswith(folder + "/")
    return folder in source.split("/")[:-1]


def private_error(source, header):
    """Why `source` may not see a library's header, or None."""
    if source.startswith("tests/"):
        return None
    for pattern, folder in PRIVATE:
        if pattern.match(header) and not inside(source, folder):
            return f"only {folder} may include {header}"
    return None


def include_errors(root, source, text):
    """Violations of one file's includes, as (line, what)."""
    for line, quote, name in includes(text):
        own = name.split("/")[0] in TOP
        if quote == "<" and own:
            yield line, f"write \"{name}\": it is ours"
        elif quote == "<":
            error = private_error(source, name)
            if error:
                yield line, error
        elif own and (root / name).is_file():
            error = layer_error(source, name)
            if error:
                yield line, error
        elif own or "/" in name or not generated(root, name):
            # Libraries' headers come in <>, ours from the root.
            yield line, f"{name} is no file, seen from the root"


def generated(root, name):
    """Whether the build writes this include, which cmake/ then names."""
    return any(name in path.read_text() for path in
               sorted((root / "cmake").glob("*.cmake")))


def speech_errors(source, text):
    """Printing and exiting outside the commands, as (line, what)."""
    if (source.startswith("tests/") or source.startswith(SPEAKERS)
            or source in SPEAKING_EXCEPTIONS):
        return
    code = NOT_CODE.sub(blank, text)
    for match in SPEECH.finditer(code):
        line = code.count("\n", 0, match.start()) + 1
        yield line, (f"`{match.group(0).split('(')[0].strip()}`: "
                     "only harness/commands prints or exits")


def cycle_errors(graph):
    """(file, line, what) of each include that closes a cycle."""
    state, stack = {}, []

    def visit(node):
        state[node] = "open"
        stack.append(node)
        for line, target in graph.get(node, []):
            if state.get(target) == "open":
                cycle = stack[stack.index(target):] + [target]
                yield node, line, "include cycle: " + " -> ".join(cycle)
            elif target not in state:
                yield from visit(target)
        stack.pop()
        state[node] = "done"

    for node in sorted(graph):
        if node not in state:
            yield from visit(node)


def check(root):
    """All violations below `root`, as lines of text, and the file count."""
    errors, graph = [], {}
    for source in sources(root):
        text = (root / source).read_text(encoding="utf-8")
        graph[source] = [(line, name) for line, quote, name in includes(text)
                         if quote == '"' and (root / name).is_file()]
        if (Path(source).suffix in {".cu", ".cuh"}
                and not source.startswith("tests/")
                and not inside(source, "cuda")):
            errors.append((source, 1,
                           "CUDA sources stand in folders named cuda"))
        for line, what in include_errors(root, source, text):
            errors.append((source, line, what))
        for line, what in speech_errors(source, text):
            errors.append((source, line, what))
    errors.extend(cycle_errors(graph))
    return [f"{name}:{line}: {what}" for name, line, what in sorted(errors)
            ], len(graph)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--root", type=Path,
                        default=Path(__file__).resolve().parent.parent)
    errors, count = check(parser.parse_args().root)
    for error in errors:
        print(error)
    if count == 0:
        print("no sources found")
    print(f"check_layers: {count} files, {len(errors)} violations",
          file=sys.stderr)
    return 1 if errors or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
