"""Short names of encoders: a command line of another program is long."""

import shlex

EXTERNAL = "external:"


def short(spec):
    """`external:` and the program alone; another SPEC as it is."""
    if not spec.startswith(EXTERNAL):
        return spec
    try:
        words = shlex.split(spec[len(EXTERNAL):])
    except ValueError:
        words = spec[len(EXTERNAL):].split()
    return EXTERNAL + words[0].rsplit("/", 1)[-1] if words else spec


def unique(specs):
    """{spec: label}; labels that would be equal are numbered."""
    labels, seen = {}, {}
    for spec in specs:
        label = short(spec)
        seen[label] = seen.get(label, 0) + 1
        labels[spec] = (label if seen[label] == 1
                        else f"{label} ({seen[label]})")
    return labels


def wrapped(label, width=24):
    """A long SPEC over several lines, broken before parameters."""
    lines = [""]
    for index, part in enumerate(label.split(":")):
        text = part if index == 0 else ":" + part
        if lines[-1] and len(lines[-1]) + len(text) > width:
            lines.append("")
        lines[-1] += text
    return "\n".join(lines)
