// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/compression/paths.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"

namespace crest::certify::compression {
namespace {

class PathMaker {
 public:
  PathMaker(const Proof& proof, u32 number)
      : proof_(proof), line_(proof.stated.separatrices[number]), claimed_(proof.claimed[number]) {
    path_.backward = line_.backward != 0;
    path_.trace = &proof.lines[number];
  }

  Path make() {
    for (const auto& passed : path_.trace->straight) add(passed);
    if (!path_.trace->straight.empty())
      path_.direction = {line_.legs[0].first[0], line_.legs[0].first[1]};
    if (!line_.legs.empty() && line_.legs.back().kind != LegKind::straight) add(line_.legs.back());
    const bool from_zero = line_.origin == SkeletonOrigin::zero && claimed_.ray.exit != kNone;
    if (from_zero && claimed_.ray.root < 2) path_.root = claimed_.ray.root;
    return std::move(path_);
  }

 private:
  const Domain& domain() const { return proof_.domain; }
  /// The corner of a triangle at the vertex of another corner.
  u32 corner_at(u32 triangle, u32 corner) const {
    for (const u32 c : {3 * triangle, 3 * triangle + 1, 3 * triangle + 2})
      if (domain().fan[c] == domain().fan[corner]) return c;
    throw Reject("a straight line passes a vertex elsewhere");
  }
  u32 side_in(u32 triangle, u32 side) const {
    return side / 3 == triangle ? side : domain().twin[side];
  }

  void add(const StraightWalk::Passed& passed) {
    Cell cell{Entry::inside, 3 * passed.triangle, kNone};
    if (passed.from.kind == Spot::at_vertex)
      cell = {Entry::vertex, corner_at(passed.triangle, passed.from.name), kNone};
    else if (passed.from.kind == Spot::in_side)
      cell = {path_.cells.empty() ? Entry::side : Entry::crossing,
              side_in(passed.triangle, passed.from.name), kNone};
    if (passed.through && passed.to.kind == Spot::in_side) cell.exit = passed.to.name;
    path_.cells.push_back(cell);
  }

  /// The first cell, or where the first turn is made.
  Cell first(const SkeletonLeg& leg) const {
    if (leg.kind == LegKind::point) return {Entry::vertex, leg.corner, kNone};
    if (leg.kind == LegKind::along) {
      const u32 head = next_corner(leg.corner);
      const u32 fan = start_fan();
      if (fan == kNone) return {Entry::side, leg.corner, kNone};
      return {Entry::vertex, domain().fan[leg.corner] == fan ? leg.corner : head, kNone};
    }
    const Component& zero = proof_.zeros.components[line_.from];
    const u32 t = leg.corner / 3;
    if (zero.stated.place == ZeroPlace::triangle) return {Entry::inside, 3 * t, leg.corner};
    if (zero.stated.place == ZeroPlace::edge)
      return {Entry::side, side_in(t, zero.place), leg.corner};
    return {Entry::vertex, previous_corner(leg.corner), leg.corner};
  }
  /// Of the vertex where a corridor starts, kNone inside a side.
  u32 start_fan() const {
    const auto& straight = path_.trace->straight;
    if (!straight.empty()) return domain().fan[straight.back().to.name];
    if (line_.origin == SkeletonOrigin::vertex) return domain().fan[line_.from];
    const SkeletonSwitch& point = proof_.boundary.switches[line_.from];
    return point.place == 0 ? kNone : domain().fan[next_corner(point.side)];
  }

  void add(const SkeletonLeg& leg) {
    Cell cell = first(leg);
    u32 entered = leg.corner;
    if (leg.kind == LegKind::ray) {
      path_.cells.push_back(cell);
      entered = domain().twin[leg.corner];
      cell = {Entry::crossing, entered, kNone};
    }
    path_.first_turn = path_.cells.size();
    for (const Turn turn : leg.turns) {
      cell.exit = exit_of(entered, turn);
      path_.cells.push_back(cell);
      entered = domain().twin[cell.exit];
      cell = {Entry::crossing, entered, kNone};
    }
    if (line_.end != SkeletonEnd::zero) return;
    const ZeroPlace place = proof_.zeros.components[line_.to].stated.place;
    if (place == ZeroPlace::line || place == ZeroPlace::region) cell.exit = wall_of(entered / 3);
    path_.cells.push_back(cell);
  }
  /// The side of a triangle with two zero vectors.
  u32 wall_of(u32 triangle) const {
    for (const u32 c : {3 * triangle, 3 * triangle + 1, 3 * triangle + 2})
      if (is_zero(proof_.field.vector(c)) && is_zero(proof_.field.vector(next_corner(c)))) return c;
    throw Reject("no wall");
  }

  const Proof& proof_;
  const SkeletonSeparatrix& line_;
  const Claimed& claimed_;
  Path path_;
};

/// In half a corner: where a point or crossing lies on a side.
int in_side(Entry entry, bool enters_at_tail) {
  return entry == Entry::side ? 1 : enters_at_tail ? 0 : 2;
}

}  // namespace

Path path_of(const Proof& proof, u32 separatrix) {
  return PathMaker(proof, separatrix).make();
}

Path chain_of(const Proof& proof, u32 orbit) {
  const SkeletonOrbit& stated = proof.stated.orbits[orbit];
  Path path;
  path.backward = stated.backward != 0;
  path.trace = &proof.orbits[orbit];
  u32 entered = stated.side;
  for (const Turn turn : stated.turns) {
    const u32 exit = exit_of(entered, turn);
    path.cells.push_back({Entry::crossing, entered, exit});
    entered = proof.domain.twin[exit];
  }
  return path;
}

bool Comparison::enters_at_tail(u32 side, bool backward) {
  const Field& field = proof_.field;
  return inflow_sign(sign_, field.position(side), field.position(next_corner(side)),
                     field.vector(side)) == (backward ? Sign::negative : Sign::positive);
}

int Comparison::place(const Path& path, std::size_t i) {
  const Cell& cell = path.cells[i];
  const int corner = 4 * static_cast<int>(cell.name % 3);
  if (cell.entry == Entry::vertex) return corner;
  return corner + 1 + in_side(cell.entry, enters_at_tail(cell.name, path.backward));
}

/// Counter-clockwise from the part of the exit through which lines leave.
int Comparison::rank(const Path& path, std::size_t i, u32 exit) {
  const int start =
      4 * static_cast<int>(exit % 3) + 1 + (enters_at_tail(exit, path.backward) ? 2 : 0);
  // The exit's part itself is nobody's place: it enters where its other part does not.
  return (place(path, i) - start + 12) % 12;
}

Sign Comparison::swirl(const Path& path, std::size_t i) {
  const Cell& cell = path.cells[i];
  const u32 t = cell.name / 3;
  const Field& field = proof_.field;
  const Plane<Rational> z =
      zero_point(field, proof_.domain, proof_.zeros.components[proof_.zeros.of_triangle[t]]);
  const auto turn = [&](const Plane<Rational>& x, const Plane<Rational>& v) {
    const Sign sign = kernel::sign_of(Rational(det(x - z, v)));
    require(sign != Sign::zero, "triangle {}: a line passes through its zero", t);
    return sign;
  };
  if (i < path.trace->straight.size())
    return turn(path.trace->straight[i].start, exact(path.direction));
  const auto passage =
      std::find_if(path.trace->passages.begin(), path.trace->passages.end(),
                   [&](const Passage& p) { return path.first_turn + p.turn == i; });
  require(passage != path.trace->passages.end(), "triangle {}: a line that ends there", t);
  const auto at = [&](const auto& value) {
    const u32 o = passage->corner;
    return value(o) + passage->at.a * (value(next_corner(o)) - value(o)) +
           passage->at.b * (value(previous_corner(o)) - value(o));
  };
  const Sign sign = turn(at([&](u32 c) { return exact(field.position(c)); }),
                         at([&](u32 c) { return exact(field.vector(c)); }));
  return path.backward ? -sign : sign;
}

/// Both start at, or pass, the same point of a triangle's border.
Order Comparison::of_one_point(const Path& a, std::size_t i, const Path& b, std::size_t j) {
  const Cell& cell = a.cells[i];
  const bool zero = cell.entry == Entry::vertex ? is_zero(proof_.field.vector(cell.name))
                                                : has_edge_zero(proof_.field, cell.name, sign_);
  if (!zero) return Order::same;
  require(i == 0 && j == 0 && a.root < 2 && b.root < 2,
          "triangle {}: which of two lines of a zero is at the left is not known", cell.name / 3);
  // Nearer to the exit's head is at the left.
  return a.root == b.root ? Order::same : a.root > b.root ? Order::left : Order::right;
}

std::optional<Order> Comparison::compare_cells(const Path& a, std::size_t i, const Path& b,
                                               std::size_t j) {
  const Cell &p = a.cells[i], &q = b.cells[j];
  if (p.entry == Entry::inside && q.entry == Entry::inside) return Order::same;
  // At the left of a ray that goes out flow turns clockwise.
  if (p.entry == Entry::inside) return swirl(b, j) == Sign::negative ? Order::right : Order::left;
  if (q.entry == Entry::inside) return swirl(a, i) == Sign::negative ? Order::left : Order::right;
  const int first = rank(a, i, p.exit), second = rank(b, j, p.exit);
  if (first != second) return first < second ? Order::left : Order::right;
  if (p.entry == Entry::crossing) return std::nullopt;
  return of_one_point(a, i, b, j);
}

Order Comparison::compare(const Path& a, std::size_t i, const Path& b, std::size_t j) {
  for (;; --i, --j)
    if (const auto order = compare_cells(a, i, b, j)) return *order;
}

}  // namespace crest::certify::compression
