// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Binary files made in tests.
#include <algorithm>
#include <cstring>
#include <string>

namespace crest::tests {

/// Appends the number's bytes.
template <class T>
void put(std::string& bytes, T number, bool big_endian = false) {
  char at[sizeof number];
  std::memcpy(at, &number, sizeof number);
  if (big_endian) std::reverse(at, at + sizeof number);
  bytes.append(at, sizeof number);
}

}  // namespace crest::tests
