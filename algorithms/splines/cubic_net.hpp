// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From the normal form to the coefficients of a tetrahedron, over any number type.
#include <array>
#include <cstddef>

#include "algorithms/splines/cubic_model.hpp"
#include "algorithms/splines/partition.hpp"
#include "kernel/polynomial/simplex_net.hpp"

namespace crest::splines {

template <class T>
using CubicNet = kernel::SimplexNet<T, 3, 3>;

constexpr auto make_words() {
  using Basis = kernel::SimplexBasis<3, 3>;
  std::array<std::array<std::array<std::size_t, 4>, 4>, 4> words{};
  for (std::size_t x = 0; x < 4; ++x)
    for (std::size_t y = 0; y < 4; ++y)
      for (std::size_t z = 0; z < 4; ++z) {
        Basis::Index index{};
        for (const std::size_t letter : {x, y, z}) ++index[letter];
        words[x][y][z] = Basis::position(index);
      }
  return words;
}
inline constexpr auto kWords = make_words();

/// The place among a tetrahedron's coefficients of the word of these letters.
constexpr std::size_t word(Letter x, Letter y, Letter z) {
  return kWords[x][y][z];
}

/// Of tetrahedron t. `vertex` and `slopes` give the numbers at a corner of the cube (offsets 0 or
/// 1): f and g; the six of the edges that start there.
template <class T, class VertexAt, class SlopesAt>
CubicNet<T> cubic_net(std::size_t t, const VertexAt& vertex, const SlopesAt& slopes,
                      const std::array<T, 4>& centre) {
  const Tetrahedron& s = kTetrahedron[t];
  const T half(0.5);
  const bool face_up = s.face_sign > 0, edge_up = s.edge_sign > 0;
  // The axes m and f span the face, n leaves it; corners by their places along m and f.
  const std::size_t m = s.edge_axis, f = s.free_axis, n = s.face_axis;
  const auto corner = [&](std::size_t at_m, std::size_t at_f) {
    std::array<std::size_t, 3> at;
    at[n] = face_up;
    at[m] = at_m;
    at[f] = at_f;
    return at;
  };
  const auto inward = [&](bool upper, const T& x) { return upper ? T(-half * x) : T(half * x); };
  struct Edge {
    T d, c;  ///< a(ABD), a(ABC)
  };
  // The edge along `axis` at the place `at` along `across`.
  const auto edge = [&](std::size_t axis, std::size_t across, std::size_t at) {
    const auto low_at = axis == f ? corner(at, 0) : corner(0, at);
    const auto high_at = axis == f ? corner(at, 1) : corner(1, at);
    const auto &low = vertex(low_at), &high = vertex(high_at);
    const auto& all = slopes(low_at);
    const auto slope = [&](std::size_t d) {
      return all[2 * axis + (kAcross[axis][0] == d ? 0 : 1)];
    };
    Edge r;
    r.d = half * (low[0] + high[0] + (low[axis + 1] - high[axis + 1])) +
          inward(at == 1, slope(across));
    r.c = r.d + inward(face_up, slope(n));
    return r;
  };
  const std::array<Edge, 2> along_f{edge(f, m, 0), edge(f, m, 1)};
  const std::array<Edge, 2> along_m{edge(m, f, 0), edge(m, f, 1)};

  CubicNet<T> net;
  auto& a = net.c;
  const std::size_t side = edge_up;
  const Edge& ab = along_f[side];
  a[word(kA, kB, kD)] = ab.d;
  a[word(kA, kB, kC)] = ab.c;
  for (const Letter letter : {kA, kB}) {
    const bool upper = letter == kB;
    const Letter other = upper ? kA : kB;
    const auto& v = vertex(corner(side, upper ? 1 : 0));
    const T to_d = inward(edge_up, v[m + 1]) + inward(upper, v[f + 1]);
    a[word(letter, letter, letter)] = v[0];
    a[word(letter, letter, other)] = upper ? v[0] - v[f + 1] : v[0] + v[f + 1];
    a[word(letter, letter, kD)] = v[0] + to_d;
    a[word(letter, letter, kC)] = v[0] + to_d + inward(face_up, v[n + 1]);
    const Edge& beside = along_m[upper ? 1 : 0];
    a[word(letter, kD, kD)] = half * (ab.d + beside.d);
    a[word(letter, kD, kC)] = half * (ab.c + beside.c);
    a[word(letter, kC, kC)] = centre[0] - inward(edge_up, centre[m + 1]) -
                              inward(upper, centre[f + 1]) - inward(face_up, centre[n + 1]);
  }
  a[word(kD, kD, kD)] = T(0.25) * ((along_f[0].d + along_f[1].d) + (along_m[0].d + along_m[1].d));
  a[word(kD, kD, kC)] = T(0.25) * ((along_f[0].c + along_f[1].c) + (along_m[0].c + along_m[1].c));
  a[word(kD, kC, kC)] = centre[0] - inward(face_up, centre[n + 1]);
  a[word(kC, kC, kC)] = centre[0];
  return net;
}

}  // namespace crest::splines
