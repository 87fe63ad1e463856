// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "What the checker proves, in order": the second checker of claim 4.
#include "certify/second/certificate.hpp"

namespace crest::recheck {

/// Proves the claim of a certificate's bytes and returns it in words.
/// Throws: Rejected with what is wrong or was not proven.
std::string recheck(const Bytes& file);

}  // namespace crest::recheck
