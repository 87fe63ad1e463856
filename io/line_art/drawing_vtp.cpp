// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing's pieces in space, visible or not.
#include "algorithms/line_art/face_locator.hpp"
#include "io/line_art/drawing_writer.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"

namespace crest::io {
namespace {

using kernel::operator+, kernel::operator*;

enum Kind { kContour, kBoundary, kRim, kCrease, kHatch };  // then the strokes' own kinds

int kind_of(const line_art::ContourEdge& e) {
  return e.crease ? kCrease : e.rim ? kRim : e.boundary ? kBoundary : kContour;
}

}  // namespace

vtkSmartPointer<vtkPolyData> drawing_poly_data(const line_art::Drawing& drawing) {
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
  const line_art::FaceLocator locator(drawing.scene, drawing.view);
  for (line_art::Index h = 0; h < drawing.hatches.size(); ++h) {
    const line_art::Stroke& stroke = drawing.hatches[h];
    line_art::Index face = stroke.face;
    std::vector<PolyData::Id> ids;
    for (const auto& p : stroke.points) {
      face = locator.at(p).value_or(face);
      ids.push_back(data.add_point(locator.lift(p, face)));
    }
    Columns& row = data.add_line(ids);
    row.add("kind", kHatch + static_cast<int>(stroke.kind));
    row.add("invisibility", 0);
    row.add("stroke", static_cast<int>(h));
  }
  return data.data();
}

std::string vtp_of(const line_art::Drawing& drawing) {
  return vtp_bytes(*drawing_poly_data(drawing));
}

}  // namespace crest::io
