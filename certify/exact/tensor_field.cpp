// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/exact/tensor_field.hpp"

#include <cmath>
#include <limits>

#include "certify/container/reject.hpp"
#include "kernel/arithmetic/wide_clones.hpp"

namespace crest::certify::modes {
namespace {

Field::Approximate with_largest(const Tensor<double>& entries, double error) {
  double most = 0;
  bool known = true;  // NaN is not the most
  for (const double x : entries) {
    known = known && std::isfinite(x);
    most = std::max(most, std::fabs(x));
  }
  if (!known || !(error < most)) error = std::numeric_limits<double>::infinity();
  return {entries, error, most};
}

/// An entry of the diagonal is (a + a) - (b + c): two roundings, each at most u times 2 |a| + |b| +
/// |c|; one beside it 3 a: one. What underflows loses 2^-1074.
Field::Approximate deviator(const std::array<double, 6>& t) {
  const Tensor<double> entries = {(t[0] + t[0]) - (t[1] + t[2]),
                                  (t[1] + t[1]) - (t[0] + t[2]),
                                  (t[2] + t[2]) - (t[0] + t[1]),
                                  3 * t[3],
                                  3 * t[4],
                                  3 * t[5]};
  double most = 0;
  for (const double x : t) most = std::max(most, std::fabs(x));
  return with_largest(entries, 9 * kUnit * most + 0x1p-1070);
}

/// mantissa times 2^exponent.
struct Dyadic {
  Integer mantissa;
  long exponent;
};
Dyadic dyadic(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return {Integer(static_cast<long long>(std::ldexp(fraction, 53))), exponent - 53L};
}

/// Integers times a common power of two.
ExactTensor common(const std::array<Dyadic, 6>& from) {
  ExactTensor t;
  bool any = false;
  for (const Dyadic& x : from) {
    if (x.mantissa == 0) continue;
    t.exponent = any ? std::min(t.exponent, x.exponent) : x.exponent;
    any = true;
  }
  for (std::size_t i = 0; i < 6; ++i)
    if (from[i].mantissa != 0)
      t.entries[i] = from[i].mantissa << static_cast<unsigned>(from[i].exponent - t.exponent);
  return t;
}

template <std::size_t n>
void align(std::array<ExactTensor, n>& tensors) {
  long least = 0;
  bool any = false;
  for (const auto& t : tensors)
    for (const auto& x : t.entries)
      if (x != 0) least = any ? std::min(least, t.exponent) : t.exponent, any = true;
  for (auto& t : tensors) {
    for (auto& x : t.entries)
      if (x != 0) x <<= static_cast<unsigned>(t.exponent - least);
    t.exponent = least;
  }
}

/// (A B + B A) / 2 as <., C> needs it: twice, to stay in integers. Entries xx yy zz xy yz xz.
template <class Number>
Tensor<Number> twice_symmetric_product(const Tensor<Number>& a, const Tensor<Number>& b) {
  const auto entry = [](const Tensor<Number>& t, std::size_t row, std::size_t column) {
    static constexpr std::array<std::array<std::size_t, 3>, 3> at = {
        {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}};
    return t[at[row][column]];
  };
  static constexpr std::array<std::array<std::size_t, 2>, 6> places = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
  Tensor<Number> product;
  for (std::size_t i = 0; i < 6; ++i) {
    Number sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += entry(a, places[i][0], k) * entry(b, k, places[i][1]);
      sum += entry(b, places[i][0], k) * entry(a, k, places[i][1]);
    }
    product[i] = sum;
  }
  return product;
}

template <class Number>
Number inner(const Tensor<Number>& a, const Tensor<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

template <class Number, std::size_t n>
void multiply_out(const std::array<Tensor<Number>, n>& t, Products<Number, n>& p) {
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i; j < n; ++j) {
      p.pair[i][j] = p.pair[j][i] = inner(t[i], t[j]);
      const auto square = twice_symmetric_product(t[i], t[j]);
      for (std::size_t k = j; k < n; ++k) {
        const Number x = inner(square, t[k]);
        p.triple[i][j][k] = p.triple[i][k][j] = p.triple[j][i][k] = x;
        p.triple[j][k][i] = p.triple[k][i][j] = p.triple[k][j][i] = x;
      }
    }
}

}  // namespace

Field::Field(std::span<const std::array<double, 6>> tensors)
    : tensors_(tensors), fixed_(tensors.size()) {
  approximate_.reserve(fixed_);
  zero_.reserve(fixed_);
  for (const auto& t : tensors) {
    approximate_.push_back(deviator(t));
    zero_.push_back(t[0] == t[1] && t[1] == t[2] && t[3] == 0 && t[4] == 0 && t[5] == 0);
  }
}

u32 Field::add_zero() {
  approximate_.push_back({{}, 0, 0});
  zero_.push_back(1);
  return static_cast<u32>(fixed_++);
}

u32 Field::split(u32 first, u32 second, unsigned n) {
  const auto age = [&](u32 v) {
    return v < fixed_ ? 0U : unsigned{splits_[v - fixed_].generation};
  };
  const unsigned generation = std::max(age(first), age(second)) + 1;
  require(generation <= kMostGenerations, "trees: more than {} splits one of another",
          kMostGenerations);
  require(vertices() < kNone - 1, "trees: more vertices than there are numbers");
  const Approximate &a = approximate_[first], &b = approximate_[second];
  const double f = (64 - n) / 64.0, g = n / 64.0;
  Tensor<double> entries;
  for (std::size_t i = 0; i < 6; ++i) entries[i] = f * a.entries[i] + g * b.entries[i];
  // Three roundings of numbers below the larger one.
  const double most = std::max(a.largest, b.largest);
  approximate_.push_back(with_largest(
      entries, std::max(a.error, b.error) * (1 + 0x1p-50) + 4 * kUnit * most + 0x1p-1070));
  splits_.push_back(
      {first, second, static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(generation)});
  return static_cast<u32>(vertices() - 1);
}

void Field::drop_splits() {
  splits_.clear();
  approximate_.resize(fixed_);
}

ExactTensor ExactTensors::operator()(u32 v) {
  if (v < field_.tensors_.size()) {
    const auto& t = field_.tensors_[v];
    std::array<Dyadic, 6> entries;
    for (std::size_t i = 0; i < 6; ++i) entries[i] = dyadic(t[i]);
    ExactTensor exact = common(entries);
    const Integer trace = exact.entries[0] + exact.entries[1] + exact.entries[2];
    for (std::size_t i = 0; i < 6; ++i) exact.entries[i] *= 3;
    for (std::size_t i = 0; i < 3; ++i) exact.entries[i] -= trace;
    return exact;
  }
  if (v < field_.fixed_) return {};
  if (const auto at = known_.find(v); at != known_.end()) return at->second;
  const SplitVertex& split = field_.splits_[v - field_.fixed_];
  std::array<ExactTensor, 2> ends = {(*this)(split.first), (*this)(split.second)};
  align(ends);
  ExactTensor exact;
  for (std::size_t i = 0; i < 6; ++i)
    exact.entries[i] = (64 - split.n) * ends[0].entries[i] + split.n * ends[1].entries[i];
  exact.exponent = ends[0].exponent - 6;
  // No more is kept than this: a file may have as many splits as bytes.
  constexpr std::size_t kMost = 1U << 16U;
  if (known_.size() >= kMost) known_.clear();
  known_.emplace(v, exact);
  return exact;
}

namespace {

/// A simplex' tensors divided by 2^exponent.
template <std::size_t n>
struct Divided {
  std::array<Tensor<double>, n> t;
  int exponent = 0;
  double pair_error, triple_error;
};

/// Errors, with entries at most 1 + e, each wrong by e <= 2^-20: a product <A, B> has nine terms
/// (three counted twice), so at most 9 (2 e + e^2) + 12 u 9 <= 19 e + 120 u; twice the symmetric
/// product six terms an entry, 6 (2 e + e^2) + 8 u 6 <= 12.1 e + 50 u, at most 6.1; its product
/// with a third tensor 9 ((12.1 e + 50 u) 1.1 + 6.1 e) + 12 u 60 <= 180 e + 1300 u.
template <std::size_t n>
Divided<n> divided(const Field& field, const std::array<u32, n>& corners) {
  Divided<n> d;
  double most = 0, error = 0;
  for (const u32 v : corners) {
    most = std::max(most, field.approximate(v).largest);
    error = std::max(error, field.approximate(v).error);
  }
  const bool finite = most > 0 && most < std::numeric_limits<double>::infinity();
  if (finite) std::frexp(most, &d.exponent);
  // 2^-exponent may be no double: in two steps, as exact as in one.
  const double half = std::ldexp(1, -(d.exponent / 2)),
               rest = std::ldexp(1, -(d.exponent - d.exponent / 2));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 6; ++k)
      d.t[i][k] = field.approximate(corners[i]).entries[k] * half * rest;
  const double e = error * half * rest + 0x1p-1000;
  const bool known = finite && e < 0x1p-20;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  d.pair_error = known ? 20 * e + 128 * kUnit : kInfinite;
  d.triple_error = known ? 190 * e + 1400 * kUnit : kInfinite;
  return d;
}

template <std::size_t n>
Products<Lanes, n> products_of_eight(const Field& field,
                                     std::span<const std::array<u32, n>> simplices) {
  std::array<Tensor<Lanes>, n> t;
  Products<Lanes, n> p;
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    const Divided<n> d = divided<n>(field, simplices[std::min(lane, simplices.size() - 1)]);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < 6; ++k) t[i][k].x[lane] = d.t[i][k];
    p.pair_error.x[lane] = d.pair_error;
    p.triple_error.x[lane] = d.triple_error;
    p.exponent[lane] = d.exponent;
  }
  multiply_out<Lanes, n>(t, p);
  return p;
}

}  // namespace

template <std::size_t n>
Products<double, n> approximate_products(const Field& field, const std::array<u32, n>& corners) {
  const Divided<n> d = divided<n>(field, corners);
  Products<double, n> p;
  multiply_out<double, n>(d.t, p);
  p.pair_error = d.pair_error;
  p.triple_error = d.triple_error;
  p.exponent = d.exponent;
  return p;
}

CREST_WIDE_CLONES Products<Lanes, 3> approximate_products(
    const Field& field, std::span<const std::array<u32, 3>> simplices) {
  return products_of_eight<3>(field, simplices);
}
CREST_WIDE_CLONES Products<Lanes, 4> approximate_products(
    const Field& field, std::span<const std::array<u32, 4>> simplices) {
  return products_of_eight<4>(field, simplices);
}

template <std::size_t n>
Products<Integer, n> exact_products(ExactTensors& exact, const std::array<u32, n>& corners) {
  std::array<ExactTensor, n> tensors;
  for (std::size_t i = 0; i < n; ++i) tensors[i] = exact(corners[i]);
  align(tensors);
  std::array<Tensor<Integer>, n> t;
  for (std::size_t i = 0; i < n; ++i) t[i] = tensors[i].entries;
  Products<Integer, n> p;
  multiply_out<Integer, n>(t, p);
  p.exponent = tensors[0].exponent;
  return p;
}

template Products<double, 1> approximate_products(const Field&, const std::array<u32, 1>&);
template Products<double, 2> approximate_products(const Field&, const std::array<u32, 2>&);
template Products<double, 3> approximate_products(const Field&, const std::array<u32, 3>&);
template Products<double, 4> approximate_products(const Field&, const std::array<u32, 4>&);
template Products<Integer, 1> exact_products(ExactTensors&, const std::array<u32, 1>&);
template Products<Integer, 2> exact_products(ExactTensors&, const std::array<u32, 2>&);
template Products<Integer, 3> exact_products(ExactTensors&, const std::array<u32, 3>&);
template Products<Integer, 4> exact_products(ExactTensors&, const std::array<u32, 4>&);

}  // namespace crest::certify::modes
