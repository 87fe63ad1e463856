// SPDX-License-Identifier: GPL-3.0-or-later
// Fields cut into pieces: joined, surfaces and certificate are those of the whole, byte for byte.
#include "algorithms/modes/pieces.hpp"

#include <catch2/catch.hpp>

#include "algorithms/modes/certificate.hpp"
#include "tests/modes/samples.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::Index;

namespace {

struct Extracted {
  modes::ModeResult result;
  certify::Bytes certificate;
};

Extracted extracted(modes::ModeField field, const modes::Level& level,
                    const modes::ModeOptions& options, const modes::Workers* workers) {
  const modes::ZeroSet zeros = modes::insert_zeros(field);
  std::vector<certify::ModeLevel> records(1);
  Extracted r{modes::extract(field, level, options, records[0], workers), {}};
  r.certificate = certify::encode(modes::make_certificate(field, zeros, std::move(records)));
  return r;
}

auto counts_in(const modes::ModeCounts& c) {
  return std::tie(c.total, c.rejected_bound, c.rejected_bernstein, c.active, c.cones,
                  c.graph_at_once, c.graph_cells, c.uniform, c.tests, c.exact_tests, c.max_depth);
}

void check_same(const Extracted& a, const Extracted& b) {
  CHECK(a.certificate == b.certificate);
  CHECK(counts_in(a.result.counts) == counts_in(b.result.counts));
  CHECK(a.result.undecided == b.result.undecided);
  CHECK(a.result.exhausted == b.result.exhausted);
  REQUIRE(a.result.surfaces.size() == b.result.surfaces.size());
  for (std::size_t k = 0; k < a.result.surfaces.size(); ++k) {
    const modes::ModeSurface &s = a.result.surfaces[k], &t = b.result.surfaces[k];
    CHECK(s.points == t.points);
    CHECK(s.triangles == t.triangles);
    CHECK(s.tensors == t.tensors);
    CHECK(s.component_of == t.component_of);
  }
}

void check_pieces(const modes::ModeField& field, const modes::Level& level,
                  const modes::ModeOptions& options = {}) {
  const Extracted whole = extracted(field, level, options, nullptr);
  for (const Index pieces : {2U, 7U, 64U}) {
    INFO("mode " << level.p << "/" << level.q << ", " << pieces << " pieces");
    const modes::Workers workers = modes::workers_here(pieces);
    check_same(extracted(field, level, options, &workers), whole);
  }
}

}  // namespace

TEST_CASE("mode pieces: 2, 7 and 64 pieces have the bytes of the whole") {
  for (const Row& row : small_boxes()) {
    INFO("field " << row.name);
    for (const modes::Level& level : {modes::Level{0, 1}, modes::Level{9, 10}})
      check_pieces(box(row.rows, 2, 3, Cut::mirrored), level);
  }
}

TEST_CASE("mode pieces: small integers, with ties, exact zeros and spent budgets") {
  modes::ModeOptions options;
  options.budget = 2000;
  for (const modes::Level& level : {modes::Level{0, 1}, modes::Level{1, 2}})
    check_pieces(random_integers(4, 6), level, options);
  options.budget = 3;  // spent in most tetrahedra
  options.max_depth = 2;
  check_pieces(random_integers(4, 9), {1, 2}, options);
}

TEST_CASE("mode pieces: each tetrahedron is in one piece, and what its record says counts") {
  const auto field = random_integers(4, 6);
  std::size_t tets = 0, tests = 0;
  modes::Workers workers = modes::workers_here(5);
  const auto plain = workers.tests;
  workers.tests = [&](std::size_t jobs, const auto& job) {
    auto r = plain(jobs, job);
    for (auto& records : r) {
      tets += records.signs.size();
      tests += records.tests.size();
      for (auto& sign : records.signs) sign = {modes::Finding::negative, true};
    }
    return r;
  };
  const auto r = modes::extract(field, {1, 2}, {}, &workers);
  CHECK(tets == field.mesh.tets().size());
  CHECK(tests > tets / 2);
  CHECK(r.counts.rejected_bound + r.counts.cones == tets);
  CHECK(r.surfaces[0].triangles.empty());
}

TEST_CASE("mode pieces: a tetrahedron each, and more workers than there are") {
  const auto field = random_integers(3, 5);
  const Extracted whole = extracted(field, {1, 2}, {}, nullptr);
  for (const std::size_t pieces : {field.mesh.tets().size(), 2 * field.mesh.tets().size()}) {
    const modes::Workers workers = modes::workers_here(static_cast<Index>(pieces));
    check_same(extracted(field, {1, 2}, {}, &workers), whole);
  }
}
