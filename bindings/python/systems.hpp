// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the package can run: a source a system, as the commands of cli/ do it with files. Arguments
// have the names of the commands' options, and all are given: defaults are the package's.
#include "bindings/python/run.hpp"
#include "io/picture/viewpoint.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::python {

// Meshes.
Output run_ridges(const Arguments& a, const Progress& progress);
Output run_smooth_ridges(const Arguments& a, const Progress& progress);
Output run_curvature(const Arguments& a, const Progress& progress);
Output run_features(const Arguments& a, const Progress& progress);
Output run_reeb(const Arguments& a, const Progress& progress);
Output run_lineart(const Arguments& a, const Progress& progress);
Output run_strips(const Arguments& a, const Progress& progress);
Output run_encode(const Arguments& a, const Progress& progress);
Output run_decode(const Arguments& a, const Progress& progress);
// Fields.
Output run_modes(const Arguments& a, const Progress& progress);
Output run_extremal(const Arguments& a, const Progress& progress);
Output run_extremal_points(const Arguments& a, const Progress& progress);
Output run_skeleton(const Arguments& a, const Progress& progress);
Output run_compress(const Arguments& a, const Progress& progress);
Output run_spline_volume(const Arguments& a, const Progress& progress);
Output run_spline_samples(const Arguments& a, const Progress& progress);
// Files and certificates.
Output run_verify(const Arguments& a, const Progress& progress);
Output run_read_mesh(const Arguments& a, const Progress& progress);
Output run_read_tensors(const Arguments& a, const Progress& progress);
Output run_read_vectors(const Arguments& a, const Progress& progress);
Output run_read_volume(const Arguments& a, const Progress& progress);
Output run_read_points(const Arguments& a, const Progress& progress);

/// By name, "ridges". Throws: std::out_of_range.
System system_of(const std::string& name);

/// `view` and `up`, of pictures.
io::Viewpoint viewpoint_of(const Arguments& a);

/// V and F as a mesh.
kernel::TriangleMesh mesh_of(const Arguments& a);

}  // namespace crest::python
