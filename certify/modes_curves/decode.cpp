// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes_curves/decode.hpp"

#include "certify/container/plain_numbers.hpp"
#include "certify/surface/tensor_data.hpp"

namespace crest::certify {
namespace {

template <class Rows>
void read_rows(ByteReader& reader, Rows& rows) {
  const std::size_t count = reader.integer<std::uint32_t>();
  if (count > 0) reader.rows(rows, count);
}

double read_number(ByteReader& reader) {
  const auto bits = reader.integer<std::uint64_t>();
  require_plain(is_plain(bits), "claim section");
  return std::bit_cast<double>(bits);
}

template <class Record, class Read>
void read_list(ByteReader& reader, std::vector<Record>& list, std::size_t size, const Read& read) {
  const std::size_t count = reader.integer<std::uint32_t>();
  if (count > reader.left() / size)
    throw Malformed("claim section: a list is longer than its bytes");
  list.resize(count);
  for (Record& record : list) read(record);
}

}  // namespace

ModesCurvesCertificate decode_modes_curves(std::span<const std::uint8_t> data,
                                           std::span<const std::uint8_t> claims) {
  ModesCurvesCertificate c;
  read_tensor_data(data, c);
  ByteReader reader(claims);
  read_rows(reader, c.faces);
  read_list(reader, c.face_points, 37, [&](DegeneratePoint& point) {
    point.face = reader.integer<std::uint32_t>();
    point.type = reader.integer<std::int8_t>();
    for (auto* list : {&point.low, &point.high})
      for (double& x : *list) x = read_number(reader);
  });
  read_list(reader, c.arcs, 12, [&](DegenerateArc& arc) {
    arc.tet = reader.integer<std::uint32_t>();
    for (auto& point : arc.points) point = reader.integer<std::uint32_t>();
  });
  read_rows(reader, c.special_faces);
  reader.words(c.special_tets, reader.integer<std::uint32_t>());
  read_rows(reader, c.degenerate_edges);
  read_rows(reader, c.plane_faces);
  for (CurveCounts* counts : {&c.linear, &c.planar})
    for (auto* number : {&counts->open, &counts->closed, &counts->touched})
      *number = reader.integer<std::uint32_t>();
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
