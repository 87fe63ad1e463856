// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The polynomial of a tetrahedron (SPEC.md, "Normal form").
#include "certify/spline_cubic/cube_form.hpp"

namespace crest::certify::spline_cubic {

/// a(PQD) and a(PQC) of an edge of the face of D along `axis`, given by one of its corners.
template <class Number>
struct EdgeValues {
  Number d, c;
};
template <class Number>
EdgeValues<Number> edge_values(const CubeForm<Number>& form, const Tetrahedron& tet,
                               unsigned corner, std::size_t axis) {
  const auto& t = form.t[edge_at(corner, axis)];
  const std::size_t across = tet.a;  // D has no part along it
  const std::size_t first = kOtherAxes[axis][0] == across ? 1 : 0;
  const Number half = Number(0.5);
  const Number in_face = half * inwards(t[first], corner, kOtherAxes[axis][first]);
  const Number inner = half * inwards(t[1 - first], corner, across);
  const Number d = half * edge_sum(form, corner, axis) + in_face;
  return {d, d + inner};
}

/// s at a point with these barycentrics.
template <class Number>
Number value(const CubeForm<Number>& form, const Tetrahedron& tet, const std::array<Number, 4>& l) {
  const Number half = Number(0.5), three = Number(3), six = Number(6);
  const unsigned corner[2] = {tet.corner(0), tet.corner(1)};
  const auto ab = edge_values(form, tet, corner[0], tet.f);
  const auto opposite = edge_values(form, tet, corner[0] ^ 1U << tet.m, tet.f);
  const EdgeValues<Number> side[2] = {edge_values(form, tet, corner[0], tet.m),
                                      edge_values(form, tet, corner[1], tet.m)};
  const Number quarter = Number(0.25);
  const Number ddd = quarter * (ab.d + opposite.d + side[0].d + side[1].d);
  const Number ddc = quarter * (ab.c + opposite.c + side[0].c + side[1].c);
  Number sum = Number(0);
  for (unsigned end = 0; end < 2; ++end) {
    const unsigned at = corner[end];
    const Number &la = l[1 + end], &lb = l[2 - end];
    const Number aad = form.f[at] + half * (inwards(form.g[at][tet.m], at, tet.m) +
                                            inwards(form.g[at][tet.f], at, tet.f));
    const Number aac = aad + half * inwards(form.g[at][tet.a], at, tet.a);
    const Number aab = form.f[at] + inwards(form.g[at][tet.f], at, tet.f);
    sum = sum + la * la * (la * form.f[at] + three * (lb * aab + l[3] * aad + l[0] * aac)) +
          three * la * l[3] * (l[3] * half * (ab.d + side[end].d) + l[0] * (ab.c + side[end].c));
  }
  sum = sum + six * l[1] * l[2] * (l[3] * ab.d + l[0] * ab.c);
  sum = sum + l[3] * l[3] * (l[3] * ddd + three * l[0] * ddc);
  // a(CCX) = f + g (X - C); summed over X with weight 3 l_C^2 l_X, for X = C with l_C^3.
  const Number down = l[1] + l[2];  // the part of A and B
  const auto upwards = [&](const Number& x, unsigned up) { return up != 0 ? x : Number(-x); };
  const Number slope = half * (upwards(form.centre_g[tet.a], tet.upper) * (down + l[3]) +
                               upwards(form.centre_g[tet.m], tet.outer) * down +
                               form.centre_g[tet.f] * (l[2] - l[1]));
  return sum + l[0] * l[0] * (form.centre_f * (l[0] + three * (down + l[3])) + three * slope);
}

}  // namespace crest::certify::spline_cubic
