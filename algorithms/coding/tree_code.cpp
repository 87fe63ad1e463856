// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/tree_code.hpp"

#include <algorithm>
#include <array>

#include "algorithms/coding/mixer.hpp"
#include "algorithms/coding/numbers.hpp"
#include "algorithms/coding/reverse_mesh.hpp"
#include "algorithms/coding/stream_error.hpp"
#include "kernel/geometry/stop.hpp"
#include "kernel/geometry/strip_tree.hpp"

namespace crest::coding {
namespace {

constexpr std::size_t kContexts = 6;
constexpr int kLineBits = 16;
/// 1 / phi, phi the golden ratio: code lengths are whole multiples of log2(phi).
constexpr Probability kInversePhi = {2654435769u, 32};

struct NodeCode {
  NodeType type = NodeType::leaf;
  Index length = 1;
};

/// The tree that is coded, in postorder, and where its half-edges are slots.
class Original {
 public:
  Original(const Surface& surface, kernel::StripExits exits, CodedOrder& order)
      : order_(order),
        tree_(kernel::grow_strips(surface.table(), surface.faces(), exits)),
        nodes_(kernel::postorder(tree_)),
        slot_(3 * std::size_t{surface.face_count()}, kNone) {}

  bool closed(Index component) const { return tree_.removed[component] != kNone; }
  void next_node() { node_ = &tree_.nodes[nodes_[at_++]]; }
  NodeType type() const {
    const bool left = node_->left != kNone, right = node_->right != kNone || splits();
    return left ? (right ? NodeType::both : NodeType::left)
                : (right ? NodeType::right : NodeType::leaf);
  }
  bool splits() const { return node_->split != kNone; }
  Index length() const { return node_->length; }
  Index split_slot() const { return splits() ? slot_[node_->split] : 0; }

  /// The triangle `back` from the strip's end, beginning with 0, was added.
  void added(const ReverseMesh& mesh, Index back) {
    const Index h = tree_.entered[node_->begin + node_->length - 1 - back];
    order_.corners.push_back(h);
    const Index gate = mesh.gate(0);
    put(gate, h);
    if (back > 0) return;
    const NodeType type = this->type();
    const Index next = mesh.slots()[gate].next, previous = mesh.slots()[gate].previous;
    if (type == NodeType::leaf || type == NodeType::right) put(next, next_half(h));
    if (type == NodeType::leaf || type == NodeType::left) put(previous, previous_half(h));
    order_.splits += splits() ? 1 : 0;
  }
  /// The triangle that closes a component; the gate's half-edge is its first.
  void filled(Index component) { order_.corners.push_back(tree_.removed[component]); }

 private:
  void put(Index slot, Index h) { slot_[h] = slot; }

  CodedOrder& order_;
  kernel::StripTree tree_;
  std::vector<Index> nodes_, slot_;
  std::size_t at_ = 0;
  const kernel::StripTree::Node* node_ = nullptr;
};

struct NoOriginal {
  bool closed(Index) const { return false; }
  void next_node() {}
  NodeType type() const { return NodeType::leaf; }
  bool splits() const { return false; }
  Index length() const { return 1; }
  Index split_slot() const { return 0; }
  void added(const ReverseMesh&, Index) {}
  void filled(Index) {}
};

constexpr std::uint64_t pack(std::uint64_t which, std::initializer_list<std::uint64_t> parts) {
  for (const std::uint64_t part : parts) which = which << 6 | part;
  return which;
}

/// Everything that methods share; how types and lengths are coded is the derived class'.
template <class Range, class Mesh, class Code>
class TreeRoutine {
 public:
  TreeRoutine(Range& range, Mesh& original, const Counts& counts, Index max_faces)
      : range_(range),
        original_(original),
        counts_(counts),
        mesh_(max_faces),
        code_(range, mesh_) {}

  std::vector<Triangle> run() {
    const std::vector<bool> closed = code_closed();
    std::int64_t open = 0;
    for (const bool c : closed) open += c ? 0 : 1;
    const std::int64_t splits = 2 * std::int64_t{counts_.handles} + counts_.loops - open;
    const std::int64_t nodes =
        std::int64_t{counts_.vertices} - 2 * std::int64_t{counts_.components} + 2 * splits;
    if (splits < 0) throw StreamError("has more open components than boundary loops");
    splits_left_ = splits;
    for (std::int64_t i = 0; i < nodes; ++i) {
      kernel::stop_point();
      original_.next_node();
      code_.node(
          original_, [&](NodeType type) { add(type); },
          [&](bool left, Index back) {
            mesh_.close(left);
            original_.added(mesh_, back);
          });
    }
    if (mesh_.depth() != counts_.components || splits_left_ != 0)
      throw StreamError("has other components or splits than the header says");
    for (std::size_t c = 0; c < closed.size(); ++c) {
      if (!closed[c]) continue;
      mesh_.fill(closed.size() - 1 - c);
      original_.filled(static_cast<Index>(c));
    }
    Index vertices = 0;
    std::vector<Triangle> faces = mesh_.take_faces(vertices);
    if (vertices != counts_.vertices) throw StreamError("has other vertices than the header says");
    return faces;
  }

 private:
  /// One bit a component, if the header leaves it open.
  std::vector<bool> code_closed() {
    std::vector<bool> closed;
    for (Index c = 0; c < counts_.components; ++c)
      if (counts_.loops == 0 || counts_.components == 1)
        closed.push_back(counts_.loops == 0);
      else
        closed.push_back(range_.code(original_.closed(c), {1, 1}));
    return closed;
  }
  void add(NodeType type) {
    switch (type) {
      case NodeType::leaf:
        mesh_.add_leaf();
        break;
      case NodeType::left:
        mesh_.add_left();
        break;
      case NodeType::right:
        mesh_.add_right();
        break;
      case NodeType::both:
        add_both();
        break;
    }
    original_.added(mesh_, 0);
  }
  void add_both() {
    if (splits_left_ == 0 || !code_alone(range_, split_, original_.splits()))
      return mesh_.add_both();
    --splits_left_;
    const auto slots = static_cast<std::uint32_t>(mesh_.slots().size());
    mesh_.add_split(code_below(range_, original_.split_slot(), slots));
  }

  Range& range_;
  Mesh& original_;
  const Counts& counts_;
  ReverseMesh mesh_;
  Code code_;
  Counter split_;
  std::int64_t splits_left_ = 0;
};

/// How mixed contexts see the boundary at a gate.
template <class Range>
class MixedCode {
 protected:
  MixedCode(Range& range, const ReverseMesh& mesh)
      : range_(range), mesh_(mesh), lines_(kLineBits) {}

  /// Triangles at the vertices before, at the ends of, and after a gate.
  struct Ends {
    std::uint64_t before, first, second, after;
  };
  Ends ends(std::size_t below) const {
    if (below >= mesh_.depth()) return {};
    const auto& slots = mesh_.slots();
    const auto& gate = slots[mesh_.gate(below)];
    const auto clip = [](Index n) { return std::uint64_t{std::min<Index>(n, 15)}; };
    const auto& next = slots[gate.next];
    return {clip(slots[gate.previous].triangles), clip(gate.triangles), clip(next.triangles),
            clip(slots[next.next].triangles)};
  }
  NodeType code_type(NodeType type) {
    const Ends top = ends(0), second = ends(1);
    const std::uint64_t last = symbol(0), before = symbol(1), third = symbol(2);
    const Context<kContexts> context = {
        &lines_.of(pack(1, {last})),
        &lines_.of(pack(2, {top.first, top.second, last})),
        &lines_.of(pack(3, {top.first, top.second, second.first, second.second})),
        &lines_.of(pack(4, {last, before, third})),
        &lines_.of(pack(5, {top.before, top.first, top.second, top.after})),
        &lines_.of(pack(6, {top.second, second.first, last, before}))};
    const bool left =
        code_mixed(range_, context, 0, type_[0], type == NodeType::left || type == NodeType::both);
    const bool right = code_mixed(range_, context, left ? 1 : 2, type_[left ? 1 : 2],
                                  type == NodeType::right || type == NodeType::both);
    return left ? (right ? NodeType::both : NodeType::left)
                : (right ? NodeType::right : NodeType::leaf);
  }
  Context<kContexts> length_context(NodeType type, Index steps) {
    const Ends e = ends(0);
    const auto t = static_cast<std::uint64_t>(type);
    const std::uint64_t k = std::min<Index>(steps, 7), kind = t << 3 | k;
    return {&lines_.of(pack(11, {kind})),
            &lines_.of(pack(12, {e.first, e.second, kind})),
            &lines_.of(pack(13, {e.before, e.first, e.second, e.after})),
            &lines_.of(pack(14, {e.first, e.before, t})),
            &lines_.of(pack(15, {e.second, e.after, t, std::min<std::uint64_t>(k, 1)})),
            &lines_.of(pack(16, {e.first, e.second, symbol(0), symbol(1), kind}))};
  }
  bool decide(const Context<kContexts>& context, std::size_t number, std::size_t weights,
              bool bit) {
    return code_mixed(range_, context, number, length_[weights], bit);
  }
  void remember(NodeType type, Index length) {
    history_ = history_ << 6 | static_cast<std::uint64_t>(type) << 4 | std::min<Index>(length, 15);
  }

 private:
  std::uint64_t symbol(int back) const { return history_ >> (6 * back) & 63; }

  Range& range_;
  const ReverseMesh& mesh_;
  Lines lines_;
  std::array<Weights<kContexts>, 3> type_;
  std::array<Weights<kContexts>, 16> length_;
  std::uint64_t history_ = 0;
};

/// Strips that leave every triangle through its left edge.
template <class Range>
class FanCode : MixedCode<Range> {
 public:
  FanCode(Range& range, const ReverseMesh& mesh) : MixedCode<Range>(range, mesh) {}

  template <class Mesh, class Add, class Close>
  void node(const Mesh& original, Add&& add, Close&& close) {
    const NodeType type = this->code_type(original.type());
    add(type);
    Index length = 1;
    if (type == NodeType::right || type == NodeType::both) {
      const std::size_t weights = type == NodeType::both ? 8 : 0;
      while (this->decide(this->length_context(type, length), 0,
                          weights + std::min<std::size_t>(length, 7), length < original.length()))
        close(true, length++);
    }
    this->remember(type, length);
  }
};

/// Strips that leave their triangles through left and right edges in turn, the first one left.
template <class Range>
class ZigzagCode : MixedCode<Range> {
 public:
  ZigzagCode(Range& range, const ReverseMesh& mesh) : MixedCode<Range>(range, mesh) {}

  template <class Mesh, class Add, class Close>
  void node(const Mesh& original, Add&& add, Close&& close) {
    const NodeType type = this->code_type(original.type());
    add(type);
    Index length = 1;
    if (type != NodeType::leaf) {
      const auto t = static_cast<std::size_t>(type) * 4;
      const auto context = this->length_context(type, 1);
      if (this->decide(context, 0, t, original.length() > 1)) {
        bool even = type == NodeType::right;
        if (type == NodeType::both)
          even = this->decide(context, 1, t + 1, original.length() % 2 == 0);
        if (!even) close(false, length++);
        close(true, length++);
        while (this->decide(this->length_context(type, length), 2, t + 2,
                            length < original.length())) {
          close(false, length++);
          close(true, length++);
        }
      }
    }
    this->remember(type, length);
  }
};

/// Zig-zag strips, every decision of probability 1 / phi or 1 / phi^2, which makes code lengths of
/// 3 for a leaf, 3 + l for one child, 4 + l for two, in units of log2(phi).
template <class Range>
class FixedCode {
 public:
  FixedCode(Range& range, const ReverseMesh&) : range_(range) {}

  template <class Mesh, class Add, class Close>
  void node(const Mesh& original, Add&& add, Close&& close) {
    const Index wanted = original.length();
    const NodeType t = original.type();
    Index length = 1;
    if (!likely(wanted == 1)) {
      length = 2;
      while (likely(length < wanted)) ++length;
    }
    NodeType type = NodeType::both;
    if (length > 1) {
      if (likely(t != NodeType::both)) type = length % 2 == 1 ? NodeType::left : NodeType::right;
    } else if (!likely(t != NodeType::leaf)) {
      type = NodeType::leaf;
    } else if (!likely(t != NodeType::left)) {
      type = NodeType::left;
    } else if (likely(t == NodeType::right)) {
      type = NodeType::right;
    }
    add(type);
    for (Index back = 1; back < length; ++back) close((length - back) % 2 == 1, back);
  }

 private:
  bool likely(bool bit) { return range_.code(bit, kInversePhi); }
  Range& range_;
};

template <class Range, class Mesh>
std::vector<Triangle> run(TreeMethod method, Range& range, Mesh& original, const Counts& counts,
                          Index max_faces) {
  switch (method) {
    case TreeMethod::fan:
      return TreeRoutine<Range, Mesh, FanCode<Range>>(range, original, counts, max_faces).run();
    case TreeMethod::zigzag:
      return TreeRoutine<Range, Mesh, ZigzagCode<Range>>(range, original, counts, max_faces).run();
    case TreeMethod::fixed:
      break;
  }
  return TreeRoutine<Range, Mesh, FixedCode<Range>>(range, original, counts, max_faces).run();
}

}  // namespace

Bytes encode_tree(const Surface& surface, TreeMethod method, CodedOrder& order) {
  const auto exits =
      method == TreeMethod::fan ? kernel::StripExits::fan : kernel::StripExits::zigzag;
  Original original(surface, exits, order);
  RangeEncoder range;
  order.faces = run(method, range, original, surface.counts(), kNone);
  return range.finish();
}

std::vector<Triangle> decode_tree(std::span<const std::uint8_t> bytes, TreeMethod method,
                                  const Counts& counts, Index max_faces) {
  RangeDecoder range(bytes);
  NoOriginal none;
  return with_position(range, [&] {
    std::vector<Triangle> faces = run(method, range, none, counts, max_faces);
    range.finish();
    return faces;
  });
}

}  // namespace crest::coding
