// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Refines a triangulation until every condition of certify/ridges_smooth/SPEC.md that speaks of
// faces, edges and patches is proven, or the budget is spent.
#include <vector>

#include "algorithms/smooth_ridges/face_test.hpp"
#include "algorithms/smooth_ridges/ridge_singularity.hpp"
#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "algorithms/smooth_ridges/umbilics.hpp"

namespace crest::smooth_ridges {

/// An umbilic and the disk of faces around it.
struct UmbilicPatch {
  Umbilic umbilic;
  std::vector<Index> faces;   ///< ascending
  bool complete = false;      ///< they are a disk
  std::vector<Index> near;    ///< while it is looked for: faces that may belong to it
  std::size_t looked_at = 0;  ///< faces that were asked
};

struct UncertifiedCell {
  Index face;
  FaceStatus status;  ///< proven: an edge of it is not decided
  Vec3 centre;        ///< of its image; implicit: of the flat face
  double size;        ///< of its longest edge in space
};

struct RefinedSurface {
  Triangulation mesh;
  std::vector<FaceResult> faces;      ///< F
  std::vector<Index> patch_of;        ///< F: patch, or kNone
  std::vector<UmbilicPatch> patches;  ///< by ascending first face
  std::vector<UncertifiedCell> uncertified;
  std::vector<RidgeSingularity> singularities;  ///< found by the way, in the order of finding
  bool stopped = false;
  int rounds = 0;
  std::size_t tests = 0;  ///< of faces
  struct {
    double faces = 0, umbilics = 0, bisection = 0;
  } seconds;  ///< testing faces; umbilics and their patches; making faces
};

/// Around points where ridges of one colour seem to meet nothing is refined once they are found: no
/// number of faces would do.
RefinedSurface refine(const Surface& surface, Triangulation start, const RefinementOptions& options,
                      const Stop& stop = {});

/// Midpoint, in space, of face's image; parametric: of X at the unit coordinates' mean.
class Places {
 public:
  explicit Places(const Surface& surface);
  /// The point of space of a vertex (parametric: of unit coordinates).
  Vec3 operator()(const Vertex& v);

 private:
  std::optional<ParametricMap<double, 0>> map_;
};

}  // namespace crest::smooth_ridges
