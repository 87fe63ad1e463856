// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 12, spline-cubic: a cubic spline on type-6 tetrahedra, how smooth and how near (SPEC.md).
#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/spline_cubic/decode.hpp"
#include "certify/spline_cubic/errors.hpp"
#include "certify/spline_cubic/smoothness.hpp"

namespace crest::certify {
namespace {

using namespace spline_cubic;

/// Cost: linear; a microsecond a cube and two a sample.
void verify_spline_cubic(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                         const VerifyOptions& options, Verdict& verdict) {
  const SplineCubicCertificate c = decode_spline_cubic(data, claims);
  if (options.input)
    throw TieUnavailable(options.input->name +
                         ": --input cannot compare samples; compare the data digest with the one "
                         "in the output");
  const Domain domain(c.data);
  const auto& n = c.data.cubes;
  prove(verdict, "data: {} of {} x {} x {} cubes, {} samples ({} elsewhere); digests match",
        domain.size(), n[0], n[1], n[2], c.data.samples.size(), c.data.outside);
  check_smoothness(c, domain);
  if (c.jump == 0)
    prove(verdict, "the spline is C1 on the whole domain: 8 residuals a cube are exactly 0");
  else
    prove(verdict,
          "the spline is continuous; its gradient jumps by at most {} across triangles with a "
          "cube's centre and edge, and across no others",
          c.jump);
  check_errors(c, domain);
  prove(verdict, "it differs by at most {} from every sample", c.error);
}

}  // namespace

extern const ClaimChecker spline_cubic_claim;
const ClaimChecker spline_cubic_claim = {kSplineCubic, kSplineCubicVersion, "spline-cubic",
                                         verify_spline_cubic};

}  // namespace crest::certify
