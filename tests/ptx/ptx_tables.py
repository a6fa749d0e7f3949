"""Tables of PTX's simple instructions and of what stands beside their names."""

WIDER = {"u16": "u32", "s16": "s32", "u32": "u64", "s32": "s64"}

# Where the answer to a comparison with NaN is yes, PTX adds a `u`.
COMPARISONS = {"eq": "==", "ne": "!=", "lt": "<", "le": "<=", "gt": ">",
               "ge": ">=", "lo": "<", "ls": "<=", "hi": ">", "hs": ">="}

# Two operands and one, as C++ of operands %0, %1, ... of type %T.
PLAIN = {
    "add": "%0 + %1", "sub": "%0 - %1", "and": "%0 & %1", "or": "%0 | %1",
    "xor": "%0 ^ %1", "not": "PtxNot(%0)", "neg": "PtxNegate(%0)",
    "abs": "PtxAbs(%0)", "min": "PtxMin(%0, %1)", "max": "PtxMax(%0, %1)",
    "mov": "%0", "cvta": "%0", "cnot": "%0 == 0",
    "copysign": "std::copysign(%1, %0)", "popc": "std::popcount(%0)",
    "clz": "std::countl_zero(%0)", "brev": "PtxReverse(%0)",
}
FLOATING = {
    "mul": "%0 * %1", "div": "%0 / %1", "sqrt": "std::sqrt(%0)",
    "rcp": "1 / %0", "rsqrt": "1 / std::sqrt(%0)", "ex2": "std::exp2(%0)",
    "lg2": "std::log2(%0)", "sin": "std::sin(%0)", "cos": "std::cos(%0)",
    "fma": "std::fma(%0, %1, %2)", "tanh": "std::tanh(%0)",
}
WHOLE = {"div": "%0 / %1", "rem": "%0 % %1"}

# Modifiers that change nothing here: rounding to nearest even is the host's.
IGNORED = {"rn", "approx", "full", "ftz", "uni", "global", "local", "param",
           "const", "nc", "to", "volatile", "relaxed", "weak", "L1", "L2",
           "L1::evict_last", "L1::no_allocate"}
