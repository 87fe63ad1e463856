// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vectors of three over any number type; results may be of another type
// (certify/exact/filtered.hpp).

namespace crest::certify {

template <class T>
struct Vector {
  T x, y, z;
};

template <class T>
Vector(T, T, T) -> Vector<T>;

template <class A, class B>
auto operator-(const Vector<A>& a, const Vector<B>& b) {
  return Vector{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class A, class B>
auto operator*(const A& c, const Vector<B>& b) {
  return Vector{c * b.x, c * b.y, c * b.z};
}
template <class A, class B>
auto dot(const Vector<A>& a, const Vector<B>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class A, class B>
auto cross(const Vector<A>& a, const Vector<B>& b) {
  return Vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Three coordinates lifted from doubles to the number type of `lift`.
template <class Lift>
auto lift_vector(const Lift& lift, const double* p) {
  return Vector{lift(p[0]), lift(p[1]), lift(p[2])};
}

}  // namespace crest::certify
