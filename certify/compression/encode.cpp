// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/compression/encode.hpp"

#include "certify/container/compose.hpp"
#include "certify/skeleton/encode.hpp"

namespace crest::certify {
namespace {

void check_output(const CompressionCertificate& c) {
  const std::size_t n = c.vertices.size();
  if (c.output.positions.size() != n || c.output.vectors.size() != n)
    throw std::invalid_argument("certificate: the output's vertices are not those named");
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t v = c.vertices[i];
    if (v >= c.input.positions.size() || v >= c.input.vectors.size() ||
        c.output.positions[i] != c.input.positions[v] || c.output.vectors[i] != c.input.vectors[v])
      throw std::invalid_argument("certificate: a vertex of the output is not the input's");
  }
}

void write_claims(ByteWriter& out, const CompressionCertificate& c) {
  out.integer(static_cast<std::uint8_t>(c.notion));
  for (const auto* map : {&c.zeros, &c.orbits, &c.separatrices}) {
    out.count(map->size());
    out.numbers(*map);
  }
  ByteWriter input;
  write_skeleton_claims(input, c.input);
  out.integer(std::uint64_t{input.size()});
  out.bytes(input.result());
  write_skeleton_claims(out, c.output);
}

}  // namespace

Bytes encode(const CompressionCertificate& c) {
  check_output(c);
  const std::size_t size =
      skeleton_data_size(c.input) + 8 + c.vertices.size() * 4 + c.output.triangles.size() * 12;
  const auto write_data = [&](ByteWriter& out) {
    write_skeleton_data(out, c.input);
    out.count(c.vertices.size());
    out.count(c.output.triangles.size());
    out.numbers(c.vertices);
    out.rows(c.output.triangles);
  };
  return compose({kCompression, kCompressionVersion}, size, write_data,
                 [&](ByteWriter& out) { write_claims(out, c); });
}

}  // namespace crest::certify
