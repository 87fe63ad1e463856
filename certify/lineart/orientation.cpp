// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/lineart/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "certify/exact/filtered.hpp"
#include "certify/exact/vector.hpp"

namespace crest::certify {
namespace {

using kernel::MaybeSign;
using kernel::Rational;
using kernel::Sign;
using Quad = std::array<PointId, 4>;

/// A power of eps: 2^code summed over at most three coordinates, code = 3 rank + coordinate.
/// Descending and filled with kNoCode: the smaller array is the larger power.
using Power = std::array<std::int64_t, 3>;
constexpr std::int64_t kNoCode = -1;

/// A term of the expansion of a determinant by rows that are replaced by eps times unit vectors.
struct Term {
  std::array<int, 4> column;  // of the unit vector of each row, -1: the row stays
  int sign;
  Power code;  // with the rows' positions 0..3 for ranks
};

/// Sign of the determinant of the unit rows against the minor of the others: rows and columns are
/// struck out one by one.
int laplace_sign(const std::array<int, 4>& column) {
  int sign = 1;
  std::array<bool, 4> row_gone{}, column_gone{};
  for (std::size_t r = 0; r < 4; ++r) {
    if (column[r] < 0) continue;
    const auto c = static_cast<std::size_t>(column[r]);
    std::ptrdiff_t place = 0;
    place += std::count(row_gone.begin(), row_gone.begin() + static_cast<std::ptrdiff_t>(r), false);
    place += std::count(column_gone.begin(), column_gone.begin() + static_cast<std::ptrdiff_t>(c),
                        false);
    if (place % 2 != 0) sign = -sign;
    row_gone[r] = column_gone[c] = true;
  }
  return sign;
}

std::vector<Term> all_terms() {
  std::vector<Term> terms;
  for (int code = 0; code < 256; ++code) {
    Term term{{}, 1, {kNoCode, kNoCode, kNoCode}};
    std::array<bool, 3> used{};
    std::size_t count = 0;
    bool good = true;
    for (int r = 3; r >= 0; --r) {
      const int c = (code >> (2 * r) & 3) - 1;
      term.column[static_cast<std::size_t>(r)] = c;
      if (c < 0) continue;
      good = good && !used[static_cast<std::size_t>(c)] && count < 3;
      if (!good) break;
      used[static_cast<std::size_t>(c)] = true;
      term.code[count++] = 3 * r + c;
    }
    if (!good) continue;
    term.sign = laplace_sign(term.column);
    terms.push_back(term);
  }
  std::sort(terms.begin(), terms.end(),
            [](const Term& s, const Term& t) { return s.code < t.code; });
  return terms;
}

const std::vector<Term>& terms() {
  static const std::vector<Term> table = all_terms();
  return table;
}

/// Ascending, and the sign of the permutation.
int sort_ranks(Quad& quad) {
  int sign = 1;
  for (std::size_t i = 1; i < 4; ++i)
    for (std::size_t j = i; j > 0 && quad[j] < quad[j - 1]; --j) {
      std::swap(quad[j], quad[j - 1]);
      sign = -sign;
    }
  return sign;
}

/// A difference of two inputs as a filtered number: one rounding, relative to itself.
Filtered<1> difference(double a, double b) {
  const double d = a - b;
  return {d, std::fabs(d)};
}

Vector<Filtered<1>> difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {difference(a[0], b[0]), difference(a[1], b[1]), difference(a[2], b[2])};
}

Vector<Filtered<1>> as_difference(const std::array<double, 3>& a) {
  return difference(a, {0, 0, 0});
}

template <class T>
T minor_of(const std::array<std::array<T, 4>, 4>& rows, std::array<int, 4> row, int n,
           std::array<int, 4> column) {
  if (n == 0) return T(1);
  T sum = 0;
  // By the first row left.
  std::array<int, 4> rest{};
  for (int i = 1; i < n; ++i)
    rest[static_cast<std::size_t>(i - 1)] = row[static_cast<std::size_t>(i)];
  for (int k = 0; k < n; ++k) {
    const T& x = rows[static_cast<std::size_t>(row[0])]
                     [static_cast<std::size_t>(column[static_cast<std::size_t>(k)])];
    if (x == 0) continue;
    std::array<int, 4> left{};
    for (int i = 0, j = 0; i < n; ++i)
      if (i != k) left[static_cast<std::size_t>(j++)] = column[static_cast<std::size_t>(i)];
    const T m = x * minor_of(rows, rest, n - 1, left);
    if (k % 2 == 0)
      sum += m;
    else
      sum -= m;
  }
  return sum;
}

/// A determinant's coefficients, from the largest power of eps on.
class Expansion {
 public:
  Expansion(const Orientation& o, Quad quad) : quad_(quad), sign_(sort_ranks(quad_)) {
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c < 3; ++c) rows_[r][c] = Rational(o.place(quad_[r])[c]);
      rows_[r][3] = o.weight(quad_[r]);
    }
  }

  bool ended() const { return next_ == terms().size(); }
  /// Of the next term.
  Power power() const {
    Power power = terms()[next_].code;
    for (std::int64_t& code : power)
      if (code != kNoCode)
        code = 3 * std::int64_t{quad_[static_cast<std::size_t>(code / 3)]} + code % 3;
    return power;
  }
  /// The next term's coefficient; moves on.
  Rational take() {
    const Term& term = terms()[next_++];
    std::array<int, 4> row{}, column{};
    int n = 0, m = 0;
    std::array<bool, 4> gone{};
    for (int r = 0; r < 4; ++r) {
      const int c = term.column[static_cast<std::size_t>(r)];
      if (c < 0)
        row[static_cast<std::size_t>(n++)] = r;
      else
        gone[static_cast<std::size_t>(c)] = true;
    }
    for (int c = 0; c < 4; ++c)
      if (!gone[static_cast<std::size_t>(c)]) column[static_cast<std::size_t>(m++)] = c;
    const Rational value = minor_of(rows_, row, n, column);
    return sign_ * term.sign > 0 ? value : Rational(-value);
  }

 private:
  Quad quad_;
  int sign_;
  std::array<std::array<Rational, 4>, 4> rows_;
  std::size_t next_ = 0;
};

/// The coefficients of both at the largest power of eps at which either has one.
struct Leading {
  Rational a, b;
  bool plain = true;  ///< they are those before perturbation
};

Leading leading(Expansion a, Expansion b) {
  // The first terms are the determinants before perturbation, of both.
  for (bool plain = true; !a.ended() || !b.ended(); plain = false) {
    const bool take_a = !a.ended() && (b.ended() || a.power() <= b.power());
    const bool take_b = !b.ended() && (a.ended() || b.power() <= a.power());
    Leading found{take_a ? a.take() : Rational(0), take_b ? b.take() : Rational(0), plain};
    if (found.a != 0 || found.b != 0) return found;
  }
  return {};
}

/// The determinant before perturbation as a filtered number, up to no sign.
auto filtered_determinant(const Orientation& o, const Quad& quad) {
  // A direction, if there is one, is the eye; it is brought to the front.
  Quad q = quad;
  bool odd = false;
  const auto eye = std::find(q.begin(), q.end(), kEye);
  if (eye != q.end() && eye != q.begin()) {
    std::iter_swap(q.begin(), eye);
    odd = true;
  }
  const auto& base = o.place(q[1]);
  const bool direction = o.weight(q[0]) == 0;
  const auto u = direction ? as_difference(o.place(q[0])) : difference(o.place(q[0]), base);
  const auto v = difference(o.place(q[2]), base), w = difference(o.place(q[3]), base);
  auto value = dot(u, cross(v, w));
  if (odd) value.value = -value.value;
  return value;
}

}  // namespace

EdgePoint::EdgePoint(const Rational& at) : t(at) {
  share_b = at.convert_to<double>();
  share_a = 1 - share_b;
  short_enough = Rational(share_b) == t && Rational(share_a) == 1 - t;
}

Sign Orientation::plain_sign(PointId p, PointId q, PointId r, PointId s) const {
  const Quad quad = {p, q, r, s};
  if (const MaybeSign sign = certain_sign(filtered_determinant(*this, quad))) return *sign;
  return kernel::sign_of(Expansion(*this, quad).take());
}

Sign Orientation::sign(PointId p, PointId q, PointId r, PointId s) const {
  const Quad quad = {p, q, r, s};
  if (const MaybeSign sign = certain_sign(filtered_determinant(*this, quad))) return *sign;
  Expansion expansion(*this, quad);
  Rational value = expansion.take();
  if (value == 0) ++symbolic_;
  while (value == 0) value = expansion.take();
  return kernel::sign_of(value);
}

Rational Orientation::limit(PointId p, PointId q, PointId r, EdgeEnds edge) const {
  const Leading at =
      leading(Expansion(*this, {p, q, r, edge.a}), Expansion(*this, {p, q, r, edge.b}));
  return Rational(at.a / (at.a - at.b));
}

std::optional<Sign> Orientation::sign_at(PointId p, PointId q, PointId r, EdgeEnds edge,
                                         const EdgePoint& point) const {
  const Quad with_a = {p, q, r, edge.a}, with_b = {p, q, r, edge.b};
  // A point of the plane at one end leaves the other end's share.
  if (std::find(with_a.begin(), with_a.begin() + 3, edge.a) != with_a.begin() + 3)
    return sign(p, q, r, edge.b);
  if (std::find(with_b.begin(), with_b.begin() + 3, edge.b) != with_b.begin() + 3)
    return sign(p, q, r, edge.a);
  const auto a = filtered_determinant(*this, with_a), b = filtered_determinant(*this, with_b);
  const MaybeSign at_a = certain_sign(a), at_b = certain_sign(b);
  if (at_a && at_b && *at_a == *at_b) return at_a;
  if (point.short_enough) {
    const auto mixed = filtered(point.share_a) * a + filtered(point.share_b) * b;
    if (const MaybeSign sign = certain_sign(mixed)) return sign;
  }
  const Leading at = leading(Expansion(*this, with_a), Expansion(*this, with_b));
  if (!at.plain) ++symbolic_;
  const Sign sign = kernel::sign_of(Rational((1 - point.t) * at.a + point.t * at.b));
  if (sign == Sign::zero) return std::nullopt;
  return sign;
}

bool Orientation::end_on(EdgeEnds edge) const {
  const auto &a = place(edge.a), &b = place(edge.b), &e = place(kEye);
  const auto u = difference(b, a);
  const auto v = c_.parallel ? as_difference(e) : difference(e, a);
  const auto n = cross(u, v);
  if (certain_sign(n.x) || certain_sign(n.y) || certain_sign(n.z)) return false;
  const auto exact = [](const std::array<double, 3>& p) {
    return Vector{Rational(p[0]), Rational(p[1]), Rational(p[2])};
  };
  const Vector<Rational> d = exact(b) - exact(a), w = c_.parallel ? exact(e) : exact(e) - exact(a);
  return d.y * w.z == d.z * w.y && d.z * w.x == d.x * w.z && d.x * w.y == d.y * w.x;
}

}  // namespace crest::certify
