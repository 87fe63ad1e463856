// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SHA-256 over pieces (OpenSSL).
#include <initializer_list>
#include <memory>
#include <span>

#include "certify/certificate.hpp"

namespace crest::certify {

/// The digest of the pieces one after the other. Throws std::runtime_error if OpenSSL has none.
Digest sha256(std::initializer_list<std::span<const std::uint8_t>> pieces);

/// The same for pieces that come one after the other. Throws as sha256().
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;
  void add(std::span<const std::uint8_t> piece);
  /// Of all that was added; once.
  Digest digest();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace crest::certify
