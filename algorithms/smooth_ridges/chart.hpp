// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Taylor models of the map Phi from a face to the surface (certify/ridges_smooth/SPEC.md,
// "Triangulation"), and the proof of the chart conditions (F) and (J).
//
// Implicit: with p(l) and m(l) linear, Phi(l) = p(l) + s(l) m(l). Let D enclose the derivative
// grad F . m along the fibre for |s| <= h. If D > 0 and N = s1 - F(p + s1 m) / D stays within
// (-h, h) for some function s1 there, the fibre has one zero in |s| <= h and it lies in N: by the
// mean value theorem F(p + s1 m) = D (s1 - s), and F at the ends +-h has the signs of h - N and
// -h - N. N is the model of s. The polynomial s1 is one Newton step from s = 0.
// (J) is a polynomial in s, its coefficients linear in l, so bounded by their values at corners.
// Parametric: U and V are linear on the face.
#include <array>
#include <optional>

#include "algorithms/smooth_ridges/projection.hpp"

namespace crest::smooth_ridges {

template <class Model>
struct Chart {
  /// Implicit: x, y, z of Phi. Parametric: lifted U, V, and 0.
  std::array<Model, 3> x;
  /// Their derivatives by l1 and l2 (l0 + l1 + l2 constant); implicit: after tangents().
  std::array<std::array<Model, 3>, 2> dx;
  // Implicit: the fibre.
  Model s;
  std::array<Model, 3> m;
  double h = 0;
};

/// (J) for |s| <= h, with room for rounding.
bool jacobian_is_positive(const std::array<Vertex, 3>& corners, double h);

/// Model: kernel::TaylorModel<3>, <4> or <5>. Not for two threads at a time.
template <class Model>
class Charts {
 public:
  explicit Charts(const Surface& surface);

  /// Nothing if (F) or (J) is not decided. Cost: one gradient and one value of F over Model.
  std::optional<Chart<Model>> operator()(const std::array<Vertex, 3>& corners);
  /// Adds dx: s_i = -(grad F . (p_i + s m_i)) / (grad F . m). `gradient`: of F on chart.x.
  static void tangents(Chart<Model>& chart, const std::array<Vertex, 3>& corners,
                       const std::array<Model, 3>& gradient);
  /// The same, with the gradient evaluated here.
  void tangents(Chart<Model>& chart, const std::array<Vertex, 3>& corners);

  /// Parametric: adds dx.
  static void directions(Chart<Model>& chart, const std::array<Vertex, 3>& corners);
  /// Implicit: about twice the largest |s|, from the face's centre and its edges' midpoints.
  double guess_reach(const std::array<Vertex, 3>& corners);

 private:
  using Models = std::array<Model, 3>;

  bool solve_fibres(Chart<Model>& chart, const Models& p);

  std::optional<kernel::Evaluator<double>> value_;
  std::optional<ImplicitMap<Model, 0>> value_model_;
  std::optional<ImplicitMap<Model, 1>> gradient_model_;
};

extern template class Charts<kernel::TaylorModel<3>>;
extern template class Charts<kernel::TaylorModel<4>>;
extern template class Charts<kernel::TaylorModel<5>>;

}  // namespace crest::smooth_ridges
