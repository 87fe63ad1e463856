// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/container/container.hpp"

#include <algorithm>

#include "certify/container/byte_reader.hpp"
#include "certify/container/sha256.hpp"

namespace crest::certify {
namespace {

/// Neither infinite, NaN nor -0, by bits: independent of flags and of the rounding mode.
bool is_plain(std::uint64_t bits) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63, kExponent = std::uint64_t{0x7ff} << 52;
  return ((bits & kExponent) != kExponent) & (bits != kSign);
}
bool is_plain(double x) {
  return is_plain(std::bit_cast<std::uint64_t>(x));
}

template <class Row>
void require_plain_numbers(const std::vector<Row>& rows, const char* what) {
  bool good = true;
  for (const Row& row : rows)
    for (const double x : row) good = is_plain(x) && good;
  if (!good) throw Malformed(std::string(what) + ": a number is infinite, NaN or -0");
}

/// Of doubles as they stand in the bytes.
void require_plain_bytes(std::span<const std::uint8_t> bytes, const char* what) {
  bool good = true;
  if constexpr (std::endian::native == std::endian::little) {
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(double)) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, bytes.data() + i, sizeof bits);
      good &= is_plain(bits);
    }
  } else {
    for (ByteReader reader(bytes); reader.left() != 0;)
      good &= is_plain(reader.integer<std::uint64_t>());
  }
  if (!good) throw Malformed(std::string(what) + ": a number is infinite, NaN or -0");
}

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

void read_list(ByteReader& reader, std::vector<std::uint32_t>& list, const char* what) {
  const std::size_t count = reader.integer<std::uint32_t>();
  if (count > reader.left() / 4) throw Malformed(std::string(what) + ": longer than its bytes");
  list.resize(count);
  for (auto& item : list) item = reader.integer<std::uint32_t>();
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

Digest Container::data_digest() const {
  return sha256({data});
}

Digest Container::seal() const {
  return sha256({header, claims});
}

Container open_container(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderSize + kSealSize) throw Malformed("shorter than a header and a seal");
  ByteReader reader(bytes);
  const auto magic = reader.take(kMagic.size());
  if (!std::equal(magic.begin(), magic.end(), kMagic.begin()))
    throw Malformed("not a certificate (magic)");
  Container c{};
  c.version = reader.integer<std::uint32_t>();
  c.claim = reader.integer<std::uint32_t>();
  const auto digest = reader.take(kSealSize);
  std::copy(digest.begin(), digest.end(), c.stated_data_digest.begin());
  const auto data = reader.integer<std::uint64_t>(), claims = reader.integer<std::uint64_t>();
  const std::uint64_t room = bytes.size() - kHeaderSize - kSealSize;
  if (data > room || claims != room - data) throw Malformed("section lengths do not fit the file");
  c.header = bytes.first(kHeaderSize);
  c.data = reader.take(static_cast<std::size_t>(data));
  c.claims = reader.take(static_cast<std::size_t>(claims));
  const auto seal = reader.take(kSealSize);
  std::copy(seal.begin(), seal.end(), c.stated_seal.begin());
  return c;
}

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
  require_plain_numbers(data.positions, "positions");
  require_plain_numbers(data.monge, "Monge data");
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
  require_plain_numbers(c.positions, "positions");
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
  for (BettiRecord& b : c.betti) {
    b.euler = reader.integer<std::int32_t>();
    b.components = reader.integer<std::uint32_t>();
    b.loops = reader.integer<std::uint32_t>();
    b.closed = reader.integer<std::uint32_t>();
  }
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

namespace {

void read_reeb_data(std::span<const std::uint8_t> data, ReebContents& c) {
  ByteReader reader(data);
  const std::uint64_t vertices = reader.integer<std::uint32_t>();
  const std::uint64_t faces = reader.integer<std::uint32_t>();
  const unsigned degree = reader.integer<std::uint8_t>();
  if (degree != 1 && degree != 2) throw Malformed("data section: the degree is neither 1 nor 2");
  const std::uint64_t fixed = vertices * 4 * sizeof(double) + faces * kFaceSize;
  if (fixed > reader.left()) throw Malformed("data section: shorter than its mesh");
  const std::uint64_t rest = reader.left() - fixed;
  if (degree == 1 ? rest != 0 : rest == 0 || rest % sizeof(double) != 0)
    throw Malformed("data section: vertex and face counts do not fit its length");
  if (vertices < 3 || faces < 1) throw Malformed("data section: no mesh");
  if (3 * faces > 0xfffffffeU) throw Malformed("data section: more faces than the format numbers");
  c.vertices = vertices;
  reader.rows(c.faces, faces);
  c.positions = reader.take(vertices * 3 * sizeof(double));
  const auto values = reader.take(vertices * sizeof(double)), edges = reader.take(rest);
  require_plain_bytes(c.positions, "positions");
  require_plain_bytes(values, "values");
  require_plain_bytes(edges, "midpoint values");
  ByteReader(values).words(c.values, vertices);
  ByteReader(edges).words(c.edge_values, rest / sizeof(double));
}

template <class Pairs>
void read_pairs(ByteReader& reader, Pairs& pairs, const char* too_long) {
  const std::size_t count = reader.integer<std::uint32_t>();
  if (count > reader.left() / 8) throw Malformed(too_long);
  pairs.resize(count);
  for (auto& [first, second] : pairs) {
    first = reader.integer<std::uint32_t>();
    second = reader.integer<std::uint32_t>();
  }
}

}  // namespace

ReebContents open_reeb(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims) {
  ReebContents c;
  read_reeb_data(data, c);
  ByteReader reader(claims);
  c.euler_characteristic = reader.integer<std::int32_t>();
  for (auto* number : {&c.boundary_loops, &c.components, &c.line_critical, &c.face_critical,
                       &c.tiles, &c.minima, &c.saddles, &c.maxima})
    *number = reader.integer<std::uint32_t>();
  const std::uint64_t nodes = c.vertices + std::uint64_t{c.line_critical} + c.face_critical;
  if (nodes > reader.left() / 4) throw Malformed("order: longer than its bytes");
  reader.words(c.order, nodes);
  reader.words(c.critical_nodes, reader.integer<std::uint32_t>());
  read_pairs(reader, c.arcs, "arcs: longer than their bytes");
  read_pairs(reader, c.cuts, "cuts: longer than their bytes");
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

ReebCertificate decode_reeb(std::span<const std::uint8_t> data,
                            std::span<const std::uint8_t> claims) {
  const ReebContents from = open_reeb(data, claims);
  const auto copy = [](const auto& list, auto& to) { to.assign(list.begin(), list.end()); };
  ReebCertificate c;
  copy(from.faces, c.faces);
  ByteReader(from.positions).rows(c.positions, from.vertices);
  copy(from.values, c.values);
  copy(from.edge_values, c.edge_values);
  c.euler_characteristic = from.euler_characteristic;
  c.boundary_loops = from.boundary_loops, c.components = from.components;
  c.line_critical = from.line_critical, c.face_critical = from.face_critical;
  c.tiles = from.tiles;
  c.minima = from.minima, c.saddles = from.saddles, c.maxima = from.maxima;
  copy(from.order, c.order);
  copy(from.critical_nodes, c.critical_nodes);
  copy(from.arcs, c.arcs);
  copy(from.cuts, c.cuts);
  return c;
}

}  // namespace crest::certify
