// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/lineart/page.hpp"

#include <cmath>

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/exact/vector.hpp"
#include "certify/lineart/span.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;
using kernel::Rational;
using kernel::Sign;
template <class T>
using Plane = std::array<T, 2>;

/// The page map over a number type.
template <class T>
class PageMap {
 public:
  explicit PageMap(const LineArtCertificate& c)
      : parallel_(c.parallel),
        eye_(lift(c.eye)),
        x_(lift(c.view.axes[0])),
        y_(lift(c.view.axes[1])),
        z_(lift(c.view.axes[2])),
        origin_{T(c.view.origin[0]), T(c.view.origin[1])},
        scale_{T(c.view.scale[0]), T(c.view.scale[1])} {
    if (!parallel_) return;
    x_ = cross(y_, eye_);
    y_ = cross(eye_, x_);
  }

  static Vector<T> lift(const std::array<double, 3>& p) { return {T(p[0]), T(p[1]), T(p[2])}; }

  Plane<T> place(const Vector<T>& p) const {
    if (parallel_) {
      const T x = scale_[0] * dot(x_, p), y = scale_[1] * dot(y_, p);
      return {T(x - origin_[0]), T(origin_[1] - y)};
    }
    const Vector<T> q = p - eye_;
    const T z = dot(z_, q), x = dot(x_, q) / z, y = dot(y_, q) / z;
    return {T((x - origin_[0]) * scale_[0]), T((origin_[1] - y) * scale_[1])};
  }
  /// Larger nearer to the eye; affine on the page where a face is seen.
  T nearness(const Vector<T>& p) const {
    if (parallel_) return dot(eye_, p);
    return T(1) / dot(z_, p - eye_);
  }
  /// Zero iff points of the page have no sight line each.
  T rank() const {
    if (parallel_) return dot(x_, x_) * dot(eye_, eye_);
    return dot(x_, cross(y_, z_));
  }
  T in_front(const Vector<T>& p) const { return dot(z_, p - eye_); }

 private:
  bool parallel_;
  Vector<T> eye_, x_, y_, z_;
  Plane<T> origin_, scale_;
};

/// Twice the area of a triangle.
Rational turn(const Plane<Rational>& p, const Plane<Rational>& q, const Plane<Rational>& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

bool opposite_or_zero(const Rational& a, const Rational& b) {
  return !((a > 0 && b > 0) || (a < 0 && b < 0));
}

/// Of closed segments on one line.
bool overlap_beyond(const Plane<Rational>& p, const Plane<Rational>& q, const Plane<Rational>& u,
                    const Plane<Rational>& v, bool but_p, bool but_q) {
  const std::size_t k = p[0] != q[0] ? 0 : 1;
  const Rational low = std::max(std::min(p[k], q[k]), std::min(u[k], v[k])),
                 high = std::min(std::max(p[k], q[k]), std::max(u[k], v[k]));
  if (low > high) return false;
  return low < high || !((but_p && low == p[k]) || (but_q && low == q[k]));
}

/// Whether the segments p q and u v have a point in common, but for p and q where they do not
/// count. Requires: p != q.
bool meet(const Plane<Rational>& p, const Plane<Rational>& q, const Plane<Rational>& u,
          const Plane<Rational>& v, bool but_p, bool but_q) {
  const Rational at_u = turn(p, q, u), at_v = turn(p, q, v);
  if (!opposite_or_zero(at_u, at_v)) return false;
  if (at_u == 0 && at_v == 0) return overlap_beyond(p, q, u, v, but_p, but_q);
  const Rational at_p = turn(u, v, p), at_q = turn(u, v, q);
  if (!opposite_or_zero(at_p, at_q)) return false;
  return !((but_p && at_p == 0) || (but_q && at_q == 0));
}

PlaneBox enclose(const Plane<Rational>& p) {
  std::array<Span, 2> place;
  // Conversion cuts digits off: an ulp, and the span moves another.
  for (std::size_t n = 0; n < 2; ++n) {
    const double x = p[n].convert_to<double>();
    place[n] = Span(x, x) + Span(0.0);
  }
  return box_of(place);
}

/// A part of the page that no hatch may meet; a point where both ends are one.
struct Barrier {
  Plane<Rational> from, to;
};

class Barriers {
 public:
  Barriers(const LineArtCertificate& c, const PageMap<Rational>& map,
           const std::vector<FoundEdge>& edges)
      : c_(c), map_(map) {
    for (const FoundEdge& found : edges)
      if (found.edge.occluding || found.edge.rim) add(found);
    std::vector<PlaneBox> boxes;
    for (const Barrier& barrier : barriers_) {
      PlaneBox box = enclose(barrier.from);
      box.add(enclose(barrier.to));
      boxes.push_back(box);
    }
    tree_ = std::make_unique<BoxTree>(std::move(boxes));
  }

  bool holds(const Plane<Rational>& p) const {
    bool found = false;
    tree_->query(enclose(p), [&](u32 i) {
      const Plane<Rational>&u = barriers_[i].from, &v = barriers_[i].to;
      if (found || turn(u, v, p) != 0) return;
      const auto between = [&](std::size_t k) {
        return std::min(u[k], v[k]) <= p[k] && p[k] <= std::max(u[k], v[k]);
      };
      found = between(0) && between(1);
    });
    return found;
  }
  bool cut(const Plane<Rational>& p, const Plane<Rational>& q, bool but_p, bool but_q) const {
    PlaneBox box = enclose(p);
    box.add(enclose(q));
    bool found = false;
    tree_->query(box, [&](u32 i) {
      found = found || meet(p, q, barriers_[i].from, barriers_[i].to, but_p, but_q);
    });
    return found;
  }

 private:
  void add(const FoundEdge& found) {
    const Vector<Rational> a = PageMap<Rational>::lift(c_.points[found.edge.low]),
                           b = PageMap<Rational>::lift(c_.points[found.edge.high]);
    const auto at = [&](const Rational& t) {
      return map_.place(Vector<Rational>{(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y,
                                         (1 - t) * a.z + t * b.z});
    };
    const auto add_point = [&](const Rational& t) { barriers_.push_back({at(t), at(t)}); };
    if (found.end_on || found.busy_low) add_point(0);
    if (found.end_on || found.busy_high) add_point(1);
    Rational from = 0;
    for (std::size_t i = 0; i < found.pieces.size(); ++i) {
      const Rational to = i < found.breaks.size() ? found.breaks[i].t : Rational(1);
      if (found.pieces[i].hiding == 0) barriers_.push_back({at(from), at(to)});
      if (i < found.breaks.size() && found.breaks[i].events.size() > 1) add_point(to);
      from = to;
    }
  }

  const LineArtCertificate& c_;
  const PageMap<Rational>& map_;
  std::vector<Barrier> barriers_;
  std::unique_ptr<BoxTree> tree_;
};

/// The faces as they are on the page.
class PageFaces {
 public:
  PageFaces(const LineArtCertificate& c, const PageMap<Rational>& map) : c_(c), map_(map) {
    const PageMap<Span> rough(c);
    std::vector<PlaneBox> corner, boxes;
    for (const auto& p : c.points) corner.push_back(box_of(rough.place(rough.lift(p))));
    for (const auto& face : c.faces) {
      PlaneBox box;
      for (const u32 v : face) box.add(corner[v]);
      boxes.push_back(box);
    }
    tree_ = std::make_unique<BoxTree>(std::move(boxes));
  }

  /// Whether p is strictly inside the face on the page, and no face there is nearer to the eye.
  bool nearest(u32 face, const Plane<Rational>& p) const {
    const auto depth = depth_of(face, p);
    if (!depth.strictly) return false;
    bool first = true;
    tree_->query(enclose(p), [&](u32 f) {
      if (!first || f == face) return;
      const Depth other = depth_of(f, p);
      first = !other.inside || other.nearest <= depth.nearest;
    });
    return first;
  }

 private:
  struct Depth {
    bool inside, strictly;
    Rational nearest;
  };
  Depth depth_of(u32 face, const Plane<Rational>& p) const {
    std::array<Plane<Rational>, 3> at;
    std::array<Rational, 3> near, share;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = PageMap<Rational>::lift(c_.points[c_.faces[face][k]]);
      at[k] = map_.place(v);
      near[k] = map_.nearness(v);
    }
    const Rational area = turn(at[0], at[1], at[2]);
    // Seen edge-on: as near as its nearest corner where its box is and p on its line.
    if (area == 0) {
      const bool on_line =
          turn(at[0], at[1], p) == 0 && turn(at[1], at[2], p) == 0 && turn(at[2], at[0], p) == 0;
      return {on_line, false, *std::max_element(near.begin(), near.end())};
    }
    Depth depth{true, true, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      share[k] = turn(p, at[(k + 1) % 3], at[(k + 2) % 3]) / area;
      depth.inside = depth.inside && share[k] >= 0;
      depth.strictly = depth.strictly && share[k] > 0;
      depth.nearest += share[k] * near[k];
    }
    return depth;
  }

  const LineArtCertificate& c_;
  const PageMap<Rational>& map_;
  std::unique_ptr<BoxTree> tree_;
};

}  // namespace

void check_view(const LineArtCertificate& c) {
  require(c.eye != std::array<double, 3>{0, 0, 0} || !c.parallel, "view: the direction is zero");
  require(c.view.scale[0] > 0 && c.view.scale[1] > 0, "view: a scale is not positive");
  const std::array<double, 3> none{};
  require(!c.parallel || (c.view.axes[0] == none && c.view.axes[2] == none),
          "view: a parallel one has axes besides `up`");
  const PageMap<Rational> map(c);
  require(map.rank() != 0, "view: points of the page have no sight line each");
  if (c.parallel) return;
  const PageMap<Span> rough(c);
  for (u32 v = 0; v < c.points.size(); ++v) {
    if (rough.in_front(rough.lift(c.points[v])).low > 0) continue;
    require(map.in_front(map.lift(c.points[v])) > 0, "vertex {}: is not in front of the eye", v);
  }
}

void check_hatches(const LineArtCertificate& c, const std::vector<FoundEdge>& edges) {
  if (c.hatches.empty()) return;
  const PageMap<Rational> map(c);
  const Barriers barriers(c, map, edges);
  const PageFaces faces(c, map);
  const auto exact = [](const std::array<double, 2>& p) {
    return Plane<Rational>{Rational(p[0]), Rational(p[1])};
  };
  parallel_for(
      c.hatches.size(), [] { return 0; },
      [&](int, std::size_t h) {
        const auto& hatch = c.hatches[h];
        require(hatch.size() >= 2, "hatch {}: has fewer than two points", h);
        for (std::size_t i = 0; i + 1 < hatch.size(); ++i) {
          require(hatch[i] != hatch[i + 1], "hatch {}: repeats point {}", h, i);
          const bool cut =
              barriers.cut(exact(hatch[i]), exact(hatch[i + 1]), i == 0, i + 2 == hatch.size());
          require(!cut, "hatch {}: segment {} meets a visible contour", h, i);
        }
        const Plane<Rational> p = exact(hatch[0]), q = exact(hatch[1]);
        const Plane<Rational> start =
            barriers.holds(p)
                ? Plane<Rational>{Rational((p[0] + q[0]) / 2), Rational((p[1] + q[1]) / 2)}
                : p;
        require(c.hatch_faces[h] < c.faces.size() && faces.nearest(c.hatch_faces[h], start),
                "hatch {}: face {} is not the one seen where it starts", h, c.hatch_faces[h]);
      });
}

}  // namespace crest::certify
