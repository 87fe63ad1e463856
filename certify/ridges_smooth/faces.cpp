// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/faces.hpp"

#include <set>

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"

namespace crest::certify::smooth {
namespace {

using kernel::Sign;
using u32 = std::uint32_t;

class FaceChecker {
 public:
  explicit FaceChecker(const Claim& claim) : claim_(claim), provers_(claim) {}

  FaceResult check(u32 face) {
    face_ = face;
    const SmoothFaceRecord& record = claim_.certificate.face_records[face];
    FaceFindings found;
    FaceResult result;
    if (record.in_patch) {
      provers_.prove(face, kChart, &found);
      result.box = found.box;
      return result;
    }
    unsigned open = kChart | kRegular | kVerdict | kVerdict << 1;
    for (unsigned j = 0; j < 2; ++j)
      if (record.type[j] != 0) open |= kType << j;
    if (record.type[0] != 0 && record.type[1] != 0)
      open |= record.purple ? kCross : kApart | kCross;
    const unsigned ends = provers_.prove(face, open, &found);
    result.box = found.box;
    result.decided = found.decided;
    for (std::size_t j = 0; j < 2; ++j)
      if (record.verdict[j] != SmoothFaceRecord::kNoZero)
        result.crossed[j] = crossed_edges(j, found, result.loose[j]);
    check_types(record, result, ends);
    return result;
  }

 private:
  Question ask(std::size_t colour, Quantity quantity) const { return {face_, colour, quantity, 0}; }

  /// A corner of the square, if no direction is periodic.
  bool is_domain_corner(std::size_t i) const {
    if (claim_.surface.implicit || claim_.surface.periodic[0] || claim_.surface.periodic[1])
      return false;
    const auto& v = claim_.certificate.vertices[claim_.certificate.faces[face_][i]];
    return (v[0] == 0 || v[0] == 1) && (v[1] == 0 || v[1] == 1);
  }

  /// Signs at the corners, on the whole face or at the points alone.
  std::uint8_t crossed_edges(std::size_t j, const FaceFindings& found, std::uint8_t& loose) {
    for (std::size_t i = 0; i < 3; ++i) {
      auto sign = found.corner[j][i];
      if (!nonzero(sign)) sign = provers_.at_point(ask(j, Quantity::value), on_edge(i, 0));
      if (!nonzero(sign) && is_domain_corner(i)) {
        loose = static_cast<std::uint8_t>(loose | 1U << i);
        sign = Sign::positive;
      }
      if (!nonzero(sign)) throw Undecided(fmt::format("face {}: sign at corner {}", face_, i));
      corner_[j][i] = *sign;
    }
    unsigned bits = 0;
    for (unsigned i = 0; i < 3; ++i)
      if (corner_[j][i] != corner_[j][(i + 1) % 3]) bits |= 1U << i;
    return static_cast<std::uint8_t>(bits);
  }

  void check_types(const SmoothFaceRecord& record, const FaceResult& result, unsigned ends) {
    for (std::size_t j = 0; j < 2; ++j) {
      require((record.type[j] != 0) == (result.crossed[j] != 0), "face {}: a type {} an arc", face_,
              record.type[j] != 0 ? "without" : "is missing for");
      if ((ends & kType << j) == 0) continue;
      require(result.loose[j] == 0, "face {}: its type at a corner of the domain", face_);
      check_growth(j, record.type[j], result.crossed[j]);
    }
    const bool both = result.crossed[0] != 0 && result.crossed[1] != 0;
    require(both || !record.purple, "face {}: a purple point without two arcs", face_);
    if (both && (ends & kCross) != 0) {
      require(result.loose[0] == 0 && result.loose[1] == 0,
              "face {}: purple at a corner of the domain", face_);
      Sign product = Sign::positive;
      for (std::size_t i = 0; i < 3; ++i)
        if ((result.crossed[0] >> i & 1U) != 0) product = product * red_at_blue(i, result);
      require(record.purple == (product == Sign::negative), "face {}: the purple bit", face_);
    }
  }

  /// The signs of G_j at the two crossings: opposite at a turning point, else lemma 5's.
  void check_growth(std::size_t j, unsigned type, unsigned crossed) {
    Sign product = Sign::positive;
    for (std::size_t i = 0; i < 3; ++i) {
      if ((crossed >> i & 1U) == 0) continue;
      const Sign sign = growth_at_crossing(j, i);
      product = product * sign;
      require(type == 3 || (sign == Sign::negative) == ((type == 1) == (j == 0)),
              "face {}: type {}", face_, type);
    }
    require(type != 3 || product == Sign::negative, "face {}: no turning point", face_);
  }

  /// A point of the edge between two others where E_j is certain. Barycentric coordinates stay
  /// exact.
  std::optional<std::pair<double, Sign>> between(std::size_t j, std::size_t i, double low,
                                                 double high) {
    if (high - low < 0x1p-40) return std::nullopt;
    for (const double part : {0.5, 0.375, 0.625, 0.4375, 0.5625}) {
      const double t = low + part * (high - low);
      const auto sign = provers_.at_point(ask(j, Quantity::value), on_edge(i, t));
      if (nonzero(sign)) return std::pair(t, *sign);
    }
    return std::nullopt;
  }

  /// G_j's sign on a part of edge i at whose ends E_j has opposite signs.
  Sign growth_at_crossing(std::size_t j, std::size_t i) {
    double low = 0, high = 1;
    for (;;) {
      const Piece part = Piece::segment(on_edge(i, low), on_edge(i, high));
      const auto sign =
          provers_.at_depth(0, [&](auto& p) { return p.sign(ask(j, Quantity::growth), part); });
      if (nonzero(sign)) return *sign;
      const auto next = between(j, i, low, high);
      if (!next) throw Undecided(fmt::format("face {}: G at the crossing of edge {}", face_, i));
      (next->second == corner_[j][i] ? low : high) = next->first;
    }
  }

  /// The sign of E2 where E1 is zero on edge i. On an edge crossed twice a point is looked for that
  /// separates the crossings.
  Sign red_at_blue(std::size_t i, const FaceResult& result) {
    const Sign red = corner_[1][i];
    if ((result.crossed[1] >> i & 1U) == 0) return red;
    double low = 0, high = 1;
    while (high - low > 0x1p-40) {  // then t and 1 - t are exact
      bool moved = false;
      for (const double part : {0.5, 0.375, 0.625, 0.4375, 0.5625}) {
        const double t = low + part * (high - low);
        const auto blue_sign = provers_.at_point(ask(0, Quantity::value), on_edge(i, t));
        const auto red_sign = provers_.at_point(ask(1, Quantity::value), on_edge(i, t));
        if (!nonzero(blue_sign) || !nonzero(red_sign)) continue;
        const bool blue_passed = *blue_sign != corner_[0][i], red_passed = *red_sign != red;
        if (blue_passed != red_passed) return blue_passed ? red : -red;
        (blue_passed ? high : low) = t;
        moved = true;
        break;
      }
      if (!moved) break;
    }
    throw Undecided(fmt::format("face {}: the order of two crossings on edge {}", face_, i));
  }

  const Claim& claim_;
  FaceProvers provers_;
  u32 face_ = 0;
  std::array<std::array<Sign, 3>, 2> corner_{};
};

/// One edge and colour that needs a proof in one of two faces.
struct OpenEdge {
  u32 edge;
  std::size_t colour;
  std::array<u32, 2> side;  ///< or kNone
};

void decide(FaceProvers& provers, const OpenEdge& open) {
  for (const u32 side : open.side) {
    if (side == kNone) continue;
    const std::size_t i = side % 3;
    for (const auto quantity : {Quantity::along_edge, Quantity::value})
      if (nonzero(provers.on_segment({side / 3, open.colour, quantity, i}, on_edge(i, 0),
                                     on_edge(i, 1))))
        return;
  }
  throw Undecided(
      fmt::format("edge {}: number of {} crossings", open.edge, open.colour == 0 ? "blue" : "red"));
}

/// The faces at a corner of the domain where a sign was taken (SPEC.md, "Corners of the domain").
class LooseCorner {
 public:
  LooseCorner(const Claim& claim, const std::vector<FaceResult>& faces, u32 vertex, std::size_t j)
      : claim_(claim), faces_(faces), provers_(claim), vertex_(vertex), j_(j) {}

  void check() {
    const auto& c = claim_.certificate;
    std::optional<u32> first;
    std::vector<Sign> slopes;
    unsigned opposite = 0, along = 0;
    for (u32 f = 0; f < c.faces.size(); ++f)
      for (u32 i = 0; i < 3; ++i) {
        if (c.faces[f][i] != vertex_) continue;
        const SmoothFaceRecord& r = c.face_records[f];
        if (!first) first = f;
        const SmoothFaceRecord& o = c.face_records[*first];
        require(!r.in_patch && r.w == o.w && r.verdict[j_] == o.verdict[j_] &&
                    r.verdict[j_] != SmoothFaceRecord::kNoZero,
                "vertex {}: its faces differ at a corner of the domain", vertex_);
        opposite += faces_[f].crossed[j_] >> (i + 1) % 3 & 1U;
        for (const u32 k : {i, (i + 2) % 3}) {
          if (claim_.mesh.topology.twin[3 * f + k] != kNone) continue;
          along += faces_[f].crossed[j_] >> k & 1U;
          const auto sign =
              provers_.on_segment({f, j_, Quantity::along_edge, k}, on_edge(k, 0), on_edge(k, 1));
          if (!nonzero(sign))
            throw Undecided(fmt::format("face {}: along the boundary at a corner", f));
          slopes.push_back(*sign);
        }
      }
    require(slopes.size() == 2 && slopes[0] == slopes[1] && opposite == 1 && along == 1,
            "vertex {}: a ridge at a corner of the domain", vertex_);
  }

 private:
  const Claim& claim_;
  const std::vector<FaceResult>& faces_;
  FaceProvers provers_;
  u32 vertex_;
  std::size_t j_;
};

/// Checks them all; by colour the vertices.
std::array<std::set<u32>, 2> check_loose_corners(const Claim& claim,
                                                 const std::vector<FaceResult>& faces) {
  std::array<std::set<u32>, 2> vertices;
  for (u32 f = 0; f < faces.size(); ++f)
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t i = 0; i < 3; ++i)
        if ((faces[f].loose[j] >> i & 1U) != 0) vertices[j].insert(claim.certificate.faces[f][i]);
  for (std::size_t j = 0; j < 2; ++j)
    for (const u32 v : vertices[j]) LooseCorner(claim, faces, v, j).check();
  return vertices;
}

}  // namespace

std::vector<FaceResult> check_faces(const Claim& claim) {
  std::vector<FaceResult> results(claim.certificate.faces.size());
  parallel_for(
      results.size(), [&] { return FaceChecker(claim); },
      [&](FaceChecker& checker, std::size_t f) {
        results[f] = checker.check(static_cast<u32>(f));
      });
  return results;
}

std::array<std::vector<std::uint8_t>, 2> check_edges(const Claim& claim,
                                                     const std::vector<FaceResult>& faces) {
  const auto& edges = claim.mesh.topology.edges;
  const auto& patch_of = claim.mesh.patch_of;
  const auto& records = claim.certificate.face_records;
  std::array<std::vector<std::uint8_t>, 2> crossed;
  std::vector<OpenEdge> open;
  const auto loose = check_loose_corners(claim, faces);
  for (auto& list : crossed) list.assign(edges.size(), 0);
  for (u32 e = 0; e < edges.size(); ++e) {
    std::array<u32, 2> side = {edges[e].forward, edges[e].backward};
    std::array<u32, 2> patch{};
    for (std::size_t k = 0; k < 2; ++k) {
      patch[k] = side[k] == kNone ? kNone : patch_of[side[k] / 3];
      if (patch[k] != kNone) side[k] = kNone;
    }
    if (patch[0] != kNone && patch[0] == patch[1]) continue;
    require(side[0] != kNone || side[1] != kNone, "edge {}: no face outside patches", e);
    for (std::size_t j = 0; j < 2; ++j) {
      bool decided = false;
      std::array<int, 2> seen = {-1, -1};
      for (std::size_t k = 0; k < 2; ++k) {
        if (side[k] == kNone) continue;
        const FaceResult& face = faces[side[k] / 3];
        decided = decided || records[side[k] / 3].verdict[j] == SmoothFaceRecord::kNoZero ||
                  (face.decided[j] >> side[k] % 3 & 1U) != 0;
        seen[k] = face.crossed[j] >> side[k] % 3 & 1;
      }
      require(seen[0] < 0 || seen[1] < 0 || seen[0] == seen[1], "edge {}: its faces disagree", e);
      crossed[j][e] = static_cast<std::uint8_t>(std::max(seen[0], seen[1]));
      const u32 any = side[0] != kNone ? side[0] : side[1];
      const auto& corners = claim.certificate.faces[any / 3];
      const bool free =
          loose[j].count(corners[any % 3]) + loose[j].count(corners[(any + 1) % 3]) > 0;
      if (!decided && !free) open.push_back({e, j, side});
    }
  }
  parallel_for(
      open.size(), [&] { return FaceProvers(claim); },
      [&](FaceProvers& provers, std::size_t k) { decide(provers, open[k]); });
  return crossed;
}

}  // namespace crest::certify::smooth
