// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 11, spline-rays: where rays first meet a level set of a quadratic spline (SPEC.md).
#include <algorithm>
#include <bit>

#include "certify/container/checker.hpp"
#include "certify/container/parallel.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/spline_rays/decode.hpp"
#include "certify/spline_rays/walk.hpp"

namespace crest::certify {
namespace {

using namespace spline_rays;

void check_rays(const SplineRaysCertificate& c) {
  const Scene scene(c.volume);
  std::vector<std::size_t> place(c.rays.size());  // of a ray's hit
  for (std::size_t i = 1; i < place.size(); ++i) place[i] = place[i - 1] + c.meets[i - 1];
  parallel_for(
      c.rays.size(), [] { return 0; },
      [&](int, std::size_t i) {
        const SplineHit* const hit = c.meets[i] != 0 ? &c.hits[place[i]] : nullptr;
        const char* const problem = objection(scene, c.rays[i], hit);
        require(problem == nullptr, "ray {} {}", i, problem == nullptr ? "" : problem);
      });
}

/// Doubles from the first to the second. Requires: 0 <= low <= high.
std::uint64_t steps(double low, double high) {
  return std::bit_cast<std::uint64_t>(high) - std::bit_cast<std::uint64_t>(low);
}

/// Cost: linear; some 10 microseconds a ray.
void verify_spline_rays(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                        const VerifyOptions& options, Verdict& verdict) {
  const SplineRaysCertificate c = decode_spline_rays(data, claims);
  if (options.input)
    throw TieUnavailable(options.input->name +
                         ": --input cannot compare samples; compare the data digest with the one "
                         "in the output");
  orientation(c.volume);  // not singular
  const auto& n = c.volume.nodes;
  prove(verdict, "data: {} x {} x {} samples{}, level {}, {} rays; digests match", n[0], n[1], n[2],
        c.volume.extended ? " and an extended layer" : "", c.volume.level, c.rays.size());
  check_rays(c);
  prove(verdict, "{} rays meet the level set first where they are said to, {} nowhere",
        c.hits.size(), c.rays.size() - c.hits.size());
  const auto wide = std::ranges::count_if(
      c.hits, [](const SplineHit& hit) { return steps(hit.low, hit.high) > 4; });
  prove(verdict, "{} brackets are wider than 4 steps of doubles", wide);
}

}  // namespace

extern const ClaimChecker spline_rays_claim;
const ClaimChecker spline_rays_claim = {kSplineRays, kSplineRaysVersion, "spline-rays",
                                        verify_spline_rays};

}  // namespace crest::certify
