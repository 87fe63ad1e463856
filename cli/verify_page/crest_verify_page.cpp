// SPDX-License-Identifier: GPL-3.0-or-later
// crest-verify without a system around it, as crest-verify.js calls it: a certificate's bytes in,
// the verdict and the claims' words out. One call an instance.
#include <cstdlib>
#include <new>

#include "certify/container/sha256.hpp"
#include "certify/verify.hpp"
#include "cli/verify_page/sha256.hpp"
#include "kernel/arithmetic/self_test.hpp"

namespace {

using namespace crest::certify;

/// With size_t of 32 bits, no small multiple of what a certificate lists may wrap round.
constexpr std::size_t kMost = std::size_t{1} << 27;

std::span<std::uint8_t> certificate;
std::string reason, digest;

/// Given by the page: a line that has been proved.
extern "C" void crest_proved(const char* line) __attribute__((import_name("crest_proved")));

/// As crest-verify decides; whatever cannot be computed here is no verdict.
int decide() {
  try {
    crest::kernel::require_sound_floating_point();
    VerifyOptions options;
    options.progress = [](const std::string& line) { crest_proved(line.c_str()); };
    const Verdict verdict = verify(certificate, options);
    reason = verdict.reason;
    if (verdict.data) digest = hex(*verdict.data);
    return verdict.accepted ? 1 : verdict.undecided ? 2 : 0;
  } catch (const std::bad_alloc&) {
    reason = "the page's memory does not suffice";
  } catch (const std::exception& problem) {
    reason = problem.what();
  }
  return 2;
}

}  // namespace

namespace crest::certify {

Digest sha256(std::initializer_list<std::span<const std::uint8_t>> pieces) {
  page::Sha256 hash;
  for (const auto& piece : pieces) hash.add(piece);
  return hash.digest();
}

}  // namespace crest::certify

extern "C" {

/// For large arrays; nobody takes it here.
int madvise(void* /*memory*/, std::size_t /*size*/, int /*advice*/) {
  return 0;
}
/// GMP says so where a number outgrows it.
int raise(int /*signal*/) {
  __builtin_trap();
}

/// Where a certificate of this size is to be written; null if it is too large.
__attribute__((export_name("crest_room"))) std::uint8_t* crest_room(std::size_t size) {
  if (size > kMost) return nullptr;
  auto* const bytes = static_cast<std::uint8_t*>(std::malloc(size + 1));
  if (bytes != nullptr) certificate = {bytes, size};
  return bytes;
}

/// 1 accepted, 0 refuted, 2 neither.
__attribute__((export_name("crest_check"))) int crest_check() {
  return decide();
}
__attribute__((export_name("crest_reason"))) const char* crest_reason() {
  return reason.c_str();
}
__attribute__((export_name("crest_digest"))) const char* crest_digest() {
  return digest.c_str();
}
}
