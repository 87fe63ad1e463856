// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/decode.hpp"

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {
namespace {

double read_number(ByteReader& reader) {
  const auto bits = reader.integer<std::uint64_t>();
  require_plain(is_plain(bits), "claim section");
  return std::bit_cast<double>(bits);
}

/// A code not above `last`.
template <class Code>
Code read_code(ByteReader& reader, Code last) {
  const auto byte = reader.integer<std::uint8_t>();
  if (byte > static_cast<std::uint8_t>(last)) throw Malformed("claim section: no such code");
  return static_cast<Code>(byte);
}
std::uint8_t read_flag(ByteReader& reader, std::uint8_t last = 1) {
  return read_code(reader, last);
}

/// No length is believed before it is compared: a record takes at least `size` bytes.
std::size_t read_count(ByteReader& reader, std::size_t size) {
  const std::size_t count = reader.integer<std::uint32_t>();
  if (count > reader.left() / size)
    throw Malformed("claim section: a list is longer than its bytes");
  return count;
}
void read(ByteReader& reader, SkeletonZero& zero);
void read(ByteReader& reader, SkeletonSwitch& point);
void read(ByteReader& reader, SkeletonLoop& loop);
void read(ByteReader& reader, SkeletonPoint& point);
void read(ByteReader& reader, SkeletonException& exception);
void read(ByteReader& reader, SkeletonTrap& trap);
void read(ByteReader& reader, SkeletonLeg& leg);
void read(ByteReader& reader, SkeletonSeparatrix& line);
void read(ByteReader& reader, SkeletonOrbit& orbit);

template <class Record>
void read_list(ByteReader& reader, std::vector<Record>& list, std::size_t size) {
  list.resize(read_count(reader, size));
  for (Record& record : list) read(reader, record);
}

void read_numbers(ByteReader& reader, std::vector<double>& list) {
  list.resize(read_count(reader, 8));
  for (double& x : list) x = read_number(reader);
}

void read_turns(ByteReader& reader, std::vector<Turn>& turns) {
  const std::uint64_t count = reader.integer<std::uint32_t>();
  const auto bytes = reader.take((count + 3) / 4);
  turns.resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < 4 * bytes.size(); ++i) {
    const unsigned code = (bytes[i / 4] >> (2 * (i % 4))) & 3U;
    if (code > (i < count ? 2U : 0U)) throw Malformed("turns: no such code");
    if (i < count) turns[i] = static_cast<Turn>(code);
  }
}

void read(ByteReader& reader, SkeletonZero& zero) {
  zero.triangle = reader.integer<std::uint32_t>();
  zero.place = read_code(reader, ZeroPlace::region);
  zero.kind = read_code(reader, ZeroClass::higher_order);
  zero.focus = read_flag(reader);
  zero.index = reader.integer<std::int32_t>();
  zero.hyperbolic = reader.integer<std::uint32_t>();
  zero.elliptic = reader.integer<std::uint32_t>();
}
void read(ByteReader& reader, SkeletonSwitch& point) {
  point.side = reader.integer<std::uint32_t>();
  point.place = read_flag(reader, 2);
  point.inside = read_flag(reader);
}
void read(ByteReader& reader, SkeletonLoop& loop) {
  loop.side = reader.integer<std::uint32_t>();
  loop.zero = read_flag(reader);
  loop.winding = reader.integer<std::int32_t>();
  loop.turning = reader.integer<std::int32_t>();
  for (auto* n : {&loop.interior, &loop.exterior, &loop.inflow, &loop.outflow})
    *n = reader.integer<std::uint32_t>();
}
void read(ByteReader& reader, SkeletonPoint& point) {
  point.corner = reader.integer<std::uint32_t>();
  point.a = read_number(reader);
  point.b = read_number(reader);
}
void read(ByteReader& reader, SkeletonBarrier& barrier) {
  barrier.degree = reader.integer<std::uint8_t>();
  barrier.angle = reader.integer<std::uint16_t>();
  barrier.bits = reader.integer<std::uint16_t>();
  barrier.shrink = reader.integer<std::int8_t>();
}
void read(ByteReader& reader, SkeletonException& exception) {
  exception.step = reader.integer<std::uint32_t>();
  read(reader, exception.barrier);
}
void read(ByteReader& reader, SkeletonTrap& trap) {
  trap.zero = reader.integer<std::uint32_t>();
  for (double& x : trap.form) x = read_number(reader);
  read_list(reader, trap.star, 20);
}
void read(ByteReader& reader, SkeletonLeg& leg) {
  leg.kind = read_code(reader, LegKind::straight);
  leg.corner = reader.integer<std::uint32_t>();
  read_numbers(reader, leg.first);
  read_numbers(reader, leg.second);
  leg.elements = reader.integer<std::uint32_t>();
  read_turns(reader, leg.turns);
  read(reader, leg.barrier);
  read_list(reader, leg.exceptions, 10);
}
void read(ByteReader& reader, SkeletonSeparatrix& line) {
  line.origin = read_code(reader, SkeletonOrigin::vertex);
  line.from = reader.integer<std::uint32_t>();
  line.backward = read_flag(reader);
  read_list(reader, line.legs, 31);
  line.end = read_code(reader, SkeletonEnd::undecided);
  line.to = reader.integer<std::uint32_t>();
  line.reason = read_code(reader, OpenReason::budget);
}
void read(ByteReader& reader, SkeletonOrbit& orbit) {
  orbit.side = reader.integer<std::uint32_t>();
  orbit.backward = read_flag(reader);
  orbit.left = read_number(reader);
  orbit.right = read_number(reader);
  read_turns(reader, orbit.turns);
  read(reader, orbit.barrier);
  read_list(reader, orbit.exceptions, 10);
}

}  // namespace

void read_skeleton_data(ByteReader& reader, SkeletonCertificate& c) {
  const std::uint64_t vertices = reader.integer<std::uint32_t>();
  const std::uint64_t triangles = reader.integer<std::uint32_t>();
  if (vertices * 32 + triangles * 12 > reader.left())
    throw Malformed("data section: vertex and triangle counts do not fit its length");
  if (vertices < 3 || triangles < 1) throw Malformed("data section: no mesh");
  if (3 * triangles > 0xfffffffeU)
    throw Malformed("data section: more triangles than the format numbers");
  reader.rows(c.triangles, triangles);
  reader.rows(c.positions, vertices);
  reader.rows(c.vectors, vertices);
  require_plain_rows(c.positions, "positions");
  require_plain_rows(c.vectors, "vectors");
}

void read_skeleton_claims(ByteReader& reader, SkeletonCertificate& c) {
  read_list(reader, c.zeros, 19);
  read_list(reader, c.loops, 29);
  read_list(reader, c.switches, 6);
  read_list(reader, c.traps, 32);
  read_list(reader, c.orbits, 35);
  read_list(reader, c.separatrices, 15);
  c.index_sum = reader.integer<std::int32_t>();
  for (auto& n : c.ends) n = reader.integer<std::uint32_t>();
}

SkeletonCertificate decode_skeleton(std::span<const std::uint8_t> data,
                                    std::span<const std::uint8_t> claims) {
  SkeletonCertificate c;
  ByteReader reader(data);
  read_skeleton_data(reader, c);
  if (reader.left() != 0)
    throw Malformed("data section: vertex and triangle counts do not fit its length");
  ByteReader stated(claims);
  read_skeleton_claims(stated, c);
  if (stated.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
