#!/usr/bin/python3
"""The report's statistics against values derived by hand and by SciPy."""

import unittest

from report_case import ReportTest, need

need()

import numpy
import scipy.stats

from report import statistics


class StatisticsTest(ReportTest):

    def test_sign_flip_is_exact(self):
        # Of the 8 sign vectors of 1, 2, 3 only +++ and --- reach |sum| = 6.
        self.assertEqual(statistics.sign_flip_p([1, 2, 3]), 2 / 8)
        # -1, 2, 3: |sum| = 4 is reached by +-(1+2+3), +-(-1+2+3).
        self.assertEqual(statistics.sign_flip_p([-1, 2, 3]), 4 / 8)
        # Equal magnitudes: rounding must not lose the ties.
        self.assertEqual(statistics.sign_flip_p([0.1] * 10), 2 / 1024)
        self.assertEqual(statistics.sign_flip_p([0, 0, 0]), 1)
        self.assertIsNone(statistics.sign_flip_p([]))

    def test_sign_flip_is_scipys(self):
        values = numpy.random.default_rng(1).normal(0.3, 1, 12)
        expected = scipy.stats.permutation_test(
            (values,), numpy.mean, permutation_type="samples",
            n_resamples=numpy.inf).pvalue
        self.assert_close(statistics.sign_flip_p(values), expected)

    def test_many_values_are_sampled(self):
        values = numpy.random.default_rng(2).normal(0.4, 1, 25)
        sampled = statistics.sign_flip_p(values)
        # The normal approximation of the same test.
        z = values.sum() / numpy.sqrt((values ** 2).sum())
        self.assert_close(sampled, 2 * scipy.stats.norm.sf(abs(z)), 0.02)
        self.assertEqual(sampled, statistics.sign_flip_p(values))

    def test_holm(self):
        # Sorted 0.01, 0.02, 0.03, 0.04 times 4, 3, 2, 1, never decreasing:
        # 0.04, 0.06, max(0.06, 0.06), max(0.06, 0.04).
        found = statistics.holm([0.04, 0.01, 0.03, 0.02])
        for value, expected in zip(found, [0.06, 0.04, 0.06, 0.06]):
            self.assert_close(value, expected)
        self.assertEqual(statistics.holm([0.9, 0.8]), [1.0, 1.0])
        self.assertEqual(statistics.holm([]), [])

    def test_mean_interval_is_scipys_bca(self):
        values = [0.01, 0.02, -0.01, 0.05, 0.03, 0.2, 0.01]
        low, high = statistics.mean_interval(values)
        expected = scipy.stats.bootstrap(
            (values,), numpy.mean, n_resamples=10_000, method="BCa",
            random_state=statistics.SEED).confidence_interval
        self.assertEqual((low, high), (expected.low, expected.high))
        # The outlier makes BCa's interval reach further up than down.
        mean = numpy.mean(values)
        self.assertGreater(high - mean, mean - low)

    def test_mean_interval_of_few_or_equal_values(self):
        self.assertEqual(statistics.mean_interval([1, 2]), (None, None))
        self.assertEqual(statistics.mean_interval([3, 3, 3]), (3, 3))

    def test_wins_ties_losses(self):
        # At the very border of the tie it is one.
        self.assertEqual(statistics.wins_ties_losses(
            [-0.006, -0.005, 0, 0.005, 0.0051], 0.005), (1, 3, 1))

    def test_friedman(self):
        # Three blocks that agree on 1, 2, 3: chi-square = b (k - 1) = 6 with
        # b = 3, k = 3; its p for 2 degrees of freedom is exp(-3).
        chi_square, p, ranks = statistics.friedman(
            [[1, 2, 3], [10, 20, 30], [0.1, 0.2, 0.3]])
        self.assert_close(chi_square, 6)
        self.assert_close(p, numpy.exp(-3))
        self.assertEqual(ranks, [1, 2, 3])
        self.assertIsNone(statistics.friedman([[1, 2]]))
        self.assertEqual(statistics.friedman([[1, 1, 1]] * 2)[:2], (0, 1))

    def test_tau_b(self):
        # Of 6 pairs 5 agree and 1 does not: (5 - 1) / 6.
        self.assert_close(statistics.tau_b([1, 2, 3, 4], [1, 2, 4, 3]), 4 / 6)
        # A tie in one: 2 agreeing pairs of 3, / sqrt(3 * 2).
        self.assert_close(statistics.tau_b([1, 2, 3], [1, 1, 2]),
                          2 / 6 ** 0.5)
        self.assertIsNone(statistics.tau_b([1, 1], [1, 2]))

    def test_median_interval(self):
        low, high = statistics.median_interval([5.0] * 10)
        self.assertEqual((low, high), (5, 5))
        low, high = statistics.median_interval(list(range(30)))
        self.assertLess(low, 14.5)
        self.assertGreater(high, 14.5)
        # About the order statistics 10 and 21 of the exact interval.
        self.assertTrue(8 <= low <= 11 and 18 <= high <= 21, (low, high))

    def test_pareto_front(self):
        points = [(3, 1), (1, 3), (2, 3), (2, 2), (3, 1), (4, 1.5)]
        self.assertEqual(statistics.pareto_front(points), [1, 3, 0])
        self.assertEqual(statistics.pareto_front([]), [])


if __name__ == "__main__":
    unittest.main()
