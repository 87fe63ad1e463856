// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The doubles a certificate may hold.
#include "certify/container/byte_reader.hpp"

namespace crest::certify {

/// Neither infinite, NaN nor -0, by bits: independent of flags and of the rounding mode.
inline bool is_plain(std::uint64_t bits) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63, kExponent = std::uint64_t{0x7ff} << 52;
  return ((bits & kExponent) != kExponent) & (bits != kSign);
}

inline void require_plain(bool all, const char* what) {
  if (!all) throw Malformed(std::string(what) + ": a number is infinite, NaN or -0");
}

template <class Row>
void require_plain_rows(const std::vector<Row>& rows, const char* what) {
  bool good = true;
  for (const Row& row : rows)
    for (const double x : row) good = is_plain(std::bit_cast<std::uint64_t>(x)) && good;
  require_plain(good, what);
}

}  // namespace crest::certify
