"""cuda_report reads what nvcc says, and --check fails on what it must."""

import json
import unittest

from script_case import ROOT, ScriptTest

# Stands in for nvcc: says $REPORT of every kernel file compiled to machine
# code, and writes $PTX for one compiled to PTX.
NVCC = '''#!/bin/bash
[[ -n $BROKEN ]] && { echo "$BROKEN" >&2; exit 1; }
while (( $# )); do
  case $1 in
    -o) shift; output=$1 ;;
    -ptx) ptx=yes ;;
    -arch=*) arch=${1#-arch=} ;;
    *encode_kernels.cu) other=yes ;;
  esac
  shift
done
if [[ $ptx ]]; then echo "$PTX" >"$output"; exit; fi
[[ $other ]] || echo "${REPORT//ARCH/$arch}" >&2
'''

# As nvcc 13.0 words it, of one kernel.
REPORT = """ptxas info    : 0 bytes gmem
ptxas info    : Compiling entry function 'rtb_render' for 'ARCH'
ptxas info    : Function properties for rtb_render
    144 bytes stack frame, {stores} bytes spill stores, {loads} bytes spill loads
ptxas info    : Used 202 registers, used 0 barriers, {stack} bytes cumulative \
stack size
ptxas info    : Compile time = 2713.303 ms"""

PTX = "add.rn.f32 %f1, %f2, %f3;\nfma.rn.f64 %d1, %d2, %d3, %d4;"


class CudaReportTest(ScriptTest):

    def setUp(self):
        super().setUp()
        self.nvcc = self.write("bin/nvcc", NVCC, executable=True)
        self.write("bin/pkg-config", "#!/bin/bash\n", executable=True)

    def report(self, *arguments, ptx=PTX, broken="", **figures):
        figures = {"stores": 0, "loads": 0, "stack": 144, **figures}
        return self.run_command(
            ROOT / "scripts/cuda_report", f"--nvcc={self.nvcc}", *arguments,
            PATH=f"{self.tree / 'bin'}:/usr/bin:/bin", BROKEN=broken, PTX=ptx,
            REPORT=REPORT.format(**figures))

    def assert_refused(self, run, *words):
        """Exit status 1, and all the words among the errors."""
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        for word in words:
            self.assertIn(word, run.stderr)

    def test_a_kernel_within_its_bounds_passes(self):
        run = self.report("--check", "--json", "--arch=80,90")
        self.assert_passes(run)
        kernels = json.loads(run.stdout)["kernels"]
        # 202 registers of 32 threads are 6464, in lots of 256 6656; 65536
        # hold 9 of them.
        self.assertEqual(
            kernels,
            [{"kernel": "rtb_render", "arch": arch, "registers": 202,
              "stack": 144, "spilled": 0, "warps": 9, "most_warps": 64}
             for arch in ("80", "90")])

    def test_the_table_names_every_figure(self):
        run = self.report("--arch=75")
        self.assert_passes(run)
        self.assertEqual(run.stdout.splitlines()[1].split(),
                         ["rtb_render", "75", "202", "144", "0", "9/32"])

    def test_spilled_registers_fail(self):
        run = self.report("--check", "--arch=90", stores=400, loads=428)
        self.assert_refused(run, "rtb_render at sm_90 spills registers: "
                            "828 bytes")

    def test_spills_of_what_a_kernel_calls_are_its_own(self):
        called = ("\nptxas info    : Function properties for walk\n    64 bytes "
                  "stack frame, 8 bytes spill stores, 4 bytes spill loads")
        run = self.report("--check", "--arch=80", stack="144" + called)
        self.assert_refused(run, "spills registers: 12 bytes")

    def test_without_check_a_spill_is_only_reported(self):
        run = self.report("--arch=80", stores=1)
        self.assert_passes(run)
        self.assertEqual(run.stdout.splitlines()[1].split()[4], "1")

    def test_a_large_stack_fails(self):
        self.assert_passes(self.report("--check", stack=16384))
        self.assert_refused(self.report("--check", stack=16388),
                            "stack frame of 16388 bytes")

    def test_arithmetic_that_may_be_contracted_fails(self):
        for loose in ("add.f32", "mul.f64", "div.full.f32", "sqrt.approx.f32",
                      "mul.rn.ftz.f32"):
            run = self.report("--check", "--arch=80",
                              ptx=f"{PTX}\n{loose} %f1, %f2, %f3;")
            self.assert_refused(run, f"rounding is left open: {loose}")

    def test_a_file_that_does_not_compile_fails(self):
        run = self.report("--check", broken="error: no such header")
        self.assert_refused(run, "does not compile", "no such header")

    def test_no_compiler_is_a_missing_tool(self):
        run = self.run_command(ROOT / "scripts/cuda_report",
                               f"--nvcc={self.tree / 'none'}")
        self.assertEqual((run.returncode, run.stdout), (3, ""))
        self.assertIn("there is no nvcc", run.stderr)


if __name__ == "__main__":
    unittest.main()
