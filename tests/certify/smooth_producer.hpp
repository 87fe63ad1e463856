// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A second producer of claim 4, kind 1, for the tests: everything by sampling in plain double. What
// it writes is likely on a mesh fine enough, and nothing more; the checker decides.
#include "certify/ridges_smooth/encode.hpp"

namespace crest::tests {

/// A grid of nu x nv squares, each in two triangles, vertices moved by up to `jitter` cells; a
/// patch is the face of an umbilic and `rings` rings of faces around it.
certify::RidgesSmoothCertificate smooth_grid(const certify::SmoothSurfaceData& surface, int nu,
                                             int nv, double jitter, int rings, std::uint64_t seed);

/// x, y, z and the domain; periodic: bit 0 in u, bit 1 in v.
certify::SmoothSurfaceData parametric(std::string x, std::string y, std::string z,
                                      std::array<std::string, 4> domain, int periodic = 0);

/// Certificates that the checker accepts, by name: without umbilic, one umbilic of each index, a
/// period.
struct NamedSmoothClaim {
  const char* name;
  certify::RidgesSmoothCertificate certificate;
};
std::vector<NamedSmoothClaim> smooth_claims();

}  // namespace crest::tests
