// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A census as claim modes (certify/modes/SPEC.md).
#include "algorithms/modes/modes.hpp"
#include "certify/modes/encode.hpp"

namespace crest::modes {

certify::ModesCertificate make_certificate(const Input& input, const Census& census);

}  // namespace crest::modes
