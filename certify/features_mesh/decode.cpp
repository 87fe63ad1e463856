// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/features_mesh/decode.hpp"

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {
namespace {

void read_list(ByteReader& reader, std::vector<std::uint32_t>& list, const char* what) {
  const std::size_t count = reader.integer<std::uint32_t>();
  if (count > reader.left() / 4) throw Malformed(std::string(what) + ": longer than its bytes");
  list.resize(count);
  for (auto& item : list) item = reader.integer<std::uint32_t>();
}

}  // namespace

FeaturesMeshCertificate decode_features_mesh(std::span<const std::uint8_t> data,
                                             std::span<const std::uint8_t> claims) {
  FeaturesMeshCertificate c;
  ByteReader reader(data);
  const std::uint64_t vertices = reader.integer<std::uint32_t>();
  const std::uint64_t faces = reader.integer<std::uint32_t>();
  if (vertices * (3 * sizeof(double) + 1) + faces * kFaceSize != reader.left())
    throw Malformed("data section: vertex and face counts do not fit its length");
  if (vertices < 3 || faces < 1) throw Malformed("data section: no mesh");
  if (3 * faces > 0xfffffffeU) throw Malformed("data section: more faces than the format numbers");
  reader.rows(c.faces, faces);
  reader.rows(c.positions, vertices);
  require_plain_rows(c.positions, "positions");
  const auto marks = reader.take(vertices);
  c.marked_before.assign(marks.begin(), marks.end());
  for (const auto mark : c.marked_before)
    if (mark > 1) throw Malformed("marks: one is neither 0 nor 1");

  reader = ByteReader(claims);
  c.euler_characteristic = reader.integer<std::int32_t>();
  c.boundary_loops = reader.integer<std::uint32_t>();
  read_list(reader, c.removed, "removed vertices");
  read_list(reader, c.marked_after, "marked vertices");
  read_list(reader, c.dropped, "dropped vertices");
  c.components = reader.integer<std::uint32_t>();
  for (BettiRecord& b : c.betti) {
    b.euler = reader.integer<std::int32_t>();
    b.components = reader.integer<std::uint32_t>();
    b.loops = reader.integer<std::uint32_t>();
    b.closed = reader.integer<std::uint32_t>();
  }
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
