// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 1 as bytes: all that a producer needs.
#include <functional>

#include "certify/certificate.hpp"
#include "certify/ridges_mesh/records.hpp"

namespace crest::certify {

EncodedData encode_data(const MeshData& data);
/// The same for a mesh whose rows of Monge forms are made one by one.
EncodedData encode_data(const std::vector<std::array<std::uint32_t, 3>>& faces,
                        const std::vector<std::array<double, 3>>& positions,
                        const std::function<std::array<double, 14>(std::size_t)>& monge);

/// The file's bytes, sealed, in canonical form. Cost: linear.
Bytes encode(RidgesMeshCertificate certificate);
/// The same with `data` made before; certificate.data is not read.
Bytes encode(RidgesMeshCertificate certificate, EncodedData data);

}  // namespace crest::certify
