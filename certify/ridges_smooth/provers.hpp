// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One thread's FaceProvers, and the ladder: order 3 on faces without arcs, order 4 on all others
// and on quarters, order 5 below; MPFR for points that doubles leave open, or for everything.
#include <memory>

#include "certify/container/verdict.hpp"
#include "certify/ridges_smooth/face.hpp"

namespace crest::certify::smooth {

/// What the checks of one claim share.
struct Claim {
  const Surface& surface;
  const RidgesSmoothCertificate& certificate;
  const Mesh& mesh;
  Arithmetic arithmetic;
};

class FaceProvers {
 public:
  explicit FaceProvers(const Claim& claim) : claim_(claim) {}

  /// Calls f with the prover for pieces of this depth.
  template <class F>
  auto at_depth(int depth, F&& f) {
    if (claim_.arithmetic == Arithmetic::mpfr) return f(get(mp_));
    return depth < 2 ? f(get(four_)) : f(get(five_));
  }
  /// With a cheaper type, if there is one.
  template <class F>
  auto cheaply(F&& f) {
    return claim_.arithmetic == Arithmetic::mpfr ? f(get(mp_)) : f(get(three_));
  }
  template <class F>
  auto precisely(F&& f) {
    return f(get(mp_));
  }

  /// Throws Undecided if a statement of `open` is not proven on the face's pieces; of kApart and
  /// kCross, if both are asked, one will do. Returns types that rest on the signs of G_j at the
  /// crossings, and kCross if the purple bit rests on those of E_2.
  unsigned prove(std::uint32_t face, unsigned open, FaceFindings* findings);
  /// The one sign on the segment between two points of the face, if it is certain on its pieces.
  kernel::MaybeSign on_segment(const Question& q, const Barycentric& a, const Barycentric& b);
  kernel::MaybeSign at_point(const Question& q, const Barycentric& at);

 private:
  static constexpr int kDepth = 5, kSegmentDepth = 10;

  template <class M>
  FaceProver<M>& get(std::unique_ptr<FaceProver<M>>& prover) {
    if (!prover) prover = std::make_unique<FaceProver<M>>(claim_.surface, claim_.certificate);
    return *prover;
  }
  void prove_children(std::uint32_t face, const Piece& piece, int depth, unsigned open,
                      unsigned& ends);
  kernel::MaybeSign on_segment(const Question& q, const Barycentric& a, const Barycentric& b,
                               int depth);

  const Claim& claim_;
  std::unique_ptr<FaceProver<Model3>> three_;
  std::unique_ptr<FaceProver<Model4>> four_;
  std::unique_ptr<FaceProver<Model5>> five_;
  std::unique_ptr<FaceProver<MpModel>> mp_;
};

}  // namespace crest::certify::smooth
