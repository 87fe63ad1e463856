// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The fit and the ridge graph of a mesh: what extraction returns, what io writes, what a
// certificate claims.
#include <cstdint>
#include <vector>

#include "kernel/geometry/index.hpp"
#include "kernel/geometry/monge_form.hpp"
#include "kernel/geometry/ridge_words.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::ridges {

using kernel::Colour;
using kernel::Index;
using kernel::RidgeType;
using kernel::StageCounts;
using kernel::UmbilicKind;
using kernel::Vec3;

/// How well a vertex's fit is determined.
struct FitQuality {
  double condition;      ///< of the scaled least-squares system, estimated from R
  std::uint16_t points;  ///< neighbours used
  std::uint8_t degree;   ///< of the fit that was possible: 4, 3, 2 or 0 (none: flat form)
};

/// How far a vertex's curvatures can be trusted (standard_errors.hpp), units of the input.
struct CurvatureError {
  double k1 = 0, k2 = 0, gap = 0;  ///< standard errors of k1, k2, k1 - k2; infinite: no quartic fit
  double wide_k1 = 0, wide_k2 = 0;  ///< the curvatures of the second, wider fit
  double radius = 0;                ///< R of the first support: root 2 times the rms distance
};

struct FitResult {
  std::vector<kernel::MongeForm> forms;  ///< V
  std::vector<FitQuality> quality;       ///< V
  std::vector<CurvatureError> errors;    ///< V with FitOptions::errors, else none
  std::vector<std::uint8_t> creases;     ///< likewise; 1: on a crease (creases.hpp)
  double scale = 0;                      ///< radius of the supports, 0: by rings
  int points = 0;  ///< least points of the supports (at creases 30), 0: not by their number
};

/// A crossing of a ridge with a mesh edge, edge = (p, q) with p < q (observation 2, equation 4).
struct Crossing {
  Index edge;
  double weight;   ///< the point is (1 - weight) p + weight q
  Vec3 point;      ///< units of the input
  RidgeType type;  ///< exact sign of the interpolated P: none, elliptic or hyperbolic
  double k1, k2;   ///< interpolated curvatures
  double b;        ///< |b0| or |b3|, mean of the two ends: how steep the zero crossing is
  double p;        ///< interpolated P1 (blue) or P2 (red)
  // Salience (salience.hpp); 0 before it is marked.
  double significance = 0;        ///< z of the extremum of the crossing's type
  double crest_significance = 0;  ///< z as a maximum of |k|, on the crest
  double prominence = 0;          ///< drop of k on the lesser side, 1/length
  std::uint8_t level = 0;         ///< 0 dropped, 1 significant, 2 salient
};

/// What a ridge's end rests on; cut: a filter has taken the rest of the ridge.
enum class EndKind : std::uint8_t { none = 0, umbilic = 1, boundary = 2, cut = 3 };
struct RidgeEnd {
  EndKind kind = EndKind::none;
  Index umbilic = kernel::kNone;  ///< index into RidgeGraph::umbilics
};

/// A ridge of one colour: a loop (both ends none; the last crossing is joined to the first) or a
/// segment from ends[0] to ends[1].
struct Ridge {
  Colour colour;
  bool loop;
  RidgeEnd ends[2];
  std::vector<Crossing> crossings;      ///< in order; at least 1, at least 3 in a loop
  std::vector<RidgeType> third_order;   ///< per segment between consecutive crossings (and closing
                                        ///< one in a loop): the det rule of section 5.3
  std::vector<Vec3> lead_in, lead_out;  ///< points drawn in the umbilic patch before the first and
                                        ///< after the last crossing, centre included
  double length = 0, elliptic_length = 0, hyperbolic_length = 0;
  double strength = 0;   ///< integral of |k1| (blue) or |k2| (red); no unit
  double sharpness = 0;  ///< integral of |P / (k1 - k2)| times model_size^2; no unit
  double weight = 0;     ///< the largest of its crest pieces (salience.hpp); no unit
  std::size_t segment_count() const { return crossings.size() - (loop ? 0u : 1u); }
  /// Fourth-order type of the segment after crossing i: that of its ends, or turning.
  RidgeType fourth_order(std::size_t i) const {
    const RidgeType a = crossings[i].type, b = crossings[(i + 1) % crossings.size()].type;
    return a == b ? a : RidgeType::turning;
  }
};

/// An umbilic: a disk of triangles whose contour the principal directions wind around.
struct Umbilic {
  Index face;           ///< the central triangle (certify/ridges_mesh/SPEC.md)
  Vec3 point;           ///< its centroid
  int twice_index = 0;  ///< +1 and -1 are the generic ones; the sum over a closed mesh is 2 chi
  UmbilicKind kind = UmbilicKind::degenerate;
  bool coherent = false;     ///< the patch's contour has 1 or 3 crossings, as many blue as red
  std::vector<Index> patch;  ///< faces, ascending; a topological disk
  Index border_crossings[2] = {0, 0};  ///< blue and red crossings of its contour
  // Salience (salience.hpp); 0 before it is marked.
  std::uint8_t level = 0;      ///< 1: a significant umbilic; 2: and a salient ridge ends in it
  int region_twice_index = 0;  ///< of the region the umbilic stands for; 0: another one does
};

/// Faces of non-zero index, before grouping into patches.
struct FaceIndex {
  Index face;
  int twice_index;
};

struct RidgeGraph {
  double model_size = 0;                 ///< largest distance of a vertex from the vertices' mean
  std::vector<Ridge> ridges;             ///< blue first; within a colour by smallest edge
  std::vector<Umbilic> umbilics;         ///< by face
  std::vector<FaceIndex> face_indices;   ///< by face; only non-zero ones
  Index conflict_triangles = 0;          ///< triangles with 1 or 3 crossings (section 7.1)
  Index ambiguous_edges = 0;             ///< principal pairs at exactly 90 degrees
  Index zero_extremalities[2] = {0, 0};  ///< vertices with b0 (b3) exactly zero
  /// Vertices with n against the faces around them, with k1 = k2, with n x d1 = 0.
  Index against_faces = 0, equal_curvatures = 0, parallel_frames = 0;
  int twice_index_sum = 0;
};

}  // namespace crest::ridges
