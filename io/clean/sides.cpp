// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/sides.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace crest::io {

using kernel::Index;

std::vector<Side> sorted_sides(const Surface& surface) {
  const auto& faces = surface.faces;
  std::vector<std::size_t> begin(surface.points.size() + 1, 0);
  for (const kernel::Triangle& face : faces)
    for (std::size_t k = 0; k < 3; ++k) ++begin[std::min(face[k], face[(k + 1) % 3]) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Side> sides(3 * faces.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (Index f = 0; f < faces.size(); ++f) {
    for (std::uint8_t k = 0; k < 3; ++k) {
      const Index a = faces[f][k], b = faces[f][(k + 1) % 3], c = faces[f][(k + 2) % 3];
      const Index low = std::min(a, b);
      sides[next[low]++] = {low, std::max(a, b), c, f, k, a < b};
    }
  }
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              sides.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
              [](const Side& s, const Side& t) {
                return std::tie(s.high, s.third, s.face) < std::tie(t.high, t.third, t.face);
              });
  }
  return sides;
}

std::size_t edge_end(const std::vector<Side>& sides, std::size_t i) {
  std::size_t end = i + 1;
  while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
    ++end;
  return end;
}

Neighbours neighbours(const std::vector<Side>& sides) {
  Neighbours across(sides.size() / 3);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    end = edge_end(sides, i);
    if (end - i != 2) continue;
    const Side &s = sides[i], &t = sides[i + 1];
    const bool agrees = s.direct != t.direct;
    across[s.face][s.corner] = {t.face, t.corner, agrees};
    across[t.face][t.corner] = {s.face, s.corner, agrees};
  }
  return across;
}

}  // namespace crest::io
