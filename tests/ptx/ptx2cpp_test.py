#!/usr/bin/python3
"""Tests of ptx2cpp.py: small functions in PTX, translated, compiled and run.

Expected values come from Python's own arithmetic, or are worked out beside
the case. Needs a C++ compiler and nothing of CUDA.
"""

import ctypes
import math
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE))
import ptx2cpp  # noqa: E402

COMPILER = shutil.which("c++") or shutil.which("g++")
NAN = float("nan")


def f32(number):
    """The number rounded to single precision."""
    return struct.unpack("f", struct.pack("f", number))[0]


def case(code, inputs, output, kinds="f32 f32 f32"):
    """A function of inputs in registers i0, i1, ... to one in `o`.

    kinds: the types of the output, then of the inputs."""
    return code, inputs, output, kinds.split()


CASES = {
    # Arithmetic: what IEEE says of single precision.
    "add": case("add.rn.f32 %o, %i0, %i1;", (0.1, 0.2),
                f32(f32(0.1) + f32(0.2))),
    "add_toward_zero": case(
        # 1 + 1.5 ulp of 1/2's: to nearest that is 1 + 2^-23, toward zero 1.
        "add.rz.f32 %o, %i0, %i1;", (1.0, 2.0**-24 * 1.5), 1.0),
    # (1 + e)^2 - (1 + 2e) = e^2, which a rounded product loses.
    "fma_once_rounded": case(
        "mov.f32 %o, 0fBF801000; fma.rn.f32 %o, %i0, %i1, %o;",
        (1 + 2.0**-12, 1 + 2.0**-12), 2.0**-24),
    "mul_not_fused": case(
        "mul.rn.f32 %o, %i0, %i1; mov.b32 %t, 0fBF801000; "
        "add.rn.f32 %o, %o, %t;", (1 + 2.0**-12, 1 + 2.0**-12), 0.0),
    "div": case("div.rn.f32 %o, %i0, %i1;", (1.0, 3.0), f32(1 / 3)),
    "sqrt": case("sqrt.rn.f32 %o, %i0;", (2.0, 0), f32(math.sqrt(2))),
    "minimum_of_nan": case("min.f32 %o, %i0, %i1;", (NAN, 3.0), 3.0),
    "copysign": case("copysign.f32 %o, %i0, %i1;", (-0.0, 2.0), -2.0),
    "saturate": case("cvt.sat.f32.f32 %o, %i0;", (1.5, 0), 1.0),
    "floor": case("cvt.rmi.f32.f32 %o, %i0;", (-1.5, 0), -2.0),
    "nearest_even": case("cvt.rni.s32.f32 %o, %i0;", (2.5, 0), 2,
                         "s32 f32 f32"),
    "too_large": case("cvt.rzi.s32.f32 %o, %i0;", (1e20, 0), 2**31 - 1,
                      "s32 f32 f32"),
    "nan_to_whole": case("cvt.rzi.s32.f32 %o, %i0;", (NAN, 0), 0,
                         "s32 f32 f32"),
    # Comparisons: of NaN only the unordered ones hold.
    "ordered": case("setp.lt.f32 %p1, %i0, %i1; selp.b32 %o, 1, 2, %p1;",
                    (NAN, 1.0), 2, "s32 f32 f32"),
    "unordered": case("setp.ltu.f32 %p1, %i0, %i1; selp.b32 %o, 1, 2, %p1;",
                      (NAN, 1.0), 1, "s32 f32 f32"),
    "not_equal_ordered": case(
        "setp.ne.f32 %p1, %i0, %i1; selp.b32 %o, 1, 2, %p1;", (NAN, 1.0), 2,
        "s32 f32 f32"),
    "combined": case(
        "setp.lt.f32 %p1, %i0, %i1; setp.lt.and.f32 %p2, %i1, %i0, %p1; "
        "selp.b32 %o, 1, 2, %p2;", (1.0, 2.0), 2, "s32 f32 f32"),
    # Whole numbers.
    "low": case("mul.lo.s32 %o, %i0, %i1;", (1 << 20, 1 << 13), 0,
                "s32 s32 s32"),
    "high": case("mul.hi.s32 %o, %i0, %i1;", (-1, 1 << 20), -1,
                 "s32 s32 s32"),
    "mad": case("mad.lo.s32 %o, %i0, %i1, 5;", (-3, 7), -16, "s32 s32 s32"),
    "rem": case("rem.s32 %o, %i0, %i1;", (-7, 3), -1, "s32 s32 s32"),
    "shift_all_out": case("shl.b32 %o, %i0, %i1;", (1, 32), 0, "s32 s32 s32"),
    "shift_sign": case("shr.s32 %o, %i0, %i1;", (-8, 40), -1, "s32 s32 s32"),
    "funnel": case("shf.l.wrap.b32 %o, %i0, %i1, 8;",
                   (0x12345678, 0x00ABCDEF), 0xABCDEF12 - (1 << 32),
                   "s32 s32 s32"),
    "insert": case("bfi.b32 %o, %i0, %i1, 8, 4;", (0xF, 0x1000), 0x1F00,
                   "s32 s32 s32"),
    "extract": case("bfe.s32 %o, %i0, 4, 4;", (0x80, 0), -8, "s32 s32 s32"),
    "extract_unsigned": case("bfe.u32 %o, %i0, 4, 4;", (0x80, 0), 8,
                             "u32 s32 s32"),
    "permute": case("prmt.b32 %o, %i0, %i1, 0x0715;",
                    # bytes 5, 1, 7, 0 of 77665544'33221100, lowest first
                    (0x33221100, 0x77665544), 0x00771155, "u32 u32 u32"),
    "bits": case("popc.b32 %o, %i0;", (0xF0F0, 0), 8, "u32 u32 u32"),
    "leading": case("clz.b32 %o, %i0;", (1, 0), 31, "u32 u32 u32"),
    "shift_amount": case("bfind.shiftamt.u32 %o, %i0;", (1 << 28, 0), 3,
                         "u32 u32 u32"),
    "reverse": case("brev.b32 %o, %i0;", (1, 0), 1 << 31, "u32 u32 u32"),
    "not": case("not.b32 %o, %i0;", (0, 0), -1, "s32 s32 s32"),
    # Memory, and registers wider than what is loaded.
    "sign_of_a_byte": case(
        "st.local.b32 [depot+4], %i0; ld.local.s8 %o, [depot+4];", (0x80, 0),
        -128, "s32 s32 s32"),
    "vectors": case(
        "st.local.v2.f32 [depot], {%i0, %i1}; ld.local.v2.f32 {%t, %o}, "
        "[depot];", (1.0, 2.0), 2.0),
    "table": case("ld.global.u32 %o, [table+4];", (0, 0), 0x04030201,
                  "u32 u32 u32"),
    "halves": case("mov.b64 %w, {%i0, %i1}; shr.u64 %w, %w, 16; "
                   "cvt.u32.u64 %o, %w;", (0x22221111, 0x44443333),
                   0x33332222, "u32 u32 u32"),
    "half_in_a_scope": case(
        "mov.b64 %w, {%i0, %i1};\n {.reg .b32 tmp; mov.b64 {tmp, %o}, %w; "
        "add.s32 %o, %o, tmp; }", (3, 4), 7, "s32 s32 s32"),
    # Control flow.
    "loop": case(
        # The sum of 1..i0.
        "mov.b32 %o, 0; mov.b32 %t, 0;\n$L_1:\n add.s32 %t, %t, 1; "
        "add.s32 %o, %o, %t; setp.lt.s32 %p1, %t, %i0; @%p1 bra $L_1;",
        (10, 0), 55, "s32 s32 s32"),
    "unless": case("setp.eq.s32 %p1, %i0, 3; mov.b32 %o, 1; "
                   "@!%p1 mov.b32 %o, 2;", (3, 0), 1, "s32 s32 s32"),
    "thread": case("mov.u32 %t, %ctaid.x; mov.u32 %o, %ntid.x; "
                   "mad.lo.s32 %o, %t, %o, %i0;", (5, 0), 5, "s32 s32 s32"),
    "call": case(
        "{\n.param .b32 p0;\nst.param.b32 [p0], %i0;\n.param .b32 back;\n"
        "call.uni (back), twice, (p0);\nld.param.b32 %o, [back];\n}",
        (21, 0), 42, "s32 s32 s32"),
}

FRAME = """
.visible .entry {name}(.param .u64 {name}_0)
{{
  .reg .pred %p<3>;
  .reg .b32 %i<2>;
  .reg .b32 %o, %t;
  .reg .b64 %rd<2>, %w;
  .local .align 8 .b8 depot[16];
  ld.param.u64 %rd1, [{name}_0];
  ld.global.b32 %i0, [%rd1];
  ld.global.b32 %i1, [%rd1+4];
  {code}
  st.global.b32 [%rd1+8], %o;
  ret;
}}
"""
HEAD = """.version 9.0
.target sm_80
.address_size 64
.global .align 4 .b8 table[8] = {9, 9, 9, 9, 1, 2, 3, 4};
.func (.param .b32 result) twice(.param .b32 twice_0)
{
  .reg .b32 %r<2>;
  ld.param.b32 %r1, [twice_0]; // a comment; with a semicolon
  add.s32 %r1, %r1, %r1;
  st.param.b32 [result], %r1;
  ret;
}
"""


def packed(kind, number):
    return (struct.pack("f", number) if kind == "f32"
            else struct.pack("I", number & 0xFFFFFFFF))


class Ptx2CppTest(unittest.TestCase):
    """Each of CASES, compiled together."""

    @classmethod
    def setUpClass(cls):
        if COMPILER is None:
            raise unittest.SkipTest("no C++ compiler")
        text = HEAD + "".join(
            FRAME.format(name=f"case_{name}", code=code)
            for name, (code, _, _, _) in CASES.items())
        folder = Path(tempfile.mkdtemp(prefix="rtbench_ptx_"))
        cls.addClassCleanup(shutil.rmtree, folder)
        source = folder / "cases.cc"
        source.write_text(ptx2cpp.translate(text))
        shared = folder / "cases.so"
        subprocess.run([COMPILER, "-std=c++20", "-O0", "-fwrapv", "-w",
                        "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}",
                        "-o", shared, source], check=True)
        cls.compiled = ctypes.CDLL(str(shared))

    def test_cases(self):
        for name, (_, inputs, expected, kinds) in CASES.items():
            with self.subTest(name):
                memory = ctypes.create_string_buffer(
                    packed(kinds[1], inputs[0]) + packed(kinds[2], inputs[1]),
                    12)
                place = ctypes.c_uint64(ctypes.addressof(memory))
                case = getattr(self.compiled, f"ptx_case_{name}")
                case(ctypes.byref(place))
                found = memory.raw[8:]
                self.assertEqual(found, packed(kinds[0], expected), found)

    def test_what_is_not_known_is_an_error(self):
        for code in ("bar.sync 0;", "atom.global.add.u32 %o, [%rd1], 1;",
                     "shfl.sync.idx.b32 %o, %i0, 0, 31, -1;",
                     "add.rm.f32 %o, %i0, %i1;"):
            with self.subTest(code):
                with self.assertRaises(ptx2cpp.PtxError) as error:
                    ptx2cpp.translate(HEAD + FRAME.format(name="f", code=code))
                self.assertIn(code.split()[0], str(error.exception))


if __name__ == "__main__":
    unittest.main()
