// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Sets of vertices and the morphological operators on them (paper 001, sections 3.4.2 and 3.4.3).
#include <cstdint>
#include <vector>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::feature_lines {

using kernel::Index;
using kernel::kNone;

/// The paper's vector F: one entry a vertex, 1 marked, 0 not.
using Marks = std::vector<std::uint8_t>;

Index count(const Marks& marks);

/// Marks the vertices whose field value is at least `value`.
/// Throws: InputError if a field value is not a number. Cost: O(V).
Marks threshold_by_value(const std::vector<double>& field, double value);

/// The value that is entry floor(quantile V) of the sorted field (the last one for quantile 1).
/// Requires: 0 <= quantile <= 1. Throws: InputError as above, or for an empty field.
double field_quantile(const std::vector<double>& field, double quantile);

/// What nhd(i), the structure element, is. All contain i.
enum class Neighbourhood {
  rings,      ///< vertices at most `size` edges away
  euclidean,  ///< vertices at most `size` away in space, joined to i by edges inside that ball
  path,       ///< vertices with an edge path of length at most `size`: not less than geodesic
  geodesic    ///< vertices at most `size` from the whole set over the surface (geodesic.hpp)
};

/// size: a whole number of rings, or a length in units of the input. 0: the operators do nothing.
struct Structure {
  Neighbourhood kind = Neighbourhood::rings;
  double size = 1;
};

/// {j : j in nhd(i) for some marked i}.
/// Cost: rings, path and geodesic O(V log V), euclidean O(marked times vertices in a ball).
Marks dilate(const kernel::TriangleMesh& mesh, const Marks& marks, const Structure& s);
/// {j : nhd(j) all marked}. Adjoint to dilate: dilate(A) in B iff A in erode(B), so that opening
/// and closing are idempotent. Not so for geodesic, whose distances from a set are no minima of
/// distances from its vertices: there it is the complement of what dilating the complement gives.
/// Cost: as dilate.
Marks erode(const kernel::TriangleMesh& mesh, const Marks& marks, const Structure& s);
/// dilate(erode): drops small regions and thin branches. geodesic: what of that was marked.
Marks opening(const kernel::TriangleMesh& mesh, const Marks& marks, const Structure& s);
/// erode(dilate): fills small holes. geodesic: that and what was marked.
Marks closing(const kernel::TriangleMesh& mesh, const Marks& marks, const Structure& s);

}  // namespace crest::feature_lines
