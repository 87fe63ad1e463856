// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/model.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace crest::recheck {
namespace {

__extension__ using Integer = __int128;
__extension__ using Unsigned = unsigned __int128;

constexpr int kDegree = 5, kBits = 57;
constexpr slong kShift = 64;           // by which a model moves to the left in a sum
constexpr slong kGreatest = 1L << 40;  // of an exponent
constexpr std::size_t kTermsOfProduct = 11 * 12 / 2;

constexpr std::size_t at(int i, int j) {
  return static_cast<std::size_t>((i + j) * (i + j + 1) / 2 + j);
}
constexpr std::size_t terms(int degree) {
  return at(degree + 1, 0);
}

/// min(i, j) of every term: |u^i v^j| <= 2^-min(i, j).
constexpr std::array<int, kTermsOfProduct> kHalvings = [] {
  std::array<int, kTermsOfProduct> all{};
  for (int d = 0; d <= 2 * kDegree; ++d)
    for (int j = 0; j <= d; ++j) all[at(d - j, j)] = std::min(d - j, j);
  return all;
}();

constexpr std::array<double, kTermsOfProduct> kHalved = [] {
  std::array<double, kTermsOfProduct> all{};
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = 1.0 / (1 << kHalvings[k]);
  return all;
}();

/// Bernstein coefficients of u^i v^j, times 60 * 2^degree: integers.
struct Bernstein {
  using Polynomial = std::array<std::array<int, kDegree + 1>, kDegree + 1>;  // by l1^a l2^b

  explicit Bernstein(int degree) : common(60 << degree) {
    const auto times = [](Polynomial& p, const std::array<int, 3>& linear) {
      for (std::size_t a = kDegree + 1; a-- > 0;)
        for (std::size_t b = kDegree + 1 - a; b-- > 0;)
          p[a][b] = linear[0] * p[a][b] + (a > 0 ? linear[1] * p[a - 1][b] : 0) +
                    (b > 0 ? linear[2] * p[a][b - 1] : 0);
    };
    Polynomial multinomial{{{1}}};
    for (int k = 0; k < degree; ++k) times(multinomial, {1, 1, 1});
    for (int d = 0; d <= degree; ++d)
      for (int j = 0; j <= d; ++j) {
        Polynomial p{{{1}}};
        for (int k = 0; k < degree; ++k)
          times(p, k < d - j ? std::array{-1, 2, -1}
                   : k < d   ? std::array{-1, -1, 2}
                             : std::array{1, 1, 1});
        std::size_t row = 0;
        for (int a = 0; a <= degree; ++a)
          for (int b = 0; a + b <= degree; ++b) {
            const auto x = static_cast<std::size_t>(a), y = static_cast<std::size_t>(b);
            entry[row++][at(d - j, j)] = p[x][y] * (60 / multinomial[x][y]) << (degree - d);
          }
      }
  }
  int common;
  std::array<std::array<int, 21>, 21> entry{};  // [Bernstein coefficient][term]
};

/// Divides by 2^by and rounds; the radius takes the errors.
template <class Number, std::size_t N>
void shift_right(std::array<Number, N>& c, std::size_t n, Number& radius, slong by) {
  by = std::min(by, static_cast<slong>(8 * sizeof(Number)) - 2);  // all bits but the sign
  const Number rest = (Number{1} << by) - 1, half = Number{1} << (by - 1);
  Number rounded = 0;
  for (std::size_t k = 0; k < n; ++k) {
    rounded += (c[k] & rest) != 0 ? 1 : 0;
    c[k] = (c[k] + half) >> by;
  }
  radius = ((radius + rest) >> by) + (rounded + 1) / 2;
}

/// A bound n / d * 2^e as a double.
double below(Integer n, int d, slong e) {
  const auto quotient = static_cast<std::int64_t>(n / d - (n % d < 0 ? 1 : 0));
  const int within = static_cast<int>(std::clamp(e, slong{-9999}, slong{9999}));
  return std::nextafter(std::ldexp(static_cast<double>(quotient), within), -INFINITY);
}

}  // namespace

/// A model before it is rounded: |c| < 2^122.
struct Model::Wide {
  int degree = 0;
  slong exponent = 0;
  Integer radius = 0;
  std::array<Integer, kTerms> c;  ///< set as far as the degree says

  explicit Wide(int n) : degree(n) { std::fill_n(c.begin(), terms(n), 0); }
  void shift(slong by) {
    if (by <= 0) return;
    exponent += by;
    shift_right(c, terms(degree), radius, by);
  }
  /// Requires: what is there is a product of models, not zero.
  void add(Model m) {
    if (m.is_zero()) return;
    shift(m.exponent_ - exponent - kShift);
    slong left = m.exponent_ - exponent;
    if (left < 0) shift_right(m.c_, terms(m.degree_), m.radius_, -left);
    left = std::max(left, slong{0});
    for (; degree < m.degree_; ++degree)
      std::fill(c.begin() + terms(degree), c.begin() + terms(degree + 1), 0);
    for (std::size_t k = 0; k < terms(m.degree_); ++k) c[k] += Integer{m.c_[k]} << left;
    radius += Integer{m.radius_} << left;
  }
  Model rounded() {
    auto all = static_cast<Unsigned>(radius);
    for (std::size_t k = 0; k < terms(degree); ++k)
      all |= static_cast<Unsigned>(c[k] < 0 ? -c[k] : c[k]);
    const auto high = static_cast<std::uint64_t>(all >> 64), low = static_cast<std::uint64_t>(all);
    shift((high != 0 ? 64 + std::bit_width(high) : std::bit_width(low)) - kBits);
    if (std::abs(exponent) > kGreatest) throw Undefined{};
    Model m;
    m.degree_ = degree;
    m.exponent_ = exponent;
    m.radius_ = static_cast<std::int64_t>(radius);
    for (std::size_t k = 0; k < terms(degree); ++k) m.c_[k] = static_cast<std::int64_t>(c[k]);
    return m;
  }
  /// At most this: |c|, radius included.
  static Integer norm(const Model& m) {
    Integer sum = 0;
    for (std::size_t k = 0; k < terms(m.degree_); ++k)
      sum += (std::abs(m.c_[k]) >> kHalvings[k]) + 1;
    return sum;
  }
  /// The greatest power of v that occurs is at most this: 0 on segments.
  static int powers_of_v(const Model& m) {
    for (int d = m.degree_; d > 0; --d)
      for (int j = 1; j <= d; ++j)
        if (m.c_[at(d - j, j)] != 0) return m.degree_;
    return 0;
  }
  /// Adds a b: up to this degree the terms, of the others a bound to the radius; in doubles, whose
  /// error is below 2^-40.
  void add_terms(const Model& a, const Model& b) {
    const int wa = powers_of_v(a), wb = powers_of_v(b);
    std::array<double, kTerms> sizes;
    for (std::size_t k = 0; k < terms(b.degree_); ++k)
      sizes[k] = static_cast<double>(std::abs(b.c_[k]));
    std::array<double, kTermsOfProduct> beyond{};
    for (int d = 0; d <= a.degree_; ++d)
      for (int j = 0; j <= std::min(d, wa); ++j) {
        const std::int64_t x = a.c_[at(d - j, j)];
        if (x == 0) continue;
        const auto size = static_cast<double>(std::abs(x));
        for (int e = 0; e <= b.degree_; ++e) {
          const std::size_t from = at(e, 0), to = at(d - j + e, j), n = std::min(e, wb) + 1U;
          if (d + e <= degree)
            for (std::size_t l = 0; l < n; ++l) c[to + l] += Integer{x} * b.c_[from + l];
          else
            for (std::size_t l = 0; l < n; ++l) beyond[to + l] += size * sizes[from + l];
        }
      }
    double sum = 0;
    for (std::size_t k = terms(degree); k < terms(a.degree_ + b.degree_); ++k)
      sum += beyond[k] * kHalved[k];
    if (sum != 0) radius += static_cast<Integer>(sum * (1 + 0x1p-40)) + 1;
  }
};

Model::Model(const Ball& b) {
  b.finite();
  if (b.is_zero()) return;
  arf_t middle, radius;
  arf_init(middle);
  arf_init(radius);
  arf_set(middle, arb_midref(b.get()));
  arf_set_mag(radius, arb_radref(b.get()));
  exponent_ = std::max(arf_abs_bound_lt_2exp_si(middle), arf_abs_bound_lt_2exp_si(radius)) - kBits;
  if (std::abs(exponent_) > kGreatest) throw Undefined{};
  arf_mul_2exp_si(middle, middle, -exponent_);
  arf_mul_2exp_si(radius, radius, -exponent_);
  c_[0] = arf_get_si(middle, ARF_RND_NEAR);
  radius_ = arf_get_si(radius, ARF_RND_CEIL) + (arf_is_int(middle) ? 0 : 1);
  arf_clear(middle);
  arf_clear(radius);
}

Model Model::linear(const Ball& value, const Ball& to1, const Ball& to2) {
  Model m(value + scaled(to1 + to2, 1, 3)), u(scaled(to1, 2, 3)), v(scaled(to2, 2, 3));
  m.degree_ = u.degree_ = v.degree_ = 1;
  std::swap(u.c_[0], u.c_[1]);
  std::swap(v.c_[0], v.c_[2]);
  return m + u + v;
}

Interval Model::range() const {
  static const std::array<Bernstein, kDegree + 1> all = {Bernstein(0), Bernstein(1), Bernstein(2),
                                                         Bernstein(3), Bernstein(4), Bernstein(5)};
  const Bernstein& basis = all[static_cast<std::size_t>(degree_)];
  const std::size_t n = terms(degree_);
  Integer least = 0, greatest = 0;
  for (std::size_t row = 0; row < n; ++row) {
    Integer sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += Integer{c_[k]} * basis.entry[row][k];
    least = row == 0 ? sum : std::min(least, sum);
    greatest = row == 0 ? sum : std::max(greatest, sum);
  }
  const Integer radius = Integer{basis.common} * radius_;
  if (is_zero()) return {};
  return {below(least - radius, basis.common, exponent_),
          -below(-greatest - radius, basis.common, exponent_)};
}

Model Model::middle() const {
  Model m = *this;
  m.radius_ = 0;
  return m;
}

void Model::add_product(const Model& a, const Model& b) {
  if (a.is_zero() || b.is_zero()) return;
  Wide w(std::min(context.order, a.degree_ + b.degree_));
  w.exponent = a.exponent_ + b.exponent_;
  w.add_terms(a, b);
  if (a.radius_ != 0) w.radius += (Wide::norm(b) + b.radius_) * a.radius_;
  if (b.radius_ != 0) w.radius += Wide::norm(a) * b.radius_;
  w.add(*this);
  *this = w.rounded();
}

Model& Model::operator+=(const Model& b) {
  if (b.is_zero()) return *this;
  if (is_zero() || exponent_ < b.exponent_) {
    const Model low = *this;
    *this = b;
    return low.is_zero() ? *this : *this += low;
  }
  Model low = b;
  const slong shift = exponent_ - b.exponent_;
  if (shift > 0) shift_right(low.c_, terms(low.degree_), low.radius_, shift);
  degree_ = std::max(degree_, b.degree_);
  radius_ += low.radius_;
  std::int64_t all = radius_;
  for (std::size_t k = 0; k < terms(degree_); ++k) {
    c_[k] += low.c_[k];
    all |= std::abs(c_[k]);
  }
  if (all >> kBits == 0) return *this;
  shift_right(c_, terms(degree_), radius_, 1);
  ++exponent_;
  return *this;
}
Model Model::operator-() const {
  Model m = *this;
  for (std::int64_t& c : m.c_) c = -c;
  return m;
}
/// Requires: |n| <= 2^20 if d is not a power of two, |n| <= 2^60 else.
Model scaled(const Model& x, slong n, slong d) {
  if (x.is_zero()) return x;
  Model::Wide w(x.degree_);
  w.exponent = x.exponent_;
  for (; d % 2 == 0; d /= 2) --w.exponent;
  for (std::size_t k = 0; k < terms(w.degree); ++k) w.c[k] = Integer{x.c_[k]} * n;
  w.radius = Integer{x.radius_} * std::abs(n);
  if (d == 1) return w.rounded();
  constexpr slong kLeft = 40;
  for (std::size_t k = 0; k < terms(w.degree); ++k) w.c[k] = (w.c[k] << kLeft) / d;
  w.radius = (w.radius << kLeft) / d + 1 + static_cast<Integer>(terms(w.degree));
  w.exponent -= kLeft;
  return w.rounded();
}

/// f(g): the Taylor polynomial of f at the middle c of g's range, in g - c, with Lagrange's
/// remainder.
Model applied(const Function& f, const Model& g) {
  if (f.kind == Function::Kind::power) return power(g, f.exponent);
  const Interval values = g.range();
  if (g.degree_ == 0) return Model(value_of(f, values.ball()));
  const Ball c(values.middle()), range = hull(values, values.middle()).ball();
  const int n = context.order;
  const Ball last = series(f, range, n + 1).back();
  const std::vector<Ball> t = series(f, c, n);
  const Model delta = g - Model(c);
  Model r(t.back());
  for (int k = n - 1; k >= 0; --k) r = r * delta + Model(t[static_cast<std::size_t>(k)]);
  const Ball error = last * power(range - c, static_cast<unsigned>(n + 1));
  return r + Model(Ball::radius(error));
}

Model inverse(const Model& x) {
  return applied({Function::Kind::inverse}, x);
}
Model sqrt(const Model& x) {
  return applied({Function::Kind::sqrt}, x);
}
Model log(const Model& x) {
  return applied({Function::Kind::log}, x);
}
Model exp(const Model& x) {
  return applied({Function::Kind::exp}, x);
}
Model sin(const Model& x) {
  return applied({Function::Kind::sin}, x);
}
Model cos(const Model& x) {
  return applied({Function::Kind::cos}, x);
}
Model power(const Model& x, unsigned n) {
  if (n == 0) return Model(1.0);
  if (n == 1) return x;
  const Model half = power(x, n / 2);
  const Model square = half * half;
  return n % 2 == 0 ? square : square * x;
}

}  // namespace crest::recheck
