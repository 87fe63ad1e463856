// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which arc things belong to after a graph was contracted or simplified.
#include "algorithms/reeb/contraction.hpp"
#include "algorithms/reeb/simplify.hpp"

namespace crest::reeb {

/// Labels of the vertices of a complex (reeb_graph_and_arcs) for the graph `before`, and then for
/// the graph made of it. Vertices that contracting put into a node have kNone there, like the
/// nodes.
std::vector<Index> relabel_vertices(const std::vector<Index>& arc_of_vertex,
                                    const ReebGraph& before, const ContractedGraph& after);
std::vector<Index> relabel_vertices(const std::vector<Index>& arc_of_vertex,
                                    const ReebGraph& before, const CoarserGraph& after);

/// The same for things that each belong to one arc.
std::vector<Index> relabel_arcs(const std::vector<Index>& arc_of_thing,
                                const std::vector<Index>& arc_of_arc);

}  // namespace crest::reeb
