// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/sharp_edges/encode.hpp"

#include "certify/container/compose.hpp"
#include "certify/container/container.hpp"

namespace crest::certify {
namespace {

void write_sharp_data(ByteWriter& out, const SharpEdgesCertificate& c) {
  out.count(c.positions.size());
  out.count(c.faces.size());
  out.count(c.angle.size());
  for (const char digit : c.angle) out.integer(static_cast<std::uint8_t>(digit));
  out.rows(c.faces);
  out.rows(c.positions);
}

void write_sharp_claims(ByteWriter& out, const SharpEdgesCertificate& c) {
  out.integer(c.euler_characteristic);
  out.integer(c.boundary_loops);
  out.count(c.sharp.size());
  out.numbers(c.sharp);
  for (const auto number : {c.ties, c.ends, c.nodes, c.patches}) out.integer(number);
}

}  // namespace

Bytes encode(const SharpEdgesCertificate& certificate) {
  const std::size_t data_size = 12 + certificate.angle.size() +
                                certificate.faces.size() * kFaceSize +
                                certificate.positions.size() * 3 * sizeof(double);
  return compose(
      {kSharpEdges, kSharpEdgesVersion}, data_size,
      [&](ByteWriter& out) { write_sharp_data(out, certificate); },
      [&](ByteWriter& out) { write_sharp_claims(out, certificate); });
}

}  // namespace crest::certify
