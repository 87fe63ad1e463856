// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A certificate as bytes: digests, seal, files (format: certify/SPEC.md). What a claim states is in
// its room: certify/<claim>/encode.hpp is all that a producer needs.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace crest::certify {

using Bytes = std::vector<std::uint8_t>;
using Digest = std::array<std::uint8_t, 32>;

/// The first bytes of a certificate, up to the end of its data section. They depend on the data
/// alone, so they can be made beside the extraction.
struct EncodedData {
  Bytes bytes;
  Digest digest;  ///< of the data section
};

/// Digest of the data section as encode() writes it.
Digest data_digest(const Bytes& certificate);
std::string hex(const Digest& digest);

/// Recomputes the seal (reseal), or the data digest and the seal (rebind). Throws
/// std::invalid_argument when the container's lengths do not fit the bytes.
void reseal(Bytes& certificate);
void rebind(Bytes& certificate);

/// Writes to a temporary file beside it, then renames. Throws std::runtime_error.
void write_file(const std::string& path, const Bytes& bytes);
Bytes read_file(const std::string& path);

}  // namespace crest::certify
