// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Small meshes with Monge data, regular and degenerate, for the certificate tests.
#include <cstdint>
#include <string>
#include <vector>

#include "certify/ridges_mesh/encode.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

struct Sample {
  std::string name;
  certify::MeshData data;
};

/// Uniform in [-1, 1).
double uniform(Random& random);

/// Surfaces (Monge data zero). Icosahedron with every face split into 4^level, on the unit sphere.
certify::MeshData icosphere(int level);
certify::MeshData torus(std::uint32_t m, std::uint32_t n);
/// A grid of (m + 1)(n + 1) vertices in the plane z = 0; with a hole, the middle square is missing.
certify::MeshData grid(std::uint32_t m, std::uint32_t n, bool hole = false);

/// Ellipsoid with its principal directions and curvatures, b as derivatives of smooth functions.
certify::MeshData ellipsoid(int level, double a, double b, double c);
/// Random d1, n, b; k1 >= k2.
void randomize_monge(certify::MeshData& data, Random& random);
void scale_positions(certify::MeshData& data, double factor);

/// All of them: regular, random, with boundary, two components, all-zero b, axis frames (products
/// exactly zero), exact half-turn ties, extreme scales, tilted and null projections of d1.
std::vector<Sample> all_samples();

}  // namespace crest::tests
