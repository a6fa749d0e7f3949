#include "core/base/parallel.h"

#include <pmmintrin.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <xmmintrin.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "core/base/check.h"

namespace rtb {
namespace {

/// Embree wants denormals flushed; one mode everywhere keeps results equal on
/// workers and on the calling thread.
class FlushDenormals {
 public:
  FlushDenormals() : saved_(_mm_getcsr()) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~FlushDenormals() { _mm_setcsr(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned saved_;
};

/// An arena that a thread keeps: made anew for every loop, its workers would
/// have to be called together each time.
class OwnArena {
 public:
  void Run(int threads, const std::function<void()>& work) {
    if (busy_) {  // A loop within a loop must not take up the outer one's work.
      tbb::task_arena(threads).execute(work);
      return;
    }
    if (!arena_ || threads_ != threads) arena_.emplace(threads);
    threads_ = threads;
    busy_ = true;
    const std::unique_ptr<bool, void (*)(bool*)> free(
        &busy_, [](bool* busy) { *busy = false; });
    arena_->execute(work);
  }

 private:
  std::optional<tbb::task_arena> arena_;
  int threads_ = 0;
  bool busy_ = false;
};

}  // namespace

void ParallelFor(int count, int grain, int threads,
                 const std::function<void(int begin, int end)>& body) {
  RTB_CHECK_GT(grain, 0);
  const int blocks = (count + grain - 1) / grain;
  const auto run_block = [&](int block) {
    const FlushDenormals flush;
    const int begin = block * grain;
    body(begin, std::min(begin + grain, count));
  };
  if (threads == 1) {
    for (int block = 0; block < blocks; ++block) run_block(block);
    return;
  }
  RunBounded(threads, [&] {
    tbb::parallel_for(0, blocks, run_block, tbb::simple_partitioner());
  });
}

void RunBounded(int threads, const std::function<void()>& work) {
  // An arena of our own bounds the threads: Embree's device installs no
  // process-wide limit this way. Asking for more threads than there are cores
  // would make TBB print a warning.
  const int cores = tbb::info::default_concurrency();
  thread_local OwnArena arena;
  arena.Run(threads > 0 ? std::min(threads, cores) : cores, work);
}

}  // namespace rtb
