"""gpu_check runs every step on a GPU, and prints nothing without one."""

import json
import shutil
import unittest

from script_case import ROOT, ScriptTest

# Stands in for each program: notes the call, says $NAME_SAYS, and exits with
# $NAME_EXIT.
PROGRAM = '''#!/bin/bash
echo "{name} $*" >>"$STATE"
echo "GPU $CUDA_DEVICE_ORDER $CUDA_VISIBLE_DEVICES" >>"$STATE"
[[ -n ${name}_says ]] && echo "${name}_says"
exit "${{{name}_exit:-0}}"
'''

BACKENDS = json.dumps([{"name": "bvh", "available": True, "why_not": ""},
                       {"name": "cuda", "available": True, "why_not": ""}])
UNUSABLE = json.dumps([{"name": "cuda", "available": False,
                        "why_not": "the driver is old"}])
BENCH = {"schema": 1, "device": "Some GPU (9.0)", "scenes": []}


class GpuCheckTest(ScriptTest):

    def setUp(self):
        super().setUp()
        (self.tree / "bin").mkdir()
        (self.tree / "bin/bash").symlink_to(shutil.which("bash"))
        self.write("calls")
        shutil.copytree(ROOT / "scripts", self.tree / "repo/scripts")
        self.fake("bin/nvcc", "nvcc")
        self.fake("bin/cmake", "cmake")
        self.fake("bin/compute-sanitizer", "sanitizer")
        for program in ("rtbench", "rtb_gpu_tests", "rtb_gpu_bench"):
            self.fake(f"repo/build/cuda/{program}", program)

    def fake(self, path, name):
        self.write(path, PROGRAM.format(name=name), executable=True)

    def check(self, *arguments, device="Some GPU, 9.0", **behavior):
        """Runs it on a machine with that GPU; None: without a driver."""
        if device is not None:
            self.fake("bin/nvidia-smi", "smi")
        return self.run_command(
            self.tree / "repo/scripts/gpu_check", *arguments,
            PATH=str(self.tree / "bin"), STATE=str(self.tree / "calls"),
            **{"smi_says": device, "rtbench_says": BACKENDS,
               "rtb_gpu_bench_says": json.dumps(BENCH), **behavior})

    def assert_missing(self, run, why):
        """Status 3, a reason, and not one figure."""
        self.assertEqual((run.returncode, run.stdout), (3, ""), run.stderr)
        self.assertIn(why, run.stderr)
        calls = (self.tree / "calls").read_text(encoding="utf-8")
        self.assertNotIn("\nrtb_gpu_bench ", calls)

    def test_without_a_driver(self):
        self.assert_missing(self.check(device=None),
                            "there is no NVIDIA driver")

    def test_without_a_gpu(self):
        run = self.check(device="No devices were found", smi_exit="6")
        self.assert_missing(run, "there is no GPU: 'No devices were found")

    def test_with_a_gpu_that_is_too_old(self):
        self.assert_missing(self.check(device="Old GPU, 7.0"),
                            "Old GPU is of compute capability 7.0, expected "
                            "7.5 or newer")

    def test_with_a_driver_that_tells_no_capability(self):
        self.assert_missing(self.check(device="Some GPU, [N/A]"),
                            "knows no compute capability of Some GPU")

    def test_where_the_program_cannot_use_the_gpu(self):
        self.assert_missing(self.check(rtbench_says=UNUSABLE),
                            "the program cannot use the GPU: the driver is old")

    def test_every_step_passes(self):
        run = self.check()
        self.assert_passes(run)
        record = json.loads(run.stdout)
        self.assertEqual(record["device"], {"name": "Some GPU",
                                            "compute_capability": "9.0"})
        self.assertEqual(
            [(step["name"], step["passed"]) for step in record["steps"]],
            [(name, True) for name in ("configure", "build", "list backends",
                                       "tests", "compute-sanitizer", "bench")])
        self.assertEqual(record["bench"], BENCH)
        calls = (self.tree / "calls").read_text(encoding="utf-8")
        self.assertIn("cmake --preset cuda -DRTB_CUDA_ARCHITECTURES=90\n",
                      calls)
        self.assertIn("rtb_gpu_tests \nGPU PCI_BUS_ID 0\n", calls)

    def test_a_failing_test_fails(self):
        run = self.check(rtb_gpu_tests_exit="1")
        self.assertEqual(run.returncode, 1)
        failed = [step["name"] for step in json.loads(run.stdout)["steps"]
                  if not step["passed"]]
        self.assertEqual(failed, ["tests"])

    def test_a_build_that_fails_measures_nothing(self):
        run = self.check(cmake_exit="1")
        self.assertEqual(run.returncode, 1)
        self.assertIsNone(json.loads(run.stdout)["bench"])

    def test_a_bench_that_fails_gives_no_figures(self):
        run = self.check(rtb_gpu_bench_exit="1")
        self.assertEqual(run.returncode, 1)
        self.assertIsNone(json.loads(run.stdout)["bench"])

    def test_the_record_may_go_to_a_file(self):
        run = self.check(f"--output={self.tree / 'gpu.json'}")
        self.assert_passes(run)
        self.assertEqual(run.stdout, "")
        record = json.loads((self.tree / "gpu.json").read_text("utf-8"))
        self.assertEqual(record["bench"], BENCH)


if __name__ == "__main__":
    unittest.main()
