// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which corners of the mesh are kept: L and s_nn at the places written (SPEC.md, "Trim").
#include "certify/extremal/components.hpp"

namespace crest::certify::extremal {

/// Throws Reject unless there are as many places as the mesh has corners; Undecided where n is
/// not certain.
Kept trim(const ExtremalCertificate& c, const Splines& splines, const Mesh& mesh);

}  // namespace crest::certify::extremal
