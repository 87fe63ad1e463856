// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_isosurface/mesh.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"

namespace crest::certify::spline_isosurface {
namespace {

/// An edge is known by its middle: in a conforming complex no two edges share one.
struct Occurrence {
  Point twice_middle;
  std::uint32_t number;
  friend std::strong_ordering operator<=>(const Occurrence&, const Occurrence&) = default;
};

constexpr std::array<std::array<std::uint8_t, 2>, 6> kEdges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

Point sum(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

bool changes(const ActiveLeaf& leaf, const std::array<std::uint8_t, 2>& edge) {
  return ((leaf.negative >> edge[0] ^ leaf.negative >> edge[1]) & 1U) != 0;
}

/// Counted from z down.
bool is_lower(const Point& a, const Point& b) {
  return std::array{a[2], a[1], a[0]} < std::array{b[2], b[1], b[0]};
}

/// Triangles of one leaf, of places in it: each corner is an edge by its ends.
using Side = std::array<std::size_t, 2>;
using LeafTriangle = std::array<Side, 3>;

bool faces_negative(const ActiveLeaf& leaf, const LeafTriangle& triangle) {
  std::array<Point, 3> p;  // twice the middles
  for (std::size_t i = 0; i < 3; ++i)
    p[i] = sum(leaf.simplex.corners[triangle[i][0]], leaf.simplex.corners[triangle[i][1]]);
  std::array<std::array<double, 3>, 3>
      rows;  // two sides, and from a positive end to a negative one
  const Side& side = triangle[0];
  const bool first = (leaf.negative >> side[0] & 1U) != 0;
  for (std::size_t d = 0; d < 3; ++d) {
    rows[0][d] = static_cast<double>(p[1][d] - p[0][d]);
    rows[1][d] = static_cast<double>(p[2][d] - p[0][d]);
    rows[2][d] = static_cast<double>(leaf.simplex.corners[side[first ? 0 : 1]][d] -
                                     leaf.simplex.corners[side[first ? 1 : 0]][d]);
  }
  const auto minor = [&](std::size_t d) {
    const std::size_t k = (d + 1) % 3, l = (d + 2) % 3;
    return rows[0][k] * rows[1][l] - rows[0][l] * rows[1][k];
  };
  // Sides of one leaf are at most 2 kScale / 2^j with few digits: exact.
  return rows[2][0] * minor(0) + rows[2][1] * minor(1) + rows[2][2] * minor(2) > 0;
}

std::vector<LeafTriangle> triangles_of(const ActiveLeaf& leaf) {
  std::vector<std::size_t> positive, negative;
  for (std::size_t i = 0; i < 4; ++i)
    ((leaf.negative >> i & 1U) != 0 ? negative : positive).push_back(i);
  if (positive.size() == 2) {
    const std::size_t p0 = positive[0], p1 = positive[1], n0 = negative[0], n1 = negative[1];
    return {{{{p0, n0}, {p0, n1}, {p1, n1}}}, {{{p0, n0}, {p1, n1}, {p1, n0}}}};
  }
  const bool alone = positive.size() == 1;
  const std::size_t v = alone ? positive[0] : negative[0];
  const auto& others = alone ? negative : positive;
  return {{{{v, others[0]}, {v, others[1]}, {v, others[2]}}}};
}

/// Numbers of the edges that change sign, leaf by leaf, six places each.
std::vector<std::uint32_t> number_vertices(const Leaves& leaves, Mesh& mesh) {
  std::vector<Occurrence> occurrences;
  for (std::size_t i = 0; i < leaves.active.size(); ++i)
    for (std::size_t k = 0; k < 6; ++k) {
      const ActiveLeaf& leaf = leaves.active[i];
      if (!changes(leaf, kEdges[k])) continue;
      occurrences.push_back(
          {sum(leaf.simplex.corners[kEdges[k][0]], leaf.simplex.corners[kEdges[k][1]]),
           static_cast<std::uint32_t>(6 * i + k)});
    }
  std::ranges::sort(occurrences);
  std::vector<std::uint32_t> first(6 * leaves.active.size());  // where its edge occurs first
  for (std::size_t i = 0; i < occurrences.size(); ++i) {
    const bool same = i > 0 && occurrences[i].twice_middle == occurrences[i - 1].twice_middle;
    const std::uint32_t number = occurrences[i].number;
    first[number] = same ? first[occurrences[i - 1].number] : number;
  }
  std::vector<std::uint32_t> numbers(first.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    const ActiveLeaf& leaf = leaves.active[i / 6];
    const auto& edge = kEdges[i % 6];
    if (!changes(leaf, edge)) continue;
    if (first[i] == i) {
      numbers[i] = static_cast<std::uint32_t>(mesh.vertices.size());
      const bool up = is_lower(leaf.simplex.corners[edge[0]], leaf.simplex.corners[edge[1]]);
      mesh.vertices.push_back({i / 6, {edge[up ? 0 : 1], edge[up ? 1 : 0]}});
    } else {
      numbers[i] = numbers[first[i]];
    }
  }
  return numbers;
}

std::size_t place_of(const Side& side) {
  const auto low = std::min(side[0], side[1]), high = std::max(side[0], side[1]);
  return low == 0 ? high - 1 : low + high;
}

}  // namespace

Mesh build_mesh(const Leaves& leaves, kernel::Sign orientation) {
  require(leaves.active.size() < 0xffffffffU / 6, "too many leaves");
  Mesh mesh;
  const auto numbers = number_vertices(leaves, mesh);
  for (std::size_t i = 0; i < leaves.active.size(); ++i)
    for (const LeafTriangle& triangle : triangles_of(leaves.active[i])) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = numbers[6 * i + place_of(triangle[k])];
      const bool direct = orientation == kernel::Sign::positive;
      if (faces_negative(leaves.active[i], triangle) != direct) std::swap(corners[1], corners[2]);
      mesh.triangles.push_back(corners);
    }
  return mesh;
}

}  // namespace crest::certify::spline_isosurface
