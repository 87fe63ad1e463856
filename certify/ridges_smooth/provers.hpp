// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One thread's FaceProvers: statements shown on the pieces that a witness divides a face into
// (SPEC.md, "Witnesses"), each with models of the order that it says; MPFR for points that doubles
// leave open, or for everything: its models are not those that the witness was made with, so it may
// divide pieces further.
#include <memory>

#include "certify/container/verdict.hpp"
#include "certify/ridges_smooth/face.hpp"
#include "certify/ridges_smooth/face_lanes.hpp"
#include "certify/ridges_smooth/witness.hpp"

namespace crest::certify::smooth {

/// What the checks of one claim share.
struct Claim {
  const Surface& surface;
  const RidgesSmoothCertificate& certificate;
  const Mesh& mesh;
  Arithmetic arithmetic;
};

/// The bits of a division's node: the order less 3, children; by use a functional, or steep.
struct DivisionNode {
  static constexpr unsigned kDivided = 4, kSteep = 8;
  static constexpr int kDepth = 8, kSegmentDepth = 12;

  DivisionNode(WitnessReader& in, int depth, int deepest) : bits(in.byte()) {
    in.check(order() <= 5, "names no such order");
    in.check(!divided() || depth < deepest, "divides too often");
  }
  int order() const { return static_cast<int>(bits & 3U) + 3; }
  bool divided() const { return (bits & kDivided) != 0; }
  bool steep() const { return (bits & kSteep) != 0; }
  unsigned functional() const { return bits >> 3; }

  unsigned bits;
};

/// Item 1 of "Patches", of an enclosure of points of S.
bool is_inside(const SmoothPatchRecord& patch, const std::array<kernel::Range, 3>& box);

class FaceProvers {
 public:
  explicit FaceProvers(const Claim& claim);
  ~FaceProvers();

  /// Calls f with the prover of this order.
  template <class F>
  auto at_order(int order, F&& f) {
    if (claim_.arithmetic == Arithmetic::mpfr)
      return order == 3 ? f(get(mp_three_)) : order == 4 ? f(get(mp_four_)) : f(get(mp_five_));
    return order == 3 ? f(get(three_)) : order == 4 ? f(get(four_)) : f(get(five_));
  }
  template <class F>
  auto precisely(F&& f) {
    return f(get(mp_four_));
  }

  /// Evaluates what whole faces need, several at a time; they are asked about next. The methods are
  /// those of their witnesses, or, if these are still to be made, what suits them.
  void prepare(std::uint32_t first, std::uint32_t last, bool has_witnesses);
  static constexpr std::uint32_t kTogether = 64;  ///< faces to prepare at once

  /// Shows `open` on the face as a division with statements says; `findings` on the whole face.
  /// Throws Undecided.
  void prove(std::uint32_t face, unsigned open, Method method, WitnessReader& in,
             FaceFindings& findings) {
    prove(face, Piece::face(), open, method, in, &findings, 0);
  }
  /// Those of the statements `here` that the piece does not show with models of this order.
  unsigned left_open(std::uint32_t face, const Piece& piece, unsigned here, Method& method,
                     int order, FaceFindings* findings, Advisor* advisor = nullptr);
  /// Does proves(prover, piece, functional) hold on all pieces of a plain division?
  template <class Proves>
  bool on_pieces(const Piece& piece, WitnessReader& in, const Proves& proves, int depth = 0) {
    const DivisionNode node(in, depth, DivisionNode::kDepth);
    if (!node.divided())
      return further(piece, [&](const Piece& part) {
        return at_order(node.order(), [&](auto& p) { return proves(p, part, node.functional()); });
      });
    in.check(node.functional() == 0, "says more of a piece that is divided");
    for (std::size_t k = 0; k < 4; ++k)
      if (!on_pieces(piece.child(k), in, proves, depth + 1)) return false;
    return true;
  }
  /// The one sign on the segment between two points of the face. Throws Undecided.
  kernel::Sign on_segment(const Question& q, const Barycentric& a, const Barycentric& b,
                          WitnessReader& in, int depth = 0);
  /// MPFR: the one sign on the segment, shown on parts of it; else nothing.
  kernel::MaybeSign in_parts(const Question& q, const Barycentric& a, const Barycentric& b);
  /// If it is certain.
  kernel::MaybeSign at_point(const Question& q, const Barycentric& at);

 private:
  /// Does f hold on the piece, or (MPFR) on parts of it?
  template <class F>
  bool further(const Piece& piece, const F& f, int depth = 0) {
    if (f(piece)) return true;
    if (claim_.arithmetic != Arithmetic::mpfr || depth == kFurther) return false;
    for (std::size_t k = 0; k < 4; ++k)
      if (!further(piece.child(k), f, depth + 1)) return false;
    return true;
  }
  static constexpr int kFurther = 4;

  template <class M>
  FaceProver<M>& get(std::unique_ptr<FaceProver<M>>& prover);
  void prove(std::uint32_t face, const Piece& piece, unsigned open, Method method,
             WitnessReader& in, FaceFindings* findings, int depth);
  /// Whole faces by models of one order.
  template <int Order, int K>
  void prepare(std::unique_ptr<FaceLanes<Order, K>>& lanes,
               std::unique_ptr<FaceProver<kernel::TaylorModel<Order>>>& prover,
               const std::vector<std::uint32_t>& faces, bool has_witnesses);

  const Claim& claim_;
  std::unique_ptr<FaceProver<Model3>> three_;
  std::unique_ptr<FaceProver<Model4>> four_;
  std::unique_ptr<FaceProver<Model5>> five_;
  std::unique_ptr<FaceLanes<3, 0>> lanes_three_;
  std::unique_ptr<FaceLanes<4, 1>> lanes_four_;
  std::unique_ptr<FaceProver<MpModel3>> mp_three_;
  std::unique_ptr<FaceProver<MpModel4>> mp_four_;
  std::unique_ptr<FaceProver<MpModel5>> mp_five_;
};

/// "chart, blue verdict" and the like.
std::string names_of(unsigned statements);

}  // namespace crest::certify::smooth
