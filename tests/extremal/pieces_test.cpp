// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes cut into pieces: joined, they are the whole, byte for byte.
#include "algorithms/extremal/pieces.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <numeric>

#include "algorithms/extremal/record_bytes.hpp"
#include "certify/extremal/encode.hpp"
#include "tests/extremal/reference_sheets.hpp"
#include "tests/support/memory_limit.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using extremal::Options;
using extremal::Result;
using extremal::Volume;
using kernel::GridBox;

namespace {

struct Outcome {
  Result result;
  certify::Bytes certificate;
};

Outcome of_whole(const Volume& volume, const Options& options) {
  Outcome r;
  certify::ExtremalCertificate c;
  r.result = extremal::extract(volume, options, &c);
  r.certificate = certify::encode(c);
  return r;
}

/// What the boxes' owners make of their pieces, in the boxes' order.
Outcome of_pieces(const Volume& volume, const Options& options, const std::vector<GridBox>& boxes) {
  Outcome r;
  certify::ExtremalCertificate c;
  r.result = extremal::extract_in_pieces(
      {volume.size, volume.spacing, volume.origin}, options, boxes,
      [&](const GridBox& box) { return extremal::part_of(volume, box); }, &c);
  extremal::store_samples(volume, c.data);
  r.certificate = certify::encode(c);
  return r;
}

template <class Items, class Tie>
bool alike(const Items& a, const Items& b, const Tie& tie) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const auto& x, const auto& y) { return tie(x) == tie(y); });
}

void check_same(const Outcome& a, const Outcome& b) {
  CHECK(a.certificate == b.certificate);
  const Result &x = a.result, &y = b.result;
  CHECK(x.points == y.points);
  CHECK(x.normals == y.normals);
  CHECK(x.first == y.first);
  CHECK(x.corners == y.corners);
  CHECK(x.critical_type == y.critical_type);
  CHECK(x.component == y.component);
  CHECK(x.strength == y.strength);
  CHECK(x.s == y.s);
  CHECK(x.plateness == y.plateness);
  CHECK(x.max_residual == y.max_residual);
  CHECK(x.h == y.h);
  CHECK(alike(x.features, y.features, [](const auto& f) { return std::tie(f.a, f.b, f.reason); }));
  CHECK(alike(x.undecided, y.undecided, [](const auto& e) { return std::tie(e.a, e.b, e.type); }));
  CHECK(alike(x.components, y.components, [](const auto& c) {
    return std::tie(c.polygons, c.vertices, c.euler_characteristic, c.boundary_loops, c.ends,
                    c.orientable, c.area, c.isotopic, c.critical_type);
  }));
  const auto counts = [](const extremal::Counts& c) {
    return std::tie(c.nodes, c.active_nodes, c.flat_nodes, c.empty, c.regular, c.cone, c.open,
                    c.edges, c.critical_edges, c.extremal_edges, c.undecided_edges,
                    c.undecided_types, c.odd_faces, c.junction_edges, c.ambiguous_faces,
                    c.sheets_split, c.valence, c.bisections, c.cone_tests);
  };
  CHECK(counts(x.counts) == counts(y.counts));
}

/// Boxes between random planes, cut again and again, in random order.
std::vector<GridBox> random_boxes(const kernel::GridSize& size, std::size_t count,
                                  tests::Random& random) {
  std::vector<GridBox> r{{{}, size}};
  while (r.size() < count) {
    const std::size_t i = random() % r.size();
    const std::size_t k = random() % 3;
    if (r[i].size()[k] < 2) continue;
    GridBox far = r[i];
    const auto cut = static_cast<kernel::Index>(far.low[k] + 1 + random() % (far.size()[k] - 1));
    r[i].high[k] = far.low[k] = cut;
    r.push_back(far);
  }
  for (std::size_t i = r.size(); i > 1; --i) std::swap(r[i - 1], r[random() % i]);
  return r;
}

}  // namespace

TEST_CASE("extremal pieces: boxes own every node once") {
  for (const kernel::Index count : {1U, 2U, 7U, 64U, 1000U}) {
    const kernel::GridSize size{9, 13, 5};
    const auto boxes = kernel::cut_grid(size, kernel::parts_of(size, count));
    std::vector<int> owners(9 * 13 * 5);
    for (const GridBox& b : boxes)
      for (auto z = b.low[2]; z < b.high[2]; ++z)
        for (auto y = b.low[1]; y < b.high[1]; ++y)
          for (auto x = b.low[0]; x < b.high[0]; ++x) ++owners[x + 9 * (y + 13 * z)];
    INFO(count);
    CHECK(boxes.size() <= count);
    CHECK(std::all_of(owners.begin(), owners.end(), [](int n) { return n == 1; }));
  }
}

TEST_CASE("extremal pieces: 1, 2, 7 and 64 blocks have the bytes of the whole") {
  for (const auto& [field, n] :
       {std::pair{&tests::moebius_sheet, 33U}, std::pair{&tests::junction_sheet, 24U}}) {
    const Volume volume = tests::sampled(field, n);
    Options options;
    options.min_value = 0.4;
    const Outcome whole = of_whole(volume, options);
    REQUIRE(whole.result.polygons() > 100);
    for (const kernel::Index count : {1U, 2U, 7U, 64U}) {
      INFO(n << " nodes, " << count << " blocks");
      check_same(whole,
                 of_pieces(volume, options,
                           kernel::cut_grid(volume.size, kernel::parts_of(volume.size, count))));
    }
  }
}

TEST_CASE("extremal pieces: shuffled owners have the bytes of the whole, whatever the options") {
  tests::Random random(20261130);
  Volume volume = tests::sampled(&tests::torus_sheet, 26);
  // Noise opens cells, bisects edges, splits sheets.
  for (float& x : std::get<std::vector<float>>(volume.samples))
    x += 0.4F * (static_cast<float>(random() % 1024) / 1023 - 0.5F);
  std::vector<Options> all(6);
  all[1].definition = extremal::Definition::hessian;
  all[1].critical = true;
  all[2].side = extremal::Side::valley;
  all[2].sigma = 1.7;
  all[3].tensor_sigma = 2.5;
  all[3].min_strength = 0.5;
  all[4].refine = 1;
  all[4].min_value = 0.3;
  all[5].critical = true;
  all[5].min_value = 0.25;
  all[5].min_strength = 1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Outcome whole = of_whole(volume, all[i]);
    REQUIRE(whole.result.polygons() > 0);
    for (const std::size_t count : {2U, 9U}) {
      INFO("options " << i << ", " << count << " boxes");
      check_same(whole, of_pieces(volume, all[i], random_boxes(volume.size, count, random)));
    }
  }
}

TEST_CASE("extremal pieces: curves of images, too") {
  Volume image = tests::sampled(&tests::moebius_sheet, 40);
  auto& samples = std::get<std::vector<float>>(image.samples);
  samples = std::vector<float>(samples.begin() + 40 * 40 * 20, samples.begin() + 40 * 40 * 21);
  image.size[2] = 1;
  const Outcome whole = of_whole(image, {});
  REQUIRE(whole.result.polygons() > 10);
  for (const kernel::Index count : {2U, 7U})
    check_same(whole, of_pieces(image, {},
                                kernel::cut_grid(image.size, kernel::parts_of(image.size, count))));
}

TEST_CASE("extremal pieces: slabs of a node, few nodes along an axis, spacings that differ") {
  tests::Random random(20261201);
  for (unsigned trial = 0; trial < 12 * tests::multiplier(); ++trial) {
    Volume volume;
    for (std::size_t k = 0; k < 3; ++k) {
      volume.size[k] = static_cast<kernel::Index>(4 + random() % 10);
      volume.spacing[k] = 0.5 * static_cast<double>(1 + random() % 3);
    }
    volume.size[random() % 3] += 20;  // more than both halos
    std::vector<float> samples(volume.size[0] * volume.size[1] * volume.size[2]);
    for (float& x : samples) x = static_cast<float>(random() % 256);
    volume.samples = std::move(samples);
    Options options;
    options.definition =
        trial % 2 == 0 ? extremal::Definition::structure : extremal::Definition::hessian;
    options.sigma = std::array{0.0, 0.7, 1.5}[random() % 3];
    options.refine = static_cast<int>(random() % 3 == 0 ? random() % 3 : 0);
    options.critical = random() % 2 == 0;
    if (random() % 2 == 0) options.min_value = 100;
    INFO("trial " << trial << ", " << volume.size[0] << " x " << volume.size[1] << " x "
                  << volume.size[2] << ", sigma " << options.sigma << ", refined "
                  << options.refine);
    const Outcome whole = of_whole(volume, options);
    check_same(whole, of_pieces(volume, options, random_boxes(volume.size, 6, random)));
    const std::size_t longest = static_cast<std::size_t>(
        std::max_element(volume.size.begin(), volume.size.end()) - volume.size.begin());
    kernel::GridSize parts{1, 1, 1};
    parts[longest] = volume.size[longest];  // a node each
    check_same(whole, of_pieces(volume, options, kernel::cut_grid(volume.size, parts)));
  }
}

TEST_CASE("extremal pieces: far more parts asked for than there are nodes") {
  CHECK(kernel::parts_of({3, 4, 5}, 1 << 20) == kernel::GridSize{3, 4, 5});
  const auto [x, y, z] = kernel::parts_of({24, 24, 24}, 13823);
  CHECK(x * y * z == 23 * 24 * 24);
  CHECK(kernel::parts_of({7, 1, 1}, 8) == kernel::GridSize{7, 1, 1});
}

TEST_CASE("extremal pieces: lengths in records ask for no more memory than there are bytes") {
  const std::size_t free = std::size_t{1} << 25;
  std::vector<std::uint8_t> bytes(free + 8);
  // As many runs of cells, of eight bytes, as bytes follow; and where the product wraps round.
  for (const std::uint64_t count : {std::uint64_t{free}, std::uint64_t{free} / 8 + 1,
                                    ~std::uint64_t{0} / 8 + 2, ~std::uint64_t{0}}) {
    std::memcpy(bytes.data(), &count, 8);
    const tests::MemoryLimit limit(free);
    INFO(count);
    CHECK_THROWS_AS(extremal::records_from(bytes), std::runtime_error);
  }
}
