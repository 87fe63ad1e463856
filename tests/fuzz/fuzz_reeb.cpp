// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target of claim 3: any bytes give a verdict, the same under both arithmetics, and what
// is accepted is true. Most inputs are edits of small true certificates.
#include <cstdlib>
#include <map>

#include "certify/reeb/decode.hpp"
#include "certify/verify.hpp"
#include "kernel/arithmetic/self_test.hpp"
#include "tests/certify/reeb_samples.hpp"
#include "tests/certify/reference_reeb.hpp"
#include "tests/fuzz/edits.hpp"

namespace {

using namespace crest::certify;
using namespace crest::tests;

/// One of 256, made on first use.
const Bytes& true_certificate(std::uint8_t number) {
  static std::map<std::uint8_t, Bytes> made;
  Bytes& bytes = made[number];
  if (bytes.empty()) {
    Random random(number);
    const auto surfaces = reeb_surfaces(random);
    const auto kind = static_cast<Values>(number / 2 % 5);
    const auto data = reeb_data(surfaces[number % surfaces.size()], 1 + number % 2, kind, random);
    bytes = encode(ReferenceReeb(data).certificate(random, number % 3 == 0 ? 0.3 : 0));
    if (!verify(bytes).accepted) std::abort();
  }
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool sound = (crest::kernel::require_sound_floating_point(), true);
  if (!sound || size < 2) return 0;
  const std::span<const std::uint8_t> input(data + 2, size - 2);
  Bytes bytes;
  if (data[0] % 8 == 0)
    bytes.assign(input.begin(), input.end());
  else
    edit(bytes = true_certificate(data[1]), input);
  crest::tests::bind(bytes);
  VerifyOptions mpfr;
  mpfr.arithmetic = Arithmetic::mpfr;
  const Verdict verdict = verify(bytes);
  if (data[0] % 8 == 1 && verify(bytes, mpfr).reason != verdict.reason) std::abort();
  if (!verdict.accepted) return 0;
  const Container container = open_container(bytes);
  if (container.claim == kReeb &&
      !ReferenceReeb::is_true(decode_reeb(container.data, container.claims)))
    std::abort();
  return 0;
}
