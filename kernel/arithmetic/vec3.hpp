// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Points and vectors of the plane and of space over any number type. Sums run from the first
// coordinate to the last, so that all who use them round alike. The operators are those of
// std::array: other namespaces name them (using kernel::operator+).
#include <array>
#include <cmath>
#include <type_traits>

namespace crest::kernel {

template <class T>
using Vector2 = std::array<T, 2>;
template <class T>
using Vector3 = std::array<T, 3>;
using Vec2 = Vector2<double>;
using Vec3 = Vector3<double>;

template <class T>
Vector2<T> operator+(const Vector2<T>& a, const Vector2<T>& b) {
  return {a[0] + b[0], a[1] + b[1]};
}
template <class T>
Vector3<T> operator+(const Vector3<T>& a, const Vector3<T>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class T>
Vector2<T> operator-(const Vector2<T>& a, const Vector2<T>& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
template <class T>
Vector3<T> operator-(const Vector3<T>& a, const Vector3<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class T>
Vector2<T> operator*(const std::type_identity_t<T>& s, const Vector2<T>& a) {
  return {s * a[0], s * a[1]};
}
template <class T>
Vector3<T> operator*(const std::type_identity_t<T>& s, const Vector3<T>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}

template <class T>
T dot(const Vector2<T>& a, const Vector2<T>& b) {
  return a[0] * b[0] + a[1] * b[1];
}
template <class T>
T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// The determinant of (a, b).
template <class T>
T cross(const Vector2<T>& a, const Vector2<T>& b) {
  return a[0] * b[1] - a[1] * b[0];
}
template <class T>
Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class T>
T determinant(const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c) {
  return dot(cross(a, b), c);
}

/// The root of a . a, whose squares may overflow or vanish.
template <class T>
T norm(const Vector2<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
template <class T>
T norm(const Vector3<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
/// Without overflow or loss at any size; not to the last bit norm(a - b).
inline double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The same vector over another number type that holds doubles exactly.
template <class T>
Vector3<T> lift(const Vec3& a) {
  return {T(a[0]), T(a[1]), T(a[2])};
}

}  // namespace crest::kernel
