// SPDX-License-Identifier: GPL-3.0-or-later
// Undefined is a poison (defined.hpp): no operation of any enclosing type gives a defined result of
// an undefined operand.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "kernel/expressions/enclosures.hpp"

namespace {

using namespace crest::kernel;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class T>
struct NamedValue {
  std::string name;
  T value;
};
template <class T>
using Values = std::vector<NamedValue<T>>;

template <class T>
T number(double x) {
  return number_like(x, static_cast<const T*>(nullptr));
}

Values<Interval> undefined_samples(const Interval*) {
  return {{"whole", Interval::undefined()},
          {"above 1", Interval(1) / Interval(0)},
          {"infinity", Interval(kInfinity)},
          {"NaN", Interval(std::nan(""))},
          {"NaN bound", Interval(std::nan(""), 1)},
          {"half line", Interval(1, kInfinity)},
          {"overflow", Interval(1e300, 2e300) * Interval(1e300)},
          {"overflow below", Interval(-2e300, -1e300) * Interval(1e300)},
          {"sum overflow", Interval(1.7e308) + Interval(1.7e308)},
          {"log", log(Interval(-1))},
          {"log at 0", log(Interval(0, 1))},
          {"sqrt", sqrt(Interval(-1, 1))},
          {"exp", exp(Interval(1000))},
          {"empty", Interval(1, 0)}};
}
Values<MpInterval> undefined_samples(const MpInterval*) {
  const auto x = [](double low, double high) { return MpInterval::between(low, high, 80); };
  return {{"whole", MpInterval::undefined(80)},
          {"pole", x(1, 1) / x(0, 1)},
          {"by 0", x(1, 1) / 0.0},
          {"infinity", MpInterval(kInfinity, 80)},
          {"NaN", MpInterval(std::nan(""), 80)},
          {"half line", x(1, kInfinity)},
          {"log", log(x(-1, -1))},
          {"log at 0", log(x(0, 1))},
          {"sqrt", sqrt(x(-1, 1))},
          {"hull", MpInterval::hull(MpInterval::undefined(80), x(1, 1))},
          {"angle", atan2(MpInterval::undefined(80), x(1, 1))},
          {"empty", x(1, 0)}};
}
/// Of both Taylor models.
template <class M>
Values<M> undefined_models() {
  const M u = M::linear(-1, 1, 0.5), zero = M(0.0), one = M(1.0);
  return {{"radius", M::around(0, kInfinity)},
          {"NaN radius", M::around(1, std::nan(""))},
          {"constant", M(kInfinity)},
          {"corner", M::linear(0, kInfinity, 1)},
          {"pole", one / u},
          {"1/0", inverse(zero)},
          {"by 0", u / 0.0},
          {"log", log(M(-1.0))},
          {"log of a model", log(u)},
          {"log at 0", log(zero)},
          {"sqrt", sqrt(M(-1.0))},
          {"sqrt of a model", sqrt(u)},
          {"sqrt at 0", sqrt(zero)},
          {"sqrt within", sqrt(M::around(0, 1e-300))},
          {"exp", exp(exp(M(1000.0)))}};
}
template <int Order>
Values<TaylorModel<Order>> undefined_samples(const TaylorModel<Order>*) {
  auto samples = undefined_models<TaylorModel<Order>>();
  const auto big = TaylorModel<Order>::linear(1e200, 2e200, 1e200);
  samples.push_back({"product overflow", big * big});
  samples.push_back({"overflow", big * 1e200});
  samples.push_back({"exp overflow", exp(TaylorModel<Order>(1000.0))});
  return samples;
}
template <int Order>
Values<MpTaylorModel<Order>> undefined_samples(const MpTaylorModel<Order>*) {
  auto samples = undefined_models<MpTaylorModel<Order>>();
  MpTaylorModel<Order> one_coefficient = MpTaylorModel<Order>(1.0);
  one_coefficient.c[2] = MpInterval::undefined(106);
  samples.push_back({"one coefficient", one_coefficient});
  return samples;
}

template <class T>
Values<T> defined_samples() {
  return {
      {"0", number<T>(0)}, {"1", number<T>(1)}, {"-2", number<T>(-2)}, {"1e300", number<T>(1e300)}};
}
template <class T>
Values<T> more_defined(const T*) {
  return {{"1e-300", number<T>(1e-300)}};
}
template <int Order>
Values<TaylorModel<Order>> more_defined(const TaylorModel<Order>*) {
  return {{"linear", TaylorModel<Order>::linear(-1, 1, 0.5)},
          {"around 0", TaylorModel<Order>::around(0, 1e-3)}};
}
template <int Order>
Values<MpTaylorModel<Order>> more_defined(const MpTaylorModel<Order>*) {
  return {{"linear", MpTaylorModel<Order>::linear(-1, 1, 0.5)},
          {"around 0", MpTaylorModel<Order>::around(0, 1e-3)}};
}

/// No operation on `bad`, whatever `other` is, has a defined result.
template <class T>
void check_poison(const NamedValue<T>& bad, const NamedValue<T>& other) {
  CAPTURE(bad.name, other.name);
  const T &x = bad.value, &y = other.value;
  CHECK_FALSE(is_defined(x));
  CHECK_FALSE(is_defined(T(-x)));
  CHECK_FALSE(is_defined(T(x + y)));
  CHECK_FALSE(is_defined(T(y + x)));
  CHECK_FALSE(is_defined(T(x - y)));
  CHECK_FALSE(is_defined(T(y - x)));
  CHECK_FALSE(is_defined(T(x * y)));
  CHECK_FALSE(is_defined(T(y * x)));
  CHECK_FALSE(is_defined(T(x / y)));
  CHECK_FALSE(is_defined(T(y / x)));
  CHECK_FALSE(is_defined(T(x * x)));
  CHECK_FALSE(is_defined(T(x - x)));
  CHECK_FALSE(is_defined(T(x / x)));
  CHECK_FALSE(is_defined(T(x / kInfinity)));
  CHECK_FALSE(is_defined(T(y / kInfinity)));
  for (const double s : {0.0, 1.0, -1e-300, 1e300, kInfinity}) {
    CHECK_FALSE(is_defined(T(x * s)));
    CHECK_FALSE(is_defined(T(x / s)));
  }
  for (const auto code : {Operation::Code::sqrt, Operation::Code::exp, Operation::Code::log,
                          Operation::Code::sin, Operation::Code::cos})
    CHECK_FALSE(is_defined(ElementaryFunctions<T>::apply(code, x)));
  T sum = y;
  add_product(sum, x, y);
  CHECK_FALSE(is_defined(sum));
  sum = x;
  add_product(sum, y, y);
  CHECK_FALSE(is_defined(sum));
}

template <class T>
void check_number_type() {
  const T* const kind = nullptr;
  Values<T> good = defined_samples<T>();
  for (auto& more : more_defined(kind)) good.push_back(std::move(more));
  for (const auto& y : good) {
    CAPTURE(y.name);
    CHECK(is_defined(y.value));
  }
  const Values<T> bad = undefined_samples(kind);
  for (const auto& x : bad) {
    for (const auto& y : good) check_poison(x, y);
    for (const auto& y : bad) check_poison(x, y);
  }
}

template <class Model>
void check_ranges() {
  for (const auto& x : undefined_samples(static_cast<const Model*>(nullptr))) {
    CAPTURE(x.name);
    for (const Range r : {x.value.range(), x.value.range_on_edge(1), x.value.at_corner(2)})
      CHECK_FALSE(certain_sign(r));
  }
}

/// A jet that is not defined: all its coefficients are not.
template <class J>
void check_undefined(const J& f) {
  CHECK_FALSE(is_defined(f));
  for (std::size_t k = 0; k < J::kCount; ++k) {
    CAPTURE(k);
    CHECK_FALSE(is_defined(f[k]));
  }
}

template <class T>
void check_jets() {
  using J = Jet<T, 2, 3>;
  const J zero, one = J::constant(number<T>(1)), u = J::variable(0, number<T>(0.25)),
                v = J::variable(1, number<T>(-0.5));
  const J below = log(v - 0.25), root = sqrt(v), pole = one / (u - 0.25);
  const std::vector<NamedValue<J>> bad = {
      {"log below zero", below},
      {"log of a constant", log(J::constant(number<T>(-1)))},
      {"sqrt below zero", root},
      {"pole", pole},
      {"by the zero jet", one / zero},
      {"log of the zero jet", log(zero)},
      {"constant", J::constant(T(number<T>(1) / number<T>(0)))},
      {"variable", J::variable(0, T(number<T>(1) / number<T>(0)))}};
  const std::vector<NamedValue<J>> good = {
      {"zero", zero}, {"one", one}, {"u", u}, {"u - value", u - 0.25}, {"uv", u * v}};
  for (const auto& x : bad) {
    CAPTURE(x.name);
    check_undefined(x.value);
    check_undefined(-x.value);
    for (const auto& f : {x.value * x.value, x.value - x.value, x.value / x.value, x.value * 0.0,
                          x.value + 1.0, 1.0 - x.value, x.value / 2.0, 0.0 / x.value, sqrt(x.value),
                          exp(x.value), log(x.value), sin(x.value), cos(x.value)})
      check_undefined(f);
    for (const auto& y : good) {
      CAPTURE(y.name);
      for (const auto& f :
           {x.value + y.value, y.value + x.value, x.value - y.value, y.value - x.value,
            x.value * y.value, y.value * x.value, x.value / y.value, y.value / x.value})
        check_undefined(f);
    }
  }
  for (const auto& y : good) CHECK(is_defined(y.value));
}

template <class T, class Convert>
bool defined_value(const std::string& text, const std::vector<T>& at, Convert&& convert) {
  const auto e = Expression::parse(text, {"x", "y"});
  return is_defined(Evaluator<T>(e, convert, number<T>(1))(at));
}
template <class T>
void check_expressions(const T& x, const T& y) {
  const auto convert = [](const Constant& c) {
    return as_enclosure(c, static_cast<const T*>(nullptr));
  };
  const auto by_jets = [&](const std::string& text) {
    const auto e = Expression::parse(text, {"x", "y"});
    const std::vector<Jet<T, 2, 2>> at = {Jet<T, 2, 2>::variable(0, x),
                                          Jet<T, 2, 2>::variable(1, y)};
    return is_defined(jet_evaluator<T, 2, 2>(e)(at));
  };
  for (const char* part :
       {"log(x-2)", "sqrt(-1)", "sqrt(x-2)", "1/0", "1/(x-x)", "log(0)", "log(x-2)^2",
        "(x-2)^0*log(x-2)", "sin(1/0)", "exp(exp(exp(100)))", "(x-x)^-1", "y/log(1)", "log(-1-x^2)",
        "sqrt(log(x-3))", "1/(sqrt(x-2)-sqrt(x-2))"})
    for (const char* context :
         {"#", "x + 0*#", "x + #*0", "# - #", "sin(#)", "x + cos(0*#)", "(#)^0", "x^(0)*(#)^0",
          "0/(#)", "exp(-(#)^2)", "((#)^0)^0", "x + (y - y)*#", "1/(1 + (#)^2)"}) {
      std::string text = context;
      for (auto at = text.find('#'); at != std::string::npos; at = text.find('#'))
        text.replace(at, 1, "(" + std::string(part) + ")");
      CAPTURE(text);
      CHECK_FALSE(defined_value<T>(text, {x, y}, convert));
      CHECK_FALSE(by_jets(text));
    }
  for (const char* text : {"x^0", "(x-x)^0", "0*log(x)", "sqrt(x)^0 + sin(1/x)"}) {
    CAPTURE(text);
    CHECK(defined_value<T>(text, {x, y}, convert));
    CHECK(by_jets(text));
  }
}

}  // namespace

TEST_CASE("undefined is a poison: intervals") {
  const RoundUpward guard;
  check_number_type<Interval>();
}
TEST_CASE("undefined is a poison: MPFR intervals") {
  check_number_type<MpInterval>();
}
TEST_CASE("undefined is a poison: Taylor models") {
  check_number_type<TaylorModel<3>>();
  check_number_type<TaylorModel<5>>();
  check_ranges<TaylorModel<3>>();
  check_ranges<TaylorModel<4>>();
}
TEST_CASE("undefined is a poison: Taylor models over MPFR") {
  check_number_type<MpTaylorModel<3>>();
  check_ranges<MpTaylorModel<3>>();
}

TEST_CASE("undefined is a poison: jets over every type") {
  check_jets<TaylorModel<3>>();
  check_jets<TaylorModel<5>>();
  check_jets<MpTaylorModel<3>>();
  check_jets<MpInterval>();
  const RoundUpward guard;
  check_jets<Interval>();
}

TEST_CASE("undefined is a poison: expressions over every type") {
  check_expressions<TaylorModel<4>>(TaylorModel<4>::linear(1, 1.5, 1.25),
                                    TaylorModel<4>::linear(0.5, 0, 1));
  check_expressions<MpTaylorModel<3>>(MpTaylorModel<3>::linear(1, 1.5, 1.25),
                                      MpTaylorModel<3>::linear(0.5, 0, 1));
  const RoundUpward guard;
  check_expressions<Interval>(Interval(1, 1.5), Interval(0, 1));
}

TEST_CASE("a sign is certain of defined numbers only") {
  const RoundUpward guard;
  CHECK_FALSE(certain_sign(Interval(1e300, 2e300) * Interval(1e300)));
  CHECK_FALSE(certain_sign(Range{1, kInfinity}));
  CHECK_FALSE(certain_sign(Range{-kInfinity, -1}));
  CHECK(certain_sign(Range{1, 2}) == Sign::positive);
}

/// f over the enclosures [-1, 1] and [0, 1] of a variable.
template <class T>
void check_partly_defined(const T& around, const T& from, bool root_at_zero) {
  const T zero = number<T>(0), one = number<T>(1);
  CHECK_FALSE(is_defined(T(sqrt(around))));
  CHECK(is_defined(T(sqrt(from))) == root_at_zero);
  CHECK_FALSE(is_defined(T(log(from))));
  CHECK_FALSE(is_defined(T(one / from)));
  CHECK_FALSE(is_defined(T(one / around)));
  CHECK_FALSE(is_defined(T(zero * T(one / around))));
  CHECK_FALSE(is_defined(T(one / T(from * from))));
  using J = Jet<T, 1, 1>;
  CHECK_FALSE(is_defined(sqrt(J::variable(0, from)).coefficient(1)));
}
TEST_CASE("an enclosure over a set on which an operation is undefined at a point is undefined") {
  check_partly_defined(TaylorModel<3>::linear(-1, 1, 1), TaylorModel<3>::linear(0, 1, 1), false);
  check_partly_defined(MpTaylorModel<3>::linear(-1, 1, 1), MpTaylorModel<3>::linear(0, 1, 1),
                       false);
  check_partly_defined(MpInterval::between(-1, 1, 80), MpInterval::between(0, 1, 80), true);
  const RoundUpward guard;
  check_partly_defined(Interval(-1, 1), Interval(0, 1), true);
}

TEST_CASE("sqrt at zero: an interval has its value and not its slope, a model nothing") {
  const RoundUpward guard;
  const auto f = sqrt(Jet<Interval, 2, 1>::variable(0, Interval(0, 1)));
  CHECK(is_defined(f));
  CHECK_FALSE(is_defined(f.coefficient(1, 0)));
  CHECK(is_defined(f.coefficient(0, 1)));
  CHECK_FALSE(is_defined(sqrt(TaylorModel<3>::linear(0, 1, 1))));
}

// Terms of a bound that underflow must not vanish where they are multiplied by large ones.
TEST_CASE("Taylor models near the smallest numbers still enclose") {
  for (const double c : {1e-76, 1e-77, 1e-78, 1e-79, 1e-80, 1e-100})
    for (const double spread : {0.5, 1e-3, 1e-6}) {
      const auto x = TaylorModel<3>::linear(c, c * (1 + spread), c);
      const auto at = [](const TaylorModel<3>& m) { return m.at_corner(1); };
      CAPTURE(c, spread);
      const Range root = at(sqrt(x)), quotient = at(inverse(x));
      CHECK(root.contains(std::sqrt(c * (1 + spread))));
      CHECK(quotient.contains(1 / (c * (1 + spread))));
    }
}
