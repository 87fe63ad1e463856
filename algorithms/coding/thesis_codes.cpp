// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/thesis_codes.hpp"

#include <algorithm>
#include <deque>
#include <queue>
#include <stdexcept>

namespace crest::coding {
namespace {

bool has_left(NodeType type) { return type == NodeType::left || type == NodeType::both; }
bool has_right(NodeType type) { return type == NodeType::right || type == NodeType::both; }
NodeType type_of(bool left, bool right) {
  return left ? (right ? NodeType::both : NodeType::left) : (right ? NodeType::right : NodeType::leaf);
}

/// Children of nodes in preorder, or kNone.
struct Links {
  std::vector<Index> left, right;
};

Links links_of(const std::vector<TreeNode>& preorder) {
  Links links{std::vector<Index>(preorder.size(), kNone), std::vector<Index>(preorder.size(), kNone)};
  std::vector<Index*> open;  // where the next node is to be linked
  for (Index i = 0; i < preorder.size(); ++i) {
    if (i > 0) {
      if (open.empty()) throw std::invalid_argument("more nodes than the tree has");
      *open.back() = i;
      open.pop_back();
    }
    if (has_right(preorder[i].type)) open.push_back(&links.right[i]);
    if (has_left(preorder[i].type)) open.push_back(&links.left[i]);
  }
  if (!open.empty() || preorder.empty()) throw std::invalid_argument("nodes are missing");
  return links;
}

/// The nodes' numbers in the order of a traversal.
std::vector<Index> sequence(const std::vector<TreeNode>& preorder, Traversal traversal) {
  const Links links = links_of(preorder);
  std::vector<Index> order;
  if (traversal == Traversal::level) {
    std::deque<Index> queue{0};
    for (; !queue.empty(); queue.pop_front()) {
      order.push_back(queue.front());
      for (const Index child : {links.left[queue.front()], links.right[queue.front()]})
        if (child != kNone) queue.push_back(child);
    }
    return order;
  }
  struct Step {
    Index node;
    int done;  // 0: nothing yet, 1: the left subtree, 2: both
  };
  std::vector<Step> steps{{0, 0}};
  const int when = traversal == Traversal::pre ? 0 : traversal == Traversal::in ? 1 : 2;
  while (!steps.empty()) {
    const auto [node, done] = steps.back();
    if (done == when) order.push_back(node);
    if (done == 2) {
      steps.pop_back();
      continue;
    }
    ++steps.back().done;
    const Index child = done == 0 ? links.left[node] : links.right[node];
    if (child != kNone) steps.push_back({child, 0});
  }
  return order;
}

/// Nodes and triangles of the subtrees of nodes in postorder.
class Subtrees {
 public:
  struct Sums {
    Index nodes, triangles;
  };
  /// Of a node's children together; removes them.
  Sums children(NodeType type) {
    Sums sums{0, 0};
    for (int i = (has_left(type) ? 1 : 0) + (has_right(type) ? 1 : 0); i > 0; --i) {
      if (stack_.empty()) throw std::invalid_argument("nodes are missing");
      sums.nodes += stack_.back().nodes;
      sums.triangles += stack_.back().triangles;
      stack_.pop_back();
    }
    return sums;
  }
  void add(Sums sums) { stack_.push_back(sums); }

 private:
  std::vector<Sums> stack_;
};

}  // namespace

void add_node(ReverseMesh& mesh, const TreeNode& node) {
  switch (node.type) {
    case NodeType::leaf: mesh.add_leaf(); break;
    case NodeType::left: mesh.add_left(); break;
    case NodeType::right: mesh.add_right(); break;
    case NodeType::both: mesh.add_both(); break;
  }
  for (Index k = node.length - 1; k > 0; --k) mesh.close(k % 2 == 1);
}

std::vector<TreeNode> in_preorder(const kernel::StripTree& tree) {
  std::vector<TreeNode> nodes;
  for (const auto& node : tree.nodes) {
    if (node.split != kNone) throw std::invalid_argument("the tree has splits");
    nodes.push_back({type_of(node.left != kNone, node.right != kNone), node.length});
  }
  return nodes;
}

std::vector<TreeNode> to_postorder(const std::vector<TreeNode>& preorder) {
  std::vector<TreeNode> nodes;
  for (const Index i : sequence(preorder, Traversal::post)) nodes.push_back(preorder[i]);
  return nodes;
}

std::vector<TreeNode> to_preorder(const std::vector<TreeNode>& postorder) {
  // Backwards it is the mirror image's preorder.
  std::vector<TreeNode> mirrored(postorder.rbegin(), postorder.rend());
  for (TreeNode& node : mirrored) node.type = type_of(has_right(node.type), has_left(node.type));
  std::vector<TreeNode> nodes = to_postorder(mirrored);
  std::reverse(nodes.begin(), nodes.end());
  for (TreeNode& node : nodes) node.type = type_of(has_right(node.type), has_left(node.type));
  return nodes;
}

std::vector<Index> lengths(const std::vector<TreeNode>& preorder, Traversal traversal) {
  std::vector<Index> result;
  for (const Index i : sequence(preorder, traversal)) result.push_back(preorder[i].length);
  return result;
}

std::vector<TreeNode> with_lengths(const std::vector<TreeNode>& preorder, Traversal traversal,
                                   const std::vector<Index>& lengths) {
  std::vector<TreeNode> nodes = preorder;
  const std::vector<Index> order = sequence(preorder, traversal);
  for (std::size_t i = 0; i < order.size(); ++i) nodes[order[i]].length = lengths.at(i);
  return nodes;
}

std::vector<Index> with_zeros(const std::vector<TreeNode>& preorder) {
  const Links links = links_of(preorder);
  std::vector<Index> code, waiting{0};
  while (!waiting.empty()) {
    const Index node = waiting.back();
    waiting.pop_back();
    code.push_back(node == kNone ? 0 : preorder[node].length);
    if (node == kNone) continue;
    waiting.push_back(links.right[node]);
    waiting.push_back(links.left[node]);
  }
  return code;
}

std::vector<TreeNode> from_zeros(const std::vector<Index>& code) {
  std::vector<TreeNode> nodes;
  struct Open {
    Index node;
    bool left;
  };
  std::vector<Open> open;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (i > 0) {
      if (open.empty()) throw std::invalid_argument("numbers follow the tree");
      const auto [node, left] = open.back();
      open.pop_back();
      if (code[i] > 0) {
        NodeType& type = nodes[node].type;
        type = type_of(has_left(type) || left, has_right(type) || !left);
      }
    }
    if (code[i] == 0) continue;
    const auto node = static_cast<Index>(nodes.size());
    nodes.push_back({NodeType::leaf, code[i]});
    open.push_back({node, false});
    open.push_back({node, true});
  }
  if (!open.empty()) throw std::invalid_argument("numbers are missing");
  return nodes;
}

Bits letters(const std::vector<TreeNode>& nodes) {
  Bits bits;
  for (const TreeNode& node : nodes) {
    bits.push_back(has_left(node.type));
    bits.push_back(has_right(node.type));
  }
  return bits;
}

std::vector<TreeNode> from_letters(const Bits& bits) {
  std::vector<TreeNode> nodes;
  for (std::size_t i = 0; i + 1 < bits.size(); i += 2) nodes.push_back({type_of(bits[i], bits[i + 1]), 1});
  return nodes;
}

Bits zaks(const std::vector<TreeNode>& preorder) {
  Bits bits;
  for (const Index length : with_zeros(preorder)) bits.push_back(length > 0);
  return bits;
}

std::vector<TreeNode> from_zaks(const Bits& bits) {
  return from_zeros(std::vector<Index>(bits.begin(), bits.end()));
}

std::vector<Index> weights(const std::vector<TreeNode>& preorder) {
  const Links links = links_of(preorder);
  std::vector<Index> size(preorder.size(), 1), left(preorder.size(), 0);
  for (std::size_t i = preorder.size(); i-- > 0;) {
    if (links.left[i] != kNone) left[i] = size[links.left[i]];
    size[i] += left[i] + (links.right[i] != kNone ? size[links.right[i]] : 0);
  }
  return left;
}

std::vector<TreeNode> from_weights(const std::vector<Index>& weights) {
  std::vector<TreeNode> nodes;
  std::vector<Index> sizes{static_cast<Index>(weights.size())};  // of subtrees to come
  for (const Index left : weights) {
    if (sizes.empty() || left >= sizes.back()) throw std::invalid_argument("a left subtree is too large");
    const Index right = sizes.back() - 1 - left;
    sizes.pop_back();
    nodes.push_back({type_of(left > 0, right > 0), 1});
    if (right > 0) sizes.push_back(right);
    if (left > 0) sizes.push_back(left);
  }
  return nodes;
}

Bits unary(const std::vector<Index>& numbers) {
  Bits bits;
  for (const Index x : numbers) {
    bits.insert(bits.end(), x - 1, true);
    bits.push_back(false);
  }
  return bits;
}

std::vector<Index> from_unary(const Bits& bits) {
  std::vector<Index> numbers;
  Index x = 1;
  for (const bool bit : bits) {
    if (bit) {
      ++x;
      continue;
    }
    numbers.push_back(x);
    x = 1;
  }
  return numbers;
}

Huffman::Huffman(const std::vector<Index>& numbers) {
  std::map<Index, std::size_t> count;
  for (const Index x : numbers) ++count[x];
  struct Tree {
    std::size_t count, age;
    std::vector<Index> symbols;
  };
  const auto later = [](const Tree& a, const Tree& b) {
    return a.count != b.count ? a.count > b.count : a.age > b.age;
  };
  std::priority_queue<Tree, std::vector<Tree>, decltype(later)> trees(later);
  for (const auto& [x, n] : count) trees.push({n, trees.size(), {x}});
  if (trees.size() == 1) words_[trees.top().symbols[0]] = {false};
  for (std::size_t age = trees.size(); trees.size() > 1; ++age) {
    Tree joined{0, age, {}};
    for (const bool bit : {false, true}) {
      const Tree& least = trees.top();
      joined.count += least.count;
      for (const Index x : least.symbols) {
        words_[x].insert(words_[x].begin(), bit);
        joined.symbols.push_back(x);
      }
      trees.pop();
    }
    trees.push(std::move(joined));
  }
}

Bits Huffman::code(const std::vector<Index>& numbers) const {
  Bits bits;
  for (const Index x : numbers) bits.insert(bits.end(), words_.at(x).begin(), words_.at(x).end());
  return bits;
}

std::vector<Index> Huffman::decode(const Bits& bits) const {
  std::map<Bits, Index> symbols;
  for (const auto& [x, word] : words_) symbols[word] = x;
  std::vector<Index> numbers;
  Bits word;
  for (const bool bit : bits) {
    word.push_back(bit);
    const auto found = symbols.find(word);
    if (found == symbols.end()) continue;
    numbers.push_back(found->second);
    word.clear();
  }
  return numbers;
}

std::vector<Index> legal_lengths(NodeType type, Index most) {
  std::vector<Index> legal;
  for (Index l = 1; l <= most; ++l)
    if (l == 1 || type == NodeType::both || (type == NodeType::left && l % 2 == 1) ||
        (type == NodeType::right && l % 2 == 0))
      legal.push_back(l);
  return legal;
}

std::vector<Index> places_in_legal_sets(const std::vector<TreeNode>& postorder) {
  std::vector<Index> places;
  Subtrees subtrees;
  for (const TreeNode& node : postorder) {
    const auto [nodes, triangles] = subtrees.children(node.type);
    const std::vector<Index> legal = legal_lengths(node.type, 2 * nodes + 1 - triangles);
    const auto place = std::find(legal.begin(), legal.end(), node.length);
    if (place == legal.end()) throw std::invalid_argument("a length is not legal");
    places.push_back(static_cast<Index>(place - legal.begin()));
    subtrees.add({nodes + 1, triangles + node.length});
  }
  return places;
}

std::vector<TreeNode> from_places(const std::vector<TreeNode>& tree_in_postorder,
                                  const std::vector<Index>& places) {
  std::vector<TreeNode> result;
  Subtrees subtrees;
  for (std::size_t i = 0; i < tree_in_postorder.size(); ++i) {
    const NodeType type = tree_in_postorder[i].type;
    const auto [nodes, triangles] = subtrees.children(type);
    const Index length = legal_lengths(type, 2 * nodes + 1 - triangles).at(places.at(i));
    result.push_back({type, length});
    subtrees.add({nodes + 1, triangles + length});
  }
  return result;
}

Bits lengths_first(const std::vector<TreeNode>& nodes) {
  Bits bits;
  for (const TreeNode& node : nodes) {
    const Bits length = unary({node.length});
    bits.insert(bits.end(), length.begin(), length.end());
    if (node.length == 1) bits.push_back(has_left(node.type));
    if (node.length == 1) bits.push_back(has_right(node.type));
    if (node.length > 1) bits.push_back(node.type == NodeType::both);
  }
  return bits;
}

std::vector<TreeNode> from_lengths_first(const Bits& bits) {
  std::vector<TreeNode> nodes;
  for (std::size_t i = 0; i < bits.size();) {
    Index length = 1;
    for (; bits.at(i); ++i) ++length;
    ++i;
    if (length == 1) {
      nodes.push_back({type_of(bits.at(i), bits.at(i + 1)), 1});
      i += 2;
      continue;
    }
    const NodeType one = length % 2 == 1 ? NodeType::left : NodeType::right;
    nodes.push_back({bits.at(i) ? NodeType::both : one, length});
    ++i;
  }
  return nodes;
}

std::string clers(const std::vector<TreeNode>& preorder) {
  std::string result;
  for (const TreeNode& node : preorder) {
    result.append(node.length - 1, 'C');
    result += "ELRS"[static_cast<std::size_t>(node.type)];
  }
  return result;
}

std::vector<TreeNode> from_clers(const std::string& letters) {
  std::vector<TreeNode> nodes;
  Index length = 1;
  for (const char letter : letters) {
    if (letter == 'C') {
      ++length;
      continue;
    }
    nodes.push_back({static_cast<NodeType>(std::string("ELRS").find(letter)), length});
    length = 1;
  }
  return nodes;
}

}  // namespace crest::coding
