// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/arithmetic/self_test.hpp"

#include <cfenv>
#include <limits>
#include <stdexcept>

#include "kernel/arithmetic/interval.hpp"

namespace crest::kernel {
namespace {

// volatile: the compiler must neither fold these nor move them across a change of mode.
bool subnormals_are_kept() {
  volatile double tiny = std::numeric_limits<double>::min();
  volatile double half = tiny / 2;
  return half > 0 && half + half == tiny;
}

bool products_are_rounded() {
  // (1 + 2^-30)^2 = 1 + 2^-29 + 2^-60: the last term survives only in a fused operation.
  volatile double a = 1 + 0x1p-30, b = 1 + 0x1p-29;
  return a * a - b == 0;
}

bool directed_rounding_works() {
  volatile double one = 1, three = 3;
  const Interval third = [&] {
    RoundUpward guard;
    return Interval(one) / Interval(three);
  }();
  return third.inf() < third.sup();
}

}  // namespace

void require_sound_floating_point() {
  if (std::fegetround() != FE_TONEAREST)
    throw std::runtime_error("floating point is not in round-to-nearest mode; cannot certify");
  if (!subnormals_are_kept())
    throw std::runtime_error(
        "subnormal numbers are flushed to zero (a library linked with -ffast-math?); cannot "
        "certify");
  if (!products_are_rounded())
    throw std::runtime_error("products are fused (build with -ffp-contract=off); cannot certify");
  if (!directed_rounding_works())
    throw std::runtime_error("directed rounding has no effect in this build; cannot certify");
}

}  // namespace crest::kernel
