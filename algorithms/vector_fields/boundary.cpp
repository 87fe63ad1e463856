// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/boundary.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::vector_fields {

using kernel::Sign;

namespace {

/// The sign of a loop's area.
int turning_of(const Domain& domain, const std::vector<HalfEdge>& loop) {
  kernel::Approximate sum;
  const Vec2 o = domain.point(domain.from(loop[0]));
  for (const HalfEdge h : loop) {
    const Vec2 &p = domain.point(domain.from(h)), &q = domain.point(domain.to(h));
    using A = kernel::Approximate;
    sum = sum +
          ((A(p[0]) - A(o[0])) * (A(q[1]) - A(o[1])) - (A(p[1]) - A(o[1])) * (A(q[0]) - A(o[0])));
  }
  constexpr std::size_t kTerms = 990;  // Approximate's theorem is for depths to 1000
  if (loop.size() <= kTerms)
    if (const auto s = kernel::certain_sign(sum, kTerms + 6)) return static_cast<int>(*s);
  kernel::Rational exact = 0;
  for (const HalfEdge h : loop) {
    const Vec2 &p = domain.point(domain.from(h)), &q = domain.point(domain.to(h));
    using R = kernel::Rational;
    exact += R(p[0]) * R(q[1]) - R(p[1]) * R(q[0]);
  }
  return exact < 0 ? -1 : 1;
}

/// One end of a boundary edge.
struct EdgeEnd {
  Sign across = Sign::zero;
  bool zero = false;  ///< the vector is
};

/// The signs along one loop.
class LoopSigns {
 public:
  LoopSigns(const Domain& domain, const std::vector<HalfEdge>& loop)
      : domain_(domain), loop_(loop) {
    for (const HalfEdge h : loop) {
      const Vec2 &p = domain.point(domain.from(h)), &q = domain.point(domain.to(h));
      for (const Index v : {domain.from(h), domain.to(h)})
        ends_.push_back({kernel::flow_across(p, q, domain.vector(v)), domain.is_zero(v)});
      const Sign turn =
          kernel::vector_turn(domain.vector(domain.from(h)), domain.vector(domain.to(h)));
      // Opposite signs across with parallel vectors: a zero inside the edge.
      zero_inside_.push_back(turn == Sign::zero && opposite(ends_.size() / 2 - 1));
    }
  }
  std::size_t size() const { return ends_.size(); }
  const EdgeEnd& end(std::size_t i) const { return ends_[i % ends_.size()]; }
  bool zero_inside(std::size_t edge) const { return zero_inside_[edge]; }

  /// The sign of the flow along the edge at one of its ends.
  Sign along(std::size_t end) const {
    const HalfEdge h = loop_[end / 2];
    return kernel::flow_along(domain_.point(domain_.from(h)), domain_.point(domain_.to(h)),
                              domain_.vector(end % 2 == 0 ? domain_.from(h) : domain_.to(h)));
  }
  /// How the loop turns from edge i to edge j, which follows it.
  Sign corner(std::size_t i, std::size_t j) const {
    return kernel::orientation(domain_.point(domain_.from(loop_[i])),
                               domain_.point(domain_.to(loop_[i])),
                               domain_.point(domain_.to(loop_[j])));
  }
  /// None if a zero lies on the loop.
  std::optional<int> winding() const {
    int sum = 0;
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      if (zero_inside_[i] || ends_[2 * i].zero) return std::nullopt;
      sum += axis_crossing(domain_.vector(domain_.from(loop_[i])),
                           domain_.vector(domain_.to(loop_[i])));
    }
    return sum;
  }

 private:
  bool opposite(std::size_t i) const {
    return ends_[2 * i].across * ends_[2 * i + 1].across == Sign::negative ||
           (ends_[2 * i].across == Sign::zero && !ends_[2 * i].zero && !ends_[2 * i + 1].zero &&
            along(2 * i) != along(2 * i + 1));
  }

  const Domain& domain_;
  const std::vector<HalfEdge>& loop_;
  std::vector<EdgeEnd> ends_;
  std::vector<bool> zero_inside_;
};

/// Walks around one loop.
class LoopWalk {
 public:
  LoopWalk(const Domain& domain, const std::vector<HalfEdge>& loop, Index number, Boundary& result,
           Index& regions)
      : domain_(domain),
        loop_(loop),
        signs_(domain, loop),
        number_(number),
        result_(result),
        regions_(regions) {}

  BoundaryLoop walk() {
    out_.length = static_cast<Index>(loop_.size());
    out_.turning = turning_of(domain_, loop_);
    out_.winding = signs_.winding();
    const std::size_t n = signs_.size();
    std::size_t start = 0;
    while (start < n && signs_.end(start).across == Sign::zero) ++start;
    if (start == n) {
      bool wall = false;
      for (std::size_t i = 0; i < n; ++i) wall = wall || signs_.end(i).zero;
      ++(wall ? out_.zero : out_.tangent);
      ++regions_;
      return out_;
    }
    const std::size_t first_switch = result_.switch_points.size();
    Index events = 0;
    count_region(signs_.end(start).across, 1);
    std::vector<std::pair<std::size_t, Index>> events_before = {{start, 0}};
    std::size_t last = start;
    for (std::size_t at = start + 1; at < start + n; ++at) {
      const Sign across = signs_.end(at).across;
      if (across == Sign::zero) continue;
      if (separates(last, at)) {
        ++events;
        count_region(across, 1);
      }
      events_before.push_back({at % n, events});
      last = at;
    }
    // The last run joins the first unless something lies between.
    if (separates(last, start + n))
      ++events;
    else if (events > 0)
      count_region(signs_.end(start).across, -1);
    // Region r follows event r; the loop's start lies in the last one.
    const Index count = std::max<Index>(events, 1);
    for (const auto& [end, before] : events_before)
      set_region(end, regions_ + (before + count - 1) % count);
    regions_ += count;
    std::sort(result_.switch_points.begin() + static_cast<std::ptrdiff_t>(first_switch),
              result_.switch_points.end(), [&](const SwitchPoint& a, const SwitchPoint& b) {
                return place_of(a) < place_of(b);
              });
    return out_;
  }

 private:
  void count_region(Sign s, int by) { (s == Sign::positive ? out_.inflow : out_.outflow) += by; }
  void set_region(std::size_t end, Index region) {
    EdgeRegions& r = result_.regions[loop_[end / 2]];
    (end % 2 == 0 ? r.at_from : r.at_to) = region;
  }
  /// Looks between two ends whose flow across is not zero, all between them being zero: whether a
  /// region ends there; a switch point is added. Ends count on around the loop.
  bool separates(std::size_t a, std::size_t b) {
    const std::size_t n = signs_.size();
    const auto end = [&](std::size_t i) -> const EdgeEnd& { return signs_.end(i); };
    const Sign before = end(a).across, after = end(b).across;
    bool zero = false;
    for (std::size_t i = a; i <= b; ++i) {
      zero = zero || end(i).zero;
      if (i % 2 == 0 && i < b) zero = zero || signs_.zero_inside(i % n / 2);
    }
    if (zero) {
      ++out_.zero;
      return true;
    }
    if (b == a + 1) {
      if (before == after) return false;
      if (a % 2 == 0)
        add_in_edge(a % n / 2, after);
      else
        add_corner(a % n / 2, b % n / 2, after);
      return true;
    }
    if (b > a + 2 + (a + 1) % 2) ++out_.tangent;  // both ends of an edge
    if (before == after) return false;
    add_run(a + 1, b - 1, after);
    return true;
  }

  SwitchPoint& add(HalfEdge h, Sign after) {
    SwitchPoint& s = result_.switch_points.emplace_back();
    s.loop = number_;
    s.edge = s.last_edge = s.side = h;
    s.point = domain_.point(domain_.from(h));
    s.inflow_after = after == Sign::positive;
    return s;
  }
  void note(const SwitchPoint& s) { ++(s.inside ? out_.interior : out_.exterior); }

  void add_in_edge(std::size_t i, Sign after) {
    const HalfEdge h = loop_[i];
    const Index a = domain_.from(h), b = domain_.to(h);
    SwitchPoint& s = add(h, after);
    s.inside = kernel::vector_turn(domain_.vector(a), domain_.vector(b)) == Sign::positive;
    const auto flow = [&](Index v) {
      return std::fabs(kernel::FlowAcross{domain_.point(a), domain_.point(b), domain_.vector(v)}
                           .value<double>());
    };
    const double f = flow(a), g = flow(b), t = f + g > 0 ? f / (f + g) : 0.5;
    for (std::size_t k = 0; k < 2; ++k)
      s.point[k] += t * (domain_.point(b)[k] - domain_.point(a)[k]);
    note(s);
  }
  void add_corner(std::size_t i, std::size_t j, Sign after) {
    SwitchPoint& s = add(loop_[j], after);
    s.last_edge = s.side = loop_[i];
    s.at_vertex = s.corner = true;
    s.inside = signs_.corner(i, j) == Sign::negative;
    note(s);
  }
  /// Ends `first` to `last` are tangent.
  void add_run(std::size_t first, std::size_t last, Sign after) {
    const std::size_t n = signs_.size(), edges = loop_.size();
    // The edges whose ends these are; its first vertex is left by the next edge if the run begins
    // at an edge's end.
    const std::size_t i = (first + 1) / 2 % edges, j = (last + 1) / 2 % edges;
    SwitchPoint& s = add(loop_[i], after);
    s.last_edge = loop_[(j + edges - 1) % edges];
    s.side = loop_[(first - 1) % n / 2];
    s.at_vertex = s.tangent = true;
    s.corner = signs_.corner((i + edges - 1) % edges, i) != Sign::zero ||
               signs_.corner((j + edges - 1) % edges, j) != Sign::zero;
    s.inside = signs_.along(first % n) == after;
    note(s);
  }
  std::size_t place_of(const SwitchPoint& s) const {
    const auto at = std::find(loop_.begin(), loop_.end(), s.side) - loop_.begin();
    return 2 * static_cast<std::size_t>(at) + (s.at_vertex ? 1 : 0);
  }

  const Domain& domain_;
  const std::vector<HalfEdge>& loop_;
  const LoopSigns signs_;
  const Index number_;
  Boundary& result_;
  Index& regions_;
  BoundaryLoop out_;
};

}  // namespace

Boundary examine_boundary(const Domain& domain) {
  Boundary result;
  result.half_edges = domain.loops();
  Index regions = 0;
  for (Index i = 0; i < result.half_edges.size(); ++i)
    result.loops.push_back(LoopWalk(domain, result.half_edges[i], i, result, regions).walk());
  return result;
}

int axis_crossing(const Vec2& a, const Vec2& b) {
  if ((a[1] < 0) == (b[1] < 0)) return 0;
  const Sign turn = kernel::vector_turn(a, b);
  if (a[1] < 0) return turn == Sign::positive ? 1 : 0;
  return turn == Sign::negative ? -1 : 0;
}

int winding_around(const Domain& domain, const Boundary& boundary,
                   const std::vector<ZeroComponent>& zeros) {
  const auto crossing = [&](HalfEdge h) {
    return axis_crossing(domain.vector(domain.from(h)), domain.vector(domain.to(h)));
  };
  int sum = 0;
  for (const auto& loop : boundary.half_edges)
    for (const HalfEdge h : loop) sum += crossing(h);
  // The chain around what is left out; where it passes zeros its terms cancel.
  for (const ZeroComponent& z : zeros)
    if (z.at_boundary)
      for (const Index t : z.triangles)
        for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) sum -= crossing(h);
  return sum;
}

}  // namespace crest::vector_fields
