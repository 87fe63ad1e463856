// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes_curves/encode.hpp"

#include "certify/container/compose.hpp"
#include "certify/surface/tensor_data.hpp"

namespace crest::certify {
namespace {

template <std::size_t n>
void write(ByteWriter& out, const std::array<std::uint32_t, n>& corners) {
  out.numbers(std::span<const std::uint32_t>(corners));
}
void write(ByteWriter& out, const DegeneratePoint& point) {
  out.integer(point.face);
  out.integer(point.type);
  out.numbers(std::span<const double>(point.low));
  out.numbers(std::span<const double>(point.high));
}
void write(ByteWriter& out, const DegenerateArc& arc) {
  out.integer(arc.tet);
  write(out, arc.points);
}

template <class Record>
void write_list(ByteWriter& out, const std::vector<Record>& list) {
  out.count(list.size());
  for (const Record& record : list) write(out, record);
}

}  // namespace

Bytes encode(const ModesCurvesCertificate& c) {
  const auto write_data = [&](ByteWriter& out) { write_tensor_data(out, c); };
  const auto write_claims = [&](ByteWriter& out) {
    write_list(out, c.faces);
    write_list(out, c.face_points);
    write_list(out, c.arcs);
    write_list(out, c.special_faces);
    out.count(c.special_tets.size());
    out.numbers(c.special_tets);
    write_list(out, c.degenerate_edges);
    write_list(out, c.plane_faces);
    for (const CurveCounts* counts : {&c.linear, &c.planar})
      for (const auto number : {counts->open, counts->closed, counts->touched}) out.integer(number);
  };
  return compose({kModesCurves, kModesCurvesVersion}, tensor_data_size(c), write_data,
                 write_claims);
}

}  // namespace crest::certify
