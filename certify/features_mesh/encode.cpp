// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/features_mesh/encode.hpp"

#include "certify/container/compose.hpp"
#include "certify/container/container.hpp"

namespace crest::certify {
namespace {

void write_features_data(ByteWriter& out, const FeaturesMeshCertificate& c) {
  out.count(c.positions.size());
  out.count(c.faces.size());
  out.rows(c.faces);
  out.rows(c.positions);
  out.bytes(c.marked_before);
}

void write_features_claims(ByteWriter& out, const FeaturesMeshCertificate& c) {
  out.integer(c.euler_characteristic);
  out.integer(c.boundary_loops);
  for (const auto* list : {&c.removed, &c.marked_after, &c.dropped}) {
    out.count(list->size());
    for (const auto v : *list) out.integer(v);
  }
  out.integer(c.components);
  for (const BettiRecord& b : c.betti) {
    out.integer(b.euler);
    out.integer(b.components);
    out.integer(b.loops);
    out.integer(b.closed);
  }
}

}  // namespace

Bytes encode(const FeaturesMeshCertificate& certificate) {
  if (certificate.marked_before.size() != certificate.positions.size())
    throw std::invalid_argument("certificate: as many marks as vertices are needed");
  const std::size_t data_size = 8 + certificate.faces.size() * kFaceSize +
                                certificate.positions.size() * (3 * sizeof(double) + 1);
  return compose(
      {kFeaturesMesh, kFeaturesMeshVersion}, data_size,
      [&](ByteWriter& out) { write_features_data(out, certificate); },
      [&](ByteWriter& out) { write_features_claims(out, certificate); });
}

}  // namespace crest::certify
