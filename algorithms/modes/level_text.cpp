// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/level_text.hpp"

#include <charconv>
#include <numeric>
#include <stdexcept>

namespace crest::modes {
namespace {

[[noreturn]] void bad_mode(const std::string& text, const char* why) {
  throw std::invalid_argument(text + ": " + why);
}

/// Digits as an integer below 10^15.
std::int64_t integer(const std::string& text, const std::string& digits) {
  std::int64_t x = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), x);
  if (error != std::errc() || end != digits.data() + digits.size() || x < 0 || digits[0] == '+' ||
      digits.size() > 15)
    bad_mode(text, "is neither a decimal nor a fraction p/q (at most 15 digits)");
  return x;
}

}  // namespace

SignedLevel parse_level(const std::string& text) {
  std::string rest = text;
  const bool negative = !rest.empty() && rest[0] == '-';
  if (!rest.empty() && (rest[0] == '-' || rest[0] == '+')) rest.erase(0, 1);
  std::int64_t p = 0, q = 1;
  if (const auto slash = rest.find('/'); slash != std::string::npos) {
    p = integer(text, rest.substr(0, slash));
    q = integer(text, rest.substr(slash + 1));
  } else {
    const auto dot = rest.find('.');
    const std::string fraction = dot == std::string::npos ? "" : rest.substr(dot + 1);
    p = integer(text, rest.substr(0, dot) + fraction);
    for (std::size_t i = 0; i < fraction.size(); ++i) q *= 10;
  }
  if (q == 0) bad_mode(text, "has the denominator 0");
  if (p == q) bad_mode(text, "degenerate tensors are curves: use --degenerate");
  if (p > q) bad_mode(text, "modes lie between -1 and 1");
  const std::int64_t divisor = std::gcd(p, q);
  p /= divisor;
  q /= divisor;
  if (q > Level::kLargest) bad_mode(text, "its denominator in lowest terms exceeds 10^7");
  return {{p, q}, p == 0 ? 0 : negative ? -1 : 1};
}

}  // namespace crest::modes
