// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target of claim 1: any bytes give a verdict, accepted under one arithmetic is not false
// under the other, and what is accepted is true. Most inputs are edits of small true certificates.
#include <cstdlib>
#include <map>

#include "certify/ridges_mesh/decode.hpp"
#include "certify/verify.hpp"
#include "kernel/arithmetic/self_test.hpp"
#include "tests/certify/reference_ridges.hpp"
#include "tests/certify/sample_meshes.hpp"
#include "tests/fuzz/edits.hpp"

namespace {

using namespace crest::certify;
using namespace crest::tests;

/// One of 256, made on first use.
const Bytes& true_certificate(std::uint8_t number) {
  static const auto samples = all_samples();
  static std::map<std::uint8_t, Bytes> made;
  Bytes& bytes = made[number];
  if (bytes.empty()) {
    Random random(number);
    MeshData data = samples[number % samples.size()].data;
    if (data.faces.size() > 100) data = icosphere(0);
    if (number >= 128) randomize_monge(data, random);
    const ReferenceRidges ridges(data);
    bytes =
        encode(*ridges.certificate(number % 2 ? ridges.grown(6, random) : ridges.single_faces()));
    if (!verify(bytes).accepted) std::abort();
  }
  return bytes;
}

bool is_true(const Bytes& bytes) {
  const Container container = open_container(bytes);
  RidgesMeshCertificate c;
  c.data = decode_data(container.data);
  decode_claims(container.claims, c);
  std::vector<PatchFaces> patches;
  for (const auto& patch : c.patches) patches.push_back({patch.centre, patch.faces});
  const ReferenceRidges ridges(c.data);
  if (!ridges.valid()) return false;
  const auto truth = ridges.certificate(patches);
  return truth && encode(*truth) == bytes;
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
  const Verdict verdict = verify(bytes);
  if (data[0] % 8 == 1) {
    const Verdict mpfr = verify(bytes, {Arithmetic::mpfr, {}});
    if (!verdict.undecided && !mpfr.undecided && mpfr.reason != verdict.reason) std::abort();
  }
  if (verdict.accepted && !is_true(bytes)) std::abort();
  return 0;
}
