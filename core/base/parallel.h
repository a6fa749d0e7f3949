/// @file
/// Parallel loops with a bound on the number of threads (TBB).
#pragma once

#include <functional>

namespace rtb {

/// Calls body(begin, end) for disjoint ranges that cover [0, count), at most
/// `grain` long each, on at most `threads` threads (0 = all cores). Ranges
/// depend on count and grain alone. Flush-to-zero is set in each call.
void ParallelFor(int count, int grain, int threads,
                 const std::function<void(int begin, int end)>& body);

/// Runs `work` so that the parallel loops of libraries in it (TBB's) use at
/// most `threads` threads (0 = all cores).
void RunBounded(int threads, const std::function<void()>& work);

}  // namespace rtb
