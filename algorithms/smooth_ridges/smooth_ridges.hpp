// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Certified ridges and umbilics of a smooth surface given by expressions (paper 002, case I;
// certify/ridges_smooth/SPEC.md states what is proven and why).
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/smooth_ridges/refinement.hpp"
#include "kernel/geometry/ridge_words.hpp"

namespace crest::smooth_ridges {

using kernel::Colour;

struct Options {
  /// Of the first triangulation, about. Else 1500 that resolve an implicit surface, or 400: of a
  /// parametrisation any grid is a start.
  std::optional<int> start_faces;
  RefinementOptions refinement;
};

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
  std::vector<std::string> obstacles;  ///< if not: one line each
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

/// Throws: std::invalid_argument for options outside their ranges.
/// The same result for any number of threads.
SmoothRidges smooth_ridges(const Surface& surface, const Options& options);

}  // namespace crest::smooth_ridges
