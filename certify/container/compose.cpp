// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/container/compose.hpp"

#include <algorithm>

#include "certify/container/container.hpp"
#include "certify/container/sha256.hpp"

namespace crest::certify {
namespace {

void write_header(ByteWriter& out, ClaimFormat format, const Digest& digest, std::size_t data,
                  std::size_t claims) {
  out.bytes(kMagic);
  out.integer(format.version);
  out.integer(format.claim);
  out.bytes(digest);
  out.integer(std::uint64_t{data});
  out.integer(std::uint64_t{claims});
}

}  // namespace

EncodedData begin(ClaimFormat format, std::size_t data_size, const WriteSection& write_data) {
  ByteWriter out;
  out.reserve(kHeaderSize + data_size + data_size / 8);
  write_header(out, format, {}, data_size, 0);
  write_data(out);
  EncodedData data{std::move(out.result()), {}};
  data.digest = sha256({std::span(data.bytes).subspan(kHeaderSize)});
  std::copy(data.digest.begin(), data.digest.end(), data.bytes.begin() + kDigestOffset);
  return data;
}

Bytes finish(EncodedData data, const WriteSection& write_claims) {
  ByteWriter out(std::move(data.bytes));
  const std::size_t claims_start = out.size();
  write_claims(out);
  auto claims_size = static_cast<std::uint64_t>(out.size() - claims_start);
  out.bytes(Digest{});
  Bytes bytes = std::move(out.result());
  for (std::size_t i = 0; i < 8; ++i, claims_size >>= 8)
    bytes[kLengthsOffset + 8 + i] = static_cast<std::uint8_t>(claims_size);
  reseal(bytes);
  return bytes;
}

Bytes compose(ClaimFormat format, std::size_t data_size, const WriteSection& write_data,
              const WriteSection& write_claims) {
  return finish(begin(format, data_size, write_data), write_claims);
}

Envelope envelope(ClaimFormat format, std::size_t data_size, const Digest& data_digest,
                  const WriteSection& write_claims) {
  ByteWriter head, tail;
  write_claims(tail);
  write_header(head, format, data_digest, data_size, tail.size());
  tail.bytes(sha256({head.result(), tail.result()}));
  return {std::move(head.result()), std::move(tail.result())};
}

}  // namespace crest::certify
