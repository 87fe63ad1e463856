// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The numbers of the second checker: balls and rationals of Arb and FLINT, as values. SPEC.md, "How
// enclosures show it": what is not certainly defined and finite has no value here; the operation
// that would make it throws, so nothing can absorb it.
#include <arb.h>
#include <flint/fmpq.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace crest::recheck {

using Index = std::size_t;

/// A part is not certainly defined.
struct Undefined {};

/// An inequality that its enclosure leaves open.
struct Open {
  const char* what;
};

/// The claim is not proven: why.
struct Rejected : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void require(bool proven, const char* what) {
  if (!proven) throw Open{what};
}

/// How a thread computes: bits; the degree of its models; the degree of its jets.
struct Context {
  slong precision = 64;
  int order = 3;
  int jet_order = 0;
};
inline thread_local Context context;

/// Restores the context.
class Scope {
 public:
  Scope() = default;
  explicit Scope(int jet_order) { context.jet_order = jet_order; }
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;
  ~Scope() { context = saved_; }

 private:
  Context saved_ = context;
};

class Rational {
 public:
  Rational(slong n = 0, ulong d = 1) {
    fmpq_init(v_);
    fmpq_set_si(v_, n, d);
  }
  Rational(const Rational& b) {
    fmpq_init(v_);
    fmpq_set(v_, b.v_);
  }
  Rational& operator=(const Rational& b) {
    fmpq_set(v_, b.v_);
    return *this;
  }
  ~Rational() { fmpq_clear(v_); }
  fmpq* get() { return v_; }
  const fmpq* get() const { return v_; }
  bool is_zero() const { return fmpq_is_zero(v_) != 0; }
  bool is_integer() const { return fmpz_is_one(fmpq_denref(v_)) != 0; }

  friend Rational operator+(const Rational& a, const Rational& b) { return made(fmpq_add, a, b); }
  friend Rational operator-(const Rational& a, const Rational& b) { return made(fmpq_sub, a, b); }
  friend Rational operator*(const Rational& a, const Rational& b) { return made(fmpq_mul, a, b); }
  /// Requires: b is not zero.
  friend Rational operator/(const Rational& a, const Rational& b) { return made(fmpq_div, a, b); }

 private:
  template <class Operation>
  static Rational made(Operation f, const Rational& a, const Rational& b) {
    Rational r;
    f(r.v_, a.v_, b.v_);
    return r;
  }
  fmpq_t v_;
};

class Ball {
 public:
  Ball() { arb_init(v_); }
  Ball(double x) : Ball() { arb_set_d(v_, x); }
  explicit Ball(const Rational& x) : Ball() { arb_set_fmpq(v_, x.get(), context.precision); }
  Ball(const Ball& b) : Ball() { arb_set(v_, b.v_); }
  Ball(Ball&& b) noexcept : Ball() { arb_swap(v_, b.v_); }
  Ball& operator=(const Ball& b) {
    arb_set(v_, b.v_);
    return *this;
  }
  Ball& operator=(Ball&& b) noexcept {
    arb_swap(v_, b.v_);
    return *this;
  }
  ~Ball() { arb_clear(v_); }
  /// All numbers from -r to r.
  static Ball radius(const Ball& r) {
    Ball b;
    arb_add_error(b.v_, r.v_);
    return b;
  }
  arb_ptr get() { return v_; }
  arb_srcptr get() const { return v_; }
  bool is_zero() const { return arb_is_zero(v_) != 0; }
  bool is_positive() const { return arb_is_positive(v_) != 0; }
  /// 1, -1, or 0 if both are possible.
  int sign() const { return arb_is_positive(v_) ? 1 : arb_is_negative(v_) ? -1 : 0; }
  Ball middle() const {
    Ball b;
    arb_set_arf(b.v_, arb_midref(v_));
    return b;
  }
  const Ball& finite() const {
    if (!arb_is_finite(v_)) throw Undefined{};
    return *this;
  }
  void add_product(const Ball& a, const Ball& b) {
    arb_addmul(v_, a.v_, b.v_, context.precision);
    finite();
  }

  friend Ball operator+(const Ball& a, const Ball& b) { return made(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return made(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return made(arb_mul, a, b); }
  Ball operator-() const {
    Ball r;
    arb_neg(r.v_, v_);
    return r;
  }

 private:
  template <class Operation>
  static Ball made(Operation f, const Ball& a, const Ball& b) {
    Ball r;
    f(r.v_, a.v_, b.v_, context.precision);
    r.finite();
    return r;
  }
  arb_t v_;
};

template <class Operation>
Ball through(Operation f, const Ball& x) {
  Ball r;
  f(r.get(), x.get(), context.precision);
  r.finite();
  return r;
}
inline Ball inverse(const Ball& x) {
  if (x.sign() == 0) throw Undefined{};
  return through(arb_inv, x);
}
inline Ball sqrt(const Ball& x) {
  if (x.sign() <= 0 && !x.is_zero()) throw Undefined{};
  return through(arb_sqrt, x);
}
inline Ball log(const Ball& x) {
  if (x.sign() <= 0) throw Undefined{};
  return through(arb_log, x);
}
inline Ball exp(const Ball& x) {
  return through(arb_exp, x);
}
inline Ball sin(const Ball& x) {
  return through(arb_sin, x);
}
inline Ball cos(const Ball& x) {
  return through(arb_cos, x);
}
inline Ball power(const Ball& x, unsigned n) {
  Ball r;
  arb_pow_ui(r.get(), x.get(), n, context.precision);
  r.finite();
  return r;
}
/// x * n / d.
inline Ball scaled(const Ball& x, slong n, slong d = 1) {
  Ball r;
  arb_mul_si(r.get(), x.get(), n, context.precision);
  if (d != 1) arb_div_si(r.get(), r.get(), d, context.precision);
  return r;
}

}  // namespace crest::recheck
