// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/patch_joins.hpp"

#include <algorithm>
#include <functional>

namespace crest::ridges {
namespace {

using Key = std::pair<Index, Colour>;

class Joiner {
 public:
  Joiner(const kernel::TriangleMesh& mesh, const EdgeStates& states,
         const std::vector<Index>& owner, Index number, const CrossingWeight& weight)
      : mesh_(mesh), states_(states), owner_(owner), number_(number), weight_(weight) {}

  PatchJoins run(const Umbilic& umbilic) {
    centre_ = umbilic.point;
    build_tree(umbilic.face);
    PatchJoins joins;
    for (int k = 0; k < 3; ++k)
      for (const Key& key : lines_through_side(umbilic.face, k)) {
        std::vector<Vec3>& inner = inner_points_[key];
        joins[key].push_back(umbilic.point);
        // Collected from the crossing inwards.
        joins[key].insert(joins[key].end(), inner.rbegin(), inner.rend());
      }
    return joins;
  }

 private:
  bool inside(Index f) const { return f != kernel::kNone && owner_[f] == number_; }

  void build_tree(Index root) {
    parent_[root] = root;
    std::vector<Index> queue{root};
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Index g = mesh_.neighbour(queue[i], k);
        if (inside(g) && parent_.try_emplace(g, queue[i]).second) queue.push_back(g);
      }
  }

  // The lines that enter face f through its side k, in order along the side.
  std::vector<Key> lines_through_side(Index f, int k) {
    const Index e = mesh_.face_edges()[f][static_cast<std::size_t>(k)];
    const Index g = mesh_.neighbour(f, k);
    if (!inside(g)) return contour_crossings_on(f, k, e);
    if (parent_.at(g) != f) return {};
    int entry = 0;
    while (mesh_.neighbour(g, entry) != f) ++entry;
    // Seen from f the side runs A to B; around g, A to C and C to B follow it in the same order.
    std::vector<Key> lines;
    for (int step : {1, 2}) {
      const std::vector<Key> part = lines_through_side(g, (entry + step) % 3);
      lines.insert(lines.end(), part.begin(), part.end());
    }
    place_on_side(f, k, lines);
    return lines;
  }

  std::vector<Key> contour_crossings_on(Index f, int k, Index e) const {
    std::vector<Key> keys;
    for (Colour c : {Colour::blue, Colour::red})
      if (states_.is_crossed(e, c)) keys.push_back({e, c});
    if (keys.size() == 2 && weight_(e, Colour::red) < weight_(e, Colour::blue))
      std::swap(keys[0], keys[1]);
    if (mesh_.faces()[f][static_cast<std::size_t>(k)] != mesh_.edges()[e].v0)
      std::reverse(keys.begin(), keys.end());
    return keys;
  }

  // Each line passes the side where the straight way from its crossing to the umbilic comes
  // closest; if that does not keep their order, all pass at equal distances.
  void place_on_side(Index f, int k, const std::vector<Key>& lines) {
    const auto i = static_cast<std::size_t>(k);
    const Vec3& a = mesh_.points()[mesh_.faces()[f][i]];
    const Vec3& b = mesh_.points()[mesh_.faces()[f][(i + 1) % 3]];
    std::vector<double> at;
    for (const Key& line : lines) at.push_back(nearest_to_straight_way(line, a, b));
    if (std::adjacent_find(at.begin(), at.end(), std::greater_equal<>()) != at.end())
      for (std::size_t j = 0; j < at.size(); ++j)
        at[j] = static_cast<double>(j + 1) / static_cast<double>(at.size() + 1);
    for (std::size_t j = 0; j < lines.size(); ++j)
      inner_points_[lines[j]].push_back(between(a, b, at[j]));
  }

  // Position in [0.1, 0.9] on ab closest to the line through the crossing and the umbilic.
  double nearest_to_straight_way(const Key& line, const Vec3& a, const Vec3& b) const {
    const kernel::Edge& edge = mesh_.edges()[line.first];
    const Vec3 crossing =
        between(mesh_.points()[edge.v0], mesh_.points()[edge.v1], weight_(line.first, line.second));
    double uu = 0, uv = 0, vv = 0, uw = 0, vw = 0;
    for (std::size_t x = 0; x < 3; ++x) {
      const double u = b[x] - a[x], v = centre_[x] - crossing[x], w = a[x] - crossing[x];
      uu += u * u;
      uv += u * v;
      vv += v * v;
      uw += u * w;
      vw += v * w;
    }
    const double determinant = uu * vv - uv * uv;
    const double t = determinant > 0 ? (uv * vw - vv * uw) / determinant : 0.5;
    return std::clamp(t, 0.1, 0.9);
  }

  static Vec3 between(const Vec3& a, const Vec3& b, double t) {
    Vec3 p;
    for (std::size_t x = 0; x < 3; ++x) p[x] = (1 - t) * a[x] + t * b[x];
    return p;
  }

  const kernel::TriangleMesh& mesh_;
  const EdgeStates& states_;
  const std::vector<Index>& owner_;
  Index number_;
  const CrossingWeight& weight_;
  Vec3 centre_{};
  std::map<Index, Index> parent_;
  std::map<Key, std::vector<Vec3>> inner_points_;
};

}  // namespace

PatchJoins join_patch(const kernel::TriangleMesh& mesh, const EdgeStates& states,
                      const std::vector<Index>& owner, const Umbilic& umbilic, Index number,
                      const CrossingWeight& weight) {
  return Joiner(mesh, states, owner, number, weight).run(umbilic);
}

}  // namespace crest::ridges
