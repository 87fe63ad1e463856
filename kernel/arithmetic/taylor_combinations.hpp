// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Linear combinations of the same Taylor models with weights that are known up to an error: one
// bound for the rounding of a whole sum where + and * take one each.
#include <array>
#include <cmath>
#include <cstddef>

#include "kernel/arithmetic/taylor_lanes.hpp"

namespace crest::kernel {

inline constexpr double kLeastSize = 0x1p-900;

/// At most Most models, which must outlive this.
///
/// Theorem. of(w, error) encloses sum w*_i f_i for all |w*_i - w_i| <= error and all f_i that the
/// models enclose. Proof. Let S_i be the sum of |c| in model i, N their number. In floating point a
/// term w_i c carries at most N factors (1 + d), |d| <= u: all coefficients together err by at most
/// 1.01 N u sum |w_i| S_i. The models add sum |w_i| radius_i, the weights error sum (S_i +
/// radius_i), as |u^j v^k| <= 1. The bound takes at most 2^8 operations (taylor_model.hpp, (c)); no
/// S_i is so small that u S_i, which meets a w_i of any size, would underflow.
template <int Order, std::size_t Most>
class TaylorCombinations {
  static_assert(Most <= 32);

 public:
  using Model = TaylorModel<Order>;

  void add(const Model& f) {
    models_[count_] = &f;
    sizes_[count_] = Model::Kernels::size(f.c) + kLeastSize;
    all_ += sizes_[count_] + f.radius;
    ++count_;
  }
  std::size_t size() const { return count_; }

  Model of(const std::array<double, Most>& weights, double error) const {
    const double rounding = 1.02 * Model::Kernels::kUnit * static_cast<double>(count_);
    std::array<double, Model::kCount> c{};
    double radius = error * all_;
    for (std::size_t i = 0; i < count_; ++i) {
      const double w = weights[i];
      const Model& f = *models_[i];
      for (std::size_t m = 0; m < Model::kCount; ++m) c[m] += w * f.c[m];
      radius += std::fabs(w) * (f.radius + rounding * sizes_[i]);
    }
    Model r;
    r.c = c;
    r.radius = grow(radius);
    return r;
  }

 private:
  std::array<const Model*, Most> models_{};
  std::array<double, Most> sizes_{};
  double all_ = 0;
  std::size_t count_ = 0;
};

/// The same of eight models at once, with weights a lane.
template <int Order, std::size_t Most>
class TaylorLaneCombinations {
 public:
  using Model = TaylorLanes<Order>;

  void add(const Model& f) {
    models_[count_] = &f;
    taylor::sizes_of(f.rows, sizes_[count_]);
    sizes_[count_] = sizes_[count_] + kLeastSize;
    all_ = all_ + (sizes_[count_] + f.radius());
    ++count_;
  }
  std::size_t size() const { return count_; }

  Model of(const std::array<Lanes, Most>& weights, const Lanes& error) const {
    const double rounding = 1.02 * Model::Model::Kernels::kUnit * static_cast<double>(count_);
    Model r;
    Lanes radius = error * all_;
    for (std::size_t i = 0; i < count_; ++i) {
      taylor::add_scaled(models_[i]->rows, weights[i], r.rows);
      radius = radius + magnitude(weights[i]) * (models_[i]->radius() + rounding * sizes_[i]);
    }
    for (std::size_t l = 0; l < Lanes::count; ++l) r.radius().x[l] = grow(radius.x[l]);
    return r;
  }

 private:
  std::array<const Model*, Most> models_{};
  std::array<Lanes, Most> sizes_;
  Lanes all_ = 0;
  std::size_t count_ = 0;
};

template <class Model, std::size_t Most>
struct CombinationsOf;
template <int Order, std::size_t Most>
struct CombinationsOf<TaylorModel<Order>, Most> {
  using Type = TaylorCombinations<Order, Most>;
};
template <int Order, std::size_t Most>
struct CombinationsOf<TaylorLanes<Order>, Most> {
  using Type = TaylorLaneCombinations<Order, Most>;
};

}  // namespace crest::kernel
