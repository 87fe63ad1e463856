// SPDX-License-Identifier: GPL-3.0-or-later
#include "crest_modes.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <sstream>

#include "kernel/geometry/input_error.hpp"

namespace {

using crest::modes::Level;

[[noreturn]] void refuse(const std::string& word, const std::string& why) {
  throw crest::kernel::InputError("Mode " + word + ": " + why);
}

/// Digits as an integer below 10^15.
std::int64_t integer(const std::string& word, const std::string& digits) {
  std::int64_t x = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, x);
  if (error != std::errc() || stop != end || x < 0 || digits.size() > 15)
    refuse(word, "is neither a decimal nor a fraction; give p/q (at most 15 digits)");
  return x;
}

WantedMode level_of(const std::string& word, bool keep_sign) {
  std::string rest = word;
  const bool negative = rest[0] == '-';
  if (rest[0] == '-' || rest[0] == '+') rest.erase(0, 1);
  std::int64_t p = 0, q = 1;
  if (const auto slash = rest.find('/'); slash != rest.npos) {
    p = integer(word, rest.substr(0, slash));
    q = integer(word, rest.substr(slash + 1));
  } else {
    const auto dot = rest.find('.');
    const std::string fraction = dot == rest.npos ? "" : rest.substr(dot + 1);
    p = integer(word, rest.substr(0, dot) + fraction);
    for (std::size_t i = 0; i < fraction.size(); ++i) q *= 10;
  }
  if (q == 0) refuse(word, "has the denominator 0; give another");
  if (p == q) refuse(word, "degenerate tensors are curves; use Degenerate");
  if (p > q) refuse(word, "lies outside of -1 to 1; give a mode between them");
  const std::int64_t divisor = std::gcd(p, q);
  p /= divisor;
  q /= divisor;
  if (q > Level::kLargest)
    refuse(word, "its denominator in lowest terms exceeds 10^7; give a shorter one");
  return {{p, q}, keep_sign && p > 0 ? (negative ? -1 : 1) : 0};
}

}  // namespace

std::vector<WantedMode> wanted_modes(const std::string& words, bool keep_sign, bool neutral) {
  std::vector<WantedMode> all, different;
  std::string spaced = words;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  std::istringstream stream(spaced);
  for (std::string word; stream >> word;) all.push_back(level_of(word, keep_sign));
  if (neutral) all.push_back({{0, 1}, 0});
  for (const WantedMode& w : all)
    if (std::find(different.begin(), different.end(), w) == different.end()) different.push_back(w);
  return different;
}
