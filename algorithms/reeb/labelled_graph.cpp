// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/labelled_graph.hpp"

#include "algorithms/reeb/arc_labels.hpp"
#include "algorithms/reeb/certificate.hpp"
#include "algorithms/reeb/contraction.hpp"
#include "algorithms/reeb/segmentation.hpp"
#include "algorithms/reeb/simplify.hpp"

namespace crest::reeb {

void label(const TileComplex& tiles, bool segmentation, LabelledGraph& labelled) {
  const OrderedComplex complex = ordered(tiles);
  if (!segmentation) {
    labelled.arc_of_node = reeb_graph_and_arcs(complex).arc_of_vertex;
    return;
  }
  Segmentation parts = reeb::segmentation(complex, labelled.graph);
  labelled.arc_of_node = std::move(parts.arc_of_vertex);
  for (const TriangleArcs& arcs : parts.triangles) labelled.arc_of_tile.push_back(arcs.middle);
}

Simplified simplify(const TileComplex& tiles, std::span<const double> values,
                    const Simplification& wanted, LabelledGraph& labelled) {
  const auto replace = [&](const auto& next) {
    const bool lost = next.graph.arcs.size() < labelled.graph.arcs.size();
    labelled = {next.graph,
                labelled.arc_of_node.empty()
                    ? std::vector<Index>()
                    : relabel_vertices(labelled.arc_of_node, labelled.graph, next),
                relabel_arcs(labelled.arc_of_tile, next.arc_of_arc)};
    return lost;
  };
  Simplified done;
  if (wanted.contract) done.contract = replace(contract(labelled.graph, tiles.rank, tiles.tied));
  if (wanted.persistence) {
    const auto loops = labelled.graph.loops();
    done.persistence =
        replace(simplify(labelled.graph, values, *wanted.persistence, wanted.cancel_loops));
    done.cancel_loops = labelled.graph.loops() < loops;
  }
  return done;
}

}  // namespace crest::reeb
