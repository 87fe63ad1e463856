// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All C1 conditions of a box of cubes, word by word (section 7.3.2).
#include <array>
#include <vector>

#include "algorithms/splines/partition.hpp"

namespace crest::splines {

/// The sum of factor times coefficient is 0. Coefficients are named by the sums of their letters'
/// lattice points.
struct Condition {
  struct Term {
    Lattice at;
    int factor;
  };
  Junction junction;
  std::array<int, 3> cube;     ///< the lower one of two
  std::array<int, 4> letters;  ///< of the word: how often C, A, B, D
  Lattice word;                ///< their sum
  std::vector<Term> terms;     ///< first a(wu), a(wv)
};

inline Lattice times(int k, const Lattice& a) {
  return {k * a[0], k * a[1], k * a[2]};
}

/// Calls visit for the conditions of degree q across one triangle.
template <class Visit>
void visit_words(const Crossing& crossing, const Lattice& centre, const std::array<int, 3>& cube,
                 int q, const Visit& visit) {
  std::array<Lattice, 3> corner;
  for (std::size_t i = 0; i < 3; ++i) corner[i] = centre + crossing.triangle[i];
  for (int i = 0; i < q; ++i)
    for (int j = 0; i + j < q; ++j) {
      const int k = q - 1 - i - j;
      Condition c{crossing.junction, cube, {}, {}, {}};
      c.word = times(i, corner[0]) + times(j, corner[1]) + times(k, corner[2]);
      const std::array<int, 3> count{i, j, k};
      for (std::size_t l = 0; l < 3; ++l) c.letters[crossing.letters[l]] = count[l];
      const bool five = crossing.junction == Junction::inter_pyramid;
      for (const Lattice& opposite : crossing.opposite)
        c.terms.push_back({c.word + centre + opposite, five ? 2 : 1});
      for (std::size_t l = 0; l < 3; ++l) {
        const std::size_t letter = crossing.letters[l];
        const int factor = five ? (letter == kC ? -2 : -1) : (letter == kD ? -2 : 0);
        if (factor != 0) c.terms.push_back({c.word + corner[l], factor});
      }
      visit(c);
    }
}

template <class Visit>
void for_each_condition(const std::array<int, 3>& n, int q, const Visit& visit) {
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        const std::array<int, 3> cube{i, j, k};
        const Lattice centre{2 * i + 1, 2 * j + 1, 2 * k + 1};
        for (const Crossing& crossing : kCrossing) {
          if (crossing.junction == Junction::inter_cube) {
            const Lattice next = centre + crossing.opposite[1];
            bool inside = true;
            for (std::size_t d = 0; d < 3; ++d) inside = inside && next[d] < 2 * n[d];
            if (!inside) continue;
          }
          visit_words(crossing, centre, cube, q, visit);
        }
      }
}

}  // namespace crest::splines
