// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Well-shaped meshes of the surfaces with known answers, noise-free or with noise.
#include <cstdint>

#include "algorithms/sampling/surfaces.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::sampling {

/// V points on the surface (to rounding), F outward faces ready for kernel::TriangleMesh, and the
/// exact Monge form at each point (none for "handles", and where none is asked for).
struct SurfaceSample {
  std::vector<Vec3> points;
  std::vector<kernel::Triangle> faces;
  std::vector<kernel::MongeForm> forms;
  KnownFacts known;
};

/// Three quarters of the time of a sample.
enum class Forms : std::uint8_t { none, exact };

/// A mesh of about the given number of vertices: an icosahedron of frequency n (10 n^2 + 2
/// vertices) projected along rays, or a jittered grid with alternating diagonals (tori, patches);
/// closed ones are then smoothed along the surface. With rotate both the pose and the mesh are
/// generic; without it an icosahedral mesh keeps the surface's coordinate symmetries.
/// Requires: 12 <= vertices <= 10^8.
/// Guarantees: the same bytes for the same arguments, whatever the thread count.
/// Throws: std::invalid_argument for an unknown name, bad parameters, or a bad number.
/// Cost: about 10 microseconds a vertex and thread.
SurfaceSample sample(const std::string& name, const std::vector<double>& parameters, int vertices,
                     bool rotate, Forms forms = Forms::exact);
SurfaceSample sample(const Surface& surface, int vertices, bool rotate, Forms forms = Forms::exact);

/// Mean length of the edges of the faces.
double mean_edge_length(const std::vector<Vec3>& points,
                        const std::vector<kernel::Triangle>& faces);

/// Moves each point by a normally distributed length along its normal (one of normals a point), or
/// isotropically, three coordinates each, when normals is empty.
/// sigma: standard deviation, in units of the input (a fraction times mean_edge_length).
/// Guarantees: the same sequence on every platform whose log, cos and sqrt agree.
void add_normal_noise(std::vector<Vec3>& points, const std::vector<Vec3>& normals, double sigma,
                      std::uint64_t seed);

/// The normals of a sample's forms.
std::vector<Vec3> normals(const SurfaceSample& sample);

}  // namespace crest::sampling
