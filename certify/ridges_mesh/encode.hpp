// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 1 as bytes: all that a producer needs.
#include <functional>
#include <span>

#include "certify/certificate.hpp"
#include "certify/container/compose.hpp"
#include "certify/ridges_mesh/records.hpp"

namespace crest::certify {

/// MeshData whose rows of Monge forms are made one by one, each time they are asked for.
struct DataRows {
  const std::vector<std::array<std::uint32_t, 3>>& faces;
  const std::vector<std::array<double, 3>>& positions;
  std::function<std::array<double, 14>(std::size_t)> monge;
};
/// Takes bytes in pieces, one after the other.
using TakePiece = std::function<void(std::span<const std::uint8_t>)>;

/// Of the data section. Cost: linear, a piece at a time in memory.
Digest digest_of(const DataRows& rows);
/// What stands around the data section, in canonical form; certificate.data is not read.
Envelope encode_envelope(RidgesMeshCertificate certificate, const DataRows& rows,
                         const Digest& digest);
/// The file's bytes: the envelope with the data section in it.
void hand_on(const Envelope& envelope, const DataRows& rows, const TakePiece& take);

/// All of them, sealed, in canonical form. Cost: linear.
Bytes encode(RidgesMeshCertificate certificate);

}  // namespace crest::certify
