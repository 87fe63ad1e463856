// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Feature lines as polylines with vertex labels, and as a picture.
#include <string>

#include "algorithms/feature_lines/feature_graph.hpp"
#include "io/picture/viewpoint.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;

namespace crest::io {

/// Writes .vtp or .obj, by the extension in any case.
///
/// .vtp: the mesh's points in their order; a polyline a feature line (a loop ends with the point it
/// starts with; one of a single vertex is a vertex cell), a two-point one an edge inside a node,
/// then the mesh's faces.
///   points: label (0 patch, 1 node, 2 arc, 3 branch, 4 loop, 5 isolated line), patch (-1 on
///     lines), field (the thresholded number).
///   cells: kind (1 node, 2 arc, 3 branch, 4 loop, 5 isolated line; 0 for faces), length (0 for
///     faces and node edges), end_0 and end_1 (0 open, 1 node, 2 mesh boundary, 3 none; -1 for
///     faces and node edges), node_0 and node_1 (number of the node, else -1), patch (of a face; -1
///     on lines, and where all of a component is marked).
///   field: data_digest, the digest a certificate of the run carries.
/// .obj: v for the points of lines; the same lines as l (of a single vertex: p), in groups.
/// Requires: one label, patch and field value a vertex. Guarantees: the same bytes for the same
///   input; no half-written file.
/// Throws: kernel::InputError for another extension or a place that cannot be written.
void write_features(const std::string& path, const kernel::TriangleMesh& mesh,
                    const feature_lines::FeatureGraph& graph, const std::vector<double>& field,
                    const std::string& data_digest_hex);

/// What the .vtp file holds.
vtkSmartPointer<vtkPolyData> feature_poly_data(const kernel::TriangleMesh& mesh,
                                               const feature_lines::FeatureGraph& graph,
                                               const std::vector<double>& field,
                                               const std::string& data_digest_hex);

/// Writes the mesh with the patch each face belongs to, as numbers from 0: .vtp (cell array
/// `patch`) or .ply (a face property `patch`, int, after the face's vertices), by the extension in
/// any case. -1: of a component whose vertices are all marked.
/// Guarantees, Throws: as write_features.
void write_patches(const std::string& path, const kernel::TriangleMesh& mesh,
                   const std::vector<kernel::Index>& face_patch);

/// Writes .png or .svg: arcs blue, branches red, loops green, isolated lines yellow, nodes black
/// dots and lines. Hidden parts are not drawn. `patches`: each in a tint of its own, shaded flat up
/// to its edges. `note`: a line of the legend. Throws: kernel::InputError for another extension, a
/// place that cannot be written or a direction that is none.
void write_feature_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                           const feature_lines::FeatureGraph& graph, bool patches,
                           const Viewpoint& viewpoint = {}, const std::string& note = {});

struct Scene;  // io/page/scene.hpp

/// The same for a page, with the field and the patches. `field_name`: of the thresholded numbers.
Scene feature_scene(const kernel::TriangleMesh& mesh, const feature_lines::FeatureGraph& graph,
                    const std::string& field_name, const std::vector<double>& field, bool patches,
                    const Viewpoint& viewpoint);

}  // namespace crest::io
