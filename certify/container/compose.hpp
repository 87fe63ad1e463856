// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The container around a claim's two sections (certify/SPEC.md), for encoders.
#include <functional>

#include "certify/container/byte_writer.hpp"

namespace crest::certify {

using WriteSection = std::function<void(ByteWriter&)>;

/// What a header says of its claim: each room's records.hpp has its own.
struct ClaimFormat {
  std::uint32_t claim, version;
};

/// Header and data section; the claim section's length is still open. Requires: write_data writes
/// data_size bytes.
EncodedData begin(ClaimFormat format, std::size_t data_size, const WriteSection& write_data);
/// Claim section and seal.
Bytes finish(EncodedData data, const WriteSection& write_claims);
/// Both.
Bytes compose(ClaimFormat format, std::size_t data_size, const WriteSection& write_data,
              const WriteSection& write_claims);

/// What stands before and after the data section of a certificate that is written without being in
/// memory as a whole.
struct Envelope {
  Bytes head, tail;
};
Envelope envelope(ClaimFormat format, std::size_t data_size, const Digest& data_digest,
                  const WriteSection& write_claims);

}  // namespace crest::certify
