// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The witnesses of claim 4 (certify/ridges_smooth/SPEC.md, "Witnesses"): a producer's last pass.
// Nothing here is trusted: it searches with the checker's own enclosures for what the checker will
// only evaluate, and crest-verify does not hold it.
#include <optional>
#include <string>

#include "certify/ridges_smooth/records.hpp"

namespace crest::certify {

/// Fills in everything that version 2 records beside the claim: the fibres' lengths, loose corners,
/// the witnesses of faces, patches and graph boxes, all of one sheet but its faces; and divides
/// leaves of the tree. The same for any number of threads. Returns what could not be shown, in one
/// line, or nothing. Requires: all else, one_sheet with its faces. Cost: about that of a check that
/// searches; on all cores.
std::optional<std::string> record_witnesses(RidgesSmoothCertificate& c);

}  // namespace crest::certify
