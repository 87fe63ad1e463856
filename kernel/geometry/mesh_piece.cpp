// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/geometry/mesh_piece.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace crest::kernel {
namespace {

/// The faces of a part as they are gathered.
class Gathering {
 public:
  explicit Gathering(const TriangleMesh& mesh)
      : mesh_(mesh), has_(mesh.face_count()), seen_(mesh.vertex_count()) {}

  /// All faces of the vertices fewer than `rings` edges away.
  void gather(std::span<const Index> owned, Index rings) {
    std::vector<Index> near(owned.begin(), owned.end());
    for (const Index v : near) seen_[v] = 1;
    std::size_t first = 0;
    for (Index ring = 1; ring < rings && first < near.size(); ++ring) {
      const std::size_t last = near.size();
      for (std::size_t i = first; i < last; ++i)
        for (const Index w : mesh_.ring(near[i]))
          if (std::exchange(seen_[w], 1) == 0) near.push_back(w);
      first = last;
    }
    for (const Index v : near) add_faces_of(v);
  }

  /// Adds the faces of vertices with several fans until there are none.
  void close() {
    for (std::size_t i = 0; i < faces_.size(); ++i)  // which grows
      for (const Index v : mesh_.faces()[faces_[i]])
        if (fans(v) > 1) add_faces_of(v);
  }

  /// Ascending.
  std::vector<Index> faces() const {
    std::vector<Index> r = faces_;
    std::sort(r.begin(), r.end());
    return r;
  }
  bool has_all_of(Index v) const {
    const auto fan = mesh_.fan(v);
    return std::all_of(fan.begin(), fan.end(), [&](Index f) { return has_[f] != 0; });
  }

 private:
  void add_faces_of(Index v) {
    for (const Index f : mesh_.fan(v))
      if (std::exchange(has_[f], 1) == 0) faces_.push_back(f);
  }
  /// Of the vertex's faces that are there: a fan begins where the face before is missing.
  int fans(Index v) const {
    const auto fan = mesh_.fan(v);
    bool before = !mesh_.on_boundary(v) && has_[fan.back()] != 0;
    int count = 0;
    for (const Index f : fan) {
      count += has_[f] != 0 && !before ? 1 : 0;
      before = has_[f] != 0;
    }
    return count;
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint8_t> has_, seen_;
  std::vector<Index> faces_;
};

void cut(std::span<const Vec3> points, std::span<Index> of, Index count,
         std::vector<std::vector<Index>>& parts) {
  if (count == 1) {
    std::sort(of.begin(), of.end());
    parts.emplace_back(of.begin(), of.end());
    return;
  }
  Vec3 low = points[of[0]], high = low;
  for (const Index v : of)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], points[v][k]);
      high[k] = std::max(high[k], points[v][k]);
    }
  const Vec3 size = high - low;
  const auto k =
      static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  const Index near = count / 2;
  const std::size_t middle = of.size() * near / count;
  std::nth_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(middle), of.end(),
                   [&](Index v, Index w) {
                     return points[v][k] != points[w][k] ? points[v][k] < points[w][k] : v < w;
                   });
  cut(points, of.first(middle), near, parts);
  cut(points, of.subspan(middle), count - near, parts);
}

}  // namespace

std::vector<Index> MeshPiece::owned_vertices() const {
  std::vector<Index> r;
  for (Index v = 0; v < mesh_.vertex_count(); ++v)
    if (owns(v)) r.push_back(v);
  return r;
}

MeshPart mesh_part(const TriangleMesh& mesh, std::span<const Index> owned, Index rings) {
  Gathering gathering(mesh);
  gathering.gather(owned, rings);
  gathering.close();
  MeshPart r;
  std::vector<Index> number(mesh.vertex_count(), kNone);
  const std::vector<Index> faces = gathering.faces();
  for (const Index f : faces)
    for (const Index v : mesh.faces()[f]) number[v] = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (number[v] == kNone) continue;
    number[v] = static_cast<Index>(r.vertices.size());
    r.vertices.push_back(v);
    r.points.push_back(mesh.points()[v]);
    r.roles.push_back(gathering.has_all_of(v) ? Role::inner : Role::rim);
  }
  for (const Index v : owned) r.roles[number[v]] = Role::owned;
  for (const Index f : faces) {
    const auto [a, b, c] = mesh.faces()[f];
    r.faces.push_back({number[a], number[b], number[c]});
  }
  return r;
}

std::vector<Index> take_done(std::vector<Index>& owned, std::span<const Index> left) {
  std::vector<Index> done, rest;
  for (Index i = 0; i < owned.size(); ++i) {
    const bool is_left = rest.size() < left.size() && left[rest.size()] == i;
    (is_left ? rest : done).push_back(owned[i]);
  }
  owned = std::move(rest);
  return done;
}

std::vector<std::vector<Index>> cut_points(std::span<const Vec3> points, Index count) {
  std::vector<Index> all(points.size());
  std::iota(all.begin(), all.end(), Index{0});
  std::vector<std::vector<Index>> parts;
  count =
      std::min(std::max<Index>(count, 1), static_cast<Index>(std::max<std::size_t>(all.size(), 1)));
  cut(points, all, count, parts);
  return parts;
}

}  // namespace crest::kernel
