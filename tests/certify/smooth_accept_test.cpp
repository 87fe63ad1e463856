// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 4: true certificates of the tests' own producer and of crest are accepted, under both
// arithmetics; periods that the claim does not cover are refused.
#include <catch2/catch.hpp>

#include "certify/container/container.hpp"
#include "certify/ridges_smooth/decode.hpp"
#include "certify/verify.hpp"
#include "tests/certify/smooth_producer.hpp"
#include "tests/support/program.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

Verdict check(const RidgesSmoothCertificate& c, Arithmetic arithmetic = Arithmetic::doubles) {
  return verify(encode(c), {arithmetic, std::nullopt});
}

RidgesSmoothCertificate decoded(const Bytes& bytes) {
  const Container container = open_container(bytes);
  return decode_ridges_smooth(container.data, container.claims);
}

}  // namespace

TEST_CASE("smooth ridges: the tests' own certificates are accepted") {
  const auto all = smooth_claims();
  for (const auto& [name, c] : all) {
    const Bytes bytes = encode(c);
    const Verdict verdict = verify(bytes);
    INFO(name << ": " << verdict.reason);
    CHECK(verdict.accepted);
    CHECK(encode(decoded(bytes)) == bytes);
  }
  CHECK(all[0].certificate.patches.empty());
  CHECK(all[1].certificate.umbilics[0] == 1);
  CHECK(all[2].certificate.umbilics[1] == 1);
  CHECK(all[3].certificate.euler_characteristic == 0);
  CHECK(all[3].certificate.boundary_loops == 2);
}

TEST_CASE("smooth ridges: MPFR agrees") {
  const auto all = smooth_claims();
  CHECK(check(all[0].certificate, Arithmetic::mpfr).accepted);
  auto wrong = all[0].certificate;
  ++wrong.purple_points;
  CHECK_FALSE(check(wrong, Arithmetic::mpfr).accepted);
}

#ifdef CREST_PROGRAM
TEST_CASE("smooth ridges: an ellipsoid's certificate from crest is accepted") {
  const TemporaryFolder folder;
  const auto run =
      run_shell(std::string(CREST_PROGRAM) +
                    " ridges --quiet --surface 'x^2 + y^2/2.25 + z^2/4 - 1' --box '-3,3' "
                    "--certificate e.crest",
                folder.path(), ".");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const Bytes bytes = read_file((folder / "e.crest").string());
  const Verdict verdict = verify(bytes);
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  const auto c = decoded(bytes);
  CHECK(encode(c) == bytes);
  CHECK(c.umbilics == std::array<std::uint32_t, 4>{4, 0, 4, 0});
  CHECK(c.counts == std::array<std::uint32_t, 4>{1, 2, 1, 2});
}
#endif

TEST_CASE("smooth ridges: only periods that follow by the rules are believed") {
  const auto reason = [](const std::string& x, const std::string& from, const std::string& to) {
    RidgesSmoothCertificate c;
    c.surface = parametric(x, "v", "sin(u)", {from, to, "0", "1"}, 1);
    c.vertices.resize(3);
    c.faces = {{0, 1, 2}};
    c.face_records.resize(1);
    c.lifts.resize(1);
    return check(c).reason;
  };
  for (const auto& [x, from, to] : {std::array{"cos(2*u + v)", "-pi", "pi"},
                                    {"cos(u)^3/(2 + sin(u))", "0", "2*pi"},
                                    {"exp(cos(3*(u - v)))", "pi/2", "5*pi/2"},
                                    {"sqrt(2 + cos(u))", "1 - 1", "4*pi"},
                                    {"cos(u + 0.1*cos(u))", "0", "2*pi"},
                                    {"cos(1.5*u)", "0", "4*pi"},
                                    {"cos(u)", "1", "1 + 2*pi"}}) {
    INFO(x);
    CHECK(reason(x, from, to).find("surface") == std::string::npos);  // a later step refuses
  }
  for (const auto& [x, from, to] : {std::array{"cos(1.5*u)", "0", "2*pi"},
                                    {"u", "0", "2*pi"},
                                    {"cos(u)*u", "0", "2*pi"},
                                    {"cos(u^2)", "0", "2*pi"},
                                    {"cos(pi*u)", "0", "2*pi"},
                                    {"cos(u/v)", "0", "2*pi"}}) {
    INFO(x);
    CHECK(reason(x, from, to).find("not provably periodic") != std::string::npos);
  }
  CHECK(reason("cos(u)", "0", "6.283185307179586").find("rational multiple") != std::string::npos);
  CHECK(reason("cos(u)", "2*pi", "0").find("length") != std::string::npos);
  // Numbers that would grow without bound count as unknown.
  CHECK(reason("cos(((9^1000)^1000)^1000*u)", "0", "2*pi").find("not provably periodic") !=
        std::string::npos);
}
