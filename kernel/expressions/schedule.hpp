// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What evaluating expressions takes: each value once, also those that several expressions or
// several places of one have in common, and a place for it that is free again after its last use.
#include <compare>
#include <span>

#include "kernel/expressions/expression.hpp"

namespace crest::kernel {

struct Schedule {
  struct Operand {
    enum class Kind : std::uint8_t { one, constant, variable, step };
    Kind kind;
    std::size_t index;
    friend auto operator<=>(const Operand&, const Operand&) = default;
  };
  /// Powers are products: x^2n = x^n x^n, x^(2n+1) = x^2n x, x^-n = 1 / x^n. The only power among
  /// the steps is x^0: 1 where x is defined.
  struct Step {
    Operation::Code code;
    Operand first, last;  ///< the same for a function of one
    std::size_t place;    ///< of the value: none of the operands'
  };

  std::vector<Constant> constants;
  std::vector<Step> steps;
  std::vector<Operand> results;  ///< one for each expression; their places keep them
  std::size_t places = 0;
};

/// Of expressions with the same variables. Equal operations of equal operands are one step: the
/// values are those of each expression on its own, to the last bit.
Schedule schedule(std::span<const Expression> expressions);

}  // namespace crest::kernel
