// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/arithmetic/mp_interval.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crest::kernel {
namespace {

mpfr_prec_t common(const MpInterval& a, const MpInterval& b) {
  return std::max(a.precision(), b.precision());
}

}  // namespace

MpInterval::MpInterval(mpfr_prec_t bits) {
  mpfr_init2(low_, bits);
  mpfr_init2(high_, bits);
  mpfr_set_zero(low_, 1);
  mpfr_set_zero(high_, 1);
}

MpInterval::MpInterval(double x, mpfr_prec_t bits) {
  mpfr_init2(low_, bits);
  mpfr_init2(high_, bits);
  mpfr_set_d(low_, x, MPFR_RNDD);
  mpfr_set_d(high_, x, MPFR_RNDU);
  settle();
}

MpInterval::MpInterval(const MpInterval& other) {
  mpfr_init2(low_, other.precision());
  mpfr_init2(high_, other.precision());
  mpfr_set(low_, other.low_, MPFR_RNDD);
  mpfr_set(high_, other.high_, MPFR_RNDU);
}

// A moved-from interval owns no limbs; it can only be destroyed or assigned to.
MpInterval::MpInterval(MpInterval&& other) noexcept {
  *low_ = *other.low_;
  *high_ = *other.high_;
  other.low_->_mpfr_d = nullptr;
  other.high_->_mpfr_d = nullptr;
}

MpInterval& MpInterval::operator=(MpInterval other) noexcept {
  std::swap(*low_, *other.low_);
  std::swap(*high_, *other.high_);
  return *this;
}

MpInterval::~MpInterval() {
  if (low_->_mpfr_d != nullptr) mpfr_clear(low_);
  if (high_->_mpfr_d != nullptr) mpfr_clear(high_);
}

MpInterval MpInterval::from(const Rational& x, mpfr_prec_t bits) {
  MpInterval r(bits);
  mpfr_set_q(r.low_, x.backend().data(), MPFR_RNDD);
  mpfr_set_q(r.high_, x.backend().data(), MPFR_RNDU);
  return r;
}

MpInterval MpInterval::between(double low, double high, mpfr_prec_t bits) {
  if (!(low <= high)) return undefined(bits);
  MpInterval r(bits);
  mpfr_set_d(r.low_, low, MPFR_RNDD);
  mpfr_set_d(r.high_, high, MPFR_RNDU);
  r.settle();
  return r;
}

MpInterval MpInterval::hull(const MpInterval& a, const MpInterval& b) {
  MpInterval r(common(a, b));
  mpfr_min(r.low_, a.low_, b.low_, MPFR_RNDD);
  mpfr_max(r.high_, a.high_, b.high_, MPFR_RNDU);
  r.settle();
  return r;
}

MpInterval MpInterval::pi(mpfr_prec_t bits) {
  MpInterval r(bits);
  mpfr_const_pi(r.low_, MPFR_RNDD);
  mpfr_const_pi(r.high_, MPFR_RNDU);
  return r;
}

MpInterval MpInterval::undefined(mpfr_prec_t bits) {
  MpInterval r(bits);
  mpfr_set_inf(r.low_, -1);
  mpfr_set_inf(r.high_, 1);
  return r;
}

double MpInterval::width() const {
  mpfr_t w;
  mpfr_init2(w, 64);
  mpfr_sub(w, high_, low_, MPFR_RNDU);
  const double result = mpfr_get_d(w, MPFR_RNDU);
  mpfr_clear(w);
  return result;
}

bool MpInterval::contains(const Rational& x) const {
  return mpfr_cmp_q(low_, x.backend().data()) <= 0 && mpfr_cmp_q(high_, x.backend().data()) >= 0;
}

bool MpInterval::contains_zero() const {
  return mpfr_sgn(low_) <= 0 && mpfr_sgn(high_) >= 0;
}

void MpInterval::settle() {
  if (is_defined(*this)) return;
  mpfr_set_inf(low_, -1);
  mpfr_set_inf(high_, 1);
}

MpInterval MpInterval::operator-() const {
  MpInterval r(precision());
  mpfr_neg(r.low_, high_, MPFR_RNDD);
  mpfr_neg(r.high_, low_, MPFR_RNDU);
  return r;
}

MpInterval operator+(const MpInterval& a, const MpInterval& b) {
  MpInterval r(common(a, b));
  mpfr_add(r.low_, a.low_, b.low_, MPFR_RNDD);
  mpfr_add(r.high_, a.high_, b.high_, MPFR_RNDU);
  r.settle();
  return r;
}

MpInterval operator-(const MpInterval& a, const MpInterval& b) {
  MpInterval r(common(a, b));
  mpfr_sub(r.low_, a.low_, b.high_, MPFR_RNDD);
  mpfr_sub(r.high_, a.high_, b.low_, MPFR_RNDU);
  r.settle();
  return r;
}

// Sources of the extreme products: an operand of one sign decides which endpoint of the other is
// taken; an operand's own sign decides where the other is mixed. Two mixed operands: four products.
MpInterval operator*(const MpInterval& a, const MpInterval& b) {
  MpInterval r(common(a, b));
  const bool a_up = mpfr_sgn(a.low_) >= 0, a_signed = a_up || mpfr_sgn(a.high_) <= 0;
  const bool b_up = mpfr_sgn(b.low_) >= 0, b_signed = b_up || mpfr_sgn(b.high_) <= 0;
  if (a_signed || b_signed) {
    const bool low_a = b_signed ? !b_up : a_up, low_b = a_signed ? !a_up : b_up;
    const bool high_a = b_signed ? b_up : a_up, high_b = a_signed ? a_up : b_up;
    mpfr_mul(r.low_, low_a ? a.high_ : a.low_, low_b ? b.high_ : b.low_, MPFR_RNDD);
    mpfr_mul(r.high_, high_a ? a.high_ : a.low_, high_b ? b.high_ : b.low_, MPFR_RNDU);
  } else {
    MpInterval other(common(a, b));
    mpfr_mul(r.low_, a.low_, b.high_, MPFR_RNDD);
    mpfr_mul(other.low_, a.high_, b.low_, MPFR_RNDD);
    mpfr_min(r.low_, r.low_, other.low_, MPFR_RNDD);
    mpfr_mul(r.high_, a.low_, b.low_, MPFR_RNDU);
    mpfr_mul(other.high_, a.high_, b.high_, MPFR_RNDU);
    mpfr_max(r.high_, r.high_, other.high_, MPFR_RNDU);
  }
  r.settle();
  return r;
}

MpInterval operator/(const MpInterval& a, const MpInterval& b) {
  if (b.contains_zero() || !is_defined(a) || !is_defined(b))
    return MpInterval::undefined(common(a, b));
  MpInterval inverse(common(a, b));
  mpfr_ui_div(inverse.low_, 1, b.high_, MPFR_RNDD);
  mpfr_ui_div(inverse.high_, 1, b.low_, MPFR_RNDU);
  return a * inverse;
}

MpInterval operator+(const MpInterval& a, double b) {
  MpInterval r(a.precision());
  mpfr_add_d(r.low_, a.low_, b, MPFR_RNDD);
  mpfr_add_d(r.high_, a.high_, b, MPFR_RNDU);
  r.settle();
  return r;
}

MpInterval operator-(const MpInterval& a, double b) {
  return a + -b;
}

MpInterval operator*(const MpInterval& a, double b) {
  MpInterval r(a.precision());
  mpfr_mul_d(r.low_, b < 0 ? a.high_ : a.low_, b, MPFR_RNDD);
  mpfr_mul_d(r.high_, b < 0 ? a.low_ : a.high_, b, MPFR_RNDU);
  r.settle();
  return r;
}

MpInterval operator/(const MpInterval& a, double b) {
  if (b == 0 || !std::isfinite(b)) return MpInterval::undefined(a.precision());
  MpInterval r(a.precision());
  mpfr_div_d(r.low_, b < 0 ? a.high_ : a.low_, b, MPFR_RNDD);
  mpfr_div_d(r.high_, b < 0 ? a.low_ : a.high_, b, MPFR_RNDU);
  r.settle();
  return r;
}

MpInterval sqrt(const MpInterval& a) {
  if (mpfr_sgn(a.low_) < 0) return MpInterval::undefined(a.precision());
  MpInterval r(a.precision());
  mpfr_sqrt(r.low_, a.low_, MPFR_RNDD);
  mpfr_sqrt(r.high_, a.high_, MPFR_RNDU);
  r.settle();
  return r;
}

MpInterval exp(const MpInterval& a) {
  if (!is_defined(a)) return a;
  MpInterval r(a.precision());
  mpfr_exp(r.low_, a.low_, MPFR_RNDD);
  mpfr_exp(r.high_, a.high_, MPFR_RNDU);
  r.settle();
  return r;
}

MpInterval log(const MpInterval& a) {
  if (mpfr_sgn(a.low_) <= 0) return MpInterval::undefined(a.precision());
  MpInterval r(a.precision());
  mpfr_log(r.low_, a.low_, MPFR_RNDD);
  mpfr_log(r.high_, a.high_, MPFR_RNDU);
  r.settle();
  return r;
}

// Whole numbers in an enclosure of (a - shift) / pi: none, and f is monotone over a; an even one,
// and 1 is its maximum; an odd one, and -1 is its minimum.
MpInterval MpInterval::wave(const MpInterval& a, int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t),
                            double shift) {
  if (!is_defined(a)) return a;
  const mpfr_prec_t bits = a.precision();
  const MpInterval one = between(-1, 1, bits), turns = a / pi(bits + 32) - shift;
  if (!is_defined(turns)) return one;
  MpInterval whole_turns(turns), r(bits), other(bits);
  mpfr_rint_ceil(whole_turns.low_, turns.low_, MPFR_RNDD);
  mpfr_rint_floor(whole_turns.high_, turns.high_, MPFR_RNDU);
  const int held = mpfr_cmp(whole_turns.low_, whole_turns.high_);  // > 0: none, 0: one
  if (held < 0) return one;
  f(r.low_, a.low_, MPFR_RNDD);
  f(other.low_, a.high_, MPFR_RNDD);
  mpfr_min(r.low_, r.low_, other.low_, MPFR_RNDD);
  f(r.high_, a.low_, MPFR_RNDU);
  f(other.high_, a.high_, MPFR_RNDU);
  mpfr_max(r.high_, r.high_, other.high_, MPFR_RNDU);
  if (held > 0) return r;
  mpfr_div_2ui(whole_turns.low_, whole_turns.low_, 1, MPFR_RNDD);
  if (mpfr_integer_p(whole_turns.low_))
    mpfr_set_si(r.high_, 1, MPFR_RNDU);
  else
    mpfr_set_si(r.low_, -1, MPFR_RNDD);
  return r;
}

MpInterval sin(const MpInterval& a) {
  return MpInterval::wave(a, mpfr_sin, 0.5);
}
MpInterval cos(const MpInterval& a) {
  return MpInterval::wave(a, mpfr_cos, 0);
}

// atan2 over a box without the origin takes its extremes at two corners: the argument grows with -x
// above the x-axis, with y to the right of the y-axis, and falls with y to the left.
MpInterval atan2(const MpInterval& y, const MpInterval& x) {
  const mpfr_prec_t bits = common(y, x);
  if (!is_defined(y) || !is_defined(x)) return MpInterval::undefined(bits);
  if (mpfr_sgn(y.low_) >= 0) {
    if (mpfr_sgn(y.low_) == 0 && x.contains_zero()) {
      const MpInterval pi = MpInterval::pi(bits);
      MpInterval r(bits);
      mpfr_neg(r.low_, pi.high_, MPFR_RNDD);
      mpfr_set(r.high_, pi.high_, MPFR_RNDU);
      return r;
    }
    // MPFR's atan2 tells -0 from +0; here zero is a point like others.
    MpInterval up(y), r(bits);
    mpfr_abs(up.low_, up.low_, MPFR_RNDD);
    mpfr_abs(up.high_, up.high_, MPFR_RNDU);
    mpfr_atan2(r.low_, mpfr_sgn(x.high_) > 0 ? up.low_ : up.high_, x.high_, MPFR_RNDD);
    mpfr_atan2(r.high_, mpfr_sgn(x.low_) < 0 ? up.low_ : up.high_, x.low_, MPFR_RNDU);
    return r;
  }
  if (mpfr_sgn(y.high_) <= 0) return -atan2(-y, x);
  if (mpfr_sgn(x.high_) < 0) return MpInterval::pi(bits) + atan2(-y, -x);
  if (mpfr_sgn(x.low_) <= 0) return atan2(MpInterval(bits), MpInterval(bits));
  MpInterval r(bits);
  mpfr_atan2(r.low_, y.low_, x.low_, MPFR_RNDD);
  mpfr_atan2(r.high_, y.high_, x.low_, MPFR_RNDU);
  return r;
}

MaybeSign certain_sign(const MpInterval& a) {
  if (mpfr_sgn(a.low_) > 0) return Sign::positive;
  if (mpfr_sgn(a.high_) < 0) return Sign::negative;
  if (mpfr_zero_p(a.low_) && mpfr_zero_p(a.high_)) return Sign::zero;
  return std::nullopt;
}

}  // namespace crest::kernel
