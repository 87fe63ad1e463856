// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Least squares of local samples by a polynomial of degree 3, or of as much as they determine
// (section 9.4.1).
#include <array>
#include <memory>
#include <vector>

#include "algorithms/splines/local_cubic.hpp"
#include "algorithms/splines/scattered.hpp"

namespace crest::splines {

class LocalFit {
 public:
  /// `flat`: axes on which no polynomial is to depend.
  LocalFit(const Scattered& samples, const Scattered::Request& request,
           std::array<bool, 3> flat = {});
  ~LocalFit();

  /// The fit of the samples near a place. A degree is taken if it has no more coefficients than
  /// there are samples, and the singular values of its matrix, variables over the radius of the
  /// farthest sample, are at least 1e-4 of the largest.
  LocalCubic operator()(const Vec3& centre);

 private:
  struct Workspace;
  const Scattered& samples_;
  Scattered::Request request_;
  std::vector<std::size_t> columns_;          ///< the monomials in use
  std::array<std::size_t, 4> columns_up_to_;  ///< of each degree
  std::vector<Scattered::Near> near_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace crest::splines
