// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/embedding.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify::skeleton {
namespace {

constexpr std::size_t kMost = std::size_t{1} << 30U;

struct Side {
  u32 name, tail, head;  ///< vertices
  Pair p, q;
  double low(std::size_t k) const { return std::min(p[k], q[k]); }
  double high(std::size_t k) const { return std::max(p[k], q[k]); }
};

std::vector<Side> border(const Field& field, const Domain& domain) {
  std::vector<Side> sides;
  for (const u32 c : domain.border) {
    const u32 head = next_corner(c);
    sides.push_back(
        {c, field.vertex(c), field.vertex(head), field.position(c), field.position(head)});
  }
  return sides;
}

/// Common points other than a common vertex. Requires: the boxes meet.
bool collide(const Side& s, const Side& t, SignLadder& sign) {
  for (const bool s_head : {false, true})
    for (const bool t_head : {false, true}) {
      if ((s_head ? s.head : s.tail) != (t_head ? t.head : t.tail)) continue;
      const Pair &v = s_head ? s.q : s.p, &a = s_head ? s.p : s.q, &b = t_head ? t.p : t.q;
      return orientation(sign, v, a, b) == Sign::zero &&
             sign([&](const auto& lift) {
               const auto o = lifted(lift, v);
               return dot(lifted(lift, a) - o, lifted(lift, b) - o);
             }) != Sign::negative;
    }
  const Sign a = orientation(sign, s.p, s.q, t.p), b = orientation(sign, s.p, s.q, t.q);
  if (a == b && a != Sign::zero) return false;
  const Sign c = orientation(sign, t.p, t.q, s.p), d = orientation(sign, t.p, t.q, s.q);
  return c != d || c == Sign::zero;  // on one line the boxes decide
}

void check_crossings(std::vector<Side> sides, SignLadder& sign) {
  std::sort(sides.begin(), sides.end(),
            [](const Side& s, const Side& t) { return s.low(0) < t.low(0); });
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size() && sides[j].low(0) <= sides[i].high(0); ++j) {
      require(++pairs <= kMost, "too many boundary sides above one another");
      if (sides[j].low(1) > sides[i].high(1) || sides[i].low(1) > sides[j].high(1)) continue;
      require(!collide(sides[i], sides[j], sign), "boundary sides {} and {} meet", sides[i].name,
              sides[j].name);
    }
}

/// Winding number of all sides around the middle of one, which is passed over.
int winding_around_middle(const std::vector<Side>& sides, const Side& at, SignLadder& sign) {
  int winding = 0;
  for (const Side& s : sides) {
    if (&s == &at) continue;
    const auto below = [&](const Pair& end) {
      return sign([&](const auto& lift) {
               return lift(2) * lift(end[1]) - (lift(at.p[1]) + lift(at.q[1]));
             }) != Sign::positive;
    };
    if (s.high(1) < at.low(1) || s.low(1) > at.high(1)) continue;
    const bool tail = below(s.p), head = below(s.q);
    if (tail == head) continue;
    // Does the ray to the right pass it? Twice the middle against the side.
    const Sign place = sign([&](const auto& lift) {
      const auto p = lifted(lift, s.p);
      const auto d = lifted(lift, s.q) - p;
      return det(d, (lifted(lift, at.p) - p) + (lifted(lift, at.q) - p));
    });
    if (place == (tail ? Sign::positive : Sign::negative)) winding += tail ? 1 : -1;
  }
  return winding;
}

/// Numbers of border sides of one chain: cut where more than two meet.
UnionFind chains_of(const std::vector<Side>& sides, std::size_t vertices) {
  std::vector<u8> ends(vertices, 0);
  for (const Side& s : sides)
    for (const u32 v : {s.tail, s.head}) ends[v] = std::min<u8>(3, ends[v] + 1);
  std::vector<u32> at(vertices, kNone);
  UnionFind chains(sides.size());
  for (u32 i = 0; i < sides.size(); ++i)
    for (const u32 v : {sides[i].tail, sides[i].head}) {
      if (at[v] != kNone && ends[v] == 2) chains.join(at[v], i);
      at[v] = i;
    }
  return chains;
}

/// Mirrored at x = y: windings change their signs, and left is right.
std::vector<Side> mirrored_sides(std::vector<Side> sides) {
  for (Side& s : sides) {
    std::swap(s.p[0], s.p[1]);
    std::swap(s.q[0], s.q[1]);
  }
  return sides;
}

}  // namespace

void check_embedding(const Field& field, const Domain& domain, SignLadder& sign) {
  const std::vector<Side> sides = border(field, domain), mirrored = mirrored_sides(sides);
  check_crossings(sides, sign);
  UnionFind chains = chains_of(sides, field.vertices());
  std::size_t rays = 0;
  for (u32 i = 0; i < sides.size(); ++i) {
    if (chains.find(i) != i) continue;
    require(++rays <= kMost / sides.size(), "too many loops");
    const bool level = sides[i].p[1] == sides[i].q[1];
    const auto& all = level ? mirrored : sides;
    // The ray begins behind a side that runs upwards, before one that runs downwards.
    const bool up = all[i].q[1] > all[i].p[1];
    const int expected = level ? -int{up} : int{!up};
    require(winding_around_middle(all, all[i], sign) == expected,
            "side {}: triangles lie over one another beside it", sides[i].name);
  }
}

}  // namespace crest::certify::skeleton
