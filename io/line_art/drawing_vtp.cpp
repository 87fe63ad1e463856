// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing's pieces in space, visible or not.
#include "algorithms/line_art/face_locator.hpp"
#include "io/line_art/drawing_writer.hpp"
#include "io/page/scene.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"

namespace crest::io {
namespace {

using kernel::operator+, kernel::operator*;

enum CellKind { kContour, kBoundary, kRim, kCrease, kHatch };  // then the strokes' own kinds

int kind_of(const line_art::ContourEdge& e) {
  return e.crease ? kCrease : e.rim ? kRim : e.boundary ? kBoundary : kContour;
}

SceneLayer contour_layer(const line_art::Drawing& drawing) {
  SceneLayer layer{"Contours", {}};
  constexpr const char* kLabels[] = {"contour", "boundary", "rim", "crease"};
  for (const bool hidden : {false, true})
    for (const char* label : kLabels)
      layer.kinds.push_back({label + std::string(hidden ? ", hidden" : ""),
                             hidden ? Rgb{150, 150, 156} : Rgb{24, 24, 28}, hidden ? 0.5 : 1,
                             !hidden});
  for (const line_art::ContourEdge& e : drawing.contours.edges)
    for (line_art::Index i = e.first_piece; i < e.first_piece + e.pieces; ++i) {
      const line_art::Piece& piece = drawing.contours.pieces[i];
      const auto& points = drawing.scene.points;
      const auto at = [&](double t) { return (1 - t) * points[e.a] + t * points[e.b]; };
      const auto invisibility = static_cast<int>(piece.in_front - piece.touching);
      layer.add_item().add("invisibility", invisibility);
      layer.add_run(static_cast<std::uint32_t>(kind_of(e) + (invisibility > 0 ? 4 : 0)),
                    std::array{at(piece.from), at(piece.to)});
    }
  return layer;
}

SceneLayer hatch_layer(const line_art::Drawing& drawing) {
  SceneLayer layer{"Hatches", {}};
  for (const auto kind : {line_art::StrokeKind::rib, line_art::StrokeKind::cross,
                          line_art::StrokeKind::streamline, line_art::StrokeKind::contour})
    layer.kinds.push_back({line_art::name_of(kind), {40, 40, 46}, 0.5});
  const line_art::FaceLocator locator(drawing.scene, drawing.view);
  for (const line_art::Stroke& stroke : drawing.hatches) {
    line_art::Index face = stroke.face;
    std::vector<kernel::Vec3> points;
    for (const auto& p : stroke.points) {
      face = locator.at(p).value_or(face);
      points.push_back(locator.lift(p, face));
    }
    Columns& row = layer.add_item();
    row.add("length on the page, mm", stroke.length());
    row.add("segment", stroke.segment == line_art::kNone ? -1 : static_cast<int>(stroke.segment));
    const auto kind = static_cast<int>(stroke.kind);
    layer.add_line(points, false, [kind](std::size_t) { return kind; });
  }
  return layer;
}

}  // namespace

Scene drawing_scene(const line_art::Drawing& drawing) {
  Scene scene{"Drawing"};
  const line_art::View& view = drawing.view;
  scene.camera = Camera{view.x, view.y, view.z, {}, 1, 1200, 1200};
  SceneSurface surface{"surface", drawing.scene.points, drawing.scene.faces};
  surface.colour = Rgb{246, 244, 238};
  scene.surfaces.push_back(std::move(surface));
  scene.layers = {hatch_layer(drawing), contour_layer(drawing)};
  return scene;
}

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
