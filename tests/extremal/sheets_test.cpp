// SPDX-License-Identifier: GPL-3.0-or-later
// Known surfaces come out with their topology, and their certificates are accepted.
#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "algorithms/extremal/fields.hpp"
#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/extremal/reference_sheets.hpp"
#include "tests/support/degenerate_families.hpp"

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

extremal::Options at_least(double value) {
  extremal::Options options;
  options.min_value = value;
  return options;
}

}  // namespace

TEST_CASE("extremal sheets: the table at 48 nodes") {
  for (const Row& row : table()) {
    const auto [r, verdict] = extracted(sampled(row.sheet, 48), at_least(0.4));
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

TEST_CASE("extremal sheets: three half planes meet along the axis") {
  const auto [r, verdict] = extracted(sampled(junction_sheet, 48), at_least(0.4));
  REQUIRE(r.components.size() == 1);
  CHECK(r.components[0].euler_characteristic == 1);
  CHECK(r.components[0].boundary_loops == 1);
  CHECK(r.components[0].orientable);
  // One on each of the faces across z that have four cells' vertices on both sides.
  CHECK(r.counts.valence[2] == 46);
  for (const auto& f : r.features) {
    if (f.reason != extremal::Reason::discontinuity) continue;
    CHECK(std::hypot(r.points[f.a][0], r.points[f.a][1]) < 0.05);
  }
  INFO(verdict.reason);
  CHECK(verdict.accepted);
}

TEST_CASE("extremal sheets: a closed shell is isotopic to the field's, and lies on it") {
  const auto [r, verdict] = extracted(sampled(sphere_sheet, 64), at_least(0.4));
  REQUIRE(r.components.size() == 1);
  CHECK(r.components[0].isotopic == true);
  CHECK(r.components[0].euler_characteristic == 2);
  CHECK(r.counts.regular + r.counts.empty > 30000);
  CHECK(r.counts.cone == 0);
  CHECK(r.features.empty());
  for (const auto& p : r.points) CHECK(std::hypot(p[0], p[1], p[2]) == Approx(0.6).margin(0.01));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
}

TEST_CASE("extremal sheets: an ellipsoid of 64 nodes is isotopic, its bounds by coordinate") {
  const auto ellipsoid = [](double x, double y, double z) {
    const double k = std::hypot(x / 0.7, y / 0.55, z / 0.45);
    const double slope = std::hypot(x / 0.49, y / 0.3025, z / 0.2025);
    return profile(k * (k - 1) / slope);
  };
  const auto [r, verdict] = extracted(sampled(ellipsoid, 64), at_least(0.4));
  REQUIRE(r.components.size() == 1);
  CHECK(r.components[0].isotopic == true);
  CHECK(r.components[0].euler_characteristic == 2);
  INFO(verdict.reason);
  CHECK(verdict.accepted);
}

TEST_CASE("extremal sheets: on a halved grid closed sheets are isotopic to the field's") {
  struct Sheet {
    Function f;
    unsigned nodes;
    int chi;
  };
  for (const Sheet& sheet :
       {Sheet{sphere_sheet, 32, 2}, Sheet{torus_sheet, 64, 0}, Sheet{genus2_sheet, 64, -2}}) {
    extremal::Options options = at_least(0.4);
    const auto before = extremal::extract(sampled(sheet.f, sheet.nodes), options);
    options.refine = 1;
    const auto [r, verdict] = extracted(sampled(sheet.f, sheet.nodes), options);
    INFO(sheet.nodes << " nodes, Euler characteristic " << sheet.chi);
    REQUIRE(before.components.size() == 1);
    REQUIRE(r.components.size() == 1);
    CHECK(before.components[0].isotopic == false);
    CHECK(r.components[0].isotopic == true);
    CHECK(r.components[0].euler_characteristic == sheet.chi);
    CHECK(r.components[0].boundary_loops == 0);
    CHECK(r.counts.cone + r.counts.open == 0);
    CHECK(r.components[0].area == Approx(before.components[0].area).epsilon(0.02));
    CHECK(r.h == before.h);
    INFO(verdict.reason);
    CHECK(verdict.accepted);
  }
}

TEST_CASE("extremal sheets: halving the grid leaves the field as it is") {
  extremal::Volume v = sampled(moebius_sheet, 12);
  v.spacing = {1, 2, 0.5};
  extremal::Options options;
  const extremal::Fields coarse(v, options);
  options.refine = 2;
  const extremal::Fields fine(v, options);
  for (int k = 0; k < 3; ++k) CHECK(fine.grid().size[static_cast<std::size_t>(k)] == 45);
  const auto at = [](const extremal::Fields& f, const extremal::Vec3& x) {
    extremal::Node cell;
    extremal::Vec3 t;
    for (std::size_t k = 0; k < 3; ++k) {
      cell[k] = static_cast<int>(x[k]);
      t[k] = x[k] - cell[k];
    }
    return f.at(cell, t);
  };
  Draw d(4);
  double worst = 0, size = 0, hessian = 0;
  for (int i = 0; i < 500; ++i) {
    // But next to the border, where coefficients are mirrored anew.
    const extremal::Vec3 x = {5.5 + 4.9 * d.uniform(), 5.5 + 4.9 * d.uniform(),
                              5.5 + 4.9 * d.uniform()};
    const auto a = at(coarse, x), b = at(fine, extremal::operator*(4, x));
    worst = std::max(worst, std::fabs(a.value - b.value));
    size = std::max(size, std::fabs(a.value));
    for (std::size_t n = 0; n < 6; ++n) {
      worst = std::max(worst, std::fabs(a.tensor[n] - b.tensor[n]));
      size = std::max(size, std::fabs(a.tensor[n]));
      hessian = std::max(hessian, std::fabs(a.hessian[n] - b.hessian[n]));
    }
  }
  CHECK(size > 0.1);
  CHECK(worst < 0x1p-22 * size);    // two roundings to binary32
  CHECK(hessian < 0x1p-12 * size);  // over a spacing of 1/8, twice
}

TEST_CASE("extremal sheets: the number of halvings belongs to the data") {
  extremal::Options options = at_least(0.4);
  options.refine = 1;
  certify::ExtremalCertificate c;
  extremal::extract(sampled(sphere_sheet, 20), options, &c);
  CHECK(c.data.refine == 1);
  CHECK(certify::verify(certify::encode(c)).accepted);
  for (const int refine : {0, 2, 3, 4}) {
    auto other = c;
    other.data.refine = static_cast<std::uint8_t>(refine);
    CHECK_FALSE(certify::verify(certify::encode(other)).accepted);
  }
}

TEST_CASE("extremal sheets: by Hess the largest component has the shape and claims no isotopy") {
  for (const Row& row : table()) {
    if (!row.orientable) continue;
    extremal::Volume v = sampled(row.sheet, 40);
    v.spacing = {1, 1, 1};
    extremal::Options options = at_least(0.4);
    options.definition = extremal::Definition::hessian;
    options.min_strength = 0.08;
    const auto [r, verdict] = extracted(v, options);
    INFO(row.name);
    const Component& c = largest(r);
    CHECK(c.euler_characteristic == row.chi);
    CHECK(c.boundary_loops == 0);
    CHECK(!c.isotopic.has_value());
    CHECK(r.counts.odd_valence_unexplained == 0);
    INFO(verdict.reason);
    CHECK(verdict.accepted);
  }
}

TEST_CASE("extremal sheets: spacing is the world's") {
  extremal::Volume v;
  v.size = {64, 64, 26};
  v.spacing = {1, 1, 2.5};
  std::vector<float> samples;
  for (int k = 0; k < 26; ++k)
    for (int j = 0; j < 64; ++j)
      for (int i = 0; i < 64; ++i) {
        const double d = std::hypot(i - 31.5, j - 31.5, 2.5 * (k - 12.5)) - 19;
        samples.push_back(static_cast<float>(std::exp(-d * d / 12)));
      }
  v.samples = std::move(samples);
  extremal::Options options = at_least(0.4);
  options.sigma = 1.5;
  const auto [r, verdict] = extracted(v, options);
  REQUIRE(r.components.size() == 1);
  CHECK(r.components[0].euler_characteristic == 2);
  CHECK(r.components[0].boundary_loops == 0);
  CHECK(r.components[0].area == Approx(4 * M_PI * 19 * 19).epsilon(0.03));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
}

TEST_CASE("extremal sheets: plateaus give flat nodes and no sheet") {
  // Clipped on one side: beside the step L is constant where T is not zero yet.
  extremal::Volume v;
  v.size = {24, 24, 24};
  std::vector<float> samples;
  for (int k = 0; k < 24; ++k)
    for (int j = 0; j < 24; ++j)
      for (int i = 0; i < 24; ++i) samples.push_back(i < 10 ? 0.0F : 1.0F);
  v.samples = std::move(samples);
  const auto [r, verdict] = extracted(v, {});
  CHECK(r.counts.flat_nodes > 0);
  CHECK(r.counts.undecided_edges == 0);
  CHECK(r.polygons() == 0);
  INFO(verdict.reason);
  CHECK(verdict.accepted);
}

TEST_CASE("extremal sheets: a sheet between nodes that are below the level is found") {
  // Coefficients 0 1 1 0: L = 0.833 at both nodes, 0.958 between.
  extremal::Volume v;
  v.size = {12, 12, 12};
  std::vector<float> samples;
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i) samples.push_back(i == 5 || i == 6 ? 1.0F : 0.0F);
  v.samples = std::move(samples);
  extremal::Options options = at_least(0.9);
  options.sigma = 0.5;
  options.tensor_sigma = 1;
  const auto [r, verdict] = extracted(v, options);
  CHECK(r.counts.extremal_edges == 144);
  REQUIRE(r.components.size() == 1);
  CHECK(r.components[0].euler_characteristic == 1);
  for (const auto& p : r.points) CHECK(p[0] == Approx(5.5).margin(1e-4));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
}

TEST_CASE("extremal sheets: the same bytes with one thread and with several") {
  const extremal::Volume v = sampled(moebius_sheet, 40);
  std::vector<certify::Bytes> bytes;
  for (const std::size_t threads : {1U, 3U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    certify::ExtremalCertificate c;
    extremal::extract(v, at_least(0.3), &c);
    bytes.push_back(certify::encode(c));
  }
  CHECK(bytes[0] == bytes[1]);
}

TEST_CASE("extremal sheets: bad input is named") {
  const auto message = [](const extremal::Volume& v, const extremal::Options& o) -> std::string {
    try {
      extremal::extract(v, o);
    } catch (const kernel::InputError& e) {
      return e.what();
    }
    return "";
  };
  extremal::Volume v = sampled(sphere_sheet, 8);
  std::get<0>(v.samples)[8 * 8 * 3 + 8 * 2 + 1] = NAN;
  CHECK(message(v, {}).find("sample (1, 2, 3)") == 0);
  v.size = {8, 8, 7};
  CHECK(message(v, {}).find("size") == 0);
  v.size = {3, 8, 8};
  CHECK(message(v, {}).find("fewer than 4 nodes") != std::string::npos);
  v = sampled(sphere_sheet, 8);
  extremal::Options o;
  o.sigma = -1;
  CHECK(message(v, o).find("sigma") == 0);
  o.sigma = 1;
  o.refine = 4;
  CHECK(message(v, o).find("refine") == 0);
  v.spacing[1] = 0;
  CHECK(message(v, {}).find("spacing") == 0);
  // Constant: nothing, and no error.
  v = sampled([](double, double, double) { return 7; }, 8);
  const auto [r, verdict] = extracted(v, {});
  CHECK(r.polygons() == 0);
  CHECK(verdict.accepted);
}

TEST_CASE("extremal curves: a circle in an image, a bar with two ends") {
  extremal::Volume v;
  v.size = {64, 70, 1};
  std::vector<float> ring, bar;
  for (int j = 0; j < 70; ++j)
    for (int i = 0; i < 64; ++i) {
      const double x = (i - 31.7) / 32, y = (j - 34.2) / 32;
      ring.push_back(static_cast<float>(profile(std::hypot(x, y) - 0.6)));
      bar.push_back(static_cast<float>(profile(y) * profile(std::max(0.0, std::fabs(x) - 0.5))));
    }
  v.samples = std::move(ring);
  const auto [r, verdict] = extracted(v, at_least(0.4));
  REQUIRE(r.components.size() == 1);
  CHECK(r.dimension == 2);
  CHECK(r.components[0].euler_characteristic == 0);
  CHECK(r.components[0].ends == 0);
  CHECK(r.components[0].area == Approx(2 * M_PI * 0.6 * 32).epsilon(0.01));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  v.samples = std::move(bar);
  const auto [s, accepted] = extracted(v, at_least(0.4));
  CHECK(largest(s).ends == 2);
  CHECK(largest(s).euler_characteristic == 1);
  INFO(accepted.reason);
  CHECK(accepted.accepted);
}
