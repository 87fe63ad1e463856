// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Mode surfaces to files.
#include <string>
#include <vector>

#include "algorithms/modes/degenerate_result.hpp"
#include "algorithms/modes/mode_surface.hpp"
#include "io/picture/viewpoint.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;

namespace crest::io {

struct ModeScene {
  std::vector<modes::ModeSurface> surfaces;
  std::vector<modes::DegenerateCurve> curves = {};
  std::vector<std::array<kernel::Vec3, 2>> outline = {};  ///< of the domain; pictures alone
  std::string data_digest = {};                           ///< of the certificate; empty: none
  /// Triangles with a smaller |T| at a corner are left out; 0: none.
  double min_magnitude = 0;
};

/// .vtp: triangles with cell arrays mode and tet, point arrays normal, minor, medium, major
/// (eigenvectors by eigenvalue), magnitude, where the surfaces have it their geometry as
/// field_normal, k1, k2, direction1, direction2; degenerate curves as lines of mode 1 (linear) and
/// -1 (planar), tet -1, the point arrays 0 there. .ply, .obj: the triangles alone. Guarantees: the
/// same bytes for the same surfaces; no half-written file. Throws: kernel::InputError for another
/// extension or a place that cannot be written.
void write_modes(const std::string& path, const ModeScene& scene);

/// What the .vtp file holds.
vtkSmartPointer<vtkPolyData> mode_poly_data(const ModeScene& scene);

/// Surfaces and curves in the paper's colours, in the domain's outline. Requires: a triangle or a
/// curve at least. Throws: kernel::InputError for another extension than .png and .svg, a place
/// that cannot be written or a direction that is none.
void write_mode_picture(const std::string& path, const ModeScene& scene,
                        const Viewpoint& viewpoint = {});

struct Scene;  // io/page/scene.hpp

/// The same for a page, with the modes' magnitudes.
Scene mode_page_scene(const ModeScene& scene, const Viewpoint& viewpoint);

}  // namespace crest::io
