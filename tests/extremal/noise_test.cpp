// SPDX-License-Identifier: GPL-3.0-or-later
// Clipped noise: flat nodes, faces with edges that are not tested, several arcs between two cells,
// fans cut at the centre alone. What is counted is what the checker counts.
#include <catch2/catch.hpp>
#include <map>

#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "tests/extremal/reference_sheets.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;

namespace {

/// Means over 27 samples, stretched, clipped and rounded to so many steps.
extremal::Volume clipped_noise(std::uint64_t seed, double steps) {
  constexpr int kSize[3] = {22, 20, 18};
  Random random(seed);
  std::vector<double> raw(22 * 20 * 18);
  for (double& x : raw) x = static_cast<double>(random() >> 11) * 0x1p-53;
  extremal::Volume v;
  v.size = {22, 20, 18};
  std::vector<float> samples;
  for (int k = 0; k < kSize[2]; ++k)
    for (int j = 0; j < kSize[1]; ++j)
      for (int i = 0; i < kSize[0]; ++i) {
        double sum = 0;
        int count = 0;
        for (int n = 0; n < 27; ++n) {
          const int a = i + n % 3 - 1, b = j + n / 3 % 3 - 1, c = k + n / 9 - 1;
          if (a < 0 || b < 0 || c < 0 || a >= kSize[0] || b >= kSize[1] || c >= kSize[2]) continue;
          sum += raw[static_cast<std::size_t>((c * kSize[1] + b) * kSize[0] + a)];
          ++count;
        }
        const double x = std::clamp((sum / count - 0.4) * 12, 0.0, 1.0);
        samples.push_back(static_cast<float>(std::floor(x * steps)));
      }
  v.samples = std::move(samples);
  return v;
}

}  // namespace

TEST_CASE("extremal noise: certificates of clipped noise are accepted") {
  std::size_t flat = 0, ambiguous = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U}) {
    const double steps = seed % 3 == 0 ? 40 : 4;
    extremal::Options options;
    options.sigma = seed % 2 == 0 ? 0.7 : 0.5;
    options.tensor_sigma = 0.5;
    if (seed % 4 != 0) options.min_value = 0.5 * steps;
    certify::ExtremalCertificate certificate;
    const auto r = extremal::extract(clipped_noise(seed, steps), options, &certificate);
    const auto verdict = certify::verify(certify::encode(certificate));
    INFO(seed << ": " << verdict.reason);
    CHECK(verdict.accepted);
    CHECK(r.counts.odd_valence_unexplained == 0);
    flat += r.counts.flat_nodes;
    ambiguous += r.counts.ambiguous_faces;
    // As written: more than two polygons at a pair of points only where a junction is named.
    std::map<std::pair<kernel::Index, kernel::Index>, int> valence;
    for (std::size_t p = 0; p < r.polygons(); ++p)
      for (kernel::Index i = r.first[p]; i < r.first[p + 1]; ++i) {
        const auto a = r.corners[i], b = r.corners[i + 1 < r.first[p + 1] ? i + 1 : r.first[p]];
        ++valence[std::minmax({a, b})];
      }
    std::map<std::pair<kernel::Index, kernel::Index>, extremal::Reason> named;
    for (const auto& f : r.features) named[std::minmax({f.a, f.b})] = f.reason;
    for (const auto& [pair, count] : valence) CHECK((count == 2) == (named.count(pair) == 0));
  }
  CHECK(flat > 100);
  CHECK(ambiguous > 100);
}
