// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/decode.hpp"

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {

ModesCertificate decode_modes(std::span<const std::uint8_t> data,
                              std::span<const std::uint8_t> claims) {
  ModesCertificate c;
  ByteReader reader(data);
  const std::size_t points = reader.integer<std::uint32_t>();
  const std::size_t cells = reader.integer<std::uint32_t>();
  reader.rows(c.points, points);
  require_plain_rows(c.points, "positions");
  reader.rows(c.cells, cells);
  if (reader.left() != 0) throw Malformed("data section: bytes left over");
  reader = ByteReader(claims);
  c.distinct = reader.integer<std::uint32_t>();
  c.used = reader.integer<std::uint32_t>();
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
