// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/certificate.hpp"

namespace crest::modes {

certify::ModesCertificate make_certificate(const Input& input, const Census& census) {
  certify::ModesCertificate c;
  c.points = input.points;
  c.cells = input.cells;
  c.distinct = census.distinct;
  c.used = census.used;
  return c;
}

}  // namespace crest::modes
