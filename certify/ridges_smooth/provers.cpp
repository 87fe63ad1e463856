// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/provers.hpp"

#include "kernel/arithmetic/rational.hpp"

namespace crest::certify::smooth {

using kernel::Rational;

std::string names_of(unsigned statements) {
  constexpr std::array kNames = {"chart",     "S(w) > 0", "blue verdict", "red verdict",
                                 "blue type", "red type", "purple point", "inside the patch"};
  std::string names;
  for (unsigned i = 0; i < kNames.size(); ++i)
    if ((statements >> i & 1U) != 0) names += (names.empty() ? "" : ", ") + std::string(kNames[i]);
  return names;
}

bool is_inside(const SmoothPatchRecord& p, const std::array<kernel::Range, 3>& box) {
  const Rational most = Rational(p.radius) - 2 * Rational(p.rho);
  for (std::size_t d = 0; d < 2; ++d) {
    const kernel::Range& x = box[(p.axis + 1 + d) % 3];
    if (!std::isfinite(x.low) || !std::isfinite(x.high)) return false;
    const Rational z(p.centre[d]);
    if (!(Rational(x.high) - z < most && z - Rational(x.low) < most)) return false;
  }
  return box[p.axis].low > p.height[0] && box[p.axis].high < p.height[1];
}

namespace {

/// What the first node of a face's division says, if there is one.
std::optional<bool> steep_in(const SmoothFaceRecord& record, bool implicit) {
  std::size_t at = implicit ? 1 : 0;
  if (record.type[0] != 0 || record.type[1] != 0) ++at;
  for (const auto verdict : record.verdict) at += verdict != SmoothFaceRecord::kNoZero ? 1 : 0;
  if (at >= record.witness.size()) return std::nullopt;
  return (record.witness[at] & DivisionNode::kSteep) != 0;
}

}  // namespace

// Here, since every file that makes or destroys provers would compile those of all orders.
FaceProvers::FaceProvers(const Claim& claim) : claim_(claim) {}
FaceProvers::~FaceProvers() = default;

template <class M>
FaceProver<M>& FaceProvers::get(std::unique_ptr<FaceProver<M>>& prover) {
  if (!prover) prover = std::make_unique<FaceProver<M>>(claim_.surface, claim_.certificate);
  return *prover;
}
template FaceProver<Model3>& FaceProvers::get(std::unique_ptr<FaceProver<Model3>>&);
template FaceProver<Model4>& FaceProvers::get(std::unique_ptr<FaceProver<Model4>>&);
template FaceProver<Model5>& FaceProvers::get(std::unique_ptr<FaceProver<Model5>>&);
template FaceProver<MpModel3>& FaceProvers::get(std::unique_ptr<FaceProver<MpModel3>>&);
template FaceProver<MpModel4>& FaceProvers::get(std::unique_ptr<FaceProver<MpModel4>>&);
template FaceProver<MpModel5>& FaceProvers::get(std::unique_ptr<FaceProver<MpModel5>>&);

void FaceProvers::prepare(std::uint32_t first, std::uint32_t last, bool has_witnesses) {
  if (claim_.arithmetic == Arithmetic::mpfr) return;
  const RidgesSmoothCertificate& c = claim_.certificate;
  std::vector<std::uint32_t> plain, with_ridges;
  for (std::uint32_t f = first; f < last; ++f) {
    const SmoothFaceRecord& record = c.face_records[f];
    if (record.in_patch || (!c.lifts.empty() && c.lifts[f] != 0)) continue;
    const auto no_zero = SmoothFaceRecord::kNoZero;
    const bool is_plain = record.verdict[0] == no_zero && record.verdict[1] == no_zero;
    (is_plain ? plain : with_ridges).push_back(f);
  }
  prepare<3, 0>(lanes_three_, three_, plain, has_witnesses);
  prepare<4, 1>(lanes_four_, four_, with_ridges, has_witnesses);
}

template <int Order, int K>
void FaceProvers::prepare(std::unique_ptr<FaceLanes<Order, K>>& lanes,
                          std::unique_ptr<FaceProver<kernel::TaylorModel<Order>>>& prover,
                          const std::vector<std::uint32_t>& faces, bool has_witnesses) {
  using Lanes = FaceLanes<Order, K>;
  constexpr std::size_t kWorthwhile = 3;  // fewer cost less alone
  if (!lanes) lanes = std::make_unique<Lanes>(claim_.surface, claim_.certificate);
  std::vector<typename Lanes::Values> all;
  for (std::size_t i = 0; i + kWorthwhile <= faces.size(); i += Lanes::kCount) {
    const auto group = std::span(faces).subspan(i, std::min(Lanes::kCount, faces.size() - i));
    std::vector<std::optional<bool>> steep;
    for (const std::uint32_t f : group)
      steep.push_back(has_witnesses
                          ? steep_in(claim_.certificate.face_records[f], claim_.surface.implicit)
                          : std::nullopt);
    for (auto& values : lanes->evaluate(group, steep)) all.push_back(std::move(values));
  }
  get(prover).prepare(std::move(all));
}

unsigned FaceProvers::left_open(std::uint32_t face, const Piece& piece, unsigned here,
                                Method& method, int order, FaceFindings* findings,
                                Advisor* advisor) {
  FaceFindings own;
  if (findings == nullptr && (here & kInside) != 0) findings = &own;
  const unsigned left = at_order(
      order, [&](auto& p) { return p.prove(face, piece, here, method, findings, advisor); });
  if ((left & kInside) == 0 || !findings->box) return left;
  const auto& patch = claim_.certificate.patches[claim_.mesh.patch_of[face]];
  return is_inside(patch, *findings->box) ? left & ~static_cast<unsigned>(kInside) : left;
}

void FaceProvers::prove(std::uint32_t face, const Piece& piece, unsigned open, Method method,
                        WitnessReader& in, FaceFindings* findings, int depth) {
  const DivisionNode node(in, depth, DivisionNode::kDepth);
  in.check(node.functional() <= 1, "says what no piece has");
  const unsigned here = node.divided() ? in.byte() : open;
  in.check((here & ~open) == 0 && !(node.divided() && here == open),
           "names other statements than those open");
  method.steep = node.steep();
  if ((here & kPurple) != 0 && !method.cross) {
    method.combination[0] = in.f32();
    method.combination[1] = in.f32();
  }
  if (here != 0 || findings != nullptr) {
    unsigned left = left_open(face, piece, here, method, node.order(), findings);
    if (left != 0 && further(piece, [&](const Piece& part) {
          return left_open(face, part, left, method, node.order(), nullptr) == 0;
        }))
      left = 0;
    if (left != 0) in.fail(names_of(left));
  }
  for (std::size_t k = 0; node.divided() && k < 4; ++k)
    prove(face, piece.child(k), open & ~here, method, in, nullptr, depth + 1);
}

kernel::Sign FaceProvers::on_segment(const Question& q, const Barycentric& a, const Barycentric& b,
                                     WitnessReader& in, int depth) {
  const DivisionNode node(in, depth, DivisionNode::kSegmentDepth);
  in.check(node.functional() == 0, "says what no segment has");
  if (node.divided()) {
    const Barycentric middle = midpoint(a, b);
    const kernel::Sign first = on_segment(q, a, middle, in, depth + 1);
    // Both hold at the middle: the signs agree.
    on_segment(q, middle, b, in, depth + 1);
    return first;
  }
  kernel::MaybeSign sign;
  const auto is_certain = [&](const Piece& part) {
    sign = at_order(node.order(), [&](auto& p) { return p.sign(q, part); });
    return nonzero(sign);
  };
  if (!further(Piece::segment(a, b), is_certain))
    in.fail(fmt::format("crossings of edge {}", q.edge));
  return *sign;
}

kernel::MaybeSign FaceProvers::in_parts(const Question& q, const Barycentric& a,
                                        const Barycentric& b) {
  if (claim_.arithmetic != Arithmetic::mpfr) return std::nullopt;
  kernel::MaybeSign sign;
  const auto is_certain = [&](const Piece& part) {
    sign = precisely([&](auto& p) { return p.sign(q, part); });
    return nonzero(sign);
  };
  return further(Piece::segment(a, b), is_certain) ? sign : std::nullopt;
}

kernel::MaybeSign FaceProvers::at_point(const Question& q, const Barycentric& at) {
  const Piece point = Piece::point(at);
  const auto sign = at_order(4, [&](auto& p) { return p.sign(q, point); });
  if (nonzero(sign) || claim_.arithmetic == Arithmetic::mpfr) return sign;
  return precisely([&](auto& p) { return p.sign(q, point); });
}

}  // namespace crest::certify::smooth
