// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/elastic_block.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using crest::sampling::ElasticBlock;

/// All nodes of the surface prescribed.
template <class U>
void clamp_surface(ElasticBlock& block, const U& u) {
  const auto& n = block.size();
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        if (i % n[0] && j % n[1] && k % n[2]) continue;
        const auto x = u(i, j, k);
        for (std::size_t a = 0; a < 3; ++a) block.prescribed(block.index(i, j, k), a) = x[a];
      }
}

}  // namespace

TEST_CASE("elastic block, patch test: a linear displacement has its constant stress") {
  ElasticBlock block(4, 3, 5);
  const auto u = [](double x, double y, double z) {
    return std::array<double, 3>{0.01 * x + 0.02 * y - 0.03 * z, 0.005 * x - 0.01 * y + 0.02 * z,
                                 0.03 * x + 0.01 * y + 0.04 * z};
  };
  clamp_surface(block, u);
  CHECK(block.solve() > 0);
  const double lambda = 0.3 / (1.3 * 0.4), mu = 1 / 2.6, trace = 0.04;
  const std::array<double, 6> expected{lambda * trace + 2 * mu * 0.01,
                                       lambda * trace - 2 * mu * 0.01,
                                       lambda * trace + 2 * mu * 0.04,
                                       mu * 0.025,
                                       mu * 0.03,
                                       0};
  for (const auto& s : block.nodal_stress())
    for (std::size_t k = 0; k < 6; ++k) CHECK(s[k] == Approx(expected[k]).margin(1e-9));
  for (int k = 0; k <= 5; ++k)
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i <= 4; ++i) {
        const auto x = u(i, j, k);
        for (std::size_t a = 0; a < 3; ++a)
          CHECK(block.displacement()[static_cast<Eigen::Index>(3 * block.index(i, j, k) + a)] ==
                Approx(x[a]).margin(1e-9));
      }
}

TEST_CASE("elastic block: a bar under its ends' pull has uniaxial stress") {
  ElasticBlock block(3, 3, 6);
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i <= 3; ++i) {
      block.prescribed(block.index(i, j, 0), 2) = 0;
      block.prescribed(block.index(i, j, 6), 2) = 0.06;
    }
  block.prescribed(block.index(0, 0, 0), 0) = 0;
  block.prescribed(block.index(0, 0, 0), 1) = 0;
  block.prescribed(block.index(3, 0, 0), 1) = 0;
  block.solve();
  for (const auto& s : block.nodal_stress())
    for (std::size_t k = 0; k < 6; ++k) CHECK(s[k] == Approx(k == 2 ? 0.01 : 0).margin(1e-9));
}

TEST_CASE("elastic block: a symmetric load has symmetric stress, tets fill the block") {
  ElasticBlock block(4, 4, 3);
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i)
      for (std::size_t a = 0; a < 3; ++a) block.prescribed(block.index(i, j, 0), a) = 0;
  block.prescribed(block.index(2, 2, 3), 2) = -0.1;
  block.solve();
  auto stress = block.nodal_stress();
  const auto before = stress;
  for (const std::size_t axis : {0u, 1u}) crest::sampling::symmetrise(block, axis, 1, stress);
  for (std::size_t i = 0; i < stress.size(); ++i)
    for (std::size_t k = 0; k < 6; ++k) CHECK(stress[i][k] == Approx(before[i][k]).margin(1e-8));
  for (int k = 0; k <= 3; ++k)
    for (int j = 0; j <= 4; ++j) CHECK(stress[block.index(2, j, k)][3] == 0);
  double volume = 0;
  for (const auto& t : block.tets()) {
    Eigen::Matrix3d edges;
    const auto at = [](std::uint32_t v) { return Eigen::Vector3d(v % 5, v / 5 % 5, v / 25); };
    for (int c = 0; c < 3; ++c) edges.col(c) = at(t[static_cast<std::size_t>(c) + 1]) - at(t[0]);
    CHECK(edges.determinant() == Approx(1));
    volume += edges.determinant() / 6;
  }
  CHECK(volume == Approx(48));
}
