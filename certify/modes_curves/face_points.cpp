// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes_curves/face_points.hpp"

#include <algorithm>
#include <memory>

#include "certify/container/reject.hpp"
#include "certify/modes_curves/quartic_roots.hpp"
#include "kernel/arithmetic/ball.hpp"

namespace crest::certify::curves {
namespace {

using kernel::Ball;
using modes::Place;
using modes::Sturm;

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial c(std::max(a.size(), b.size()), Integer(0));
  for (std::size_t i = 0; i < a.size(); ++i) c[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) c[i] += b[i];
  return c;
}
Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, Integer(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}
Polynomial scaled(const Integer& factor, Polynomial a) {
  for (Integer& x : a) x *= factor;
  return a;
}
Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  return a + scaled(-1, b);
}

Rational value(const Place& t) {
  return Rational(t.numerator, Integer(1) << t.exponent);
}

/// a(u), or a(-u) if `negative`, without the zeros at both ends: times a power of u > 0.
Polynomial trimmed(Polynomial a, bool negative) {
  if (negative)
    for (std::size_t i = 1; i < a.size(); i += 2) a[i] = -a[i];
  while (!a.empty() && a.back() == 0) a.pop_back();
  const auto first = std::ranges::find_if(a, [](const Integer& x) { return x != 0; });
  a.erase(a.begin(), first);
  return a;
}

/// Doubles of a positive multiple: what is cut off is below one unit, and 2^-52 of the number.
std::vector<Ball> approximate(const Polynomial& a) {
  unsigned bits = 0;
  for (const Integer& x : a)
    if (x != 0) bits = std::max(bits, static_cast<unsigned>(msb(Integer(abs(x)))));
  constexpr unsigned kMost = 900;
  const unsigned shift = bits > kMost ? bits - kMost : 0;
  std::vector<Ball> list;
  for (const Integer& x : a) {
    const double number = static_cast<double>(Integer(x / (Integer(1) << shift)));
    list.emplace_back(number, 0x1.1p-52 * std::fabs(number) + (shift > 0 ? 1 : 0));
  }
  return list;
}

/// sum a_i t^i (1 - t)^(d - i).
Ball value(const std::vector<Ball>& a, const Ball& t) {
  const Ball rest = Ball(1) - t;
  Ball sum = 0, power = 1;
  for (std::size_t i = a.size(); i-- > 0;) {
    sum = sum * t + a[i] * power;
    power = power * rest;
  }
  return sum;
}

Matrix<Integer> congruent(const Matrix<Integer>& p, const std::array<std::array<int, 3>, 3>& m) {
  Matrix<Integer> half, q;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      half[i][j] = p[i][0] * m[0][j] + p[i][1] * m[1][j] + p[i][2] * m[2][j];
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      q[i][j] = half[0][j] * m[0][i] + half[1][j] * m[1][i] + half[2][j] * m[2][i];
  return q;
}

/// With y = 1: p0 z^2 + p1 z + p2, polynomials in x.
struct InZ {
  Integer p0;
  Polynomial p1, p2;
  explicit InZ(const Matrix<Integer>& p)
      : p0(p[2][2]), p1{2 * p[1][2], 2 * p[0][2]}, p2{p[1][1], 2 * p[0][1], p[0][0]} {}
};

/// v . B v.
Polynomial form(const Matrix<Integer>& b, const FacePoint::Curve& v) {
  Polynomial sum;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = i; j < 3; ++j) sum = sum + scaled((i == j ? 1 : 2) * b[i][j], v[i] * v[j]);
  return sum;
}

/// The sign on a closed interval of sum a_i t^i (1 - t)^(d - i), if Bernstein's coefficients there
/// have one; else 0.
int sign_between(const Polynomial& a, const Place& low, const Place& high) {
  const unsigned e = std::max(low.exponent, high.exponent);
  const Integer unit = Integer(1) << e;
  const Integer l = low.numerator << (e - low.exponent), h = high.numerator << (e - high.exponent);
  // In the homogeneous coordinates of the interval's ends.
  const Polynomial t = {l, h}, rest = {unit - l, unit - h};
  Polynomial sum = {a.back()}, power = {1};
  for (std::size_t i = a.size() - 1; i-- > 0;) {
    power = power * rest;
    sum = sum * t + scaled(a[i], power);
  }
  const int sign = sum.front() > 0 ? 1 : sum.front() < 0 ? -1 : 0;
  const bool one_sign = std::ranges::all_of(sum, [&](const Integer& x) { return x * sign >= 0; });
  return one_sign && sum.back() != 0 ? sign : 0;
}

/// Intervals of single roots in (0, 1).
using Intervals = std::vector<std::array<Place, 2>>;

/// In doubles with errors: the roots found are simple. False where these do not tell.
bool isolate_by_doubles(const Polynomial& quartic, Intervals& list) {
  const auto a = approximate(quartic);
  std::vector<Bracket> brackets;
  if (!curves::isolate<Ball>({a[0], a[1] / 4, a[2] / 6, a[3] / 4, a[4]}, 0, 1, 0x1p-40, brackets))
    return false;
  for (const Bracket& b : brackets) list.push_back({modes::place(b.low), modes::place(b.high)});
  return true;
}

/// By Sturm's theorem. False if a root is multiple.
bool isolate(const Sturm& sturm, const Place& low, const Place& high, Intervals& list,
             unsigned depth = 0) {
  const int count = sturm.distinct(low, high);
  if (count == 1) list.push_back({low, high});
  if (count <= 1) return true;
  constexpr unsigned kMostHalvings = 400;
  if (depth > kMostHalvings) return false;
  for (const unsigned k : {4U, 3U, 5U, 2U, 6U}) {
    const Place middle = modes::between(low, high, k);
    if (sturm.sign(middle) != 0)
      return isolate(sturm, low, middle, list, depth + 1) &&
             isolate(sturm, middle, high, list, depth + 1);
  }
  return false;
}

/// a / b, which divides it.
Polynomial quotient(Polynomial a, const Polynomial& b) {
  Polynomial q(a.size() - b.size() + 1);
  for (std::size_t k = q.size(); k-- > 0;) {
    q[k] = a[k + b.size() - 1] / b.back();
    for (std::size_t i = 0; i < b.size(); ++i) a[k + i] -= q[k] * b[i];
  }
  return q;
}

/// The roots in (0, 1) of a quartic, as simple ones of `simple`; those of `multiple` are multiple.
struct Roots {
  std::shared_ptr<const Polynomial> simple;
  Polynomial multiple = {1};
  Intervals intervals;
};
std::optional<Roots> find_roots(Polynomial quartic) {
  Roots roots;
  if (isolate_by_doubles(quartic, roots.intervals)) {
    roots.simple = std::make_shared<const Polynomial>(std::move(quartic));
    return roots;
  }
  roots.intervals.clear();
  Integer divisor = 0;
  for (const Integer& x : quartic) divisor = gcd(divisor, x);
  for (Integer& x : quartic) x /= divisor;
  roots.multiple = Sturm(quartic).multiple();
  roots.simple = std::make_shared<const Polynomial>(quotient(quartic, roots.multiple));
  if (!isolate(Sturm(*roots.simple), modes::place(0), modes::place(1), roots.intervals))
    return std::nullopt;
  return roots;
}

/// Changes of coordinates to be tried, so that no two points lie on a line with the centre.
constexpr std::array<std::array<std::array<int, 3>, 3>, 5> kCoordinates = {
    {{{{3, 1, 2}, {-1, 4, 1}, {2, -3, 5}}},
     {{{1, 2, 7}, {5, -1, 3}, {-2, 6, 1}}},
     {{{7, -3, 1}, {2, 5, -6}, {1, 1, 4}}},
     {{{2, 9, -5}, {-7, 1, 3}, {4, 2, 11}}},
     {{{13, 2, -1}, {3, -8, 5}, {-6, 1, 9}}}}};

/// Two conics in some coordinates; z = -a / b at their common points.
struct Elimination {
  Integer p0, q0;
  Polynomial a, b, resultant;

  Elimination(const Matrix<Integer>& p_there, const Matrix<Integer>& q_there,
              const std::array<std::array<int, 3>, 3>& m) {
    const InZ p(congruent(p_there, m)), q(congruent(q_there, m));
    p0 = p.p0, q0 = q.p0;
    a = scaled(p.p0, q.p2) - scaled(q.p0, p.p2);
    b = scaled(p.p0, q.p1) - scaled(q.p0, p.p1);
    resultant = a * a - b * (p.p1 * q.p2 - q.p1 * p.p2);
  }
};

/// The common points of two conics in some coordinates; empty if these do not show them.
std::optional<std::vector<FacePoint>> common_points(const Matrix<Integer>& p,
                                                    const Matrix<Integer>& q,
                                                    const std::array<std::array<int, 3>, 3>& m) {
  const auto [p0, q0, a, b, resultant] = Elimination(p, q, m);
  if (resultant.size() < 5 || resultant[4] == 0 || resultant[0] == 0) return std::nullopt;
  // z = -a / b: v = (x b, b, -a), turned back.
  const FacePoint::Curve local = {Polynomial{0, 1} * b, b, scaled(-1, a)};
  FacePoint::Curve turned;
  for (unsigned i = 0; i < 3; ++i)
    turned[i] = scaled(m[i][0], local[0]) + scaled(m[i][1], local[1]) + scaled(m[i][2], local[2]);
  const auto v = std::make_shared<const FacePoint::Curve>(std::move(turned));
  std::vector<FacePoint> points;
  for (const bool negative : {false, true}) {
    const auto roots = find_roots(trimmed(resultant, negative));
    if (!roots) return std::nullopt;
    for (const auto& [low, high] : roots->intervals) {
      FacePoint& point = points.emplace_back(roots->simple, low, high, negative, v);
      const auto denominator = point.sign(b);
      if (!denominator || *denominator == 0) return std::nullopt;
      // In the same variable as the quartic, trimmed and turned already.
      point.multiple = !point.avoids(roots->multiple);
    }
  }
  return points;
}

}  // namespace

Range operator+(const Range& a, const Range& b) {
  return {a.low + b.low, a.high + b.high};
}
Range operator-(const Range& a, const Range& b) {
  return {a.low - b.high, a.high - b.low};
}
Range operator*(const Range& a, const Range& b) {
  const std::array<Rational, 4> ends = {a.low * b.low, a.low * b.high, a.high * b.low,
                                        a.high * b.high};
  const auto [low, high] = std::ranges::minmax(ends);
  return {low, high};
}

FacePoint::FacePoint(std::shared_ptr<const Polynomial> polynomial, Place low, Place high,
                     bool negative, std::shared_ptr<const Curve> v)
    : polynomial_(std::move(polynomial)),
      low_(std::move(low)),
      high_(std::move(high)),
      negative_(negative),
      v_(std::move(v)) {
  refine_by_doubles();
  while (high_.numerator == Integer(1) << high_.exponent)
    refine();  // u is infinite there, the root is not
}

/// Bisects as long as doubles tell the sign.
void FacePoint::refine_by_doubles() {
  // Places of few bits are doubles.
  constexpr unsigned kMostBits = 50;
  if (low_.exponent > kMostBits || high_.exponent > kMostBits) return;
  const auto to_double = [](const Place& t) {
    return std::ldexp(static_cast<double>(t.numerator), -static_cast<int>(t.exponent));
  };
  near_low_ = to_double(low_), near_high_ = to_double(high_);
  const auto a = approximate(*polynomial_);
  const int sign_low = modes::sign_at(*polynomial_, low_);
  for (;;) {
    const double middle = near_low_ + (near_high_ - near_low_) / 2;
    if (!(near_low_ < middle && middle < near_high_)) break;
    const int there = sign_of(value(a, Ball(middle)));
    if (there == 0) break;
    (there == sign_low ? near_low_ : near_high_) = middle;
  }
  low_ = modes::place(near_low_), high_ = modes::place(near_high_);
}

void FacePoint::refine() {
  for (const unsigned k : {4U, 3U, 5U, 2U, 6U}) {
    const Place middle = modes::between(low_, high_, k);
    const int there = modes::sign_at(*polynomial_, middle);
    if (there == 0) continue;
    (there == modes::sign_at(*polynomial_, low_) ? low_ : high_) = middle;
    return;
  }
}

int FacePoint::certain_sign(const Polynomial& polynomial) const {
  const double middle = near_low_ + (near_high_ - near_low_) / 2;
  const double radius = 1.001 * std::max(near_high_ - middle, middle - near_low_) + 0x1p-1000;
  return sign_of(value(approximate(trimmed(polynomial, negative_)), Ball(middle, radius)));
}

std::optional<int> FacePoint::sign(const Polynomial& polynomial, unsigned halvings) {
  if (const int certain = certain_sign(polynomial); certain != 0) return certain;
  return exact_sign(trimmed(polynomial, negative_), halvings);
}

bool FacePoint::avoids(const Polynomial& other) {
  return exact_sign(other, kMostHalvings).has_value();
}

std::optional<int> FacePoint::exact_sign(const Polynomial& list, unsigned halvings) {
  if (list.empty()) return std::nullopt;
  if (list.size() == 1) return list[0] > 0 ? 1 : -1;
  constexpr unsigned kFew = 96;
  for (unsigned i = 0; i < halvings; ++i) {
    if (i % 4 == 0)
      if (const int found = sign_between(list, low_, high_); found != 0) return found;
    if (i == kFew && may_vanish(list)) return std::nullopt;
    refine();
  }
  return std::nullopt;
}

/// A common root of both is a multiple one of their product.
bool FacePoint::may_vanish(const Polynomial& list) const {
  const Polynomial common = Sturm(*polynomial_ * list).multiple();
  if (common.size() == 1) return false;
  const Sturm roots(common);
  return roots.sign(low_) == 0 || roots.sign(high_) == 0 || roots.distinct(low_, high_) > 0;
}

Range FacePoint::at() const {
  const Rational low = value(low_) / (1 - value(low_));
  const Rational high = value(high_) / (1 - value(high_));
  if (negative_) return {-high, -low};
  return {low, high};
}

Triple<Range> FacePoint::direction() const {
  const Range u = at();
  Triple<Range> v;
  for (unsigned i = 0; i < 3; ++i) {
    v[i] = {0, 0};
    for (std::size_t k = curve()[i].size(); k-- > 0;) {
      const Rational c(curve()[i][k]);
      v[i] = v[i] * u + Range{c, c};
    }
  }
  return v;
}

std::vector<Matrix<Integer>> matrices(modes::ExactTensors& exact, std::span<const u32> corners) {
  std::vector<modes::ExactTensor> tensors;
  for (const u32 v : corners) tensors.push_back(exact(v));
  long least = tensors[0].exponent;
  for (const auto& t : tensors) least = std::min(least, t.exponent);
  std::vector<Matrix<Integer>> list;
  for (auto& t : tensors) {
    for (Integer& x : t.entries) x <<= static_cast<unsigned>(t.exponent - least);
    const auto& [xx, yy, zz, xy, yz, xz] = t.entries;
    list.push_back({{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}});
  }
  return list;
}

Integer determinant(const Matrix<Integer>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

namespace {

Integer inner(const Matrix<Integer>& a, const Matrix<Integer>& b) {
  Integer sum = 0;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j) sum += a[i][j] * b[i][j];
  return sum;
}

/// Along the first row.
Integer laplace(const std::vector<std::vector<Integer>>& m);
Integer cofactor(const std::vector<std::vector<Integer>>& m, std::size_t row, std::size_t column) {
  std::vector<std::vector<Integer>> minor;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (i == row) continue;
    minor.emplace_back();
    for (std::size_t j = 0; j < m.size(); ++j)
      if (j != column) minor.back().push_back(m[i][j]);
  }
  const Integer d = laplace(minor);
  return (row + column) % 2 == 0 ? d : Integer(-d);
}
Integer laplace(const std::vector<std::vector<Integer>>& m) {
  if (m.size() == 1) return m[0][0];
  if (m.size() == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  Integer sum = 0;
  for (std::size_t j = 0; j < m.size(); ++j) sum += m[0][j] * cofactor(m, 0, j);
  return sum;
}

/// A basis of traceless symmetric matrices.
Matrix<Integer> basis(unsigned k) {
  Matrix<Integer> m{};
  if (k < 2) m[k][k] = 1, m[2][2] = -1;
  if (k == 2) m[0][1] = m[1][0] = 1;
  if (k == 3) m[1][2] = m[2][1] = 1;
  if (k == 4) m[0][2] = m[2][0] = 1;
  return m;
}

void make_primitive(std::array<Integer, 5>& row) {
  Integer divisor = 0;
  for (const Integer& x : row) divisor = gcd(divisor, x);
  if (divisor > 1)
    for (Integer& x : row) x /= divisor;
}

}  // namespace

/// The inverse of Gram's matrix, times its determinant, which is positive.
std::vector<Matrix<Integer>> dual_basis(const std::vector<Matrix<Integer>>& tensors) {
  const std::size_t n = tensors.size();
  std::vector<std::vector<Integer>> gram(n, std::vector<Integer>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) gram[i][j] = inner(tensors[i], tensors[j]);
  require(laplace(gram) != 0, "dependent tensors, not listed as special");
  std::vector<Matrix<Integer>> dual(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const Integer weight = cofactor(gram, i, j);
      for (unsigned r = 0; r < 3; ++r)
        for (unsigned c = 0; c < 3; ++c) dual[i][r][c] += weight * tensors[j][r][c];
    }
  return dual;
}

std::vector<Matrix<Integer>> complement(const std::vector<Matrix<Integer>>& tensors) {
  std::vector<std::array<Integer, 5>> rows(tensors.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (unsigned k = 0; k < 5; ++k) rows[i][k] = inner(tensors[i], basis(k));
    make_primitive(rows[i]);
  }
  std::array<std::size_t, 5> pivot_of{};
  pivot_of.fill(5);
  std::size_t rank = 0;
  for (unsigned k = 0; k < 5 && rank < rows.size(); ++k) {
    std::size_t at = rank;
    while (at < rows.size() && rows[at][k] == 0) ++at;
    if (at == rows.size()) continue;
    std::swap(rows[at], rows[rank]);
    const Integer lead = rows[rank][k];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == rank) continue;
      const Integer factor = rows[i][k];
      for (unsigned j = 0; j < 5; ++j) rows[i][j] = lead * rows[i][j] - factor * rows[rank][j];
      make_primitive(rows[i]);
    }
    pivot_of[k] = rank++;
  }
  if (rank < tensors.size()) return {};
  Integer common = 1;
  for (unsigned k = 0; k < 5; ++k)
    if (pivot_of[k] != 5) common = lcm(common, rows[pivot_of[k]][k]);
  std::vector<Matrix<Integer>> list;
  for (unsigned free = 0; free < 5; ++free) {
    if (pivot_of[free] != 5) continue;
    Matrix<Integer> m{};
    const auto add = [&](const Integer& factor, unsigned k) {
      const auto part = basis(k);
      for (unsigned r = 0; r < 3; ++r)
        for (unsigned c = 0; c < 3; ++c) m[r][c] += factor * part[r][c];
    };
    add(common, free);
    for (unsigned k = 0; k < 5; ++k) {
      if (pivot_of[k] == 5) continue;
      const auto& row = rows[pivot_of[k]];
      add(-row[free] * (common / row[k]), k);
    }
    list.push_back(m);
  }
  return list;
}

namespace {

/// low < a weight's share of the sum: 2^e weight - m sum, with low = m / 2^e.
Polynomial beyond(const Polynomial& weight, double bound, const Polynomial& sum) {
  int exponent = 0;
  const double fraction = std::frexp(bound, &exponent);
  const Integer mantissa = static_cast<long long>(std::ldexp(fraction, 53));
  exponent -= 53;
  if (exponent >= 0) return weight - scaled(mantissa << static_cast<unsigned>(exponent), sum);
  return scaled(Integer(1) << static_cast<unsigned>(-exponent), weight) - scaled(mantissa, sum);
}

/// The common sign of the weights; 0 if they differ: the point is not in the closed face.
int common_sign(FacePoint& point, const std::array<Polynomial, 3>& weights,
                const std::array<u32, 3>& corners) {
  std::array<int, 3> signs{};
  for (unsigned i = 0; i < 3; ++i) signs[i] = point.certain_sign(weights[i]);
  const auto differ = [&] {
    const auto [low, high] = std::ranges::minmax(signs);
    return low < 0 && high > 0;
  };
  // A weight that is zero, or nearly, takes long: two others that differ make it needless.
  for (const unsigned halvings : {24U, FacePoint::kMostHalvings})
    for (unsigned i = 0; i < 3 && !differ(); ++i)
      if (signs[i] == 0) signs[i] = point.sign(weights[i], halvings).value_or(0);
  const bool open = std::ranges::find(signs, 0) != signs.end();
  if (differ()) return 0;
  require(!open, "face ({}, {}, {}): a point on an edge, not listed as special", corners[0],
          corners[1], corners[2]);
  return signs[0];
}

}  // namespace

bool share_line(const Matrix<Integer>& p, const Matrix<Integer>& q) {
  // Conics whose equations have no square of z both go through the centre: other coordinates.
  for (const auto& coordinates : kCoordinates) {
    const Elimination by_z(p, q, coordinates);
    if (by_z.p0 == 0 && by_z.q0 == 0) continue;
    return std::ranges::all_of(by_z.resultant, [](const Integer& x) { return x == 0; });
  }
  return false;
}

std::optional<std::vector<FacePoint>> find_points(modes::ExactTensors& exact,
                                                  const std::array<u32, 3>& corners,
                                                  const std::vector<Box>& boxes) {
  const auto tensors = matrices(exact, corners);
  const auto rest = complement(tensors);
  if (rest.empty()) return std::nullopt;
  const auto dual = dual_basis(tensors);
  std::optional<std::vector<FacePoint>> all;
  for (const auto& coordinates : kCoordinates) {
    all = common_points(rest[0], rest[1], coordinates);
    if (all) break;
  }
  if (!all) return std::nullopt;
  std::vector<FacePoint> found;
  if (all->empty()) {
    require(boxes.empty(), "face ({}, {}, {}): {} degenerate points listed, none found", corners[0],
            corners[1], corners[2], boxes.size());
    return found;
  }
  std::array<Polynomial, 3> weights;
  for (unsigned i = 0; i < 3; ++i) weights[i] = form(dual[i], all->front().curve());
  const Polynomial sum = weights[0] + weights[1] + weights[2];
  std::vector<std::uint8_t> used(boxes.size(), 0);
  for (FacePoint& point : *all) {
    point.type = common_sign(point, weights, corners);
    if (point.type == 0) continue;
    if (point.multiple) return std::nullopt;
    const auto inside = [&](const Box& box) {
      for (unsigned i = 0; i < 2; ++i) {
        const auto above = point.sign(beyond(weights[i], box.low[i], sum));
        if (!above || *above != point.type) return false;
        const auto below = point.sign(beyond(weights[i], box.high[i], sum));
        if (!below || *below != -point.type) return false;
      }
      return true;
    };
    const auto at = std::ranges::find_if(boxes, inside);
    require(at != boxes.end(), "face ({}, {}, {}): a degenerate point in no listed box", corners[0],
            corners[1], corners[2]);
    auto& once = used[static_cast<std::size_t>(at - boxes.begin())];
    require(once == 0, "face ({}, {}, {}): two degenerate points in a box", corners[0], corners[1],
            corners[2]);
    once = 1;
    require(at->type == point.type, "face ({}, {}, {}): the type of a point", corners[0],
            corners[1], corners[2]);
    point.listed = at->listed;
    found.push_back(point);
  }
  require(found.size() == boxes.size(), "face ({}, {}, {}): {} degenerate points listed, {} found",
          corners[0], corners[1], corners[2], boxes.size(), found.size());
  return found;
}

}  // namespace crest::certify::curves
