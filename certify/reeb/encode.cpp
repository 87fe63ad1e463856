// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/reeb/encode.hpp"

#include "certify/container/compose.hpp"
#include "certify/container/container.hpp"

namespace crest::certify {
namespace {

void write_reeb_data(ByteWriter& out, const ReebCertificate& c) {
  out.count(c.positions.size());
  out.count(c.faces.size());
  out.integer(static_cast<std::uint8_t>(c.edge_values.empty() ? 1 : 2));
  out.rows(c.faces);
  out.rows(c.positions);
  out.numbers(c.values);
  out.numbers(c.edge_values);
}

void write_reeb_claims(ByteWriter& out, const ReebCertificate& c) {
  out.integer(c.euler_characteristic);
  for (const auto number : {c.boundary_loops, c.components, c.line_critical, c.face_critical,
                            c.tiles, c.minima, c.saddles, c.maxima})
    out.integer(number);
  out.numbers(c.order);
  out.count(c.critical_nodes.size());
  out.numbers(c.critical_nodes);
  out.count(c.arcs.size());
  for (const ArcRecord& arc : c.arcs) {
    out.integer(arc.lower);
    out.integer(arc.upper);
  }
  out.count(c.cuts.size());
  for (const CutRecord& cut : c.cuts) {
    out.integer(cut.arc);
    out.integer(cut.node);
  }
  out.integer(c.tied_arcs);
  out.integer(c.contracted_nodes);
}

}  // namespace

Bytes encode(const ReebCertificate& certificate) {
  const std::size_t vertices = certificate.positions.size();
  if (certificate.values.size() != vertices)
    throw std::invalid_argument("certificate: as many values as vertices are needed");
  if (certificate.order.size() !=
      vertices + std::size_t{certificate.line_critical} + certificate.face_critical)
    throw std::invalid_argument("certificate: the order must hold every node");
  const std::size_t data_size = 9 + certificate.faces.size() * kFaceSize +
                                vertices * 4 * sizeof(double) +
                                certificate.edge_values.size() * sizeof(double);
  return compose(
      {kReeb, kReebVersion}, data_size, [&](ByteWriter& out) { write_reeb_data(out, certificate); },
      [&](ByteWriter& out) { write_reeb_claims(out, certificate); });
}

}  // namespace crest::certify
