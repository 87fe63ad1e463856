// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_isosurface/forest.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/surface/tetrahedra.hpp"

namespace crest::certify::spline_isosurface {
namespace {

unsigned number_of(std::size_t a, unsigned upper, std::size_t m, unsigned outer) {
  return static_cast<unsigned>(8 * a) + 4 * upper + (m == kOtherAxes[a][0] ? 0 : 2) + outer;
}

}  // namespace

Forest::Forest(const SplineIsosurfaceCertificate& c, const QuadraticSpline& spline)
    : spline_(spline), roots_(c.bisected), trees_(c.trees) {
  require(spline.cube_count() <= 0xffffffffU / kTetrahedra, "the volume is too large");
  std::size_t node = 0;
  std::vector<unsigned> depths;
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    require((i == 0 || roots_[i] > roots_[i - 1]) && roots_[i] < kTetrahedra * spline.cube_count(),
            "bisected tetrahedra are not ascending");
    starts_.push_back(node);
    require(node < trees_.size() && trees_[node] == spline_code::kBisected,
            "tetrahedron {} has no tree", roots_[i]);
    for (depths.assign(1, 0); !depths.empty();) {
      const unsigned depth = depths.back();
      depths.pop_back();
      require(node < trees_.size(), "the tree of tetrahedron {} is not complete", roots_[i]);
      if (trees_[node++] == spline_code::kLeaf) {
        deepest_ = std::max<std::size_t>(deepest_, depth);
        ++leaves_;
        continue;
      }
      require(depth < kDepth, "the tree of tetrahedron {} is too deep", roots_[i]);
      depths.insert(depths.end(), 2, depth + 1);
    }
  }
  require(node == trees_.size(), "there are more trees than tetrahedra");
}

std::size_t Forest::first_node(std::uint32_t number) const {
  const auto at = std::ranges::lower_bound(roots_, number);
  return at != roots_.end() && *at == number
             ? starts_[static_cast<std::size_t>(at - roots_.begin())]
             : trees_.size();
}
bool Forest::is_bisected(std::uint32_t number) const {
  return first_node(number) != trees_.size();
}
bool Forest::touches(std::size_t cube) const {
  const auto at = std::ranges::lower_bound(roots_, kTetrahedra * cube);
  return at != roots_.end() && *at / kTetrahedra == cube;
}

Point Forest::cube_corner(std::size_t cube) const {
  const CubePosition at = spline_.position(cube);
  return {2 * std::int64_t{at[0]}, 2 * std::int64_t{at[1]}, 2 * std::int64_t{at[2]}};
}

std::uint32_t Forest::neighbour(std::uint32_t number, std::size_t i) const {
  const Tetrahedron tet = tetrahedron(number % kTetrahedra);
  const std::uint32_t cube = number - number % kTetrahedra;
  if (i == 1 || i == 2) return cube + number_of(tet.a, tet.upper, tet.f, i == 1 ? 1 : 0);
  if (i == 3) return cube + number_of(tet.m, tet.outer, tet.a, tet.upper);
  CubePosition at = spline_.position(number / kTetrahedra);
  if (tet.upper != 0 ? at[tet.a] + 1 == spline_.cubes(tet.a) : at[tet.a] == 0) return number;
  at[tet.a] += tet.upper != 0 ? 1 : ~0U;
  return static_cast<std::uint32_t>(kTetrahedra * spline_.number(at)) +
         number_of(tet.a, 1 - tet.upper, tet.m, tet.outer);
}

bool Forest::on_border(const Point& a, const Point& b, const Point& c) const {
  for (std::size_t d = 0; d < 3; ++d)
    for (const std::int64_t side : {std::int64_t{0}, 2 * kScale * spline_.cubes(d)})
      if (a[d] == side && b[d] == side && c[d] == side) return true;
  return false;
}

/// Where nothing is bisected the partition conforms. So only the leaves of bisected tetrahedra
/// count, and the tetrahedra beside these.
void Forest::check_conforming() const {
  std::vector<std::uint32_t> beside;
  for (const std::uint32_t number : roots_)
    for (std::size_t i = 0; i < 4; ++i)
      if (const auto other = neighbour(number, i); !is_bisected(other)) beside.push_back(other);
  std::ranges::sort(beside);
  beside.erase(std::ranges::unique(beside).begin(), beside.end());

  std::vector<std::array<Point, 4>> leaves;
  for (const std::uint32_t number : roots_)
    for_each_leaf(number, [&](const Simplex& leaf) { leaves.push_back(leaf.corners); });
  for (const std::uint32_t number : beside) leaves.push_back(root_of(number).corners);
  require(leaves.size() < 0x3fffffffU, "too many leaves");
  std::vector<Point> points;
  for (const auto& leaf : leaves) points.insert(points.end(), leaf.begin(), leaf.end());
  std::ranges::sort(points);
  points.erase(std::ranges::unique(points).begin(), points.end());
  std::vector<std::array<std::uint32_t, 4>> corners(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k)
      corners[i][k] = static_cast<std::uint32_t>(std::ranges::lower_bound(points, leaves[i][k]) -
                                                 points.begin());
    std::ranges::sort(corners[i]);
  }
  const std::size_t first_beside = leaves.size() - beside.size();
  for (const TetFace& face : list_faces(corners, points.size())) {
    if (face.tets[1] != kNoTet) continue;
    const auto& [a, b, c] = face.corners;
    if (on_border(points[a], points[b], points[c])) continue;
    const std::size_t leaf = face.tets[0];
    const bool outside = leaf >= first_beside;
    require(outside, "a face of a leaf of a bisected tetrahedron is not one of another leaf");
    // Of a tetrahedron beside bisected ones: the one across is not bisected, or its face is missed.
    const std::uint32_t number = beside[leaf - first_beside];
    for (std::size_t i = 0; i < 4; ++i) {
      const Point& opposite = leaves[leaf][i];
      const bool across = opposite != points[a] && opposite != points[b] && opposite != points[c];
      require(!across || !is_bisected(neighbour(number, i)),
              "a face of tetrahedron {} is bisected on the other side alone", number);
    }
  }
}

}  // namespace crest::certify::spline_isosurface
