// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The complex with what a certificate lists on it.
#include <span>

#include "certify/container/verdict.hpp"
#include "certify/modes_curves/box.hpp"
#include "certify/modes_curves/records.hpp"
#include "certify/surface/tetrahedra.hpp"

namespace crest::certify::curves {

/// Throws Reject unless H1 holds and the lists are in order and name what is there.
class Places {
 public:
  Places(const ModesCurvesCertificate& c, Verdict& verdict);

  const std::vector<std::array<u32, 4>>& tets() const { return tets_; }  ///< corners ascending
  const std::vector<TetFace>& faces() const { return faces_; }
  bool special_tet(std::size_t t) const { return special_tet_[t] != 0; }
  bool special_face(std::size_t f) const { return special_face_[f] != 0; }
  /// Place of a face among those with points, kNoTet if it has none.
  u32 listed(std::size_t face) const { return listed_[face]; }
  /// The face with this place.
  u32 face(u32 listed) const { return face_of_[listed]; }
  const std::vector<Box>& boxes(u32 listed) const { return boxes_[listed]; }
  /// The arcs of a tetrahedron.
  std::span<const DegenerateArc> arcs(std::size_t t) const {
    return std::span(c_.arcs).subspan(first_arc_[t], first_arc_[t + 1] - first_arc_[t]);
  }
  /// The listed faces opposite to its corners.
  std::array<u32, 4> around(std::size_t t) const { return around_[t]; }

 private:
  void read_tets(Verdict& verdict);
  void read_faces();
  void read_special();
  void read_points();
  void read_arcs();

  const ModesCurvesCertificate& c_;
  std::vector<std::array<u32, 4>> tets_, around_;
  std::vector<TetFace> faces_;
  std::vector<std::uint8_t> special_tet_, special_face_;
  std::vector<u32> listed_, face_of_;
  std::vector<std::vector<Box>> boxes_;
  std::vector<std::size_t> first_arc_;
};

}  // namespace crest::certify::curves
