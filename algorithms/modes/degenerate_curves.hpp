// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Degenerate curves of a piecewise linear field of symmetric tensors, T = +-(v v^T - I/3) times a
// number (Roy et al. 2019; paper 004, sections 3.2 and 5.2), decided exactly: face points from the
// face alone, arcs from the order along a tet's conic, pieces by their shared face points.
#include <span>

#include "algorithms/modes/degenerate_result.hpp"

namespace crest::modes {

struct FaceWorkers;

/// All degenerate curves. Positions place the polylines and decide nothing.
/// workers: whose processes test tetrahedra and faces (degenerate_faces.hpp); null: this one.
/// Requires: finite tensors and points; corners of a tet distinct; a face in two tets at most.
/// Guarantees: where no special face or tet, nor an undecided one, is named, the degenerate points
/// are
///   the curves as listed; a curve that is not closed ends on the boundary or at a named place; the
///   same for any number of threads.
/// Cost: about 0.03 us a tet that a cone excludes, 1.5 us a face else, 200 us where integers
/// decide.
DegenerateCurves degenerate_curves(std::span<const kernel::Vec3> points,
                                   std::span<const TetCorners> tets,
                                   std::span<const Tensor> tensors,
                                   const FaceWorkers* workers = nullptr);

}  // namespace crest::modes
