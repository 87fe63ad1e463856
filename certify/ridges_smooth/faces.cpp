// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/faces.hpp"

#include <set>

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"

namespace crest::certify::smooth {
namespace {

using kernel::Sign;
using u32 = std::uint32_t;

/// Where the ridges cross the edges of one face, from the signs of E_j at its corners.
struct Crossings {
  FaceProvers& provers;
  u32 face = 0;
  std::array<std::array<Sign, 3>, 2> corner{};

  bool is_crossed(std::size_t j, std::size_t i) const {
    return corner[j][i] != corner[j][(i + 1) % 3];
  }

  static double read_place(WitnessReader& in) {
    const double t = in.f64();
    in.check(t >= 0 && t <= 1 && std::floor(t * 0x1p50) == t * 0x1p50,
             "has no such point of an edge");
    return t;
  }
  /// Of E_j at a point of edge i, certain and not zero.
  Sign sign_at(std::size_t j, std::size_t i, double t) const {
    if (t == 0 || t == 1) return corner[j][t == 0 ? i : (i + 1) % 3];
    const auto sign = provers.at_point({face, j, Quantity::value, 0}, on_edge(i, t));
    if (!nonzero(sign)) throw Undecided(fmt::format("face {}: sign on edge {}", face, i));
    return *sign;
  }

  /// The signs of G_j at the two crossings, each on a part of the edge at whose ends E_j has
  /// opposite signs: opposite at a turning point, else lemma 5's.
  void check_turn(std::size_t j, unsigned type, WitnessReader& in) const {
    Sign product = Sign::positive;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_crossed(j, i)) continue;
      const double low = read_place(in), high = read_place(in);
      in.check(low < high && sign_at(j, i, low) == corner[j][i] &&
                   sign_at(j, i, high) == corner[j][(i + 1) % 3],
               "names a part of an edge without the crossing");
      const Question q = {face, j, Quantity::growth, 0};
      const Piece part = Piece::segment(on_edge(i, low), on_edge(i, high));
      auto sign = provers.at_order(4, [&](auto& p) { return p.sign(q, part); });
      if (!nonzero(sign)) sign = provers.in_parts(q, on_edge(i, low), on_edge(i, high));
      if (!nonzero(sign)) in.fail(fmt::format("G at the crossing of edge {}", i));
      product = product * *sign;
      require(type == 3 || (*sign == Sign::negative) == ((type == 1) == (j == 0)),
              "face {}: type {}", face, type);
    }
    require(type != 3 || product == Sign::negative, "face {}: no turning point", face);
  }

  /// The sign of E2 where E1 is zero on edge i, which is crossed in red; in both colours a point
  /// separates the crossings.
  Sign red_at_blue(std::size_t i, WitnessReader& in) const {
    const Sign red = corner[1][i];
    if (!is_crossed(0, i)) return red;
    const double t = read_place(in);
    const bool blue_passed = sign_at(0, i, t) != corner[0][i], red_passed = sign_at(1, i, t) != red;
    in.check(blue_passed != red_passed, "names a point that separates no crossings");
    return blue_passed ? red : -red;
  }
};

class FaceChecker {
 public:
  explicit FaceChecker(const Claim& claim) : claim_(claim), provers_(claim) {}
  FaceChecker(const FaceChecker&) = delete;  // crossings_ points to provers_

  void prepare(u32 first, u32 last) { provers_.prepare(first, last, true); }

  FaceResult check(u32 face) {
    face_ = crossings_.face = face;
    const bool implicit = claim_.surface.implicit;
    const SmoothFaceRecord& record = claim_.certificate.face_records[face];
    WitnessReader in(record.witness, "face", face);
    FaceFindings found;
    FaceResult result;
    if (implicit) in.byte();  // fibre_length()
    if (record.in_patch) {
      if (implicit) provers_.prove(face, kChart | kInside, {}, in, found);
    } else {
      check_outside(record, in, found, result);
    }
    in.end();
    result.box = found.box;
    return result;
  }

 private:
  Question ask(std::size_t colour, Quantity quantity, std::size_t edge = 0) const {
    return {face_, colour, quantity, edge};
  }
  static bool has(unsigned bits, std::size_t i) { return (bits >> i & 1U) != 0; }

  void check_outside(const SmoothFaceRecord& record, WitnessReader& in, FaceFindings& found,
                     FaceResult& result) {
    const bool arcs = record.type[0] != 0 || record.type[1] != 0;
    const unsigned methods = arcs ? in.byte() : 0;
    const Method method = Method::of_byte(methods);
    in.check(methods < 8 && (!method.turn[0] || record.type[0] != 0) &&
                 (!method.turn[1] || record.type[1] != 0) &&
                 (!method.cross || (record.type[0] != 0 && record.type[1] != 0)),
             "shows what is not claimed");
    in.check(method.cross || !record.purple, "keeps arcs apart that are said to cross");
    std::array<unsigned, 2> edges{};
    for (std::size_t j = 0; j < 2; ++j)
      if (record.verdict[j] != SmoothFaceRecord::kNoZero) edges[j] = read_edges(in, j, found);
    unsigned open = kRegular | kVerdict | kVerdict << 1;
    if (claim_.surface.implicit) open |= kChart;
    for (unsigned j = 0; j < 2; ++j)
      if (record.type[j] != 0) open |= kType << j;
    if (record.type[0] != 0 && record.type[1] != 0) open |= kPurple;
    provers_.prove(face_, open, method, in, found);
    for (std::size_t j = 0; j < 2; ++j)
      if (record.verdict[j] != SmoothFaceRecord::kNoZero) {
        check_edges(j, edges[j], found, in, result);
        result.crossed[j] = crossed_edges(j, found, result.loose[j]);
      }
    check_types(record, method, result, in);
  }

  /// What is asked of the whole face's model.
  unsigned read_edges(WitnessReader& in, std::size_t j, FaceFindings& found) {
    const unsigned bits = in.byte(), decided = bits & 7U, by_value = bits >> 3 & 7U;
    const bool divided = has(bits, 6);
    in.check(bits < 128 && (by_value & ~decided) == 0 && (!divided || decided != 0),
             "decides edges in no way that there is");
    if (!divided) {
      found.ask_value[j] = by_value;
      found.ask_slope[j] = decided & ~by_value;
    }
    return bits;
  }

  void check_edges(std::size_t j, unsigned bits, const FaceFindings& found, WitnessReader& in,
                   FaceResult& result) {
    result.decided[j] = static_cast<std::uint8_t>(bits & 7U);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!has(bits, i)) continue;
      const bool by_value = has(bits, 3 + i);
      const Question q = ask(j, by_value ? Quantity::value : Quantity::along_edge, i);
      auto sign = by_value ? found.value[j][i] : found.slope[j][i];
      if (has(bits, 6)) sign = provers_.on_segment(q, on_edge(i, 0), on_edge(i, 1), in);
      if (!nonzero(sign)) sign = provers_.in_parts(q, on_edge(i, 0), on_edge(i, 1));
      if (!nonzero(sign))
        in.fail(fmt::format("{} crossings of edge {}", j == 0 ? "blue" : "red", i));
      if (!by_value) result.slope[j][i] = sign;
    }
  }

  /// A corner of the square where the claim takes the sign of E_j for positive.
  bool is_loose(std::size_t j, std::size_t i) const {
    const RidgesSmoothCertificate& c = claim_.certificate;
    if (c.loose_corners == 0) return false;
    const auto& v = c.vertices[c.faces[face_][i]];
    return is_corner(v) && has(c.loose_corners, loose_bit(v, j));
  }

  /// Signs at the corners, of the whole face's model or at the points alone.
  std::uint8_t crossed_edges(std::size_t j, const FaceFindings& found, std::uint8_t& loose) {
    for (std::size_t i = 0; i < 3; ++i) {
      auto sign = found.corner[j][i];
      if (is_loose(j, i)) {
        loose = static_cast<std::uint8_t>(loose | 1U << i);
        sign = Sign::positive;
      }
      if (!nonzero(sign)) sign = provers_.at_point(ask(j, Quantity::value), on_edge(i, 0));
      if (!nonzero(sign)) throw Undecided(fmt::format("face {}: sign at corner {}", face_, i));
      crossings_.corner[j][i] = *sign;
    }
    unsigned bits = 0;
    for (unsigned i = 0; i < 3; ++i)
      if (crossings_.is_crossed(j, i)) bits |= 1U << i;
    return static_cast<std::uint8_t>(bits);
  }

  void check_types(const SmoothFaceRecord& record, const Method& method, const FaceResult& result,
                   WitnessReader& in) {
    for (std::size_t j = 0; j < 2; ++j) {
      require((record.type[j] != 0) == (result.crossed[j] != 0), "face {}: a type {} an arc", face_,
              record.type[j] != 0 ? "without" : "is missing for");
      if (!method.turn[j]) continue;
      require(result.loose[j] == 0, "face {}: its type at a corner of the domain", face_);
      crossings_.check_turn(j, record.type[j], in);
    }
    if (!method.cross) return;
    require(result.loose[0] == 0 && result.loose[1] == 0,
            "face {}: purple at a corner of the domain", face_);
    Sign product = Sign::positive;
    for (std::size_t i = 0; i < 3; ++i) {
      const Sign red =
          crossings_.is_crossed(1, i) ? crossings_.red_at_blue(i, in) : crossings_.corner[1][i];
      if (has(result.crossed[0], i)) product = product * red;
    }
    require(record.purple == (product == Sign::negative), "face {}: the purple bit", face_);
  }

  const Claim& claim_;
  FaceProvers provers_;
  u32 face_ = 0;
  Crossings crossings_{provers_};
};

/// The faces at a corner of the domain where a sign is taken (SPEC.md, "Loose corners").
void check_loose_corner(const Claim& claim, const std::vector<FaceResult>& faces, u32 vertex,
                        std::size_t j) {
  const auto& topology = claim.mesh.topology;
  std::vector<kernel::Sign> slopes;
  std::optional<u32> first;
  unsigned opposite = 0, along = 0;
  for (u32 k = topology.ring_start[vertex]; k < topology.ring_start[vertex + 1]; ++k) {
    const u32 f = topology.ring[k] / 3, i = topology.ring[k] % 3;
    if (!first) first = f;
    const SmoothFaceRecord &r = claim.certificate.face_records[f],
                           &o = claim.certificate.face_records[*first];
    require(!r.in_patch && r.w == o.w && r.verdict[j] == o.verdict[j] &&
                r.verdict[j] != SmoothFaceRecord::kNoZero,
            "vertex {}: its faces differ at a corner of the domain", vertex);
    require((faces[f].loose[0] | faces[f].loose[1]) == 1U << i,
            "face {}: at two loose corners of the domain", f);
    opposite += faces[f].crossed[j] >> (i + 1) % 3 & 1U;
    for (const u32 side : {i, (i + 2) % 3}) {
      if (topology.twin[3 * f + side] != kNone) continue;
      along += faces[f].crossed[j] >> side & 1U;
      const auto& slope = faces[f].slope[j][side];
      require(slope.has_value(), "face {}: along the boundary at a corner", f);
      slopes.push_back(*slope);
    }
  }
  require(slopes.size() == 2 && slopes[0] == slopes[1] && opposite == 1 && along == 1,
          "vertex {}: a ridge at a corner of the domain", vertex);
}

/// Where a loose corner has several faces, the arc may run through others than those in which it is
/// drawn: these, too, are without turning and purple points.
void check_undrawn_arc(const Claim& claim, FaceProvers& provers, u32 vertex, std::size_t j) {
  const auto& topology = claim.mesh.topology;
  const auto& records = claim.certificate.face_records;
  const u32 begin = topology.ring_start[vertex], end = topology.ring_start[vertex + 1];
  unsigned type = 0;
  for (u32 k = begin; k < end; ++k) {
    const unsigned here = records[topology.ring[k] / 3].type[j];
    require(here == 0 || type == 0 || here == type,
            "vertex {}: two types at a corner of the domain", vertex);
    if (here != 0) type = here;
  }
  const Sign wanted = (type == 1) == (j == 0) ? Sign::negative : Sign::positive;
  for (u32 k = begin; k < end; ++k) {
    const u32 f = topology.ring[k] / 3;
    if (records[f].type[j] != 0) continue;
    require(records[f].type[1 - j] == 0, "face {}: an arc at a corner of the domain", f);
    const auto sign = provers.at_order(5, [&](auto& p) {
      return p.sign({f, j, Quantity::growth, 0}, Piece::face());
    });
    if (!sign || *sign != wanted)
      throw Undecided(fmt::format("face {}: the type at a corner of the domain", f));
  }
}

/// Checks all that are marked, needed or not; by colour the vertices.
std::array<std::set<u32>, 2> check_loose_corners(const Claim& claim,
                                                 const std::vector<FaceResult>& faces) {
  const RidgesSmoothCertificate& c = claim.certificate;
  std::array<std::set<u32>, 2> vertices;
  for (u32 v = 0; v < c.vertices.size() && c.loose_corners != 0; ++v)
    for (std::size_t j = 0; j < 2; ++j)
      if (is_corner(c.vertices[v]) && (c.loose_corners >> loose_bit(c.vertices[v], j) & 1) != 0)
        vertices[j].insert(v);
  for (std::size_t j = 0; j < 2; ++j)
    for (const u32 v : vertices[j]) check_loose_corner(claim, faces, v, j);
  return vertices;
}

}  // namespace

std::vector<FaceResult> check_faces(const Claim& claim) {
  std::vector<FaceResult> results(claim.certificate.faces.size());
  constexpr std::size_t kTogether = FaceProvers::kTogether;
  parallel_for((results.size() + kTogether - 1) / kTogether, [&] { return FaceChecker(claim); },
               [&](FaceChecker& checker, std::size_t group) {
                 const auto first = static_cast<u32>(group * kTogether);
                 const auto last = static_cast<u32>(std::min(first + kTogether, results.size()));
                 checker.prepare(first, last);
                 for (u32 f = first; f < last; ++f) results[f] = checker.check(f);
               });
  check_undrawn_arcs(claim);
  return results;
}

void check_undrawn_arcs(const Claim& claim) {
  const RidgesSmoothCertificate& c = claim.certificate;
  if (c.loose_corners == 0) return;
  FaceProvers provers(claim);
  const auto& start = claim.mesh.topology.ring_start;
  for (u32 v = 0; v < c.vertices.size(); ++v) {
    const auto& at = c.vertices[v];
    if (!is_corner(at)) continue;
    const bool blue = (c.loose_corners >> loose_bit(at, 0) & 1) != 0;
    const bool red = (c.loose_corners >> loose_bit(at, 1) & 1) != 0;
    if ((!blue && !red) || start[v + 1] - start[v] == 1) continue;
    require(!blue || !red, "vertex {}: ridges of both colours at a corner of the domain", v);
    check_undrawn_arc(claim, provers, v, blue ? 0 : 1);
  }
}

std::array<std::vector<std::uint8_t>, 2> check_edges(const Claim& claim,
                                                     const std::vector<FaceResult>& faces) {
  const auto& edges = claim.mesh.topology.edges;
  const auto& patch_of = claim.mesh.patch_of;
  const auto& records = claim.certificate.face_records;
  std::array<std::vector<std::uint8_t>, 2> crossed;
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
      bool decided = loose[j].count(edges[e].low) + loose[j].count(edges[e].high) > 0;
      std::array<int, 2> seen = {-1, -1};
      for (std::size_t k = 0; k < 2; ++k) {
        if (side[k] == kNone) continue;
        const FaceResult& face = faces[side[k] / 3];
        decided = decided || records[side[k] / 3].verdict[j] == SmoothFaceRecord::kNoZero ||
                  (face.decided[j] >> side[k] % 3 & 1U) != 0;
        seen[k] = face.crossed[j] >> side[k] % 3 & 1;
      }
      require(seen[0] < 0 || seen[1] < 0 || seen[0] == seen[1], "edge {}: its faces disagree", e);
      require(decided, "edge {}: no face decides its {} crossings", e, j == 0 ? "blue" : "red");
      crossed[j][e] = static_cast<std::uint8_t>(std::max(seen[0], seen[1]));
    }
  }
  return crossed;
}

}  // namespace crest::certify::smooth
