// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 1 as bytes: all that a producer needs.
#include "certify/certificate.hpp"
#include "certify/ridges_mesh/records.hpp"

namespace crest::certify {

EncodedData encode_data(const MeshData& data);

/// The file's bytes, sealed, in canonical form. Cost: linear.
Bytes encode(RidgesMeshCertificate certificate);
/// The same with `data` made before; certificate.data is not read.
Bytes encode(RidgesMeshCertificate certificate, EncodedData data);

}  // namespace crest::certify
