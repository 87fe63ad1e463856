// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/edges.hpp"

#include <atomic>
#include <memory>

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/extremal/incidence.hpp"
#include "certify/extremal/signs.hpp"

namespace crest::certify::extremal {
namespace {

namespace code = extremal_code;
using kernel::Rational;

constexpr unsigned kDepth = 14;  ///< of trees
/// Of the halving of an edge whose type is proven: next to lambda1 = lambda2 n turns quickly.
constexpr unsigned kTypeDepth = 28, kPieces = 4096;
/// Of all edges together, for each and for so many more: a file must not cost more than it weighs.
constexpr std::uint64_t kPiecesEach = 64, kMoreEdges = 4096;

/// A node's direction, as stored, and the sign of g there.
struct NodeSign {
  Vec n;
  double chord;
  std::int8_t sign;
};

int orientation(const NodeSign& node, const Vec& w) {
  return extremal::orientation(node.n, node.chord, w);
}

template <class Number>
std::array<Number, 6> first_controls(const std::array<std::array<Number, 4>, 6>& m) {
  return {m[0][0], m[1][0], m[2][0], m[3][0], m[4][0], m[5][0]};
}

NodeSign node_sign(const Fields& fields, u32 node) {
  const auto net = node_net<double>(fields, node);
  const Direction direction = direction_at(doubles<1>(net.t, net.t_size));
  const int sign = perturbed_sign(direction, doubles<1>(net.v, net.v_size), [&] {
    const auto exact = node_net<Rational>(fields, node);
    return ExactPoint{first_controls(exact.t), {exact.v[0][0], exact.v[1][0], exact.v[2][0]}};
  });
  return {direction.frame.w, direction.cone.chord, static_cast<std::int8_t>(sign)};
}

/// Signs at the nodes of edges that no empty cell decides.
class NodeSigns {
 public:
  NodeSigns(const Fields& fields, const ExtremalCertificate& c, const Cells& cells,
            const Edges& edges)
      : place_(fields.grid.count) {
    const Grid& grid = fields.grid;
    std::fill(place_.begin(), place_.end(), kNothing);
    std::vector<u32> nodes;
    const auto want = [&](u32 node) {
      if (place_[node] != kNothing) return;
      place_[node] = static_cast<u32>(nodes.size());
      nodes.push_back(node);
    };
    for (size_t i = 0; i < cells.ids.size(); ++i) {
      if (c.codes[i] == code::kOpen || c.codes[i] == code::kEmpty) continue;
      for_edges_of_cell(grid, cells.ids[i], [&](u32 edge, unsigned low, unsigned high) {
        if (edges.state[edge] != Edges::kUntested) return;
        want(corner_node(grid, cells.ids[i], low));
        want(corner_node(grid, cells.ids[i], high));
      });
    }
    for (const u32 edge : c.edges) {
      const auto [node, axis] = edge_place(grid, edge);
      want(node);
      want(node + grid.stride[axis]);
    }
    signs_.resize(nodes.size());
    constexpr size_t kBatch = 256;
    parallel_for((nodes.size() + kBatch - 1) / kBatch, [] { return 0; },
                 [&](int, size_t batch) {
                   const size_t end = std::min(nodes.size(), (batch + 1) * kBatch);
                   for (size_t i = batch * kBatch; i < end; ++i)
                     signs_[i] = node_sign(fields, nodes[i]);
                 });
  }
  const NodeSign& operator[](u32 node) const { return signs_[place_[node]]; }

 private:
  Buffer<u32> place_;
  std::vector<NodeSign> signs_;
};

/// Edges of cells that are not open.
void test_edges_of_cells(const ExtremalCertificate& c, const Fields& fields, const Cells& cells,
                         const NodeSigns& nodes, Edges& edges) {
  const Grid& grid = fields.grid;
  for (size_t i = 0; i < cells.ids.size(); ++i) {
    if (c.codes[i] == code::kOpen || c.codes[i] == code::kEmpty) continue;
    const Vec w = Frame(c.directions[cells.directions[i]]).w;
    std::array<int, 8> sign{};  // of g, n oriented by w; 0: not asked for
    const auto sign_at = [&](unsigned corner) {
      if (sign[corner] == 0) {
        const NodeSign& node = nodes[corner_node(grid, cells.ids[i], corner)];
        sign[corner] = node.sign * orientation(node, w);
      }
      return sign[corner];
    };
    for_edges_of_cell(grid, cells.ids[i], [&](u32 edge, unsigned low, unsigned high) {
      if (edges.state[edge] != Edges::kUntested) return;
      edges.state[edge] = sign_at(low) == sign_at(high) ? Edges::kPlain : Edges::kCritical;
    });
  }
}

/// Reads the trees of listed edges.
class TreeReader {
 public:
  TreeReader(const ExtremalCertificate& c, const Fields& fields) : c_(c), fields_(fields) {}

  /// How n at the low end, as stored, goes over into n at the high end: 1 or -1. Throws Reject.
  int transport(u32 edge, const NodeSign& low, const NodeSign& high) {
    const auto [node, axis] = edge_place(fields_.grid, edge);
    edge_ = edge;
    leaves_.clear();
    middles_.clear();
    read(edge_net<double>(fields_, node, axis), 0);
    int product = orientation(low, leaves_.front()) * orientation(high, leaves_.back());
    for (size_t i = 0; i < middles_.size(); ++i)
      product *= orientation(middles_[i], leaves_[i]) * orientation(middles_[i], leaves_[i + 1]);
    return product;
  }
  void require_end() const {
    require(node_ == c_.trees.size(), "trees: {} nodes, {} needed", c_.trees.size(), node_);
  }

 private:
  void read(const EdgeNet<double>& net, unsigned depth) {
    require(node_ < c_.trees.size(), "trees: they end early");
    if (c_.trees[node_++] == code::kLeaf) {
      const Frame frame(c_.leaves[leaf_++]);
      require(test_cone(doubles<4>(net.t, net.t_size), frame).holds, "edge {}: the cone test fails",
              edge_);
      leaves_.push_back(frame.w);
      return;
    }
    require(depth < kDepth, "edge {}: its tree is too deep", edge_);
    read(half(net, 0), depth + 1);
    const auto upper = half(net, 1);
    const Direction middle = direction_at(doubles<1>(upper.t, upper.t_size));
    middles_.push_back({middle.frame.w, middle.cone.chord, 0});
    read(upper, depth + 1);
  }

  const ExtremalCertificate& c_;
  const Fields& fields_;
  size_t node_ = 0, leaf_ = 0;
  u32 edge_ = 0;
  std::vector<Vec> leaves_;
  std::vector<NodeSign> middles_;  ///< without signs
};

void test_listed_edges(const ExtremalCertificate& c, const Fields& fields, const NodeSigns& nodes,
                       Edges& edges) {
  const Grid& grid = fields.grid;
  TreeReader trees(c, fields);
  for (const u32 edge : c.edges) {
    require(edges.state[edge] == Edges::kUntested, "edge {}: listed, but a cell tests it", edge);
    const auto [node, axis] = edge_place(grid, edge);
    const NodeSign &low = nodes[node], &high = nodes[node + grid.stride[axis]];
    const int product = low.sign * high.sign * trees.transport(edge, low, high);
    edges.state[edge] = product > 0 ? Edges::kPlain : Edges::kCritical;
  }
  trees.require_end();
}

/// Proves that s_nn has one sign where g is zero.
class TypeProver {
 public:
  explicit TypeProver(int sign) : sign_(sign) {}
  bool prove(const EdgeNet<double>& net, unsigned depth) {
    if (--left_ == 0) return false;
    const auto t = doubles<4>(net.t, net.t_size);
    std::array<double, 6> mean;
    for (size_t i = 0; i < 6; ++i)
      mean[i] = (t.at[i][0] + 3 * t.at[i][1] + 3 * t.at[i][2] + t.at[i][3]) / 8;
    const Frame frame(likely_direction(mean));
    const Cone cone = test_cone(t, frame);
    if (cone.holds && (sign_on(cone, frame, doubles<4>(net.v, net.v_size)) != 0 ||
                       curvature_on(cone, frame, doubles<4>(net.h, net.h_size)) == sign_))
      return true;
    return depth < kTypeDepth && prove(half(net, 0), depth + 1) && prove(half(net, 1), depth + 1);
  }

  unsigned pieces() const { return kPieces - left_; }

 private:
  int sign_;
  unsigned left_ = kPieces;
};

/// Returns how many pieces that took.
unsigned check_type(const Fields& fields, const Cells& cells, u32 edge, std::uint8_t type) {
  if (type == code::kUndecidedType) return 0;
  const Grid& grid = fields.grid;
  const bool extremal = type == code::kExtremalEdge;
  if (is_inside(grid, edge))
    for (const u32 cell : cells_round(grid, edge))
      if (cell != kNothing && cells.code[cell] == code::kRegularExtremal) {
        require(extremal, "edge {}: stated as merely critical, but s_nn > 0", edge);
        return 0;
      }
  const auto [node, axis] = edge_place(grid, edge);
  TypeProver prover(extremal ? 1 : -1);
  require(prover.prove(edge_net<double>(fields, node, axis), 0), "edge {}: its type is not proven",
          edge);
  return prover.pieces();
}

void check_types(const ExtremalCertificate& c, const Fields& fields, const Cells& cells,
                 Edges& edges) {
  for (u32 edge = 0; edge < edges.state.size(); ++edge)
    if (edges.is_critical(edge)) edges.critical.push_back(edge);
  require_equal(static_cast<std::int64_t>(c.types.size()), edges.critical.size(), "critical edges");
  constexpr size_t kBatch = 64;
  std::atomic<std::uint64_t> pieces{0};
  parallel_for((c.types.size() + kBatch - 1) / kBatch, [] { return 0; },
               [&](int, size_t batch) {
                 const size_t end = std::min(c.types.size(), (batch + 1) * kBatch);
                 for (size_t i = batch * kBatch; i < end; ++i)
                   pieces += check_type(fields, cells, edges.critical[i], c.types[i]);
                 require(pieces <= kPiecesEach * (c.types.size() + kMoreEdges),
                         "types: they take too many pieces of edges");
               });
  for (size_t i = 0; i < c.types.size(); ++i)
    edges.state[edges.critical[i]] = static_cast<std::uint8_t>(Edges::kCritical + c.types[i]);
}

}  // namespace

Edges check_edges(const ExtremalCertificate& c, const Fields& fields, const Cells& cells) {
  const Grid& grid = fields.grid;
  Edges edges;
  edges.state.resize(size_t{grid.dimension} * grid.count);
  std::fill(edges.state.begin(), edges.state.end(), Edges::kUntested);
  for (size_t i = 0; i < c.edges.size(); ++i)
    require(is_edge(grid, c.edges[i]) && (i == 0 || c.edges[i - 1] < c.edges[i]),
            "edges: {} is none, or not in order", c.edges[i]);
  for (size_t i = 0; i < cells.ids.size(); ++i)
    if (c.codes[i] == code::kEmpty)
      for_edges_of_cell(grid, cells.ids[i],
                        [&](u32 edge, unsigned, unsigned) { edges.state[edge] = Edges::kPlain; });
  const NodeSigns nodes(fields, c, cells, edges);
  test_edges_of_cells(c, fields, cells, nodes, edges);
  test_listed_edges(c, fields, nodes, edges);
  check_types(c, fields, cells, edges);
  return edges;
}

}  // namespace crest::certify::extremal
