// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one form of a claim (SPEC.md, "Canonical form").
#include "certify/ridges_mesh/encode.hpp"

namespace crest::certify {

/// Sorts faces, patches and ridges and gives each ridge its start and direction; ends keep naming
/// their patches. Idempotent. Throws std::invalid_argument if an end names no patch or a ridge has
/// no node. Cost: linear plus the sorting of records.
void make_canonical(RidgesMeshCertificate& certificate);

/// encode() without make_canonical: the records in the order and direction given.
Bytes encode_as_is(const RidgesMeshCertificate& certificate);

}  // namespace crest::certify
