// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 15, lineart, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kLineArt = 15, kLineArtVersion = 1;

/// What happens to the number of faces in front where a drawn edge passes a place.
struct LineEvent {
  enum Kind : std::uint8_t { kCrossing = 0, kPiercing = 1 };
  Kind kind = kCrossing;
  std::uint32_t first = 0, second = 0;  ///< crossing: the occluding edge, first < second;
                                        ///< piercing: the face, 0
  auto operator<=>(const LineEvent&) const = default;
};

/// Part of an edge between two places: faces in front, and those of them that do not only touch it.
struct LinePiece {
  std::uint32_t front = 0, hiding = 0;
  auto operator<=>(const LinePiece&) const = default;
};

/// breaks.size() + 1 pieces from `low` to `high`, none where the edge is seen end-on.
struct LineEdge {
  std::uint32_t low = 0, high = 0;  ///< vertices, low < high
  /// Between two pieces: the events there, ascending; none where `hiding` alone changes.
  std::vector<std::vector<LineEvent>> breaks;
  std::vector<LinePiece> pieces;
};

/// Where points come on the page, in millimetres. Parallel: page = (scale[0] X.p - origin[0],
/// origin[1] - scale[1] Y.p), X = up x e, Y = e x X, up = axes[1], axes[0] = axes[2] = 0.
/// Perspective, q = p - e: page = ((x.q / z.q - origin[0]) scale[0], (origin[1] - y.q / z.q)
/// scale[1]).
struct LineView {
  std::array<std::array<double, 3>, 3> axes{};
  std::array<double, 2> origin{}, scale{};
};

/// Claim lineart: what is visible of the contours of a set of triangles, and where hatches start.
struct LineArtCertificate {
  std::vector<std::array<double, 3>> points;          ///< V, no two equal
  std::vector<std::array<std::uint32_t, 3>> faces;    ///< F, three different corners
  std::array<double, 3> eye{};                        ///< the eye, or the direction towards it
  bool parallel = false;                              ///< the latter
  std::vector<std::array<std::uint32_t, 2>> creases;  ///< low < high, ascending; edges of faces
  LineView view;
  std::vector<std::vector<std::array<double, 2>>> hatches;  ///< polylines on the page

  std::vector<LineEdge> edges;             ///< the drawn ones, ascending by (low, high)
  std::vector<std::uint32_t> hatch_faces;  ///< H: the nearest one where the hatch starts
};

}  // namespace crest::certify
