// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Doubles as integers that predict each other well: decimals, or patterns of floats or doubles
// (docs/cmc-format.md, "Positions").
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/coding/numbers.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::coding {

using kernel::Index;

/// How doubles are integers.
enum class Form : std::uint32_t { decimal, float_decimal, floats, doubles };

struct RealForm {
  Form form = Form::doubles;
  std::uint32_t exponent = 0;  ///< of decimals

  bool has_exponent() const { return form == Form::decimal || form == Form::float_decimal; }
  /// Are the integers of 64 bits, not of 53?
  bool wide() const { return form == Form::doubles; }
};

struct RealChannel {
  RealForm form;
  std::vector<Index> exceptions;  ///< places whose number the form does not give, ascending
};

/// That which seems to cost least of those with at most 1 % exceptions.
RealChannel choose_form(std::span<const double> numbers);

/// The integer whose number is x, or is near it.
std::int64_t integer(RealForm form, double x);
/// The number of an integer from a stream. Throws: StreamError if there is none.
double checked_number(RealForm form, std::int64_t k);

inline constexpr std::size_t kPowerCount = 23;  ///< of exponents

template <class Range>
void code_form(Range& range, RealForm& form) {
  form.form = static_cast<Form>(code_bits(range, static_cast<std::uint32_t>(form.form), 2));
  if (form.has_exponent()) form.exponent = code_below(range, form.exponent, kPowerCount);
}

/// Puts the numbers of these places right.
template <class Range>
void code_exceptions(Range& range, std::span<const Index> places, std::span<double> numbers) {
  SmallNumber count, gap;
  const std::uint32_t n = count.code(range, static_cast<std::uint32_t>(places.size()));
  std::uint64_t at = 0;
  for (std::uint32_t i = 0; i < n; ++i, ++at) {
    at += gap.code(range, Range::kEncodes ? static_cast<std::uint32_t>(places[i] - at) : 0);
    if (at >= numbers.size()) throw StreamError("has an exception at no place");
    double& x = numbers[at];
    x = std::bit_cast<double>(LargeNumber::code_lower(range, std::bit_cast<std::uint64_t>(x), 64));
  }
}

}  // namespace crest::coding
