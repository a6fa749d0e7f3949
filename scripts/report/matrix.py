"""One figure for each encoder and scene: seeds and times averaged first."""

from dataclasses import dataclass

import numpy

from report import statistics

STAGES = ("load", "build", "plan", "render", "encode", "decode", "emit")
# What a frame of an animation takes; the scene is loaded once, and decoding
# is for scores alone.
FRAME_STAGES = ("plan", "render", "encode")
# What summing in another order may put a run below its bound.
BOUND_TOLERANCE = 1e-6
CONTROLS = ("half", "tiv")


@dataclass
class Matrix:
    """values[encoder][scene]; encoders in the order of tables."""
    encoders: list
    scenes: list
    values: dict

    def get(self, encoder, scene):
        return self.values.get(encoder, {}).get(scene)

    def row(self, encoder):
        """The encoder's values where it has any, by scene."""
        return [self.get(encoder, scene) for scene in self.scenes
                if self.get(encoder, scene) is not None]

    def pairs(self, encoder, other):
        """(encoder's, other's) values of the scenes that both have."""
        both = [(self.get(encoder, s), self.get(other, s))
                for s in self.scenes]
        return [pair for pair in both if None not in pair]

    def best(self, scene):
        found = [self.get(e, scene) for e in self.encoders]
        return min((v for v in found if v is not None), default=None)

    def on(self, scenes):
        """The same on those of its scenes alone."""
        return Matrix(self.encoders, [s for s in self.scenes if s in scenes],
                      self.values)

    def complete(self):
        """The encoders that have a value for every scene."""
        return [encoder for encoder in self.encoders
                if len(self.row(encoder)) == len(self.scenes)]

    def blocks(self):
        """scenes x complete encoders."""
        return [[self.get(e, s) for e in self.complete()]
                for s in self.scenes]

    def mean(self, encoder):
        return float(numpy.mean(self.row(encoder)))

    def geometric_mean(self, encoder):
        row = self.row(encoder)
        if not row or min(row) <= 0:
            return None
        return float(numpy.exp(numpy.mean(numpy.log(row))))

    def __bool__(self):
        return bool(self.encoders)


def shared_times(times):
    """The times that all of {encoder: set of times} have in common.

    Where there is none, the one time that most encoders have.
    """
    shared = set.intersection(*times.values())
    if shared:
        return shared
    every = sorted(set.union(*times.values()))
    return {max(every, key=lambda t: sum(t in own for own in times.values()))}


def build(runs, value):
    """The matrix of value(run) over runs; runs without a value are left out.

    Seeds of one time are averaged, then the times of one scene that all its
    encoders have: differences are between the same frames.
    """
    found, rays = {}, {}
    for run in runs:
        figure = value(run)
        if figure is None:
            continue
        scene = found.setdefault(run.scene, {})
        own = scene.setdefault(run.encoder, {})
        own.setdefault(run.time, []).append(figure)
        rays.setdefault(run.encoder, []).append(
            run.value("rays_per_cell") or 0)
    values = {}
    for scene, encoders in found.items():
        times = shared_times({e: set(own) for e, own in encoders.items()})
        for encoder, own in encoders.items():
            means = [numpy.mean(own[time]) for time in times if time in own]
            if means:
                row = values.setdefault(encoder, {})
                row[scene] = float(numpy.mean(means))
    # By what they cost, so that a table reads from cheap to dear.
    encoders = sorted(values, key=lambda e: (round(numpy.mean(rays[e]), 1), e))
    return Matrix(encoders, sorted(found), values)


def metric(name):
    return lambda run: run.value("metrics", name)


def frame_samples(run, kind="samples"):
    """The milliseconds of each timed frame, or None; cpu_samples: CPU time."""
    stages = [run.value("ms", stage, kind) for stage in FRAME_STAGES]
    if stages[1] is None or stages[2] is None:
        return None
    stages = [samples for samples in stages if samples]
    if len({len(samples) for samples in stages}) != 1:
        return None
    # Sample i of every stage was taken in the same frame.
    return [sum(frame) for frame in zip(*stages)]


def frame_ms(run):
    samples = frame_samples(run)
    return None if samples is None else float(numpy.median(samples))


def gap(run):
    return run.value("bound", "gap")


def below_bound(run):
    """Whether a run beats what no encoder can beat: a measuring error."""
    found = gap(run)
    return found is not None and found < 1 - BOUND_TOLERANCE


@dataclass
class Comparison:
    """An encoder against a control: encoder - control, or the ratio."""
    encoder: str
    control: str
    n: int
    mean: float
    low: float
    high: float
    p: float
    wins: int
    ties: int
    losses: int
    p_holm: float = None


def compare(matrix, encoder, control, tie=statistics.FLIP_TIE):
    """The paired difference over scenes, or None without common scenes."""
    pairs = matrix.pairs(encoder, control)
    if not pairs:
        return None
    differences = [a - b for a, b in pairs]
    low, high = statistics.mean_interval(differences)
    return Comparison(
        encoder, control, len(pairs), float(numpy.mean(differences)), low,
        high, statistics.sign_flip_p(differences),
        *statistics.wins_ties_losses(differences, tie))


def compare_ratio(matrix, encoder, control):
    """The same on logarithms: mean, low and high are ratios."""
    pairs = [p for p in matrix.pairs(encoder, control) if min(p) > 0]
    if not pairs:
        return None
    logs = [float(numpy.log(a / b)) for a, b in pairs]
    low, high = statistics.mean_interval(logs)
    exp = lambda x: None if x is None else float(numpy.exp(x))
    return Comparison(
        encoder, control, len(pairs), exp(numpy.mean(logs)), exp(low),
        exp(high), statistics.sign_flip_p(logs),
        *statistics.wins_ties_losses(logs, 1e-9))


def against_controls(matrix):
    """{(encoder, control): Comparison} with Holm's p over all of them.

    tiv against half is one pair, wherever it is shown.
    """
    found = {}
    for control in CONTROLS:
        for encoder in matrix.encoders:
            if encoder == control or (control, encoder) in found:
                continue
            comparison = compare(matrix, encoder, control)
            if comparison:
                found[encoder, control] = comparison
    adjusted = statistics.holm([c.p for c in found.values()])
    for comparison, p in zip(found.values(), adjusted):
        comparison.p_holm = p
    return found
