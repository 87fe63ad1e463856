// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Words in pictures of pixels.
#include <string>

#include "io/picture/rasteriser.hpp"

namespace crest::io {

/// Draws with the baseline from (x, y) on, `size` pixels high; in the sans serif strokes that cairo
/// brings along: the same everywhere, whatever fonts there are.
void draw_text(Canvas& canvas, double x, double y, double size, const std::string& text);

/// The width of a text that is `size` pixels high.
double text_width(const std::string& text, double size);

}  // namespace crest::io
