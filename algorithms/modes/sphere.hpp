// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The medium eigenvector as parameter of all mode surfaces of one linear field (paper 004, section
// 4 and equation 14), in plain doubles: closed-form points, and a second way to every vertex of a
// mesh.
//
// Letters: v medium eigenvector, a unit vector; Tbar the unit traceless tensor orthogonal to the
// field, det <= 0; alpha = v.Tbar v, beta = |Tbar v|^2; rho half the gap of Tbar's eigenvalues in
// the plane across v, 4 rho^2 = 2 - 4 beta + alpha^2; sin(theta) = sqrt3 tan(arcsin|mu| / 3). The
// dominant eigenvector makes the angles +-1/2 arccos(alpha sin(theta) / (2 rho)) with Tbar's major
// axis in that plane: equation 5 without an asymmetric tensor.
#include <array>
#include <optional>

#include "algorithms/modes/small_matrix.hpp"

namespace crest::modes {

/// A linear field given by four corners' tensors. Requires: independent deviators.
class LinearTensors {
 public:
  explicit LinearTensors(const std::array<Tensor, 4>& corners);

  const Matrix3& characteristic() const { return bar_; }  ///< Tbar (equation 3)
  double characteristic_mode() const { return bar_mode_; }
  /// Tbar's eigenvectors as rows, eigenvalues in descending order.
  const Matrix3& frame() const { return frame_; }
  const kernel::Vec3& eigenvalues() const { return eigenvalues_; }

  /// Barycentric coordinates of the point where the field is a multiple of U, a tensor of its span;
  /// s is that multiple. s = 0: none (a point at infinity).
  struct Place {
    std::array<double, 4> weights;
    double s;
  };
  Place place(const Matrix3& u) const;

 private:
  Matrix3 bar_, frame_;
  kernel::Vec3 eigenvalues_;
  double bar_mode_;
  std::array<Matrix3, 4> dual_;
};

/// sin(theta) for a mode.
double sine_of_theta(double mu);

/// Equation 6's left side, (4 rho^2 - alpha^2 sin^2 theta) / 4: real domain where >= 0.
double real_domain(const LinearTensors& field, const kernel::Vec3& v, double mu);

struct ModePoint {
  Matrix3 tensor;  ///< unit, of mode +|mu|
  kernel::Vec3 dominant;
  std::array<double, 4> weights;
  int sign;  ///< of the mode at the point: of s
};
/// Both points whose medium eigenvector is v; nothing outside the real domain or at rho = 0.
std::optional<std::array<ModePoint, 2>> mode_points(const LinearTensors& field,
                                                    const kernel::Vec3& v, double mu);

/// rho = 0: (+-a, 0, +-c) in Tbar's frame; here a, c >= 0.
struct IrregularPoints {
  double a, c;
};
IrregularPoints irregular_points(const LinearTensors& field);

/// A point of the complex domain's boundary with that alpha, in Tbar's frame, all coordinates >= 0
/// (equations 7 to 9); nothing if there is none.
std::optional<kernel::Vec3> boundary_point(const LinearTensors& field, double alpha, double mu);

/// Equation 14 corrected: sin(theta) in y, and normalised. In Tbar's frame.
kernel::Vec3 quad_grid(const IrregularPoints& p, double theta, double eta);
/// The orthogonal grid with the same irregular points.
kernel::Vec3 spheroconal_grid(const IrregularPoints& p, double theta, double eta);

}  // namespace crest::modes
