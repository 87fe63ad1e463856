// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The container of certify/SPEC.md: header, data section, claim section, seal.
#include <span>
#include <stdexcept>

#include "certify/certificate.hpp"
#include "certify/container/buffer.hpp"

namespace crest::certify {

inline constexpr std::array<std::uint8_t, 8> kMagic = {'C', 'R', 'E', 'S', 'T', 'C', 'R', 'T'};
inline constexpr std::size_t kDigestOffset = 16, kLengthsOffset = 48, kHeaderSize = 64,
                             kSealSize = 32;
/// Bytes of a triangle.
inline constexpr std::size_t kFaceSize = 12;

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

}  // namespace crest::certify
