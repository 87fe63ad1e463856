// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing's pieces in space, visible or not.
#include "io/line_art/drawing_writer.hpp"
#include "io/write/poly_data.hpp"

namespace crest::io {
namespace {

using kernel::operator+, kernel::operator*;

enum Kind { kContour, kBoundary, kRim, kCrease };

int kind_of(const line_art::ContourEdge& e) {
  return e.crease ? kCrease : e.rim ? kRim : e.boundary ? kBoundary : kContour;
}

}  // namespace

std::string vtp_of(const line_art::Drawing& drawing) {
  PolyData data;
  const auto& points = drawing.scene.points;
  for (const line_art::ContourEdge& e : drawing.contours.edges)
    for (line_art::Index i = e.first_piece; i < e.first_piece + e.pieces; ++i) {
      const line_art::Piece& piece = drawing.contours.pieces[i];
      const auto at = [&](double t) { return (1 - t) * points[e.a] + t * points[e.b]; };
      const PolyData::Id ends[] = {data.add_point(at(piece.from)), data.add_point(at(piece.to))};
      Columns& row = data.add_line(ends);
      row.add("kind", kind_of(e));
      row.add("invisibility", static_cast<int>(piece.in_front - piece.touching));
      row.add("stroke", -1);
    }
  return data.bytes();
}

}  // namespace crest::io
