// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/edges.hpp"

#include <atomic>
#include <memory>

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
  NodeSigns(const Splines& splines, const ExtremalCertificate& c, const Cells& cells,
            const Edges& edges)
      : place_(splines.grid().count, kNothing) {
    const Grid& grid = splines.grid();
    std::vector<u32> nodes;
    const auto want = [&](u32 node) {
      u32& place = place_.at(node);
      if (place != kNothing) return;
      place = static_cast<u32>(nodes.size());
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
    splines.for_items(
        nodes.size(), 256, [&](size_t i) { return nodes[i]; }, [](const Fields&) { return 0; },
        [&](int, const Window& window, size_t i) {
          signs_[i] = node_sign(*window.fields, window.node(grid, nodes[i]));
        });
  }
  const NodeSign& operator[](u32 node) const { return signs_[place_[node]]; }

 private:
  Sparse<u32> place_;
  std::vector<NodeSign> signs_;
};

/// Edges of cells that are not open.
void test_edges_of_cells(const ExtremalCertificate& c, const Grid& grid, const Cells& cells,
                         const NodeSigns& nodes, Edges& edges) {
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
      std::uint8_t& state = edges.state.at(edge);
      if (state == Edges::kUntested)
        state = sign_at(low) == sign_at(high) ? Edges::kPlain : Edges::kCritical;
    });
  }
}

/// Where the tree of every listed edge starts, and its leaves: one more than there are edges.
struct TreeStarts {
  std::vector<u32> nodes, leaves;
};
TreeStarts find_trees(const ExtremalCertificate& c) {
  TreeStarts starts;
  u32 node = 0, leaf = 0;
  const auto start = [&] {
    starts.nodes.push_back(node);
    starts.leaves.push_back(leaf);
  };
  for (size_t i = 0; i < c.edges.size(); ++i) {
    start();
    for (std::uint64_t missing = 1; missing > 0;) {
      require(node < c.trees.size(), "trees: they end early");
      const bool split = c.trees[node++] == code::kSplit;
      missing = split ? missing + 1 : missing - 1;
      leaf += split ? 0 : 1;
    }
  }
  start();
  require(node == c.trees.size(), "trees: {} nodes, {} needed", c.trees.size(), node);
  return starts;
}

/// Reads the trees of listed edges.
class TreeReader {
 public:
  TreeReader(const ExtremalCertificate& c, const TreeStarts& starts) : c_(c), starts_(starts) {}

  /// How n at the low end of the i-th edge, as stored, goes over into n at the high end: 1 or -1.
  /// Throws Reject.
  int transport(size_t i, const EdgeNet<double>& net, const NodeSign& low, const NodeSign& high) {
    edge_ = c_.edges[i];
    node_ = starts_.nodes[i];
    leaf_ = starts_.leaves[i];
    leaves_.clear();
    middles_.clear();
    read(net, 0);
    int product = orientation(low, leaves_.front()) * orientation(high, leaves_.back());
    for (size_t k = 0; k < middles_.size(); ++k)
      product *= orientation(middles_[k], leaves_[k]) * orientation(middles_[k], leaves_[k + 1]);
    return product;
  }

 private:
  void read(const EdgeNet<double>& net, unsigned depth) {
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
  const TreeStarts& starts_;
  size_t node_ = 0, leaf_ = 0;
  u32 edge_ = 0;
  std::vector<Vec> leaves_;
  std::vector<NodeSign> middles_;  ///< without signs
};

void test_listed_edges(const ExtremalCertificate& c, const Splines& splines, const NodeSigns& nodes,
                       Edges& edges) {
  const Grid& grid = splines.grid();
  for (const u32 edge : c.edges)
    require(edges.state[edge] == Edges::kUntested, "edge {}: listed, but a cell tests it", edge);
  const TreeStarts starts = find_trees(c);
  std::vector<std::int8_t> products(c.edges.size());
  splines.for_items(
      c.edges.size(), 64, [&](size_t i) { return edge_place(grid, c.edges[i]).node; },
      [&](const Fields&) { return TreeReader(c, starts); },
      [&](TreeReader& reader, const Window& window, size_t i) {
        const auto [node, axis] = edge_place(grid, c.edges[i]);
        const NodeSign &low = nodes[node], &high = nodes[node + grid.stride[axis]];
        const auto net = edge_net<double>(*window.fields, window.node(grid, node), axis);
        products[i] =
            static_cast<std::int8_t>(low.sign * high.sign * reader.transport(i, net, low, high));
      });
  for (size_t i = 0; i < c.edges.size(); ++i)
    edges.state.at(c.edges[i]) = products[i] > 0 ? Edges::kPlain : Edges::kCritical;
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

/// Is its type proven by a cell? Throws Reject if a cell refutes it.
bool is_type_of_cell(const Grid& grid, const Cells& cells, u32 edge, std::uint8_t type) {
  if (!is_inside(grid, edge)) return false;
  for (const u32 cell : cells_round(grid, edge))
    if (cell != kNothing && cells.code(cell) == code::kRegularExtremal) {
      require(type == code::kExtremalEdge, "edge {}: stated as merely critical, but s_nn > 0",
              edge);
      return true;
    }
  return false;
}

void check_types(const ExtremalCertificate& c, const Splines& splines, const Cells& cells,
                 Edges& edges) {
  const Grid& grid = splines.grid();
  edges.state.for_each([&](size_t edge, std::uint8_t state) {
    if (state >= Edges::kCritical) edges.critical.push_back(static_cast<u32>(edge));
  });
  require_equal(static_cast<std::int64_t>(c.types.size()), edges.critical.size(), "critical edges");
  std::vector<u32> asked;
  for (u32 i = 0; i < c.types.size(); ++i)
    if (c.types[i] != code::kUndecidedType &&
        !is_type_of_cell(grid, cells, edges.critical[i], c.types[i]))
      asked.push_back(i);
  std::atomic<std::uint64_t> pieces{0};
  splines.for_items(
      asked.size(), 64, [&](size_t i) { return edge_place(grid, edges.critical[asked[i]]).node; },
      [](const Fields&) { return 0; },
      [&](int, const Window& window, size_t i) {
        const u32 edge = edges.critical[asked[i]];
        const auto [node, axis] = edge_place(grid, edge);
        TypeProver prover(c.types[asked[i]] == code::kExtremalEdge ? 1 : -1);
        require(prover.prove(edge_net<double>(*window.fields, window.node(grid, node), axis), 0),
                "edge {}: its type is not proven", edge);
        require((pieces += prover.pieces()) <= kPiecesEach * (c.types.size() + kMoreEdges),
                "types: they take too many pieces of edges");
      });
  for (size_t i = 0; i < c.types.size(); ++i)
    edges.state.at(edges.critical[i]) = static_cast<std::uint8_t>(Edges::kCritical + c.types[i]);
}

}  // namespace

Edges check_edges(const ExtremalCertificate& c, const Splines& splines, const Cells& cells) {
  const Grid& grid = splines.grid();
  Edges edges(grid);
  for (size_t i = 0; i < c.edges.size(); ++i)
    require(is_edge(grid, c.edges[i]) && (i == 0 || c.edges[i - 1] < c.edges[i]),
            "edges: {} is none, or not in order", c.edges[i]);
  for (size_t i = 0; i < cells.ids.size(); ++i)
    if (c.codes[i] == code::kEmpty)
      for_edges_of_cell(grid, cells.ids[i], [&](u32 edge, unsigned, unsigned) {
        edges.state.at(edge) = Edges::kPlain;
      });
  const NodeSigns nodes(splines, c, cells, edges);
  test_edges_of_cells(c, grid, cells, nodes, edges);
  test_listed_edges(c, splines, nodes, edges);
  check_types(c, splines, cells, edges);
  return edges;
}

}  // namespace crest::certify::extremal
