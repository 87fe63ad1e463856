// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/exact/quadratic_spline.hpp"

#include <algorithm>
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
  ByteReader reader(std::span(volume_.samples)
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

/// The negative weights of a mask sum to -1/16 of all at most (SPEC.md), so no coefficient leaves
/// the samples' range by more than 1/16 of its length.
bool QuadraticSpline::surely_one_sided(const CubePosition& cube) const {
  using kernel::Interval;
  const auto samples = neighbourhood<Interval>(cube);
  double low = samples[0].inf(), high = samples[0].sup();
  for (const Interval& s : samples) {
    if (!is_defined(s)) return false;
    low = std::min(low, s.inf());
    high = std::max(high, s.sup());
  }
  const Interval margin = (Interval(high) - Interval(low)) * Interval(0.0625);
  const Interval least = Interval(low) - margin, most = Interval(high) + margin;
  return is_defined(margin) && ((is_defined(least) && least.inf() > volume_.level) ||
                                (is_defined(most) && most.sup() < volume_.level));
}

std::vector<std::uint8_t> QuadraticSpline::one_sided() const {
  std::vector<std::uint8_t> sides(cube_count());
  const std::size_t row = cubes(0);
  parallel_for(
      sides.size() / row, [] { return 0; },
      [&](int, std::size_t i) {
        const kernel::RoundUpward guard;
        for (std::size_t cube = i * row; cube < (i + 1) * row; ++cube)
          sides[cube] = surely_one_sided(position(cube)) ? 1 : 0;
      });
  return sides;
}

}  // namespace crest::certify
