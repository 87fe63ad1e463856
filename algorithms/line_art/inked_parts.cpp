// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/inked_parts.hpp"

#include <algorithm>

namespace crest::line_art {
namespace {

using kernel::dot;
using kernel::operator+, kernel::operator-, kernel::operator*;

using Interval = std::array<double, 2>;

constexpr double kSpeck = 1e-3;  // mm: less is no ink

/// What is left of an interval.
std::vector<Interval> without(const Interval& whole, const std::vector<Interval>& covered) {
  std::vector<Interval> left = {whole};
  for (const auto& [from, to] : covered) {
    std::vector<Interval> next;
    for (const auto& [a, b] : left) {
      if (to <= a || b <= from) {
        next.push_back({a, b});
        continue;
      }
      if (a < from) next.push_back({a, from});
      if (to < b) next.push_back({to, b});
    }
    left = std::move(next);
  }
  return left;
}

class Pens {
 public:
  Pens(const Scene& scene, const View& view, const Contours& contours)
      : scene_(scene), view_(view), contours_(contours), sight_(view.eye, scene.points) {
    for (const ContourEdge& e : contours.edges) {
      const Vec3 &a = scene.points[e.a], &b = scene.points[e.b];
      PageBox box;
      box.add(view.see(a));
      box.add(view.see(b));
      boxes_.push_back(box);
      page_.push_back({view.project(a), view.project(b)});
    }
    find_coincident();
  }

  std::vector<InkedPart> run() const {
    std::vector<InkedPart> parts;
    for (Index i = 0; i < contours_.edges.size(); ++i) {
      const ContourEdge& e = contours_.edges[i];
      if (e.end_on) continue;
      std::vector<Interval> covered;
      for (const Index other : before_[i]) cover(i, other, covered);
      for (Index k = 0; k < e.pieces; ++k) {
        const Piece& p = contours_.pieces[e.first_piece + k];
        if (!p.drawn()) continue;
        if (covered.empty()) {
          parts.push_back({i, k, p.from, p.to, true, true});
          continue;
        }
        const Interval whole = {share(i, p.from), share(i, p.to)};
        const double length = kernel::norm(page_[i][1] - page_[i][0]);
        for (const auto& [from, to] : without(whole, covered)) {
          if ((to - from) * length < kSpeck) continue;
          const bool first = from == whole[0], last = to == whole[1];
          parts.push_back(
              {i, k, first ? p.from : place(i, from), last ? p.to : place(i, to), first, last});
        }
      }
    }
    return parts;
  }

 private:
  bool seen(Index edge) const {
    const ContourEdge& e = contours_.edges[edge];
    if (e.end_on) return false;
    return std::any_of(contours_.pieces.begin() + e.first_piece,
                       contours_.pieces.begin() + e.first_piece + e.pieces,
                       [](const Piece& p) { return p.drawn(); });
  }

  bool on_one_line(const ContourEdge& e, const ContourEdge& o) const {
    const auto on_line = [&](Index v) {
      return v == e.a || v == e.b || sight_.flat_side(e.a, e.b, v) == kernel::Sign::zero;
    };
    return on_line(o.a) && on_line(o.b);
  }

  /// From left to right, with those still open.
  void find_coincident() {
    before_.resize(contours_.edges.size());
    std::vector<Index> order, open;
    for (Index i = 0; i < contours_.edges.size(); ++i)
      if (seen(i)) order.push_back(i);
    std::sort(order.begin(), order.end(),
              [&](Index x, Index y) { return boxes_[x].x0 < boxes_[y].x0; });
    const auto later = [&](Index x, Index y) {
      return std::pair{contours_.edges[x].crease, x} > std::pair{contours_.edges[y].crease, y};
    };
    for (const Index i : order) {
      std::erase_if(open, [&](Index o) { return boxes_[o].x1 < boxes_[i].x0; });
      for (const Index o : open)
        if (boxes_[o].meets(boxes_[i]) && on_one_line(contours_.edges[o], contours_.edges[i]))
          before_[later(i, o) ? i : o].push_back(later(i, o) ? o : i);
      open.push_back(i);
    }
  }

  double depth(Index v) const { return view_.see(scene_.points[v]).near; }
  /// The share of an edge's length on the page at t, and t of a share.
  double share(Index edge, double t) const {
    if (!view_.eye.finite) return t;
    const ContourEdge& e = contours_.edges[edge];
    return t * depth(e.b) / ((1 - t) * depth(e.a) + t * depth(e.b));
  }
  double place(Index edge, double s) const {
    if (!view_.eye.finite) return s;
    const ContourEdge& e = contours_.edges[edge];
    return s * depth(e.a) / (s * depth(e.a) + (1 - s) * depth(e.b));
  }

  /// Where the other's visible pieces lie, as shares of the edge's length.
  void cover(Index edge, Index other, std::vector<Interval>& covered) const {
    const auto& [a, b] = page_[edge];
    const auto& [c, d] = page_[other];
    const Vec2 along = b - a;
    const auto project = [&](double s) {
      return dot(c + s * (d - c) - a, along) / dot(along, along);
    };
    const ContourEdge& o = contours_.edges[other];
    for (Index k = o.first_piece; k < o.first_piece + o.pieces; ++k) {
      const Piece& p = contours_.pieces[k];
      if (!p.drawn()) continue;
      const auto [from, to] =
          std::minmax({project(share(other, p.from)), project(share(other, p.to))});
      if (from < 1 && to > 0) covered.push_back({from, to});
    }
  }

  const Scene& scene_;
  const View& view_;
  const Contours& contours_;
  kernel::Sight sight_;
  std::vector<PageBox> boxes_;
  std::vector<std::array<Vec2, 2>> page_;
  std::vector<std::vector<Index>> before_;  ///< those on an edge's line that are inked before it
};

}  // namespace

std::vector<InkedPart> inked_parts(const Scene& scene, const View& view, const Contours& contours) {
  return Pens(scene, view, contours).run();
}

}  // namespace crest::line_art
