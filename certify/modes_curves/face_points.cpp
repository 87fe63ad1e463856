// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes_curves/face_points.hpp"

#include <algorithm>
#include <memory>

#include "certify/container/reject.hpp"

namespace crest::certify::curves {
namespace {

using modes::Integer;
using modes::Place;
using modes::Sturm;
using Polynomial = std::vector<Rational>;

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial c(std::max(a.size(), b.size()), Rational(0));
  for (std::size_t i = 0; i < a.size(); ++i) c[i] += a[i];
  for (std::size_t i = 0; i < b.size(); ++i) c[i] += b[i];
  return c;
}
Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, Rational(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}
Polynomial scaled(const Rational& factor, Polynomial a) {
  for (Rational& x : a) x *= factor;
  return a;
}
Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  return a + scaled(-1, b);
}

Rational value(const Place& t) {
  return Rational(t.numerator, Integer(1) << t.exponent);
}

/// Numbers without denominators; a(-u) if `negative`. Zeros at both ends are dropped.
std::vector<Integer> integers(const Polynomial& a, bool negative) {
  Integer common = 1;
  for (const Rational& x : a) common = lcm(common, Integer(denominator(x)));
  std::vector<Integer> list;
  for (std::size_t i = 0; i < a.size(); ++i) {
    Integer x = Integer(numerator(a[i])) * (common / Integer(denominator(a[i])));
    if (negative && i % 2 == 1) x = -x;
    list.push_back(x);
  }
  while (!list.empty() && list.back() == 0) list.pop_back();
  const auto first = std::ranges::find_if(list, [](const Integer& x) { return x != 0; });
  list.erase(list.begin(), first);
  return list;
}

Matrix<Rational> congruent(const Matrix<Rational>& p, const std::array<std::array<int, 3>, 3>& m) {
  Matrix<Rational> q;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j) {
      Rational sum = 0;
      for (unsigned k = 0; k < 3; ++k)
        for (unsigned l = 0; l < 3; ++l) sum += m[k][i] * p[k][l] * m[l][j];
      q[i][j] = sum;
    }
  return q;
}

/// With y = 1: p0 z^2 + p1 z + p2, polynomials in x.
struct InZ {
  Rational p0;
  Polynomial p1, p2;
  explicit InZ(const Matrix<Rational>& p)
      : p0(p[2][2]), p1{2 * p[1][2], 2 * p[0][2]}, p2{p[1][1], 2 * p[0][1], p[0][0]} {}
};

/// v . B v.
Polynomial form(const Matrix<Rational>& b, const std::array<Polynomial, 3>& v) {
  Polynomial sum;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = i; j < 3; ++j) sum = sum + scaled((i == j ? 1 : 2) * b[i][j], v[i] * v[j]);
  return sum;
}

/// Changes of coordinates to be tried, so that no two points lie on a line with the centre.
constexpr std::array<std::array<std::array<int, 3>, 3>, 5> kCoordinates = {
    {{{{3, 1, 2}, {-1, 4, 1}, {2, -3, 5}}},
     {{{1, 2, 7}, {5, -1, 3}, {-2, 6, 1}}},
     {{{7, -3, 1}, {2, 5, -6}, {1, 1, 4}}},
     {{{2, 9, -5}, {-7, 1, 3}, {4, 2, 11}}},
     {{{13, 2, -1}, {3, -8, 5}, {-6, 1, 9}}}}};

/// The common points of two conics in some coordinates; empty if these do not show them.
std::optional<std::vector<FacePoint>> common_points(const Matrix<Rational>& p_there,
                                                    const Matrix<Rational>& q_there,
                                                    const std::array<std::array<int, 3>, 3>& m) {
  const InZ p(congruent(p_there, m)), q(congruent(q_there, m));
  const Polynomial a = scaled(p.p0, q.p2) - scaled(q.p0, p.p2);
  const Polynomial b = scaled(p.p0, q.p1) - scaled(q.p0, p.p1);
  const Polynomial c = p.p1 * q.p2 - q.p1 * p.p2;
  const Polynomial resultant = a * a - b * c;
  if (resultant.size() < 5 || resultant[4] == 0 || resultant[0] == 0) return std::nullopt;
  // z = -a / b: v = (x b, b, -a), turned back.
  const std::array<Polynomial, 3> local = {Polynomial{0, 1} * b, b, scaled(-1, a)};
  std::array<Polynomial, 3> v;
  for (unsigned i = 0; i < 3; ++i)
    v[i] = scaled(m[i][0], local[0]) + scaled(m[i][1], local[1]) + scaled(m[i][2], local[2]);
  std::vector<FacePoint> points;
  for (const bool negative : {false, true}) {
    const auto sturm = std::make_shared<const Sturm>(integers(resultant, negative));
    if (!sturm->square_free()) return std::nullopt;
    const std::function<bool(Place, Place, int)> isolate = [&](const Place& low, const Place& high,
                                                               int depth) {
      const int count = sturm->distinct(low, high);
      if (count == 0) return true;
      if (count == 1) {
        points.emplace_back(sturm, low, high, negative, v);
        const auto denominator = points.back().sign(b);
        return denominator && *denominator != 0;
      }
      if (depth > 400) return false;
      for (const unsigned k : {4U, 3U, 5U, 2U, 6U}) {
        const Place middle = modes::between(low, high, k);
        if (sturm->sign(middle) != 0)
          return isolate(low, middle, depth + 1) && isolate(middle, high, depth + 1);
      }
      return false;
    };
    if (!isolate(modes::place(0), modes::place(1), 0)) return std::nullopt;
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

FacePoint::FacePoint(std::shared_ptr<const Sturm> sturm, Place low, Place high, bool negative,
                     std::array<Polynomial, 3> v)
    : sturm_(std::move(sturm)),
      low_(std::move(low)),
      high_(std::move(high)),
      negative_(negative),
      v_(std::move(v)) {
  while (value(high_) == 1) refine();  // u is infinite there, the root is not
}

void FacePoint::refine() {
  for (const unsigned k : {4U, 3U, 5U, 2U, 6U}) {
    const Place middle = modes::between(low_, high_, k);
    const int there = sturm_->sign(middle);
    if (there == 0) continue;
    (there == sturm_->sign(low_) ? low_ : high_) = middle;
    return;
  }
}

std::optional<int> FacePoint::sign(const Polynomial& polynomial) const {
  const auto list = integers(polynomial, negative_);
  if (list.empty()) return std::nullopt;
  const Sturm other(list);
  // A factor u that was dropped is positive; signs were turned for it before.
  FacePoint at = *this;
  for (int i = 0; i < 400; ++i) {
    const int low = other.sign(at.low_), high = other.sign(at.high_);
    if (low != 0 && low == high && other.distinct(at.low_, at.high_) == 0) return low;
    at.refine();
  }
  return std::nullopt;
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
    for (std::size_t k = v_[i].size(); k-- > 0;) v[i] = v[i] * u + Range{v_[i][k], v_[i][k]};
  }
  return v;
}

std::vector<Matrix<Rational>> matrices(modes::ExactTensors& exact, std::span<const u32> corners) {
  std::vector<Matrix<Rational>> list;
  for (const u32 v : corners) {
    const auto t = exact(v);
    const Integer unit = Integer(1) << static_cast<unsigned>(std::labs(t.exponent));
    const Rational scale = t.exponent < 0 ? Rational(Integer(1), unit) : Rational(unit);
    Triple<Rational> diagonal, off;
    for (unsigned i = 0; i < 3; ++i) {
      diagonal[i] = Rational(t.entries[i]) * scale;
      off[i] = Rational(t.entries[i + 3]) * scale;
    }
    list.push_back({{{diagonal[0], off[0], off[2]},
                     {off[0], diagonal[1], off[1]},
                     {off[2], off[1], diagonal[2]}}});
  }
  return list;
}

Rational determinant(const Matrix<Rational>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

namespace {

Rational inner(const Matrix<Rational>& a, const Matrix<Rational>& b) {
  Rational sum = 0;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j) sum += a[i][j] * b[i][j];
  return sum;
}

/// A basis of traceless symmetric matrices.
Matrix<Rational> basis(unsigned k) {
  Matrix<Rational> m{};
  if (k < 2) m[k][k] = 1, m[2][2] = -1;
  if (k == 2) m[0][1] = m[1][0] = 1;
  if (k == 3) m[1][2] = m[2][1] = 1;
  if (k == 4) m[0][2] = m[2][0] = 1;
  return m;
}

}  // namespace

std::vector<Matrix<Rational>> dual_basis(const std::vector<Matrix<Rational>>& tensors) {
  const std::size_t n = tensors.size();
  std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(2 * n, Rational(0)));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = inner(tensors[i], tensors[j]);
    rows[i][n + i] = 1;
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && rows[pivot][k] == 0) ++pivot;
    require(pivot < n, "dependent tensors, not listed as special");
    std::swap(rows[pivot], rows[k]);
    const Rational lead = rows[k][k];
    for (Rational& x : rows[k]) x /= lead;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Rational factor = rows[i][k];
      for (std::size_t j = 0; j < 2 * n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<Matrix<Rational>> dual(n);
  for (std::size_t i = 0; i < n; ++i)
    for (unsigned r = 0; r < 3; ++r)
      for (unsigned c = 0; c < 3; ++c)
        for (std::size_t j = 0; j < n; ++j) dual[i][r][c] += rows[i][n + j] * tensors[j][r][c];
  return dual;
}

std::vector<Matrix<Rational>> complement(const std::vector<Matrix<Rational>>& tensors) {
  std::vector<std::array<Rational, 5>> rows(tensors.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (unsigned k = 0; k < 5; ++k) rows[i][k] = inner(tensors[i], basis(k));
  std::array<std::size_t, 5> pivot_of{};
  pivot_of.fill(5);
  std::size_t rank = 0;
  for (unsigned k = 0; k < 5 && rank < rows.size(); ++k) {
    std::size_t at = rank;
    while (at < rows.size() && rows[at][k] == 0) ++at;
    if (at == rows.size()) continue;
    std::swap(rows[at], rows[rank]);
    const Rational lead = rows[rank][k];
    for (Rational& x : rows[rank]) x /= lead;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == rank) continue;
      const Rational factor = rows[i][k];
      for (unsigned j = 0; j < 5; ++j) rows[i][j] -= factor * rows[rank][j];
    }
    pivot_of[k] = rank++;
  }
  require(rank == tensors.size(), "dependent tensors, not listed as special");
  std::vector<Matrix<Rational>> list;
  for (unsigned free = 0; free < 5; ++free) {
    if (pivot_of[free] != 5) continue;
    Matrix<Rational> m = basis(free);
    for (unsigned k = 0; k < 5; ++k) {
      if (pivot_of[k] == 5) continue;
      const auto part = basis(k);
      for (unsigned r = 0; r < 3; ++r)
        for (unsigned c = 0; c < 3; ++c) m[r][c] -= rows[pivot_of[k]][free] * part[r][c];
    }
    list.push_back(m);
  }
  return list;
}

std::vector<FacePoint> find_points(modes::ExactTensors& exact, const std::array<u32, 3>& corners,
                                   const std::vector<Box>& boxes) {
  const auto tensors = matrices(exact, corners);
  const auto rest = complement(tensors);
  const auto dual = dual_basis(tensors);
  std::optional<std::vector<FacePoint>> all;
  for (const auto& coordinates : kCoordinates) {
    all = common_points(rest[0], rest[1], coordinates);
    if (all) break;
  }
  require(all.has_value(), "face ({}, {}, {}): no quartic with simple roots, not listed as special",
          corners[0], corners[1], corners[2]);
  std::vector<FacePoint> found;
  std::vector<std::uint8_t> used(boxes.size(), 0);
  for (FacePoint& point : *all) {
    std::array<Polynomial, 3> weights;
    for (unsigned i = 0; i < 3; ++i) weights[i] = form(dual[i], point.curve());
    std::array<int, 3> signs{};
    for (unsigned i = 0; i < 3; ++i) {
      const auto sign = point.sign(weights[i]);
      require(sign.has_value(), "face ({}, {}, {}): a point on an edge, not listed as special",
              corners[0], corners[1], corners[2]);
      signs[i] = *sign;
    }
    if (signs[0] != signs[1] || signs[1] != signs[2]) continue;
    point.type = signs[0];
    const Polynomial sum = weights[0] + weights[1] + weights[2];
    const auto inside = [&](const Box& box) {
      for (unsigned i = 0; i < 2; ++i) {
        const auto above = point.sign(weights[i] - scaled(Rational(box.low[i]), sum));
        const auto below = point.sign(scaled(Rational(box.high[i]), sum) - weights[i]);
        if (!above || !below || *above != point.type || *below != point.type) return false;
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
