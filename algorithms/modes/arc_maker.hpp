// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Joins the roots around a face that has a witness: along it each line meets a side's curve once at
// most, so over the axis across it, where the roots are ordered, arcs lie side by side.
#include <boost/container/small_vector.hpp>

#include "algorithms/modes/faces.hpp"

namespace crest::modes {

class ArcMaker {
 public:
  /// Requires: the face's witness holds.
  ArcMaker(Faces& faces, Index face) : faces_(faces), face_(face) {}
  /// Adds the face's arcs; false if an order is not decided or a number of roots is odd.
  bool make();

 private:
  struct End {
    Index root;
    std::uint8_t edge, number;
    Side side;
    std::size_t order;  ///< on the edge, from its corner on
  };
  void collect();
  bool join(Side side);
  bool is_at(const End& end, std::size_t corner);
  int compare(const End& a, const End& b);
  void add(const End& a, const End& b);

  Faces& faces_;
  Index face_;
  boost::container::small_vector<End, 12> ends_;
  boost::container::small_vector<Arc, 6> arcs_;
};

}  // namespace crest::modes
