// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stress of a block of unit cubes by linear elasticity (E = 1, nu = 0.3), as a tensor field on
// tets: trilinear hexahedra, conjugate gradients without a matrix, stress at the nodes as the mean
// over their cubes.
#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace crest::sampling {

class ElasticBlock {
 public:
  static constexpr double kFree = std::numeric_limits<double>::infinity();

  /// Cubes along x, y, z; all nodes free.
  ElasticBlock(int nx, int ny, int nz);

  const std::array<int, 3>& size() const { return n_; }
  std::size_t nodes() const { return index(n_[0], n_[1], n_[2]) + 1; }
  std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i + (n_[0] + 1) * (j + (n_[1] + 1) * k));
  }
  /// Of a node's coordinate; kFree: no force there.
  double& prescribed(std::size_t node, std::size_t axis) { return prescribed_[3 * node + axis]; }

  /// Returns the number of iterations (Jacobi's preconditioner; the residual falls to 1e-10).
  int solve(int most = 20000);
  const Eigen::VectorXd& displacement() const { return u_; }
  /// xx yy zz xy yz xz at every node.
  std::vector<std::array<double, 6>> nodal_stress() const;

  /// Six a cube, along its diagonal; every cube's split is its neighbours' mirror image, so that
  /// the mesh is symmetric about each plane of nodes.
  std::vector<std::array<std::uint32_t, 4>> tets() const;

 private:
  template <class F>
  void for_each_cube(const F& f) const;
  Eigen::VectorXd times(const Eigen::VectorXd& x) const;
  Eigen::VectorXd diagonal() const;

  std::array<int, 3> n_;
  Eigen::Matrix<double, 24, 24> stiffness_;
  std::vector<double> prescribed_;
  Eigen::VectorXd u_;
};

/// The mean of the stress and its mirror image about the middle plane across an axis: the symmetry
/// becomes exact. sign -1: the image is that of -T (a load that pushes on one side and pulls on the
/// other).
void symmetrise(const ElasticBlock& block, std::size_t axis, double sign,
                std::vector<std::array<double, 6>>& stress);

}  // namespace crest::sampling
