// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The bisected tetrahedra and their leaves (SPEC.md, step 2).
#include "certify/exact/quadratic_spline.hpp"
#include "certify/spline_isosurface/bisection.hpp"
#include "certify/spline_isosurface/records.hpp"

namespace crest::certify::spline_isosurface {

class Forest {
 public:
  /// Throws Reject unless the trees are complete, one a tetrahedron listed, ascending, and at most
  /// kDepth deep.
  Forest(const SplineIsosurfaceCertificate& certificate, const QuadraticSpline& spline);

  /// Whether one of a cube's tetrahedra is bisected.
  bool touches(std::size_t cube) const;
  bool is_bisected(std::uint32_t root) const;

  /// The lowest corner of a cube, in lattice units.
  Point cube_corner(std::size_t cube) const;

  /// Calls f(leaf) for the leaves of a tetrahedron, in their order.
  template <class F>
  void for_each_leaf(std::uint32_t number, const F& f) const {
    std::size_t node = first_node(number);
    if (node == trees_.size()) return f(root_of(number));
    // Depth first; a pending node is where its tree goes on.
    std::vector<Simplex> pending = {root_of(number)};
    while (!pending.empty()) {
      const Simplex simplex = pending.back();
      pending.pop_back();
      if (trees_[node++] == spline_code::kLeaf) {
        f(simplex);
        continue;
      }
      pending.push_back(child(simplex, true));
      pending.push_back(child(simplex, false));
    }
  }

  std::size_t bisected() const { return roots_.size(); }
  std::size_t deepest() const { return deepest_; }
  /// Leaves of bisected tetrahedra.
  std::size_t leaves() const { return leaves_; }

  /// Throws Reject unless every face of a leaf is a face of another one or in the border.
  void check_conforming() const;

 private:
  Simplex root_of(std::uint32_t number) const {
    return root(cube_corner(number / kTetrahedra), number % kTetrahedra);
  }
  /// Where its tree begins; the end of all without one.
  std::size_t first_node(std::uint32_t number) const;
  /// The tetrahedron across the face without corner i; its own number at the border.
  std::uint32_t neighbour(std::uint32_t number, std::size_t i) const;
  bool on_border(const Point& a, const Point& b, const Point& c) const;

  const QuadraticSpline& spline_;
  const std::vector<std::uint32_t>& roots_;
  const std::vector<std::uint8_t>& trees_;
  std::vector<std::size_t> starts_;
  std::size_t deepest_ = 0, leaves_ = 0;
};

}  // namespace crest::certify::spline_isosurface
