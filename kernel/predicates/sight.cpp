// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/sight.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(SightOrientation)
CREST_INSTANTIATE_STAGES(HomogeneousRows)
CREST_INSTANTIATE_STAGES(PlaceGap)
CREST_INSTANTIATE_STAGES(InFrontOfEye)

namespace {

using Row = std::array<double, 4>;
constexpr unsigned kMostRows = 5;  // of two determinants that share three

/// Bit 3 i + j: coordinate j of the point of rank i moves. At most one a row and one a column:
/// these alone have coefficients. Ascending as numbers, so descending as powers of eps.
std::vector<unsigned> make_monomials() {
  std::vector<unsigned> monomials;
  for (unsigned mask = 1; mask < 1U << (3 * kMostRows); ++mask) {
    unsigned columns = 0;
    bool valid = true;
    for (unsigned i = 0; i < kMostRows; ++i) {
      const unsigned bits = mask >> (3 * i) & 7U;
      valid = valid && (bits & (bits - 1)) == 0 && (bits & columns) == 0;
      columns |= bits;
    }
    if (valid) monomials.push_back(mask);
  }
  return monomials;
}
const std::vector<unsigned>& monomials() {
  static const std::vector<unsigned> all = make_monomials();
  return all;
}

/// Replaces a row by the unit vector of the coordinate that moves in the monomial, if one does.
void move_row(Row& row, unsigned mask, unsigned rank) {
  const unsigned bits = mask >> (3 * rank) & 7U;
  if (bits != 0) row = {bits == 1 ? 1.0 : 0.0, bits == 2 ? 1.0 : 0.0, bits == 4 ? 1.0 : 0.0, 0};
}

bool moves(unsigned mask, unsigned rank) {
  return (mask >> (3 * rank) & 7U) != 0;
}

unsigned place_among(std::span<const VertexNumber> sorted, VertexNumber rank) {
  return static_cast<unsigned>(std::lower_bound(sorted.begin(), sorted.end(), rank) -
                               sorted.begin());
}

Decision climb_counted(const SightOrientation& formula, StageCounts& counts) {
  const Decision d = climb(formula);
  if (d.sign != Sign::zero) counts.add(d.stage);
  return d;
}

}  // namespace

struct Sight::Coefficients {
  Rational a, b;
};

/// A and B of a plane in exact numbers, by the rule of EventPlace.
Sight::Coefficients Sight::coefficients(VertexNumber a, VertexNumber b,
                                        const EventPlane& plane) const {
  const bool seen = plane.r == kNoVertex;
  const std::array<VertexNumber, 5> ranks = {seen ? 0 : plane.p + 1,
                                             seen ? plane.p + 1 : plane.q + 1,
                                             seen ? plane.q + 1 : plane.r + 1, a + 1, b + 1};
  std::array<VertexNumber, 5> sorted = ranks;
  std::sort(sorted.begin(), sorted.end());
  const auto coefficient = [&](unsigned mask, std::size_t end) {
    HomogeneousRows rows;
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexNumber rank = ranks[i < 3 ? i : end];
      rows.row[i] = row(rank);
      move_row(rows.row[i], mask, place_among(sorted, rank));
    }
    return rows.value<Rational>();
  };
  const auto values = [&](unsigned mask) {
    Coefficients c{0, 0};
    if (!moves(mask, place_among(sorted, b + 1))) c.a = coefficient(mask, 3);
    if (!moves(mask, place_among(sorted, a + 1))) c.b = coefficient(mask, 4);
    return c;
  };
  Coefficients c = values(0);
  for (std::size_t m = 0; c.a == 0 && c.b == 0 && m < monomials().size(); ++m)
    c = values(monomials()[m]);
  return c;
}

std::array<double, 4> Sight::row(VertexNumber rank) const {
  const Vec3& p = rank == 0 ? eye_.at : points_[rank - 1];
  return {p[0], p[1], p[2], rank == 0 ? eye_.weight() : 1};
}

template <std::size_t N>
Decision Sight::resolve(std::array<VertexNumber, N> ranks, SightOrientation formula,
                        StageCounts& counts) const {
  const Decision flat = climb_counted(formula, counts);
  if (flat.sign != Sign::zero) return flat;
  counts.add(Stage::symbolic);
  std::array<VertexNumber, N> sorted = ranks;
  std::sort(sorted.begin(), sorted.end());
  for (const unsigned mask : monomials()) {
    HomogeneousRows rows;
    for (std::size_t i = 0; i < N; ++i) {
      rows.row[i] = row(ranks[i]);
      move_row(rows.row[i], mask, place_among(sorted, ranks[i]));
    }
    if (const Sign s = climb(rows).sign; s != Sign::zero) return {s, Stage::symbolic};
  }
  return {Sign::zero,
          Stage::symbolic};  // never for distinct ranks: three moved rows leave a weight
}

Decision Sight::side(VertexNumber a, VertexNumber b, VertexNumber c, SightCounts& counts) const {
  return resolve<4>({0, a + 1, b + 1, c + 1},
                    {eye_.at, eye_.weight(), points_[a], points_[b], points_[c]}, counts.side);
}

Decision Sight::volume(VertexNumber a, VertexNumber b, VertexNumber c, VertexNumber d,
                       SightCounts& counts) const {
  return resolve<4>({a + 1, b + 1, c + 1, d + 1},
                    {points_[a], 1, points_[b], points_[c], points_[d]}, counts.volume);
}

Sign Sight::flat_side(VertexNumber a, VertexNumber b, VertexNumber c) const {
  return climb(SightOrientation{eye_.at, eye_.weight(), points_[a], points_[b], points_[c]}).sign;
}

Sign Sight::flat_volume(VertexNumber a, VertexNumber b, VertexNumber c, VertexNumber d) const {
  return climb(SightOrientation{points_[a], 1, points_[b], points_[c], points_[d]}).sign;
}

bool Sight::crosses(VertexNumber a, VertexNumber b, VertexNumber c, VertexNumber d,
                    SightCounts& counts) const {
  return side(c, d, a, counts).sign != side(c, d, b, counts).sign &&
         side(a, b, c, counts).sign != side(a, b, d, counts).sign;
}

bool Sight::in_front(VertexNumber a, VertexNumber b, VertexNumber c, VertexNumber d,
                     SightCounts& counts) const {
  // [a, b, c, e] = -[e, a, b, c].
  return volume(a, b, c, d, counts).sign == -side(a, b, c, counts).sign;
}

bool Sight::pierces(VertexNumber a, VertexNumber b, const Corners& f, SightCounts& counts) const {
  const auto [p, q, r] = f;
  if (volume(p, q, r, a, counts).sign == volume(p, q, r, b, counts).sign) return false;
  const Sign s = volume(a, b, p, q, counts).sign;
  return volume(a, b, q, r, counts).sign == s && volume(a, b, r, p, counts).sign == s;
}

bool Sight::covers(const Corners& f, VertexNumber a, SightCounts& counts) const {
  const auto [p, q, r] = f;
  const Sign s = side(a, p, q, counts).sign;
  if (side(a, q, r, counts).sign != s || side(a, r, p, counts).sign != s) return false;
  return volume(p, q, r, a, counts).sign == side(p, q, r, counts).sign;
}

bool Sight::end_on(VertexNumber a, VertexNumber b) const {
  const Vec3 &p = points_[a], &q = points_[b];
  const Vec3 o = eye_.finite ? p : Vec3{};
  // (e - o) and (q - p), or e and (q - p), are parallel: no coordinate of their product is left.
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3;
    const auto value = [&]<class T>(T) {
      const T ej = input_difference<T>(eye_.at[j], o[j]),
              ek = input_difference<T>(eye_.at[k], o[k]);
      return ej * input_difference<T>(q[k], p[k]) - ek * input_difference<T>(q[j], p[j]);
    };
    constexpr int kDepth = 5;
    if (const MaybeSign s = certain_sign(value(Approximate()), kDepth); s && *s != Sign::zero)
      return false;
    if (sign_of(value(Rational())) != Sign::zero) return false;
  }
  return true;
}

SightOrientation Sight::value_at(const EventPlane& plane, VertexNumber v) const {
  if (plane.r == kNoVertex)
    return {eye_.at, eye_.weight(), points_[plane.p], points_[plane.q], points_[v]};
  return {points_[plane.p], 1, points_[plane.q], points_[plane.r], points_[v]};
}

EventPlace Sight::place(VertexNumber a, VertexNumber b, const EventPlane& plane,
                        SightCounts& counts) const {
  EventPlace place;
  place.plane_ = plane;
  const SightOrientation at_a = value_at(plane, a), at_b = value_at(plane, b);
  place.a_ = at_a.value<Approximate>();
  place.b_ = at_b.value<Approximate>();
  const Sign sa = climb(at_a).sign, sb = climb(at_b).sign;
  place.positive_ = sa == Sign::positive || sb == Sign::negative;
  place.start_ = sa == Sign::zero && sb != Sign::zero;
  place.end_ = sb == Sign::zero && sa != Sign::zero;
  place.symbolic_ = sa == Sign::zero && sb == Sign::zero;
  if (place.symbolic_) {
    const Decision d = plane.r == kNoVertex ? side(plane.p, plane.q, a, counts)
                                            : volume(plane.p, plane.q, plane.r, a, counts);
    place.positive_ = d.sign == Sign::positive;
  }
  if (sa != Sign::zero && sb != Sign::zero)
    place.guess_ = place.a_.value / (place.a_.value - place.b_.value);
  if (place.symbolic_ || !(place.guess_ >= 0 && place.guess_ <= 1)) {
    const auto [x, y] = coefficients(a, b, plane);
    if (place.symbolic_) place.start_ = x == 0;
    if (place.symbolic_) place.end_ = y == 0;
    place.guess_ = static_cast<double>(Rational(x / (x - y)));
  }
  if (place.end_) place.guess_ = 1;
  return place;
}

Sign Sight::event_order(VertexNumber a, VertexNumber b, const EventPlace& first,
                        const EventPlace& second, SightCounts& counts) const {
  const Sign denominators = first.positive_ == second.positive_ ? Sign::positive : Sign::negative;
  if (first.symbolic_ || second.symbolic_) {
    counts.order.add(Stage::symbolic);
    const auto [a1, b1] = coefficients(a, b, first.plane_);
    const auto [a2, b2] = coefficients(a, b, second.plane_);
    return sign_of(Rational(a2 * b1 - a1 * b2)) * denominators;
  }
  const Approximate gap = second.a_ * first.b_ - first.a_ * second.b_;
  if (const MaybeSign s = certain_sign(gap, PlaceGap::depth)) {
    counts.order.add(Stage::triage);
    return *s * denominators;
  }
  const Decision d = climb(PlaceGap{value_at(first.plane_, a), value_at(first.plane_, b),
                                    value_at(second.plane_, a), value_at(second.plane_, b)});
  counts.order.add(d.stage);
  return d.sign * denominators;
}

Sign in_front_of_eye(const Vec3& e, const Vec3& z, const Vec3& p) {
  return climb(InFrontOfEye{z, p, e}).sign;
}

}  // namespace crest::kernel
