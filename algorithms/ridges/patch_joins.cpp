// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/patch_joins.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace crest::ridges {
namespace {

class Joiner {
 public:
  Joiner(const kernel::TriangleMesh& mesh, const EdgeStates& states,
         const std::vector<Index>& owner, const Umbilic& umbilic, Index number,
         const CrossingWeight& weight)
      : mesh_(mesh),
        states_(states),
        owner_(owner),
        umbilic_(umbilic),
        number_(number),
        weight_(weight),
        parent_(umbilic.patch.size(), kernel::kNone) {}

  PatchJoins run() {
    build_tree();
    for (int k = 0; k < 3; ++k) add_lines(umbilic_.face, k);
    PatchJoins joins;
    for (Line& line : lines_) {  // collected from the crossing inwards
      line.points.push_back(umbilic_.point);
      std::reverse(line.points.begin(), line.points.end());
      joins.lines.push_back({line.edge, line.colour, std::move(line.points)});
    }
    return joins;
  }

 private:
  struct Line {
    Index edge;
    Colour colour;
    Vec3 crossing;
    std::vector<Vec3> points;
  };

  bool inside(Index f) const { return f != kernel::kNone && owner_[f] == number_; }

  Index& parent(Index f) {
    const auto& patch = umbilic_.patch;
    return parent_[static_cast<std::size_t>(std::lower_bound(patch.begin(), patch.end(), f) -
                                            patch.begin())];
  }

  void build_tree() {
    parent(umbilic_.face) = umbilic_.face;
    std::vector<Index> queue{umbilic_.face};
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Index g = mesh_.neighbour(queue[i], k);
        if (!inside(g) || parent(g) != kernel::kNone) continue;
        parent(g) = queue[i];
        queue.push_back(g);
      }
  }

  // Appends the lines that enter face f through its side k, in order along the side.
  void add_lines(Index f, int k) {
    const Index g = mesh_.neighbour(f, k);
    if (!inside(g)) return add_crossings(f, k);
    if (parent(g) != f) return;
    int entry = 0;
    while (mesh_.neighbour(g, entry) != f) ++entry;
    // Seen from f the side runs A to B; around g, A to C and C to B follow it in the same order.
    const std::size_t first = lines_.size();
    for (int step : {1, 2}) add_lines(g, (entry + step) % 3);
    place_on_side(f, k, std::span(lines_).subspan(first));
  }

  void add_crossings(Index f, int k) {
    const Index e = mesh_.face_edges()[f][static_cast<std::size_t>(k)];
    const kernel::Edge& edge = mesh_.edges()[e];
    const std::size_t first = lines_.size();
    std::array<double, 2> at{};
    for (Colour c : {Colour::blue, Colour::red}) {
      if (!states_.is_crossed(e, c)) continue;
      const double weight = weight_(e, c);
      at[lines_.size() - first] = weight;
      lines_.push_back(
          {e, c, between(mesh_.points()[edge.v0], mesh_.points()[edge.v1], weight), {}});
    }
    if (lines_.size() < first + 2) return;
    const bool turned = mesh_.faces()[f][static_cast<std::size_t>(k)] != edge.v0;
    if ((at[1] < at[0]) != turned) std::swap(lines_[first], lines_[first + 1]);
  }

  // Each line passes the side where the straight way from its crossing to the umbilic comes
  // closest; if that does not keep their order, all pass at equal distances.
  void place_on_side(Index f, int k, std::span<Line> lines) {
    const auto i = static_cast<std::size_t>(k);
    const Vec3& a = mesh_.points()[mesh_.faces()[f][i]];
    const Vec3& b = mesh_.points()[mesh_.faces()[f][(i + 1) % 3]];
    at_.clear();
    for (const Line& line : lines) at_.push_back(nearest_to_straight_way(line.crossing, a, b));
    if (std::adjacent_find(at_.begin(), at_.end(), std::greater_equal<>()) != at_.end())
      for (std::size_t j = 0; j < at_.size(); ++j)
        at_[j] = static_cast<double>(j + 1) / static_cast<double>(at_.size() + 1);
    for (std::size_t j = 0; j < lines.size(); ++j) lines[j].points.push_back(between(a, b, at_[j]));
  }

  // Position in [0.1, 0.9] on ab closest to the line through the crossing and the umbilic.
  double nearest_to_straight_way(const Vec3& crossing, const Vec3& a, const Vec3& b) const {
    const Vec3& centre = umbilic_.point;
    double uu = 0, uv = 0, vv = 0, uw = 0, vw = 0;
    for (std::size_t x = 0; x < 3; ++x) {
      const double u = b[x] - a[x], v = centre[x] - crossing[x], w = a[x] - crossing[x];
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
  const Umbilic& umbilic_;
  Index number_;
  const CrossingWeight& weight_;
  std::vector<Index> parent_;  ///< of the patch's faces, in its order
  std::vector<Line> lines_;
  std::vector<double> at_;
};

}  // namespace

const std::vector<Vec3>& PatchJoins::at(Index edge, Colour colour) const {
  for (const PatchLine& line : lines)
    if (line.edge == edge && line.colour == colour) return line.points;
  throw std::out_of_range("an umbilic's contour is not crossed in edge " + std::to_string(edge));
}

PatchJoins join_patch(const kernel::TriangleMesh& mesh, const EdgeStates& states,
                      const std::vector<Index>& owner, const Umbilic& umbilic, Index number,
                      const CrossingWeight& weight) {
  return Joiner(mesh, states, owner, umbilic, number, weight).run();
}

}  // namespace crest::ridges
