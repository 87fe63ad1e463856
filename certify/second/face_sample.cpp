// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/face_sample.hpp"

namespace crest::recheck {
namespace {

/// Newton steps at a point, where the fibre's zero is wanted to the last bit.
constexpr int kSharp = 6;

}  // namespace

template <class T>
Sample<T> Sampler::foot(const Piece& piece, int c) const {
  Sample<T> s;
  if (!problem_.surface.implicit()) return s;
  s.fibre = problem_.fibre<T>(face_, piece, c);
  s.foot = problem_.surface.foot(s.fibre, piece.is_point() ? kSharp : 0);
  return s;
}
template Sample<Model> Sampler::foot(const Piece&, int) const;

template <class T>
Sample<T> Sampler::forms(const Piece& piece, int c, int jet_order, unsigned wanted) const {
  Sample<T> s = foot<T>(piece, c);
  const Scope scope(jet_order);
  if (problem_.surface.implicit()) {
    const Jet3<T> f = problem_.surface.expand(s.foot.x, frame_of(record_.frame), jet_degree());
    s.gradient = {f[1], f[2], f[3]};
    s.forms = problem_.surface.forms(f, 1);
  } else {
    const auto uv = problem_.unit<T>(face_, piece);
    s.forms = problem_.surface.forms(uv[0], uv[1]);
  }
  s.a = operator_of(s.forms);
  const auto w = direction(record_.w);
  require(definite(s.forms.i, s.a, w).sign() > 0, "(R): S(w) > 0");
  if (wanted == 0) return s;
  const auto v = directions(s.forms.i, s.a, w);
  for (std::size_t j = 0; j < 2; ++j) {
    if ((wanted >> j & 1) == 0) continue;
    Jet2<T>& e = s.e[j];
    e = extremality(s.forms, v[j]);
    s.growth[j] = v[j][0][0] * e[1] + v[j][1][0] * e[2];
    if (jet_order < 2) continue;
    const Scope first(1);
    const Jet2<T> g = v[j][0].cut() * e.derivative(0) + v[j][1].cut() * e.derivative(1);
    s.turn[j] = e[1] * g[2] - e[2] * g[1];
  }
  return s;
}
template Sample<Model> Sampler::forms(const Piece&, int, int, unsigned) const;

void Sampler::require_orientation(const Sample<>& s) const {
  const Vector<Model> first = problem_.chord(face_, 0, 1, s.foot.s),
                      second = problem_.chord(face_, 0, 2, s.foot.s);
  require(determinant(first, second, s.fibre.along).sign() > 0, "(J)");
}

std::array<int, 2> Sampler::signs_at(const Barycentric& l, int c, unsigned wanted) const {
  const Scope scope;
  for (const slong precision : {128, 256}) {
    context.precision = precision;
    const auto e = forms<Ball>(Piece::point(l), c, 0, wanted).e;
    const std::array<int, 2> sign = {e[0][0].sign(), e[1][0].sign()};
    if ((sign[0] != 0 || (wanted & 1) == 0) && (sign[1] != 0 || (wanted & 2) == 0)) return sign;
  }
  throw Open{"E_j has a certain sign at a point"};
}

std::array<Model, 2> Sampler::along(const Sample<>& s, Index k) const {
  std::array<Model, 2> d;
  if (!problem_.surface.implicit()) {
    for (std::size_t i = 0; i < 2; ++i)
      d[i] = Model(problem_.lifted(face_, (k + 1) % 3, i) - problem_.lifted(face_, k, i));
    return d;
  }
  const Frame frame = frame_of(record_.frame);
  const Vector<Model> chord = in_frame(frame, problem_.chord(face_, k, (k + 1) % 3, s.foot.s)),
                      fibre = in_frame(frame, s.fibre.along);
  const Model b = -(dot(s.gradient, chord) * inverse(dot(s.gradient, fibre)));
  return {chord[0] + b * fibre[0], chord[1] + b * fibre[1]};
}

std::array<Direction<Model>, 2> rootless_directions(const Operator<Model>& a, bool steep) {
  const Scope scope(0);
  using Jet = Jet2<Model>;
  const Jet a11 = a.a11.cut(), a12 = a.a12.cut(), a21 = a.a21.cut(), one(1.0);
  const Jet sigma = root(Operator<Model>{a11, a12, a21});
  const Jet q = inverse(steep ? sigma - a11 : sigma + a11);
  if (steep) return {Direction<Model>{a12 * q, one}, {one, -(a21 * q)}};
  return {Direction<Model>{one, a21 * q}, {-(a12 * q), one}};
}

}  // namespace crest::recheck
