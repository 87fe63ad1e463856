// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 8: what the extraction makes of odd data, which its checker must accept: ties, plateaus,
// numbers of every size, cells of any shape, grids that are a few cells wide.
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "algorithms/extremal/extremal.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/certify_extremal/extremal_samples.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;
using extremal::Definition;
using extremal::Options;
using extremal::Side;
using extremal::Volume;

namespace {

/// What a draw is made of.
struct Odd {
  Volume volume;
  Options options;
  std::string samples;  ///< their family
};

double real(Random& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}
int below(Random& random, int n) {
  return static_cast<int>(random() % static_cast<std::uint64_t>(n));
}

const char* const kFamilies[] = {"whole numbers",   "constant", "steps",         "along an axis",
                                 "along diagonals", "smooth",   "of every size", "tiny",
                                 "period four",     "large"};

double sample_of(int family, const std::array<int, 3>& at, int salt, Random& random) {
  const auto [x, y, z] = at;
  switch (family) {
    case 0:
      return below(random, 4);
    case 1:
      return salt;
    case 2:
      return x + (salt % 2 == 0 ? y : 0) > 5 + salt ? 7 : salt;
    case 3:
      return (salt % 3 == 0 ? x : salt % 3 == 1 ? y : z) % 5 == 2 ? 6 : 0;
    case 4:
      return (x + y + (salt % 2 == 0 ? z : 0)) % 6 == 3 ? 12 : (x + y) % 2;
    case 5:
      return std::exp(
          -std::pow(std::hypot(x - 3.7, y - 3.1, salt % 2 == 0 ? z - 3.4 : 0) - 2.2, 2));
    case 6:
      return std::ldexp(real(random) - 0.5, below(random, 119) - 59);
    case 7:
      return std::ldexp(below(random, 9) - 4, -149 + salt);
    case 8:
      return 100 + (x % 4 == 1 ? 1 : x % 4 == 3 ? -1 : 0);
    default:
      return std::ldexp(real(random) - 0.5, 60);
  }
}

Odd draw(Random& random) {
  Odd r;
  Volume& v = r.volume;
  const int family = below(random, 10), salt = below(random, 6);
  r.samples = kFamilies[family];
  const bool image = below(random, 2) == 0;
  for (std::size_t k = 0; k < 3; ++k)
    v.size[k] = image && k == 2 ? 1 : static_cast<kernel::Index>(4 + below(random, image ? 12 : 5));
  std::vector<double> samples;
  for (int z = 0; z < static_cast<int>(v.size[2]); ++z)
    for (int y = 0; y < static_cast<int>(v.size[1]); ++y)
      for (int x = 0; x < static_cast<int>(v.size[0]); ++x)
        samples.push_back(sample_of(family, {x, y, z}, salt, random));
  Options& o = r.options;
  // Half of the levels are samples: ties with plateaus.
  if (const int level = below(random, 6); level < 3)
    o.min_value = samples[random() % samples.size()];
  else if (level == 3)
    o.min_value = below(random, 5) - 1.5;
  else if (level == 4 && below(random, 4) == 0)
    o.min_value = below(random, 2) == 0 ? -1e308 : 5e-324;
  const int shape = below(random, 4);
  for (std::size_t k = 0; k < 3; ++k)
    v.spacing[k] = shape == 0   ? 1
                   : shape == 1 ? std::ldexp(1.0, below(random, 9) - 4)
                   : shape == 2 ? 0.5 + real(random)
                                : std::ldexp(1 + real(random), below(random, 119) - 60);
  if (shape == 3 && below(random, 2) == 0) v.spacing = {v.spacing[0], v.spacing[0], v.spacing[0]};
  if (below(random, 2) == 0)
    v.samples = std::vector<float>(samples.begin(), samples.end());
  else
    v.samples = std::move(samples);
  o.definition = below(random, 2) == 0 ? Definition::hessian : Definition::structure;
  o.side = below(random, 2) == 0 ? Side::valley : Side::ridge;
  const double sigmas[] = {0, 0.5, 0.7, 1, 2, 30};
  o.sigma = sigmas[below(random, 6)];
  if (below(random, 2) == 0) o.tensor_sigma = sigmas[below(random, 6)];
  if (const int strength = below(random, 8); strength < 3)
    o.min_strength = strength == 0   ? 5e-324
                     : strength == 1 ? std::ldexp(1.0, -below(random, 8))
                                     : 1e308;
  if (below(random, 6) == 0) o.refine = 1 + below(random, 2);
  return r;
}

}  // namespace

namespace {

certify::Bytes extracted(const Odd& odd) {
  certify::ExtremalCertificate c;
  extremal::extract(odd.volume, odd.options, &c);
  return certify::encode(c);
}
/// The claim's checker may leave these open: SPEC.md, "What the checker proves", 5.
bool is_left_open(const Odd& odd, const certify::Verdict& verdict) {
  return verdict.undecided && odd.options.min_strength > 0;
}
/// 66 000 x 7 nodes, a ridge along the long axis.
Volume long_image(std::size_t axis) {
  Volume v;
  v.size = {7, 7, 1};
  v.size[axis] = 66000;
  std::vector<float> samples;
  for (kernel::Index y = 0; y < v.size[1]; ++y)
    for (kernel::Index x = 0; x < v.size[0]; ++x) {
      const double across = std::fabs(static_cast<double>(axis == 0 ? y : x) - 3.3);
      samples.push_back(static_cast<float>(std::max(0.0, 200 - 60 * across)));
    }
  v.samples = std::move(samples);
  return v;
}

}  // namespace

TEST_CASE("extremal: the extraction's certificates of odd data are accepted") {
  Random random(kSeed);
  std::uint64_t made = 0, accepted = 0, open = 0, refused = 0, meshes = 0, images = 0;
  for (std::uint64_t i = 0; i < scaled(400); ++i) {
    const Odd odd = draw(random);
    certify::ExtremalCertificate c;
    try {
      extremal::extract(odd.volume, odd.options, &c);
    } catch (const kernel::InputError& error) {
      INFO(error.what());
      CHECK(std::string(error.what()) == "samples: too large for binary32; scale them");
      ++refused;
      continue;
    }
    ++made;
    images += odd.volume.size[2] == 1 ? 1 : 0;
    meshes += c.components.empty() ? 0 : 1;
    const auto verdict = certify::verify(certify::encode(c));
    accepted += verdict.accepted ? 1 : 0;
    open += is_left_open(odd, verdict) ? 1 : 0;
    const Options& o = odd.options;
    INFO(i << ": " << odd.samples << ", size " << odd.volume.size[0] << ' ' << odd.volume.size[1]
           << ' ' << odd.volume.size[2] << ", spacing " << odd.volume.spacing[0] << ' '
           << odd.volume.spacing[1] << ' ' << odd.volume.spacing[2] << ", sigma " << o.sigma << ' '
           << o.tensor_sigma.value_or(-1) << ", level " << o.min_value.value_or(NAN)
           << ", strength " << o.min_strength << ", halved " << o.refine << ", "
           << (o.definition == Definition::hessian ? "hessian" : "structure") << ": "
           << verdict.reason);
    CHECK((verdict.accepted || is_left_open(odd, verdict)));
  }
  std::cout << "odd data: " << made << " certificates (" << images << " of images), " << meshes
            << " with a mesh, " << accepted << " accepted, " << open << " left open, " << refused
            << " samples refused\n";
  CHECK(meshes > made / 4);
  CHECK(open * 100 <= made);
}

TEST_CASE("extremal: odd data have the same bytes with 1, 2, 3 and 7 threads") {
  Random random(kSeed + 1);
  for (std::uint64_t i = 0; i < scaled(24); ++i) {
    const Odd odd = draw(random);
    std::vector<certify::Bytes> bytes;
    for (const std::size_t threads : {1U, 2U, 3U, 7U}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      try {
        bytes.push_back(extracted(odd));
      } catch (const kernel::InputError&) {
        bytes.push_back({});
      }
    }
    INFO(i);
    for (const auto& other : bytes) CHECK(other == bytes[0]);
  }
}

TEST_CASE("extremal: axes of more than 65 535 nodes") {
  for (const std::size_t axis : {0U, 1U}) {
    certify::ExtremalCertificate c;
    extremal::extract(long_image(axis), {}, &c);
    require_accepted(c);
    REQUIRE(c.components.size() == 1);
    CHECK(c.components[0].polygons == 65998);
    CHECK(c.components[0].loops == 2);
  }
}
