// SPDX-License-Identifier: GPL-3.0-or-later
// MPFR computes on integers. What crosses to and from doubles here has at most 53 bits, so
// mpfr_set_d and mpfr_get_d are exact (or overflow by the direction they are given) and the
// processor's rounding mode is of no account.
#include "kernel/arithmetic/interval.hpp"

#include "kernel/arithmetic/mp_interval.hpp"

namespace crest::kernel {
namespace {

MpInterval wide(const Interval& x) {
  return MpInterval::between(x.inf(), x.sup(), 53);
}
Interval narrow(const MpInterval& x) {
  return {x.lower(), x.upper()};
}

}  // namespace

Interval sqrt(const Interval& x) {
  return x.inf() >= 0 && is_defined(x) ? Interval(CGAL::sqrt(x.x_)) : Interval::undefined();
}
Interval exp(const Interval& x) {
  return narrow(exp(wide(x)));
}
Interval log(const Interval& x) {
  return narrow(log(wide(x)));
}
Interval sin(const Interval& x) {
  return narrow(sin(wide(x)));
}
Interval cos(const Interval& x) {
  return narrow(cos(wide(x)));
}

}  // namespace crest::kernel
