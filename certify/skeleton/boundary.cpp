// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/boundary.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"

namespace crest::certify::skeleton {
namespace {

/// v.N next to one end of a side, domain at the left: two of them a side, in the loop's order.
struct EndSign {
  u32 side;
  Sign normal;
  bool zero;  ///< v = 0 at this end
};

std::vector<EndSign> end_signs(const Field& field, const std::vector<u32>& loop, SignLadder& sign) {
  std::vector<EndSign> ends;
  ends.reserve(2 * loop.size());
  for (const u32 side : loop) {
    const u32 head = next_corner(side);
    const Pair &p = field.position(side), &q = field.position(head);
    for (const u32 c : {side, head})
      ends.push_back({side, inflow_sign(sign, p, q, field.vector(c)), is_zero(field.vector(c))});
  }
  return ends;
}

/// The tangent's crossings of the positive x-axis at the head of
/// `side`: half a turn to the left, then back through the fan.
int corner_crossings(const Field& field, const Domain& domain, u32 side) {
  const u32 head = next_corner(side);
  const Pair &p = field.position(side), &q = field.position(head);
  int crossings = q[1] < p[1] || (q[1] == p[1] && q[0] < p[0]);
  for (const u32 c : domain.corners_of(domain.fan[head]))
    crossings -=
        field.position(next_corner(c))[1] < q[1] && field.position(previous_corner(c))[1] >= q[1];
  return crossings;
}

/// Walks one loop's signs and collects what separates its regions.
class LoopWalk {
 public:
  LoopWalk(const Field& field, const std::vector<u32>& loop, SignLadder& sign, Boundary& out)
      : field_(field), loop_(loop), sign_(sign), out_(out), ends_(end_signs(field, loop, sign)) {}

  bool meets_zero() {
    for (const EndSign& end : ends_)
      if (end.zero) return true;
    return std::any_of(loop_.begin(), loop_.end(),
                       [&](u32 side) { return has_edge_zero(field_, side, sign_); });
  }

  void run(SkeletonLoop& loop) {
    const std::size_t n = ends_.size();
    std::vector<std::size_t> strict;
    for (std::size_t i = 0; i < n; ++i)
      if (ends_[i].normal != Sign::zero) strict.push_back(i);
    const u32 base = out_.region_count;
    u32 events = 0;
    // An event belongs to the gap after a strict end; it is numbered before the region behind it.
    std::vector<u32> after(strict.size());  // events up to this gap
    for (std::size_t k = 0; k < strict.size(); ++k)
      after[k] = events += separates(strict[k], strict[(k + 1) % strict.size()], loop);
    const u32 count = std::max(events, 1U);
    for (std::size_t k = 0; k < strict.size(); ++k) {
      // The end behind gap k; its region follows event after[k] - 1, the last one if there is none.
      const std::size_t end = strict[(k + 1) % strict.size()];
      out_.regions[ends_[end].side][end % 2] = base + (after[k] + count - 1) % count;
    }
    if (strict.empty())
      require(loop.zero != 0, "loop {}: wholly tangent without a zero", loop.side);
    if (loop.zero == 0) count_regions(strict, events, loop);
    out_.region_count += count;
  }

 private:
  void count_regions(const std::vector<std::size_t>& strict, u32 events, SkeletonLoop& loop) const {
    if (events == 0) {
      ++(ends_[strict[0]].normal == Sign::positive ? loop.inflow : loop.outflow);
      return;
    }
    // Signs alternate at every event of a loop without zeros.
    loop.inflow = loop.outflow = events / 2;
  }

  /// Between two neighbouring strict ends: a zero, a switch point, or nothing. Records a switch.
  bool separates(std::size_t i, std::size_t j, SkeletonLoop& loop) {
    const std::size_t n = ends_.size();
    const EndSign &from = ends_[i], &to = ends_[j];
    std::size_t inner = (i + 1) % n;
    bool zero = false;
    for (std::size_t k = inner; k != j; k = (k + 1) % n) zero = zero || ends_[k].zero;
    const bool same_side = from.side == to.side && i % 2 == 0 && inner == j;
    if (zero || (same_side && has_edge_zero(field_, from.side, sign_))) return true;
    for (std::size_t k = inner; k != j; k = (k + 1) % n)  // wholly tangent sides
      if (k % 2 == 0 && has_edge_zero(field_, ends_[k].side, sign_)) return true;
    if (from.normal == to.normal) return false;
    SkeletonSwitch found{from.side, 0, 0};
    if (same_side) {
      found.inside = inside_side(from.side) == to.normal;
    } else if (inner == j) {
      found.place = 1;
      found.inside = reflex(from.side, to.side);
    } else {
      found.place = 2;
      found.inside = inside_side(ends_[inner].side, inner % 2) == to.normal;
    }
    if (loop.zero == 0) ++(found.inside ? loop.interior : loop.exterior);
    out_.switches.push_back(found);
    return true;
  }

  /// Of v along the side where v.N = 0: somewhere inside it, or at its tail (0) or head (1).
  Sign inside_side(u32 side, std::size_t end) {
    const u32 head = next_corner(side);
    return along_sign(sign_, field_.position(side), field_.position(head),
                      field_.vector(end == 0 ? side : head));
  }
  /// At the root of v.N: v = (n1 v0 - n0 v1) / (n1 - n0), n0 = v0.N, n1 = v1.N.
  Sign inside_side(u32 side) {
    const u32 head = next_corner(side);
    const Pair &p = field_.position(side), &q = field_.position(head), &a = field_.vector(side),
               &b = field_.vector(head);
    const Sign rising = inflow_sign(sign_, p, q, b);
    // e.(n1 v0 - n0 v1) = |e|^2 det(v0, v1), by Lagrange's identity.
    return rising * turn_sign(sign_, a, b);
  }
  /// The tail of `next` is the head of `side`; their directions are not parallel.
  bool reflex(u32 side, u32 next) {
    return orientation(sign_, field_.position(side), field_.position(next),
                       field_.position(next_corner(next))) == Sign::negative;
  }

  const Field& field_;
  const std::vector<u32>& loop_;
  SignLadder& sign_;
  Boundary& out_;
  std::vector<EndSign> ends_;
};

}  // namespace

Boundary find_boundary(const Field& field, const Domain& domain, SignLadder& sign) {
  Boundary b;
  b.regions.assign(field.corners(), {kNone, kNone});
  for (const auto& sides : domain.loops) {
    SkeletonLoop& loop = b.loops.emplace_back();
    loop.side = sides[0];
    LoopWalk walk(field, sides, sign, b);
    loop.zero = walk.meets_zero();
    walk.run(loop);
    if (loop.zero != 0) continue;
    for (const u32 side : sides) {
      loop.winding += axis_crossings(sign, field.vector(side), field.vector(next_corner(side)));
      loop.turning += corner_crossings(field, domain, side);
    }
    require(2 * (loop.winding - loop.turning) ==
                static_cast<std::int64_t>(loop.interior) - static_cast<std::int64_t>(loop.exterior),
            "loop {}: winding {}, turning {}, {} switch points inside, {} outside: they must "
            "agree",
            loop.side, loop.winding, loop.turning, loop.interior, loop.exterior);
  }
  return b;
}

std::int64_t winding_around_rest(const Field& field, const Domain& domain, const ZeroSet& zeros,
                                 SignLadder& sign) {
  const auto inside = [&](u32 t) {
    return domain.live[t] != 0 && (zeros.of_triangle[t] == kNone ||
                                   zeros.components[zeros.of_triangle[t]].stated.index != kNoIndex);
  };
  std::int64_t crossings = 0;
  for (u32 c = 0; c < field.corners(); ++c)
    if (inside(c / 3) && (domain.twin[c] == kNone || !inside(domain.twin[c] / 3)))
      crossings += axis_crossings(sign, field.vector(c), field.vector(next_corner(c)));
  return crossings;
}

}  // namespace crest::certify::skeleton
