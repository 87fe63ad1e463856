// SPDX-License-Identifier: GPL-3.0-or-later
// Strip trees: the paper's figures, nodes and splits on real meshes, every triangle once, other
// ways to decode.
#include <catch2/catch.hpp>
#include <map>

#include "algorithms/coding/surface.hpp"
#include "algorithms/coding/thesis_codes.hpp"
#include "kernel/geometry/disjoint_sets.hpp"
#include "tests/coding/shared_meshes.hpp"

namespace crest::tests {
namespace {

using namespace coding;
using kernel::StripExits;
using kernel::StripTree;

std::vector<TreeNode> nodes_of(const std::string& words) {
  std::vector<TreeNode> nodes;
  Index length = 0;
  for (const char c : words) {
    if (c >= '0' && c <= '9') {
      length = 10 * length + static_cast<Index>(c - '0');
      continue;
    }
    nodes.push_back({static_cast<NodeType>(std::string("ELRS").find(c)), length});
    length = 0;
  }
  return nodes;
}

PlainMesh mesh_of(const std::vector<TreeNode>& postorder) {
  ReverseMesh mesh(kNone);
  for (const TreeNode& node : postorder) add_node(mesh, node);
  CHECK(mesh.depth() == 1);
  PlainMesh result;
  Index vertices = 0;
  result.faces = mesh.take_faces(vertices);
  result.points.resize(vertices);
  return result;
}

/// The tree of the mesh from the gate that its code ends at: the last face's first side.
StripTree tree_again(const PlainMesh& mesh, StripExits exits = StripExits::zigzag) {
  const kernel::CornerTable table(mesh.vertices(), mesh.faces);
  const std::vector<Index> gate = {3 * static_cast<Index>(mesh.faces.size() - 1)};
  return kernel::grow_strips(table, mesh.faces, exits, gate);
}

TEST_CASE("figures 4.3 and 4.7: 2,1,1,0,0,0,1,0,0 and 1E,1L,1E,2S are one disk") {
  const auto postorder = nodes_of("1E1L1E2S");
  const PlainMesh mesh = mesh_of(postorder);
  CHECK(mesh.points.size() == 6);
  CHECK(mesh.faces.size() == 5);
  const Surface surface(6, mesh.faces);
  Index sides = 0;
  for (Index h = 0; h < 15; ++h) sides += surface.twin(h) == kNone ? 1 : 0;
  CHECK(sides == 5);
  const auto preorder = in_preorder(tree_again(mesh));
  CHECK(with_zeros(preorder) == std::vector<Index>{2, 1, 1, 0, 0, 0, 1, 0, 0});
  CHECK(to_postorder(preorder) == postorder);
  CHECK(from_zeros({2, 1, 1, 0, 0, 0, 1, 0, 0}) == preorder);
}

TEST_CASE("figure 4.8: above a leaf a right child leaves lengths 1 and 2, a left one only 1") {
  CHECK(legal_lengths(NodeType::right, 2 * 1 + 1 - 1) == std::vector<Index>{1, 2});
  CHECK(legal_lengths(NodeType::left, 2 * 1 + 1 - 1) == std::vector<Index>{1});
  CHECK(places_in_legal_sets(nodes_of("1E2R")) == std::vector<Index>{0, 1});
  CHECK(legal_set_sizes(nodes_of("1E2R")) == std::vector<std::size_t>{1, 2});
  CHECK_THROWS(places_in_legal_sets(nodes_of("1E3L")));
}

/// Algorithm 4.2: strips of their own first, glued to their children's afterwards, both leading
/// edges first. Slow and plain: edges are glued as pairs, vertices found from them at the end.
class TopDown {
 public:
  explicit TopDown(const std::vector<Index>& code) : code_(code) {}

  PlainMesh run() {
    decode();
    PlainMesh mesh;
    kernel::DisjointSets corners(static_cast<Index>(twin_.size()));
    for (const auto& [h, g] : twin_) {
      if (g == kNone) continue;
      corners.unite(h, kernel::next_half(g));
      corners.unite(kernel::next_half(h), g);
    }
    std::map<Index, Index> number;
    for (Index f = 0; 3 * f < twin_.size(); ++f) {
      Triangle face;
      for (Index k = 0; k < 3; ++k)
        face[k] = number.emplace(corners.find(3 * f + k), static_cast<Index>(number.size()))
                      .first->second;
      mesh.faces.push_back(face);
    }
    mesh.points.resize(number.size());
    return mesh;
  }

 private:
  /// Returns the gate of the submesh, or kNone.
  Index decode() {
    const Index length = code_.at(at_++);
    if (length == 0) return kNone;
    const auto gate = static_cast<Index>(twin_.size()), entered = gate + 3 * (length - 1);
    for (Index h = gate; h < entered + 3; ++h) twin_[h] = kNone;
    for (Index k = 1; k < length; ++k) {
      const Index h = gate + 3 * (k - 1);
      glue(k % 2 == 1 ? h + 1 : h + 2, h + 3);
    }
    const Index left = decode(), right = decode();
    if (left != kNone) glue(entered + 1, left);
    if (right != kNone) glue(entered + 2, right);
    // From the end to the gate every edge that the strip has passed meets its neighbour.
    for (Index k = length - 1; k > 0; --k) {
      const Index f = gate + 3 * (k - 1), other = k % 2 == 1 ? f + 2 : f + 1;
      glue(other, k % 2 == 1 ? before(f + 1) : after(f + 2));
    }
    return gate;
  }
  void glue(Index h, Index g) {
    twin_[h] = g;
    twin_[g] = h;
  }
  /// The boundary half-edge that ends where h's twin starts, or starts where it ends.
  Index before(Index h) { return walk(twin_[h], false); }
  Index after(Index h) { return walk(twin_[h], true); }
  Index walk(Index h, bool forward) {
    for (;;) {
      h = forward ? kernel::next_half(h) : kernel::previous_half(h);
      if (twin_[h] == kNone) return h;
      h = twin_[h];
    }
  }

  const std::vector<Index>& code_;
  std::size_t at_ = 0;
  std::map<Index, Index> twin_;
};

TEST_CASE("algorithm 4.2, recursive, decodes what algorithm 4.3 does") {
  Random random(kSeed);
  for (int i = 0; i < 60; ++i) {
    PlainMesh mesh = stacked_sphere(8 + i, random);
    flip_edges(mesh, 10 * mesh.faces.size(), random);
    mesh.faces.pop_back();  // a disk
    const kernel::CornerTable table(mesh.vertices(), mesh.faces);
    const auto preorder = in_preorder(kernel::grow_strips(table, mesh.faces, StripExits::zigzag));
    const PlainMesh first = TopDown(with_zeros(preorder)).run();
    const PlainMesh second = mesh_of(to_postorder(preorder));
    REQUIRE(first.points.size() == mesh.points.size());
    // Both have the root's gate at hand: the same code again means the same mesh.
    const kernel::CornerTable again(first.vertices(), first.faces);
    const std::vector<Index> gate = {0};
    CHECK(in_preorder(kernel::grow_strips(again, first.faces, StripExits::zigzag, gate)) ==
          preorder);
    CHECK(in_preorder(tree_again(second)) == preorder);
  }
}

TEST_CASE("real meshes: n = v - 2 + 2 s nodes, s = 2 g + h - 1 splits, every triangle once") {
  for (const std::string& name : kSharedMeshes) {
    const auto path = shared_data("meshes/" + name);
    if (!path) return;
    INFO(name);
    const PlainMesh mesh = read_plain(*path);
    const Surface surface(mesh.vertices(), mesh.faces);
    for (const StripExits exits : {StripExits::zigzag, StripExits::fan}) {
      const StripTree tree = kernel::grow_strips(surface.table(), mesh.faces, exits);
      std::int64_t splits = 0, open = 0;
      for (const auto& node : tree.nodes) splits += node.split != kNone ? 1 : 0;
      for (const Index h : tree.removed) open += h == kNone ? 1 : 0;
      const Counts& c = surface.counts();
      CHECK(splits == 2 * std::int64_t{c.handles} + c.loops - open);
      CHECK(static_cast<std::int64_t>(tree.nodes.size()) ==
            std::int64_t{c.vertices} - 2 * std::int64_t{c.components} + 2 * splits);
      std::vector<int> seen(mesh.faces.size(), 0);
      for (const Index h : tree.entered) ++seen[h / 3];
      for (const Index h : tree.removed)
        if (h != kNone) ++seen[h / 3];
      CHECK(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
      CHECK(kernel::postorder(tree).size() == tree.nodes.size());
    }
  }
}

/// Rossignac's Edgebreaker with C, L, E, R, S: the tip is new, or which side is used up.
std::string edgebreaker(const kernel::CornerTable& table, const std::vector<Triangle>& faces,
                        Index gate) {
  std::vector<bool> met(table.vertex_count(), false), done(faces.size(), false);
  const auto from = [&](Index h) { return faces[h / 3][h % 3]; };
  for (Index h = 0; h < 3 * faces.size(); ++h)
    if (table.opposite(h) == kNone) met[from(h)] = true;
  std::string letters;
  std::vector<Index> stack{gate};
  while (!stack.empty()) {
    Index h = stack.back();
    stack.pop_back();
    for (;;) {
      const Index tip = from(kernel::previous_half(h));
      done[h / 3] = true;
      // Mirrored: Rossignac's right side is the one towards the tip here.
      const Index towards = table.opposite(kernel::next_half(h)),
                  away = table.opposite(kernel::previous_half(h));
      const bool towards_open = towards != kNone && !done[towards / 3];
      const bool away_open = away != kNone && !done[away / 3];
      if (!met[tip]) {
        met[tip] = true;
        letters += 'C';
        h = towards;
      } else if (towards_open && away_open) {
        letters += 'S';
        stack.push_back(away);
        h = towards;
      } else if (towards_open) {
        letters += 'L';
        h = towards;
      } else if (away_open) {
        letters += 'R';
        h = away;
      } else {
        letters += 'E';
        break;
      }
    }
  }
  return letters;
}

TEST_CASE("fan trees are Edgebreaker's strings, both ways") {
  Random random(kSeed);
  for (int i = 0; i < 40; ++i) {
    PlainMesh mesh = stacked_sphere(10 + 5 * i, random);
    flip_edges(mesh, 5 * mesh.faces.size(), random);
    mesh.faces.pop_back();
    const kernel::CornerTable table(mesh.vertices(), mesh.faces);
    const StripTree tree = kernel::grow_strips(table, mesh.faces, StripExits::fan);
    const auto preorder = in_preorder(tree);
    const std::string letters = clers(preorder);
    CHECK(letters == edgebreaker(table, mesh.faces, tree.entered[tree.nodes[0].begin]));
    CHECK(from_clers(letters) == preorder);
    for (const TreeNode& node : preorder)
      if (node.length > 1) CHECK((node.type == NodeType::right || node.type == NodeType::both));
  }
}

TEST_CASE("thesis codes: what goes in comes out") {
  Random random(kSeed);
  for (int i = 0; i < 40; ++i) {
    PlainMesh mesh = stacked_sphere(6 + 7 * i, random);
    flip_edges(mesh, 4 * mesh.faces.size(), random);
    mesh.faces.pop_back();
    const kernel::CornerTable table(mesh.vertices(), mesh.faces);
    const auto preorder = in_preorder(kernel::grow_strips(table, mesh.faces, StripExits::zigzag));
    const auto postorder = to_postorder(preorder);
    auto tree = preorder, post_tree = postorder;
    for (auto* nodes : {&tree, &post_tree})
      for (TreeNode& node : *nodes) node.length = 1;
    CHECK(to_preorder(postorder) == preorder);
    CHECK(from_letters(letters(preorder)) == tree);
    CHECK(letters(postorder).size() == 2 * postorder.size());
    CHECK(from_zaks(zaks(preorder)) == tree);
    CHECK(zaks(preorder).size() == 2 * preorder.size() + 1);
    CHECK(from_weights(weights(preorder)) == tree);
    for (const Traversal traversal :
         {Traversal::pre, Traversal::post, Traversal::in, Traversal::level}) {
      const auto all = lengths(preorder, traversal);
      CHECK(with_lengths(tree, traversal, all) == preorder);
      CHECK(from_unary(unary(all)) == all);
      const Huffman huffman(all);
      CHECK(huffman.decode(huffman.code(all)) == all);
    }
    CHECK(from_places(post_tree, places_in_legal_sets(postorder)) == postorder);
    CHECK(from_lengths_first(lengths_first(preorder)) == preorder);
    std::size_t ones = 0;
    for (const TreeNode& node : preorder) ones += node.length == 1 ? 1 : 0;
    CHECK(lengths_first(preorder).size() == mesh.faces.size() + preorder.size() + ones);
  }
}

}  // namespace
}  // namespace crest::tests
