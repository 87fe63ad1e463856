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
  m.radius = grow(error + 16 * Kernels::kUnit * size);
  return m;
}

template <int Order>
TaylorModel<Order> TaylorModel<Order>::times_flat(const TaylorModel& flat) const {
  const double factor = flat.c[0];
  if (seems_flat() && is_flat()) {
    const double product = c[0] * factor;
    return around(product, grow(Kernels::kUnit * std::fabs(product) + std::fabs(factor) * radius +
                                flat.radius * (std::fabs(c[0]) + radius)));
  }
  TaylorModel r;
  for (std::size_t m = 0; m < kCount; ++m) r.c[m] = c[m] * factor;
  r.round(std::fabs(factor) * radius + flat.radius * (Kernels::size(c) + radius));
  return r;
}

/// f(c + h) = t0 + h (t1 + h (...)), h this model without the constant c.
template <int Order>
TaylorModel<Order> TaylorModel<Order>::compose(taylor::Series (*make_series)(double, double,
                                                                             int)) const {
  if (is_flat()) {
    // A constant within the radius: no products of models.
    const taylor::Series s = make_series(c[0], radius, Order);
    double bound = s.rest * radius;
    for (std::size_t k = Order; k > 0; --k)
      bound = (bound + std::fabs(s.t[k]) + s.error[k]) * radius;
    return around(s.t[0], grow(s.error[0] + bound));
  }
  // Expanded at the middle of the range, so that |h| <= rho is as small as can be.
  const Range all = range();
  const double centre = 0.5 * (all.low + all.high);
  TaylorModel h = *this;
  h.c[0] = c[0] - centre;
  h.radius = grow(radius + Kernels::kUnit * std::fabs(h.c[0]));
  const Range off = h.range();
  const double rho = std::fmax(-off.low, off.high);
  const taylor::Series s = make_series(centre, rho, Order);
  double power = 1;
  for (int k = 0; k <= Order; ++k) power *= rho;
  TaylorModel r = around(s.t[Order], s.error[Order]);
  for (std::size_t k = Order; k-- > 0;) r = r * h + around(s.t[k], s.error[k]);
  r.radius = grow(r.radius + s.rest * (power + 0x1p-1000));  // power may underflow
  return r;
}

namespace {

using taylor::Pair;

/// The Bernstein coefficients without those that hold a corner of the bits `without`: of the
/// triangle, of an edge (they are those of the function on it) or of a corner (its value).
template <int Order, unsigned Without>
constexpr int count_rows() {
  int count = 0;
  for (const auto& [a1, a2] : Monomials<2, Order>{}.exponents)
    count += ((Without & 1) == 0 || a1 + a2 == Order) && ((Without & 2) == 0 || a1 == 0) &&
                     ((Without & 4) == 0 || a2 == 0)
                 ? 1
                 : 0;
  return count;
}

/// The rows by pairs, the last one repeated if they are odd in number: [monomial][pair].
template <int Order, unsigned Without>
constexpr auto pair_rows() {
  constexpr std::size_t kPairs = (count_rows<Order, Without>() + 1) / 2;
  const Monomials<2, Order> table;
  const taylor::BernsteinTable<Order> bernstein;
  std::array<std::array<std::array<double, 2>, kPairs>, table.kCount> pairs{};
  std::size_t next = 0;
  for (std::size_t row = 0; row < table.kCount; ++row) {
    const int a1 = table.exponents[row][0], a2 = table.exponents[row][1];
    if (((Without & 1) != 0 && a1 + a2 < Order) || ((Without & 2) != 0 && a1 > 0) ||
        ((Without & 4) != 0 && a2 > 0))
      continue;
    for (std::size_t m = 0; m < table.kCount; ++m) {
      pairs[m][next / 2][next % 2] = bernstein.of[row][m];
      if (next % 2 == 0) pairs[m][next / 2][1] = bernstein.of[row][m];
    }
    ++next;
  }
  return pairs;
}

// Entries err by one unit, a row's sum has at most N terms: N + 2 units of sum |c| bound its error.
template <int Order, unsigned Without>
Range range_of_rows(const TaylorModel<Order>& f) {
  static constexpr auto kRows = pair_rows<Order, Without>();
  constexpr std::size_t kPairs = kRows[0].size();
  Pair values[kPairs];
  for (Pair& x : values) x = Pair{f.c[0], f.c[0]};
  for (std::size_t m = 1; m < f.c.size(); ++m)
    for (std::size_t p = 0; p < kPairs; ++p)
      values[p] += Pair{f.c[m], f.c[m]} * Pair{kRows[m][p][0], kRows[m][p][1]};
  Pair low = values[0], high = values[0];
  for (std::size_t p = 1; p < kPairs; ++p) {
    low = values[p] < low ? values[p] : low;
    high = values[p] > high ? values[p] : high;
  }
  const double least = low[0] < low[1] ? low[0] : low[1];
  const double most = high[0] > high[1] ? high[0] : high[1];
  const double size = TaylorModel<Order>::Kernels::size(f.c);
  const double slack = grow(f.radius + (f.kCount + 6) * TaylorModel<Order>::Kernels::kUnit * size);
  // A comparison with NaN drops it; the size keeps it.
  if (!(size + slack < HUGE_VAL)) return {-HUGE_VAL, HUGE_VAL};
  return {least - slack - std::fabs(least) * 0x1p-52, most + slack + std::fabs(most) * 0x1p-52};
}

}  // namespace

template <int Order>
Range TaylorModel<Order>::range() const {
  return range_of_rows<Order, 0>(*this);
}

template <int Order>
Range TaylorModel<Order>::range_on_edge(int i) const {
  if (i == 0) return range_of_rows<Order, 4>(*this);
  return i == 1 ? range_of_rows<Order, 1>(*this) : range_of_rows<Order, 2>(*this);
}

template <int Order>
Range TaylorModel<Order>::at_corner(int i) const {
  if (i == 0) return range_of_rows<Order, 6>(*this);
  return i == 1 ? range_of_rows<Order, 5>(*this) : range_of_rows<Order, 3>(*this);
}

template class TaylorModel<3>;
template class TaylorModel<4>;
template class TaylorModel<5>;

}  // namespace crest::kernel
