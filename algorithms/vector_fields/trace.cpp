// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/trace.hpp"

#include <algorithm>

#include "algorithms/vector_fields/annulus.hpp"
#include "algorithms/vector_fields/reals.hpp"
#include "algorithms/vector_fields/starts.hpp"
#include "algorithms/vector_fields/straight.hpp"
#include "algorithms/vector_fields/walls.hpp"

namespace crest::vector_fields {

namespace {

/// Of corridors that are looked for in pairs of doubles: certificates have no such bits.
constexpr BarrierSetting kPairs{133, 78, 21, 0};

/// Crossings after which a line is given up, and says so; at high precisions each is dear.
std::size_t most_crossings(int bits) {
  return bits == 53 ? 200'000 : static_cast<std::size_t>(2.5e8 / bits / bits);
}

/// From the tail, in doubles: to look, not to decide.
template <class Real>
double from_tail(const Real& t) {
  const double s = static_cast<double>(t);
  return s > 0 ? s : 1 + s;
}

/// Follows one separatrix at one precision.
template <class Real>
class Follower {
 public:
  Follower(const Surroundings& around, const BarrierSetting& setting, AnnulusNotes& notes)
      : around_(around), maker_(around.domain, setting), search_(around, notes) {}

  /// Whether it ends by name.
  bool follow(const Start& line, Trace& trace) {
    trace = {};
    trace.start = trace.leg = line;
    return follow_leg(trace);
  }
  /// The same from `trace.leg` on.
  bool follow_leg(Trace& trace) {
    const Start start = trace.leg;
    trace.setting = maker_.setting();
    CellResult<Real> cell =
        begin(maker_, start, trace, around_.trap_in(start.place / 3, start.forward));
    // Of rays the first triangle is not crossed, but left.
    if (start.kind == StartKind::along || start.kind == StartKind::point) note(trace, cell);
    Index triangle = start.place / 3;
    for (;;) {
      if (cell.end == CellEnd::left_domain) return finish_at_boundary(trace, cell);
      if (cell.end == CellEnd::trapped) {
        trace.end = EndKind::critical_point;
        trace.target = around_.traps.at(triangle).zero;
        return true;
      }
      if (cell.end == CellEnd::open) return fail(trace, cell, triangle);
      const Gate<Real> gate = cell.gate;
      triangle = gate.side / 3;
      trace.line.push_back(middle(gate));
      trace.width = width(gate);
      trace.gates.push_back({gate.side, static_cast<Index>(trace.turns.size()),
                             static_cast<double>(gate.left), static_cast<double>(gate.right),
                             trace.width});
      if (in_annulus(trace, gate) || at_wall(trace, gate)) return true;
      if (trace.turns.size() > most_crossings(trace.setting.bits)) {
        trace.reason = OpenReason::budget;
        return false;
      }
      const bool found =
          search_.visit(start.forward, gate.side, from_tail(near_middle(gate)), trace.turns.size());
      if (found && in_annulus(trace, gate)) return true;
      if (search_.hopeless()) {
        trace.reason = OpenReason::weak_focus;
        return false;
      }
      cell = cross_cell(maker_, start.forward, gate, around_.trap_in(triangle, start.forward));
      note(trace, cell);
    }
  }

 private:
  void note(Trace& trace, const CellResult<Real>& cell) {
    if (cell.special && cell.end != CellEnd::open)
      trace.special.push_back({static_cast<Index>(trace.turns.size()), cell.setting});
    if (cell.end == CellEnd::crossed || cell.end == CellEnd::left_domain)
      trace.turns.push_back(cell.turn);
  }
  Vec2 middle(const Gate<Real>& g) const {
    return place_on<Real>(around_.domain, g.side, near_middle(g));
  }
  double width(const Gate<Real>& g) const {
    const Vec2 p = place_on(around_.domain, g.side, g.left),
               q = place_on(around_.domain, g.side, g.right);
    return std::hypot(p[0] - q[0], p[1] - q[1]);
  }

  bool finish_at_boundary(Trace& trace, const CellResult<Real>& cell) {
    trace.line.push_back(middle(cell.gate));
    trace.width = width(cell.gate);
    trace.end = EndKind::boundary;
    const EdgeRegions& r = around_.boundary.regions.at(cell.gate.side);
    // All of the segment flows out (in, for a line backward): it lies in one region.
    trace.target = r.at_from;
    if (r.at_from != r.at_to) {
      // The region whose flow has the right sign.
      const Domain& d = around_.domain;
      const double across =
          kernel_across(d.point(d.from(cell.gate.side)), d.point(d.to(cell.gate.side)),
                        d.vector(d.from(cell.gate.side)));
      const bool first = trace.start.forward ? across < 0 : across > 0;
      if (!first) trace.target = r.at_to;
    }
    return true;
  }
  static double kernel_across(const Vec2& p, const Vec2& q, const Vec2& v) {
    return (q[0] - p[0]) * v[1] - (q[1] - p[1]) * v[0];
  }

  bool fail(Trace& trace, const CellResult<Real>& cell, Index triangle) {
    trace.reason = OpenReason::vertex_hit;
    const Domain& d = around_.domain;
    // A line that creeps up to a zero corner does so at any precision.
    for (HalfEdge h = 3 * triangle; h < 3 * triangle + 3; ++h)
      trace.creeps = trace.creeps || (!cell.divided && d.is_zero(d.from(h)));
    if (const auto zero = zero_of_triangle(around_, triangle); zero && cell.divided)
      if (around_.zeros[*zero].item.kind == ZeroKind::saddle)
        trace.reason = OpenReason::saddle_connection;
    return false;
  }

  bool at_wall(Trace& trace, const Gate<Real>& gate) {
    const Domain& d = around_.domain;
    int zeros = 0;
    for (HalfEdge h = 3 * (gate.side / 3); h < 3 * (gate.side / 3) + 3; ++h)
      zeros += d.is_zero(d.from(h)) ? 1 : 0;
    if (zeros != 2) return false;
    const auto wall = wall_ahead(around_, trace.start.forward, gate.side,
                                 expand(gate.left, maker_.setting().bits + 2),
                                 expand(gate.right, maker_.setting().bits + 2));
    if (!wall) return false;
    trace.end = EndKind::zero_flow;
    trace.target = *wall;
    return true;
  }

  bool in_annulus(Trace& trace, const Gate<Real>& gate) {
    const auto found = search_.holding(trace.start.forward, gate);
    if (!found) return false;
    trace.end = EndKind::closed_orbit;
    trace.target = *found;
    return true;
  }

  const Surroundings& around_;
  BarrierMaker<Real> maker_;
  AnnulusSearch search_;
};

}  // namespace

/// `straight`: the line's first part, or none.
template <class Real>
bool follow_at(const Surroundings& around, const BarrierSetting& setting, const Start& start,
               const Trace& straight, AnnulusNotes& notes, Trace& result) {
  Follower<Real> follower(around, setting, notes);
  if (!straight.straight) return follower.follow(start, result);
  result = straight;
  return follower.follow_leg(result);
}

std::vector<Trace> trace(const Surroundings& around, const Start& start, AnnulusNotes& notes) {
  std::vector<Trace> attempts(1);
  attempts.back().start = start;
  attempts.back().reason = OpenReason::vertex_hit;
  // Lines that do not settle down, or return to where they were, do so at any precision.
  const auto final = [&](bool found) {
    const Trace& t = attempts.back();
    return found || t.creeps || t.reason == OpenReason::budget ||
           t.reason == OpenReason::weak_focus;
  };
  if (start.kind != StartKind::none &&
      final(Follower<double>(around, kDoubles, notes).follow(start, attempts.back())))
    return attempts;
  Start exact_start = start;
  Trace straight;
  if (start.kind == StartKind::ray) exact_start.direction = exact_direction(around.domain, start);
  if (exact_start.direction) {
    walk_straight(around, exact_start, straight);
    if (straight.end != EndKind::undecided) {
      attempts.push_back(std::move(straight));
      return attempts;
    }
    if (straight.leg.kind == StartKind::none) straight.straight.reset();
  }
  if (start.kind == StartKind::none && !straight.straight) return attempts;
  // At one precision after the other, until one suffices.
  const auto at = [&]<class Real>(Real, const BarrierSetting& setting) {
    return final(follow_at<Real>(around, setting, start, straight, notes, attempts.emplace_back()));
  };
  (straight.straight && at(double{}, kDoubles)) || at(DoubleDouble{}, kPairs) ||
      at(Real133{}, {133, 90, 24, 0}) || at(Real332{}, {332, 240, 50, 0}) ||
      at(Real1000{}, {1000, 720, 120, 0});
  return attempts;
}

}  // namespace crest::vector_fields
