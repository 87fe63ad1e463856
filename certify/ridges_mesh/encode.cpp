// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_mesh/encode.hpp"

#include "certify/container/container.hpp"
#include "certify/container/sha256.hpp"
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

std::size_t data_size(const DataRows& rows) {
  return 8 + rows.faces.size() * kFaceSize + rows.positions.size() * kVertexSize;
}

/// Calls write(out, i) for all i below count; `take` gets what was written every few thousand.
template <class Write>
void in_pieces(std::size_t count, const TakePiece& take, const Write& write) {
  constexpr std::size_t rows = 2048;
  ByteWriter out;
  for (std::size_t i = 0; i < count; ++i) {
    write(out, i);
    if ((i + 1) % rows != 0 && i + 1 != count) continue;
    take(out.result());
    out.result().clear();
  }
}

void write_data(const DataRows& rows, const TakePiece& take) {
  ByteWriter counts;
  counts.count(rows.positions.size());
  counts.count(rows.faces.size());
  take(counts.result());
  in_pieces(rows.faces.size(), take,
            [&](ByteWriter& out, std::size_t f) { out.numbers(rows.faces[f]); });
  in_pieces(rows.positions.size(), take,
            [&](ByteWriter& out, std::size_t v) { out.numbers(rows.positions[v]); });
  in_pieces(rows.positions.size(), take,
            [&](ByteWriter& out, std::size_t v) { out.numbers(rows.monge(v)); });
}

Envelope envelope_of(const RidgesMeshCertificate& certificate, const DataRows& rows,
                     const Digest& digest) {
  return envelope({kRidgesMesh, kRidgesMeshVersion}, data_size(rows), digest,
                  [&](ByteWriter& out) { write_claims(out, certificate); });
}

}  // namespace

Digest digest_of(const DataRows& rows) {
  Sha256 hash;
  write_data(rows, [&](std::span<const std::uint8_t> piece) { hash.add(piece); });
  return hash.digest();
}

Envelope encode_envelope(RidgesMeshCertificate certificate, const DataRows& rows,
                         const Digest& digest) {
  make_canonical(certificate);
  return envelope_of(certificate, rows, digest);
}

void hand_on(const Envelope& envelope, const DataRows& rows, const TakePiece& take) {
  take(envelope.head);
  write_data(rows, take);
  take(envelope.tail);
}

Bytes encode_as_is(const RidgesMeshCertificate& certificate) {
  const MeshData& data = certificate.data;
  if (data.monge.size() != data.positions.size())
    throw std::invalid_argument("certificate: as many Monge forms as vertices are needed");
  const DataRows rows{data.faces, data.positions, [&](std::size_t v) { return data.monge[v]; }};
  const Envelope envelope = envelope_of(certificate, rows, digest_of(rows));
  Bytes bytes;
  bytes.reserve(envelope.head.size() + data_size(rows) + envelope.tail.size());
  hand_on(envelope, rows, [&](std::span<const std::uint8_t> piece) {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
  });
  return bytes;
}

Bytes encode(RidgesMeshCertificate certificate) {
  make_canonical(certificate);
  return encode_as_is(certificate);
}

}  // namespace crest::certify
