"""The statistics of the protocol, each by SciPy where SciPy has it.

The unit of replication is the scene: every function takes one value a scene.
"""

import functools

import numpy
import scipy.stats

RESAMPLES = 10_000
SEED = 20_180_611
CONFIDENCE = 0.95
# FLIP values nearer than this are a tie.
FLIP_TIE = 0.005
# Up to here the sign-flip test goes through all 2^n signs.
EXACT_UP_TO = 20


def mean_interval(values):
    """The 95 % BCa bootstrap interval of the mean (Efron 1987), or Nones.

    Too few values have none; equal values have an interval of no width.
    """
    values = numpy.asarray(values, float)
    if len(values) < 3:
        return None, None
    # Equal but for rounding: BCa would divide by what rounding left.
    if numpy.ptp(values) <= 1e-12 * numpy.abs(values).max():
        mean = float(values.mean())
        return mean, mean
    found = scipy.stats.bootstrap(
        (values,), numpy.mean, n_resamples=RESAMPLES, method="BCa",
        confidence_level=CONFIDENCE, random_state=SEED).confidence_interval
    if not numpy.isfinite([found.low, found.high]).all():
        return None, None
    return float(found.low), float(found.high)


def sign_flip_p(differences):
    """The two-sided p of the sign-flip permutation test of a mean of 0.

    Exact for up to 20 values; above that over 2^17 random sign vectors with
    the observed one counted among them (Phipson and Smyth 2010).
    """
    values = numpy.asarray(differences, float)
    if len(values) == 0:
        return None
    observed = abs(values.sum())
    least = observed - 1e-12 * numpy.abs(values).sum()
    if len(values) <= EXACT_UP_TO:
        sums = numpy.zeros(1)
        for value in values:
            sums = numpy.concatenate([sums - value, sums + value])
        return float(numpy.mean(numpy.abs(sums) >= least))
    random = numpy.random.default_rng(SEED)
    count = 1 << 17
    signs = random.integers(0, 2, (count, len(values)), numpy.int8) * 2 - 1
    beyond = numpy.count_nonzero(numpy.abs(signs @ values) >= least)
    return float((beyond + 1) / (count + 1))


def holm(p_values):
    """Holm's adjusted p values (Holm 1979), in the order given."""
    order = numpy.argsort(p_values, kind="stable")
    adjusted = [0.0] * len(p_values)
    least = 0.0
    for rank, index in enumerate(order):
        least = max(least, (len(p_values) - rank) * p_values[index])
        adjusted[index] = min(1.0, least)
    return adjusted


def wins_ties_losses(differences, tie):
    """How many differences are below -tie, within it, and above it."""
    wins = sum(d < -tie for d in differences)
    losses = sum(d > tie for d in differences)
    return wins, len(differences) - wins - losses, losses


def friedman(blocks):
    """(chi-square, p, mean ranks) of blocks x treatments, lower = rank 1.

    None for less than three treatments or two blocks.
    """
    blocks = numpy.asarray(blocks, float)
    if blocks.ndim != 2 or blocks.shape[0] < 2 or blocks.shape[1] < 3:
        return None
    ranks = scipy.stats.rankdata(blocks, axis=1).mean(axis=0)
    if numpy.all(numpy.ptp(blocks, axis=1) == 0):
        return 0.0, 1.0, ranks.tolist()
    chi_square, p = scipy.stats.friedmanchisquare(*blocks.T)
    return float(chi_square), float(p), ranks.tolist()


def tau_b(first, second):
    """Kendall's tau-b, or None where one of the two is constant."""
    if len(first) < 2 or numpy.ptp(first) == 0 or numpy.ptp(second) == 0:
        return None
    return float(scipy.stats.kendalltau(first, second).correlation)


@functools.lru_cache(maxsize=None)
def resample_indices(count):
    random = numpy.random.default_rng(SEED)
    return random.integers(0, count, (RESAMPLES, count))


def median_interval(samples):
    """The 95 % percentile bootstrap interval of the median."""
    samples = numpy.asarray(samples, float)
    medians = numpy.median(samples[resample_indices(len(samples))], axis=1)
    tail = 50 * (1 - CONFIDENCE)
    low, high = numpy.percentile(medians, [tail, 100 - tail])
    return float(low), float(high)


def pareto_front(points):
    """The indices of the points that no other beats in both coordinates.

    Lower is better in both; in the order of the first coordinate. Of equal
    points the first alone is kept.
    """
    order = sorted(range(len(points)), key=lambda i: (points[i], i))
    front, least = [], float("inf")
    for index in order:
        if points[index][1] < least:
            front.append(index)
            least = points[index][1]
    return front
