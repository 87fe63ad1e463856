// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 8 on halved grids: coefficients made a block at a time are those of the whole grid, and
// what is checked with them; a small file does not take a large grid's memory.
#include <algorithm>
#include <array>
#include <utility>

#include "algorithms/extremal/extremal.hpp"
#include "certify/extremal/clusters.hpp"
#include "certify/extremal/trim.hpp"
#include "tests/certify_extremal/extremal_samples.hpp"
#include "tests/support/memory_limit.hpp"
#include "tests/support/random.hpp"

using namespace crest::certify;
using namespace crest::tests;
namespace ext = crest::certify::extremal;

namespace {

/// Bytes of a few values, so that coefficients differ everywhere.
ExtremalData noise(std::array<std::uint32_t, 3> nodes, unsigned halvings, Random& random) {
  ExtremalData data = make_data(nodes, {}, {1, 2, 1.5}, 0);
  data.type = 1;
  data.refine = static_cast<std::uint8_t>(halvings);
  data.samples.resize(std::size_t{nodes[0]} * nodes[1] * nodes[2]);
  for (auto& x : data.samples) x = static_cast<std::uint8_t>(random() >> 56);
  return data;
}

/// Does the window hold the whole grid's coefficients as far as its block's cells ask for them?
void compare_block(const ext::Splines& whole, const ext::Splines& parts, std::uint32_t block) {
  const ext::Grid& grid = whole.grid();
  const auto [low, high] = parts.corners(block);
  std::size_t differ = 0;
  whole.with_window(0, true, [&](const ext::Window& all) {
    parts.with_window(block, true, [&](const ext::Window& window) {
      ext::Place first{}, last{};
      for (unsigned k = 0; k < grid.dimension; ++k) {
        first[k] = std::max(low[k], 1U) - 1;
        last[k] = std::min(high[k] + 1, grid.nodes[k] - 1);
      }
      for (std::uint32_t z = first[2]; z <= last[2]; ++z)
        for (std::uint32_t y = first[1]; y <= last[1]; ++y)
          for (std::uint32_t x = first[0]; x <= last[0]; ++x) {
            const std::uint32_t node = x + grid.stride[1] * y + grid.stride[2] * z;
            const std::uint32_t own = window.node(grid, node);
            differ += window.fields->l[own] != all.fields->l[node];
            for (std::size_t i = 0; i < 6; ++i)
              if (!all.fields->t[i].empty())
                differ += window.fields->t[i][own] != all.fields->t[i][node];
          }
      CHECK(window.fields->spacing == all.fields->spacing);
      CHECK(window.fields->inverse_spacing == all.fields->inverse_spacing);
    });
  });
  CAPTURE(block);
  CHECK(differ == 0);
}

/// All that is checked with coefficients.
struct Found {
  std::vector<std::uint8_t> codes, edges;
  std::vector<bool> boxed;
  std::vector<std::uint32_t> critical;
  ext::Components components;
};
Found check(const ExtremalCertificate& c, const ext::Splines& splines) {
  const ext::Grid& grid = splines.grid();
  auto cells = ext::list_cells(c, grid);
  ext::check_cells(c, splines, cells);
  const auto edges = ext::check_edges(c, splines, cells);
  const ext::Squares squares(c, grid, cells, edges);
  const auto mesh = ext::build_mesh(grid, edges, squares);
  Found out;
  out.components = ext::count_components(mesh, ext::trim(c, splines, mesh));
  ext::find_isotopic(c, grid, cells, edges, squares, mesh, out.components);
  out.critical = edges.critical;
  for (std::uint32_t cell = 0; cell < grid.count; ++cell) {
    out.codes.push_back(cells.code(cell));
    out.boxed.push_back(cells.is_boxed(cell));
    for (unsigned axis = 0; axis < grid.dimension; ++axis)
      out.edges.push_back(edges.state[grid.edge(cell, axis)]);
  }
  return out;
}

ExtremalCertificate extracted(std::array<std::uint32_t, 3> size, int refine, bool hessian) {
  crest::extremal::Volume volume;
  volume.size = {size[0], size[1], size[2]};
  std::vector<double> samples;
  const auto at = [&](std::uint32_t i, std::size_t k) {
    return size[k] == 1 ? 0 : -1 + 2.0 * i / (size[k] - 1);
  };
  for (std::uint32_t z = 0; z < size[2]; ++z)
    for (std::uint32_t y = 0; y < size[1]; ++y)
      for (std::uint32_t x = 0; x < size[0]; ++x)
        samples.push_back(sphere(0.6, 0.25)(at(x, 0), at(y, 1), at(z, 2)));
  volume.samples = std::move(samples);
  crest::extremal::Options options;
  options.side = crest::extremal::Side::ridge;
  options.definition =
      hessian ? crest::extremal::Definition::hessian : crest::extremal::Definition::structure;
  options.min_value = 0.4;
  options.min_strength = hessian ? 0.05 : 0;
  options.refine = refine;
  ExtremalCertificate c;
  crest::extremal::extract(volume, options, &c);
  return c;
}

}  // namespace

TEST_CASE("extremal: coefficients made by blocks are the whole grid's") {
  Random random(kSeed);
  for (const unsigned halvings : {1U, 2U, 3U})
    for (const std::array<std::uint32_t, 3> nodes :
         {std::array{7U, 4U, 12U}, std::array{4U, 18U, 9U}, std::array{140U, 37U, 1U},
          std::array{4U, 65U, 1U}}) {
      const auto data = noise(nodes, halvings, random);
      const ext::Splines whole(data), parts(data, 0);
      REQUIRE(whole.is_whole());
      REQUIRE_FALSE(parts.is_whole());
      REQUIRE(parts.grid().count == whole.grid().count);
      for (std::uint32_t b = 0; b < parts.blocks(); ++b) compare_block(whole, parts, b);
    }
}

TEST_CASE("extremal: every cell of a halved grid is in one block, every node in one that has it") {
  Random random(kSeed);
  for (const std::array<std::uint32_t, 3> nodes :
       {std::array{5U, 9U, 12U}, std::array{70U, 33U, 1U}}) {
    const ext::Splines parts(noise(nodes, 3, random), 0);
    const ext::Grid& grid = parts.grid();
    std::vector<int> cells(grid.count, 0);
    for (std::uint32_t b = 0; b < parts.blocks(); ++b) {
      const auto [low, high] = parts.corners(b);
      for (std::uint32_t node = 0; node < grid.count; ++node) {
        const ext::Place p = grid.place(node);
        bool cell = grid.is_cell(node), within = true;
        for (unsigned k = 0; k < grid.dimension; ++k) {
          cell = cell && p[k] >= low[k] && p[k] < high[k];
          within = within && p[k] >= low[k] && p[k] <= high[k];
        }
        cells[node] += cell ? 1 : 0;
        if (parts.block_of(node) == b && !within) FAIL("node " << node << " is not in its block");
        if (cell && parts.block_of(node) != b) FAIL("cell " << node << " has another block");
      }
    }
    std::size_t wrong = 0;
    for (std::uint32_t node = 0; node < grid.count; ++node)
      wrong += cells[node] != (grid.is_cell(node) ? 1 : 0);
    CHECK(wrong == 0);
  }
}

TEST_CASE("extremal: what is checked by blocks is what is checked on the whole grid") {
  for (const bool hessian : {false, true})
    for (const auto& [size, refine] : {std::pair(std::array<std::uint32_t, 3>{20, 17, 18}, 1),
                                       std::pair(std::array<std::uint32_t, 3>{9, 9, 9}, 3),
                                       std::pair(std::array<std::uint32_t, 3>{80, 60, 1}, 3)}) {
      CAPTURE(hessian, size[0], refine);
      const auto c = extracted(size, refine, hessian);
      const ext::Splines whole(c.data), parts(c.data, 0);
      REQUIRE(whole.is_whole());
      REQUIRE(parts.blocks() > 1);
      const Found a = check(c, whole), b = check(c, parts);
      CHECK(a.critical.size() > 100);
      CHECK(a.codes == b.codes);
      CHECK(a.boxed == b.boxed);
      CHECK(a.edges == b.edges);
      CHECK(a.critical == b.critical);
      CHECK(a.components.list == b.components.list);
      CHECK(a.components.list == c.components);
      // A code that is too strong is refused by blocks, too.
      auto lie = c;
      const auto open = std::ranges::find(lie.codes, extremal_code::kCone);
      if (open == lie.codes.end()) continue;
      *open = extremal_code::kEmpty;
      auto cells = ext::list_cells(lie, parts.grid());
      CHECK_THROWS(ext::check_cells(lie, parts, cells));
    }
}

TEST_CASE("extremal: a certificate on a grid that is too large to be held is accepted") {
  const auto c = extracted({17, 17, 17}, 3, false);
  REQUIRE_FALSE(ext::Splines(c.data).is_whole());
  require_accepted(c);
  auto lie = c;
  ++lie.components[0].euler_characteristic;
  CHECK_FALSE(is_accepted(lie));
  lie = c;
  lie.data.min_value /= 2;  // cells that are not listed reach it
  CHECK_FALSE(is_accepted(lie));
}

TEST_CASE("extremal: a small file that halves its grid three times takes a small file's memory") {
  // 127^3 bytes; 2^30 nodes would take some 40 GB. A bright sample, so that some blocks are made.
  for (const std::array<std::uint32_t, 3> nodes :
       {std::array{127U, 127U, 127U}, std::array{4U, 800U, 800U}, std::array{4096U, 4096U, 1U}}) {
    ExtremalCertificate c;
    c.data = make_data(nodes, {}, {1, 1, 1}, 0);
    c.data.type = 1;
    c.data.refine = 3;
    c.data.samples.assign(std::size_t{nodes[0]} * nodes[1] * nodes[2], 0);
    c.data.samples[c.data.samples.size() / 2 + nodes[0] / 2] = 9;
    c.data = with_level(c.data, 8);
    const Bytes bytes = encode(c);
    c = {};
    // Samples as doubles, T and L, the page's own: 36 bytes a sample and what threads reserve.
    const MemoryLimit limit(40 * bytes.size() + (std::size_t{400} << 20));
    const auto verdict = verify(bytes);
    CAPTURE(nodes, verdict.reason);
    CHECK(verdict.accepted);
  }
}
