// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The forms of eight simplices, lane by lane, and what their signs say.
#include <cstring>

#include "algorithms/modes/cell_test.hpp"
#include "algorithms/modes/forms.hpp"

namespace crest::modes {

using kernel::Lanes;
using RealLanes = kernel::Bounded<Lanes>;

/// f and the forms of the witness by mu, degree 6, and by mu = 0, degree 3.
struct General {
  static constexpr int degree = 6;
  template <class N, int D>
  static auto f(const TensorForms<N, D>& forms, const Level& level) {
    return level_form(forms, level);
  }
  template <class N, int D>
  static auto growth(const TensorForms<N, D>& forms, const Level& level, std::size_t k) {
    return growth_form(forms, level, k);
  }
};
struct Neutral {
  static constexpr int degree = 3;
  template <class N, int D>
  static auto f(const TensorForms<N, D>& forms, const Level&) {
    return forms.c;
  }
  template <class N, int D>
  static auto growth(const TensorForms<N, D>& forms, const Level&, std::size_t k) {
    return neutral_growth_form(forms, k);
  }
};

/// Lanes as the compiler's own vectors, for what it does not turn into vector instructions: choices
/// and divisions. By reference: without AVX-512 such vectors are not passed by value.
using Wide = double __attribute__((vector_size(8 * Lanes::count)));
inline void load(const Lanes& from, Wide& to) {
  std::memcpy(&to, from.x.data(), sizeof(to));
}
inline void store(const Wide& from, Lanes& to) {
  std::memcpy(to.x.data(), &from, sizeof(from));
}

template <int D>
struct EightTensors {
  std::array<Entries<Lanes>, D + 1> t;
  Lanes largest, error;  ///< as bounded_forms takes them

  /// Lanes that are left over repeat the last simplex.
  explicit EightTensors(std::span<const Corners<D>> cells) {
    largest = error = 0;
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      const auto& cell = cells[std::min(lane, cells.size() - 1)];
      double m = 0, e = 0;
      for (std::size_t i = 0; i <= D; ++i) {
        for (std::size_t k = 0; k < 6; ++k) {
          t[i][k].x[lane] = cell[i]->t[k];
          m = std::max(m, std::fabs(cell[i]->t[k]));
        }
        e = std::max(e, cell[i]->error);
      }
      largest.x[lane] = m + e;
      error.x[lane] = e;
    }
  }
};

/// Bit i: what is certain of lane i's coefficients.
struct HullMasks {
  unsigned positive = 0, negative = 0;            ///< of all
  unsigned some_positive = 0, some_negative = 0;  ///< of some

  /// As kernel::certain_hull.
  template <class B>
  explicit HullMasks(const kernel::Form<RealLanes, B>& f) {
    Wide error, s;
    load(f.error, error);
    Wide low = error * 0 + HUGE_VAL, least = low, most = -low, high = -low;
    for (std::size_t i = 0; i < B::count; ++i) {
      // Where a difference is not zero its sign is right.
      load(f.s[i], s);
      const Wide e = B::weights[i] * error, down = s - e, up = s + e;
      low = down < low ? down : low;
      most = down > most ? down : most;
      least = up < least ? up : least;
      high = up > high ? up : high;
    }
    for (std::size_t i = 0; i < Lanes::count; ++i) {
      const unsigned bit = 1U << i;
      positive |= low[i] > 0 ? bit : 0;
      some_positive |= most[i] > 0 ? bit : 0;
      some_negative |= least[i] < 0 ? bit : 0;
      negative |= high[i] < 0 ? bit : 0;
    }
  }
  HullMasks() = default;
  std::optional<Finding> finding(std::size_t lane) const {
    if (positive >> lane & 1U) return Finding::positive;
    if (negative >> lane & 1U) return Finding::negative;
    if (some_positive & some_negative & 1U << lane) return Finding::none;
    return std::nullopt;
  }
};

/// H4: the form is positive on the closed simplex because no coefficient is negative and every
/// face of it carries a positive one.
template <class B>
bool strictly_positive(const kernel::Form<Integer, B>& f) {
  std::array<bool, 1U << B::corners> carries{};
  for (std::size_t i = 0; i < B::count; ++i) {
    if (f.s[i] < 0) return false;
    if (f.s[i].is_zero()) continue;
    unsigned mask = 0;
    for (std::size_t k = 0; k < B::corners; ++k) mask |= (B::indices[i][k] > 0 ? 1U : 0U) << k;
    carries[mask] = true;
  }
  for (unsigned face = 1; face < carries.size(); ++face) {
    bool found = false;
    for (unsigned part = face; part != 0 && !found; part = (part - 1) & face) found = carries[part];
    if (!found) return false;
  }
  return true;
}

/// The sign of f by its integer coefficients.
template <class B>
Finding exact_finding(kernel::Form<Integer, B> f) {
  bool negative = false, positive = false;
  for (const Integer& x : f.s) {
    negative = negative || x < 0;
    positive = positive || x > 0;
  }
  if (negative && positive) return Finding::none;
  if (!negative) return positive ? Finding::positive : Finding::uniform;
  for (Integer& x : f.s) x = -x;
  return strictly_positive(f) ? Finding::negative : Finding::none;
}

}  // namespace crest::modes
