// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 8, extremal: extremal surfaces of volumes, extremal curves of images (SPEC.md).
#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/extremal/clusters.hpp"
#include "certify/extremal/decode.hpp"
#include "certify/extremal/trim.hpp"

namespace crest::certify {
namespace {

using namespace extremal;

std::string in_words(const ExtremalValences& v) {
  return fmt::format("valence 1: {} + {} + {} + {} + {}, 2: {}, 3: {}", v.one[0], v.one[1],
                     v.one[2], v.one[3], v.one[4], v.two, v.three);
}
std::string in_words(const ExtremalComponent& component, bool image) {
  return fmt::format("{} {}, Euler characteristic {}, {} {}{}{}{}", component.polygons,
                     image ? "segments" : "polygons", component.euler_characteristic,
                     component.loops, image ? "ends" : "boundary loops",
                     component.orientable ? "" : ", not orientable", component.cut ? ", cut" : "",
                     component.extremal   ? ", isotopic to a component of the extremal set"
                     : component.isotopic ? ", isotopic to a component of {g = 0}"
                                          : "");
}

void require_components(const ExtremalCertificate& c, const Components& found) {
  require(c.valences == found.valences, "edges of the mesh: {} stated, {} found",
          in_words(c.valences), in_words(found.valences));
  require_equal(static_cast<std::int64_t>(c.components.size()), found.list.size(), "components");
  const bool image = c.data.dimension == 2;
  for (size_t i = 0; i < c.components.size(); ++i)
    require(c.components[i] == found.list[i], "component {}: {} stated, {} found", i,
            in_words(c.components[i], image), in_words(found.list[i], image));
}

void say_cells(const ExtremalCertificate& c, Verdict& verdict) {
  std::array<size_t, 5> count{};
  for (const auto code : c.codes) ++count[code];
  prove(
      verdict,
      "cells: {} empty, {} regular ({} with s_nn > 0), {} with one orientation of n; {} open; L is "
      "below the least value on all others",
      count[2], count[3] + count[4], count[4], count[1], count[0]);
}

void say_components(const ExtremalCertificate& c, Verdict& verdict) {
  std::int64_t characteristic = 0, loops = 0, isotopic = 0, extremal = 0, one_sided = 0;
  for (const ExtremalComponent& component : c.components) {
    characteristic += component.euler_characteristic;
    loops += component.loops;
    isotopic += component.isotopic;
    extremal += component.extremal;
    one_sided += !component.orientable;
  }
  prove(verdict, "mesh: {} components, Euler characteristic {}, {} {}, {} not orientable; {}",
        c.components.size(), characteristic, loops,
        c.data.dimension == 2 ? "ends" : "boundary loops", one_sided, in_words(c.valences));
  if (isotopic > 0)
    prove(verdict,
          "{} of them are isotopic to components of {{g = 0}}, {} of these to components of the "
          "extremal set",
          isotopic, extremal);
}

/// Cost: linear; some microseconds a cell.
void verify_extremal(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                     const VerifyOptions& options, Verdict& verdict) {
  ExtremalCertificate c = decode_extremal(data, claims);
  if (options.input)
    throw TieUnavailable(options.input->name +
                         ": --input cannot compare samples; compare the data digest with the one "
                         "in the output");
  check_weights(c.data);
  const Splines splines(c.data);
  c.data.samples = {};  // What follows is about the coefficients.
  const Grid& grid = splines.grid();
  prove(verdict, "data: {} x {} x {} samples, sigma {}; digests match", grid.nodes[0],
        grid.nodes[1], grid.nodes[2], c.data.sigma);
  Cells cells = list_cells(c, grid);
  check_cells(c, splines, cells);
  say_cells(c, verdict);
  c.gradients = {};  // What is proven is thrown away: the longest lists of the certificate.
  cells.gradients = {};
  const Edges edges = check_edges(c, splines, cells);
  c.directions = {};
  cells.directions = {};
  cells.ids = {};
  const Squares squares(c, grid, cells, edges);
  prove(verdict, "edges: g changes its sign on {}; {} faces round which n is not orientable",
        edges.critical.size(), c.odd_faces);
  const Mesh mesh = build_mesh(grid, edges, squares);
  Components found = count_components(mesh, trim(c, splines, mesh));
  find_isotopic(c, grid, cells, edges, squares, mesh, found);
  require_components(c, found);
  say_components(c, verdict);
}

}  // namespace

extern const ClaimChecker extremal_claim;
const ClaimChecker extremal_claim = {kExtremal, kExtremalVersion, "extremal", verify_extremal};

}  // namespace crest::certify
