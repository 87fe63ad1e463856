// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whole drawings of meshes.
#include "algorithms/curvature/curvature.hpp"
#include "algorithms/line_art/line_art.hpp"
#include "tests/line_art/scenes.hpp"

namespace crest::tests {

inline std::vector<line_art::PrincipalFrame> frames_of(const kernel::TriangleMesh& mesh) {
  const auto estimate = curvature::estimate(mesh, {});
  std::vector<line_art::PrincipalFrame> frames;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto& c = estimate.vertices[v];
    frames.push_back({c.k1, c.k2, c.d1, c.d2, estimate.normals[v]});
  }
  return frames;
}

inline line_art::Drawing draw(const kernel::TriangleMesh& mesh, const Vec3& eye,
                              const line_art::HatchOptions& options, double width = 60) {
  line_art::Drawing drawing;
  drawing.scene = line_art::weld(mesh.points(), mesh.faces());
  line_art::ViewRequest request;
  request.towards = eye;
  request.width = width;
  drawing.view = line_art::make_view(request, drawing.scene);
  drawing.contours = line_art::find_contours(drawing.scene, drawing.view, {options.crease});
  drawing.lines = line_art::draw_contours(drawing.scene, drawing.view, drawing.contours);
  line_art::add_hatches(drawing, mesh, frames_of(mesh), options,
                        [](const char*, const std::function<void()>& work) { work(); });
  return drawing;
}

}  // namespace crest::tests
