// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 9, skeleton: the topological skeleton of a planar piecewise linear vector field (SPEC.md).
#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/skeleton/decode.hpp"
#include "certify/skeleton/proof.hpp"
#include "certify/surface/input_tie.hpp"

namespace crest::certify {
namespace {

void verify_skeleton(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                     const VerifyOptions& options, Verdict& verdict) {
  const SkeletonCertificate c = decode_skeleton(data, claims);
  SignLadder sign(options.arithmetic);
  skeleton::Proof proof(c);
  prove_surface(proof, sign, verdict);
  if (options.input) {
    std::vector<std::array<double, 3>> flat;
    for (const auto& [x, y] : c.positions) flat.push_back({x, y, 0});
    const std::string oriented = check_input(*options.input, flat, c.triangles);
    prove(verdict,
          "input: {} holds the same positions and faces, {}; nothing ties the vectors to it",
          options.input->name, oriented);
  }
  prove_skeleton(proof, sign, options.arithmetic, verdict);
}

}  // namespace

extern const ClaimChecker skeleton_claim;
const ClaimChecker skeleton_claim = {kSkeleton, kSkeletonVersion, "skeleton", verify_skeleton};

}  // namespace crest::certify
