// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/tensor_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/formats/files.hpp"

namespace crest::io {

std::array<std::size_t, 6> tensor_places(const std::string& order) {
  static const std::map<std::string, std::size_t> words = {{"xx", 0}, {"yy", 1}, {"zz", 2},
                                                           {"xy", 3}, {"yx", 3}, {"yz", 4},
                                                           {"zy", 4}, {"xz", 5}, {"zx", 5}};
  std::array<std::size_t, 6> r;
  r.fill(6);
  std::string text = order;
  std::replace(text.begin(), text.end(), ',', ' ');
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    const auto found = words.find(word);
    if (found == words.end() || r[found->second] != 6 || count == 6)
      fail("order", fmt::format("'{}' is none", order.substr(0, 60)),
           "name xx yy zz xy yz xz once each");
    r[found->second] = count++;
  }
  if (count != 6)
    fail("order", fmt::format("'{}' is none", order.substr(0, 60)),
         "name xx yy zz xy yz xz once each");
  return r;
}

std::array<double, 6> tensor_of(std::span<const double> numbers,
                                const std::array<std::size_t, 6>& places, double& asymmetry) {
  std::array<double, 6> t{};
  if (numbers.size() == 6) {
    for (std::size_t k = 0; k < 6; ++k) t[k] = numbers[places[k]];
    return t;
  }
  constexpr std::size_t upper[6] = {0, 4, 8, 1, 5, 2}, lower[6] = {0, 4, 8, 3, 7, 6};
  for (std::size_t k = 0; k < 6; ++k) {
    const double a = numbers[upper[k]], b = numbers[lower[k]];
    t[k] = a == b ? a : 0.5 * a + 0.5 * b;
    asymmetry = std::fmax(asymmetry, std::fabs(a - b));
  }
  return t;
}

}  // namespace crest::io
