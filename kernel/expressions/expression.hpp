// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Functions given as text, parsed once into a compact program for any number type.
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/arithmetic/rational.hpp"

namespace crest::kernel {

/// What the text gets wrong: one line, "column C: WHAT is expected, not 'WHAT STANDS THERE'".
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(std::size_t column, const std::string& what);
  std::size_t column() const { return column_; }  ///< bytes of the text, from 1

 private:
  std::size_t column_;
};

/// A number of the text, exactly and as the nearest double, or one of the two named constants.
struct Constant {
  enum class Kind : std::uint8_t { number, pi, e };
  Kind kind;
  Rational exact;  ///< of a number
  double nearest;
};

/// One step of the program on a stack of values.
struct Operation {
  enum class Code : std::uint8_t {
    constant,  ///< push constants[argument]
    variable,  ///< push the variable number `argument`
    add,
    subtract,
    multiply,
    divide,
    negate,
    power,  ///< by the integer `argument`
    sqrt,
    exp,
    log,
    sin,
    cos
  };
  Code code;
  std::int32_t argument = 0;
};

/// The grammar, blanks anywhere between words:
///   sum     = product {("+" | "-") product}
///   product = sign {("*" | "/") sign}
///   sign    = {"+" | "-"} power                      so -x^2 is -(x^2)
///   power   = atom ["^" exponent]
///   exponent = {"+" | "-"} ("(" exponent ")" | digits) ["^" exponent]
///                                                    an integer: x^2^3 is x^8
///   atom    = number | "pi" | "e" | variable | function "(" sum ")" | "(" sum ")"
///   function = "sqrt" | "exp" | "log" | "sin" | "cos"
///   number  = digits ["." [digits]] | "." digits, then [("e" | "E") ["+" | "-"] digits]
/// A variable named like a constant or a function hides it.
class Expression {
 public:
  /// Throws: ExpressionError for text outside the grammar, an exponent beyond 1000 in absolute
  ///   value, a number beyond 1e+-400 or of more than 1000 characters, or parentheses and signs
  ///   nested more than 200 deep.
  static Expression parse(std::string_view text, const std::vector<std::string>& variables);

  const std::string& text() const { return text_; }
  const std::vector<Operation>& program() const { return program_; }
  const std::vector<Constant>& constants() const { return constants_; }
  /// Where the part of the text stands that ends with step i: its bytes [begin, end).
  struct Place {
    std::uint32_t begin, end;
  };
  const std::vector<Place>& places() const { return places_; }
  std::size_t variable_count() const { return variable_count_; }
  /// No constants pi and e, no functions: rationals give rationals.
  bool rational() const;
  /// Of degree 0 or 1 in the variables as it is written: sums and multiples of them. (x*y - x*y + x
  /// is not.)
  bool affine() const;

 private:
  std::string text_;
  std::vector<Operation> program_;
  std::vector<Constant> constants_;
  std::vector<Place> places_;
  std::size_t variable_count_ = 0;
};

}  // namespace crest::kernel
