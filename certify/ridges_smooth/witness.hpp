// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A witness string read from its beginning to its end (SPEC.md, "Witnesses").
#include <bit>
#include <cmath>
#include <span>

#include "certify/container/reject.hpp"

namespace crest::certify::smooth {

class WitnessReader {
 public:
  /// `what`, `number`: whose it is, for messages.
  WitnessReader(std::span<const std::uint8_t> bytes, const char* what, std::size_t number)
      : left_(bytes), what_(what), number_(number) {}

  unsigned byte() { return static_cast<unsigned>(integer(1)); }
  double f32() {
    return checked(double{std::bit_cast<float>(static_cast<std::uint32_t>(integer(4)))});
  }
  double f64() { return checked(std::bit_cast<double>(integer(8))); }
  /// Throws Reject unless all of it is read.
  void end() const { check(left_.empty(), "has bytes left over"); }
  /// Throws Reject unless the condition holds: the witness `problem`.
  void check(bool condition, const char* problem) const {
    require(condition, "{} {}: its witness {}", what_, number_, problem);
  }
  /// Throws Undecided: what the witness says could not be shown.
  [[noreturn]] void fail(const std::string& statement) const {
    throw Undecided(fmt::format("{} {}: {}", what_, number_, statement));
  }

 private:
  std::uint64_t integer(std::size_t bytes) {
    check(left_.size() >= bytes, "ends early");
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value |= std::uint64_t{left_[i]} << (8 * i);
    left_ = left_.subspan(bytes);
    return value;
  }
  double checked(double x) const {
    check(std::isfinite(x) && !(x == 0 && std::signbit(x)), "has a number that is not plain");
    return x;
  }

  std::span<const std::uint8_t> left_;
  const char* what_;
  std::size_t number_;
};

}  // namespace crest::certify::smooth
