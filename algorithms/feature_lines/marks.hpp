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

/// A threshold that marks the vertices from a quantile on, and with them all whose values equal it
/// but for rounding. Values count as equal that differ by less than 2^-20 of the quantile's value
/// or 2^-36 of the largest absolute value; the threshold is the value above the widest gap among
/// those that equal the quantile's from below, so that no group of equal values is split whose
/// spread is less than the gap under it. Guarantees: at most field_quantile, by no more than that.
/// Requires, Throws: as field_quantile. Cost: O(V log V).
double quantile_threshold(const std::vector<double>& field, double quantile);

/// The same where the quantile is only a guess at how many vertices lie on features: if among the
/// thresholds that mark half to twice as many there are gaps, the next lower value being lower by
/// more than a quarter of the quantile's value, the one above the widest (of gaps alike to a
/// thousandth the uppermost). Models from CAD have such gaps, between the values at edges and on
/// faces; scans do not.
double gap_threshold(const std::vector<double>& field, double quantile);

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
