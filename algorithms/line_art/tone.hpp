// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From grey to widths of strokes.
#include "algorithms/line_art/line_art_result.hpp"
#include "algorithms/line_art/streamlines.hpp"

namespace crest::line_art {

struct ToneOptions {
  double spacing = 0.8;     ///< s, mm
  double darkest = 0.35;    ///< cmin: what one layer of hatches reaches
  double brightest = 0.95;  ///< cmax: no stroke above
  double thinnest = 0.05;   ///< mm
  double cap = 0.85;        ///< of the spacing: no stroke wider
  int corrections = 3;
};

/// The page's part and length that belong to every vertex of every hatch: pixels nearer to it than
/// to any other, not across contours nor farther than one and a half spacings.
struct OwnedArea {
  std::vector<std::vector<double>> area, spacing;  ///< mm^2; area over length, mean over 2 mm
  /// Whose a pixel is: hatch (kNone: nobody's) and vertex.
  std::vector<std::pair<Index, Index>> owner;
};
OwnedArea owned_area(const Buffers& buffers, const std::vector<Hatch>& hatches, double reach);

/// How much of every pixel the strokes cover, 0 to 1.
std::vector<float> coverage(const Buffers& buffers, const std::vector<Hatch>& hatches);

/// Sets the widths: ink times the owned area over the length, then corrected by what the strokes
/// cover. `ink`: wanted share of black at every pixel.
void set_widths(const Buffers& buffers, const std::vector<float>& ink, const ToneOptions& options,
                const OwnedArea& owned, std::vector<Hatch>& hatches);

/// The thesis' way: bands of constant width, of which the ink's share is black, the rest white, in
/// the order of painting that keeps the right ones: each segment's ribs by bit-reversed rank.
void set_bands(const Buffers& buffers, const std::vector<float>& ink, const ToneOptions& options,
               std::vector<Hatch>& hatches);

/// 0 .. n - 1 in the order rev(0), rev(1), .. of m bits, 2^m >= n > 2^(m - 1); what is n or more is
/// skipped.
std::vector<Index> bit_reversed(Index n);

/// 1 - luminance within the range that one layer can show; 0 above the brightest.
std::vector<float> layer_ink(const Buffers& buffers, const ToneOptions& options);

/// Of cross hatching, the second layer, where it is darker than the first can show. Inks of
/// crossing layers multiply: (cmin - c) / cmin; `plain`: the thesis' cmin - c.
std::vector<float> crossing_ink(const Buffers& buffers, const ToneOptions& options, bool plain);

/// Of the shares of two layers that cross.
std::vector<float> crossed(std::vector<float> a, const std::vector<float>& b);

/// |black - ink| in cells of five spacings that the surface fills by half.
ToneError tone_error(const Buffers& buffers, const std::vector<float>& black,
                     const std::vector<float>& ink, double spacing);

}  // namespace crest::line_art
