// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/provers.hpp"

#include "certify/container/reject.hpp"

namespace crest::certify::smooth {
namespace {

std::string names_of(unsigned open) {
  std::string names;
  const auto add = [&](unsigned bits, const char* name) {
    if ((open & bits) != 0) names += names.empty() ? name : std::string(", ") + name;
  };
  add(kChart, "chart");
  add(kRegular, "S(w) > 0");
  add(kVerdict, "blue verdict");
  add(kVerdict << 1, "red verdict");
  add(kType, "blue type");
  add(kType << 1, "red type");
  add(kApart | kCross, "purple point");
  return names;
}

}  // namespace

unsigned FaceProvers::prove(std::uint32_t face, unsigned open, FaceFindings* findings) {
  constexpr unsigned kBoth = kApart | kCross;
  const Piece whole = Piece::face();
  unsigned ends = 0;
  const bool choice = (open & kBoth) == kBoth;
  const SmoothFaceRecord& record = claim_.certificate.face_records[face];
  const auto no_zero = SmoothFaceRecord::kNoZero;
  if (record.in_patch || (record.verdict[0] == no_zero && record.verdict[1] == no_zero))
    open = cheaply([&](auto& p) { return p.prove(face, whole, open, findings, ends); });
  if (open == 0) return ends;
  open = at_depth(0, [&](auto& p) { return p.prove(face, whole, open, findings, ends); });
  if (!choice) {
    if (open != 0) prove_children(face, whole, 0, open, ends);
    return ends | kCross;
  }
  const unsigned others = open & ~kBoth;
  if (others != 0) prove_children(face, whole, 0, others, ends);
  if ((open & kApart) == 0) return ends;
  if ((open & kCross) == 0) return ends | kCross;
  // On pieces one of the two must hold throughout.
  try {
    prove_children(face, whole, 0, kApart, ends);
    return ends;
  } catch (const Undecided&) {
    prove_children(face, whole, 0, kCross, ends);
    return ends | kCross;
  }
}

void FaceProvers::prove_children(std::uint32_t face, const Piece& piece, int depth, unsigned open,
                                 unsigned& ends) {
  if (depth == kDepth) throw Undecided(fmt::format("face {}: {}", face, names_of(open)));
  for (std::size_t k = 0; k < 4; ++k) {
    const Piece child = piece.child(k);
    const unsigned left = at_depth(depth + 1, [&](auto& p) {
      return p.prove(face, child, open, static_cast<FaceFindings*>(nullptr), ends);
    });
    if (left != 0) prove_children(face, child, depth + 1, left, ends);
  }
}

kernel::MaybeSign FaceProvers::on_segment(const Question& q, const Barycentric& a,
                                          const Barycentric& b) {
  return on_segment(q, a, b, 0);
}

kernel::MaybeSign FaceProvers::on_segment(const Question& q, const Barycentric& a,
                                          const Barycentric& b, int depth) {
  const auto sign = at_depth(depth, [&](auto& p) { return p.sign(q, Piece::segment(a, b)); });
  if (nonzero(sign)) return sign;
  if (depth == kSegmentDepth) return std::nullopt;
  const Barycentric middle = midpoint(a, b);
  const auto first = on_segment(q, a, middle, depth + 1);
  // Both hold at the middle: the signs agree.
  return nonzero(first) && nonzero(on_segment(q, middle, b, depth + 1)) ? first : std::nullopt;
}

kernel::MaybeSign FaceProvers::at_point(const Question& q, const Barycentric& at) {
  const Piece point = Piece::point(at);
  const auto sign = at_depth(0, [&](auto& p) { return p.sign(q, point); });
  if (nonzero(sign) || claim_.arithmetic == Arithmetic::mpfr) return sign;
  return precisely([&](auto& p) { return p.sign(q, point); });
}

}  // namespace crest::certify::smooth
