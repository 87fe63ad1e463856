// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// False certificates from true ones.
#include <string>

#include "certify/ridges_mesh/encode.hpp"
#include "tests/certify/sample_meshes.hpp"

namespace crest::tests {

/// The certificate as structs; the bytes must be well formed.
certify::RidgesMeshCertificate decode(const certify::Bytes& bytes);

/// Bits, bytes, numbers, cuts, insertions anywhere in the file; the container's lengths are
/// sometimes made to fit again.
certify::Bytes mutate_bytes(certify::Bytes bytes, Random& random);

/// Where the mutant departs from its original, for the message of a failing test.
std::string difference_in_words(const certify::Bytes& original, const certify::Bytes& mutant);

/// A wrong record: dropped, doubled, swapped, with another number, type, end, order or count.
/// Returns what was done; the certificate may be unchanged when the record does not exist.
std::string mutate_claim(certify::RidgesMeshCertificate& certificate, Random& random);

}  // namespace crest::tests
