// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "certify/container/container.hpp"
#include "certify/container/sha256.hpp"

namespace crest::certify {
namespace {

/// Open for writing: reseal and rebind report lengths that do not fit as a wrong argument.
Container open_for_sealing(const Bytes& bytes) {
  try {
    return open_container(bytes);
  } catch (const Malformed& problem) {
    throw std::invalid_argument(problem.what());
  }
}

void store_seal(Bytes& bytes, const Digest& seal) {
  std::copy(seal.begin(), seal.end(), bytes.end() - static_cast<std::ptrdiff_t>(kSealSize));
}

}  // namespace

std::string hex(const Digest& digest) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

Digest data_digest(const Bytes& certificate) {
  return open_for_sealing(certificate).data_digest();
}

void reseal(Bytes& certificate) {
  store_seal(certificate, open_for_sealing(certificate).seal());
}

void rebind(Bytes& certificate) {
  const Digest digest = open_for_sealing(certificate).data_digest();
  std::copy(digest.begin(), digest.end(), certificate.begin() + kDigestOffset);
  reseal(certificate);
}

}  // namespace crest::certify
