// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files made in tests.
#include <algorithm>
#include <cstring>
#include <string>

namespace crest::tests {

/// How numbers are stored.
enum class Storage { text, little, big };

/// Of headers of PLY.
inline const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
inline const std::string kList = "property list uchar int vertex_indices\n";

/// Appends the number's bytes.
template <class T>
void put(std::string& bytes, T number, bool big_endian = false) {
  char at[sizeof number];
  std::memcpy(at, &number, sizeof number);
  if (big_endian) std::reverse(at, at + sizeof number);
  bytes.append(at, sizeof number);
}

}  // namespace crest::tests
