// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A direction with positive products with many vectors of R^N: the point nearest to the origin of
// their convex hull, by Wolfe's algorithm (Math. Programming 11, 1976). A heuristic: what it finds
// is proven elsewhere, that it finds nothing proves nothing.
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace crest::modes {

/// Vectors of R^N by their components, so that one passes over them with vector instructions.
template <std::size_t N, std::size_t Most>
struct VectorList {
  std::array<std::array<double, Most>, N> component;
  std::size_t size = 0;
};

template <std::size_t N, std::size_t Most>
class HalfSpace {
 public:
  using Vector = std::array<double, N>;

  /// Requires: unit vectors. The least product is at least half of the best there is.
  static std::optional<Vector> search(const VectorList<N, Most>& vectors) {
    if (vectors.size == 0) return std::nullopt;
    HalfSpace s(vectors);
    return s.run();
  }

 private:
  explicit HalfSpace(const VectorList<N, Most>& vectors) : v_(vectors) {}

  static double dot(const Vector& a, const Vector& b) {
    double r = 0;
    for (std::size_t k = 0; k < N; ++k) r += a[k] * b[k];
    return r;
  }
  Vector vector(std::size_t j) const {
    Vector r;
    for (std::size_t k = 0; k < N; ++k) r[k] = v_.component[k][j];
    return r;
  }

  std::optional<Vector> run() {
    constexpr double least = 1e-10;  // of |x|^2: below it no rounded direction would do
    add(0);
    part_[0] = 1;
    Vector x = active_vectors_[0];
    for (int round = 0; round < 60; ++round) {
      std::array<double, Most> products;
      for (std::size_t j = 0; j < v_.size; ++j) products[j] = 0;
      for (std::size_t k = 0; k < N; ++k)
        for (std::size_t j = 0; j < v_.size; ++j) products[j] += x[k] * v_.component[k][j];
      std::size_t worst = 0;
      for (std::size_t j = 1; j < v_.size; ++j)
        if (products[j] < products[worst]) worst = j;
      const double norm = dot(x, x), least_product = products[worst];
      if (norm < least) return std::nullopt;
      if (least_product >= 0.5 * norm) return x;
      for (std::size_t k = 0; k < size_; ++k)
        if (active_[k] == worst) return least_product > 0 ? std::optional(x) : std::nullopt;
      if (size_ == N + 1) return std::nullopt;
      add(worst);
      if (!reduce(x)) return std::nullopt;
    }
    return std::nullopt;
  }

  void add(std::size_t j) {
    active_[size_] = j;
    active_vectors_[size_] = vector(j);
    part_[size_++] = 0;
  }

  /// Moves x to the nearest point of the active vectors' hull.
  bool reduce(Vector& x) {
    while (true) {
      std::array<double, N + 1> y{};
      if (!affine_nearest(y)) return false;
      double step = 1;
      std::size_t drop = size_;
      for (std::size_t k = 0; k < size_; ++k)
        if (y[k] <= 1e-14 && part_[k] - y[k] > 0) {
          const double t = part_[k] / (part_[k] - y[k]);
          if (t < step || drop == size_) {
            step = std::fmin(t, 1);
            drop = k;
          }
        }
      for (std::size_t k = 0; k < size_; ++k) part_[k] += step * (y[k] - part_[k]);
      if (drop < size_) {
        --size_;
        active_[drop] = active_[size_];
        active_vectors_[drop] = active_vectors_[size_];
        part_[drop] = part_[size_];
        if (size_ == 0) return false;
        continue;
      }
      x.fill(0);
      for (std::size_t k = 0; k < size_; ++k)
        for (std::size_t i = 0; i < N; ++i) x[i] += part_[k] * active_vectors_[k][i];
      return true;
    }
  }

  /// Weights of sum 1 of the point nearest to the origin of the active vectors' affine hull.
  bool affine_nearest(std::array<double, N + 1>& y) const {
    std::array<std::array<double, N + 2>, N + 1> a{};
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t j = 0; j < size_; ++j)
        a[i][j] = 1 + dot(active_vectors_[i], active_vectors_[j]);
      a[i][size_] = 1;
    }
    for (std::size_t c = 0; c < size_; ++c) {
      std::size_t pivot = c;
      for (std::size_t r = c + 1; r < size_; ++r)
        if (std::fabs(a[r][c]) > std::fabs(a[pivot][c])) pivot = r;
      if (std::fabs(a[pivot][c]) < 1e-13) return false;
      std::swap(a[c], a[pivot]);
      for (std::size_t r = c + 1; r < size_; ++r) {
        const double k = a[r][c] / a[c][c];
        for (std::size_t j = c; j <= size_; ++j) a[r][j] -= k * a[c][j];
      }
    }
    double sum = 0;
    for (std::size_t c = size_; c-- > 0;) {
      double s = a[c][size_];
      for (std::size_t j = c + 1; j < size_; ++j) s -= a[c][j] * y[j];
      y[c] = s / a[c][c];
      sum += y[c];
    }
    if (!(sum > 1e-13)) return false;
    for (std::size_t c = 0; c < size_; ++c) y[c] /= sum;
    return true;
  }

  const VectorList<N, Most>& v_;
  std::array<std::size_t, N + 1> active_{};
  std::array<Vector, N + 1> active_vectors_{};
  std::array<double, N + 1> part_{};
  std::size_t size_ = 0;
};

}  // namespace crest::modes
