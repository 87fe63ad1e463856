// SPDX-License-Identifier: GPL-3.0-or-later
// crest curvature.
#include "algorithms/curvature/curvature.hpp"

#include <fmt/format.h>

#include "bindings/python/systems.hpp"
#include "io/curvature/curvature_picture.hpp"
#include "io/curvature/curvature_writer.hpp"

namespace crest::python {
namespace {

void draw(const Arguments& a, const kernel::TriangleMesh& mesh, const curvature::Result& result) {
  const std::string& colour = a.text("colour");
  io::ColourPicture picture;
  picture.view = viewpoint_of(a).view;
  picture.up = viewpoint_of(a).up;
  picture.label = colour == "K"    ? "gaussian curvature"
                  : colour == "k1" ? "larger principal curvature"
                  : colour == "k2" ? "smaller principal curvature"
                                   : "mean curvature";
  std::vector<double> values;
  for (const curvature::PointCurvature& c : result.vertices)
    values.push_back(colour == "K" ? c.K : colour == "k1" ? c.k1 : colour == "k2" ? c.k2 : c.H);
  io::write_colour_picture(a.text("picture"), mesh, values, picture);
}

}  // namespace

Output run_curvature(const Arguments& a, const Progress& progress) {
  const kernel::TriangleMesh mesh = mesh_of(a);
  curvature::Options options;
  options.method = curvature::method_of(a.text("method")).value();
  options.degree = a.integer("degree");
  options.rings = a.integer("rings");
  if (a.has("normals")) options.normals = a.rows<3>("normals");
  const curvature::Result result =
      progress.step("estimating curvatures", [&] { return curvature::estimate(mesh, options); });
  Output out;
  if (result.undetermined > 0)
    out.warnings.push_back(
        fmt::format("{} vertices have no finite estimate and are zero", result.undetermined));
  out.geometries["geometry"] = io::geometry_of(
      io::curvature_poly_data(mesh, result,
                              a.flag("corners") ? curvature::corner_curvatures(mesh, result.normals)
                                                : std::vector<curvature::CornerCurvatures>{}));
  if (a.has("picture")) progress.step("drawing", [&] { draw(a, mesh, result); });
  out.values["lowered"] = std::int64_t{result.lowered};
  out.values["complex"] = std::int64_t{result.complex};
  out.values["undetermined"] = std::int64_t{result.undetermined};
  return out;
}

}  // namespace crest::python
