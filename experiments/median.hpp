// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace crest::experiments {

/// The middle one of work()'s values, of an even number the upper. Requires: times > 0.
template <class Work>
double median_of(int times, const Work& work) {
  std::vector<double> values;
  for (int i = 0; i < times; ++i) values.push_back(work());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace crest::experiments
