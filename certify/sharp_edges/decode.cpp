// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/sharp_edges/decode.hpp"

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {

SharpEdgesCertificate decode_sharp_edges(std::span<const std::uint8_t> data,
                                         std::span<const std::uint8_t> claims) {
  SharpEdgesCertificate c;
  ByteReader reader(data);
  const std::uint64_t vertices = reader.integer<std::uint32_t>();
  const std::uint64_t faces = reader.integer<std::uint32_t>();
  const std::uint64_t digits = reader.integer<std::uint32_t>();
  if (digits > kLongestAngle) throw Malformed("angle: is too long");
  if (digits + vertices * 3 * sizeof(double) + faces * kFaceSize != reader.left())
    throw Malformed("data section: the counts do not fit its length");
  if (vertices < 3 || faces < 1) throw Malformed("data section: no mesh");
  if (3 * faces > 0xfffffffeU) throw Malformed("data section: more faces than the format numbers");
  for (const std::uint8_t digit : reader.take(digits)) c.angle += static_cast<char>(digit);
  reader.rows(c.faces, faces);
  reader.rows(c.positions, vertices);
  require_plain_rows(c.positions, "positions");

  reader = ByteReader(claims);
  c.euler_characteristic = reader.integer<std::int32_t>();
  c.boundary_loops = reader.integer<std::uint32_t>();
  reader.words(c.sharp, reader.integer<std::uint32_t>());
  for (auto* number : {&c.ties, &c.ends, &c.nodes, &c.patches})
    *number = reader.integer<std::uint32_t>();
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
