// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/encode.hpp"

#include "certify/container/compose.hpp"

namespace crest::certify {
namespace {

template <class Code>
void write_code(ByteWriter& out, Code code) {
  out.integer(static_cast<std::uint8_t>(code));
}

/// Four a byte, the first in the lowest bits, 0 where there is none.
void write_turns(ByteWriter& out, const std::vector<Turn>& turns) {
  out.count(turns.size());
  for (std::size_t i = 0; i < turns.size(); i += 4) {
    unsigned byte = 0;
    for (std::size_t k = i; k < std::min(i + 4, turns.size()); ++k)
      byte |= static_cast<unsigned>(turns[k]) << (2 * (k - i));
    out.integer(static_cast<std::uint8_t>(byte));
  }
}

void write(ByteWriter& out, const SkeletonZero& zero) {
  out.integer(zero.triangle);
  write_code(out, zero.place);
  write_code(out, zero.kind);
  out.integer(zero.focus);
  out.integer(zero.index);
  out.integer(zero.hyperbolic);
  out.integer(zero.elliptic);
}
void write(ByteWriter& out, const SkeletonSwitch& point) {
  out.integer(point.side);
  out.integer(point.place);
  out.integer(point.inside);
}
void write(ByteWriter& out, const SkeletonLoop& loop) {
  out.integer(loop.side);
  out.integer(loop.zero);
  out.integer(loop.winding);
  out.integer(loop.turning);
  for (const auto n : {loop.interior, loop.exterior, loop.inflow, loop.outflow}) out.integer(n);
}
void write(ByteWriter& out, const SkeletonPoint& point) {
  out.integer(point.corner);
  out.number(point.a);
  out.number(point.b);
}
void write(ByteWriter& out, const SkeletonBarrier& barrier) {
  out.integer(barrier.degree);
  out.integer(barrier.angle);
  out.integer(barrier.bits);
  out.integer(barrier.shrink);
}
void write(ByteWriter& out, const SkeletonException& exception) {
  out.integer(exception.step);
  write(out, exception.barrier);
}
void write(ByteWriter& out, const SkeletonTrap& trap);
void write(ByteWriter& out, const SkeletonLeg& leg);
void write(ByteWriter& out, const SkeletonSeparatrix& line);
void write(ByteWriter& out, const SkeletonOrbit& orbit);

template <class Record>
void write_list(ByteWriter& out, const std::vector<Record>& list) {
  out.count(list.size());
  for (const Record& record : list) write(out, record);
}
void write_numbers(ByteWriter& out, const std::vector<double>& list) {
  out.count(list.size());
  out.numbers(list);
}

void write(ByteWriter& out, const SkeletonTrap& trap) {
  out.integer(trap.zero);
  out.numbers(trap.form);
  write_list(out, trap.star);
}
void write(ByteWriter& out, const SkeletonLeg& leg) {
  write_code(out, leg.kind);
  out.integer(leg.corner);
  write_numbers(out, leg.first);
  write_numbers(out, leg.second);
  out.integer(leg.elements);
  write_turns(out, leg.turns);
  write(out, leg.barrier);
  write_list(out, leg.exceptions);
}
void write(ByteWriter& out, const SkeletonSeparatrix& line) {
  write_code(out, line.origin);
  out.integer(line.from);
  out.integer(line.backward);
  write_list(out, line.legs);
  write_code(out, line.end);
  out.integer(line.to);
  write_code(out, line.reason);
}
void write(ByteWriter& out, const SkeletonOrbit& orbit) {
  out.integer(orbit.side);
  out.integer(orbit.backward);
  out.number(orbit.left);
  out.number(orbit.right);
  write_turns(out, orbit.turns);
  write(out, orbit.barrier);
  write_list(out, orbit.exceptions);
}

}  // namespace

void write_skeleton_claims(ByteWriter& out, const SkeletonCertificate& c) {
  write_list(out, c.zeros);
  write_list(out, c.loops);
  write_list(out, c.switches);
  write_list(out, c.traps);
  write_list(out, c.orbits);
  write_list(out, c.separatrices);
  out.integer(c.index_sum);
  for (const auto n : c.ends) out.integer(n);
}

std::size_t skeleton_data_size(const SkeletonCertificate& c) {
  return 8 + c.triangles.size() * 12 + c.positions.size() * 32;
}

void write_skeleton_data(ByteWriter& out, const SkeletonCertificate& c) {
  if (c.vectors.size() != c.positions.size())
    throw std::invalid_argument("certificate: as many vectors as vertices are needed");
  out.count(c.positions.size());
  out.count(c.triangles.size());
  out.rows(c.triangles);
  out.rows(c.positions);
  out.rows(c.vectors);
}

Bytes encode(const SkeletonCertificate& c) {
  return compose(
      {kSkeleton, kSkeletonVersion}, skeleton_data_size(c),
      [&](ByteWriter& out) { write_skeleton_data(out, c); },
      [&](ByteWriter& out) { write_skeleton_claims(out, c); });
}

}  // namespace crest::certify
