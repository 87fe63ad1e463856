// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/compression/decode.hpp"

#include "certify/skeleton/decode.hpp"

namespace crest::certify {
namespace {

void read_output(ByteReader& reader, CompressionCertificate& c) {
  const std::uint64_t vertices = reader.integer<std::uint32_t>();
  const std::uint64_t triangles = reader.integer<std::uint32_t>();
  if (vertices * 4 + triangles * 12 != reader.left())
    throw Malformed("data section: vertex and triangle counts do not fit its length");
  if (vertices < 3 || triangles < 1) throw Malformed("data section: no mesh");
  if (3 * triangles > 0xfffffffeU)
    throw Malformed("data section: more triangles than the format numbers");
  reader.words(c.vertices, vertices);
  reader.rows(c.output.triangles, triangles);
  for (std::size_t i = 0; i < c.vertices.size(); ++i) {
    const std::uint32_t v = c.vertices[i];
    if (v >= c.input.positions.size() || (i > 0 && v <= c.vertices[i - 1]))
      throw Malformed("data section: vertices of the output that do not ascend");
    c.output.positions.push_back(c.input.positions[v]);
    c.output.vectors.push_back(c.input.vectors[v]);
  }
}

void read_map(ByteReader& reader, std::vector<std::uint32_t>& map) {
  const std::size_t count = reader.integer<std::uint32_t>();
  if (count > reader.left() / 4) throw Malformed("claim section: a list is longer than its bytes");
  reader.words(map, count);
}

}  // namespace

CompressionCertificate decode_compression(std::span<const std::uint8_t> data,
                                          std::span<const std::uint8_t> claims) {
  CompressionCertificate c;
  ByteReader fields(data);
  read_skeleton_data(fields, c.input);
  read_output(fields, c);
  ByteReader reader(claims);
  const auto notion = reader.integer<std::uint8_t>();
  if (notion > static_cast<std::uint8_t>(SkeletonNotion::relaxed))
    throw Malformed("claim section: no such code");
  c.notion = static_cast<SkeletonNotion>(notion);
  for (auto* map : {&c.zeros, &c.orbits, &c.separatrices}) read_map(reader, *map);
  const auto size = reader.integer<std::uint64_t>();
  if (size > reader.left()) throw Malformed("claim section ends early");
  ByteReader input(reader.take(size));
  read_skeleton_claims(input, c.input);
  read_skeleton_claims(reader, c.output);
  if (input.left() != 0 || reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
