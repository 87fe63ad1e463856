// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/reeb/decode.hpp"

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {
namespace {

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
  require_plain(good, what);
}

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
  c.vertices = static_cast<std::size_t>(vertices);
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
  c.tied_arcs = reader.integer<std::uint32_t>();
  c.contracted_nodes = reader.integer<std::uint32_t>();
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
  c.tied_arcs = from.tied_arcs, c.contracted_nodes = from.contracted_nodes;
  return c;
}

}  // namespace crest::certify
