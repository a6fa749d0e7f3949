#include "core/base/parallel.h"

#include <gtest/gtest.h>
#include <xmmintrin.h>

#include <atomic>
#include <limits>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace rtb {
namespace {

using Ranges = std::set<std::pair<int, int>>;

Ranges RangesOf(int count, int grain, int threads) {
  Ranges ranges;
  std::mutex mutex;
  ParallelFor(count, grain, threads, [&](int begin, int end) {
    const std::lock_guard lock(mutex);
    EXPECT_TRUE(ranges.emplace(begin, end).second);
  });
  return ranges;
}

TEST(ParallelFor, VisitsEveryIndexExactlyOnce) {
  for (const int threads : {1, 2, 3, 0}) {
    for (const int count : {1, 2, 7, 97, 1001}) {
      for (const int grain : {1, 3, 64, 2000}) {
        std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
        ParallelFor(count, grain, threads, [&](int begin, int end) {
          for (int i = begin; i < end; ++i) {
            ++visits[static_cast<std::size_t>(i)];
          }
        });
        for (const auto& visit : visits) EXPECT_EQ(visit, 1);
      }
    }
  }
}

TEST(ParallelFor, RangesDependOnCountAndGrainAlone) {
  const Ranges expected = {{0, 4}, {4, 8}, {8, 11}};
  for (const int threads : {1, 2, 3, 0}) {
    EXPECT_EQ(RangesOf(11, 4, threads), expected) << threads << " threads";
  }
}

TEST(ParallelFor, NothingToDoCallsNothing) {
  for (const int threads : {1, 2, 3, 0}) {
    EXPECT_TRUE(RangesOf(0, 5, threads).empty());
  }
}

TEST(ParallelFor, StaysWithinTheNumberOfThreads) {
  std::mutex mutex;
  std::set<std::thread::id> seen;
  ParallelFor(500, 1, 2, [&](int, int) {
    const std::lock_guard lock(mutex);
    seen.insert(std::this_thread::get_id());
  });
  EXPECT_LE(seen.size(), 2u);
}

// Each of 20 x 30 once, on threads that keep what they run loops with.
TEST(ParallelFor, LoopsWithinLoopsAndBesideThemAreWhole) {
  std::vector<std::atomic<int>> visits(20 * 30);
  const auto visit = [&](int threads) {
    ParallelFor(20, 1, threads, [&](int row, int) {
      ParallelFor(30, 4, threads, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
          ++visits[static_cast<std::size_t>(row * 30 + i)];
        }
      });
    });
  };
  std::vector<std::thread> callers;
  for (int i = 0; i < 4; ++i) {
    callers.emplace_back([&, i] {
      for (int round = 0; round < 25; ++round) visit(i % 2 * 2);
    });
  }
  for (std::thread& caller : callers) caller.join();
  for (const auto& count : visits) EXPECT_EQ(count, 100);
}

// The bound of each call counts, not that of the first.
TEST(ParallelFor, AnotherBoundHoldsAtOnce) {
  for (const int threads : {0, 1, 0, 1, 2}) {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    ParallelFor(300, 1, threads, [&](int, int) {
      const std::lock_guard lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
    if (threads > 0) {
      EXPECT_LE(seen.size(), static_cast<std::size_t>(threads));
    }
  }
}

TEST(ParallelFor, FlushesDenormalsInsideOnly) {
  const unsigned before = _mm_getcsr();
  for (const int threads : {1, 2}) {
    std::atomic<int> not_flushed = 0;
    ParallelFor(50, 1, threads, [&](int, int) {
      volatile float tiny = std::numeric_limits<float>::min();
      volatile float half = tiny / 2;  // a denormal, so 0 here
      if (half != 0) ++not_flushed;
    });
    EXPECT_EQ(not_flushed, 0);
  }
  // The rounding and denormal modes; the low 6 bits are sticky flags.
  EXPECT_EQ(_mm_getcsr() & ~0x3Fu, before & ~0x3Fu);
}

}  // namespace
}  // namespace rtb
