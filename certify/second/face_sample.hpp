// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a face's statements are shown with: the foot, the forms and E_j over one of its pieces.
#include "certify/second/chart.hpp"
#include "certify/second/vectors.hpp"

namespace crest::recheck {

template <class T = Model>
struct Sample {
  Fibre<T> fibre;      ///< kind 0
  Foot<T> foot;        ///< kind 0
  Vector<T> gradient;  ///< kind 0: of F, in the frame
  Forms<T> forms;
  Operator<T> a;
  std::array<Jet2<T>, 2> e;
  std::array<T, 2> growth;  ///< G_j
  std::array<T, 2> turn;    ///< det(grad E_j, grad G_j)
};

/// Of one face outside patches, or the foot alone of any.
class Sampler {
 public:
  Sampler(const Problem& problem, Index face)
      : problem_(problem), record_(problem.certificate.records[face]), face_(face) {}

  /// Over a piece: (F), and what follows from it.
  template <class T = Model>
  Sample<T> foot(const Piece& piece, int c) const;
  /// Over a piece: (F), (R), forms with jets of this degree, and the E_j of bit j of `wanted`; G_j
  /// from degree 1, its determinant from 2.
  template <class T = Model>
  Sample<T> forms(const Piece& piece, int c, int jet_order, unsigned wanted) const;
  /// Kind 0: (J).
  void require_orientation(const Sample<>& s) const;
  /// The certain signs of the E_j of `wanted` at a point.
  std::array<int, 2> signs_at(const Barycentric& l, int c, unsigned wanted) const;
  /// The vector of side k in coordinates.
  std::array<Model, 2> along(const Sample<>& s, Index k) const;

 private:
  const Problem& problem_;
  const FaceRecord& record_;
  Index face_;
};

/// Vectors along v1 and v2, of degree 0 (SPEC.md, "E_j for verdict 255").
std::array<Direction<Model>, 2> rootless_directions(const Operator<Model>& a, bool steep);

}  // namespace crest::recheck
