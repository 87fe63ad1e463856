// SPDX-License-Identifier: GPL-3.0-or-later
// Known surfaces come out with their topology, and their certificates are accepted.
#include <catch2/catch.hpp>

#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "tests/extremal/reference_sheets.hpp"

using namespace crest;
using namespace crest::tests;
using extremal::Component;
using extremal::Result;

namespace {

struct Extracted {
  Result result;
  certify::Verdict verdict;
};

Extracted extracted(const extremal::Volume& volume, const extremal::Options& options) {
  certify::ExtremalCertificate certificate;
  Extracted r;
  r.result = extremal::extract(volume, options, &certificate);
  r.verdict = certify::verify(certify::encode(certificate));
  return r;
}

const Component& largest(const Result& r) {
  return *std::max_element(r.components.begin(), r.components.end(),
                           [](const auto& a, const auto& b) { return a.polygons < b.polygons; });
}

struct Row {
  std::string name;
  Function sheet;
  std::size_t critical, extremal, odd;
  int chi;
  std::size_t loops;
  bool orientable;
};

std::vector<Row> table() {
  return {{"sphere", sphere_sheet, 3696, 3696, 0, 2, 0, true},
          {"torus", torus_sheet, 4232, 4232, 0, 0, 0, true},
          {"genus 2", genus2_sheet, 3188, 3128, 136, -2, 0, true},
          {"Moebius", moebius_sheet, 1870, 1870, 256, 0, 1, false}};
}

}  // namespace

TEST_CASE("extremal sheets: the table at 48 nodes") {
  for (const Row& row : table()) {
    extremal::Options options;
    options.min_value = 0.4;
    const auto [r, verdict] = extracted(sampled(row.sheet, 48), options);
    INFO(row.name);
    CHECK(r.counts.critical_edges == row.critical);
    CHECK(r.counts.extremal_edges == row.extremal);
    CHECK(r.counts.odd_faces == row.odd);
    CHECK(r.counts.undecided_edges == 0);
    CHECK(r.counts.undecided_types == 0);
    REQUIRE(r.components.size() == 1);
    CHECK(r.components[0].euler_characteristic == row.chi);
    CHECK(r.components[0].boundary_loops == row.loops);
    CHECK(r.components[0].orientable == row.orientable);
    CHECK(r.counts.valence[2] == 0);
    CHECK(r.counts.valence[3] == 0);
    CHECK(r.counts.valence[0] == (row.loops > 0 ? row.odd : 0));
    INFO(verdict.reason);
    CHECK(verdict.accepted);
  }
}
