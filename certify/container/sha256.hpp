// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SHA-256 over pieces (OpenSSL).
#include <initializer_list>
#include <span>

#include "certify/certificate.hpp"

namespace crest::certify {

/// The digest of the pieces one after the other. Throws std::runtime_error if OpenSSL has none.
Digest sha256(std::initializer_list<std::span<const std::uint8_t>> pieces);

}  // namespace crest::certify
