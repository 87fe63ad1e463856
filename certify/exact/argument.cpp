// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/exact/argument.hpp"

#include <mpfr.h>

namespace crest::certify {

Argument::Argument() {
  mpfr_t value;
  mpfr_init2(value, 200);
  for (std::size_t j = 0; j < table_.size(); ++j) {
    mpfr_set_d(value, static_cast<double>(j) / 16, MPFR_RNDN);
    mpfr_atan(value, value, MPFR_RNDN);
    table_[j] = mpfr_get_d(value, MPFR_RNDN);
  }
  mpfr_clear(value);
}

}  // namespace crest::certify
