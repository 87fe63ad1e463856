// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/python/systems.hpp"

namespace crest::python {

System system_of(const std::string& name) {
  static const std::map<std::string, System> systems = {{"ridges", run_ridges},
                                                        {"smooth_ridges", run_smooth_ridges},
                                                        {"curvature", run_curvature},
                                                        {"features", run_features},
                                                        {"reeb", run_reeb},
                                                        {"lineart", run_lineart},
                                                        {"strips", run_strips},
                                                        {"encode", run_encode},
                                                        {"decode", run_decode},
                                                        {"modes", run_modes},
                                                        {"extremal", run_extremal},
                                                        {"extremal_points", run_extremal_points},
                                                        {"skeleton", run_skeleton},
                                                        {"compress", run_compress},
                                                        {"spline_volume", run_spline_volume},
                                                        {"spline_samples", run_spline_samples},
                                                        {"verify", run_verify},
                                                        {"read_mesh", run_read_mesh},
                                                        {"read_tensors", run_read_tensors},
                                                        {"read_vectors", run_read_vectors},
                                                        {"read_volume", run_read_volume},
                                                        {"read_points", run_read_points}};
  return systems.at(name);
}

io::Viewpoint viewpoint_of(const Arguments& a) {
  return {a.maybe_numbers<3>("view"), a.maybe_numbers<3>("up")};
}

kernel::TriangleMesh mesh_of(const Arguments& a) {
  auto points = a.rows<3>("V");
  auto faces = a.cells<3>("F", points.size());
  return {std::move(points), std::move(faces)};
}

}  // namespace crest::python
