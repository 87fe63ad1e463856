// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Taylor models on the triangle of taylor_model.hpp over MPFR intervals: slower, with the same
// interface, and with nothing to prove about rounding.
//
// A model encloses f if there are numbers c*_ij in the coefficients' intervals such that
// f(u, v) - sum c*_ij u^i v^j is in `remainder` everywhere on the triangle.
// Theorem. Every operation encloses the exact result for all functions its operands enclose:
// interval arithmetic for the coefficients; terms of a product beyond the order are bounded by
// |u^i v^j| <= 2^-min(i, j) (taylor_model.hpp, (a)), products with remainders by Bernstein ranges;
// f(c + h) is Taylor's formula at c with the next derivative over the hull of c and c + h.
//
// Undefined (mp_interval.hpp): a model with a coefficient or a remainder that is. Law: a result of
// an undefined operand is undefined, also where a coefficient is zero and its products are skipped;
// so is a function that is not analytic at all points that its operand encloses.
#include <array>
#include <cstdint>

#include "kernel/arithmetic/monomials.hpp"
#include "kernel/arithmetic/mp_interval.hpp"
#include "kernel/arithmetic/taylor_model.hpp"

namespace crest::kernel {

/// Order: 3 to 5. Coefficients in the order of Monomials<2, Order>.
template <int Order>
class MpTaylorModel {
 public:
  static constexpr mpfr_prec_t kBits = 106;
  static constexpr int kCount = monomial_count(2, Order);
  static constexpr Monomials<2, Order> kTable{};

  std::array<MpInterval, kCount> c;
  MpInterval remainder;

  MpTaylorModel() : remainder(kBits) { c.fill(remainder); }
  // Defined once: inline, the loops over the coefficients are most of what jets of models compile.
  MpTaylorModel(const MpTaylorModel& other);
  MpTaylorModel(MpTaylorModel&& other) noexcept;
  MpTaylorModel& operator=(const MpTaylorModel& other);
  MpTaylorModel& operator=(MpTaylorModel&& other) noexcept;
  ~MpTaylorModel();
  MpTaylorModel(double constant)
      : MpTaylorModel(MpInterval(constant, kBits)) {}  // NOLINT: as there
  explicit MpTaylorModel(const MpInterval& constant);
  /// The constants within `error` of `constant`.
  static MpTaylorModel around(double constant, double error);
  /// The function linear on the triangle with these corner values, each within `error`.
  static MpTaylorModel linear(double at0, double at1, double at2, double error = 0);

  /// Encloses the function's values on the triangle (Bernstein coefficients).
  Range range() const;
  /// On the edge from corner i to corner (i + 1) % 3.
  Range range_on_edge(int i) const;
  Range at_corner(int i) const;
  /// The polynomial is a constant.
  bool is_flat() const;
  friend bool is_defined(const MpTaylorModel& a) { return a.all_defined(); }

  MpTaylorModel operator-() const;
  friend MpTaylorModel operator+(const MpTaylorModel& a, const MpTaylorModel& b) {
    return a.plus(b);
  }
  friend MpTaylorModel operator-(const MpTaylorModel& a, const MpTaylorModel& b) {
    return a.plus(-b);
  }
  friend MpTaylorModel operator*(const MpTaylorModel& a, const MpTaylorModel& b) {
    return a.times(b);
  }
  friend MpTaylorModel operator*(const MpTaylorModel& a, double s) { return a.scaled(s); }
  friend MpTaylorModel operator*(double s, const MpTaylorModel& a) { return a.scaled(s); }
  friend MpTaylorModel operator/(const MpTaylorModel& a, double s) { return a.divided(s); }
  friend MpTaylorModel operator/(const MpTaylorModel& a, const MpTaylorModel& b) {
    return a * inverse(b);
  }
  friend MpTaylorModel inverse(const MpTaylorModel& a) { return a.compose(Function::inverse); }
  friend MpTaylorModel sqrt(const MpTaylorModel& a) { return a.compose(Function::sqrt); }
  friend MpTaylorModel exp(const MpTaylorModel& a) { return a.compose(Function::exp); }
  friend MpTaylorModel log(const MpTaylorModel& a) { return a.compose(Function::log); }
  friend MpTaylorModel sin(const MpTaylorModel& a) { return a.compose(Function::sin); }
  friend MpTaylorModel cos(const MpTaylorModel& a) { return a.compose(Function::cos); }

 private:
  enum class Function : std::uint8_t { inverse, sqrt, exp, log, sin, cos };
  using Coefficients = std::array<MpInterval, Order + 2>;

  /// The values of the polynomial: hull of its Bernstein coefficients without those that hold a
  /// corner of the bits `without`.
  MpInterval polynomial_range(unsigned without = 0) const;
  Range range_without(unsigned corners) const;
  MpTaylorModel plus(const MpTaylorModel& b) const;
  MpTaylorModel times(const MpTaylorModel& b) const;
  MpTaylorModel scaled(double s) const;
  MpTaylorModel divided(double s) const;
  MpTaylorModel compose(Function f) const;
  /// The Taylor coefficients of f at every point of x, to the power Order + 1.
  static Coefficients series(Function f, const MpInterval& x);
  static MpTaylorModel undefined();
  bool all_defined() const;
};

extern template class MpTaylorModel<3>;
extern template class MpTaylorModel<4>;
extern template class MpTaylorModel<5>;

}  // namespace crest::kernel
