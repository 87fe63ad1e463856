// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <set>

#include "algorithms/ridges/certificate.hpp"
#include "certify/verify.hpp"
#include "tests/ridges/ridge_cases.hpp"

using namespace crest;
using namespace crest::tests;

namespace {

// Everything after the data section: the claim, without the frames.
certify::Bytes claim_of(const RidgeCase& c) {
  auto certificate =
      ridges::make_certificate(c.mesh, c.forms, ridges::extract_ridge_graph(c.mesh, c.forms));
  for (auto& m : certificate.data.monge) m = {};
  return certify::encode(certificate);
}

certify::Bytes certificate_of(const RidgeCase& c) {
  return certify::encode(
      ridges::make_certificate(c.mesh, c.forms, ridges::extract_ridge_graph(c.mesh, c.forms)));
}

/// An ellipsoid with noise: faces of non-zero index lie close together.
RidgeCase fitted_noise_case() {
  RidgeCase c = exact_case("ellipsoid", {1, 1.5, 2}, 1500, true);
  Draw d(77);
  std::vector<kernel::Vec3> points = c.mesh.points();
  for (auto& p : points)
    for (double& x : p) x += 0.01 * d.uniform();
  c.mesh = kernel::TriangleMesh(points, c.mesh.faces());
  c.forms = ridges::fit_monge_forms(c.mesh, {}).forms;
  return c;
}

std::vector<RidgeCase> symmetric_cases() {
  std::vector<RidgeCase> cases;
  cases.push_back(exact_case("ellipsoid", {1, 1.5, 2}, 2500, false));  // vertices on the planes
  cases.push_back(exact_case("sphere", {}, 1000, false));              // every point an umbilic
  cases.push_back(exact_case("plane", {}, 1000, false));
  cases.push_back(exact_case("cylinder", {}, 1000, false));
  cases.push_back(exact_case("torus", {}, 2000, false));  // b0 identically zero
  return cases;
}

}  // namespace

TEST_CASE("a certificate handed on in pieces is the whole one") {
  std::vector<RidgeCase> cases = symmetric_cases();
  cases.push_back(fitted_noise_case());
  for (const RidgeCase& c : cases)
    for (const std::size_t threads : {1u, 2u}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      const certify::Bytes whole = certificate_of(c);
      const ridges::ClaimedRidges claimed = ridges::extract_claimed(c.mesh, c.forms);
      certify::Bytes pieces;
      std::size_t count = 0;
      ridges::hand_on_certificate(claimed.envelope, c.mesh, c.forms,
                                  [&](std::span<const std::uint8_t> piece) {
                                    pieces.insert(pieces.end(), piece.begin(), piece.end());
                                    ++count;
                                  });
      CHECK(pieces == whole);
      CHECK(count > 4);
      CHECK(claimed.data_digest == certify::data_digest(whole));
      CHECK(ridges::extract_certified(c.mesh, c.forms).certificate == whole);
    }
}

TEST_CASE("the graph does not depend on the stored frames' signs") {
  std::uint64_t salt = 900;
  for (RidgeCase& c : symmetric_cases()) {
    const certify::Bytes before = claim_of(c);
    for (int trial = 0; trial < 3; ++trial) {
      Draw d(salt++);
      RidgeCase flipped = c;
      for (auto& m : flipped.forms)
        if (d.coin()) reverse_frame(m);
      REQUIRE(claim_of(flipped) == before);
    }
  }
}

TEST_CASE("symmetric models exercise the symbolic rules and certify") {
  std::uint64_t zeros = 0;
  for (const RidgeCase& c : symmetric_cases()) {
    const ridges::RidgeGraph g = ridges::extract_ridge_graph(c.mesh, c.forms);
    zeros += g.zero_extremalities[0] + g.zero_extremalities[1];
    const certify::Verdict v = certify::verify(certificate_of(c));
    CAPTURE(v.reason);
    REQUIRE(v.accepted);
  }
  CHECK(zeros > 0);
}

TEST_CASE("indices sum to the Euler characteristic for any Monge data whatsoever", "[stress]") {
  const std::vector<RidgeCase> shapes = {exact_case("ellipsoid", {1, 1.5, 2}, 640, true),
                                         exact_case("torus", {}, 600, true)};
  std::uint64_t salt = 1000, conflicts = 0;
  for (const RidgeCase& shape : shapes)
    for (Family family : kFamilies)
      for (std::uint64_t trial = 0; trial < scaled(8); ++trial) {
        RidgeCase c = shape;
        c.forms = random_forms(c.forms.size(), family, salt++);
        const ridges::RidgeGraph g = ridges::extract_ridge_graph(c.mesh, c.forms);
        CAPTURE(name_of(family), trial);
        REQUIRE(g.twice_index_sum == 2 * c.mesh.euler_characteristic());
        REQUIRE(ridges::open_ends(g) == 0);
        conflicts += g.conflict_triangles;
        const certify::Verdict v = certify::verify(certificate_of(c));
        CAPTURE(v.reason);
        REQUIRE(v.accepted);
      }
  CHECK(conflicts > 1000);
}

TEST_CASE("certificates do not depend on the number of threads") {
  const sampling::SurfaceSample s = sampling::sample("blend", {}, 10000, true);
  const kernel::TriangleMesh mesh(s.points, s.faces);
  auto run = [&](std::size_t threads) {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return certificate_of({mesh, ridges::fit_monge_forms(mesh, {}).forms, s.known});
  };
  const certify::Bytes one = run(1);
  CHECK(run(2) == one);
  CHECK(run(4) == one);
}

TEST_CASE("patches of many umbilics do not depend on the number of threads") {
  RidgeCase c = exact_case("ellipsoid", {1, 1.5, 2}, 2500, true);
  for (std::uint64_t seed = 0; seed < scaled(4); ++seed) {
    c.forms = random_forms(c.forms.size(), Family::generic, seed);
    auto run = [&](std::size_t threads) {
      tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      return certificate_of(c);
    };
    CHECK(ridges::extract_ridge_graph(c.mesh, c.forms).umbilics.size() > 500);
    const certify::Bytes one = run(1);
    CHECK(run(2) == one);
    CHECK(run(4) == one);
  }
}

TEST_CASE("the checker accepts what is extracted, under both arithmetics") {
  for (const char* name : {"ellipsoid", "blend", "perturbed-torus"}) {
    const RidgeCase c = fitted_case(name, {}, 2500, true);
    const certify::Bytes bytes = certificate_of(c);
    const certify::Verdict fast = certify::verify(bytes);
    certify::VerifyOptions options;
    options.arithmetic = certify::Arithmetic::mpfr;
    const certify::Verdict slow = certify::verify(bytes, options);
    CAPTURE(name, fast.reason, slow.reason);
    CHECK(fast.accepted);
    CHECK(slow.accepted);
    CHECK(fast.lines == slow.lines);
  }
}

TEST_CASE("one set of data has true certificates with other patches, each fixed in its numbers") {
  const RidgeCase c = fitted_noise_case();
  std::set<std::size_t> counts;
  std::size_t moved = 0;
  certify::Digest data{};
  for (const double size : {0.0, 1.0, 3.0}) {
    ridges::GraphOptions options;
    options.umbilic_patch = size;
    const auto graph = ridges::extract_ridge_graph(c.mesh, c.forms, options);
    auto certificate = ridges::make_certificate(c.mesh, c.forms, graph);
    const certify::Bytes bytes = certify::encode(certificate);
    const certify::Verdict verdict = certify::verify(bytes);
    CAPTURE(size, verdict.reason);
    REQUIRE(verdict.accepted);
    if (size == 0) data = *verdict.data;
    CHECK(*verdict.data == data);
    CHECK(verdict.lines[4].rfind("umbilics (for the stated patches): ", 0) == 0);
    counts.insert(graph.umbilics.size());
    std::set<kernel::Index> of_non_zero_index;
    for (const auto& i : graph.face_indices) of_non_zero_index.insert(i.face);
    for (auto& patch : certificate.patches)
      for (const kernel::Index f : patch.faces) {
        if (f == patch.centre || !of_non_zero_index.count(f)) continue;
        const kernel::Index centre = patch.centre;
        patch.centre = f;
        const certify::Verdict wrong = certify::verify(certify::encode(certificate));
        CHECK_FALSE(wrong.accepted);
        moved += wrong.reason.find("is not the central one") != std::string::npos;
        patch.centre = centre;
      }
  }
  CHECK(counts.size() == 3);
  CHECK(moved > 0);
}
