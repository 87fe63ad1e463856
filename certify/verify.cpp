// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/verify.hpp"

#include <array>

#include "certify/container/container.hpp"
#include "certify/container/reject.hpp"
#include "certify/features_mesh/claim.hpp"
#include "certify/reeb/claim.hpp"
#include "certify/ridges_mesh/claim.hpp"
#include "certify/ridges_smooth/claim.hpp"

namespace crest::certify {
namespace {

/// A claim's number and its checker; another claim is another row.
struct ClaimChecker {
  std::uint32_t claim;
  void (*check)(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                const VerifyOptions& options, Verdict& verdict);
};
constexpr std::array kCheckers = {ClaimChecker{kRidgesMesh, verify_ridges_mesh},
                                  ClaimChecker{kFeaturesMesh, verify_features_mesh},
                                  ClaimChecker{kReeb, verify_reeb},
                                  ClaimChecker{kRidgesSmooth, verify_ridges_smooth}};

void check_all(std::span<const std::uint8_t> certificate, const VerifyOptions& options,
               Verdict& verdict) {
  const Container container = open_container(certificate);
  require(container.version == kVersion, "version {} is not known", container.version);
  verdict.data = container.data_digest();
  require(*verdict.data == container.stated_data_digest,
          "the data are not those the certificate was made for (data digest)");
  require(container.seal() == container.stated_seal, "the file is damaged (seal)");
  for (const auto& checker : kCheckers)
    if (checker.claim == container.claim)
      return checker.check(container.data, container.claims, options, verdict);
  throw Reject(fmt::format("claim {} is not known", container.claim));
}

}  // namespace

Verdict verify(std::span<const std::uint8_t> certificate, const VerifyOptions& options) {
  Verdict verdict;
  try {
    check_all(certificate, options, verdict);
    verdict.accepted = true;
  } catch (const Undecided& problem) {
    verdict.undecided = true;
    verdict.reason = fmt::format("undecided: {}", problem.what());
  } catch (const Reject& problem) {
    verdict.reason = problem.what();
  } catch (const Malformed& problem) {
    verdict.reason = fmt::format("malformed: {}", problem.what());
  }
  return verdict;
}

}  // namespace crest::certify
