// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes_curves/free.hpp"

#include <algorithm>

#include "certify/exact/sturm.hpp"

namespace crest::certify::curves {
namespace {

using modes::ExactTensors;
using modes::Field;
using modes::Integer;
using modes::u32;

/// A multiple of 54 det^2 - |D|^6.
template <class Number, std::size_t n>
modes::Form<Number, n, 6> mode_form(const modes::Products<Number, n>& products) {
  const auto norm = norm_form(products);
  const auto cube = cube_form(products);
  return scaled(Number(3), cube * cube) - scaled(Number(2), norm * norm * norm);
}

template <std::size_t n>
bool is_free_simplex(const Field& field, const std::array<u32, n>& corners) {
  return hull(mode_form(modes::approximate_products<n>(field, corners))) == modes::Hull::negative;
}

bool is_free_in_parts(Field& field, const std::array<u32, 3>& corners, unsigned depth,
                      unsigned& budget) {
  if (is_free(field, corners)) return true;
  if (depth == modes::kMostGenerations || budget == 0) return false;
  --budget;
  // All edges in turn: between the first corners, the others move up.
  const u32 middle = field.split(corners[0], corners[1], 32);
  for (unsigned k = 0; k < 2; ++k) {
    auto part = corners;
    part[k] = middle;
    std::ranges::rotate(part, part.begin() + 1);
    if (!is_free_in_parts(field, part, depth + 1, budget)) return false;
  }
  return true;
}

}  // namespace

bool is_free(const Field& field, const std::array<u32, 3>& corners) {
  return is_free_simplex(field, corners);
}
bool is_free(const Field& field, const std::array<u32, 4>& corners) {
  return is_free_simplex(field, corners);
}

bool is_free_in_parts(const std::array<std::array<double, 6>, 3>& tensors) {
  Field field(tensors);
  unsigned budget = 4096;
  return is_free_in_parts(field, {0, 1, 2}, 0, budget);
}

bool is_free(ExactTensors& exact, const std::array<u32, 2>& corners) {
  const auto f = mode_form(modes::exact_products<2>(exact, corners));
  if (f.c.front() == 0 || f.c.back() == 0) return false;
  const modes::Sturm sturm({f.c.begin(), f.c.end()});
  return sturm.distinct(modes::place(0), modes::place(1)) == 0;
}

bool is_degenerate(ExactTensors& exact, const std::array<u32, 2>& corners) {
  const auto products = modes::exact_products<2>(exact, corners);
  const auto f = mode_form(products);
  if (std::ranges::any_of(f.c, [](const Integer& x) { return x != 0; })) return false;
  // |D|^2 = a, b, c: zero inside only for opposite multiples.
  const auto [a, b, c] = norm_form(products).c;
  return a > 0 && c > 0 && (b >= 0 || b * b < 4 * a * c);
}

}  // namespace crest::certify::curves
