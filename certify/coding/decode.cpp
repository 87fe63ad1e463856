// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/coding/decode.hpp"

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {

CodingCertificate decode_coding(std::span<const std::uint8_t> data,
                                std::span<const std::uint8_t> claims) {
  CodingCertificate c;
  ByteReader reader(data);
  const std::uint64_t vertices = reader.integer<std::uint32_t>();
  const std::uint64_t faces = reader.integer<std::uint32_t>();
  c.dropped = reader.integer<std::uint32_t>();
  if (vertices * 24 + faces * kFaceSize != reader.left())
    throw Malformed("data section: the counts do not fit its length");
  if (vertices < 3 || faces < 1) throw Malformed("data section: no mesh");
  if (3 * faces > 0xfffffffeU) throw Malformed("data section: more faces than the format numbers");
  reader.rows(c.faces, faces);
  reader.rows(c.positions, vertices);
  for (const auto& point : c.positions)
    for (const std::uint64_t pattern : point)
      if ((pattern >> 52 & 0x7ff) == 0x7ff)
        throw Malformed("positions: a number is infinite or NaN");

  reader = ByteReader(claims);
  const auto mode = reader.integer<std::uint8_t>(), keep = reader.integer<std::uint8_t>();
  if (mode > 2 || keep > 1) throw Malformed("claim section: no such mode");
  c.mode = static_cast<CodingMode>(mode);
  c.keep_order = keep == 1;
  std::vector<double> tolerance;
  reader.words(tolerance, 1);
  require_plain(is_plain(std::bit_cast<std::uint64_t>(tolerance[0])), "tolerance");
  c.tolerance = tolerance[0];
  for (auto* number : {&c.components, &c.handles, &c.loops})
    *number = reader.integer<std::uint32_t>();
  const auto stream = reader.take(reader.integer<std::uint32_t>());
  c.stream.assign(stream.begin(), stream.end());
  reader.words(c.permutation, vertices);
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
