// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The enhanced frame buffer as files, to look at and to edit (paper 001, figure 3.22).
#include <string>
#include <vector>

#include "algorithms/line_art/buffers.hpp"
#include "algorithms/line_art/stroke.hpp"

namespace crest::io {

/// What --save-buffers PREFIX adds to PREFIX.
inline constexpr const char* kBufferFiles[] = {"-luminance.png", "-normal.png", "-curvature.png",
                                               "-lic.png", "-buffers.vti"};

/// One of kBufferFiles. The LIC picture (Cabral and Leedom: white noise, always the same, over 20
/// pixels) has the contours laid over it.
std::string buffer_file(const std::string& which, const line_art::Buffers& buffers,
                        const std::vector<line_art::Stroke>& contours);

/// Luminance from a PNG of the page's size in pixels, grey: what 255 is is 1.
/// Throws: kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY".
void read_luminance(const std::string& path, line_art::Buffers& buffers);

}  // namespace crest::io
