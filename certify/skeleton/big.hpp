// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers of any precision, rounded to nearest: what double is at 53 bits. Their precision is the
// thread's at the time they are made.
#include <mpfr.h>

#include <array>
#include <cmath>
#include <utility>

#include "kernel/arithmetic/rational.hpp"

namespace crest::certify::skeleton {

/// Its digits stand in the object: no memory is taken.
class Big {
 public:
  static constexpr mpfr_prec_t kMostBits = 1000;

  Big() : Big(0.0) {}
  Big(double x) : Big(Precision{bits}) {  // NOLINT: numbers convert; exact from 53 bits on
    mpfr_set_d(x_, x, MPFR_RNDN);
  }
  Big(const Big& o) : Big(Precision{mpfr_get_prec(o.x_)}) { mpfr_set(x_, o.x_, MPFR_RNDN); }
  Big& operator=(const Big& o) {
    if (mpfr_get_prec(x_) != mpfr_get_prec(o.x_)) begin(mpfr_get_prec(o.x_));
    mpfr_set(x_, o.x_, MPFR_RNDN);
    return *this;
  }

  friend Big operator+(const Big& a, const Big& b) { return made(mpfr_add, a, b); }
  friend Big operator-(const Big& a, const Big& b) { return made(mpfr_sub, a, b); }
  friend Big operator*(const Big& a, const Big& b) { return made(mpfr_mul, a, b); }
  friend Big operator/(const Big& a, const Big& b) { return made(mpfr_div, a, b); }
  Big& operator+=(const Big& b) {
    mpfr_add(x_, x_, b.x_, MPFR_RNDN);
    return *this;
  }
  /// *this += a b + c d, with room for the products: no memory is taken.
  void add_products(const Big& a, const Big& b, const Big& c, const Big& d,
                    std::array<Big, 2>& room) {
    mpfr_mul(room[0].x_, a.x_, b.x_, MPFR_RNDN);
    mpfr_mul(room[1].x_, c.x_, d.x_, MPFR_RNDN);
    mpfr_add(room[0].x_, room[0].x_, room[1].x_, MPFR_RNDN);
    mpfr_add(x_, x_, room[0].x_, MPFR_RNDN);
  }
  Big operator-() const { return Big(0.0) - *this; }
  friend bool operator<(const Big& a, const Big& b) { return mpfr_less_p(a.x_, b.x_) != 0; }
  friend bool operator>(const Big& a, const Big& b) { return b < a; }
  friend bool operator<=(const Big& a, const Big& b) { return mpfr_lessequal_p(a.x_, b.x_) != 0; }
  friend bool operator==(const Big& a, const Big& b) { return mpfr_equal_p(a.x_, b.x_) != 0; }

  friend double to_double(const Big& a) { return mpfr_get_d(a.x_, MPFR_RNDN); }
  friend kernel::Rational to_rational(const Big& a) {
    kernel::Rational q;
    mpfr_get_q(q.backend().data(), a.x_);
    return q;
  }
  friend bool is_finite(const Big& a) { return mpfr_number_p(a.x_) != 0; }
  /// 2^-k.
  static Big power_of_half(int k) {
    Big one(1.0);
    mpfr_div_2si(one.x_, one.x_, k, MPFR_RNDN);
    return one;
  }

  static thread_local mpfr_prec_t bits;

 private:
  template <class Operation>
  static Big made(Operation operation, const Big& a, const Big& b) {
    Big result(Precision{bits});
    operation(result.x_, a.x_, b.x_, MPFR_RNDN);
    return result;
  }
  struct Precision {
    mpfr_prec_t bits;
  };
  /// Not a number yet.
  explicit Big(Precision precision) { begin(precision.bits); }
  void begin(mpfr_prec_t precision) {
    mpfr_custom_init(digits_.data(), precision);
    mpfr_custom_init_set(x_, MPFR_NAN_KIND, 0, precision, digits_.data());
  }

  std::array<mp_limb_t, (kMostBits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS> digits_;
  mpfr_t x_;
};
inline thread_local mpfr_prec_t Big::bits = 133;

// The same of doubles.
inline double to_double(double x) {
  return x;
}
inline kernel::Rational to_rational(double x) {
  return kernel::Rational(x);
}
inline bool is_finite(double x) {
  return std::isfinite(x);
}

template <class Number>
Number power_of_half(int k) {
  if constexpr (std::is_same_v<Number, double>)
    return std::ldexp(1.0, -k);
  else
    return Number::power_of_half(k);
}
/// Half the distance from 1 to the next number.
template <class Number>
double unit_roundoff() {
  if constexpr (std::is_same_v<Number, double>)
    return 0x1p-53;
  else
    return std::ldexp(1.0, -static_cast<int>(Number::bits));
}

}  // namespace crest::certify::skeleton
