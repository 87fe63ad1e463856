// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/arithmetic/taylor_model.hpp"

namespace crest::kernel {

template <int Order>
TaylorModel<Order> TaylorModel<Order>::linear(double at0, double at1, double at2, double error) {
  // l0 = (1 - u - v) 2/3 - ..: at the corners u = (-1/2, 1, -1/2), v = (-1/2, -1/2, 1).
  TaylorModel m;
  m.c[0] = (at0 + at1 + at2) / 3;
  m.c[1] = (at2 - at0) * (2.0 / 3);
  m.c[2] = (at1 - at0) * (2.0 / 3);
  const double size = std::fabs(at0) + std::fabs(at1) + std::fabs(at2);
  m.radius = grow(error + 16 * kUnit * size);
  return m;
}

template <int Order>
std::array<double, Order + 1> TaylorModel<Order>::by_degree() const {
  std::array<double, Order + 1> sums{};
  for (std::size_t m = 0; m < kCount; ++m)
    sums[static_cast<std::size_t>(kWeights.degree[m])] += kWeights.of[m] * std::fabs(c[m]);
  return sums;
}

template <int Order>
double TaylorModel<Order>::magnitude() const {
  double sum = 0;
  for (const double x : by_degree()) sum += x;
  return grow(sum + radius);
}

template <int Order>
TaylorModel<Order> TaylorModel<Order>::sum(const TaylorModel& b, double sign) const {
  TaylorModel r;
  double size = 0;
  for (std::size_t m = 0; m < kCount; ++m) {
    r.c[m] = c[m] + sign * b.c[m];
    size += std::fabs(r.c[m]);
  }
  // A rounded sum errs by at most u times itself.
  r.radius = grow(radius + b.radius + kUnit * size);
  return r;
}

template <int Order>
TaylorModel<Order> TaylorModel<Order>::scaled(double s) const {
  TaylorModel r;
  double size = 0;
  for (std::size_t m = 0; m < kCount; ++m) {
    r.c[m] = s * c[m];
    size += std::fabs(r.c[m]);
  }
  r.radius = grow(std::fabs(s) * radius + kUnit * size);
  return r;
}

template <int Order>
TaylorModel<Order> TaylorModel<Order>::divided(double s) const {
  TaylorModel r;
  double size = 0;
  for (std::size_t m = 0; m < kCount; ++m) {
    r.c[m] = c[m] / s;
    size += std::fabs(r.c[m]);
  }
  r.radius = grow(radius / std::fabs(s) + kUnit * size);
  return r;
}

template <int Order>
bool TaylorModel<Order>::is_flat() const {
  bool flat = true;
  for (std::size_t m = 1; m < kCount; ++m) flat = flat && c[m] == 0;
  return flat;
}

template <int Order>
TaylorModel<Order> TaylorModel<Order>::product(const TaylorModel& b) const {
  TaylorModel r;
  for (const auto& [i, j, k] : kTable.products) r.c[k] += c[i] * b.c[j];
  const auto da = by_degree(), db = b.by_degree();
  double sum_a = 0, sum_b = 0, beyond = 0, tail = 0;
  for (std::size_t d = 0; d <= Order; ++d) {
    sum_a += da[d];
    sum_b += db[d];
    // tail = sum of db over degrees above Order - d.
    beyond += da[d] * tail;
    tail += db[Order - d];
  }
  // (b) with |c| in place of w |c|: w >= 2^-(Order / 2), and Order is at most 5.
  const double rounding = 1.02 * 4 * 4 * (kCount + 1) * kUnit * sum_a * sum_b;
  r.radius = grow(beyond + rounding + sum_a * b.radius + sum_b * radius + radius * b.radius);
  return r;
}

/// f(c0 + h) = t0 + h (t1 + h (...)) with h this model without its constant.
template <int Order>
TaylorModel<Order> TaylorModel<Order>::compose(taylor::Series (*make_series)(double, double,
                                                                             int)) const {
  TaylorModel h = *this;
  h.c[0] = 0;
  const double rho = h.magnitude();
  const taylor::Series s = make_series(c[0], rho, Order);
  TaylorModel r = around(s.t[Order], s.error[Order]);
  for (std::size_t k = Order; k-- > 0;) r = r * h + around(s.t[k], s.error[k]);
  double power = 1;
  for (int k = 0; k <= Order; ++k) power *= rho;
  r.radius = grow(r.radius + s.rest * power);
  return r;
}

template <int Order>
Range TaylorModel<Order>::range_of_rows(std::uint64_t rows) const {
  const auto& table = taylor::kBernstein<Order>.of;
  double low = HUGE_VAL, high = -HUGE_VAL, size = 0;
  for (const double x : c) size += std::fabs(x);
  for (std::size_t row = 0; row < kCount; ++row) {
    if ((rows >> row & 1) == 0) continue;
    double b = 0;
    for (std::size_t m = 0; m < kCount; ++m) b += table[row][m] * c[m];
    low = std::fmin(low, b);
    high = std::fmax(high, b);
  }
  const double slack = grow(radius + (kCount + 6) * kUnit * size);
  // NaN spreads: fmin drops it, so the size is asked.
  if (!(size + slack < HUGE_VAL)) return {-HUGE_VAL, HUGE_VAL};
  return {low - slack - std::fabs(low) * 0x1p-52, high + slack + std::fabs(high) * 0x1p-52};
}

namespace {

/// The Bernstein coefficients l0^a0 l1^a1 l2^a2 without the corners of the bits `without`: of the
/// triangle, an edge (they are those of the function on it) or a corner (its value there).
template <int Order>
constexpr std::uint64_t rows_without(unsigned without) {
  constexpr Monomials<2, Order> kTable;  // its exponents are a1 and a2
  std::uint64_t rows = 0;
  for (std::size_t row = 0; row < kTable.kCount; ++row) {
    const int a1 = kTable.exponents[row][0], a2 = kTable.exponents[row][1];
    const bool has[3] = {a1 + a2<Order, a1> 0, a2 > 0};
    bool keep = true;
    for (unsigned i = 0; i < 3; ++i) keep = keep && !(has[i] && (without >> i & 1) != 0);
    if (keep) rows |= std::uint64_t{1} << row;
  }
  return rows;
}

}  // namespace

template <int Order>
Range TaylorModel<Order>::range() const {
  return range_of_rows(rows_without<Order>(0));
}

template <int Order>
Range TaylorModel<Order>::range_on_edge(int i) const {
  constexpr std::uint64_t kRows[3] = {rows_without<Order>(4), rows_without<Order>(1),
                                      rows_without<Order>(2)};
  return range_of_rows(kRows[i]);
}

template <int Order>
Range TaylorModel<Order>::at_corner(int i) const {
  constexpr std::uint64_t kRows[3] = {rows_without<Order>(6), rows_without<Order>(5),
                                      rows_without<Order>(3)};
  return range_of_rows(kRows[i]);
}

template class TaylorModel<3>;
template class TaylorModel<4>;
template class TaylorModel<5>;

}  // namespace crest::kernel
