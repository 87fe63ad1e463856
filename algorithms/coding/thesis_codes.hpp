// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The codes of paper 001, sections 4.2 and 4.3, for its tables: strings of bits in and out. Streams
// use none of them.
#include <map>
#include <string>
#include <vector>

#include "algorithms/coding/reverse_mesh.hpp"
#include "kernel/geometry/strip_tree.hpp"

namespace crest::coding {

/// A node as the codes see it: its letter E, L, R or S and its strip's length.
struct TreeNode {
  NodeType type;
  Index length;
  bool operator==(const TreeNode&) const = default;
};

using Bits = std::vector<bool>;

/// Adds the node's zig-zag strip, the last triangle first.
void add_node(ReverseMesh& mesh, const TreeNode& node);

/// The nodes of one tree without splits, in preorder and in postorder.
std::vector<TreeNode> in_preorder(const kernel::StripTree& tree);
std::vector<TreeNode> to_postorder(const std::vector<TreeNode>& preorder);
std::vector<TreeNode> to_preorder(const std::vector<TreeNode>& postorder);

/// The lengths in the order of a traversal for which the tree must be known.
enum class Traversal { pre, post, in, level };
std::vector<Index> lengths(const std::vector<TreeNode>& preorder, Traversal traversal);
/// The tree's nodes with lengths that came in this order.
std::vector<TreeNode> with_lengths(const std::vector<TreeNode>& preorder, Traversal traversal,
                                   const std::vector<Index>& lengths);

/// Algorithm 4.1's output: lengths in preorder, 0 for an empty subtree, and back.
std::vector<Index> with_zeros(const std::vector<TreeNode>& preorder);
std::vector<TreeNode> from_zeros(const std::vector<Index>& code);

/// Trees: two bits a node (left child, right child); Zaks' sequence in preorder; nodes of left
/// subtrees in preorder. Lengths are 1 in what comes back.
Bits letters(const std::vector<TreeNode>& nodes);
std::vector<TreeNode> from_letters(const Bits& bits);
Bits zaks(const std::vector<TreeNode>& preorder);
std::vector<TreeNode> from_zaks(const Bits& bits);
std::vector<Index> weights(const std::vector<TreeNode>& preorder);
std::vector<TreeNode> from_weights(const std::vector<Index>& weights);

/// Lengths as l - 1 ones and a zero.
Bits unary(const std::vector<Index>& numbers);
std::vector<Index> from_unary(const Bits& bits);

/// A Huffman code of these numbers; of one number alone one bit each.
struct Huffman {
  explicit Huffman(const std::vector<Index>& numbers);
  Bits code(const std::vector<Index>& numbers) const;
  std::vector<Index> decode(const Bits& bits) const;

 private:
  std::map<Index, Bits> words_;
};

/// Section 4.3.4, nodes in postorder with the tree known: each length's place in the set of legal
/// ones, from 0; and back.
std::vector<Index> legal_lengths(NodeType type, Index most);
std::vector<Index> places_in_legal_sets(const std::vector<TreeNode>& postorder);
std::vector<TreeNode> from_places(const std::vector<TreeNode>& tree_in_postorder,
                                  const std::vector<Index>& places);

/// Section 4.3.5: lengths first, in unary, then two bits of tree for length 1 and one otherwise:
/// t + n + n_1 bits, FIXED of table 4.1; in pre- or postorder.
Bits lengths_first(const std::vector<TreeNode>& nodes);
std::vector<TreeNode> from_lengths_first(const Bits& bits);

/// Section 4.2.4: a fan tree's nodes in preorder as Edgebreaker's letters C, L, E, R, S, and back.
std::string clers(const std::vector<TreeNode>& preorder);
std::vector<TreeNode> from_clers(const std::string& letters);

}  // namespace crest::coding
