// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/box.hpp"

#include <algorithm>

namespace crest::certify::smooth {
namespace {

constexpr mpfr_prec_t kBits = 106;

template <class T>
T between(double low, double high) {
  if constexpr (std::is_same_v<T, kernel::Interval>)
    return {low, high};
  else
    return kernel::MpInterval::between(low, high, kBits);
}

/// Intervals of CGAL need the rounding mode, MPFR's do not.
template <class T>
using Guard = std::conditional_t<std::is_same_v<T, kernel::Interval>, kernel::RoundUpward, int>;

template <class T, int n>
kernel::Evaluator<kernel::Jet<T, 3, n>> make(const Surface& surface) {
  [[maybe_unused]] const Guard<T> guard{};
  if constexpr (std::is_same_v<T, kernel::Interval>)
    return kernel::jet_evaluator<T, 3, n>(surface.texts[0]);
  else
    return kernel::mp_jet_evaluator<3, n>(surface.texts[0], kBits);
}

template <class T, int n>
std::array<kernel::Jet<T, 3, n>, 3> variables(const Box& box) {
  using Jet = kernel::Jet<T, 3, n>;
  std::array<Jet, 3> x;
  for (std::size_t i = 0; i < 3; ++i)
    x[i] = Jet::variable(static_cast<int>(i), between<T>(box.low[i], box.high[i]));
  return x;
}

std::array<int, 3> unit(std::size_t i) {
  std::array<int, 3> e{};
  e[i] = 1;
  return e;
}

/// F, or d . grad F, at a jet.
template <class Jet>
auto quantity(const Jet& f, const std::array<double, 3>* d) {
  if (d == nullptr) return f.coefficient(0, 0, 0);
  return f.coefficient(1, 0, 0) * (*d)[0] + f.coefficient(0, 1, 0) * (*d)[1] +
         f.coefficient(0, 0, 1) * (*d)[2];
}
/// Its derivative by coordinate i; the jet is one order longer.
template <class Jet>
auto derivative(const Jet& f, const std::array<double, 3>* d, std::size_t i) {
  const auto e = unit(i);
  if constexpr (Jet::kCount == 4) {
    return f.coefficient(e[0], e[1], e[2]);
  } else {
    const auto second = [&](std::size_t k) {
      return f.derivative(e[0] + (k == 0), e[1] + (k == 1), e[2] + (k == 2));
    };
    return second(0) * (*d)[0] + second(1) * (*d)[1] + second(2) * (*d)[2];
  }
}

}  // namespace

std::optional<std::array<Box, 2>> Box::split(std::size_t axis) const {
  const double middle = (low[axis] + high[axis]) / 2;
  if (!(low[axis] < middle && middle < high[axis])) return std::nullopt;
  std::array<Box, 2> halves = {*this, *this};
  halves[0].high[axis] = halves[1].low[axis] = middle;
  return halves;
}

template <class T>
BoxProver<T>::BoxProver(const Surface& surface)
    : first_(make<T, 1>(surface)), second_(make<T, 2>(surface)) {}

/// Condition (A): F is defined, and analytic where its derivatives are asked for. A function is
/// defined where it is not analytic only for sqrt at 0, whose derivatives are not.
template <class Jet>
bool holds_a(const Jet& f, const std::array<double, 3>* d) {
  return is_defined(f) && (d == nullptr || (is_defined(f.coefficient(1, 0, 0)) &&
                                            is_defined(f.coefficient(0, 1, 0)) &&
                                            is_defined(f.coefficient(0, 0, 1))));
}

/// f(box) and f(c) + grad f(box) . (box - c); n: order of the jet that holds grad f.
template <class T>
template <int n>
kernel::MaybeSign BoxProver<T>::natural_or_mean(const Box& box, Direction d) {
  using kernel::certain_sign;
  auto& evaluate = evaluator<n>();
  const auto f = evaluate(variables<T, n>(box));
  if (!holds_a(f, d)) return std::nullopt;
  if (const auto sign = certain_sign(quantity(f, d)); sign && *sign != kernel::Sign::zero)
    return sign;
  Box middle;
  for (std::size_t i = 0; i < 3; ++i)
    middle.low[i] = middle.high[i] =
        std::clamp(box.low[i] / 2 + box.high[i] / 2, box.low[i], box.high[i]);
  T sum = quantity(evaluate(variables<T, n>(middle)), d);
  for (std::size_t i = 0; i < 3; ++i)
    sum = sum + derivative(f, d, i) * (between<T>(box.low[i], box.high[i]) -
                                       between<T>(middle.low[i], middle.low[i]));
  return certain_sign(sum);
}

template <class T>
kernel::MaybeSign BoxProver<T>::on_box(const Box& box, Direction d) {
  [[maybe_unused]] const Guard<T> guard{};
  return d == nullptr ? natural_or_mean<1>(box, d) : natural_or_mean<2>(box, d);
}

template <class T>
kernel::Sign BoxProver<T>::on_pieces(const Box& box, Direction d, WitnessReader& in, int depth) {
  const unsigned code = in.byte();
  in.check(code <= 3 && (code == 3 || depth < kDepth), "divides a box in no way that there is");
  if (code == 3) {
    const auto sign = on_box(box, d);
    if (!sign || *sign == kernel::Sign::zero) in.fail("the sign on a box");
    return *sign;
  }
  const auto halves = box.split(code);
  in.check(halves.has_value(), "divides a box that cannot be");
  const kernel::Sign first = on_pieces((*halves)[0], d, in, depth + 1);
  // The halves share a side, so two certain signs are the same.
  on_pieces((*halves)[1], d, in, depth + 1);
  return first;
}

template class BoxProver<kernel::Interval>;
template class BoxProver<kernel::MpInterval>;

}  // namespace crest::certify::smooth
