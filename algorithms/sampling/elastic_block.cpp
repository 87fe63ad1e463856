// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/elastic_block.hpp"

#include <cmath>

namespace crest::sampling {

namespace {

Eigen::Vector3d corner(std::size_t c) {
  return {static_cast<double>(c & 1), static_cast<double>(c >> 1 & 1), static_cast<double>(c >> 2)};
}
/// xx yy zz xy yz xz, shears as engineering strains.
Eigen::Matrix<double, 6, 6> elasticity() {
  constexpr double e = 1, nu = 0.3, lambda = e * nu / ((1 + nu) * (1 - 2 * nu)),
                   mu = e / (2 * (1 + nu));
  Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
  d.topLeftCorner<3, 3>().setConstant(lambda);
  for (int k = 0; k < 6; ++k) d(k, k) += k < 3 ? 2 * mu : mu;
  return d;
}
Eigen::Matrix<double, 6, 24> strain_matrix(const Eigen::Vector3d& x) {
  Eigen::Matrix<double, 6, 24> b = Eigen::Matrix<double, 6, 24>::Zero();
  for (std::size_t c = 0; c < 8; ++c) {
    const Eigen::Vector3d at = corner(c);
    Eigen::Vector3d value, g;
    for (int k = 0; k < 3; ++k) value[k] = at[k] > 0 ? x[k] : 1 - x[k];
    for (int k = 0; k < 3; ++k)
      g[k] = (at[k] > 0 ? 1 : -1) * value[(k + 1) % 3] * value[(k + 2) % 3];
    const int o = static_cast<int>(3 * c);
    b(0, o) = b(3, o + 1) = b(5, o + 2) = g[0];
    b(1, o + 1) = b(3, o) = b(4, o + 2) = g[1];
    b(2, o + 2) = b(4, o + 1) = b(5, o) = g[2];
  }
  return b;
}
Eigen::Matrix<double, 24, 24> cube_stiffness() {
  Eigen::Matrix<double, 24, 24> k = Eigen::Matrix<double, 24, 24>::Zero();
  const double g = std::sqrt(3.0) / 6;
  for (std::size_t c = 0; c < 8; ++c) {
    const Eigen::Vector3d x =
        Eigen::Vector3d::Constant(0.5) + g * (2 * corner(c) - Eigen::Vector3d::Ones());
    const Eigen::Matrix<double, 6, 24> b = strain_matrix(x);
    k += b.transpose() * elasticity() * b / 8;
  }
  return k;
}

Eigen::Matrix<double, 24, 1> gather(const Eigen::VectorXd& x,
                                    const std::array<std::size_t, 8>& node) {
  Eigen::Matrix<double, 24, 1> local;
  for (std::size_t c = 0; c < 8; ++c)
    local.segment<3>(static_cast<Eigen::Index>(3 * c)) =
        x.segment<3>(static_cast<Eigen::Index>(3 * node[c]));
  return local;
}
/// Whether the split of the cube in place i of n is mirrored along an axis. Faces between cubes do
/// not depend on their own axis, so any rule fits: neighbours and both halves are mirror images.
int mirrored(int i, int n) {
  return 2 * i < n ? i % 2 : 1 - (n - 1 - i) % 2;
}

}  // namespace

ElasticBlock::ElasticBlock(int nx, int ny, int nz) : n_{nx, ny, nz}, stiffness_(cube_stiffness()) {
  prescribed_.assign(3 * nodes(), kFree);
  u_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * nodes()));
}

template <class F>
void ElasticBlock::for_each_cube(const F& f) const {
  for (int k = 0; k < n_[2]; ++k)
    for (int j = 0; j < n_[1]; ++j)
      for (int i = 0; i < n_[0]; ++i) {
        std::array<std::size_t, 8> node;
        for (std::size_t c = 0; c < 8; ++c)
          node[c] = index(i + static_cast<int>(c & 1), j + static_cast<int>(c >> 1 & 1),
                          k + static_cast<int>(c >> 2));
        f(node);
      }
}
Eigen::VectorXd ElasticBlock::times(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
  for_each_cube([&](const std::array<std::size_t, 8>& node) {
    const Eigen::Matrix<double, 24, 1> local = stiffness_ * gather(x, node);
    for (std::size_t c = 0; c < 8; ++c)
      y.segment<3>(static_cast<Eigen::Index>(3 * node[c])) +=
          local.segment<3>(static_cast<Eigen::Index>(3 * c));
  });
  return y;
}
Eigen::VectorXd ElasticBlock::diagonal() const {
  Eigen::VectorXd d = Eigen::VectorXd::Zero(u_.size());
  for_each_cube([&](const std::array<std::size_t, 8>& node) {
    for (std::size_t c = 0; c < 8; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        d[static_cast<Eigen::Index>(3 * node[c] + k)] +=
            stiffness_(static_cast<Eigen::Index>(3 * c + k), static_cast<Eigen::Index>(3 * c + k));
  });
  return d;
}

int ElasticBlock::solve(int most) {
  const auto free = [&](Eigen::Index i) {
    return prescribed_[static_cast<std::size_t>(i)] == kFree;
  };
  for (Eigen::Index i = 0; i < u_.size(); ++i)
    u_[i] = free(i) ? 0 : prescribed_[static_cast<std::size_t>(i)];
  Eigen::VectorXd r = -times(u_), scale = diagonal();
  const auto clear = [&](Eigen::VectorXd& x) {
    for (Eigen::Index i = 0; i < x.size(); ++i)
      if (!free(i)) x[i] = 0;
  };
  clear(r);
  Eigen::VectorXd z = r.cwiseQuotient(scale), p = z;
  double rho = r.dot(z);
  const double target = rho * 1e-20;
  int steps = 0;
  while (rho > target && steps < most) {
    Eigen::VectorXd q = times(p);
    clear(q);
    const double step = rho / p.dot(q);
    u_ += step * p;
    r -= step * q;
    z = r.cwiseQuotient(scale);
    const double next = r.dot(z);
    p = z + next / rho * p;
    rho = next;
    ++steps;
  }
  return steps;
}

std::vector<std::array<double, 6>> ElasticBlock::nodal_stress() const {
  std::vector<std::array<double, 6>> stress(nodes());
  std::vector<int> count(nodes(), 0);
  std::array<Eigen::Matrix<double, 6, 24>, 8> at;
  for (std::size_t c = 0; c < 8; ++c) at[c] = elasticity() * strain_matrix(corner(c));
  for_each_cube([&](const std::array<std::size_t, 8>& node) {
    const Eigen::Matrix<double, 24, 1> local = gather(u_, node);
    for (std::size_t c = 0; c < 8; ++c) {
      const Eigen::Matrix<double, 6, 1> s = at[c] * local;
      for (std::size_t k = 0; k < 6; ++k) stress[node[c]][k] += s[static_cast<Eigen::Index>(k)];
      ++count[node[c]];
    }
  });
  for (std::size_t i = 0; i < stress.size(); ++i)
    for (double& x : stress[i]) x /= count[i];
  return stress;
}

std::vector<std::array<std::uint32_t, 4>> ElasticBlock::tets() const {
  static constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
  std::vector<std::array<std::uint32_t, 4>> tets;
  for (int k = 0; k < n_[2]; ++k)
    for (int j = 0; j < n_[1]; ++j)
      for (int i = 0; i < n_[0]; ++i)
        for (std::size_t order = 0; order < 6; ++order) {
          const std::array<int, 3> cube{i, j, k};
          const std::array<int, 3> turned{mirrored(i, n_[0]), mirrored(j, n_[1]),
                                          mirrored(k, n_[2])};
          std::array<int, 3> step{};
          std::array<std::uint32_t, 4> tet{};
          for (std::size_t s = 0; s < 4; ++s) {
            std::array<int, 3> c{};
            for (std::size_t d = 0; d < 3; ++d)
              c[d] = cube[d] + (turned[d] ? 1 - step[d] : step[d]);
            tet[s] = static_cast<std::uint32_t>(index(c[0], c[1], c[2]));
            if (s < 3) step[kOrders[order][s]] = 1;
          }
          if ((order >= 3) != ((turned[0] + turned[1] + turned[2]) % 2 == 1))
            std::swap(tet[2], tet[3]);
          tets.push_back(tet);
        }
  return tets;
}

void symmetrise(const ElasticBlock& block, std::size_t axis, double sign,
                std::vector<std::array<double, 6>>& stress) {
  const auto& n = block.size();
  const std::array<double, 6> parity = axis == 0   ? std::array<double, 6>{1, 1, 1, -1, 1, -1}
                                       : axis == 1 ? std::array<double, 6>{1, 1, 1, -1, -1, 1}
                                                   : std::array<double, 6>{1, 1, 1, 1, -1, -1};
  const auto before = stress;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        std::array<int, 3> c{i, j, k};
        c[axis] = n[axis] - c[axis];
        const auto &own = before[block.index(i, j, k)],
                   &image = before[block.index(c[0], c[1], c[2])];
        for (std::size_t m = 0; m < 6; ++m)
          stress[block.index(i, j, k)][m] = (own[m] + sign * parity[m] * image[m]) / 2;
      }
}

}  // namespace crest::sampling
