// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/container/checker.hpp"

#include "certify/container/container.hpp"
#include "certify/container/reject.hpp"

namespace crest::certify {
namespace {

void check_all(std::span<const ClaimChecker* const> known,
               std::span<const std::uint8_t> certificate, const VerifyOptions& options,
               Verdict& verdict) {
  const Container container = open_container(certificate);
  verdict.data = container.data_digest();
  require(*verdict.data == container.stated_data_digest,
          "the data are not those the certificate was made for (data digest)");
  require(container.seal() == container.stated_seal, "the file is damaged (seal)");
  std::string names;
  for (const ClaimChecker* checker : known) {
    if (checker->number == container.claim) {
      require(container.version == checker->version,
              "version {} of {} is not known here (known: {})", container.version, checker->name,
              checker->version);
      return checker->check(container.data, container.claims, options, verdict);
    }
    names += fmt::format("{}{} {}", names.empty() ? "" : ", ", checker->number, checker->name);
  }
  throw Reject(fmt::format("claim {} is not known here (known: {})", container.claim, names));
}

}  // namespace

Verdict verify_among(std::span<const ClaimChecker* const> known,
                     std::span<const std::uint8_t> certificate, const VerifyOptions& options) {
  Verdict verdict;
  verdict.progress = options.progress;
  try {
    check_all(known, certificate, options, verdict);
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
