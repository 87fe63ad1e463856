// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ridges/smooth_ridge_lines.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <utility>

namespace crest::io {

namespace bg = boost::geometry;

std::vector<bool> undecided_faces(const smooth_ridges::SmoothRidges& result) {
  using Place = bg::model::point<double, 3, bg::cs::cartesian>;
  using Entry = std::pair<Place, kernel::Index>;
  std::vector<bool> marked(result.faces.size(), false);
  if (result.undecided.empty()) return marked;
  std::vector<Entry> middles;
  for (kernel::Index f = 0; f < result.faces.size(); ++f) {
    kernel::Vec3 m;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t corner) { return result.points[result.faces[f][corner]][k]; };
      m[k] = (at(0) + at(1) + at(2)) / 3;
    }
    middles.emplace_back(Place(m[0], m[1], m[2]), f);
  }
  const bg::index::rtree<Entry, bg::index::quadratic<16>> tree(middles);
  for (const smooth_ridges::UndecidedCell& cell : result.undecided) {
    const Place centre(cell.centre[0], cell.centre[1], cell.centre[2]);
    for (auto it = tree.qbegin(bg::index::nearest(centre, 1)); it != tree.qend(); ++it)
      if (bg::distance(it->first, centre) <= cell.size) marked[it->second] = true;
  }
  return marked;
}

}  // namespace crest::io
