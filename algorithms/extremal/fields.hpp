// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The spline pair (L, T) of a volume: coefficients in binary32, made by the sequence of binary64
// operations that certify/extremal/SPEC.md states, and its values.
#include <array>
#include <functional>
#include <vector>

#include "algorithms/extremal/extremal.hpp"
#include "algorithms/extremal/grid.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/polynomial/spline_net.hpp"
#include "kernel/predicates/cone_test.hpp"

namespace crest::extremal {

using Tensor = kernel::Symmetric3<double>;  ///< xx yy zz xy yz xz
using kernel::product;
using Coefficients = kernel::SplineCell<double, 3>;

/// Weights w_0 .. w_R of the smoothing along each axis; one weight: none.
using Weights = std::array<std::vector<double>, 3>;
Weights smoothing_weights(const Grid& grid, double sigma);

/// Throws kernel::InputError as extract does, for all that can be seen without samples.
void check_frame(const Volume& volume, const Options& options);

/// All that is asked of the fields at a point. World units; s = -L or L.
struct Local {
  Vec3 gradient;   ///< of s
  Tensor hessian;  ///< of s
  Tensor tensor;   ///< T
  double value;    ///< L
  double s;
};

/// The same, exactly.
struct ExactLocal {
  kernel::Symmetric3<kernel::Rational> hessian, tensor;
  kernel::Rational value;
};

class Fields {
 public:
  /// Throws kernel::InputError as extract does. `samples` are not kept. The grid is the refined
  /// one. `first`: where the volume begins in the whole of which it is a part, for errors.
  Fields(const Volume& volume, const Options& options, const Node& first = {});
  /// Given coefficients; no tensors: T = Hess s.
  Fields(const Grid& grid, Side side, std::vector<float> scalars,
         std::vector<std::vector<float>> tensors);

  const Grid& grid() const { return grid_; }
  bool structure() const { return structure_; }
  /// s = sign() L
  double sign() const { return sign_; }
  /// Of T's splines, in this order, there are so many: xx yy zz xy yz xz; an image: xx yy xy.
  const std::vector<std::vector<float>>& tensors() const { return tensors_; }
  const std::vector<float>& scalars() const { return scalars_; }
  /// Where tensors()[i] stands among xx yy zz xy yz xz.
  std::size_t entry(std::size_t i) const { return grid_.dimension() == 3 || i < 2 ? i : 3; }
  const Weights& scalar_weights() const { return scalar_weights_; }
  const Weights& tensor_weights() const { return tensor_weights_; }

  /// The 64 coefficients that the cell with lowest node v sees; beyond the border they repeat.
  Coefficients coefficients(const std::vector<float>& spline, const Node& v) const;
  /// At t of the cell [v, v + 1].
  Local at(const Node& v, const Vec3& t) const;
  /// The same of t as it stands, exactly.
  ExactLocal exact_at(const Node& v, const Vec3& t) const;
  /// What n and its sign are made from at a node, with bounds of the errors in every entry.
  struct AtNode {
    Tensor tensor;
    Vec3 gradient;
    double tensor_size, tensor_error, gradient_error;
  };
  AtNode at_node(const Node& v) const;
  /// The same exactly; the tensor times a positive number.
  std::pair<kernel::Symmetric3<kernel::Rational>, kernel::Vector3<kernel::Rational>> exact_at_node(
      const Node& v) const;
  /// Of an image's T, in place of the entry zz: below all eigenvalues in the plane.
  static double below(const Tensor& t);

 private:
  void smooth(const std::function<void(int, double*)>& slice, const Weights& weights,
              std::vector<float>& result) const;
  /// The same splines on the grid of half the spacing.
  void halve_grid();

  Grid grid_;
  bool structure_;
  double sign_;
  Weights scalar_weights_, tensor_weights_;
  std::vector<float> scalars_;
  std::vector<std::vector<float>> tensors_;
};

/// The grid halved so many times.
Grid refined(Grid grid, int levels);

/// Nine numbers that two derivatives make of spacing: index units to world units.
Tensor world_hessian(const Tensor& h, const Vec3& spacing);

}  // namespace crest::extremal
