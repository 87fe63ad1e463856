// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/encode.hpp"

#include "certify/container/compose.hpp"
#include "certify/surface/tensor_data.hpp"

namespace crest::certify {
namespace {

void write(ByteWriter& out, const RootRecord& root) {
  out.number(root.low);
  out.number(root.high);
  out.integer(root.level);
}
void write(ByteWriter& out, const FaceWitness& witness) {
  for (const auto w : witness.w) out.integer(w);
  out.number(witness.lambda);
}
void write(ByteWriter& out, const ArcPair& arc) {
  out.integer(arc.first);
  out.integer(arc.second);
}
void write(ByteWriter& out, const TetWitness& witness) {
  for (const auto w : witness.w) out.integer(w);
  out.number(witness.lambda);
  for (const auto count : witness.pieces) out.integer(count);
}
void write(ByteWriter& out, const SurfaceComponent& component) {
  out.integer(component.euler_characteristic);
  out.integer(component.boundary_loops);
}
void write(ByteWriter& out, double place) {
  out.number(place);
}
void write(ByteWriter& out, std::uint16_t count) {
  out.integer(count);
}
void write(ByteWriter& out, const std::array<double, 2>& weights) {
  out.numbers(std::span<const double>(weights));
}
void write(ByteWriter& out, const InnerVertex& vertex) {
  out.integer(vertex.witness);
  out.integer(vertex.level);
  out.numbers(std::span<const double>(vertex.weights));
}
template <std::size_t n>
void write(ByteWriter& out, const std::array<std::uint32_t, n>& corners) {
  out.numbers(std::span<const std::uint32_t>(corners));
}

template <class Record>
void write_list(ByteWriter& out, const std::vector<Record>& list) {
  out.count(list.size());
  for (const Record& record : list) write(out, record);
}

void write_counts(ByteWriter& out, const SurfaceCounts& counts) {
  write_list(out, counts.components);
  out.integer(counts.touched);
}

void write_level(ByteWriter& out, const ModeLevel& level) {
  out.integer(level.numerator);
  out.integer(level.denominator);
  write_list(out, level.edges);
  write_list(out, level.faces);
  out.count(level.tets.size());
  out.numbers(level.tets);
  out.count(level.codes.size());
  out.bytes(level.codes);
  write_list(out, level.roots);
  write_list(out, level.face_witnesses);
  write_list(out, level.arcs);
  write_list(out, level.tet_witnesses);
  write_counts(out, level.positive);
  if (level.numerator != 0) write_counts(out, level.negative);
  out.integer(level.open_tets);
  write_list(out, level.root_places);
  write_list(out, level.arc_points);
  write_list(out, level.points);
  write_list(out, level.inner);
  out.integer(level.placed);
  out.integer(level.not_placed);
  out.integer(level.near);
}

}  // namespace

Bytes encode(const ModesCertificate& c) {
  const auto write_data = [&](ByteWriter& out) { write_tensor_data(out, c); };
  const auto write_claims = [&](ByteWriter& out) {
    out.count(c.zeros.size());
    for (const ZeroRecord& zero : c.zeros) {
      out.integer(static_cast<std::uint8_t>(zero.corners.size()));
      out.numbers(zero.corners);
    }
    out.count(c.levels.size());
    for (const ModeLevel& level : c.levels) write_level(out, level);
  };
  return compose({kModes, kModesVersion}, tensor_data_size(c), write_data, write_claims);
}

}  // namespace crest::certify
