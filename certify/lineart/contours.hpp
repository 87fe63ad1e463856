// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The drawn edges of the data, all that happens on them and what is in front (SPEC.md, steps 2 to
// 4), found without a look at the claim.
#include <memory>

#include "certify/lineart/boxes.hpp"
#include "certify/lineart/orientation.hpp"

namespace crest::certify {

/// An edge of faces.
struct SceneEdge {
  std::uint32_t low, high;
  bool occluding;  ///< L != R
  bool rim;        ///< L = R, L0 != R0
  bool crease;     ///< listed
};

/// A place strictly inside an edge, of the limit t.
struct LineBreak {
  kernel::Rational t;
  std::vector<LineEvent> events;
};

/// What the checker finds on a drawn edge.
struct FoundEdge {
  SceneEdge edge;
  bool end_on = false;
  std::vector<LineBreak> breaks;
  std::vector<LinePiece> pieces;
  bool busy_low = false, busy_high = false;  ///< events whose limits are the ends
};

class Contours {
 public:
  /// Requires: the data are what step 1 asks for.
  explicit Contours(const LineArtCertificate& c);
  ~Contours();

  /// The edges that are drawn, ascending.
  const std::vector<SceneEdge>& drawn() const { return drawn_; }
  /// Cost: the faces and occluding edges whose boxes in the picture meet the edge's.
  FoundEdge find(const SceneEdge& edge) const;
  std::size_t occluding() const { return occluding_.size(); }
  std::uint64_t symbolic() const { return o_.symbolic(); }

 private:
  struct Candidate;
  void collect_edges();
  void add_crossings(EdgeEnds ends, const PlaneBox& box, std::vector<Candidate>& found) const;
  void add_face_events(EdgeEnds ends, const PlaneBox& box, std::vector<Candidate>& found,
                       std::vector<std::uint32_t>& touching) const;
  bool touches(std::uint32_t face, EdgeEnds ends) const;
  std::optional<bool> in_front(std::uint32_t face, EdgeEnds ends, const EdgePoint& at) const;
  LinePiece count(EdgeEnds ends, const PlaneBox& box, const std::vector<std::uint32_t>& touching,
                  const kernel::Rational& from, const kernel::Rational& to) const;

  const LineArtCertificate& c_;
  Orientation o_;
  std::vector<kernel::Sign> face_side_, plain_side_;  // [e, a, b, c] of face a b c
  std::vector<SceneEdge> drawn_, occluding_;
  std::vector<PlaneBox> vertex_box_;
  std::unique_ptr<BoxTree> faces_, occluders_;
};

}  // namespace crest::certify
