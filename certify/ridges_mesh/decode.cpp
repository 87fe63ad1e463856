// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_mesh/decode.hpp"

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {
namespace {

PatchRecord read_patch(ByteReader& reader) {
  PatchRecord patch{};
  patch.centre = reader.integer<std::uint32_t>();
  patch.twice_index = reader.integer<std::int8_t>();
  patch.kind = reader.integer<std::uint8_t>();
  patch.coherent = reader.integer<std::uint8_t>();
  const std::size_t faces = reader.integer<std::uint32_t>();
  if (faces > reader.left() / 4) throw Malformed("patches: more faces than bytes");
  patch.faces.resize(faces);
  for (auto& face : patch.faces) face = reader.integer<std::uint32_t>();
  return patch;
}

RidgeRecord read_ridge(ByteReader& reader) {
  RidgeRecord ridge{};
  ridge.flags = reader.integer<std::uint8_t>();
  const std::size_t nodes = reader.integer<std::uint32_t>();
  for (std::size_t end = 0; end < 2; ++end) {
    ridge.end_kind[end] = reader.integer<std::uint8_t>();
    ridge.end_patch[end] = reader.integer<std::uint32_t>();
  }
  if (nodes > reader.left() / 5) throw Malformed("ridges: more nodes than bytes");
  ridge.nodes.resize(nodes);
  for (auto& node : ridge.nodes) {
    node.edge = reader.integer<std::uint32_t>();
    node.type = reader.integer<std::uint8_t>();
  }
  return ridge;
}

}  // namespace

MeshData decode_data(std::span<const std::uint8_t> bytes) {
  ByteReader reader(bytes);
  const std::uint64_t vertices = reader.integer<std::uint32_t>();
  const std::uint64_t faces = reader.integer<std::uint32_t>();
  // Both factors are below 2^32, so nothing overflows.
  if (vertices * kVertexSize + faces * kFaceSize != reader.left())
    throw Malformed("data section: vertex and face counts do not fit its length");
  if (vertices < 3 || faces < 1) throw Malformed("data section: no mesh");
  if (3 * faces > 0xfffffffeU) throw Malformed("data section: more faces than the format numbers");
  MeshData data;
  reader.rows(data.faces, faces);
  reader.rows(data.positions, vertices);
  reader.rows(data.monge, vertices);
  require_plain_rows(data.positions, "positions");
  require_plain_rows(data.monge, "Monge data");
  return data;
}

void decode_claims(std::span<const std::uint8_t> bytes, RidgesMeshCertificate& certificate) {
  ByteReader reader(bytes);
  certificate.euler_characteristic = reader.integer<std::int32_t>();
  certificate.boundary_loops = reader.integer<std::uint32_t>();
  certificate.twice_index_sum = reader.integer<std::int32_t>();
  certificate.conflict_triangles = reader.integer<std::uint32_t>();
  certificate.ambiguous_edges = reader.integer<std::uint32_t>();
  for (auto& zeros : certificate.zero_extremalities) zeros = reader.integer<std::uint32_t>();
  for (auto* number :
       {&certificate.against_faces, &certificate.equal_curvatures, &certificate.parallel_frames})
    *number = reader.integer<std::uint32_t>();
  const std::size_t indices = reader.integer<std::uint32_t>();
  if (indices > reader.left() / 5) throw Malformed("face indices: more records than bytes");
  certificate.face_indices.resize(indices);
  for (auto& record : certificate.face_indices) {
    record.face = reader.integer<std::uint32_t>();
    record.twice_index = reader.integer<std::int8_t>();
  }
  const std::size_t patches = reader.integer<std::uint32_t>();
  if (patches > reader.left() / 11) throw Malformed("patches: more records than bytes");
  certificate.patches.clear();
  for (std::size_t i = 0; i < patches; ++i) certificate.patches.push_back(read_patch(reader));
  std::uint64_t ridges = 0;
  for (auto& count : certificate.counts) ridges += count = reader.integer<std::uint32_t>();
  if (ridges > reader.left() / 15) throw Malformed("ridges: more records than bytes");
  certificate.ridges.clear();
  for (std::uint64_t i = 0; i < ridges; ++i) certificate.ridges.push_back(read_ridge(reader));
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
}

}  // namespace crest::certify
