// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/zeros.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify::skeleton {
namespace {

/// A zero of a closed triangle. Edge zeros by the lesser side of the edge.
struct Place {
  ZeroPlace kind;
  u32 number;  ///< triangle, side or fan
  u32 triangle;
  friend auto operator<=>(const Place&, const Place&) = default;
};

u32 edge_name(const Domain& domain, u32 side) {
  return std::min(side, domain.twin[side]);
}

/// The places of a live triangle.
void places_of(const Field& field, const Domain& domain, u32 t, SignLadder& sign,
               std::vector<Place>& places) {
  const u32 c = 3 * t;
  const Pair &v0 = field.vector(c), &v1 = field.vector(c + 1), &v2 = field.vector(c + 2);
  if (!is_zero(v0) && !is_zero(v1) && !is_zero(v2)) {
    const Sign s0 = turn_sign(sign, v0, v1), s1 = turn_sign(sign, v1, v2),
               s2 = turn_sign(sign, v2, v0);
    if (s0 != Sign::zero && s1 != Sign::zero && s2 != Sign::zero) {
      if (s0 == s1 && s1 == s2) places.push_back({ZeroPlace::triangle, t, t});
      return;
    }
  }
  for (const u32 k : {c, c + 1, c + 2}) {
    if (is_zero(field.vector(k))) places.push_back({ZeroPlace::vertex, domain.fan[k], t});
    if (has_edge_zero(field, k, sign)) places.push_back({ZeroPlace::edge, edge_name(domain, k), t});
  }
}

/// Triangles that share a place, joined; returns all places, by triangle.
std::vector<Place> join_places(const Field& field, const Domain& domain, SignLadder& sign,
                               UnionFind& classes) {
  std::vector<Place> places;
  for (u32 t = 0; t < field.triangles(); ++t)
    if (domain.live[t] != 0) places_of(field, domain, t, sign, places);
  for (const Place& p : places) {
    if (p.kind == ZeroPlace::vertex)  // every triangle of the fan has this place
      classes.join(p.triangle, domain.corners_of(p.number).front() / 3);
    if (p.kind == ZeroPlace::edge) {
      classes.join(p.triangle, p.number / 3);
      if (domain.twin[p.number] != kNone) classes.join(p.triangle, domain.twin[p.number] / 3);
    }
  }
  return places;
}

/// Kind and focus of the zero inside triangle t.
void classify(const Field& field, u32 t, SignLadder& sign, SkeletonZero& zero) {
  const auto terms = [&](const auto& lift, const auto& use) {
    const auto p = lifted(lift, field.position(3 * t)), v = lifted(lift, field.vector(3 * t));
    return use(
        lifted(lift, field.position(3 * t + 1)) - p, lifted(lift, field.position(3 * t + 2)) - p,
        lifted(lift, field.vector(3 * t + 1)) - v, lifted(lift, field.vector(3 * t + 2)) - v);
  };
  if (turn_sign(sign, field.vector(3 * t), field.vector(3 * t + 1)) == Sign::negative) {
    zero.kind = ZeroClass::saddle;
    return;
  }
  // Trace and determinant of J times det(e, f): J e = a, J f = b.
  const Sign trace = sign([&](const auto& lift) {
    return terms(lift, [](auto e, auto f, auto a, auto b) { return det(a, f) + det(e, b); });
  });
  zero.kind = trace == Sign::positive   ? ZeroClass::source
              : trace == Sign::negative ? ZeroClass::sink
                                        : ZeroClass::centre;
  if (trace == Sign::zero) return;
  const Sign discriminant = sign([&](const auto& lift) {
    return terms(lift, [&](auto e, auto f, auto a, auto b) {
      const auto sum = det(a, f) + det(e, b);
      return sum * sum - lift(4) * (det(e, f) * det(a, b));
    });
  });
  zero.focus = discriminant == Sign::negative;
}

/// Winding of v around the component's triangles: its zeros are inside them.
int winding_around(const Field& field, const Domain& domain, const ZeroSet& zeros, u32 component,
                   std::span<const u32> triangles, SignLadder& sign) {
  int crossings = 0;
  for (const u32 t : triangles)
    for (const u32 c : {3 * t, 3 * t + 1, 3 * t + 2})
      if (domain.twin[c] == kNone || zeros.of_triangle[domain.twin[c] / 3] != component)
        crossings += axis_crossings(sign, field.vector(c), field.vector(next_corner(c)));
  return crossings;
}

bool borders_on_dead(const Domain& domain, const Field& field, const Place& p) {
  if (p.kind != ZeroPlace::vertex) return false;
  for (const u32 c : domain.corners_of(p.number))
    for (const u32 side : {c, previous_corner(c)})
      if (domain.at_dead[side] != 0 && is_zero(field.vector(next_corner(side)))) return true;
  return false;
}

/// Place and boundary of the component with these places.
void place_component(const Field& field, const Domain& domain, std::vector<Place>& places,
                     Component& component) {
  std::sort(places.begin(), places.end());
  bool region = false;
  std::size_t distinct = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& p = places[i];
    if (i > 0 && places[i - 1].kind == p.kind && places[i - 1].number == p.number) continue;
    ++distinct;
    region = region || borders_on_dead(domain, field, p);
    if (p.kind == ZeroPlace::vertex) component.on_boundary |= domain.open[p.number] != 0;
    if (p.kind == ZeroPlace::edge) component.on_boundary |= domain.twin[p.number] == kNone;
  }
  component.stated.place = region         ? ZeroPlace::region
                           : distinct > 1 ? ZeroPlace::line
                                          : places[0].kind;
  if (component.stated.place == ZeroPlace::vertex || component.stated.place == ZeroPlace::edge)
    component.place = places[0].number;
}

void complete(const Field& field, const Domain& domain, const ZeroSet& zeros, u32 number,
              std::span<const u32> triangles, SignLadder& sign, Component& component) {
  SkeletonZero& zero = component.stated;
  zero.kind = ZeroClass::higher_order;
  if (zero.place == ZeroPlace::triangle) classify(field, zero.triangle, sign, zero);
  if (component.on_boundary || zero.place == ZeroPlace::line || zero.place == ZeroPlace::region)
    return;
  zero.index = winding_around(field, domain, zeros, number, triangles, sign);
  if (zero.place == ZeroPlace::triangle) return;
  count_sectors(field, domain, component);
  require(2 * (zero.index - 1) ==
              static_cast<std::int64_t>(zero.elliptic) - static_cast<std::int64_t>(zero.hyperbolic),
          "zero at triangle {}: index {} with {} hyperbolic, {} elliptic sectors", zero.triangle,
          zero.index, zero.hyperbolic, zero.elliptic);
}

}  // namespace

bool has_edge_zero(const Field& field, u32 side, SignLadder& sign) {
  const Pair &a = field.vector(side), &b = field.vector(next_corner(side));
  return !is_zero(a) && !is_zero(b) && turn_sign(sign, a, b) == Sign::zero &&
         dot_sign(sign, a, b) == Sign::negative;
}

ZeroSet find_zeros(const Field& field, const Domain& domain, SignLadder& sign) {
  UnionFind classes(field.triangles());
  std::vector<Place> places = join_places(field, domain, sign, classes);
  // A place's component, then the places in the order of components.
  std::vector<std::array<u32, 2>> order;
  for (u32 i = 0; i < places.size(); ++i) order.push_back({classes.find(places[i].triangle), i});
  std::sort(order.begin(), order.end());
  ZeroSet zeros;
  zeros.of_triangle.assign(field.triangles(), kNone);
  std::vector<std::vector<u32>> triangles;
  std::vector<Place> group;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Place& p = places[order[i][1]];
    if (group.empty()) triangles.emplace_back();
    group.push_back(p);
    u32& of = zeros.of_triangle[p.triangle];
    if (of == kNone) triangles.back().push_back(p.triangle);
    of = static_cast<u32>(zeros.components.size());
    if (i + 1 < order.size() && order[i + 1][0] == order[i][0]) continue;
    Component& component = zeros.components.emplace_back();
    component.stated.triangle = order[i][0];
    place_component(field, domain, group, component);
    group.clear();
  }
  for (u32 k = 0; k < zeros.components.size(); ++k)
    complete(field, domain, zeros, k, triangles[k], sign, zeros.components[k]);
  return zeros;
}

}  // namespace crest::certify::skeleton
