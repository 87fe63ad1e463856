// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The container of certify/SPEC.md: header, data section, claim section, seal.
#include <span>
#include <stdexcept>

#include "certify/certificate.hpp"
#include "certify/container/buffer.hpp"

namespace crest::certify {

inline constexpr std::array<std::uint8_t, 8> kMagic = {'C', 'R', 'E', 'S', 'T', 'C', 'R', 'T'};
inline constexpr std::uint32_t kVersion = 1;
inline constexpr std::uint32_t kRidgesMesh = 1, kFeaturesMesh = 2, kReeb = 3, kRidgesSmooth = 4;
/// Bytes of an expression.
inline constexpr std::size_t kLongestText = 65535;
inline constexpr std::size_t kDigestOffset = 16, kLengthsOffset = 48, kHeaderSize = 64,
                             kSealSize = 32;
/// Bytes of a face, and of a vertex (position and Monge data).
inline constexpr std::size_t kFaceSize = 12, kVertexSize = 17 * 8;

/// The bytes are not a certificate: the text says which part.
class Malformed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Views into the bytes of a certificate.
struct Container {
  std::uint32_t version, claim;
  Digest stated_data_digest, stated_seal;
  std::span<const std::uint8_t> header, data, claims;

  Digest data_digest() const;
  Digest seal() const;
};

/// A file for verify(); certify/certificate.hpp's read_file without touching the memory twice.
Buffer<std::uint8_t> read_buffer(const std::string& path);

/// Throws Malformed if the magic is another or the lengths do not add up to the bytes. Reads
/// neither section.
Container open_container(std::span<const std::uint8_t> bytes);

/// The data section alone, and the claim section of claim 1 into `certificate` (data untouched).
/// Every length is compared with the bytes left before anything is allocated.
/// Throws Malformed: counts that do not fit, numbers not finite or -0, bytes left over.
MeshData decode_data(std::span<const std::uint8_t> data);
void decode_claims(std::span<const std::uint8_t> claims, RidgesMeshCertificate& certificate);

/// Both sections of claim 2. Throws Malformed, also for marks other than 0 and 1.
FeaturesMeshCertificate decode_features_mesh(std::span<const std::uint8_t> data,
                                             std::span<const std::uint8_t> claims);

/// A ReebCertificate for checking: the positions, on which nothing depends, stay in the bytes.
struct ReebContents {
  std::size_t vertices = 0;
  std::span<const std::uint8_t> positions;
  Buffer<std::array<std::uint32_t, 3>> faces;
  Buffer<double> values, edge_values;
  std::int32_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0, components = 0;
  std::uint32_t line_critical = 0, face_critical = 0, tiles = 0;
  std::uint32_t minima = 0, saddles = 0, maxima = 0;
  Buffer<std::uint32_t> order, critical_nodes;
  Buffer<ArcRecord> arcs;
  Buffer<CutRecord> cuts;
};
/// Both sections of claim 3. Throws Malformed. The number of midpoint values is what the data
/// section's length leaves: whether it is the number of edges is a check of step 1.
ReebContents open_reeb(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims);
/// The same as the producer's struct.
ReebCertificate decode_reeb(std::span<const std::uint8_t> data,
                            std::span<const std::uint8_t> claims);

/// Both sections of claim 4. Throws Malformed, also for codes that have no meaning.
RidgesSmoothCertificate decode_ridges_smooth(std::span<const std::uint8_t> data,
                                             std::span<const std::uint8_t> claims);

}  // namespace crest::certify
