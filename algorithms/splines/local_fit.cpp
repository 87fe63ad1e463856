// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/local_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace crest::splines {
namespace {

constexpr double kCondition = 1e-4;  ///< the least singular value over the largest

/// Whether a triangular matrix is well enough conditioned. The bound by norms decides nearly
/// always.
template <class Matrix>
bool determines(const Matrix& r) {
  const auto n = r.rows();
  const Eigen::MatrixXd upper = r.template triangularView<Eigen::Upper>();
  if ((upper.diagonal().array() == 0).any()) return false;
  const double inverse =
      upper.template triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(n, n)).norm();
  if (1 >= kCondition * upper.norm() * inverse) return true;
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(upper).singularValues();
  return singular(n - 1) >= kCondition * singular(0);
}

}  // namespace

struct LocalFit::Workspace {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd temporary = Eigen::VectorXd(kMonomials + 1);
};

LocalFit::LocalFit(const Scattered& samples, const Scattered::Request& request,
                   std::array<bool, 3> flat)
    : samples_(samples), request_(request), workspace_(std::make_unique<Workspace>()) {
  const auto along = monomials({flat[0] ? 0.0 : 1.0, flat[1] ? 0.0 : 1.0, flat[2] ? 0.0 : 1.0});
  for (std::size_t degree = 0, m = 0; degree < 4; ++degree) {
    for (; m < kMonomialsUpTo[degree]; ++m)
      if (along[m] != 0) columns_.push_back(m);
    columns_up_to_[degree] = columns_.size();
  }
}

LocalFit::~LocalFit() = default;

LocalCubic LocalFit::operator()(const Vec3& centre) {
  samples_.gather(centre, request_, near_);
  LocalCubic fit{.centre = centre, .samples = static_cast<int>(near_.size())};
  double square = 0;
  for (const auto& near : near_) square = std::max(square, near.square);
  if (square > 0) fit.radius = std::sqrt(square);

  std::size_t degree = 3;
  while (degree > 0 && columns_up_to_[degree] > near_.size()) --degree;
  const auto rows = static_cast<Eigen::Index>(near_.size());
  const auto columns = static_cast<Eigen::Index>(columns_up_to_[degree]);
  Eigen::MatrixXd& a = workspace_->matrix;
  a.resize(rows, columns + 1);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Sample& s = samples_[near_[static_cast<std::size_t>(i)].sample];
    Vec3 v;
    for (std::size_t d = 0; d < 3; ++d) v[d] = (s.x[d] - centre[d]) / fit.radius;
    const auto m = monomials(v);
    for (Eigen::Index j = 0; j < columns; ++j) a(i, j) = m[columns_[static_cast<std::size_t>(j)]];
    a(i, columns) = s.value;
  }
  for (Eigen::Index j = 0; j < columns; ++j) {
    auto right = a.bottomRightCorner(rows - j, columns - j);
    double tau, beta;
    a.col(j).tail(rows - j).makeHouseholderInPlace(tau, beta);
    a(j, j) = beta;
    right.applyHouseholderOnTheLeft(a.col(j).tail(rows - j - 1), tau, workspace_->temporary.data());
  }
  const auto triangle = [&] {
    const auto size = static_cast<Eigen::Index>(columns_up_to_[degree]);
    return a.topLeftCorner(size, size);
  };
  while (degree > 0 && !determines(triangle())) --degree;
  const auto n = static_cast<Eigen::Index>(columns_up_to_[degree]);
  const Eigen::VectorXd c = triangle().triangularView<Eigen::Upper>().solve(a.col(columns).head(n));
  for (Eigen::Index j = 0; j < n; ++j) fit.c[columns_[static_cast<std::size_t>(j)]] = c(j);
  fit.degree = static_cast<int>(degree);
  return fit;
}

}  // namespace crest::splines
