// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/lines.hpp"

#include <algorithm>

namespace crest::certify::skeleton {
namespace {

/// Throws Reject unless barriers can be made so.
void check_barrier(const SkeletonBarrier& b, const std::string& name) {
  constexpr std::array kBits = {53, 133, 332, 1000};
  require(std::find(kBits.begin(), kBits.end(), b.bits) != kBits.end(), "{}: {} bits", name,
          b.bits);
  require(b.degree >= 1 && b.degree <= (b.bits == 53 ? 50 : 128), "{}: degree {}", name, b.degree);
  require(b.angle >= 1 && b.angle <= b.bits && std::abs(b.shrink) <= 16, "{}: angle {}, shrink {}",
          name, b.angle, b.shrink);
}
void check_barriers(const SkeletonBarrier& barrier, const std::vector<SkeletonException>& list,
                    std::size_t turns, const std::string& name) {
  check_barrier(barrier, name);
  for (std::size_t i = 0; i < list.size(); ++i) {
    check_barrier(list[i].barrier, name);
    require(list[i].barrier.bits == barrier.bits && list[i].step <= turns &&
                (i == 0 || list[i - 1].step < list[i].step),
            "{}: exceptions of other precision or not ascending", name);
  }
}
const SkeletonBarrier& last_barrier(const SkeletonLeg& leg) {
  return !leg.exceptions.empty() && leg.exceptions.back().step == leg.turns.size()
             ? leg.exceptions.back().barrier
             : leg.barrier;
}

/// Calls follow(Number) with the thread's precision set.
template <class Follow>
Work with_precision(u32 bits, const Follow& follow) {
  if (bits == 53) return follow(double{});
  Big::bits = static_cast<mpfr_prec_t>(bits);
  return follow(Big{});
}

/// The end of a line that is straight to its end.
class StraightEnd {
 public:
  StraightEnd(const Context& context, const SkeletonSeparatrix& line, const std::string& name,
              SignLadder& sign)
      : context_(context), line_(line), name_(name), sign_(sign) {}

  /// Throws Reject.
  void check(const StraightWalk& walk) const {
    const Spot& spot = walk.spot();
    if (line_.end == SkeletonEnd::zero)
      return require(walk.at_zero() && context_.zeros.of_triangle[walk.triangle()] == line_.to,
                     "{}: does not end in zero {}", name_, line_.to);
    require(!walk.at_zero() && walk.leaves(), "{}: does not leave the domain", name_);
    if (line_.end == SkeletonEnd::switch_point) {
      require(line_.to < context_.boundary.switches.size(), "{}: no switch point {}", name_,
              line_.to);
      const SkeletonSwitch& point = context_.boundary.switches[line_.to];
      return require(
          point.place != 0 && spot.kind == Spot::at_vertex &&
              context_.domain.fan[spot.name] == context_.domain.fan[next_corner(point.side)],
          "{}: does not end in switch point {}", name_, line_.to);
    }
    require(line_.end == SkeletonEnd::boundary, "{}: straight into an orbit", name_);
    const u32 found = region_at(spot);
    require(found == line_.to && found != kNone, "{}: does not end in region {}", name_, line_.to);
  }

 private:
  /// kNone between two regions.
  u32 region_at(const Spot& spot) const {
    const auto& regions = context_.boundary.regions;
    if (spot.kind == Spot::in_side) {
      // v.N < 0 (forward) at the point: the end of the side with that sign has the region.
      const Sign out = line_.backward != 0 ? Sign::positive : Sign::negative;
      const Field& field = context_.field;
      const u32 head = next_corner(spot.name);
      const Sign tail = inflow_sign(sign_, field.position(spot.name), field.position(head),
                                    field.vector(spot.name));
      return regions[spot.name][tail == out ? 0 : 1];
    }
    const auto fan = context_.domain.corners_of(context_.domain.fan[spot.name]);
    const u32 leaving = fan.front(), arriving = previous_corner(fan.back());
    const u32 before = regions[arriving][1], after = regions[leaving][0];
    return before == after ? before : kNone;
  }

  const Context& context_;
  const SkeletonSeparatrix& line_;
  const std::string& name_;
  SignLadder& sign_;
};

/// One separatrix.
class LineCheck {
 public:
  LineCheck(const Context& context, const Traps& traps, u32 number, SignLadder& sign)
      : context_(context),
        traps_(traps),
        sign_(sign),
        line_(context.stated.separatrices[number]),
        name_(fmt::format("separatrix {}", number)),
        backward_(line_.backward != 0) {}

  Work run(Claimed& claimed, Trace& trace) {
    check_origin();
    claimed = {line_.origin, line_.from, backward_, !line_.legs.empty(), {kNone, 0, !backward_}};
    const bool open = line_.end == SkeletonEnd::undecided;
    require(open == (line_.reason != OpenReason::none) && (!open || line_.to == 0),
            "{}: an end and a reason for none", name_);
    if (line_.legs.empty()) {
      require(open, "{}: an end without a way", name_);
      return {};
    }
    require(line_.legs.size() <= 2, "{}: more than a straight part and another", name_);
    const SkeletonLeg& first = line_.legs[0];
    for (const SkeletonLeg& leg : line_.legs)
      require(leg.corner < context_.field.corners() && context_.domain.live[leg.corner / 3] != 0,
              "{}: no corner {}", name_, leg.corner);
    if (first.kind != LegKind::straight) {
      require(line_.legs.size() == 1, "{}: goes on where it is not known exactly", name_);
      return corridor(first, nullptr, claimed, trace);
    }
    StraightWalk walk(context_, backward_, name_);
    check_straight(first);
    walk.run(first, zero());
    trace.straight = walk.passed();
    if (zero() != nullptr && zero()->stated.index != kNoIndex)
      claimed.ray = ray_name(context_, walk, *zero(), backward_);
    if (line_.legs.size() == 1) {
      if (!open) StraightEnd(context_, line_, name_, sign_).check(walk);
      return {};
    }
    require(walk.spot().kind == Spot::at_vertex && !walk.at_zero(), "{}: goes on from no vertex",
            name_);
    return corridor(line_.legs[1], &walk, claimed, trace);
  }

 private:
  const Component* zero() const {
    return line_.origin == SkeletonOrigin::zero ? &context_.zeros.components[line_.from] : nullptr;
  }
  void check_origin() const {
    if (line_.origin == SkeletonOrigin::vertex)
      return require(line_.from < context_.field.corners() &&
                         !is_zero(context_.field.vector(line_.from)) &&
                         context_.domain.live[line_.from / 3] != 0,
                     "{}: from no vertex with flow", name_);
    const std::size_t count = line_.origin == SkeletonOrigin::zero
                                  ? context_.zeros.components.size()
                                  : context_.boundary.switches.size();
    require(line_.from < count, "{}: from nowhere", name_);
  }
  /// Of the switch point's vertex, kNone if it is inside a side, or of the vertex.
  u32 origin_fan() const {
    if (line_.origin == SkeletonOrigin::vertex) return context_.domain.fan[line_.from];
    const SkeletonSwitch& point = context_.boundary.switches[line_.from];
    return point.place == 0 ? kNone : context_.domain.fan[next_corner(point.side)];
  }
  void check_straight(const SkeletonLeg& leg) const {
    require(leg.turns.empty() && leg.exceptions.empty(), "{}: turns of a straight part", name_);
    if (zero() != nullptr) return;
    const u32 fan = origin_fan();
    require(fan != kNone && context_.domain.fan[leg.corner] == fan,
            "{}: does not start at its point", name_);
  }

  /// `before`: the straight part that it goes on from.
  Work corridor(const SkeletonLeg& leg, const StraightWalk* before, Claimed& claimed,
                Trace& trace) {
    require(leg.kind != LegKind::straight && leg.elements == 0, "{}: straight twice", name_);
    check_barriers(leg.barrier, leg.exceptions, leg.turns.size(), name_);
    return with_precision(leg.barrier.bits, [&](auto number) {
      Corridor<decltype(number)> line(context_, backward_, sign_, name_);
      start(line, leg, before, claimed);
      line.follow(leg.turns, leg.barrier, leg.exceptions);
      end(line, leg);
      const Work work = line.work();
      trace.passages = std::move(line).passages();
      return work;
    });
  }

  template <class Line>
  void start(Line& line, const SkeletonLeg& leg, const StraightWalk* before, Claimed& claimed) {
    if (leg.kind == LegKind::ray) {
      require(zero() != nullptr && before == nullptr, "{}: a ray of no zero", name_);
      const RaySigns signs = line.start_ray(leg, *zero());
      claimed.ray = ray_name(context_, leg, *zero(), signs, backward_);
      return;
    }
    require(before != nullptr || zero() == nullptr, "{}: does not start at its zero", name_);
    const u32 fan = before == nullptr ? origin_fan() : context_.domain.fan[before->spot().name];
    if (leg.kind == LegKind::point) {
      require(leg.first.empty() && leg.second.empty(), "{}: numbers of a vertex", name_);
      require(fan != kNone && context_.domain.fan[leg.corner] == fan, "{}: starts elsewhere",
              name_);
      return line.start_point(leg);
    }
    if (fan == kNone) {
      require(leg.corner == context_.boundary.switches[line_.from].side,
              "{}: not in its switch point's side", name_);
      return line.start_along(leg, kNone);
    }
    const u32 head = next_corner(leg.corner);
    require(context_.domain.fan[leg.corner] == fan || context_.domain.fan[head] == fan,
            "{}: starts elsewhere", name_);
    line.start_along(
        leg, context_.field.vertex(context_.domain.fan[leg.corner] == fan ? leg.corner : head));
  }

  template <class Line>
  void end(Line& line, const SkeletonLeg& leg) {
    switch (line_.end) {
      case SkeletonEnd::undecided:
        return require(!line.at_boundary(), "{}: undecided at the boundary", name_);
      case SkeletonEnd::boundary:
        return line.end_in_region(line_.to);
      case SkeletonEnd::orbit: {
        require(line_.to < context_.stated.orbits.size(), "{}: no orbit {}", name_, line_.to);
        const SkeletonOrbit& orbit = context_.stated.orbits[line_.to];
        require((orbit.backward != 0) == backward_, "{}: ends in an orbit of the other kind",
                name_);
        return line.end_in_segment({orbit.side, orbit.left, orbit.right}, false);
      }
      case SkeletonEnd::zero: {
        require(line_.to < context_.zeros.components.size(), "{}: no zero {}", name_, line_.to);
        const ZeroPlace place = context_.zeros.components[line_.to].stated.place;
        if (place == ZeroPlace::line || place == ZeroPlace::region)
          return line.end_in_wall(line_.to);
        require(traps_[line_.to] != nullptr, "{}: zero {} has no trap", name_, line_.to);
        return line.end_in_trap(*traps_[line_.to], last_barrier(leg));
      }
      default:
        require(false, "{}: ends in a switch point, but is not straight", name_);
    }
  }

  const Context& context_;
  const Traps& traps_;
  SignLadder& sign_;
  const SkeletonSeparatrix& line_;
  std::string name_;
  bool backward_;
};

}  // namespace

Work check_orbit(const Context& context, u32 number, SignLadder& sign, Trace& trace) {
  const SkeletonOrbit& orbit = context.stated.orbits[number];
  const std::string name = fmt::format("orbit {}", number);
  require(orbit.side < context.field.corners() && context.domain.live[orbit.side / 3] != 0 &&
              in_side(orbit.left) && in_side(orbit.right) && before(orbit.left, orbit.right),
          "{}: no segment", name);
  require(!orbit.turns.empty(), "{}: no turns", name);
  check_barriers(orbit.barrier, orbit.exceptions, orbit.turns.size(), name);
  for (const double t : {orbit.left, orbit.right})
    require(normal_sign(context.field, orbit.side, t, sign) ==
                (orbit.backward != 0 ? Sign::negative : Sign::positive),
            "{}: the field does not enter through its segment", name);
  return with_precision(orbit.barrier.bits, [&](auto number_type) {
    using Number = decltype(number_type);
    const Segment<Number> segment{orbit.side, orbit.left, orbit.right};
    Corridor<Number> line(context, orbit.backward != 0, sign, name);
    line.start_segment(segment);
    line.follow(orbit.turns, orbit.barrier, orbit.exceptions);
    line.end_in_segment(segment, true);
    const Work work = line.work();
    trace.passages = std::move(line).passages();
    return work;
  });
}

Work check_line(const Context& context, const Traps& traps, u32 number, SignLadder& sign,
                Claimed& claimed, Trace& trace) {
  return LineCheck(context, traps, number, sign).run(claimed, trace);
}

}  // namespace crest::certify::skeleton
