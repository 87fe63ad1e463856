// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The ridge graph of a smooth surface and the triangulation that proves it: what the computation
// returns, io writes and a certificate claims. (Apart from smooth_ridges.hpp so that readers of
// results see no Taylor models.)
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "certify/ridges_smooth/records.hpp"
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"
#include "kernel/geometry/ridge_words.hpp"

namespace crest::smooth_ridges {

using kernel::Colour;
using kernel::Index;
using kernel::kNone;
using kernel::RidgeType;
using kernel::Vec3;

struct UmbilicPoint {
  Vec3 point;
  int twice_index;              ///< 1 or -1
  std::array<int, 2> branches;  ///< blue, red: 1 (1-ridge) or 3 (3-ridge)
};

/// A ridge as a polyline through its crossings of edges.
struct SmoothRidge {
  Colour colour = Colour::blue;
  bool loop = false;
  std::array<Index, 2> ends{kNone, kNone};  ///< umbilics; kNone: a loop, or the boundary
  std::vector<Vec3> points;                 ///< a loop's first point is not repeated
  std::vector<RidgeType> types;  ///< of the segment after each point; none inside a patch
};

struct RidgePoint {
  Vec3 point;
  Colour colour = Colour::blue;  ///< of a turning point
};

struct UndecidedCell {
  Vec3 centre;
  double size;
  std::string reason;  ///< what was not proven, and why that is likely
};

struct SmoothRidges {
  bool certified = false;
  bool stopped = false;                ///< before all was tried (Options::stop)
  std::vector<std::string> obstacles;  ///< if not certified: one line each
  std::vector<UndecidedCell> undecided;

  // The triangulation in space; what follows is right only where nothing is undecided.
  std::vector<Vec3> points;
  std::vector<kernel::Triangle> faces;
  std::vector<bool> in_patch;  ///< F
  int euler_characteristic = 0;
  std::size_t components = 0, boundary_loops = 0;

  std::vector<UmbilicPoint> umbilics;
  std::vector<SmoothRidge> ridges;  ///< blue, then red
  std::vector<RidgePoint> turning_points, purple_points;

  int rounds = 0;         ///< of refinement
  std::size_t tests = 0;  ///< of faces
  /// By the clock. start: the first triangulation; graph: the certificate's contents too.
  struct {
    double completeness = 0, start = 0, faces = 0, umbilics = 0, bisection = 0, graph = 0;
  } seconds;
  certify::RidgesSmoothCertificate certificate;  ///< if certified
};

}  // namespace crest::smooth_ridges
