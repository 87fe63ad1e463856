// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which face is nearest to the eye at a point of the page, in double: what a certificate states and
// its checker proves.
#include <optional>

#include "algorithms/line_art/view.hpp"

namespace crest::line_art {

class FaceLocator {
 public:
  FaceLocator(const Scene& scene, const View& view);
  /// Nothing where no face is, or where a side is too near to be told from the inside.
  std::optional<Index> at(const Vec2& page) const;
  /// Where the sight line of a point of the page meets the plane of a face that is not seen
  /// edge-on.
  Vec3 lift(const Vec2& page, Index face) const;

 private:
  const Scene& scene_;
  std::vector<PagePoint> seen_;
  const View& view_;
  CellFrame frame_;
  CellLists faces_;
};

}  // namespace crest::line_art
