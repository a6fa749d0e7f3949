"""All tables of a report, in the order in which they are read."""

from report import study
from report.tables import (circumstances, decomposition, flip, measures,
                           overview, temporal, times)


def build(results):
    """The tables that the records have figures for."""
    found = []
    for one in study.studies(results):
        if one.first:
            found.append(overview.overview(one))
        found += [flip.by_scene(one), flip.summary(one), flip.by_time(one),
                  *measures.by_scene(one), measures.ratios(one),
                  measures.agreement(one), measures.agreement_by_scene(one),
                  times.stages(one), times.frames(one), times.rays(one),
                  decomposition.gap(one), decomposition.terms(one),
                  decomposition.shares(one), decomposition.distances(one),
                  decomposition.inner(one)]
    found += [temporal.flicker(results), temporal.effect(results),
              temporal.live(results), circumstances.programs(results),
              circumstances.references(results),
              circumstances.failures(results)]
    return [table for table in found if table]
