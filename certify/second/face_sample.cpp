// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/face_sample.hpp"

namespace crest::recheck {
namespace {

/// Newton steps at a point, where the fibre's zero is wanted to the last bit.
constexpr int kSharp = 6;

}  // namespace

Sample Sampler::foot(const Piece& piece, int c) const {
  Sample s;
  if (!problem_.surface.implicit()) return s;
  s.fibre = problem_.fibre(face_, piece, c);
  s.foot = problem_.surface.foot(s.fibre, piece.is_point() ? kSharp : 0);
  return s;
}

Sample Sampler::forms(const Piece& piece, int c, int jet_order, unsigned wanted) const {
  Sample s = foot(piece, c);
  const Scope scope(jet_order);
  if (problem_.surface.implicit()) {
    const Jet3 f = problem_.surface.expand(s.foot.x, frame_of(record_.frame), jet_degree());
    s.gradient = {f[1], f[2], f[3]};
    s.forms = problem_.surface.forms(f, 1);
  } else {
    const auto uv = problem_.unit(face_, piece);
    s.forms = problem_.surface.forms(uv[0], uv[1]);
  }
  s.a = operator_of(s.forms);
  const auto w = direction(record_.w);
  require(definite(s.forms, s.a, w).sign() > 0, "(R): S(w) > 0");
  if (wanted == 0) return s;
  const auto v = directions(s.forms.i, s.a, w);
  for (std::size_t j = 0; j < 2; ++j) {
    if ((wanted >> j & 1) == 0) continue;
    Jet2& e = s.e[j];
    e = extremality(s.forms, v[j]);
    s.growth[j] = v[j][0][0] * e[1] + v[j][1][0] * e[2];
    if (jet_order < 2) continue;
    const Scope first(1);
    const Jet2 g = v[j][0].cut() * e.derivative(0) + v[j][1].cut() * e.derivative(1);
    s.turn[j] = e[1] * g[2] - e[2] * g[1];
  }
  return s;
}

void Sampler::require_orientation(const Sample& s) const {
  const Vector first = problem_.chord(face_, 0, 1, s.foot.s),
               second = problem_.chord(face_, 0, 2, s.foot.s);
  require(determinant(first, second, s.fibre.along).sign() > 0, "(J)");
}

int Sampler::sign_at(const Barycentric& l, int c, std::size_t j) const {
  const Scope scope;
  for (const slong precision : {128, 256}) {
    context.precision = precision;
    const int sign = forms(Piece::point(l), c, 0, 1U << j).e[j][0].sign();
    if (sign != 0) return sign;
  }
  throw Open{"E_j has a certain sign at a point"};
}

std::array<Model, 2> Sampler::along(const Sample& s, Index k) const {
  std::array<Model, 2> d;
  if (!problem_.surface.implicit()) {
    for (std::size_t i = 0; i < 2; ++i)
      d[i] =
          Model(Ball(problem_.lifted(face_, (k + 1) % 3, i)) - Ball(problem_.lifted(face_, k, i)));
    return d;
  }
  const Frame frame = frame_of(record_.frame);
  const Vector chord = in_frame(frame, problem_.chord(face_, k, (k + 1) % 3, s.foot.s)),
               fibre = in_frame(frame, s.fibre.along);
  const Model b = -(dot(s.gradient, chord) * inverse(dot(s.gradient, fibre)));
  return {chord[0] + b * fibre[0], chord[1] + b * fibre[1]};
}

Model extremality_without_root(const Sample& s, std::size_t j, bool steep) {
  const Scope scope(0);
  const Jet2 a11 = s.a.a11.cut(), a12 = s.a.a12.cut(), a21 = s.a.a21.cut(), one(1.0);
  const Jet2 sigma = root({a11, a12, a21});
  const Jet2 q = inverse(steep ? sigma - a11 : sigma + a11);
  const Direction v = j == 0 ? (steep ? Direction{a12 * q, one} : Direction{one, a21 * q})
                             : (steep ? Direction{one, -(a21 * q)} : Direction{-(a12 * q), one});
  return extremality(s.forms, v)[0];
}

}  // namespace crest::recheck
