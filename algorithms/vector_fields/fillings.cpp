// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/fillings.hpp"

namespace crest::vector_fields {

Fillings::Fillings(const std::vector<Index>& corners,
                   const std::function<bool(std::size_t, std::size_t, std::size_t)>& may_be)
    : corners_(corners), n_(corners.size()), apices_(n_ * n_) {
  const auto fills = [&](std::size_t first, std::size_t last) {
    return last == first + 1 || !apices_[at(first, last)].empty();
  };
  for (std::size_t width = 2; width < n_; ++width)
    for (std::size_t first = 0; first + width < n_; ++first)
      for (std::size_t apex = first + 1; apex < first + width; ++apex)
        if (fills(first, apex) && fills(apex, first + width) && may_be(first, apex, first + width))
          apices_[at(first, first + width)].push_back(apex);
}

bool Fillings::any(std::size_t most, const std::function<bool(const Triangles&)>& will_do) {
  left_ = most;
  triangles_.clear();
  std::vector<Part> open{{0, n_ - 1}};
  return go_on(open, will_do);
}

bool Fillings::go_on(std::vector<Part>& open,
                     const std::function<bool(const Triangles&)>& will_do) {
  if (left_ == 0) return false;
  if (open.empty()) {
    --left_;
    return will_do(triangles_);
  }
  const auto [first, last] = open.back();
  open.pop_back();
  bool found = false;
  if (last == first + 1) {
    found = go_on(open, will_do);
  } else {
    for (const std::size_t apex : apices_[at(first, last)]) {
      triangles_.push_back({corners_[first], corners_[apex], corners_[last]});
      const std::size_t parts = open.size();
      open.push_back({first, apex});
      open.push_back({apex, last});
      found = go_on(open, will_do);
      open.resize(parts);
      triangles_.pop_back();
      if (found || left_ == 0) break;
    }
  }
  open.push_back({first, last});
  return found;
}

}  // namespace crest::vector_fields
