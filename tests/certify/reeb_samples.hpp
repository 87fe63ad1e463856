// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Small surfaces of many kinds with functions on them, for the tests of claim 3.
#include "certify/reeb/records.hpp"
#include "tests/certify/sample_meshes.hpp"

namespace crest::tests {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

struct ReebSurface {
  std::string name;
  Faces faces;
  std::size_t vertices;
  std::uint32_t genus;  ///< of closed orientable ones, all components together
  bool closed_orientable;
};
/// Spheres, tori, genus 2 and 3, disks, annuli, Moebius strip, projective plane, Klein bottle, two
/// components, one triangle; with vertices and faces shuffled and, on half of them,
/// faces turned around.
std::vector<ReebSurface> reeb_surfaces(Random& random);

enum class Values { random, small, constant, ramp, mixed };
/// Data without claims: values of that kind at the vertices and, with degree 2, at the midpoints.
certify::ReebCertificate reeb_data(const ReebSurface& surface, int degree, Values kind,
                                   Random& random);

}  // namespace crest::tests
