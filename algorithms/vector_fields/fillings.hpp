// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All triangulations of the hole that a vertex leaves.
#include <array>
#include <functional>
#include <vector>

#include "algorithms/vector_fields/collapse_mesh.hpp"

namespace crest::vector_fields {

class Fillings {
 public:
  using Triangles = std::vector<std::array<Index, 3>>;

  /// may_be: whether the corners first < apex < last may become a triangle. Requires: the corners
  /// outlive the fillings.
  Fillings(const std::vector<Index>& corners,
           const std::function<bool(std::size_t, std::size_t, std::size_t)>& may_be);

  /// In turns until one will do, so many at most; whether one did. Cost: none for parts of the hole
  /// that no triangle fills.
  bool any(std::size_t most, const std::function<bool(const Triangles&)>& will_do);

 private:
  struct Part {
    std::size_t first, last;  ///< corners on one side of a diagonal
  };
  std::size_t at(std::size_t first, std::size_t last) const { return first * n_ + last; }
  bool go_on(std::vector<Part>& open, const std::function<bool(const Triangles&)>& will_do);

  const std::vector<Index>& corners_;
  std::size_t n_;
  std::vector<std::vector<std::size_t>> apices_;  ///< by part: of the triangle at its diagonal
  Triangles triangles_;
  std::size_t left_ = 0;
};

}  // namespace crest::vector_fields
