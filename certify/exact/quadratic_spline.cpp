// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/exact/quadratic_spline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "certify/container/parallel.hpp"

namespace crest::certify {
namespace {

/// By the absolute values of a domain point, descending, as digits; then by how many steps the
/// sample lies from the cube's along the axis of the largest value (where it is alone), and along
/// the others.
int weight_of(int kind, int along, int others) {
  switch (kind) {
    case 222:
    case 220:
      return 1;
    case 211:
      return std::array{2, 1, 0}[static_cast<std::size_t>(others)];
    case 200:
      return std::array{4, 1, 0}[static_cast<std::size_t>(others)];
    case 111:
      return 5 - 2 * others;
    case 100:
      return along == 0 ? std::array{20, 6, 1}[static_cast<std::size_t>(others)]
                        : std::array{12, 2, -1}[static_cast<std::size_t>(others)];
    default:
      return std::array{40, 12, 2, -1}[static_cast<std::size_t>(others)];
  }
}

SplineMask make_mask(const std::array<int, 3>& p) {
  std::array<int, 3> size = {std::abs(p[0]), std::abs(p[1]), std::abs(p[2])};
  const std::size_t largest =
      static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
  std::ranges::sort(size, std::greater<>());
  const int kind = 100 * size[0] + 10 * size[1] + size[2];
  const bool alone = size[0] > size[1];
  SplineMask mask;
  int sum = 0;
  for (int i = 0; i < 27; ++i) {
    const std::array<int, 3> at = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
    bool inside = true;
    int others = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      // Towards the point, or its own row; where the point is in the middle, all but for edges.
      const bool middle = p[d] == 0 && kind != 220;
      inside = inside && (middle || at[d] == 0 || at[d] * p[d] > 0);
      if (!(alone && d == largest)) others += std::abs(at[d]);
    }
    if (!inside) continue;
    const int weight = weight_of(kind, at[largest], others);
    mask.weights[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(weight);
    sum += weight;
  }
  mask.sum = static_cast<std::uint8_t>(sum);
  return mask;
}

}  // namespace

const SplineMask& spline_mask(const std::array<int, 3>& p) {
  static const auto masks = [] {
    std::array<SplineMask, 125> all;
    for (int i = 0; i < 125; ++i)
      all[static_cast<std::size_t>(i)] = make_mask({i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2});
    return all;
  }();
  return masks[static_cast<std::size_t>(p[0] + 2 + 5 * (p[1] + 2) + 25 * (p[2] + 2))];
}

double QuadraticSpline::sample(const std::array<std::int64_t, 3>& node) const {
  const auto [nx, ny, nz] = volume_.nodes;
  const std::size_t i = static_cast<std::size_t>(node[0] + nx * (node[1] + ny * node[2]));
  ByteReader reader(
      std::span(volume_.samples)
          .subspan(i * kVolumeSampleSize[volume_.type], kVolumeSampleSize[volume_.type]));
  switch (volume_.type) {
    case 0:
      return reader.integer<std::int8_t>();
    case 1:
      return reader.integer<std::uint8_t>();
    case 2:
      return reader.integer<std::int16_t>();
    case 3:
      return reader.integer<std::uint16_t>();
    case 4:
      return reader.integer<std::int32_t>();
    case 5:
      return reader.integer<std::uint32_t>();
    case 6:
      return static_cast<double>(reader.integer<std::int64_t>());
    case 7:
      return static_cast<double>(reader.integer<std::uint64_t>());
    case 8:
      return std::bit_cast<float>(reader.integer<std::uint32_t>());
    default:
      return std::bit_cast<double>(reader.integer<std::uint64_t>());
  }
}

/// Of the 27 samples round a cube's own; not finite if that is not known.
QuadraticSpline::Range QuadraticSpline::range_round(const CubePosition& cube) const {
  Range range{HUGE_VAL, -HUGE_VAL};
  for (const kernel::Interval& s : neighbourhood<kernel::Interval>(cube)) {
    range.low = std::min(range.low, s.inf());
    range.high = std::max(range.high, s.sup());
  }
  return range;
}

/// For every node along x, of the nine that cubes with these numbers along y and z see. Empty if
/// some are beyond the grid.
std::vector<QuadraticSpline::Range> QuadraticSpline::column_ranges(const CubePosition& row) const {
  const std::int64_t first = volume_.extended ? 0 : 1;
  const std::int64_t y = row[1] + first, z = row[2] + first;
  if (y == 0 || z == 0 || y + 1 == volume_.nodes[1] || z + 1 == volume_.nodes[2]) return {};
  std::vector<Range> columns(volume_.nodes[0], {HUGE_VAL, -HUGE_VAL});
  for (std::int64_t k = z - 1; k <= z + 1; ++k)
    for (std::int64_t j = y - 1; j <= y + 1; ++j)
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const double s = sample({static_cast<std::int64_t>(i), j, k});
        columns[i].low = std::min(columns[i].low, s);
        columns[i].high = std::max(columns[i].high, s);
      }
  return columns;
}

/// By lemma 20 of SPEC.md no coefficient leaves the range by more than a sixteenth of its length.
bool QuadraticSpline::surely_one_sided(const Range& range) const {
  using kernel::Interval;
  const Interval low(range.low), high(range.high);
  const Interval margin = (high - low) * Interval(0.0625);
  const Interval least = low - margin, most = high + margin;
  return is_defined(least) && is_defined(most) &&
         (least.inf() > volume_.level || most.sup() < volume_.level);
}

std::vector<std::uint8_t> QuadraticSpline::one_sided() const {
  std::vector<std::uint8_t> sides(cube_count());
  const std::size_t row = cubes(0);
  parallel_for(
      sides.size() / row, [] { return 0; },
      [&](int, std::size_t number) {
        const kernel::RoundUpward guard;
        const auto columns = column_ranges(position(number * row));
        for (std::size_t i = 0; i < row; ++i) {
          const std::size_t at = volume_.extended ? i - 1 : i;  // of the lowest of three columns
          Range range{};
          if (columns.empty() || at + 2 >= columns.size() || at > columns.size()) {
            range = range_round(position(number * row + i));
          } else {
            const Range &a = columns[at], &b = columns[at + 1], &c = columns[at + 2];
            range = {std::min({a.low, b.low, c.low}), std::max({a.high, b.high, c.high})};
          }
          sides[number * row + i] = surely_one_sided(range) ? 1 : 0;
        }
      });
  return sides;
}

}  // namespace crest::certify
