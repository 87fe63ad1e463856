// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/patches.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace crest::smooth_ridges {
namespace {

/// A face's corners in the umbilic's coordinates, relative to it, in units of R.
using Flat = std::array<std::array<double, 2>, 3>;

class Search {
 public:
  Search(const Surface& surface, const Triangulation& mesh, const Umbilic& umbilic, FaceTest& test)
      : surface_(surface), mesh_(mesh), umbilic_(umbilic), test_(test) {}

  PatchSearch run(const std::vector<Index>& candidates) {
    PatchSearch result;
    // A smaller square if the faces around a larger one do not form a disk.
    for (const double half : {0.5, 0.4, 0.3, 0.6}) {
      result = {};
      for (const Index f : candidates) {
        const auto flat = near(f);
        if (!flat || !meets(*flat, half)) continue;
        (within(f, *flat) ? result.faces : result.too_large).push_back(f);
      }
      if (!result.too_large.empty() || is_disk(result.faces)) return result;
    }
    result.too_large = std::move(result.faces);
    result.faces.clear();
    return result;
  }

 private:
  /// Nothing if the face is far away.
  std::optional<Flat> near(Index face) const {
    const auto corners = mesh_.corners(face);
    Flat flat;
    if (surface_.is_implicit()) {
      const auto [i, j] = plane_axes(umbilic_.centre.axis);
      const double middle = umbilic_.centre.height;
      const double reach = umbilic_.heights[1] - umbilic_.heights[0];
      bool close = false;
      for (std::size_t k = 0; k < 3; ++k) {
        flat[k] = {(corners[k][i] - umbilic_.centre.z[0]) / umbilic_.radius,
                   (corners[k][j] - umbilic_.centre.z[1]) / umbilic_.radius};
        const double size = std::hypot(corners[k][0] - corners[(k + 1) % 3][0],
                                       corners[k][1] - corners[(k + 1) % 3][1],
                                       corners[k][2] - corners[(k + 1) % 3][2]);
        close = close || std::fabs(corners[k][umbilic_.centre.axis] - middle) < reach + size;
      }
      if (!close) return std::nullopt;
      return flat;
    }
    std::array<double, 2> mean{}, shift{};
    for (std::size_t d = 0; d < 2; ++d) {
      mean[d] = (corners[0][d] + corners[1][d] + corners[2][d]) / 3;
      if (surface_.periodic(d)) shift[d] = std::round(mean[d] - umbilic_.centre.z[d]);
    }
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 2; ++d)
        flat[k][d] = (corners[k][d] - shift[d] - umbilic_.centre.z[d]) / umbilic_.radius;
    return flat;
  }

  /// Whether the triangle meets [-half, half]^2 (by separating lines).
  static bool meets(const Flat& t, double half) {
    for (std::size_t d = 0; d < 2; ++d) {
      const auto [low, high] = std::minmax({t[0][d], t[1][d], t[2][d]});
      if (low > half || high < -half) return false;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &a = t[k], &b = t[(k + 1) % 3], &c = t[(k + 2) % 3];
      const std::array<double, 2> n = {b[1] - a[1], a[0] - b[0]};
      double inner = n[0] * (c[0] - a[0]) + n[1] * (c[1] - a[1]);
      const double sign = inner < 0 ? -1 : 1;
      // The corner of the square furthest to c's side.
      const double best =
          sign * (-n[0] * a[0] - n[1] * a[1]) + half * (std::fabs(n[0]) + std::fabs(n[1]));
      if (best < 0) return false;
    }
    return true;
  }

  bool within(Index face, const Flat& flat) const {
    constexpr double kInside = 0.95;
    for (const auto& corner : flat)
      for (const double x : corner)
        if (!(std::fabs(x) < kInside)) return false;
    if (!surface_.is_implicit()) return true;
    const auto image = test_.image(mesh_.corners(face));
    if (!image) return false;
    const auto [i, j] = plane_axes(umbilic_.centre.axis);
    const double room = kInside * umbilic_.radius;
    const auto inside = [](const kernel::Range& r, double low, double high) {
      return r.low > low && r.high < high;
    };
    return inside((*image)[i], umbilic_.centre.z[0] - room, umbilic_.centre.z[0] + room) &&
           inside((*image)[j], umbilic_.centre.z[1] - room, umbilic_.centre.z[1] + room) &&
           inside((*image)[umbilic_.centre.axis], umbilic_.heights[0], umbilic_.heights[1]);
  }

  /// Connected through edges, Euler characteristic 1, no vertex touched twice.
  bool is_disk(const std::vector<Index>& faces) const {
    if (faces.empty()) return false;
    std::unordered_map<Index, int> corner_count, inner_count;
    std::size_t inner = 0, reached = 0;
    std::unordered_map<Index, bool> seen;
    for (const Index f : faces) seen[f] = false;
    std::vector<Index> todo = {faces.front()};
    seen[faces.front()] = true;
    while (!todo.empty()) {
      const Index f = todo.back();
      todo.pop_back();
      ++reached;
      for (std::size_t k = 0; k < 3; ++k) {
        ++corner_count[mesh_.faces()[f][k]];
        const Index n = mesh_.neighbours()[f][k];
        const auto it = n == kernel::kNone ? seen.end() : seen.find(n);
        if (it == seen.end()) continue;
        ++inner;
        ++inner_count[mesh_.faces()[f][k]];
        if (!it->second) it->second = true, todo.push_back(n);
      }
    }
    if (reached != faces.size()) return false;
    const auto edges = static_cast<long>(3 * faces.size() - inner / 2);
    if (static_cast<long>(corner_count.size()) - edges + static_cast<long>(faces.size()) != 1)
      return false;
    // Around a vertex the outgoing inner edges are one less than the faces, or as many.
    return std::all_of(corner_count.begin(), corner_count.end(), [&](const auto& entry) {
      return entry.second - inner_count[entry.first] <= 1;
    });
  }

  const Surface& surface_;
  const Triangulation& mesh_;
  const Umbilic& umbilic_;
  FaceTest& test_;
};

}  // namespace

bool may_meet(const Surface& surface, const Triangulation& mesh, const Umbilic& umbilic,
              Index face) {
  // A new vertex stays within half an edge of the edge's middle.
  constexpr double kSizes = 3;
  const auto& u = umbilic.centre;
  const auto c = mesh.corners(face);
  if (!surface.is_implicit()) {
    for (std::size_t d = 0; d < 2; ++d) {
      const double size = std::max(std::fabs(c[1][d] - c[0][d]), std::fabs(c[2][d] - c[0][d]));
      double off = c[0][d] - u.z[d];
      if (surface.periodic(d)) off -= std::round(off);
      if (!(std::fabs(off) < umbilic.radius + kSizes * size)) return false;
    }
    return true;
  }
  const Vec3 off = position(c[0]) - in_space(u);
  const double size =
      std::max(norm(position(c[1]) - position(c[0])), norm(position(c[2]) - position(c[0])));
  for (std::size_t k = 0; k < 3; ++k) {
    const double reach = k == u.axis ? umbilic.heights[1] - umbilic.heights[0] : umbilic.radius;
    if (!(std::fabs(off[k]) < reach + kSizes * size)) return false;
  }
  return true;
}

PatchSearch find_patch(const Surface& surface, const Triangulation& mesh, const Umbilic& umbilic,
                       const std::vector<Index>& candidates, FaceTest& test) {
  return Search(surface, mesh, umbilic, test).run(candidates);
}

}  // namespace crest::smooth_ridges
