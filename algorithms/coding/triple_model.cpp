// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/triple_model.hpp"

namespace crest::coding {
namespace {

/// Few values, far from filling their range? A sample does not tell: the values of a scan may recur
/// only late in the file.
bool worth_a_table(std::span<const Triple> values, std::size_t axis) {
  if (values.empty()) return false;
  std::vector<std::int64_t> all;
  for (const Triple& value : values) all.push_back(value[axis]);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const auto range =
      static_cast<std::uint64_t>(all.back()) - static_cast<std::uint64_t>(all.front());
  return 2 * all.size() <= values.size() && all.size() <= range / 2 + 1;
}

}  // namespace

std::vector<Hint> plausible(std::span<const Triple> values, std::size_t axis, std::size_t equal,
                            std::size_t pairs) {
  std::vector<Hint> hints;
  if (worth_a_table(values, axis)) hints.push_back(Hint::table);
  if (4 * equal >= 3 * pairs) hints.push_back(Hint::repeats);
  return hints;
}

}  // namespace crest::coding
