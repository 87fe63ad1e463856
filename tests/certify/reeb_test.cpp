// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 3: true certificates of Reeb graphs are accepted, under both arithmetics, whatever the
// cuts.
#include <catch2/catch.hpp>
#include <iostream>
#include <set>

#include "certify/container/container.hpp"
#include "certify/reeb/decode.hpp"
#include "certify/verify.hpp"
#include "tests/certify/reeb_samples.hpp"
#include "tests/certify/reference_reeb.hpp"
#include "tests/support/environment.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

constexpr Values kKinds[] = {Values::random, Values::small, Values::constant, Values::ramp,
                             Values::mixed};

Verdict check(const Bytes& bytes, Arithmetic arithmetic) {
  VerifyOptions options;
  options.arithmetic = arithmetic;
  const Verdict verdict = verify(bytes, options);
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  CHECK(verdict.lines.size() == 7);
  return verdict;
}

}  // namespace

TEST_CASE("true Reeb graphs are accepted under both arithmetics, with any cuts") {
  Random random(kSeed);
  std::uint64_t graphs = 0, loops = 0, cuts = 0, line = 0, face = 0, parallel = 0, exact = 0;
  std::set<std::int32_t> characteristics;
  for (std::uint64_t round = 0; round < scaled(6); ++round)
    for (const ReebSurface& surface : reeb_surfaces(random))
      for (const int degree : {1, 2})
        for (const Values kind : kKinds) {
          INFO(surface.name << ", degree " << degree << ", kind " << static_cast<int>(kind));
          const ReferenceReeb reference(reeb_data(surface, degree, kind, random));
          REQUIRE(reference.valid());
          const double extra = round % 3 == 0 ? 0 : round % 3 == 1 ? 0.3 : 1;
          const ReebCertificate c = reference.certificate(random, extra);
          const Bytes bytes = encode(c);
          const Verdict doubles = check(bytes, Arithmetic::doubles);
          const Verdict mpfr = check(bytes, Arithmetic::mpfr);
          CHECK(doubles.lines == mpfr.lines);
          CHECK(ReferenceReeb::is_true(c));
          for (std::size_t i = 1; i < c.arcs.size(); ++i)
            parallel +=
                c.arcs[i].lower == c.arcs[i - 1].lower && c.arcs[i].upper == c.arcs[i - 1].upper;
          if (surface.closed_orientable) {
            CHECK(reference.loops() <= surface.genus);
            const std::string genus = "genus " + std::to_string(surface.genus);
            CHECK(doubles.lines.back().find(genus) != std::string::npos);
          }
          ++graphs;
          loops += static_cast<std::uint64_t>(reference.loops());
          cuts += c.cuts.size();
          line += c.line_critical, face += c.face_critical;
          exact += doubles.signs.exact;
          characteristics.insert(c.euler_characteristic);
        }
  std::cout << "Reeb graphs: " << graphs << " accepted twice, " << loops << " loops, " << cuts
            << " cuts, " << line << " line-critical and " << face << " face-critical nodes, "
            << parallel << " parallel arcs, " << exact << " signs by rationals\n";
  CHECK(loops > graphs / 4);
  CHECK(line > 0);
  CHECK(face > 0);
  CHECK(parallel > 0);
  CHECK(exact > 0);
  CHECK(characteristics.size() >= 6);
}

TEST_CASE("values near each other and far from 1 are ordered exactly") {
  Random random(kSeed + 1);
  const auto surfaces = reeb_surfaces(random);
  std::uint64_t exact = 0;
  for (std::uint64_t round = 0; round < scaled(60); ++round) {
    const ReebSurface& surface = surfaces[round % surfaces.size()];
    ReebCertificate data = reeb_data(surface, 2, Values::small, random);
    const double scales[] = {0x1p-1070, 0x1p-300, 0x1p-52, 1, 0x1p+300, 0x1p+1000};
    const double scale = scales[random() % 6];
    const double offset = scale < 2 && random() % 2 ? 0x1p+40 * scale : 0;
    for (auto* list : {&data.values, &data.edge_values})
      for (double& x : *list)
        x = offset +
            x * scale * (random() % 4 ? 1 : 1 + 0x1p-50 * static_cast<double>(random() % 9));
    const ReferenceReeb reference(data);
    REQUIRE(reference.valid());
    const Bytes bytes = encode(reference.certificate(random, 0.2));
    INFO(surface.name << ", scale " << scale << ", offset " << offset);
    exact += check(bytes, Arithmetic::doubles).signs.exact;
    check(bytes, Arithmetic::mpfr);
  }
  CHECK(exact > 0);
}

TEST_CASE("equal values of quantised data are found in native integers and rationals alike") {
  Random random(kSeed + 4);
  const auto surfaces = reeb_surfaces(random);
  // Small values times an odd number: in the middle one doubles round their products, 128 bits do
  // not; the last is beyond what 128 bits are proved for.
  const double factors[] = {1, 0x1p+17 + 1, 0x1p+24 + 1};
  std::array<std::uint64_t, 3> exact{};
  for (std::uint64_t round = 0; round < scaled(60); ++round) {
    const ReebSurface& surface = surfaces[round % surfaces.size()];
    const ReebCertificate small = reeb_data(surface, 2, Values::small, random);
    for (std::size_t i = 0; i < 3; ++i) {
      ReebCertificate data = small;
      for (auto* list : {&data.values, &data.edge_values})
        for (double& x : *list) x *= factors[i] * 0x1p-30;
      const ReferenceReeb reference(data);
      INFO(surface.name << ", factor " << factors[i]);
      const Bytes bytes = encode(reference.certificate(random, 0.2));
      exact[i] += check(bytes, Arithmetic::doubles).signs.exact;
      check(bytes, Arithmetic::mpfr);
    }
  }
  CHECK(exact[1] > 100);
  CHECK(exact[2] > 100);
}

TEST_CASE("a Reeb graph's certificate has one encoding, and --input is refused") {
  Random random(kSeed + 2);
  for (const ReebSurface& surface : reeb_surfaces(random))
    for (const int degree : {1, 2}) {
      const ReferenceReeb reference(reeb_data(surface, degree, Values::mixed, random));
      const Bytes bytes = encode(reference.certificate(random, 0.3));
      const Container container = open_container(bytes);
      CHECK(container.claim == kReeb);
      CHECK(encode(decode_reeb(container.data, container.claims)) == bytes);
      VerifyOptions options;
      options.input = InputMesh{"mesh.off", {}, {}};
      CHECK_THROWS_AS(verify(bytes, options), TieUnavailable);
    }
}

TEST_CASE("data that are no surface or miss values are rejected") {
  Random random(kSeed + 3);
  const auto refused = [](const ReebCertificate& c, const char* why) {
    const Verdict verdict = verify(encode(c));
    INFO(verdict.reason);
    CHECK_FALSE(verdict.accepted);
    CHECK(verdict.reason.find(why) != std::string::npos);
    CHECK_FALSE(ReferenceReeb(c).valid());
  };
  const auto with = [&](Faces faces, std::size_t vertices) {
    ReebCertificate c =
        reeb_data({"", std::move(faces), vertices, 0, false}, 1, Values::random, random);
    for (std::uint32_t v = 0; v < vertices; ++v) c.order.push_back(v);
    return c;
  };
  refused(with({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, 5), "more than two faces");
  refused(with({{0, 1, 2}, {2, 1, 0}}, 3), "the same corners");
  refused(with({{0, 1, 2}, {0, 3, 4}}, 5), "neither one cycle nor one path");
  refused(with({{0, 1, 2}}, 4), "in no face");
  refused(with({{0, 1, 4}}, 3), "no such vertex");
  refused(with({{0, 1, 1}}, 3), "a vertex twice");
  // Two tetrahedra that share a vertex: its link is two cycles.
  refused(
      with({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}, {0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {5, 6, 0}},
           7),
      "neither one cycle nor one path");
  ReebCertificate few = with({{0, 1, 2}, {1, 2, 3}}, 4);
  few.edge_values = {0, 0, 0, 0};
  refused(few, "4 midpoint values for 5 edges");
}

TEST_CASE("ties are counted: a constant's graph is that of the numbering, contracted to points") {
  Random random(kSeed + 5);
  for (const ReebSurface& surface : reeb_surfaces(random))
    for (const int degree : {1, 2}) {
      INFO(surface.name << ", degree " << degree);
      const ReferenceReeb reference(reeb_data(surface, degree, Values::constant, random));
      const ReebCertificate c = reference.certificate(random);
      CHECK(c.tied_arcs == c.arcs.size());
      CHECK(c.contracted_nodes == c.components);
      const Verdict verdict = check(encode(c), Arithmetic::doubles);
      const std::string words =
          ": the Reeb graph of the values ordered by number at ties; " +
          std::to_string(c.arcs.size()) +
          " arcs join equal values; contracted: " + std::to_string(c.components) + " nodes, 0 arcs";
      CHECK(verdict.lines.back().find(words) != std::string::npos);
      for (const std::uint32_t step : {1U, 0xffffffffU, 0x80000000U})
        for (auto number : {&ReebCertificate::tied_arcs, &ReebCertificate::contracted_nodes}) {
          ReebCertificate wrong = c;
          wrong.*number += step;
          CHECK_FALSE(verify(encode(wrong)).accepted);
        }
    }
}
