// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Skeletons of plane vector fields to files.
#include <optional>
#include <string>
#include <vector>

#include "algorithms/vector_fields/importance.hpp"
#include "algorithms/vector_fields/skeleton_result.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;

namespace crest::io {

/// Corners of a part of the plane.
struct PlaneWindow {
  kernel::Vec2 low, high;
};

struct SkeletonScene {
  const vector_fields::PlanarField* field = nullptr;
  const vector_fields::Skeleton* skeleton = nullptr;
  std::string data_digest = {};              ///< of the certificate; empty: none
  std::optional<PlaneWindow> close_up = {};  ///< what pictures show; none: all
};

/// .vtp: a vertex a critical point (array type 0) and a switch point (1), a polyline a separatrix
/// (2) and a closed orbit (3); arrays kind, index, end, target, bits.
/// Guarantees: no half-written file. Throws: kernel::InputError for another extension or a place
/// that cannot be written.
void write_skeleton(const std::string& path, const SkeletonScene& scene);

/// What the .vtp file holds.
vtkSmartPointer<vtkPolyData> skeleton_poly_data(const SkeletonScene& scene);

/// .vtp: the ways of critical points to the smoothed field, the time as z; two partners share one.
/// Arrays zero, partner (-1: none), first, weight. The same otherwise.
void write_paths(const std::string& path, const vector_fields::Skeleton& skeleton,
                 const vector_fields::Importance& importance);

/// The field by line integral convolution with the skeleton on top: saddles blue, sources red,
/// sinks green, switch points yellow, outflow red, inflow green, separatrices black.
/// Throws: kernel::InputError for another extension than .png and .svg or a place that cannot be
/// written.
void write_skeleton_picture(const std::string& path, const SkeletonScene& scene);

struct Scene;  // io/page/scene.hpp

/// The same for a page, over the field's speed.
Scene skeleton_page_scene(const SkeletonScene& scene);

/// Two fields on one domain side by side: above their meshes, below what write_skeleton_picture()
/// shows; the close-up is that of `before`. The same otherwise.
void write_comparison_picture(const std::string& path, const SkeletonScene& before,
                              const SkeletonScene& after);

}  // namespace crest::io
