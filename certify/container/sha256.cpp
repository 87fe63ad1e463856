// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/container/sha256.hpp"

#include <openssl/evp.h>

#include <memory>
#include <stdexcept>

namespace crest::certify {

Digest sha256(std::initializer_list<std::span<const std::uint8_t>> pieces) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(),
                                                                        EVP_MD_CTX_free);
  bool good = context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  for (const auto& piece : pieces)
    good = good && EVP_DigestUpdate(context.get(), piece.data(), piece.size()) == 1;
  Digest digest{};
  unsigned length = 0;
  good = good && EVP_DigestFinal_ex(context.get(), digest.data(), &length) == 1;
  if (!good || length != digest.size()) throw std::runtime_error("OpenSSL offers no SHA-256");
  return digest;
}

}  // namespace crest::certify
