// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The data section of a field of tensors on tetrahedra, one for all claims about it: counts of
// vertices and tetrahedra, corners, positions, tensors.
#include <span>

#include "certify/container/byte_writer.hpp"
#include "certify/container/plain_numbers.hpp"

namespace crest::certify {

/// Requires of a certificate: points, tets, tensors.
template <class Certificate>
void write_tensor_data(ByteWriter& out, const Certificate& c) {
  out.count(c.points.size());
  out.count(c.tets.size());
  for (const auto& tet : c.tets)
    for (const auto corner : tet) out.integer(corner);
  out.rows(c.points);
  out.rows(c.tensors);
}
template <class Certificate>
std::size_t tensor_data_size(const Certificate& c) {
  return 8 + 16 * c.tets.size() + 24 * c.points.size() + 48 * c.tensors.size();
}

/// Throws Malformed.
template <class Certificate>
void read_tensor_data(std::span<const std::uint8_t> data, Certificate& c) {
  ByteReader reader(data);
  const std::size_t vertices = reader.integer<std::uint32_t>();
  const std::size_t tets = reader.integer<std::uint32_t>();
  reader.rows(c.tets, tets);
  reader.rows(c.points, vertices);
  require_plain_rows(c.points, "positions");
  reader.rows(c.tensors, vertices);
  require_plain_rows(c.tensors, "tensors");
  if (reader.left() != 0) throw Malformed("data section: bytes left over");
}

}  // namespace crest::certify
