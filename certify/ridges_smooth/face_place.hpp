// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// FaceProver's points, edges and forms, for the translation units that instantiate it.
#include "certify/ridges_smooth/face.hpp"
#include "certify/ridges_smooth/immersion.hpp"
#include "certify/ridges_smooth/implicit_impl.hpp"

namespace crest::certify::smooth {

/// The constant b - a.
template <class M>
M difference(double b, double a) {
  const double d = b - a;
  return M::around(d, std::fabs(d) * 0x1p-53);
}

template <class M>
M FaceProver<M>::affine(std::uint32_t face, std::size_t coordinate, const Piece& piece,
                        const std::array<M, 3>& l) const {
  const auto at = [&](std::size_t i) { return c_.vertices[c_.faces[face][i]][coordinate]; };
  if (piece.whole) return M::linear(at(0), at(1), at(2));
  return l[0] * at(0) + l[1] * at(1) + l[2] * at(2);
}

template <class M>
auto FaceProver<M>::place(std::uint32_t face, const Piece& piece) -> std::optional<Place> {
  const bool lifted = !c_.lifts.empty() && c_.lifts[face] != 0;
  std::array<M, 3> l;
  if (!piece.whole || lifted) l = coordinates<M>(piece);
  Place at;
  if (!surface_.surface().implicit) {
    at.u = affine(face, 0, piece, l);
    at.v = affine(face, 1, piece, l);
    for (std::size_t i = 0; lifted && i < 3; ++i) {
      if (lift_of(c_, face, i, 0) != 0) at.u = at.u + l[i];
      if (lift_of(c_, face, i, 1) != 0) at.v = at.v + l[i];
    }
    return at;
  }
  Vector3 p;
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = affine(face, k, piece, l);
    at.m[k] = affine(face, k + 3, piece, l);
  }
  const auto foot = find_foot(surface_, p, at.m, fibre_length(c_, face));
  if (!foot) return std::nullopt;
  at.x = foot->x;
  at.s = foot->s;
  return at;
}

template <class M>
auto FaceProver<M>::step(const Place& at, std::uint32_t face, std::size_t i, std::size_t j) const
    -> Vector3 {
  const auto& a = c_.vertices[c_.faces[face][i]];
  const auto& b = c_.vertices[c_.faces[face][j]];
  Vector3 r;
  for (std::size_t k = 0; k < 3; ++k)
    r[k] = difference<M>(b[k], a[k]) + difference<M>(b[k + 3], a[k + 3]) * at.s;
  return r;
}

/// (J) at the s of the foot. It is far from zero on small faces: double intervals nearly always do.
template <class M>
bool FaceProver<M>::keeps_orientation(const Place& at, std::uint32_t face) const {
  if constexpr (!MpModel<M>) {
    using kernel::Interval;
    const kernel::Range range = at.s.range();
    const kernel::RoundUpward guard;
    const Interval s(range.low, range.high);
    std::array<std::array<Interval, 3>, 2> side;
    std::array<Interval, 3> m;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = [&](std::size_t i, std::size_t c) {
        return c_.vertices[c_.faces[face][i]][c];
      };
      for (std::size_t i = 0; i < 2; ++i)
        side[i][k] = Interval(corner(i + 1, k)) - corner(0, k) +
                     (Interval(corner(i + 1, k + 3)) - corner(0, k + 3)) * s;
      const auto [low, high] = std::minmax({corner(0, k + 3), corner(1, k + 3), corner(2, k + 3)});
      m[k] = Interval(low, high);
    }
    if (dot(cross(side[0], side[1]), m).inf() > 0) return true;
  }
  const Vector3 a = step(at, face, 0, 1), b = step(at, face, 0, 2);
  return is_positive(dot(cross(a, b), at.m));
}

template <class M>
auto FaceProver<M>::image(std::uint32_t face, const Piece& piece, bool with_derivatives)
    -> std::optional<Image> {
  const auto at = place(face, piece);
  if (!at) return std::nullopt;
  Image r{at->x, {}};
  if (!with_derivatives) return r;
  const Vector3 grad = gradient(surface_.template implicit<1>(at->x));
  const M factor = -inverse(dot(grad, at->m));
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector3 d = step(*at, face, 0, i + 1);
    r.derivative[i] = along(d, dot(grad, d) * factor, at->m);
  }
  return r;
}

template <class M>
auto FaceProver<M>::edges(const Place& at, std::uint32_t face, const Vector3& gradient) const
    -> std::array<Vector2, 3> {
  std::array<Vector2, 3> edge;
  if (!surface_.surface().implicit) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t d = 0; d < 2; ++d) {
        const std::size_t j = (i + 1) % 3;
        const auto& a = c_.vertices[c_.faces[face][i]];
        const auto& b = c_.vertices[c_.faces[face][j]];
        edge[i][d] =
            difference<M>(b[d], a[d]) + M(lift_of(c_, face, j, d) - lift_of(c_, face, i, d));
      }
    return edge;
  }
  // In the frame's coordinates, all times n, a positive factor.
  const Frame frame = frame_of(c_.face_records[face]);
  const auto in_frame = [&](const Vector3& x) {
    return Vector3{dot(x, frame[0]), dot(x, frame[1]), dot(x, frame[2])};
  };
  const Vector3 m = in_frame(at.m);
  const M factor = -inverse(dot(gradient, m));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 d = in_frame(step(at, face, i, (i + 1) % 3));
    const M back = dot(gradient, d) * factor;
    edge[i] = {d[0] + back * m[0], d[1] + back * m[1]};
  }
  return edge;
}

template <class M>
template <int K>
auto FaceProver<M>::jets(const Place& at, std::uint32_t face, bool with_edges)
    -> std::optional<Jets<K>> {
  Jets<K> r;
  if (!surface_.surface().implicit) {
    const auto x = surface_.template immersion<3 + K>(at.u, at.v);
    if (!are_defined(x)) return std::nullopt;  // (A)
    r.forms = surface_forms<K, 3 + K, M>(x);
    if (with_edges) r.edge = edges(at, face, {});
    return r;
  }
  const Frame frame = frame_of(c_.face_records[face]);
  const auto f = surface_.template implicit<3 + K>(at.x, frame);
  if (!is_defined(f)) return std::nullopt;  // (A)
  if (!is_positive(gradient(f)[2])) return std::nullopt;
  r.forms = graph_forms<K, 3 + K>(graph_of<M>(implicit_function<M, 3 + K>(f, 2), 1));
  if (with_edges) r.edge = edges(at, face, gradient(f));
  return r;
}

}  // namespace crest::certify::smooth
