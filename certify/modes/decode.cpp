// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/decode.hpp"

#include "certify/container/plain_numbers.hpp"
#include "certify/surface/tensor_data.hpp"

namespace crest::certify {
namespace {

double read_number(ByteReader& reader) {
  const auto bits = reader.integer<std::uint64_t>();
  require_plain(is_plain(bits), "claim section");
  return std::bit_cast<double>(bits);
}

void read(ByteReader& reader, RootRecord& root) {
  root.low = read_number(reader);
  root.high = read_number(reader);
  root.level = reader.integer<std::int8_t>();
}
void read(ByteReader& reader, FaceWitness& witness) {
  for (auto& w : witness.w) w = reader.integer<std::int16_t>();
  witness.lambda = read_number(reader);
}
void read(ByteReader& reader, ArcPair& arc) {
  arc.first = reader.integer<std::uint8_t>();
  arc.second = reader.integer<std::uint8_t>();
}
void read(ByteReader& reader, TetWitness& witness) {
  for (auto& w : witness.w) w = reader.integer<std::int16_t>();
  witness.lambda = read_number(reader);
  for (auto& count : witness.pieces) count = reader.integer<std::uint8_t>();
}
void read(ByteReader& reader, SurfaceComponent& component) {
  component.euler_characteristic = reader.integer<std::int32_t>();
  component.boundary_loops = reader.integer<std::uint32_t>();
}

void read(ByteReader& reader, double& place) {
  place = read_number(reader);
}
void read(ByteReader& reader, std::uint16_t& count) {
  count = reader.integer<std::uint16_t>();
}
void read(ByteReader& reader, std::array<double, 2>& weights) {
  for (double& w : weights) w = read_number(reader);
}

void read(ByteReader& reader, InnerVertex& vertex) {
  vertex.witness = reader.integer<std::uint32_t>();
  vertex.level = reader.integer<std::int8_t>();
  for (double& w : vertex.weights) w = read_number(reader);
}

/// A record takes at least `size` bytes: no length is believed before it is compared.
template <class Record>
void read_list(ByteReader& reader, std::vector<Record>& list, std::size_t size) {
  const std::size_t count = reader.integer<std::uint32_t>();
  if (count > reader.left() / size)
    throw Malformed("claim section: a list is longer than its bytes");
  list.resize(count);
  for (Record& record : list) read(reader, record);
}

void read_counts(ByteReader& reader, SurfaceCounts& counts) {
  read_list(reader, counts.components, 8);
  counts.touched = reader.integer<std::uint32_t>();
}

/// Corners of edges or faces.
template <class Rows>
void read_rows(ByteReader& reader, Rows& rows) {
  const std::size_t count = reader.integer<std::uint32_t>();
  if (count > 0) reader.rows(rows, count);
}

void read_level(ByteReader& reader, ModeLevel& level) {
  level.numerator = reader.integer<std::uint64_t>();
  level.denominator = reader.integer<std::uint64_t>();
  read_rows(reader, level.edges);
  read_rows(reader, level.faces);
  reader.words(level.tets, reader.integer<std::uint32_t>());
  const auto codes = reader.take(reader.integer<std::uint32_t>());
  level.codes.assign(codes.begin(), codes.end());
  read_list(reader, level.roots, 17);
  read_list(reader, level.face_witnesses, 12);
  read_list(reader, level.arcs, 2);
  read_list(reader, level.tet_witnesses, 16);
  read_counts(reader, level.positive);
  if (level.numerator != 0) read_counts(reader, level.negative);
  level.open_tets = reader.integer<std::uint32_t>();
  read_list(reader, level.root_places, 8);
  read_list(reader, level.arc_points, 2);
  read_list(reader, level.points, 16);
  read_list(reader, level.inner, 29);
  level.placed = reader.integer<std::uint32_t>();
  level.not_placed = reader.integer<std::uint32_t>();
  level.near = reader.integer<std::uint32_t>();
}

/// Bytes of a level whose lists are empty.
constexpr std::size_t kEmptyLevel = 16 + 8 * 4 + 8 + 4 + 4 * 4 + 12;

}  // namespace

ModesCertificate decode_modes(std::span<const std::uint8_t> data,
                              std::span<const std::uint8_t> claims) {
  ModesCertificate c;
  read_tensor_data(data, c);
  ByteReader reader(claims);
  const std::size_t zeros = reader.integer<std::uint32_t>();
  if (zeros > reader.left() / 9) throw Malformed("zeros: longer than their bytes");
  c.zeros.resize(zeros);
  for (ZeroRecord& zero : c.zeros) {
    const unsigned corners = reader.integer<std::uint8_t>();
    if (corners < 2 || corners > 4) throw Malformed("zeros: neither 2, 3 nor 4 corners");
    reader.words(zero.corners, corners);
  }
  const std::size_t levels = reader.integer<std::uint32_t>();
  if (levels > reader.left() / kEmptyLevel) throw Malformed("levels: longer than their bytes");
  c.levels.resize(levels);
  for (ModeLevel& level : c.levels) read_level(reader, level);
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
