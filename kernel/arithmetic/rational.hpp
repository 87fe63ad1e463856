// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Exact rationals (GMP). Every finite double converts without error.
#include <boost/multiprecision/gmp.hpp>

namespace crest::kernel {

/// Expression templates are off so that templated formulas may use auto.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

}  // namespace crest::kernel
