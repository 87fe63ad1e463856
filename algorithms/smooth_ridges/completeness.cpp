// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/completeness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace crest::smooth_ridges {
namespace {

using kernel::Interval;
using Box = std::array<double, 6>;
using Cube = std::array<Interval, 3>;
using Gradient = std::array<Interval, 3>;

constexpr Vec3 kA = {8, -5, 2}, kB = {3, 7, -9};
constexpr int kDeepest = 60, kDeepestAtBoundary = 36;
constexpr std::uint8_t kNoZero = 3, kNoA = 4, kNoB = 5, kInBox = 6;

/// Without zero, with room for a checker whose enclosures are a little wider. False of what is not
/// defined.
bool avoids_zero(const Interval& x) {
  if (!is_defined(x)) return false;
  const double room = 0.02 * (x.sup() - x.inf());
  return x.inf() > room || x.sup() < -room;
}

/// a, by mean values b. Undefined if a is; b may be so alone, without derivatives.
Interval meet(const Interval& a, const Interval& b) {
  if (!is_defined(a) || !is_defined(b)) return a;
  const double low = std::max(a.inf(), b.inf()), high = std::min(a.sup(), b.sup());
  return low <= high ? Interval(low, high) : a;
}

class Enclosures {
 public:
  explicit Enclosures(const Surface& surface)
      : value_(surface), first_(surface), second_(surface) {}

  struct First {
    Interval f;
    Gradient gradient;
  };
  First first(const Cube& k) {
    const auto jet = first_(k);
    First r{jet[0], {jet.coefficient(1, 0, 0), jet.coefficient(0, 1, 0), jet.coefficient(0, 0, 1)}};
    const Cube c = centre(k);
    r.f = meet(r.f, value_(c)[0] + dot(r.gradient, k - c));
    return r;
  }

  /// grad F and its enclosure by mean values.
  struct Second {
    Gradient gradient;
    std::array<Gradient, 3> hessian;
    Gradient centre;
    Gradient offset;
  };
  Second second(const Cube& k) {
    const auto jet = second_(k);
    Second s;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        std::array<int, 3> e{};
        ++e[i], ++e[j];
        s.hessian[i][j] = jet.derivative(e[0], e[1], e[2]);
      }
    const Cube c = centre(k);
    const auto at = first_(c);
    s.gradient = {jet.coefficient(1, 0, 0), jet.coefficient(0, 1, 0), jet.coefficient(0, 0, 1)};
    s.centre = {at.coefficient(1, 0, 0), at.coefficient(0, 1, 0), at.coefficient(0, 0, 1)};
    s.offset = k - c;
    return s;
  }
  /// w . grad F.
  static Interval slope(const Second& s, const Vec3& w) {
    Interval plain = 0, mean = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      plain = plain + s.gradient[i] * w[i];
      mean = mean + s.centre[i] * w[i];
    }
    for (std::size_t j = 0; j < 3; ++j) {
      Interval row = 0;
      for (std::size_t i = 0; i < 3; ++i) row = row + s.hessian[i][j] * w[i];
      mean = mean + row * s.offset[j];
    }
    return meet(plain, mean);
  }
  static Cube cell(const Box& b) {
    return {Interval(b[0], b[1]), Interval(b[2], b[3]), Interval(b[4], b[5])};
  }

 private:
  static Cube centre(const Cube& k) {
    Cube c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = Interval(k[i].inf() / 2 + k[i].sup() / 2);
    return c;
  }

  ImplicitMap<Interval, 0> value_;
  ImplicitMap<Interval, 1> first_;
  ImplicitMap<Interval, 2> second_;
};

/// Zeros of (F, a . grad F, b . grad F) in doubles.
class CriticalPoints {
 public:
  explicit CriticalPoints(const Surface& surface) : map_(surface) {}

  std::optional<Vec3> near(Vec3 p, double reach) {
    constexpr int kSteps = 20;
    double gone = 0;
    for (int i = 0; i < kSteps; ++i) {
      const auto f = map_(p);
      const Vec3 g = {f.coefficient(1, 0, 0), f.coefficient(0, 1, 0), f.coefficient(0, 0, 1)};
      std::array<Vec3, 3> rows = {g, Vec3{}, Vec3{}};
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c) {
          std::array<int, 3> e{};
          ++e[r], ++e[c];
          const double h = f.derivative(e[0], e[1], e[2]);
          rows[1][c] += kA[r] * h;
          rows[2][c] += kB[r] * h;
        }
      const Vec3 right = {-f[0], -dot(kA, g), -dot(kB, g)};
      const double det = determinant(rows[0], rows[1], rows[2]);
      Vec3 d = {};
      d = d + right[0] / det * cross(rows[1], rows[2]);
      d = d + right[1] / det * cross(rows[2], rows[0]);
      d = d + right[2] / det * cross(rows[0], rows[1]);
      const double move = norm(d);
      gone += move;
      if (!(gone <= reach)) return std::nullopt;
      p = p + d;
      if (move <= 0x1p-40 * reach) return p;
    }
    return std::nullopt;
  }

 private:
  ImplicitMap<double, 2> map_;
};

Vec3 centre_of(const Box& b) {
  return {(b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2};
}

const char* text_of(CoverFailure::Reason reason, bool deepest) {
  using Reason = CoverFailure::Reason;
  if (reason == Reason::stopped) return "stopped while the box was searched for components,";
  if (reason == Reason::boundary) return "the surface reaches the boundary of the box";
  if (reason == Reason::singular)
    return "F and its gradient vanish together, or nearly so: a singular point";
  return deepest ? "neither F nor its critical points could be told from zero"
                 : "the budget of cells was spent";
}

class Coverer {
 public:
  Coverer(const Surface& surface, std::size_t budget, const Stop& stop)
      : surface_(surface), enclose_(surface), critical_(surface), budget_(budget), stop_(stop) {}

  CoverResult run() {
    visit(surface_.box(), 0);
    if (failure_) return {std::nullopt, failure_};
    return {std::move(cover_), std::nullopt};
  }

 private:
  void visit(const Box& b, int depth) {
    if (failure_) return;
    if (++cover_.cells > budget_) return fail(CoverFailure::Reason::undecided, b, depth);
    if (is_over(stop_)) return fail(CoverFailure::Reason::stopped, b, depth);
    const bool outer = touches_boundary(b);
    if (const auto leaf = decide(b, outer)) {
      cover_.tree.push_back(*leaf);
      if (*leaf == kInBox)
        for (unsigned i = 0; i < 4; ++i)
          cover_.tree.push_back(static_cast<std::uint8_t>(in_box_ >> (8 * i)));
      return;
    }
    if (depth >= (outer ? kDeepestAtBoundary : kDeepest))
      return fail(outer ? CoverFailure::Reason::boundary : CoverFailure::Reason::undecided, b,
                  depth);
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (b[2 * k + 1] - b[2 * k] > b[2 * axis + 1] - b[2 * axis]) axis = k;
    const double middle = (b[2 * axis] + b[2 * axis + 1]) / 2;
    cover_.tree.push_back(static_cast<std::uint8_t>(axis));
    Box lower = b, upper = b;
    lower[2 * axis + 1] = upper[2 * axis] = middle;
    visit(lower, depth + 1);
    visit(upper, depth + 1);
  }

  bool touches_boundary(const Box& b) const {
    for (std::size_t k = 0; k < 6; ++k)
      if (b[k] == surface_.box()[k]) return true;
    return false;
  }

  bool in_graph_box(const Box& b) {
    for (std::size_t j = 0; j < cover_.boxes.size(); ++j) {
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k)
        inside = inside && cover_.boxes[j].box[2 * k] <= b[2 * k] &&
                 b[2 * k + 1] <= cover_.boxes[j].box[2 * k + 1];
      if (!inside) continue;
      in_box_ = j;
      return true;
    }
    return false;
  }

  /// The leaf's code, or nothing if the cell is to be split.
  std::optional<std::uint8_t> decide(const Box& b, bool outer) {
    if (!outer && in_graph_box(b)) return kInBox;
    {
      const kernel::RoundUpward guard;
      const Cube k = Enclosures::cell(b);
      if (avoids_zero(enclose_.first(k).f)) return kNoZero;
      if (outer) return std::nullopt;
      const auto s = enclose_.second(k);
      if (avoids_zero(Enclosures::slope(s, kA))) return kNoA;
      if (avoids_zero(Enclosures::slope(s, kB))) return kNoB;
    }
    if (find_graph_box(b) && in_graph_box(b)) return kInBox;
    return std::nullopt;
  }

  /// Looks for a critical point in or near the cell that no graph box holds.
  bool find_graph_box(const Box& b) {
    const Vec3 middle = centre_of(b);
    const double size = std::max({b[1] - b[0], b[3] - b[2], b[5] - b[4]});
    const auto p = critical_.near(middle, 3 * size);
    if (!p) return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (std::fabs((*p)[k] - middle[k]) > 0.75 * (b[2 * k + 1] - b[2 * k])) return false;
    for (const auto& known : cover_.boxes) {
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k)
        inside = inside && known.box[2 * k] < (*p)[k] && (*p)[k] < known.box[2 * k + 1];
      if (inside) return false;
    }
    return add_graph_box(*p);
  }

  /// The largest that holds, by halving.
  bool add_graph_box(const Vec3& p) {
    constexpr int kHalvings = 24;
    const Box& outer = surface_.box();
    double size = std::max({outer[1] - outer[0], outer[3] - outer[2], outer[5] - outer[4]}) / 4;
    for (int i = 0; i < kHalvings; ++i, size /= 1.5)
      for (const double ratio : {2.0, 1.6, 2.6})
        if (const auto record = graph_box(p, size, ratio)) {
          cover_.boxes.push_back(*record);
          cover_.critical_points.push_back(p);
          return true;
        }
    return false;
  }

  /// Half sides `size`, along the axis `ratio` times as long: at the critical point the slopes
  /// along the other axes are 31/78 and 71/78.
  std::optional<certify::GraphBoxRecord> graph_box(const Vec3& p, double size, double ratio) {
    const kernel::RoundUpward guard;
    const auto at = enclose_.first(Enclosures::cell({p[0], p[0], p[1], p[1], p[2], p[2]})).gradient;
    certify::GraphBoxRecord r;
    for (std::uint8_t k = 1; k < 3; ++k) {
      const auto magnitude = [&](std::size_t i) { return std::fabs(at[i].inf() + at[i].sup()); };
      if (magnitude(k) > magnitude(r.axis)) r.axis = k;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double half = k == r.axis ? size * ratio : size;
      r.box[2 * k] = p[k] - half + 0.0;
      r.box[2 * k + 1] = p[k] + half + 0.0;
      if (!(r.box[2 * k] > surface_.box()[2 * k] && r.box[2 * k + 1] < surface_.box()[2 * k + 1]))
        return std::nullopt;
    }
    Vec3 unit{};
    unit[r.axis] = 1;
    if (!avoids_zero(Enclosures::slope(enclose_.second(Enclosures::cell(r.box)), unit)))
      return std::nullopt;
    std::array<Interval, 2> sides;
    for (std::size_t side = 0; side < 2; ++side) {
      Box flat = r.box;
      flat[2u * r.axis + 1 - side] = flat[2u * r.axis + side];
      sides[side] = enclose_.first(Enclosures::cell(flat)).f;
      if (!avoids_zero(sides[side])) return std::nullopt;
    }
    if ((sides[0].inf() > 0) == (sides[1].inf() > 0)) return std::nullopt;
    return r;
  }

  void fail(CoverFailure::Reason reason, const Box& b, int depth) {
    const Vec3 p = centre_of(b);
    bool flat = true;
    {
      const kernel::RoundUpward guard;
      for (const Interval& g : enclose_.first(Enclosures::cell(b)).gradient)
        flat = flat && g.inf() <= 0 && g.sup() >= 0;
    }
    if (flat && reason == CoverFailure::Reason::undecided) reason = CoverFailure::Reason::singular;
    char line[256];
    std::snprintf(line, sizeof line, "%s near (%.6g, %.6g, %.6g)",
                  text_of(reason, depth >= kDeepest), p[0], p[1], p[2]);
    failure_ = CoverFailure{reason, p, line};
  }

  const Surface& surface_;
  Enclosures enclose_;
  CriticalPoints critical_;
  std::size_t budget_, in_box_ = 0;
  const Stop& stop_;
  Cover cover_;
  std::optional<CoverFailure> failure_;
};

}  // namespace

CoverResult cover_box(const Surface& surface, std::size_t budget, const Stop& stop) {
  return Coverer(surface, budget, stop).run();
}

namespace {

/// The vertex nearest to p among those that `wanted` takes.
template <class Wanted>
std::optional<Index> nearest_vertex(const Triangulation& mesh, const Vec3& p, Wanted&& wanted) {
  std::optional<Index> best;
  double nearest = HUGE_VAL;
  for (Index v = 0; v < mesh.vertices().size(); ++v) {
    const Vec3 x = position(mesh.vertices()[v]);
    const double distance = norm(x - p);
    if (distance >= nearest || !wanted(x)) continue;
    nearest = distance;
    best = v;
  }
  return best;
}

bool well_inside(const Box& b, const Vec3& x) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double room = 1e-3 * (b[2 * k + 1] - b[2 * k]);
    if (!(x[k] > b[2 * k] + room && x[k] < b[2 * k + 1] - room)) return false;
  }
  return true;
}

void refine_at(Triangulation& mesh, Index vertex) {
  std::vector<Index> around;
  for (Index f = 0; f < mesh.faces().size(); ++f)
    for (const Index v : mesh.faces()[f])
      if (v == vertex) around.push_back(f);
  mesh.refine(around);
}

}  // namespace

std::vector<FineSpot> known_points(const Cover& cover) {
  std::vector<FineSpot> points;
  for (std::size_t j = 0; j < cover.boxes.size(); ++j) {
    const Box& box = cover.boxes[j].box;
    const std::size_t across = cover.boxes[j].axis == 0 ? 2 : 0;
    points.push_back({cover.critical_points[j], (box[across + 1] - box[across]) / 2});
  }
  return points;
}

std::optional<std::size_t> place_vertices(Cover& cover, Triangulation& mesh) {
  constexpr int kRounds = 40;
  for (std::size_t j = 0; j < cover.boxes.size(); ++j) {
    const Vec3& p = cover.critical_points[j];
    std::optional<Index> found;
    for (int round = 0; !found && round < kRounds; ++round) {
      found = nearest_vertex(mesh, p,
                             [&](const Vec3& x) { return well_inside(cover.boxes[j].box, x); });
      const auto any = nearest_vertex(mesh, p, [](const Vec3&) { return true; });
      if (!found && any) refine_at(mesh, *any);
    }
    if (!found) return j;
    cover.boxes[j].vertex = *found;
  }
  return std::nullopt;
}

}  // namespace crest::smooth_ridges
