/// @file
/// A source of samples that are known beforehand.
#pragma once

#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/render/fragment_source.h"

namespace rtb {

/// Answers one plan with what it was given, cell by cell.
class GivenSource : public FragmentSource {
 public:
  explicit GivenSource(std::vector<Rgb> values) : values_(std::move(values)) {}

  Result<Fragments> Query(const SamplePlan& plan) override {
    Fragments fragments(plan);
    RTB_CHECK_EQ(fragments.values.size(), values_.size());
    fragments.values.swap(values_);
    values_.clear();
    return fragments;
  }

 private:
  std::vector<Rgb> values_;
};

}  // namespace rtb
