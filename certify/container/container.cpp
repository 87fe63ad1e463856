// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/container/container.hpp"

#include <algorithm>

#include "certify/container/byte_reader.hpp"
#include "certify/container/sha256.hpp"

namespace crest::certify {

Digest Container::data_digest() const {
  return sha256({data});
}

Digest Container::seal() const {
  return sha256({header, claims});
}

Container open_container(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderSize + kSealSize) throw Malformed("shorter than a header and a seal");
  ByteReader reader(bytes);
  const auto magic = reader.take(kMagic.size());
  if (!std::equal(magic.begin(), magic.end(), kMagic.begin()))
    throw Malformed("not a certificate (magic)");
  Container c{};
  c.version = reader.integer<std::uint32_t>();
  c.claim = reader.integer<std::uint32_t>();
  const auto digest = reader.take(kSealSize);
  std::copy(digest.begin(), digest.end(), c.stated_data_digest.begin());
  const auto data = reader.integer<std::uint64_t>(), claims = reader.integer<std::uint64_t>();
  const std::uint64_t room = bytes.size() - kHeaderSize - kSealSize;
  if (data > room || claims != room - data) throw Malformed("section lengths do not fit the file");
  c.header = bytes.first(kHeaderSize);
  c.data = reader.take(data);
  c.claims = reader.take(claims);
  const auto seal = reader.take(kSealSize);
  std::copy(seal.begin(), seal.end(), c.stated_seal.begin());
  return c;
}

}  // namespace crest::certify
