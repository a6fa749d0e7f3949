"""Moving scenes: flicker with and without `temporal`, and the live mode."""

from report import provenance
from report.labels import EXTERNAL
from report.table import Column, Table, figure, number, spec, word

MEASURES = {
    "tde": ("TDE", lambda v: number(v, 4)),
    "t_flip": ("t-FLIP", lambda v: number(v, 4)),
    "warp_error": ("warp error", lambda v: number(v, 4)),
    "churn": ("churn", lambda v: number(v, 3)),
    "static_flicker": ("static flicker", lambda v: number(v, 3)),
    "static_flicker_rms": ("its RMS", lambda v: number(v, 4)),
    "bytes_per_frame": ("bytes a frame", lambda v: number(v, 0))}


def split_spec(spec):
    """(the SPEC without its `temporal`, the value of that or None).

    A value in quotes may hold colons, and `external:` takes all the rest.
    """
    if spec.startswith(EXTERNAL):
        return spec, None
    parts = [""]
    quoted = False
    for letter in spec:
        quoted ^= letter == "'"
        if letter == ":" and not quoted:
            parts.append("")
        else:
            parts[-1] += letter
    given = [part for part in parts if part.startswith("temporal=")]
    kept = ":".join(part for part in parts if part not in given)
    value = given[0].split("=", 1)[1] if given else "0"
    return kept, None if value == "0" else value


def runs_of(results):
    """Temporal runs, without `temporal` before with."""
    runs = [run for run in results.of("temporal") if run.value("temporal")]
    return sorted(runs, key=lambda r: (r.scene, r.data["grid"],
                                       split_spec(r.encoder)[0],
                                       split_spec(r.encoder)[1] or ""))


def caption(lead, runs):
    frames = sorted({run.value("temporal", "frames") for run in runs})
    ppd = sorted({f"{run.settings['ppd']:g}" for run in runs})
    rasters = sorted({f"{w} x {h}" for w, h in
                      (run.data["raster"] for run in runs)})
    spp = sorted({run.settings["spp"] for run in runs})
    return (f"{lead} n = {len({run.scene for run in runs})} moving scenes of "
            f"{', '.join(map(str, frames))} frames, "
            f"{', '.join(map(str, spp))} rays a sample; FLIP at "
            f"{', '.join(ppd)} PPD on a raster of {', '.join(rasters)}; "
            f"{provenance.origin([run.record for run in runs])}.")


def flicker(results):
    runs = runs_of(results)
    table = Table(
        "temporal", "Temporal quality of moving scenes", caption(
            "All lower is better. TDE: mean difference of the frame-to-frame "
            "change from the reference's; t-FLIP: the same of FLIP between "
            "frames; warp error: along the exact motion vectors, less the "
            "reference's own; churn: share of cells that change; static "
            "flicker: share of cells that change, and the RMS change, when "
            "only the seed does.", runs),
        [Column("scene", left=True), Column("grid"),
         Column("encoder", left=True), Column("temporal")]
        + [Column(heading) for heading, _ in MEASURES.values()])
    for run in runs:
        encoder, temporal = split_spec(run.encoder)
        table.rows.append(
            [word(run.scene), word("{} x {}".format(*run.data["grid"])),
             spec(encoder, results.names), word(temporal or "off")]
            + [show(run.value("temporal", name))
               for name, (_, show) in MEASURES.items()])
    return table


def paired(results):
    """[(run without, run with)] of the same work but for `temporal`."""
    without = {}
    for run in runs_of(results):
        encoder, temporal = split_spec(run.encoder)
        if temporal is None:
            without[run.setting, run.scene, run.seed, encoder] = run
    pairs = []
    for run in runs_of(results):
        encoder, temporal = split_spec(run.encoder)
        base = without.get((run.setting, run.scene, run.seed, encoder))
        if temporal is not None and base:
            pairs.append((base, run))
    return pairs


def effect(results):
    """What `temporal` changes: with over without, pair by pair."""
    pairs = paired(results)
    runs = [run for pair in pairs for run in pair]
    table = Table(
        "temporal-effect", "What temporal= changes",
        caption("Each measure with `temporal` over the same without; below "
                "1 is calmer.", runs),
        [Column("scene", left=True), Column("encoder", left=True),
         Column("temporal")]
        + [Column(heading) for heading, _ in MEASURES.values()])
    for base, run in pairs:
        encoder, temporal = split_spec(run.encoder)
        row = [word(run.scene), spec(encoder, results.names), word(temporal)]
        for name in MEASURES:
            before, after = (r.value("temporal", name) for r in (base, run))
            known = before is not None and after is not None and before > 0
            row.append(figure(after / before if known else None))
        table.rows.append(row)
    return table


def live(results):
    """The live mode without a terminal."""
    runs = [run for run in results.of("live") if run.value("ms", "live")]
    found = [(run, run.value("ms", "live")) for run in runs]
    table = Table(
        "live", "Live mode",
        "Frames a second and milliseconds a frame of the live mode; "
        + provenance.origin([run.record for run in runs]) + ".",
        [Column("scene", left=True), Column("encoder", left=True),
         Column("grid"), Column("present", left=True), Column("frames / s"),
         Column("p50 ms"), Column("p95 ms"), Column("p99 ms"),
         Column("bytes a frame"), Column("cells a frame")])
    for run, values in sorted(found, key=lambda f: (f[0].scene,
                                                    f[0].encoder)):
        frame = values.get("frame_ms", {})
        table.rows.append(
            [word(run.scene), spec(run.encoder, results.names),
             word("{} x {}".format(*run.data["grid"])),
             word(values.get("present", "–")), figure(values.get("fps"))]
            + [figure(frame.get(p)) for p in ("p50", "p95", "p99")]
            + [number(values.get(name), 0)
               for name in ("bytes_per_frame", "cells_per_frame")])
    return table
