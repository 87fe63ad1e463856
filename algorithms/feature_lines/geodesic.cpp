// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/feature_lines/geodesic.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "kernel/geometry/stop.hpp"

namespace crest::feature_lines {
namespace {

using kernel::distance;
using kernel::dot;
using kernel::norm;
using kernel::Triangle;
using kernel::TriangleMesh;
using kernel::Vec2;
using kernel::Vec3;
using kernel::operator-;

double squared(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return dot(d, d);
}

/// A corner at `apex` between a neighbour and a vertex beyond the opposite edge, in the unfolding.
struct Split {
  Index apex, near, far;
  double near_length, far_length, cosine;
};

/// The point at distances `dp`, `dq` from p and q, to the right of p -> q: where the face across
/// the edge lies when the face before it is to the left.
Vec2 across(const Vec2& p, const Vec2& q, double dp2, double dq2) {
  const Vec2 e = q - p;
  const double l2 = dot(e, e);
  const double t = 0.5 * (1 + (dp2 - dq2) / l2);
  const double h = std::sqrt(std::max(0.0, dp2 / l2 - t * t));
  return {p[0] + t * e[0] + h * e[1], p[1] + t * e[1] - h * e[0]};
}

/// Splits the obtuse corner k of face f: the faces beyond its opposite edge, unfolded into the
/// corner's plane, have a vertex in the section of directions that are less than a right angle from
/// both sides.
class Unfolder {
 public:
  Unfolder(const TriangleMesh& mesh, std::vector<Split>& splits) : mesh_(mesh), splits_(splits) {}

  bool split(Index f, std::size_t k) {
    const Triangle& t = mesh_.faces()[f];
    const Index c = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
    const auto& points = mesh_.points();
    const double ca2 = squared(points[c], points[a]), cb2 = squared(points[c], points[b]);
    const double ab2 = squared(points[a], points[b]);
    const double la = std::sqrt(ca2), along = 0.5 * (ca2 + cb2 - ab2) / la;
    const Vec2 start = {la, 0}, end = {along, std::sqrt(std::max(0.0, cb2 - along * along))};
    Vec2 p = start, q = end;
    Index vp = a, vq = b;
    for (int step = 0; step < kMostSteps; ++step) {
      const Index g = face_beyond(f, vp, vq);
      if (g == kNone) return false;
      const Triangle& u = mesh_.faces()[g];
      const Index d = u[0] != vp && u[0] != vq ? u[0] : u[1] != vp && u[1] != vq ? u[1] : u[2];
      const Vec2 r = across(p, q, squared(points[vp], points[d]), squared(points[vq], points[d]));
      const bool beside_start = dot(r, end) <= 0, beside_end = dot(r, start) <= 0;
      if (d == c || (beside_start && beside_end)) return false;
      if (!beside_start && !beside_end) {
        const double lr = norm(r), lb = std::sqrt(cb2);
        splits_.push_back({c, a, d, la, lr, dot(r, start) / (lr * la)});
        splits_.push_back({c, b, d, lb, lr, dot(r, end) / (lr * lb)});
        return true;
      }
      (beside_start ? p : q) = r;
      (beside_start ? vp : vq) = d;
      f = g;
    }
    return false;
  }

 private:
  static constexpr int kMostSteps = 32;

  Index face_beyond(Index f, Index a, Index b) const {
    const Triangle& t = mesh_.faces()[f];
    for (int k = 0; k < 3; ++k) {
      const Index x = t[static_cast<std::size_t>(k)], y = t[static_cast<std::size_t>((k + 1) % 3)];
      if ((x == a && y == b) || (x == b && y == a)) return mesh_.neighbour(f, k);
    }
    return kNone;
  }

  const TriangleMesh& mesh_;
  std::vector<Split>& splits_;
};

/// The value at a corner whose front is straight: values 0 at distance la, u >= 0 at distance lb,
/// `cosine` of the angle between. Infinite if the front does not come from within the corner.
double front(double la, double lb, double cosine, double u) {
  const double a2 = la * la, b2 = lb * lb, k = la * lb * cosine;
  const double det = a2 * b2 - k * k, scale = a2 + b2 - 2 * k, half = (a2 - k) * u;
  const double discriminant = half * half - scale * (a2 * u * u - det);
  if (!(det > 0) || discriminant < 0) return HUGE_VAL;
  const double t = (half + std::sqrt(discriminant)) / scale;
  const bool inside = b2 * t + k * (u - t) >= 0 && k * t + a2 * (u - t) <= 0 && t >= u;
  return inside ? t : HUGE_VAL;
}

class Marcher {
 public:
  explicit Marcher(const TriangleMesh& mesh)
      : mesh_(mesh),
        split_(3 * std::size_t{mesh.face_count()}, 0),
        splits_of_(mesh.vertex_count() + std::size_t{1}, 0),
        value_(mesh.vertex_count(), HUGE_VAL),
        done_(mesh.vertex_count(), 0) {
    split_obtuse_corners();
  }

  std::vector<double> march(const Marks& marks, double limit) {
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (marks[v]) relax(v, 0);
    while (!queue_.empty()) {
      kernel::stop_point();
      const auto [d, v] = queue_.top();
      queue_.pop();
      if (d > limit) break;
      if (done_[v]) continue;
      done_[v] = 1;
      pass_on(v);
    }
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (!done_[v]) value_[v] = HUGE_VAL;
    return std::move(value_);
  }

 private:
  void split_obtuse_corners() {
    Unfolder unfolder(mesh_, splits_);
    const auto& p = mesh_.points();
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      const Triangle& t = mesh_.faces()[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 &c = p[t[k]], &a = p[t[(k + 1) % 3]], &b = p[t[(k + 2) % 3]];
        if (squared(a, b) <= squared(a, c) + squared(b, c)) continue;
        split_[3 * std::size_t{f} + k] = unfolder.split(f, k) ? 1 : 0;
      }
    }
    // By the vertices whose values they take.
    for (const Split& s : splits_) ++splits_of_[s.near], ++splits_of_[s.far];
    std::size_t sum = 0;
    for (std::size_t& n : splits_of_) sum += std::exchange(n, sum);
    by_vertex_.resize(sum);
    std::vector<std::size_t> next(splits_of_.begin(), splits_of_.end() - 1);
    for (Index i = 0; i < splits_.size(); ++i) {
      by_vertex_[next[splits_[i].near]++] = i;
      by_vertex_[next[splits_[i].far]++] = i;
    }
  }

  void relax(Index v, double value) {
    if (!(value < value_[v])) return;
    value_[v] = value;
    queue_.push({value, v});
  }

  void pass_on(Index v) {
    const auto ring = mesh_.ring(v);
    const auto& p = mesh_.points();
    for (const Index w : ring)
      if (!done_[w]) relax(w, value_[v] + distance(p[v], p[w]));
    const auto fan = mesh_.fan(v);
    for (std::size_t j = 0; j < fan.size(); ++j) {
      const Index x = ring[j], y = ring[(j + 1) % ring.size()];
      if (done_[x] && !done_[y]) through_face(fan[j], y, v, x);
      if (done_[y] && !done_[x]) through_face(fan[j], x, v, y);
    }
    for (std::size_t i = splits_of_[v]; i < splits_of_[v + std::size_t{1}]; ++i) {
      const Split& s = splits_[by_vertex_[i]];
      if (done_[s.apex]) continue;
      if (v == s.far) relax(s.apex, value_[v] + s.far_length);
      if (done_[s.near] && done_[s.far])
        through_corner(s.apex, s.near, s.far, s.near_length, s.far_length, s.cosine);
    }
  }

  void through_face(Index f, Index c, Index a, Index b) {
    const Triangle& t = mesh_.faces()[f];
    const std::size_t k = t[0] == c ? 0 : t[1] == c ? 1 : 2;
    if (split_[3 * std::size_t{f} + k]) return;
    const auto& p = mesh_.points();
    const double a2 = squared(p[a], p[c]), b2 = squared(p[b], p[c]);
    const double la = std::sqrt(a2), lb = std::sqrt(b2);
    through_corner(c, a, b, la, lb, 0.5 * (a2 + b2 - squared(p[a], p[b])) / (la * lb));
  }

  void through_corner(Index c, Index a, Index b, double la, double lb, double cosine) {
    const double u = value_[b] - value_[a];
    const double t =
        u >= 0 ? value_[a] + front(la, lb, cosine, u) : value_[b] + front(lb, la, cosine, -u);
    relax(c, t);
  }

  using Entry = std::pair<double, Index>;
  const TriangleMesh& mesh_;
  std::vector<std::uint8_t> split_;  ///< 3 F: the corner is replaced by two of splits_
  std::vector<Split> splits_;
  std::vector<std::size_t> splits_of_;  ///< V + 1: where a vertex's begin in by_vertex_
  std::vector<Index> by_vertex_;
  std::vector<double> value_;
  std::vector<std::uint8_t> done_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

std::vector<double> geodesic_distances(const TriangleMesh& mesh, const Marks& marks, double limit) {
  return Marcher(mesh).march(marks, limit);
}

}  // namespace crest::feature_lines
