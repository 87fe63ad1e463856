// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Named families of numbers and vectors on which predicates go wrong. Every predicate runs over
// all.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

using kernel::Vec3;

/// Number families.
enum class Family {
  generic,          // uniform in [-1, 1)
  small_integers,   // -2..2: exact zeros and ties everywhere
  equal_mantissas,  // +-1.5 times powers of two
  tiny,             // generic times 1e-50
  huge,             // generic times 1e50
  mixed_scales,     // generic times 10^(-50..0)
  nearly_equal,     // 1 plus a few ulps: cancellation to the last bit
  subnormal,        // products underflow
};
inline constexpr std::array kFamilies = {
    Family::generic, Family::small_integers, Family::equal_mantissas, Family::tiny,
    Family::huge,    Family::mixed_scales,   Family::nearly_equal,    Family::subnormal};

inline const char* name_of(Family family) {
  constexpr const char* kNames[] = {"generic", "small_integers", "equal_mantissas", "tiny",
                                    "huge",    "mixed_scales",   "nearly_equal",    "subnormal"};
  return kNames[static_cast<std::size_t>(family)];
}

/// A generator of its own for every salt.
class Draw {
 public:
  explicit Draw(std::uint64_t salt) : Draw(salt, "") {}
  /// Another for each family.
  Draw(std::uint64_t salt, Family family)
      : Draw(salt + static_cast<std::uint64_t>(family), name_of(family)) {}
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1; }  // [-1, 1)
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool coin() { return engine_() & 1; }

 private:
  Draw(std::uint64_t salt, const std::string& family) : engine_(kSeed * 1000003 + salt) {
    const std::string of = family.empty() ? "" : ", family " + family;
    latest_generator = "Draw(" + std::to_string(salt) + ")" + of;
  }
  Random engine_;
};

inline double draw(Draw& d, Family family) {
  switch (family) {
    case Family::generic:
      return d.uniform();
    case Family::small_integers:
      return d.integer(-2, 2);
    case Family::equal_mantissas:
      return std::ldexp(d.coin() ? 1.5 : -1.5, d.integer(-8, 8));
    case Family::tiny:
      return d.uniform() * 1e-50;
    case Family::huge:
      return d.uniform() * 1e50;
    case Family::mixed_scales:
      return d.uniform() * std::pow(10, -d.integer(0, 50));
    case Family::nearly_equal:
      return (d.coin() ? 1 : -1) * (1 + d.integer(-3, 3) * 0x1p-52);
    case Family::subnormal:
      return d.uniform() * 1e-160;
  }
  return 0;
}

inline Vec3 draw_vector(Draw& d, Family family) {
  Vec3 v;
  do
    for (double& x : v) x = draw(d, family);
  while (v == Vec3{});
  return v;
}

}  // namespace crest::tests
