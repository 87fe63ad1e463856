// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/001-line-art/surface.hpp"

#include "algorithms/curvature/curvature.hpp"

namespace crest::experiments {

using namespace line_art;

std::vector<PrincipalFrame> frames_of(const kernel::TriangleMesh& mesh) {
  const auto estimate = curvature::estimate(mesh, {});
  std::vector<PrincipalFrame> frames;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto& c = estimate.vertices[v];
    frames.push_back({c.k1, c.k2, c.d1, c.d2, estimate.normals[v]});
  }
  return frames;
}

Drawing contour_drawing(const kernel::TriangleMesh& mesh, const Vec3& eye, double width) {
  Drawing drawing;
  drawing.scene = weld(mesh.points(), mesh.faces());
  ViewRequest request;
  request.towards = eye;
  request.width = width;
  drawing.view = make_view(request, drawing.scene);
  drawing.contours = find_contours(drawing.scene, drawing.view);
  drawing.lines = draw_contours(drawing.scene, drawing.view, drawing.contours);
  return drawing;
}

}  // namespace crest::experiments
