// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Small edits of lists, numbers and bytes, for mutants of certificates.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/support/random.hpp"

namespace crest::tests {

/// Drops a row, doubles one, exchanges two or turns the list; false: there is no row.
template <class Row>
bool edit_list(std::vector<Row>& rows, Random& random) {
  if (rows.empty()) return false;
  const auto i = static_cast<std::ptrdiff_t>(random() % rows.size());
  const auto j = static_cast<std::ptrdiff_t>(random() % rows.size());
  switch (random() % 4) {
    case 0:
      rows.erase(rows.begin() + i);
      break;
    case 1:
      rows.insert(rows.begin() + j, Row(rows[static_cast<std::size_t>(i)]));
      break;
    case 2:
      std::swap(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
      break;
    default:
      std::rotate(rows.begin(), rows.begin() + i, rows.end());
  }
  return true;
}

/// A small step, another bit, or anything.
template <class Integer>
void edit_number(Integer& x, Random& random) {
  switch (random() % 3) {
    case 0:
      x = static_cast<Integer>(x + (random() % 2 ? 1 : -1));
      break;
    case 1:
      x = static_cast<Integer>(x ^ static_cast<Integer>(Integer{1} << random() % (8 * sizeof x)));
      break;
    default:
      x = static_cast<Integer>(random());
  }
}

/// Another bit, another byte, the end cut off, or a byte more.
inline void edit_bytes(std::vector<std::uint8_t>& bytes, Random& random) {
  const auto at = random() % bytes.size();
  switch (random() % 4) {
    case 0:
      bytes[at] ^= static_cast<std::uint8_t>(1u << random() % 8);
      break;
    case 1:
      bytes[at] = static_cast<std::uint8_t>(random());
      break;
    case 2:
      bytes.resize(at);
      break;
    default:
      bytes.insert(bytes.begin() + static_cast<long>(at), static_cast<std::uint8_t>(random()));
  }
}

}  // namespace crest::tests
