/// @file
/// Loops over the rows of a raster, in parallel, with sums that do not depend
/// on the number of threads.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/parallel.h"
#include "harness/metrics/channel_plane.h"

namespace rtb {

/// Calls body(y) for each row.
template <class Body>
void ForRows(int height, int threads, const Body& body) {
  constexpr int kRowsPerTask = 16;
  ParallelFor(height, kRowsPerTask, threads, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) body(y);
  });
}

/// Adds body(y) of all rows, in their order.
template <class Body>
double SumRows(int height, int threads, const Body& body) {
  std::vector<double> sums(static_cast<std::size_t>(height));
  ForRows(height, threads,
          [&](int y) { sums[static_cast<std::size_t>(y)] = body(y); });
  double total = 0;
  for (const double sum : sums) total += sum;
  return total;
}

/// Mean over a raster of value(x, y).
template <class Value>
double MeanOverPixels(int width, int height, int threads, const Value& value) {
  const double sum = SumRows(height, threads, [&](int y) {
    double row = 0;
    for (int x = 0; x < width; ++x) row += value(x, y);
    return row;
  });
  return sum / (static_cast<double>(width) * height);
}

/// The plane of combine(a(x, y), b(x, y)).
template <class Combine>
ChannelPlane CombinePlanes(const ChannelPlane& a, const ChannelPlane& b,
                           int threads, const Combine& combine) {
  ChannelPlane out(a.width(), a.height());
  ForRows(a.height(), threads, [&](int y) {
    for (int x = 0; x < a.width(); ++x) {
      out.row(y)[x] = combine(a.row(y)[x], b.row(y)[x]);
    }
  });
  return out;
}

}  // namespace rtb
