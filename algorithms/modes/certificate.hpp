// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 6 (certify/modes/SPEC.md): the trees of a level, as they were decided.
#include "algorithms/modes/modes.hpp"
#include "algorithms/modes/zero_set.hpp"
#include "certify/modes/encode.hpp"

namespace crest::modes {

/// extract(), with the record of its trees and counts. Throws: kernel::InputError where the tensors
/// are too large for claim 6: its lambdas go with their size and must stay numbers.
ModeResult extract(const ModeField& field, const Level& level, const ModeOptions& options,
                   certify::ModeLevel& record, const Workers* workers = nullptr);

/// The field before the zeros' insertion, these, and the levels' records.
certify::ModesCertificate make_certificate(const ModeField& field, const ZeroSet& zeros,
                                           std::vector<certify::ModeLevel> levels);

}  // namespace crest::modes
