// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The surface of claim 4 (SPEC.md, "Data section"): expressions, proven periods, values and
// derivatives over a model type.
#include <array>
#include <optional>
#include <tuple>
#include <type_traits>
#include <vector>

#include "certify/ridges_smooth/records.hpp"
#include "kernel/arithmetic/jet.hpp"
#include "kernel/expressions/enclosures.hpp"

namespace crest::certify::smooth {

using Model3 = kernel::TaylorModel<3>;
using Model4 = kernel::TaylorModel<4>;
using Model5 = kernel::TaylorModel<5>;
using MpModel3 = kernel::MpTaylorModel<3>;
using MpModel4 = kernel::MpTaylorModel<4>;
using MpModel5 = kernel::MpTaylorModel<5>;
/// Models over MPFR intervals.
template <class M>
concept MpModel =
    std::is_same_v<M, MpModel3> || std::is_same_v<M, MpModel4> || std::is_same_v<M, MpModel5>;

/// Vectors p, q, m of exact doubles.
using Frame = std::array<std::array<double, 3>, 3>;
/// Of a face's record ("Forms"): exact, at most 2^16.
Frame frame_of(const SmoothFaceRecord& record);

struct Surface {
  bool implicit;
  std::vector<kernel::Expression> texts;  ///< kind 0: F; kind 1: x, y, z, u0, u1, v0, v1
  std::array<bool, 2> periodic;
  std::array<double, 6> box;
};

/// Step 1. Throws Reject: texts that do not parse, an empty box or domain, a period not provable.
Surface parse_surface(const SmoothSurfaceData& data);

/// The period u1 - u0 = 2 pi q of direction i (0: u) is proven for x, y and z by the rules of the
/// specification. Throws Reject.
void prove_period(const std::vector<kernel::Expression>& texts, std::size_t i);

/// Expressions over the model type M, ready to be called. Not for two threads at a time.
template <class M>
class SurfaceEvaluator {
 public:
  using Point = std::array<M, 3>;

  explicit SurfaceEvaluator(const Surface& surface) : surface_(surface) {}

  /// Kind 0: F.
  M value(const Point& x);
  /// Kind 0: F and its derivatives up to n = 1, 3, 4, 5.
  template <int n>
  kernel::Jet<M, 3, n> implicit(const Point& x);
  /// The same by coordinates along three vectors.
  template <int n>
  kernel::Jet<M, 3, n> implicit(const Point& x, const Frame& frame);
  /// Kind 1: x, y, z and their derivatives by the unit coordinates up to n = 3, 4, 5.
  template <int n>
  std::array<kernel::Jet<M, 2, n>, 3> immersion(const M& u, const M& v);

  const Surface& surface() const { return surface_; }

 private:
  template <int Variables, int n>
  using Program = std::optional<kernel::Evaluator<kernel::Jet<M, Variables, n>>>;

  const Surface& surface_;
  std::optional<kernel::Evaluator<M>> value_;
  // Made when first called: F of kind 0, x, y, z of kind 1.
  std::tuple<Program<3, 1>, Program<3, 3>, Program<3, 4>, Program<3, 5>> implicit_;
  std::tuple<Program<2, 3>, Program<2, 4>, Program<2, 5>> immersion_;
  std::vector<M> domain_;  ///< u0, u1 - u0, v0, v1 - v0
};

}  // namespace crest::certify::smooth
