// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The splines of claim 8 straight from SPEC.md, slowly: values, derivatives, Bezier controls.
#include <array>
#include <cstdint>
#include <vector>

#include "certify/extremal/records.hpp"

namespace crest::tests {

using Vec = std::array<double, 3>;
using Sym = std::array<std::array<double, 3>, 3>;

double dot(const Vec& a, const Vec& b);
Vec image(const Sym& m, const Vec& a);
Vec unit(const Vec& a);

/// Eigenvalues descending, unit vectors; by Jacobi's rotations.
struct Eigen3 {
  Vec values;
  std::array<Vec, 3> vectors;
};
Eigen3 eigen(Sym m);

struct PointFields {
  Vec gradient;  ///< of s
  Sym hessian;   ///< of s
  Sym tensor;
  double l;
};

/// Of the controls of an edge, at t in [0, 1].
PointFields on_edge(const std::array<PointFields, 4>& net, double t);

class ReferenceFields {
 public:
  explicit ReferenceFields(const certify::ExtremalData& data);

  /// At a place in units of the grid.
  PointFields at(const Vec& place) const;
  /// 64 Bezier values of a cell, x fastest, of L's derivative by index, of T's component.
  std::vector<double> l_controls(std::uint32_t cell, const std::array<int, 3>& order) const;
  std::vector<double> t_controls(std::uint32_t cell, unsigned i, unsigned j,
                                 const std::array<int, 3>& order) const;
  /// T, grad s, Hess s in world units at the controls.
  std::vector<PointFields> controls(std::uint32_t cell) const;
  std::array<PointFields, 4> edge(std::uint32_t node, unsigned axis) const;

  const certify::ExtremalData& data;
  std::uint32_t nodes;
  Vec place(std::uint32_t node) const;

 private:
  std::vector<double> controls(const std::vector<float>& c, std::uint32_t cell,
                               const std::array<int, 3>& order) const;
  double value(const std::vector<float>& c, const Vec& place,
               const std::array<int, 3>& order) const;

  std::vector<float> l_;
  std::array<std::array<std::vector<float>, 3>, 3> t_;
  mutable std::uint32_t near_cell_ = 0xffffffffU;
  mutable std::array<std::size_t, 64> near_;  ///< the coefficients of that cell
};

/// Weights, as a producer makes them.
std::vector<double> smoothing_weights(double sigma);
/// The data section of a volume (or an image, nz = 1) of floats.
certify::ExtremalData make_data(std::array<std::uint32_t, 3> nodes,
                                const std::vector<float>& samples, Vec spacing = {1, 1, 1},
                                double sigma = 1);

}  // namespace crest::tests
