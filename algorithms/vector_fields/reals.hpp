// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The precisions corridors climb: doubles, pairs of doubles, then MPFR of 133, 332 and 1000 bits.
#include <boost/multiprecision/mpfr.hpp>

#include "algorithms/vector_fields/double_double.hpp"

namespace crest::vector_fields {

template <unsigned digits>
using MpfrReal = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
using Real133 = MpfrReal<40>;
using Real332 = MpfrReal<100>;
using Real1000 = MpfrReal<301>;

}  // namespace crest::vector_fields
