// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/faces.hpp"

#include <algorithm>
#include <cmath>

#include "certify/second/vectors.hpp"

namespace crest::recheck {
namespace {

constexpr unsigned kChart = 1, kDefinite = 2, kPurple = 64, kInPatch = 128;
constexpr std::array<unsigned, 2> kVerdict = {4, 8}, kType = {16, 32};
constexpr int kNone = 255, kElliptic = 1, kHyperbolic = 2, kTurning = 3;
/// Newton steps at a point, where the fibre's zero is wanted to the last bit.
constexpr int kSharp = 6;

/// A node of a division with statements.
struct Node {
  int order;
  unsigned statements;
  bool steep;
  std::array<double, 2> combination;
};

/// The surface over a piece, and E_j.
struct Sample {
  Fibre fibre;
  Foot foot;
  Vector gradient;  ///< kind 0: of F, in the frame
  Forms forms;
  Operator a;
  std::array<Jet2, 2> e;
  std::array<Model, 2> growth;
};

class FaceProof {
 public:
  FaceProof(const Problem& problem, const LooseCorners& loose, Index face)
      : problem_(problem),
        record_(problem.certificate.records[face]),
        face_(face),
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
    for (std::size_t j = 0; j < 2; ++j) type(j);
    purple();
    in_.finish();
    return outcome_;
  }

  FaceOutcome in_patch() {
    const PatchRecord& patch = problem_.certificate.patches[problem_.complex.patch_of[face_]];
    if (implicit()) {
      outcome_.c = in_.u8();
      division(Piece::face(), kChart | kInPatch, 0);
    } else {
      corners_in(patch);
    }
    in_.finish();
    return outcome_;
  }

 private:
  bool implicit() const { return problem_.surface.implicit(); }
  bool both_types() const { return record_.type[0] != 0 && record_.type[1] != 0; }
  bool by_turn(std::size_t colour) const { return (methods_ >> colour & 1) != 0; }
  bool by_cross() const { return (methods_ & 4) != 0; }

  void read_head() {
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

  /// Forms on a piece after (F) and (R), with E_j of the colours in `wanted` and their derivatives.
  Sample sample(const Piece& piece, int jet_order, unsigned wanted, bool forms = true) {
    Sample s;
    if (implicit()) {
      s.fibre = problem_.fibre(face_, piece, outcome_.c);
      s.foot = problem_.surface.foot(s.fibre, piece.is_point() ? kSharp : 0);
    }
    if (!forms) return s;
    const Scope scope(jet_order);
    if (implicit()) {
      const Jet3 f = problem_.surface.expand(s.foot.x, frame(), jet_degree());
      s.gradient = {f[1], f[2], f[3]};
      s.forms = problem_.surface.forms(f, 1);
    } else {
      const auto uv = problem_.unit(face_, piece);
      s.forms = problem_.surface.forms(uv[0], uv[1]);
    }
    s.a = operator_of(s.forms);
    const auto w = direction(record_.w);
    require(definite(s.forms, s.a, w).sign() > 0, "(R): S(w) > 0");
    if (wanted == 0) return s;
    const auto v = directions(s.forms.i, s.a, w);
    for (std::size_t j = 0; j < 2; ++j) {
      if ((wanted >> j & 1) == 0) continue;
      s.e[j] = extremality(s.forms, v[j]);
      s.growth[j] = v[j][0][0] * s.e[j][1] + v[j][1][0] * s.e[j][2];
      if (jet_order == 2) turn(s, j, v[j]);
    }
    return s;
  }

  Frame frame() const { return frame_of(record_.frame); }

  /// det(grad E_j, grad G_j) in the place of G_j, as only its sign is asked.
  static void turn(Sample& s, std::size_t j, const Direction& v) {
    const Scope scope(1);
    const Jet2 g = v[0].cut() * s.e[j].derivative(0) + v[1].cut() * s.e[j].derivative(1);
    s.growth[j] = s.e[j][1] * g[2] - s.e[j][2] * g[1];
  }

  void show(const Piece& piece, const Node& node) {
    const Scope scope;
    context.order = node.order;
    unsigned wanted = 0;
    int jet_order = 0;
    for (std::size_t j = 0; j < 2; ++j) {
      const bool gradient = (node.statements & kVerdict[j]) != 0 && record_.verdict[j] != kNone;
      const bool type = (node.statements & kType[j]) != 0;
      if (gradient || type) wanted |= 1U << j;
      if (gradient || type) jet_order = std::max(jet_order, type && by_turn(j) ? 2 : 1);
    }
    if ((node.statements & kPurple) != 0) {
      wanted = 3;
      if (by_cross()) jet_order = std::max(jet_order, 1);
    }
    const Sample s =
        sample(piece, jet_order, wanted, (node.statements & ~(kChart | kInPatch)) != 0);
    if ((node.statements & kChart) != 0) problem_.require_orientation(face_, s.fibre, s.foot.s);
    if ((node.statements & kInPatch) != 0) image_in_patch(s.foot.x);
    for (std::size_t j = 0; j < 2; ++j) {
      if ((node.statements & kVerdict[j]) != 0) verdict(s, j, node.steep);
      if ((node.statements & kType[j]) != 0) {
        const int expected = record_.type[j] == (j == 0 ? kElliptic : kHyperbolic) ? -1 : 1;
        const int sign = s.growth[j].sign();
        require(by_turn(j) ? sign != 0 : sign == expected, "the type: G_j, or the determinant");
      }
    }
    if ((node.statements & kPurple) == 0) return;
    const Model purple = by_cross() ? s.e[0][1] * s.e[1][2] - s.e[0][2] * s.e[1][1]
                                    : Model(node.combination[0]) * s.e[0][0] +
                                          Model(node.combination[1]) * s.e[1][0];
    require(purple.sign() != 0, "purple: the combination, or the determinant");
  }

  void verdict(const Sample& s, std::size_t j, bool steep) const {
    if (record_.verdict[j] != kNone) {
      const auto c = direction(record_.verdict[j]);
      require((scaled(s.e[j][1], c[0]) + scaled(s.e[j][2], c[1])).sign() != 0,
              "the verdict: c . grad E_j");
      return;
    }
    const Scope scope(0);
    const Jet2 a11 = s.a.a11.cut(), a12 = s.a.a12.cut(), a21 = s.a.a21.cut(), one(1.0);
    const Jet2 sigma = root({a11, a12, a21});
    const Jet2 q = inverse(steep ? sigma - a11 : sigma + a11);
    const Direction v = j == 0 ? (steep ? Direction{a12 * q, one} : Direction{one, a21 * q})
                               : (steep ? Direction{one, -(a21 * q)} : Direction{-(a12 * q), one});
    require(extremality(s.forms, v)[0].sign() != 0, "the verdict: E_j has no zero");
  }

  /// Interior of z + [-(R - 2 rho), R - 2 rho]^2.
  static bool inside(const PatchRecord& p, const Interval& x, std::size_t d) {
    const Interval z(p.z[d]), r = Interval(p.r) - Interval(2 * p.rho);
    return x.inside((z - r).upper(), (z + r).lower());
  }
  void image_in_patch(const Vector& x) const {
    const PatchRecord& p = problem_.certificate.patches[problem_.complex.patch_of[face_]];
    const auto axis = static_cast<Index>(p.axis);
    require(inside(p, x[(axis + 1) % 3].range(), 0) && inside(p, x[(axis + 2) % 3].range(), 1) &&
                x[axis].range().inside(p.m[0], p.m[1]),
            "patch, 1: the image lies in it");
  }
  /// Kind 1: after one shift by integers.
  void corners_in(const PatchRecord& p) const {
    for (std::size_t d = 0; d < 2; ++d) {
      bool found = false;
      for (const int shift : {-2, -1, 0, 1, 2}) {
        if (shift != 0 && !problem_.certificate.periodic[d]) continue;
        bool all = true;
        for (Index k = 0; k < 3; ++k) {
          const Float x = problem_.lifted(face_, k, d);
          all = all && inside(p, Interval(x, x) + Interval(shift), d);
        }
        found = found || all;
      }
      require(found, "patch, 1: the image lies in it");
    }
  }

  int sign_at(const Barycentric& l, std::size_t j) {
    const Scope scope;
    for (const slong precision : {128, 256}) {
      context.precision = precision;
      const int sign = sample(Piece::point(l), 0, 1U << j).e[j][0].sign();
      if (sign != 0) return sign;
    }
    throw Open{"E_j has a certain sign at a point"};
  }
  void corners() {
    for (std::size_t j = 0; j < 2; ++j)
      for (Index k = 0; k < 3 && record_.verdict[j] != kNone; ++k)
        outcome_.sign[j][k] = is_loose_[j][k] ? 1 : sign_at(unit_corner(k), j);
  }

  void side(std::size_t j, Index k) {
    const Piece whole = Piece::segment(unit_corner(k), unit_corner(k + 1));
    if (divided_[j])
      segment_division(whole, j, k, 0);
    else
      side_piece(whole, outcome_.order, j, k);
  }
  void segment_division(const Piece& piece, std::size_t j, Index k, int depth) {
    const unsigned byte = in_.u8();
    const int order = order_of(in_, byte, 4);
    if ((byte & 4) == 0) return side_piece(piece, order, j, k);
    if (depth == kSegmentDepth) in_.fail("a division is deeper than 12");
    for (const Piece& child : piece.children()) segment_division(child, j, k, depth + 1);
  }
  void side_piece(const Piece& piece, int order, std::size_t j, Index k) {
    shown<Piece>(piece, 2 * kFurther, [&](const Piece& p) {
      const Scope scope;
      context.order = order;
      if (by_value_[j][k]) {
        require(sample(p, 0, 1U << j).e[j][0].sign() != 0, "an edge: E_j has no zero");
        return;
      }
      const Sample s = sample(p, 1, 1U << j);
      const auto d = along(s, k);
      const int sign = (d[0] * s.e[j][1] + d[1] * s.e[j][2]).sign();
      require(sign != 0, "an edge: the derivative of E_j along it has no zero");
      outcome_.slope[j][k] = sign;
    });
  }
  /// The vector of side k in coordinates.
  std::array<Model, 2> along(const Sample& s, Index k) const {
    std::array<Model, 2> d;
    if (!implicit()) {
      for (std::size_t i = 0; i < 2; ++i)
        d[i] = Model(Ball(problem_.lifted(face_, (k + 1) % 3, i)) -
                     Ball(problem_.lifted(face_, k, i)));
      return d;
    }
    const Vector chord = in_frame(frame(), problem_.chord(face_, k, (k + 1) % 3, s.foot.s));
    const Vector fibre = in_frame(frame(), s.fibre.along);
    const Model b = -(dot(s.gradient, chord) * inverse(dot(s.gradient, fibre)));
    return {chord[0] + b * fibre[0], chord[1] + b * fibre[1]};
  }

  double parameter() {
    const double t = in_.f64();
    if (t < 0 || t > 1 || std::ldexp(t, 50) != std::floor(std::ldexp(t, 50)))
      in_.fail("a point of an edge is no multiple of 2^-50 in [0, 1]");
    return t;
  }
  static Barycentric on_side(Index k, double t) {
    Barycentric l{};
    l[k] = 1 - t;
    l[(k + 1) % 3] = t;
    return l;
  }

  void type(std::size_t j) {
    std::vector<int> signs;
    bool any_loose = false;
    int crossings = 0;
    for (Index k = 0; k < 3; ++k) {
      any_loose = any_loose || is_loose_[j][k];
      if (!outcome_.crossed(j, k)) continue;
      ++crossings;
      if (record_.type[j] != 0 && by_turn(j)) signs.push_back(growth_at_crossing(j, k));
    }
    if ((crossings != 0) != (record_.type[j] != 0))
      in_.fail("a type without crossed edges, or none");
    if (record_.type[j] == 0) return;
    if (!by_turn(j)) {
      if (record_.type[j] == kTurning) in_.fail("a turning point is shown by growth");
      return;
    }
    if (any_loose) in_.fail("a type at a loose corner is shown by turn");
    const int elliptic = j == 0 ? -1 : 1;
    const int found = signs[0] != signs[1]   ? kTurning
                      : signs[0] == elliptic ? kElliptic
                                             : kHyperbolic;
    if (found != record_.type[j]) in_.fail("the type is " + std::to_string(found));
  }
  int growth_at_crossing(std::size_t j, Index k) {
    const double t0 = parameter(), t1 = parameter();
    if (t0 >= t1) in_.fail("the part of an edge around a crossing is empty");
    if (sign_at(on_side(k, t0), j) != outcome_.sign[j][k] ||
        sign_at(on_side(k, t1), j) != outcome_.sign[j][(k + 1) % 3])
      in_.fail("a crossing is not in the part of the edge that is said");
    int sign = 0;
    shown<Piece>(Piece::segment(on_side(k, t0), on_side(k, t1)), kFurther, [&](const Piece& p) {
      const Scope scope;
      context.order = 4;
      sign = sample(p, 1, 1U << j).growth[j].sign();
      require(sign != 0, "the type: G_j at a crossing");
    });
    return sign;
  }

  void purple() {
    if (!by_cross()) {
      if (record_.purple) in_.fail("a purple point is shown by a combination");
      return;
    }
    std::vector<int> red;  // the sign of E2 at the blue crossings
    for (Index k = 0; k < 3; ++k) {
      if (is_loose_[0][k] || is_loose_[1][k])
        in_.fail("purple at a loose corner is shown by cross");
      if (!outcome_.crossed(0, k)) continue;
      int sign = outcome_.sign[1][k];
      if (outcome_.crossed(1, k)) {
        const double t = parameter();
        if (t == 0 || t == 1) in_.fail("the point between two crossings is a corner");
        const bool blue = sign_at(on_side(k, t), 0) != outcome_.sign[0][k];
        if (blue == (sign_at(on_side(k, t), 1) != sign))
          in_.fail("a point does not separate the crossings of its edge");
        if (!blue) sign = -sign;
      }
      red.push_back(sign);
    }
    if (record_.purple != (red[0] != red[1])) in_.fail("the bit of the purple point is wrong");
  }

  const Problem& problem_;
  const FaceRecord& record_;
  Index face_;
  Reader in_;
  BySide<bool> is_loose_{}, by_value_{};
  std::array<bool, 2> divided_{};
  unsigned methods_ = 0;
  FaceOutcome outcome_;
};

}  // namespace

int order_of(Reader& in, unsigned byte, unsigned allowed) {
  const int order = 3 + static_cast<int>(byte & 3);
  if (order > 5 || (byte & ~(3 | allowed)) != 0) in.fail("a division has unknown bits");
  return order;
}

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

namespace {

/// The conditions of a loose corner that several faces share.
void check_loose(const Problem& problem, const LooseCorners& loose, std::size_t j,
                 std::uint32_t vertex, const std::vector<FaceOutcome>& outcomes) {
  const Certificate& c = problem.certificate;
  const auto demand = [](bool holds) {
    if (!holds) throw Rejected("the conditions of a loose corner do not hold");
  };
  const FaceRecord* first = nullptr;
  std::vector<int> slopes, ends;
  int opposite_crossed = 0;
  for (Index f = 0; f < c.faces.size(); ++f)
    for (Index k = 0; k < 3; ++k) {
      if (c.faces[f][k] != vertex) continue;
      const FaceRecord& r = c.records[f];
      if (first == nullptr) first = &r;
      demand(!r.in_patch && r.w == first->w && r.verdict[j] == first->verdict[j] &&
             r.verdict[j] != kNone);
      demand(!loose.at(j, c.faces[f][(k + 1) % 3]) && !loose.at(j, c.faces[f][(k + 2) % 3]));
      opposite_crossed += outcomes[f].crossed(j, (k + 1) % 3) ? 1 : 0;
      for (const Index side : {k, (k + 2) % 3}) {
        if (problem.complex.edges[problem.complex.edge_of[f][side]].faces == 2) continue;
        demand(outcomes[f].decided[j][side] && outcomes[f].slope[j][side] != 0);
        slopes.push_back(outcomes[f].slope[j][side]);
        ends.push_back(outcomes[f].sign[j][side == k ? (k + 1) % 3 : side]);
      }
    }
  demand(slopes.size() == 2 && slopes[0] == slopes[1] && ends[0] != ends[1] &&
         opposite_crossed == 1);
}

}  // namespace

std::array<std::vector<bool>, 2> crossed_edges(const Problem& problem, const LooseCorners& loose,
                                               const std::vector<FaceOutcome>& outcomes) {
  const Certificate& c = problem.certificate;
  std::array<std::vector<bool>, 2> crossed;
  for (std::size_t j = 0; j < 2; ++j)
    for (const Edge& e : problem.complex.edges) {
      bool decided = problem.complex.interior_to_patch(e), is_crossed = false, none = false;
      for (Index i = 0; i < static_cast<Index>(e.faces); ++i) {
        const Index f = e.face[i], side = e.side[i];
        if (c.records[f].in_patch) continue;
        none = none || c.records[f].verdict[j] == kNone;
        decided = decided || none || outcomes[f].decided[j][side];
        is_crossed = is_crossed || outcomes[f].crossed(j, side);
        // Its other edges at a loose corner need no decision.
        for (const Index k : {side, (side + 1) % 3})
          decided = decided || (e.faces == 2 && loose.at(j, c.faces[f][k]));
      }
      if (!decided || (none && is_crossed))
        throw Rejected("face " + std::to_string(e.face[0]) + ": edge " + std::to_string(e.side[0]) +
                       " is not decided" + (j == 0 ? " for blue" : " for red"));
      crossed[j].push_back(is_crossed);
    }
  for (std::size_t j = 0; j < 2; ++j)
    for (const std::uint32_t vertex : loose.of(j)) check_loose(problem, loose, j, vertex, outcomes);
  return crossed;
}

}  // namespace crest::recheck
