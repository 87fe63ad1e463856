// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Step 4: the index of every face (SPEC.md, "Index of a face", lemma 2).
#include "certify/ridges_mesh/signs.hpp"

namespace crest::certify {

/// F: twice the index. With doubles, plain double enclosures decide and MPFR what they leave open;
/// with mpfr, MPFR decides all. Throws Undecided if an index cannot be determined.
/// Cost: linear; 0.3 microseconds a face in doubles.
std::vector<std::int8_t> face_indices(const MeshData& data, const Topology& topology,
                                      const MeshSigns& signs, Arithmetic arithmetic,
                                      AngleCounts& counts);

/// The double stage alone: at every vertex scaled angles and phi, with one error bound for all.
struct DoubleAngles {
  std::vector<double> before;  ///< 3F: a(v, w) for the side v -> w
  std::vector<double> angle;   ///< 3F: alpha~ of a corner
  std::vector<double> total;   ///< V: the sum of alpha~
  std::vector<double> phi;     ///< V
  std::vector<double> error;   ///< V: bounds every error above at v; infinite if unknown
};
DoubleAngles enclose_angles(const MeshData& data, const Topology& topology);

}  // namespace crest::certify
