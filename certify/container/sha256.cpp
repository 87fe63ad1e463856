// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/container/sha256.hpp"

#include <openssl/evp.h>

#include <stdexcept>

namespace crest::certify {
namespace {

void require(bool good) {
  if (!good) throw std::runtime_error("OpenSSL offers no SHA-256");
}

}  // namespace

struct Sha256::Context {
  EVP_MD_CTX* const handle = EVP_MD_CTX_new();
  Context() = default;
  ~Context() { EVP_MD_CTX_free(handle); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  require(context_->handle != nullptr &&
          EVP_DigestInit_ex(context_->handle, EVP_sha256(), nullptr) == 1);
}

Sha256::~Sha256() = default;

void Sha256::add(std::span<const std::uint8_t> piece) {
  require(EVP_DigestUpdate(context_->handle, piece.data(), piece.size()) == 1);
}

Digest Sha256::digest() {
  Digest digest{};
  unsigned length = 0;
  require(EVP_DigestFinal_ex(context_->handle, digest.data(), &length) == 1 &&
          length == digest.size());
  return digest;
}

Digest sha256(std::initializer_list<std::span<const std::uint8_t>> pieces) {
  Sha256 hash;
  for (const auto& piece : pieces) hash.add(piece);
  return hash.digest();
}

}  // namespace crest::certify
