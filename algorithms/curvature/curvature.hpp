// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The curvature tensor of a mesh, by seven methods (paper 001, sections 3.1 to 3.3).
// Letters: k1 >= k2 principal curvatures, d1, d2 their directions, K = k1 k2 and H = (k1 + k2) / 2
// Gaussian and mean curvature. Signs as for Monge forms: a convex point seen from the side the
// normal points to has k1, k2 <= 0. Units: k, H 1/length, K 1/length^2.
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::curvature {

using kernel::Index;
using kernel::Vec3;

struct Workers;  // pieces.hpp: who works on pieces of the mesh; none: this process on all of it

enum class Method : std::uint8_t {
  np,           ///< normal-based tensor, given normals (section 3.2)
  ne,           ///< the same with area-weighted normals
  cf,           ///< cubic height function and normals (Goldfeather and Interrante 2004)
  qf,           ///< quadratic height function (the same)
  qt,           ///< quadratic surface over the exponential map (Welch and Witkin 1994)
  jet,          ///< height polynomial over several rings (Cazals and Pouget 2003)
  normal_cycle  ///< dihedral angles over a region (Cohen-Steiner and Morvan 2003)
};

inline constexpr std::array<Method, 7> kMethods = {
    Method::np, Method::ne, Method::cf, Method::qf, Method::qt, Method::jet, Method::normal_cycle};
const char* name_of(Method method);
std::optional<Method> method_of(std::string_view name);

/// The tensor at a point. The normal-based tensor is not symmetric: d1, d2 are its eigenvectors and
/// need not be orthogonal. asymmetry: |f1 - f2| of section 3.2.3 in an orthonormal tangent frame
/// (1/length; 0 for the other methods). Where its eigenvalues are not real, k1 = k2 = H, K keeps
/// the value of equation 3.13 and the directions are those of the symmetric part.
struct PointCurvature {
  double k1 = 0, k2 = 0, K = 0, H = 0, asymmetry = 0;
  Vec3 d1{}, d2{};
};

struct Options {
  Method method = Method::ne;
  /// One a vertex, of any length but zero; np needs them, the others take them instead of their
  /// estimate (qt and normal_cycle use them for orientation and projection only). np interpolates
  /// them as they are: the tensor depends on their lengths (theorem 3.1 (ii)).
  std::vector<Vec3> normals;
  int degree = 4;       ///< jet: of the polynomial, 2 to 6
  int jet_points = 30;  ///< jet: whole rings until there are that many neighbours
  int rings = 1;        ///< normal_cycle: region, barycentric cells up to that ring
};

struct Result {
  std::vector<PointCurvature> vertices;
  std::vector<Vec3> normals;  ///< used: as given, or unit area-weighted means
  Index lowered = 0;          ///< vertices whose fit lacked rank: the smallest solution was taken
  Index complex = 0;          ///< vertices whose mean tensor has no real eigenvalues (np, ne)
  Index undetermined = 0;     ///< vertices without a finite estimate: all zero
};

/// Estimates the tensor at every vertex. np, ne: the uniform mean of the adjacent triangles'
/// tensors at the corner, its K and H those of the mean (section 3.3, "Estimation-per-Vertex").
/// Guarantees: the same bytes for any number of threads and pieces.
/// Throws: kernel::InputError for np without normals, normals that are zero, not finite or not one
///   a vertex, and for coordinates whose range is beyond what products of four lengths allow.
/// Cost: O(V) for bounded valences.
Result estimate(const kernel::TriangleMesh& mesh, const Options& options,
                const Workers* workers = nullptr);

/// The same into a result whose storage is used again: fresh pages cost more than np and ne do.
void estimate(const kernel::TriangleMesh& mesh, const Options& options, Result& result);

/// Means of the adjacent faces' normals, weighted by area, of length 1 (section 3.3). Where they
/// cancel, the normal of the first face.
std::vector<Vec3> area_weighted_normals(const kernel::TriangleMesh& mesh);

/// The normal-based tensors of a triangle at its three corners.
using CornerCurvatures = std::array<PointCurvature, 3>;
/// One a face. Not finite where the interpolated normal lies in the triangle's plane.
std::vector<CornerCurvatures> corner_curvatures(const kernel::TriangleMesh& mesh,
                                                const std::vector<Vec3>& normals);

/// The normal-based tensor of a face at barycentric coordinates lambda (sum 1): K by equation 3.13,
/// H by 3.14, directions by the Weingarten matrix of appendix A.
PointCurvature curvature_at(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                            Index face, const std::array<double, 3>& lambda);

/// The distances of section 3.3 between estimates and exact values at the same vertices.
struct Distances {
  double K = 0, H = 0;  ///< means of squared differences
  double P = 0;         ///< mean angle between the directions, radians
};
Distances distances(const std::vector<PointCurvature>& estimates,
                    const std::vector<PointCurvature>& exact);

}  // namespace crest::curvature
