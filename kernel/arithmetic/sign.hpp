// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The answer of every decision: a sign that is exact, or "not decided".
#include <cstdint>
#include <optional>

namespace crest::kernel {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

/// A stage's answer. Empty means "not decided"; Sign::zero means exactly zero.
using MaybeSign = std::optional<Sign>;

constexpr Sign operator-(Sign s) {
  return static_cast<Sign>(-static_cast<int>(s));
}
constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}
template <class Number>
constexpr Sign sign_of(const Number& x) {
  return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}

}  // namespace crest::kernel
