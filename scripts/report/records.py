"""Reading the records of a sweep (or of the main job) from a folder.

A record is one JSON file of results/record.schema.json. Quality units carry
metrics, timing units times; they meet by what was done (Run.work).
"""

import functools
import json
from dataclasses import dataclass, field
from pathlib import Path

from report import labels
from report.errors import BadInput

SCHEMA = 1
KINDS = ("quality", "timing", "temporal", "live")


@dataclass(frozen=True)
class Setting:
    """All that is held fixed where encoders are compared over scenes."""
    grid: tuple
    spp: int
    backend: str
    integrator: str
    color: str

    def label(self):
        return (f"{self.grid[0]} x {self.grid[1]} cells, {self.spp} "
                f"ray{'' if self.spp == 1 else 's'} a sample, "
                f"{self.integrator} on {self.backend}, {self.color}")

    def slug(self):
        return (f"{self.grid[0]}x{self.grid[1]}-spp{self.spp}-"
                f"{self.integrator}-{self.backend}-{self.color}")


@dataclass(frozen=True)
class View:
    """A setting with what its pictures were compared with, and how."""
    setting: Setting
    reference: str
    raster: tuple
    ppd: float

    def label(self):
        return f"{self.setting.label()}, reference {self.reference}"

    def measured(self):
        """`at 40 PPD on 960 x 640`: belongs beside every FLIP value."""
        return (f"at {self.ppd:g} PPD on a raster of {self.raster[0]} x "
                f"{self.raster[1]}")

    def slug(self):
        parts = [self.setting.slug(), self.reference]
        return "-".join(part for part in parts if part)


@dataclass
class Run:
    """One encoder on one scene, with the record that it stands in."""
    kind: str
    data: dict
    record: dict
    file: str

    @property
    def scene(self):
        return self.data["scene"]

    @property
    def encoder(self):
        return self.data["encoder"]

    @property
    def settings(self):
        return self.record["manifest"]["settings"]

    @property
    def time(self):
        return self.settings["time"]

    @property
    def seed(self):
        return self.settings["seed"]

    @property
    def setting(self):
        own = self.settings
        return Setting(tuple(self.data["grid"]), own["spp"], own["backend"],
                       own["integrator"], own["color"])

    @property
    def view(self):
        # What the suite asked for: the default may be another renderer's for
        # each scene, and is one view all the same.
        unit = self.record.get("unit")
        if unit:
            reference = unit["configuration"]["reference"] or "default"
        else:
            reference = self.settings["reference"]
        return View(self.setting, reference, tuple(self.data["raster"]),
                    self.settings["ppd"])

    @property
    def work(self):
        """What times and metrics of one work have in common."""
        return self.setting, self.scene, self.time, self.encoder

    def value(self, *path):
        """A nested value of the run, or None."""
        found = self.data
        for key in path:
            if not isinstance(found, dict) or found.get(key) is None:
                return None
            found = found[key]
        return found


@dataclass
class Results:
    """Everything that a folder of records holds."""
    folder: Path
    runs: list = field(default_factory=list)
    failures: list = field(default_factory=list)  # the records themselves
    records: list = field(default_factory=list)

    @functools.cached_property
    def names(self):
        """{SPEC: short label}, each label once."""
        return labels.unique(sorted({run.encoder for run in self.runs}))

    def of(self, *kinds):
        return [run for run in self.runs if run.kind in kinds]

    def scored(self):
        """The runs that have a FLIP value of a still picture."""
        return [run for run in self.of("quality", "bench")
                if run.value("metrics", "flip") is not None]

    def timed(self):
        return [run for run in self.of("timing", "bench")
                if run.value("ms")]

    def views(self):
        """All views with a FLIP value, that of the most runs first."""
        counts = {}
        for run in self.scored():
            counts[run.view] = counts.get(run.view, 0) + 1
        return sorted(counts, key=lambda view: (-counts[view], view.slug()))


def record_files(folder):
    """The files that may hold records."""
    units = folder / "units"
    return sorted((units if units.is_dir() else folder).glob("*.json"))


def read_record(file):
    """A record, or None when the file is JSON of another kind."""
    try:
        record = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise BadInput(f"{file}: not a record: {error}") from error
    if not isinstance(record, dict) or not {"manifest",
                                            "failure"} & record.keys():
        return None
    if record.get("schema") != SCHEMA:
        raise BadInput(f"{file}: records of schema {SCHEMA} are known here, "
                       f"found {record.get('schema')}")
    return record


def check_run(run):
    """Raises BadInput for a run that lacks what every run has."""
    try:
        return run.work, run.view, run.seed, run.data["metrics"]
    except (KeyError, TypeError) as error:
        raise BadInput(f"{run.file}: a run lacks {error}") from error


def load(folder):
    """Reads all records of a folder; BadInput where there are none."""
    folder = Path(folder)
    if not folder.is_dir():
        raise BadInput(f"{folder}: no such folder")
    results = Results(folder)
    for file in record_files(folder):
        record = read_record(file)
        if record is None:
            continue
        results.records.append(record)
        if "failure" in record:
            results.failures.append(record)
        kind = record.get("unit", {}).get("kind", "bench")
        for data in record.get("runs", []):
            run = Run(kind, data, record, file.name)
            check_run(run)
            results.runs.append(run)
    if not results.records:
        raise BadInput(f"{folder}: no records in it (rtbench sweep SUITE "
                       "--out=DIR writes them)")
    return results
