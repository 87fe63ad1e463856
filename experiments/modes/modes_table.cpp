// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's table beside ours: one line a size.
#include <fmt/format.h>

#include "algorithms/modes/modes.hpp"

int main() {
  fmt::print("{:>9} {:>9} {:>9}\n", "points", "places", "used");
  for (std::uint32_t n = 10; n <= 1000; n *= 10) {
    crest::modes::Input input;
    for (std::uint32_t i = 0; i < n; ++i) input.points.push_back({1.0 * i, 0, 0});
    const auto census = crest::modes::take_census(input);
    fmt::print("{:>9} {:>9} {:>9}\n", n, census.distinct, census.used);
  }
}
