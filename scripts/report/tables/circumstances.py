"""Other programs with their versions, references, and what went wrong."""

from report import provenance
from report.table import Column, Table, code, number, word


def programs(results):
    """Encoders that are another program or library, with its version."""
    scenes = {}
    for run in results.runs:
        version = run.value("encoder_version")
        if version or run.encoder.startswith("external:"):
            key = run.encoder, version or "unknown"
            scenes.setdefault(key, set()).add(run.scene)
    table = Table("programs", "Other programs",
                  "Libraries and programs that chose cells; "
                  + provenance.origin(results.records) + ".",
                  [Column("encoder", left=True),
                   Column("version", left=True), Column("scenes")])
    for (encoder, version), found in sorted(scenes.items()):
        table.rows.append([code(encoder), word(version),
                           number(len(found), 0)])
    return table


def references(results):
    """What each scene was compared with."""
    found = {}
    for run in results.runs:
        inputs = run.record["manifest"].get("inputs", [])
        files = [f"{i['name']} {i['sha256'][:10]}" for i in inputs
                 if i["role"] == "reference"]
        key = (run.scene, f"{run.time:g}", run.settings["reference"],
               ", ".join(files) or "–")
        if run.data["metrics"]:
            found.setdefault(key, set()).add(tuple(run.data["raster"]))
    table = Table("references", "References",
                  "What the pictures of each scene were compared with; "
                  + provenance.origin(results.records) + ".",
                  [Column("scene", left=True), Column("time s"),
                   Column("renderer", left=True),
                   Column("file and SHA-256", left=True),
                   Column("rasters", left=True)])
    for key, rasters in sorted(found.items()):
        shown = ", ".join(f"{w} x {h}" for w, h in sorted(rasters))
        table.rows.append([*map(word, key), word(shown)])
    return table


def describe(configuration):
    """A unit's configuration in words, its encoders left out."""
    parts = []
    for key, value in configuration.items():
        if key == "grid" and isinstance(value, list):
            value = "x".join(map(str, value))
        if key not in ("encoders", "scene") and value not in ("", None):
            parts.append(f"{key} {value}")
    return ", ".join(parts)


def failures(results):
    """Everything that was skipped or failed."""
    table = Table("failures", "Skipped and failed",
                  "Units of the work without figures; "
                  + provenance.origin(results.failures) + ".",
                  [Column("kind", left=True), Column("unit", left=True),
                   Column("scene", left=True), Column("encoder", left=True),
                   Column("configuration", left=True),
                   Column("what", left=True), Column("hint", left=True)])
    for record in results.failures:
        failure, unit = record["failure"], record.get("unit", {})
        configuration = unit.get("configuration", {})
        what = failure.get("what", "")
        if failure.get("place"):
            what = f"{failure['place']}: {what}"
        encoders = configuration.get("encoders", [])
        table.rows.append(
            [word(failure.get("kind", "failed")), word(unit.get("kind", "–")),
             word(configuration.get("scene", "–")),
             code(failure.get("encoder") or ", ".join(encoders) or "–"),
             word(describe(configuration)), word(what),
             word(failure.get("hint") or "–")])
    table.rows.sort(key=lambda row: [cell.text for cell in row[:4]])
    return table
