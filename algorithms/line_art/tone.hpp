// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From grey to widths of strokes.
#include "algorithms/line_art/coverage.hpp"
#include "algorithms/line_art/line_art_result.hpp"

namespace crest::line_art {

struct ToneOptions {
  double spacing = 0.8;     ///< s, mm
  double darkest = 0.35;    ///< cmin: what one layer of hatches reaches
  double brightest = 0.95;  ///< cmax: no stroke above
  double thinnest = 0.05;   ///< mm
  double cap = 0.85;        ///< of the spacing: no stroke wider
};

/// One direction of hatching: its lines, the share of black wanted of it at every pixel, what its
/// lines own of the page.
struct Layer {
  std::vector<Hatch>& hatches;
  const std::vector<float>& ink;
  const OwnedArea& owned;
};

/// Sets the widths: ink times the owned area over the length, then corrected by what the layers
/// cover together.
void set_widths(const Buffers& buffers, const std::vector<Layer>& layers,
                const ToneOptions& options);

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

/// Cells of five spacings that the surface fills by half.
std::vector<ToneCell> tone_cells(const Buffers& buffers, const std::vector<float>& black,
                                 const std::vector<float>& ink, const OwnedArea& owned,
                                 double spacing);
/// Of |black - ink|.
ToneError tone_error(std::vector<ToneCell> cells);

}  // namespace crest::line_art
