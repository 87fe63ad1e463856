// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Kind 0: Phi is one-to-one, and its image is all of S (SPEC.md, "One sheet" and "Completeness").
#include "certify/ridges_smooth/box.hpp"
#include "certify/ridges_smooth/faces.hpp"

namespace crest::certify::smooth {

using Ranges = std::array<kernel::Range, 3>;

/// Where y is in its face; exact, about a third.
inline constexpr Barycentric kSheetPoint = {349525 * 0x1p-20, 349525 * 0x1p-20, 349526 * 0x1p-20};

/// The point y of a face, enclosed; nothing if undecided.
std::optional<Ranges> sheet_point(FaceProvers& provers, std::uint32_t face);
/// Of its flat triangle, in double: any vectors prove something.
std::array<std::array<double, 3>, 3> conormals(const RidgesSmoothCertificate& c,
                                               std::uint32_t face);

/// A point y, and the conormals of its face.
struct SheetPoint {
  Ranges y;
  std::array<std::array<double, 3>, 3> conormal;

  /// Does functional 0 to 5 differ from its value at y on the image of the piece?
  template <class Prover>
  bool misses(Prover& prover, std::uint32_t face, const Piece& piece, unsigned functional) const {
    const auto image = prover.image(face, piece, false);
    if (!image) return false;
    if (functional < 3) {
      const kernel::Range x = image->x[functional].range(), at = y[functional];
      return x.low > at.high || x.high < at.low;
    }
    using Model = std::decay_t<decltype(image->x[0])>;
    const auto away = [&](std::size_t k) {
      return (image->x[k] - constants<Model>(y[k])) * conormal[functional - 3][k];
    };
    return has_no_zero(away(0) + away(1) + away(2));
  }
};

/// A positive definite symmetric part of C D(projection), C constant: on a convex domain the map is
/// then injective.
template <class Prover>
bool is_injective(Prover& prover, const RidgesSmoothCertificate& c, const OneSheetRecord& sheet,
                  const Piece& piece) {
  const auto image = prover.image(sheet.face, piece, true);
  if (!image) return false;
  const auto& d = image->derivative;
  const Frame along = frame_of(c.face_records[sheet.face]);
  const auto entry = [&](std::size_t i, std::size_t j) {
    return dot(d[j], along[0]) * sheet.matrix[2 * i] +
           dot(d[j], along[1]) * sheet.matrix[2 * i + 1];
  };
  const auto first = entry(0, 0), twice = entry(0, 1) + entry(1, 0);
  return is_positive(first) && is_positive(first * entry(1, 1) * 4.0 - twice * twice);
}

/// One named face a component, on which Phi is injective and whose y no other face meets.
/// Throws Reject.
void check_one_sheet(const Claim& claim, const std::vector<FaceResult>& faces);

/// The tree's leaves with their cells; at most one a byte. Throws Reject.
struct TreeLeaf {
  Box cell;
  std::uint8_t code;
  std::uint32_t graph_box;
};
std::vector<TreeLeaf> leaves_of(const RidgesSmoothCertificate& c);
/// Of the derivative that has no zero in a leaf with this code; null: F itself.
const std::array<double, 3>* leaf_direction(std::uint8_t code);

/// What the tree and the graph boxes prove. Throws Reject. Returns the number of leaves.
std::size_t check_completeness(const Claim& claim);

}  // namespace crest::certify::smooth
