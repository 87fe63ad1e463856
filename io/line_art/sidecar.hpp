// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The sidecar of a drawing (.json): what makes it again, and what may be steered.
#include <string>

#include "algorithms/line_art/line_art_result.hpp"

namespace crest::io {

/// View, segments, contours (all pieces), strokes, counts of what was left out: README.md of
/// algorithms/line_art says what is read back. Doubles read back the same.
std::string sidecar_of(const line_art::Drawing& drawing);

/// The steering of a sidecar that was made for the same view.
/// Throws: kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY".
line_art::Steering read_sidecar(const std::string& path, const line_art::View& view);

}  // namespace crest::io
