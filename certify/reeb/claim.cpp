// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 3, reeb: the Reeb graph of a function linear or quadratic on every face (SPEC.md). No mesh
// file that the checker reads holds the values: `--input` is refused.
#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/reeb/checks.hpp"

namespace crest::certify {
namespace {

/// Steps 1 and 2.
reeb::SurfaceFacts prove_surface(const ReebContents& c, const Gluing& mesh, Verdict& verdict) {
  const bool quadratic = !c.edge_values.empty();
  const auto facts = reeb::check_surface(c.faces, mesh, c.vertices);
  require(!quadratic || c.edge_values.size() == mesh.edge_count,
          "data: {} midpoint values for {} edges", c.edge_values.size(), mesh.edge_count);
  prove(verdict, "data: a surface of {} vertices, {} faces, a {} function; digests match",
        c.vertices, c.faces.size(), quadratic ? "quadratic" : "linear");
  require_equal(c.euler_characteristic, facts.euler_characteristic, "Euler characteristic");
  require_equal(c.boundary_loops, facts.boundary_loops, "boundary loops");
  require_equal(c.components, facts.components, "components");
  prove(verdict, "topology: Euler characteristic {}, {} boundary loops, {} components{}",
        facts.euler_characteristic, facts.boundary_loops, facts.components,
        facts.orientable ? "" : ", not orientable");
  return facts;
}

/// Step 3. With degree 1 the tiles are the faces: nothing is built.
reeb::Tiling prove_tiles(const ReebContents& c, const Gluing& mesh, SignLadder& sign,
                         Verdict& verdict) {
  reeb::Tiling tiling;
  if (!c.edge_values.empty()) tiling = reeb::tessellate(c, mesh, sign);
  require_equal(c.line_critical, tiling.line_edges.size(), "line-critical nodes");
  require_equal(c.face_critical, tiling.critical_faces.size(), "face-critical nodes");
  const std::size_t tiles = c.edge_values.empty() ? c.faces.size() : tiling.tiles.size();
  require_equal(c.tiles, tiles, "tiles");
  prove(verdict, "tiles: {}, with {} line-critical and {} face-critical nodes", tiles,
        c.line_critical, c.face_critical);
  return tiling;
}

/// The first Betti number of the graph.
std::int64_t loops_of(const ReebContents& c) {
  return std::int64_t{c.components} + static_cast<std::int64_t>(c.arcs.size()) -
         static_cast<std::int64_t>(c.critical_nodes.size());
}

void prove_graph(const ReebContents& c, const reeb::SurfaceFacts& facts, bool simple,
                 const reeb::Contraction& ties, Verdict& verdict) {
  require_equal(c.tied_arcs, ties.tied_arcs, "arcs that join equal values");
  require_equal(c.contracted_nodes, ties.nodes, "nodes of the contracted graph");
  std::string beside;
  if (facts.boundary_loops == 0 && facts.orientable) {
    const std::int64_t genus = facts.components - facts.euler_characteristic / 2;
    // Theorem 7 says so for any data: a difference would be an error of the checker.
    if (simple && genus != loops_of(c))
      throw std::logic_error("loops and genus contradict theorem 7");
    beside = fmt::format(", genus {}", genus);
  }
  prove(verdict,
        "graph: {} nodes, {} arcs, {} loops{}: the Reeb graph of the values ordered by number at "
        "ties; {} arcs join equal values; contracted: {} nodes, {} arcs{}",
        c.critical_nodes.size(), c.arcs.size(), loops_of(c), beside, ties.tied_arcs, ties.nodes,
        c.arcs.size() - ties.tied_arcs,
        ties.passed == 0 ? ""
                         : fmt::format(", {} nodes with one arc below and one above", ties.passed));
}

/// Cost: near-linear in faces and crossed edges of the cuts; 0.3 microseconds a linear face, 1 when
/// half of the nodes are critical.
void verify_reeb(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                 const VerifyOptions& options, Verdict& verdict) {
  const ReebContents c = open_reeb(data, claims);
  if (options.input)
    throw TieUnavailable(options.input->name +
                         ": --input cannot compare the values of a Reeb graph's function; compare "
                         "the data digest with the one in the output");
  SignLadder sign(options.arithmetic);
  const bool quadratic = !c.edge_values.empty();
  const Gluing mesh = glue(c.faces, c.vertices, quadratic);
  const auto facts = prove_surface(c, mesh, verdict);
  const reeb::Tiling tiling = prove_tiles(c, mesh, sign, verdict);

  SignCounts comparisons;
  const reeb::NodeOrder order = reeb::check_order(c, mesh, tiling, options.arithmetic, comparisons);
  prove(verdict, "order: {} nodes ascend", order.rank.size());
  verdict.signs = sign.counts();
  verdict.signs.calls += comparisons.calls;
  verdict.signs.interval += comparisons.interval;
  verdict.signs.exact += comparisons.exact;

  const reeb::Complex k{c.faces, mesh, facts, tiling, order.rank};
  const reeb::NodeTypes types = reeb::check_types(c, k);
  prove(verdict,
        "nodes: {} minima, {} saddles with multiplicity, {} maxima; indices sum to the Euler "
        "characteristic",
        types.minima, types.saddles, types.maxima);
  const reeb::Cuts cuts = reeb::check_cuts(c, k);
  prove(verdict, "cuts: {} contours across {} edges, none twice", c.cuts.size(),
        cuts.crossings.size());
  reeb::check_trees(c, k, types, cuts);
  prove_graph(c, facts, types.simple, reeb::count_ties(c, order), verdict);
}

}  // namespace

extern const ClaimChecker reeb_claim;
const ClaimChecker reeb_claim = {kReeb, kReebVersion, "reeb", verify_reeb};

}  // namespace crest::certify
