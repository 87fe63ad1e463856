// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/tet_mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <tuple>

#include "kernel/arithmetic/approximate.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::kernel {
namespace {

template <class T>
T volume(const std::array<Vec3, 4>& p) {
  std::array<std::array<T, 3>, 3> d;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) d[i][k] = T(p[i + 1][k]) - T(p[0][k]);
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
         d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

std::string name(const TetMesh::Tet& t) {
  return std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " + std::to_string(t[2]) + ", " +
         std::to_string(t[3]);
}

}  // namespace

TetMesh::Tet TetMesh::sorted(Index tet) const {
  Tet t = tets_[tet];
  std::sort(t.begin(), t.end());
  return t;
}

TetMesh::TetMesh(std::vector<Vec3> points, std::vector<Tet> tets)
    : points_(std::move(points)), tets_(std::move(tets)) {
  struct Side {
    std::array<Index, 3> corners;
    Index tet;
    std::uint8_t opposite;
  };
  std::vector<Side> sides;
  sides.reserve(4 * tets_.size());
  for (Index c = 0; c < tets_.size(); ++c) {
    const Tet t = sorted(c);
    if (std::adjacent_find(t.begin(), t.end()) != t.end())
      throw InputError("tetrahedron " + std::to_string(c) + ": has a corner twice; leave it out");
    for (std::uint8_t i = 0; i < 4; ++i) {
      Side s{{}, c, i};
      for (std::size_t k = 0, n = 0; k < 4; ++k)
        if (k != i) s.corners[n++] = t[k];
      sides.push_back(s);
    }
  }
  // By the first corner in one pass, then each corner's few.
  std::vector<std::size_t> begin(points_.size() + 1, 0);
  for (const Side& s : sides) {
    if (s.corners[2] >= points_.size())
      throw InputError("tetrahedron " + std::to_string(s.tet) +
                       ": has a corner that does not exist");
    ++begin[s.corners[0] + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Side> sorted_sides(sides.size());
  {
    std::vector<std::size_t> at(begin.begin(), begin.end() - 1);
    for (const Side& s : sides) sorted_sides[at[s.corners[0]]++] = s;
  }
  sides.swap(sorted_sides);
  const auto key = [](const Side& s) {
    return std::tuple(std::uint64_t{s.corners[1]} << 32 | s.corners[2], s.tet);
  };
  for (std::size_t v = 0; v < points_.size(); ++v)
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              sides.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
              [&](const Side& a, const Side& b) { return key(a) < key(b); });
  faces_of_.resize(tets_.size());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    while (end < sides.size() && sides[end].corners == sides[i].corners) ++end;
    const auto& v = sides[i].corners;
    if (end - i > 2)
      throw InputError("face " + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
                       std::to_string(v[2]) + ": is in " + std::to_string(end - i) +
                       " tetrahedra; a face may have two at most");
    if (end - i == 2 && sorted(sides[i].tet) == sorted(sides[i + 1].tet))
      throw InputError("tetrahedron " + std::to_string(sides[i + 1].tet) + " (" +
                       name(sorted(sides[i].tet)) + "): is there twice; leave one out");
    for (std::size_t k = i; k < end; ++k)
      faces_of_[sides[k].tet][sides[k].opposite] = static_cast<Index>(faces_.size());
    faces_.push_back({v, {sides[i].tet, end - i == 2 ? sides[i + 1].tet : kNoTet}});
    i = end;
  }
}

int TetMesh::orientation(Index tet) const {
  std::array<Vec3, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = points_[tets_[tet][i]];
  // Depth of `volume`: at most 3 for a difference's two and the product, twice more, and sums: 12.
  if (const MaybeSign s = certain_sign(volume<Approximate>(p), 12)) return static_cast<int>(*s);
  return static_cast<int>(sign_of(volume<Rational>(p)));
}

}  // namespace crest::kernel
