// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A drawing as claim 15 states it.
#include "algorithms/line_art/line_art_result.hpp"
#include "certify/lineart/records.hpp"

namespace crest::line_art {

/// Contours with the events between their pieces, and the hatches with their first faces.
certify::LineArtCertificate line_art_record(const Drawing& drawing);

}  // namespace crest::line_art
