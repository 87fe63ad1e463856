// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_mesh/encode.hpp"

#include "certify/container/compose.hpp"
#include "certify/container/container.hpp"
#include "certify/ridges_mesh/canonical.hpp"

namespace crest::certify {
namespace {

void write_ridge(ByteWriter& out, const RidgeRecord& ridge) {
  out.integer(ridge.flags);
  out.count(ridge.nodes.size());
  for (std::size_t end = 0; end < 2; ++end) {
    out.integer(ridge.end_kind[end]);
    out.integer(ridge.end_patch[end]);
  }
  for (const auto& node : ridge.nodes) {
    out.integer(node.edge);
    out.integer(node.type);
  }
}

void write_claims(ByteWriter& out, const RidgesMeshCertificate& c) {
  out.integer(c.euler_characteristic);
  out.integer(c.boundary_loops);
  out.integer(c.twice_index_sum);
  out.integer(c.conflict_triangles);
  out.integer(c.ambiguous_edges);
  for (const auto zeros : c.zero_extremalities) out.integer(zeros);
  for (const auto number : {c.against_faces, c.equal_curvatures, c.parallel_frames})
    out.integer(number);
  out.count(c.face_indices.size());
  for (const auto& record : c.face_indices) {
    out.integer(record.face);
    out.integer(record.twice_index);
  }
  out.count(c.patches.size());
  for (const auto& patch : c.patches) {
    out.integer(patch.centre);
    out.integer(patch.twice_index);
    out.integer(patch.kind);
    out.integer(patch.coherent);
    out.count(patch.faces.size());
    for (const auto face : patch.faces) out.integer(face);
  }
  for (const auto count : c.counts) out.integer(count);
  for (const auto& ridge : c.ridges) write_ridge(out, ridge);
}

}  // namespace

EncodedData encode_data(const MeshData& data) {
  if (data.monge.size() != data.positions.size())
    throw std::invalid_argument("certificate: as many Monge forms as vertices are needed");
  return encode_data(data.faces, data.positions, [&](std::size_t v) { return data.monge[v]; });
}

EncodedData encode_data(const std::vector<std::array<std::uint32_t, 3>>& faces,
                        const std::vector<std::array<double, 3>>& positions,
                        const std::function<std::array<double, 14>(std::size_t)>& monge) {
  const std::size_t size = 8 + faces.size() * kFaceSize + positions.size() * kVertexSize;
  return begin({kRidgesMesh, kRidgesMeshVersion}, size, [&](ByteWriter& out) {
    out.count(positions.size());
    out.count(faces.size());
    out.rows(faces);
    out.rows(positions);
    for (std::size_t v = 0; v < positions.size(); ++v) out.numbers(monge(v));
  });
}

Bytes encode_as_is(const RidgesMeshCertificate& certificate) {
  return finish(encode_data(certificate.data),
                [&](ByteWriter& out) { write_claims(out, certificate); });
}

Bytes encode(RidgesMeshCertificate certificate) {
  make_canonical(certificate);
  return encode_as_is(certificate);
}

Bytes encode(RidgesMeshCertificate certificate, EncodedData data) {
  make_canonical(certificate);
  return finish(std::move(data), [&](ByteWriter& out) { write_claims(out, certificate); });
}

}  // namespace crest::certify
