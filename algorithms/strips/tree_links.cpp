// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/strips/tree_links.hpp"

#include "kernel/geometry/strip_tree.hpp"

namespace crest::strips {
namespace {

using kernel::kNone;
using kernel::StripTree;

class Joiner {
 public:
  Joiner(const CornerTable& mesh, const StripTree& tree)
      : mesh_(mesh), tree_(tree), links_(mesh.face_count(), 0) {}

  Links join() {
    for (const Index removed : tree_.removed)
      if (removed != kNone) link(removed);
    // Parents stand before their children.
    for (const StripTree::Node& node : tree_.nodes) {
      for (Index i = 1; i < node.length; ++i) link(tree_.entered[node.begin + i]);
      if (const Index child = best_child(node); child != kNone)
        link(tree_.entered[tree_.nodes[child].begin]);
    }
    return std::move(links_);
  }

 private:
  void link(Index h) {
    for (const Index s : {h, mesh_.opposite(h)})
      links_[s / 3] = static_cast<std::uint8_t>(links_[s / 3] | 1u << s % 3);
  }
  bool linked(Index h) const { return (links_[h / 3] >> (h % 3) & 1) != 0; }

  Index best_child(const StripTree::Node& node) const {
    if (node.left == kNone || node.right == kNone)
      return node.left == kNone ? node.right : node.left;
    // The face before the last one, if the strip comes from there, was left by one side or the
    // other; now it is the other's turn. The left child is behind the side next to the entry.
    const Index exit = mesh_.opposite(tree_.entered[node.begin + node.length - 1]);
    const bool joined = exit != kNone && linked(exit);
    return joined && linked(kernel::previous_half(exit)) ? node.right : node.left;
  }

  const CornerTable& mesh_;
  const StripTree& tree_;
  Links links_;
};

}  // namespace

Links tree_links(const CornerTable& mesh, std::span<const kernel::Triangle> faces) {
  return Joiner(mesh, kernel::grow_strips(mesh, faces, kernel::StripExits::zigzag)).join();
}

}  // namespace crest::strips
