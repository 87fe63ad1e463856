// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The faces around every vertex while a surface changes: collapses, flips, omissions.
#include "io/clean/surface.hpp"

namespace crest::io {

/// Changes the surface's faces in place; those that go are only marked.
/// Requires: a manifold. Cost: what an operation looks at are the stars of the vertices named.
class Stars {
 public:
  explicit Stars(Surface& surface);

  bool alive(kernel::Index f) const { return alive_[f]; }
  const std::vector<kernel::Index>& star(kernel::Index v) const { return star_[v]; }
  std::vector<kernel::Index> faces_at(kernel::Index u, kernel::Index v) const;
  bool adjacent(kernel::Index u, kernel::Index v) const { return !faces_at(u, v).empty(); }
  bool at_boundary(kernel::Index u, kernel::Index v) const { return faces_at(u, v).size() == 1; }
  bool on_boundary(kernel::Index v) const;
  /// The corner of f that is neither u nor v.
  kernel::Index third(kernel::Index f, kernel::Index u, kernel::Index v) const;

  /// Whether the links of u and v meet in the link of their edge alone, the boundary counting as
  /// one more vertex: then a collapse keeps the topology. Requires: an edge.
  bool may_collapse(kernel::Index u, kernel::Index v) const;
  /// Faces of `gone` get `kept` in its place, those at their edge go.
  void collapse(kernel::Index kept, kernel::Index gone);
  /// Of f = (a, b, c) and `other` across b c with its third corner d the edge becomes a d.
  void flip(kernel::Index f, kernel::Index other, const kernel::Triangle& abc, kernel::Index d);
  void leave_out(kernel::Index f);

 private:
  bool has(kernel::Index f, kernel::Index v) const;
  std::vector<kernel::Index> neighbours(kernel::Index v) const;

  Surface& surface_;
  std::vector<bool> alive_;
  std::vector<std::vector<kernel::Index>> star_;
};

}  // namespace crest::io
