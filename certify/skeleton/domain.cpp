// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/domain.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/surface/gluing.hpp"

namespace crest::certify::skeleton {
namespace {

void glue_live(const Field& field, Domain& d) {
  Gluing gluing = glue(field.faces(), field.vertices(), false);
  require(gluing.aligned, "two triangles run along an edge in the same direction");
  d.twin = std::move(gluing.twin);
  for (u32 c = 0; c < field.corners(); ++c)
    if (d.twin[c] == kNone) d.border.push_back(c);
  d.live.assign(field.triangles(), 0);
  for (u32 c = 0; c < field.corners(); ++c) d.live[c / 3] |= !is_zero(field.vector(c));
  d.at_dead.assign(field.corners(), 0);
  for (u32 c = 0; c < field.corners(); ++c)
    d.at_dead[c] = d.twin[c] != kNone && d.live[d.twin[c] / 3] == 0;
  for (u32 c = 0; c < field.corners(); ++c)
    if (is_zero(field.vector(c)) && is_zero(field.vector(next_corner(c)))) d.twin[c] = kNone;
  for (const u8 live : d.live) d.dead += live == 0;
}

void walk_fan(u32 first, Domain& d) {
  const auto number = static_cast<u32>(d.open.size());
  u32 c = first;
  do {
    d.fan[c] = number;
    d.round.push_back(c);
    c = d.twin[previous_corner(c)];
  } while (c != kNone && c != first);
  d.open.push_back(c == kNone);
  d.fan_start.push_back(static_cast<u32>(d.round.size()));
}

void build_fans(Domain& d) {
  d.fan.assign(d.twin.size(), kNone);
  d.fan_start.push_back(0);
  d.round.reserve(d.twin.size());
  for (u32 c = 0; c < d.twin.size(); ++c)
    if (d.live[c / 3] != 0 && d.twin[c] == kNone) walk_fan(c, d);
  for (u32 c = 0; c < d.twin.size(); ++c)
    if (d.live[c / 3] != 0 && d.fan[c] == kNone) walk_fan(c, d);
}

Pair low_part(const Pair& p, const Pair& q) {
  return {q[0] > p[0]   ? 1.0
          : q[0] < p[0] ? -1.0
                        : 0.0,
          q[1] > p[1]   ? 1.0
          : q[1] < p[1] ? -1.0
                        : 0.0};
}
bool in_lower_half(const Pair& quadrant) {
  return quadrant[1] < 0 || (quadrant[1] == 0 && quadrant[0] < 0);
}

/// Is the angle of d from the positive x-axis on, in [0, 2 pi), below that of e? Equal: zero.
Sign compare_angles(SignLadder& sign, const Pair& p, const Pair& d, const Pair& e) {
  const bool low_d = in_lower_half(low_part(p, d)), low_e = in_lower_half(low_part(p, e));
  if (low_d != low_e) return low_d ? Sign::positive : Sign::negative;
  return -orientation(sign, p, d, e);
}

/// Inner fans go round once, boundary fans less than once.
void check_angles(const Field& field, const Domain& d, SignLadder& sign) {
  for (u32 f = 0; f < d.open.size(); ++f) {
    const auto corners = d.corners_of(f);
    const Pair& p = field.position(corners[0]);
    int crossings = 0;
    for (const u32 c : corners)
      crossings +=
          field.position(next_corner(c))[1] < p[1] && field.position(previous_corner(c))[1] >= p[1];
    const u32 vertex = field.vertex(corners[0]);
    if (d.open[f] == 0) {
      require(crossings == 1, "vertex {}: its triangles go round {} times", vertex, crossings);
      continue;
    }
    const Sign order = compare_angles(sign, p, field.position(next_corner(corners.front())),
                                      field.position(previous_corner(corners.back())));
    // A wall that ends at a zero is cut: its fan goes round once.
    const bool cut = order == Sign::zero && is_zero(field.vector(corners[0]));
    require(cut || order != Sign::zero, "vertex {}: its boundary sides coincide", vertex);
    require(crossings == (cut || order == Sign::positive), "vertex {}: its triangles overlap",
            vertex);
  }
}

void build_loops(Domain& d) {
  std::vector<u8> seen(d.twin.size(), 0);
  for (u32 c = 0; c < d.twin.size(); ++c) {
    if (d.live[c / 3] == 0 || d.twin[c] != kNone || seen[c] != 0) continue;
    auto& loop = d.loops.emplace_back();
    for (u32 side = c; seen[side] == 0; side = d.next_side(side)) {
      seen[side] = 1;
      loop.push_back(side);
    }
  }
}

}  // namespace

Domain build_domain(const Field& field, SignLadder& sign) {
  Domain d;
  glue_live(field, d);
  for (u32 t = 0; t < field.triangles(); ++t)
    require(orientation(sign, field.position(3 * t), field.position(3 * t + 1),
                        field.position(3 * t + 2)) == Sign::positive,
            "triangle {}: not counter-clockwise", t);
  build_fans(d);
  check_angles(field, d, sign);
  build_loops(d);
  return d;
}

}  // namespace crest::certify::skeleton
