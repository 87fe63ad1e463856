// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/faces.hpp"

#include <algorithm>

#include "certify/second/crossings.hpp"

namespace crest::recheck {
namespace {

constexpr unsigned kChart = 1, kDefinite = 2, kPurple = 64, kInPatch = 128;
constexpr std::array<unsigned, 2> kVerdict = {4, 8}, kType = {16, 32};
constexpr int kNone = 255;

/// A node of a division with statements.
struct Node {
  int order;
  unsigned statements;
  bool steep;
  std::array<double, 2> combination;
};

/// Interior of z + [-(R - 2 rho), R - 2 rho]^2.
bool inside(const PatchRecord& p, const Interval& x, std::size_t d) {
  const Interval z(p.z[d]), r = Interval(p.r) - Interval(2 * p.rho);
  return x.inside((z - r).upper(), (z + r).lower());
}
void require_in_patch(const PatchRecord& p, const Vector<Model>& x) {
  const auto axis = static_cast<Index>(p.axis);
  require(inside(p, x[(axis + 1) % 3].range(), 0) && inside(p, x[(axis + 2) % 3].range(), 1) &&
              x[axis].range().inside(p.m[0], p.m[1]),
          "patch, 1: the image lies in it");
}
/// Kind 1: the corners, after one shift by integers.
void require_in_patch(const Problem& problem, const PatchRecord& p, Index face) {
  for (std::size_t d = 0; d < 2; ++d) {
    bool found = false;
    for (const int shift : {-2, -1, 0, 1, 2}) {
      if (shift != 0 && !problem.certificate.periodic[d]) continue;
      bool all = true;
      for (Index k = 0; k < 3; ++k)
        all = all && inside(p, Interval(problem.lifted(face, k, d)) + Interval(shift), d);
      found = found || all;
    }
    require(found, "patch, 1: the image lies in it");
  }
}

class FaceProof {
 public:
  FaceProof(const Problem& problem, const LooseCorners& loose, Index face)
      : problem_(problem),
        record_(problem.certificate.records[face]),
        face_(face),
        sampler_(problem, face),
        in_(problem.certificate.strings[face].data(), problem.certificate.strings[face].size(),
            "face " + std::to_string(face)) {
    for (std::size_t j = 0; j < 2; ++j)
      for (Index k = 0; k < 3; ++k)
        is_loose_[j][k] = !record_.in_patch && loose.at(j, problem.certificate.faces[face][k]);
  }

  FaceOutcome outside() {
    read_head();
    unsigned open = kDefinite | kVerdict[0] | kVerdict[1];
    if (implicit()) open |= kChart;
    for (std::size_t j = 0; j < 2; ++j)
      if (record_.type[j] != 0) open |= kType[j];
    if (both_types()) open |= kPurple;
    corners();
    division(Piece::face(), open, 0);
    for (std::size_t j = 0; j < 2; ++j)
      for (Index k = 0; k < 3; ++k)
        if (outcome_.decided[j][k]) side(j, k);
    Crossings crossings(problem_, face_, in_, outcome_, is_loose_);
    for (std::size_t j = 0; j < 2; ++j) crossings.type(j, by_turn(j));
    crossings.purple(by_cross());
    in_.finish();
    return outcome_;
  }

  FaceOutcome in_patch() {
    if (implicit()) {
      outcome_.c = in_.u8();
      division(Piece::face(), kChart | kInPatch, 0);
    } else {
      require_in_patch(problem_, patch(), face_);
    }
    in_.finish();
    return outcome_;
  }

 private:
  const PatchRecord& patch() const {
    return problem_.certificate.patches[problem_.complex.patch_of[face_]];
  }
  bool implicit() const { return problem_.surface.implicit(); }
  bool both_types() const { return record_.type[0] != 0 && record_.type[1] != 0; }
  bool by_turn(std::size_t colour) const { return (methods_ >> colour & 1) != 0; }
  bool by_cross() const { return (methods_ & 4) != 0; }

  void read_head();

  /// A division with statements (root: gives the order of pieces that are not divided).
  void division(const Piece& piece, unsigned open, int depth) {
    const unsigned byte = in_.u8();
    Node node = {order_of(in_, byte, 4 | 8), open, (byte & 8) != 0, {}};
    if (depth == 0) outcome_.order = node.order;
    const bool divided = (byte & 4) != 0;
    if (divided) node.statements = in_.u8();
    if ((node.statements & ~open) != 0) in_.fail("a statement is shown that is not open");
    if ((node.statements & kPurple) != 0 && !by_cross()) node.combination = {in_.f32(), in_.f32()};
    if (node.statements != 0) shown<Piece>(piece, kFurther, [&](const Piece& p) { show(p, node); });
    if (!divided) return;
    if (depth == kTriangleDepth) in_.fail("a division is deeper than 8");
    for (const Piece& child : piece.children()) division(child, open & ~node.statements, depth + 1);
  }

  void show(const Piece& piece, const Node& node);
  void enlarge_image(const Vector<Model>& x) {
    std::array<Interval, 3> box;
    for (Index k = 0; k < 3; ++k) box[k] = x[k].range();
    if (!outcome_.image) outcome_.image = box;
    for (Index k = 0; k < 3; ++k) (*outcome_.image)[k] = hull((*outcome_.image)[k], box[k]);
  }

  void no_zero(const Sample<>& s, const Direction<Model>& v) const {
    const Scope scope(0);
    require(extremality(s.forms, v)[0].sign() != 0, "the verdict: E_j has no zero");
  }
  void monotone(const Sample<>& s, std::size_t j) const {
    const auto c = direction(record_.verdict[j]);
    require((scaled(s.e[j][1], c[0]) + scaled(s.e[j][2], c[1])).sign() != 0,
            "the verdict: c . grad E_j has no zero");
  }

  void corners() {
    for (Index k = 0; k < 3; ++k) {
      unsigned wanted = 0;
      for (std::size_t j = 0; j < 2; ++j)
        if (record_.verdict[j] != kNone && !is_loose_[j][k]) wanted |= 1U << j;
      if (wanted == 0) continue;
      const auto signs = sampler_.signs_at(unit_corner(k), outcome_.c, wanted);
      for (std::size_t j = 0; j < 2; ++j) outcome_.sign[j][k] = signs[j];
    }
    for (std::size_t j = 0; j < 2; ++j)
      for (Index k = 0; k < 3; ++k)
        if (is_loose_[j][k] && record_.verdict[j] != kNone) outcome_.sign[j][k] = 1;
  }

  void side(std::size_t j, Index k) {
    const Piece whole = Piece::segment(unit_corner(k), unit_corner(k + 1));
    const Scope scope;
    context.order = outcome_.order;
    if (!divided_[j]) return side_piece(whole, j, k);
    read_division(in_, whole, kSegmentDepth, 0,
                  [&](const Piece& p, unsigned) { side_piece(p, j, k); });
  }
  void side_piece(const Piece& piece, std::size_t j, Index k);

  const Problem& problem_;
  const FaceRecord& record_;
  Index face_;
  Sampler sampler_;
  Reader in_;
  BySide<bool> is_loose_{}, by_value_{};
  std::array<bool, 2> divided_{};
  unsigned methods_ = 0;
  FaceOutcome outcome_;
};

void FaceProof::read_head() {
  if (implicit()) outcome_.c = in_.u8();
  if (record_.type[0] != 0 || record_.type[1] != 0) methods_ = in_.u8();
  const unsigned possible = (record_.type[0] != 0 ? 1U : 0U) | (record_.type[1] != 0 ? 2U : 0U) |
                            (both_types() ? 4U : 0U);
  if ((methods_ & ~possible) != 0) in_.fail("methods of what is not there");
  for (std::size_t j = 0; j < 2; ++j) {
    if (record_.verdict[j] == kNone) continue;
    const unsigned bits = in_.u8();
    divided_[j] = (bits & 64) != 0;
    if ((bits & 128) != 0 || (divided_[j] && (bits & 7) == 0) || (bits >> 3 & ~bits & 7) != 0)
      in_.fail("unknown bits of its edges");
    for (Index k = 0; k < 3; ++k) {
      outcome_.decided[j][k] = (bits >> k & 1) != 0;
      by_value_[j][k] = (bits >> (3 + k) & 1) != 0;
    }
  }
}

void FaceProof::show(const Piece& piece, const Node& node) {
  const Scope scope;
  context.order = node.order;
  const auto has = [&](unsigned statement) { return (node.statements & statement) != 0; };
  unsigned wanted = has(kPurple) ? 3 : 0;
  int jet_order = has(kPurple) && by_cross() ? 1 : 0;
  for (std::size_t j = 0; j < 2; ++j) {
    const bool turn = has(kType[j]) && by_turn(j);
    if (!has(kType[j]) && !(has(kVerdict[j]) && record_.verdict[j] != kNone)) continue;
    wanted |= 1U << j;
    jet_order = std::max(jet_order, turn ? 2 : 1);
  }
  const Sample<> s = has(~(kChart | kInPatch))
                         ? sampler_.forms(piece, outcome_.c, jet_order, wanted)
                         : sampler_.foot(piece, outcome_.c);
  if (has(kChart)) {
    sampler_.require_orientation(s);
    enlarge_image(s.foot.x);
  }
  if (has(kInPatch)) require_in_patch(patch(), s.foot.x);
  std::optional<std::array<Direction<Model>, 2>> rootless;
  for (std::size_t j = 0; j < 2; ++j) {
    if (has(kVerdict[j])) {
      if (record_.verdict[j] != kNone) {
        monotone(s, j);
      } else {
        if (!rootless) rootless = rootless_directions(s.a, node.steep);
        no_zero(s, (*rootless)[j]);
      }
    }
    if (!has(kType[j])) continue;
    const int expected = record_.type[j] == (j == 0 ? kElliptic : kHyperbolic) ? -1 : 1;
    require(by_turn(j) ? s.turn[j].sign() != 0 : s.growth[j].sign() == expected,
            "the type: G_j, or the determinant");
  }
  if (!has(kPurple)) return;
  const Model purple =
      by_cross() ? s.e[0][1] * s.e[1][2] - s.e[0][2] * s.e[1][1]
                 : Model(node.combination[0]) * s.e[0][0] + Model(node.combination[1]) * s.e[1][0];
  require(purple.sign() != 0, "purple: the combination, or the determinant");
}

void FaceProof::side_piece(const Piece& piece, std::size_t j, Index k) {
  shown<Piece>(piece, 2 * kFurther, [&](const Piece& p) {
    if (by_value_[j][k]) {
      require(sampler_.forms(p, outcome_.c, 0, 1U << j).e[j][0].sign() != 0,
              "an edge: E_j has no zero");
      return;
    }
    const Sample<> s = sampler_.forms(p, outcome_.c, 1, 1U << j);
    const auto d = sampler_.along(s, k);
    const int sign = (d[0] * s.e[j][1] + d[1] * s.e[j][2]).sign();
    require(sign != 0, "an edge: the derivative of E_j along it has no zero");
    outcome_.slope[j][k] = sign;
  });
}

}  // namespace

LooseCorners::LooseCorners(const Problem& problem) {
  const Certificate& c = problem.certificate;
  if (c.loose != 0 && (c.implicit || c.periodic[0] || c.periodic[1]))
    throw Rejected("loose corners where there are none");
  for (std::size_t j = 0; j < 2; ++j)
    for (unsigned k = 0; k < 4; ++k) {
      if ((c.loose >> (4 * j + k) & 1) == 0) continue;
      const double u = k % 2, v = k / 2;
      const auto found = std::find_if(c.vertices.begin(), c.vertices.end(),
                                      [&](const auto& x) { return x[0] == u && x[1] == v; });
      if (found == c.vertices.end()) throw Rejected("a loose corner is no vertex");
      vertices_[j].push_back(static_cast<std::uint32_t>(found - c.vertices.begin()));
    }
}
bool LooseCorners::at(std::size_t colour, std::uint32_t vertex) const {
  const auto& all = vertices_[colour];
  return std::find(all.begin(), all.end(), vertex) != all.end();
}

FaceOutcome check_face(const Problem& problem, const LooseCorners& loose, Index face) {
  const Scope scope;
  FaceProof proof(problem, loose, face);
  return problem.certificate.records[face].in_patch ? proof.in_patch() : proof.outside();
}

}  // namespace crest::recheck
