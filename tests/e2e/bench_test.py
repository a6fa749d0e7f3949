#!/usr/bin/python3
"""The main job: `rtbench --encoder=... --scene=...`."""

import json
import re
import unittest

from pictures import read_png
from program import ROOT, ProgramTest

# Small and quick: 96 x 64 pixels, one timed run, our own reference.
QUICK = ["--scene=cornell", "--grid=12x4", "--repeat=1", "--reference=self",
         "--quiet"]
COLUMNS = ["encoder", "rays/cell", "render ms", "encode ms", "frames/s", "MSE",
           "PSNR dB", "SSIM", "FLIP@40PPD"]


def stable(record):
    """The record without what may differ between two runs."""
    if isinstance(record, dict):
        return {key: stable(value) for key, value in record.items()
                if key not in ("ms", "volatile")}
    if isinstance(record, list):
        return [stable(value) for value in record]
    return record


def stable_text(text):
    """The same without parsing: those keys' lines are cut out."""
    return re.sub(r',\n( *)"(?:ms|volatile)": \{.*?\n\1\}', "", text,
                  flags=re.DOTALL)


class BenchTest(ProgramTest):

    def record(self, *args, **options):
        return json.loads(self.succeed(*args, "--json=-", **options))

    def test_table(self):
        text = self.succeed("--encoder=quadrant,half", *QUICK).decode()
        lines = text.splitlines()
        self.assertIn("cornell, 12x4 cells; compared at 96x64 pixels",
                      lines[0])
        self.assertEqual(re.split(r"\s{2,}", lines[1].strip()), COLUMNS)
        self.assertTrue(lines[3].startswith("quadrant "))
        self.assertTrue(lines[4].startswith("half "))
        self.assertRegex(lines[3], r"^quadrant\s+4\s")

    def test_no_command_means_bench(self):
        self.assertEqual(
            stable(self.record("--encoder=half", *QUICK)),
            stable(self.record("bench", "--encoder=half", *QUICK)))

    def test_all_is_every_encoder_listed(self):
        listed = [encoder for encoder in json.loads(
            self.succeed("list", "encoders", "--json"))
            if encoder["available"] and not encoder["needs_parameters"]]
        record = self.record(*QUICK)
        self.assertEqual([run["encoder"] for run in record["runs"]],
                         [encoder["name"] for encoder in listed])
        self.assertEqual([run["rays_per_cell"] for run in record["runs"]],
                         [encoder["samples_per_cell"] for encoder in listed])

    def test_record(self):
        record = self.record("--encoder=tiv", "--seed=7", "--spp=4", *QUICK)
        self.assertEqual(list(record),
                         ["schema", "manifest", "runs", "volatile"])
        run, = record["runs"]
        self.assertEqual(run["scene"], "cornell")
        self.assertEqual(run["encoder"], "tiv")
        self.assertEqual(run["grid"], [12, 4])
        # 32 samples of 4 rays.
        self.assertEqual(run["rays_per_cell"], 128)
        for stage in ("load", "build", "plan", "render", "encode", "decode",
                      "emit"):
            times = run["ms"][stage]
            self.assertEqual(len(times["samples"]), 1)
            self.assertLessEqual(times["lo"], times["median"])
        self.assertEqual(run["rays"]["camera"], 12 * 4 * 128)
        self.assertGreater(run["bytes_per_frame"], 12 * 4)
        self.assertGreater(run["metrics"]["psnr"], 10)
        self.assertLess(run["metrics"]["psnr"], 60)
        self.assertIsNone(run["metrics"]["ms_ssim"])  # below 176 pixels
        schema = json.loads(
            (ROOT / "results" / "record.schema.json").read_text())
        self.assertLessEqual(set(schema["required"]), set(record))

    def test_decompose(self):
        record = self.record("--encoder=quadrant,tiv", "--decompose", *QUICK,
                             env={"RTBENCH_CACHE": str(self.folder / "c")})
        for run in record["runs"]:
            mse = run["decomposition"]["mse"]
            parts = [mse[key] for key in
                     ("render", "sampling", "encoding", "render_sampling",
                      "render_encoding", "sampling_encoding")]
            self.assertAlmostEqual(sum(parts), mse["total"], delta=1e-9)
            self.assertAlmostEqual(mse["total"], run["metrics"]["mse"],
                                   delta=1e-12)
            inner = run["decomposition"]["inner"]
            self.assertAlmostEqual(sum(inner.values()), mse["encoding"],
                                   delta=1e-9)
            self.assertGreaterEqual(run["bound"]["gap"], 1)
        kinds = {file.name.split("-")[0]
                 for file in (self.folder / "c").iterdir()}
        self.assertEqual(kinds, {"converged", "bound"})
        self.check_schema(record)

    def check_schema(self, record):
        try:
            import jsonschema
        except ImportError as missing:
            self.skipTest(str(missing))
        schema = json.loads(
            (ROOT / "results" / "record.schema.json").read_text())
        jsonschema.Draft202012Validator(schema).validate(record)

    def test_only_times_differ_between_runs_and_threads(self):
        # The canonical grid: a small one is a single task for any number of
        # threads.
        def run(threads):
            return self.succeed(
                "--scene=cornell", "--encoder=half,quadrant,tiv", "--spp=2",
                "--grid=120x40", "--repeat=1", "--quiet", "--json=-",
                f"--threads={threads}").decode()

        one = run(1)
        for other in (run(2), run(1)):
            self.assertEqual(stable(json.loads(one)),
                             stable(json.loads(other)))
            self.assertEqual(stable_text(one), stable_text(other))
        self.assertNotEqual(one, other)
        self.assertEqual(json.loads(stable_text(one)),
                         stable(json.loads(one)))

    def test_more_threads_than_cores_say_nothing(self):
        process = self.run_program("--encoder=half", "--threads=99", *QUICK)
        self.assertEqual((process.returncode, process.stderr), (0, b""))

    def test_json_file_leaves_the_table_on_stdout(self):
        text = self.succeed("--encoder=half", "--json=a/r.json", *QUICK)
        self.assertIn(b"FLIP@40PPD", text)
        record = json.loads((self.folder / "a" / "r.json").read_text())
        self.assertEqual(record["schema"], 1)

    def test_json_stdout_is_json_alone(self):
        process = self.run_program("--encoder=half", "--json=-", "--preview",
                                   *QUICK)
        json.loads(process.stdout)
        self.assertIn("▄".encode(), process.stderr)

    def test_preview(self):
        text = self.succeed("--encoder=half", "--preview", *QUICK).decode()
        self.assertEqual(text.count("▄"), 48)
        self.assertIn("\x1b[", text)
        plain = self.succeed("--encoder=half", "--preview", *QUICK,
                             env={"NO_COLOR": "1"}).decode()
        self.assertEqual(plain.count("▄"), 48)
        self.assertNotIn("\x1b", plain)

    def test_out(self):
        self.succeed("--encoder=half,quadrant:split=best", "--out=d/e", *QUICK)
        out = self.folder / "d" / "e"
        self.assertEqual(
            sorted(p.name for p in out.iterdir()),
            sorted(["record.json", "reference.png"] +
                   [name + end for name in ("half", "quadrant_split_best")
                    for end in (".json", ".ansi", ".png")]))
        width, height, pixels = read_png((out / "half.png").read_bytes())
        self.assertEqual((width, height), (96, 64))
        grid = json.loads((out / "half.json").read_text())
        top = grid["cells"][0][2]
        self.assertEqual("#%02x%02x%02x" % pixels[0], top)
        # What was written scores as the record says, up to the PNG's rounding.
        scores = json.loads(self.succeed(
            "score", f"--reference={out}/reference.png",
            f"--cells={out}/half.json", "--json=-"))["metrics"]
        record = json.loads((out / "record.json").read_text())
        self.assertEqual(scores, record["runs"][0]["metrics"])

    def test_other_grids_reduce_to_the_smaller_raster(self):
        # 24 x 8 cells are 192 x 128 pixels of the same aspect as 96 x 64.
        self.succeed("render", "--scene=cornell", "--size=96x64",
                     "--output=r.png", "--spp=16")
        args = ["--scene=cornell", "--grid=24x8", "--repeat=1",
                "--encoder=quadrant", "--reference=r.png"]
        text = self.succeed(*args).decode()
        self.assertIn("24x8 cells; compared at 96x64 pixels", text)
        self.fail_with(2, *args, "--grid=24x8", says="--grid")  # twice
        self.fail_with(2, "--scene=cornell", "--grid=24x9", "--encoder=half",
                       "--reference=r.png",
                       says=("aspect", "--reference=self"))

    def test_committed_references_are_the_default(self):
        for scene in ("cornell", "whitted"):
            record = self.record(f"--scene={scene}", "--grid=12x4",
                                 "--repeat=1", "--encoder=quadrant")
            self.assertEqual(record["manifest"]["settings"]["reference"],
                             "povray")
            self.assertEqual([f["role"] for f in record["manifest"]["inputs"]],
                             ["scene", "reference"])
            run, = record["runs"]
            self.assertEqual(run["raster"], [96, 64])
            self.assertEqual(run["reference_raster"], [960, 640])
            self.assertGreater(run["metrics"]["psnr"], 15)

    def test_exposure_applies_to_both_sides(self):
        dark = self.record("--encoder=tiv", "--exposure=-6", *QUICK)
        self.assertGreater(dark["runs"][0]["metrics"]["psnr"], 25)
        self.assertEqual(dark["manifest"]["settings"]["exposure"], -6)

    def test_notes_go_to_stderr_unless_quiet(self):
        # At another time than 0 the default is our own image, which is said.
        args = ["--scene=cornell", "--grid=6x2", "--repeat=1",
                "--encoder=half", "--time=1"]
        self.assertRegex(self.run_program(*args).stderr.decode(),
                         r"\Artbench: [^\n]*our own image[^\n]*\n\Z")
        self.assertEqual(self.run_program(*args, "--quiet").stderr, b"")

    def test_errors(self):
        base = ["--scene=cornell", "--encoder=half", "--repeat=1"]
        self.fail_with(2, "--encoder=half", says=("scene", "cornell"))
        self.fail_with(2, says=("scene", "cornell"))
        for grid in ("120", "axb", "0x40", "-3x2", "120x", "5000x1",
                     "1e3x1", "99999999999x1"):
            self.fail_with(2, *base, f"--grid={grid}", says="120x40")
        self.fail_with(2, *base, "--grid=", says="COLSxROWS")
        self.fail_with(2, *base, "--grid=4096x4096", says="smaller grid")
        self.fail_with(2, *base, "--repeat=0", says="--repeat")
        self.fail_with(2, *base, "--cell=8", says="8x16")
        self.fail_with(2, *base, "--decode=exact", says="geometric or font")
        self.fail_with(2, *base, "--grid=6x2", "--reference=cycles",
                       "--time=1", says=("cycles", "--reference=self"))
        self.fail_with(2, *base, "--grid=6x2", "--reference=gone.exr",
                       says="gone.exr")
        self.fail_with(2, *base, "--grid=6x2", "--reference=povray",
                       "--time=1",
                       says=("cornell.t1.povray.exr", "--reference=self"))
        self.fail_with(2, "--scene=cornell", "--encoder=", says="--encoder")
        self.fail_with(2, "--scene=cornell", "--encoder=quadrant:splt=best",
                       says="split")
        self.fail_with(2, *base, "--color=17", says=("--color", "256"))
        self.fail_with(2, *base, "--font=gone.ttf", "--decode=font",
                       "--grid=6x2", "--reference=self", "--quiet",
                       says="gone.ttf")


if __name__ == "__main__":
    unittest.main()
