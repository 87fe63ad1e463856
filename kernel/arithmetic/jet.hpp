// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Truncated Taylor expansions of functions of one to three variables, over any number type.
//
// A jet holds the Taylor coefficients f_a = D^a f / a! of total degree |a| <= Order at a point.
// Theorem. Over an enclosing type (intervals, Taylor models, MPFR) every coefficient of a result
// encloses the exact one, for all functions whose coefficients the operands enclose: each
// recurrence below is an identity of exact coefficients, and T's operations enclose. Coefficients
// outside mask() are zero for all these functions, at every point where they are defined.
//
// Products are sums over a = b + c. For functions let E = sum x_i d/dx_i, so (E f)_a = |a| f_a:
//   q = g / f     f_0 q_a = g_a - sum over b != 0 of f_b q_{a-b}
//   s = sqrt(f)   2 s_0 s_a = f_a - sum over b != 0, a of s_b s_{a-b}
//   e = exp(h)    E e = e E h:     |a| e_a = sum of |b| h_b e_{a-b}
//   l = log(f)    E l = (E f) / f
//   sin, cos      E sin(h) = cos(h) E h, E cos(h) = -sin(h) E h, both at once.
// Right sides hold coefficients of lower degree only: each costs about one product.
//
// Undefined. A jet is defined if its value f_0 is (T's is_defined). Law: a jet that is not defined
// has only undefined coefficients, and a result of an undefined operand is not defined, whatever
// the other operand is: the jet of log(g) where g < 0 has no derivatives, though g' / g is finite.
// A coefficient beyond the value may be undefined alone (sqrt at 0): the function is defined there,
// that derivative is not, or not known.
#include <cmath>
#include <type_traits>
#include <utility>

#include "kernel/arithmetic/jet_tables.hpp"
#include "kernel/arithmetic/sparse_array.hpp"

namespace crest::kernel {

/// T: + - * / among themselves and * / with scalars, which are doubles, or T if it is built in.
/// Coefficients in the order of Monomials.
template <class T, int Variables, int Order>
class Jet {
  static_assert(1 <= Variables && Variables <= 3 && 0 <= Order && Order <= 5);

 public:
  static constexpr JetTables<Variables, Order> kTables{};
  static constexpr int kCount = kTables.kCount;
  using Scalar = typename ScalarOf<T>::Type;

  Jet() = default;  ///< identically zero
  static Jet constant(T value) {
    Jet r;
    r.c_.put(0, std::move(value));
    r.settle();
    return r;
  }
  /// The variable i (from 0) at `value`.
  static Jet variable(int i, T value) {
    Jet r;
    // Of degree one the last variable comes first.
    if constexpr (Order > 0)
      r.c_.put(static_cast<std::size_t>(Variables - i), number_like(1, &value));
    r.c_.put(0, std::move(value));
    r.settle();
    return r;
  }

  const T& operator[](std::size_t i) const { return c_.has(i) ? c_[i] : zero(); }
  /// By as many exponents as variables, their sum at most Order.
  template <class... Exponents>
  const T& coefficient(Exponents... exponents) const {
    return (*this)[kTables.position[kTables.digits(exponents...)]];
  }
  /// D^a f = a! f_a.
  template <class... Exponents>
  T derivative(Exponents... exponents) const {
    double factor = 1;
    const auto times_factorial = [&](int n) {
      for (; n > 1; --n) factor *= n;
    };
    (times_factorial(static_cast<int>(exponents)), ...);
    const T& c = coefficient(exponents...);
    return factor == 1 ? c : T(c * factor);
  }
  /// Gives coefficient i a value that need not be zero.
  void set(std::size_t i, T value) { c_.put(i, std::move(value)); }
  /// Bit i: coefficient i is not identically zero.
  std::uint64_t mask() const { return c_.mask(); }

  Jet operator-() const {
    return each([](const T& x) { return T(-x); });
  }
  friend Jet operator+(const Jet& a, const Jet& b) { return a.plus(b, false); }
  friend Jet operator-(const Jet& a, const Jet& b) { return a.plus(b, true); }
  friend Jet operator*(const Jet& a, const Jet& b) {
    Jet r;
    for_each_bit(a.mask(), [&](std::size_t i) {
      if (&a == &b)
        spread_square(r.c_, i, a.c_);
      else
        spread(r.c_, i, a.c_[i], b.c_, b.mask());
    });
    if (a.c_.has(0) && b.c_.has(0))
      r.settle();
    else if (!is_defined(a))  // the other value is identically zero
      r.undefine(a.c_[0]);
    else if (!is_defined(b))
      r.undefine(b.c_[0]);
    return r;
  }
  friend bool is_defined(const Jet& f) { return !f.c_.has(0) || is_defined(f.c_[0]); }
  friend Jet operator/(const Jet& a, const Jet& b) { return a.over(b); }
  friend Jet operator+(const Jet& a, Scalar s) {
    Jet r = a;
    r.shift(s);
    r.settle();
    return r;
  }
  friend Jet operator+(Scalar s, const Jet& a) { return a + s; }
  friend Jet operator-(const Jet& a, Scalar s) { return a + -s; }
  friend Jet operator-(Scalar s, const Jet& a) { return -a + s; }
  friend Jet operator*(Scalar s, const Jet& a) { return a * s; }
  friend Jet operator*(const Jet& a, Scalar s) {
    return a.each([&](const T& x) { return T(x * s); });
  }
  friend Jet operator/(const Jet& a, Scalar s) {
    return a.each([&](const T& x) { return T(x / s); });
  }
  friend Jet operator/(Scalar s, const Jet& a) { return constant(number(s, &a[0])).over(a); }

  friend Jet inverse(const Jet& f) { return 1.0 / f; }
  friend Jet sqrt(const Jet& f) { return f.square_root(); }
  friend Jet exp(const Jet& h) { return h.exponential(); }
  friend Jet log(const Jet& f) { return f.logarithm(); }
  friend Jet sin(const Jet& h) { return h.circular().first; }
  friend Jet cos(const Jet& h) { return h.circular().second; }

 private:
  using Coefficients = SparseArray<T, kCount>;

  static const T& zero() {
    static const T value = number_like(0, static_cast<const T*>(nullptr));
    return value;
  }
  template <class Function>
  Jet each(Function&& f) const {
    Jet r;
    for_each_bit(mask(), [&](std::size_t i) { r.c_.make(i, [&] { return f(c_[i]); }); });
    r.settle();
    return r;
  }
  static T number(Scalar s, const T* like) {
    if constexpr (std::is_same_v<Scalar, T>)
      return s;
    else
      return number_like(s, like);
  }
  void shift(Scalar s) { c_.put(0, c_.has(0) ? T(c_[0] + s) : number(s, &(*this)[0])); }
  Jet plus(const Jet& b, bool negative) const;
  /// Makes all coefficients `value`, an undefined one.
  void undefine(T value);
  /// Makes all coefficients undefined if the value is. In place: jets are large, copies dear.
  void settle() {
    if (!is_defined(*this)) undefine(c_[0]);
  }

  /// sums_{i + j} += x f_j for the j of `which`.
  static void spread(Coefficients& sums, std::size_t i, const T& x, const Coefficients& f,
                     std::uint64_t which);
  /// The terms of f f that hold f_i and no later coefficient.
  static void spread_square(Coefficients& sums, std::size_t i, const Coefficients& f);
  /// E f: degree times coefficient.
  Coefficients euler() const;

  Jet over(const Jet& f) const;
  Jet square_root() const;
  Jet exponential() const;
  Jet logarithm() const;
  std::pair<Jet, Jet> circular() const;

  Coefficients c_;
};

}  // namespace crest::kernel

#include "kernel/arithmetic/jet_functions.hpp"
