// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/real_form.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "algorithms/coding/triple_model.hpp"

namespace crest::coding {
namespace {

/// 10^0 .. 10^22: all are doubles.
constexpr std::array<double, kPowerCount> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Integers in the order of the numbers; -0 before 0.
std::int64_t ordered(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits - 1 : bits;
}
double from_ordered(std::int64_t k) {
  return std::bit_cast<double>(k < 0 ? std::numeric_limits<std::int64_t>::min() - k - 1 : k);
}
std::int64_t ordered(float x) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  return bits < 0 ? std::int64_t{std::numeric_limits<std::int32_t>::min()} - bits - 1 : bits;
}
float from_ordered_float(std::int64_t k) {
  const auto bits = static_cast<std::int32_t>(k);
  return std::bit_cast<float>(
      bits < 0 ? static_cast<std::int32_t>(std::numeric_limits<std::int32_t>::min() -
                                           std::int64_t{bits} - 1)
               : bits);
}

double number(RealForm form, std::int64_t k) {
  switch (form.form) {
    case Form::decimal:
      return static_cast<double>(k) / kPowers[form.exponent];
    case Form::float_decimal:
      return static_cast<double>(
          static_cast<float>(static_cast<double>(k) / kPowers[form.exponent]));
    case Form::floats:
      return static_cast<double>(from_ordered_float(k));
    case Form::doubles:
      break;
  }
  return from_ordered(k);
}

bool same(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

/// Places whose number the form does not give, or nothing if they are too many.
bool exceptions(RealForm form, std::span<const double> numbers, std::vector<Index>& found) {
  found.clear();
  for (Index i = 0; i < numbers.size(); ++i) {
    const double x = numbers[i];
    if (form.form == Form::floats && std::isfinite(x) &&
        std::fabs(x) > std::numeric_limits<float>::max())
      return false;
    if (same(number(form, integer(form, x)), x)) continue;
    found.push_back(i);
    if (100 * found.size() > numbers.size()) return false;
  }
  return true;
}

/// About how many bits the form costs: of the differences from one number to the next.
double cost(RealForm form, std::span<const double> numbers, std::size_t exceptions) {
  double bits = 80.0 * static_cast<double>(exceptions);
  std::int64_t before = 0;
  for (const double x : numbers) {
    const std::int64_t k = integer(form, x);
    bits += static_cast<double>(
        std::bit_width(static_cast<std::uint64_t>(k) - static_cast<std::uint64_t>(before)));
    before = k;
  }
  return bits;
}

}  // namespace

std::int64_t integer(RealForm form, double x) {
  switch (form.form) {
    case Form::decimal:
    case Form::float_decimal: {
      const double k = std::nearbyint(x * kPowers[form.exponent]);
      const auto limit = static_cast<double>(kExactIntegers - 1);
      return std::isnan(k) ? 0 : static_cast<std::int64_t>(std::clamp(k, -limit, limit));
    }
    case Form::floats:
      return ordered(static_cast<float>(x));
    case Form::doubles:
      break;
  }
  return ordered(x);
}

double checked_number(RealForm form, std::int64_t k) {
  if ((form.form == Form::floats && k != static_cast<std::int32_t>(k)) ||
      (form.has_exponent() && (k < -kExactIntegers || k > kExactIntegers)))
    throw StreamError("has a number beyond its range");
  return number(form, k);
}

RealChannel choose_form(std::span<const double> numbers) {
  std::vector<RealForm> forms;
  for (const Form form : {Form::decimal, Form::float_decimal})
    for (std::uint32_t e = 0; e < kPowers.size(); ++e) forms.push_back({form, e});
  forms.push_back({Form::floats, 0});
  RealChannel best;
  double least = cost(best.form, numbers, 0);
  bool found_decimal[2] = {false, false};
  std::vector<Index> found;
  for (const RealForm form : forms) {
    const bool decimal = form.has_exponent();
    if (decimal && found_decimal[static_cast<std::size_t>(form.form)]) continue;
    if (!exceptions(form, numbers, found)) continue;
    if (decimal) found_decimal[static_cast<std::size_t>(form.form)] = true;
    const double bits = cost(form, numbers, found.size());
    if (bits < least) {
      least = bits;
      best = {form, found};
    }
  }
  return best;
}

}  // namespace crest::coding
