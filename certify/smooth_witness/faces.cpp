// SPDX-License-Identifier: GPL-3.0-or-later
// Faces' witnesses: order 3 on faces without arcs, order 4 on all others and on quarters, order 5
// below.
#include "certify/ridges_smooth/faces.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/smooth_witness/loop.hpp"
#include "certify/smooth_witness/parts.hpp"

namespace crest::certify::witness {
namespace {

using kernel::Sign;
using namespace smooth;

constexpr int kDepth = 5, kSegmentDepth = 10;

/// A face's string in its parts, until its edges are settled.
struct FaceDraft {
  std::optional<unsigned> methods;
  std::array<unsigned, 2> slope{},
      value{};                      ///< edges of the whole face's model that are decided so
  std::array<unsigned, 2> edges{};  ///< as written
  Bytes division, places;
  std::array<std::array<Bytes, 3>, 2> segments;
  std::array<unsigned, 2> loose{};  ///< corners of the domain without a certain sign
  std::optional<Ranges> box;
};

class Chooser : public Advisor {
 public:
  bool steep(const kernel::Range& a11) override { return a11.low + a11.high < 0; }
  std::vector<std::array<double, 2>> combinations(
      const std::array<std::array<kernel::Range, 3>, 2>& e) override {
    auto list = witness::combinations({e[0][0], e[1][0]});
    if (list[0][0] == 0 || list[0][1] == 0) return list;
    // One nearly without slope: arcs nearly parallel stay apart.
    const double a1 = middle(e[0][1]), a2 = middle(e[0][2]);
    const double b1 = middle(e[1][1]), b2 = middle(e[1][2]);
    const double sign = a1 * b1 + a2 * b2 > 0 ? -1 : 1;
    list.push_back(as_floats(std::sqrt(b1 * b1 + b2 * b2), sign * std::sqrt(a1 * a1 + a2 * a2)));
    return list;
  }
};

/// Places where the ridges cross the edges of one face.
struct Crossings {
  FaceProvers& provers;
  u32 face = 0;
  std::array<std::array<Sign, 3>, 2> corner{};  ///< of E_j

  bool is_crossed(std::size_t j, std::size_t i) const {
    return corner[j][i] != corner[j][(i + 1) % 3];
  }

  /// A point of the edge between two others where E_j is certain. Barycentric coordinates stay
  /// exact.
  std::optional<std::pair<double, Sign>> between(std::size_t j, std::size_t i, double low,
                                                 double high) const {
    if (high - low < 0x1p-40) return std::nullopt;
    for (const double part : {0.5, 0.375, 0.625, 0.4375, 0.5625}) {
      const double t = low + part * (high - low);
      const auto sign = provers.at_point({face, j, Quantity::value, 0}, on_edge(i, t));
      if (nonzero(sign)) return std::pair(t, *sign);
    }
    return std::nullopt;
  }

  /// A part of edge i with the crossing on which G_j has one sign.
  void put_crossing(std::size_t j, std::size_t i, Bytes& out) const {
    double low = 0, high = 1;
    for (;;) {
      const Piece part = Piece::segment(on_edge(i, low), on_edge(i, high));
      const auto sign = provers.at_order(4, [&](auto& p) {
        return p.sign({face, j, Quantity::growth, 0}, part);
      });
      if (nonzero(sign)) break;
      const auto next = between(j, i, low, high);
      if (!next) throw Undecided(fmt::format("face {}: G at the crossing of edge {}", face, i));
      (next->second == corner[j][i] ? low : high) = next->first;
    }
    put_f64(out, low);
    put_f64(out, high);
  }

  /// A point of edge i between its two crossings.
  double separating_point(std::size_t i) const {
    double low = 0, high = 1;
    while (high - low > 0x1p-40) {  // then t and 1 - t are exact
      bool moved = false;
      for (const double part : {0.5, 0.375, 0.625, 0.4375, 0.5625}) {
        const double t = low + part * (high - low);
        const auto blue = provers.at_point({face, 0, Quantity::value, 0}, on_edge(i, t));
        const auto red = provers.at_point({face, 1, Quantity::value, 0}, on_edge(i, t));
        if (!nonzero(blue) || !nonzero(red)) continue;
        const bool blue_passed = *blue != corner[0][i], red_passed = *red != corner[1][i];
        if (blue_passed != red_passed) return t;
        (blue_passed ? high : low) = t;
        moved = true;
        break;
      }
      if (!moved) break;
    }
    throw Undecided(fmt::format("face {}: the order of two crossings on edge {}", face, i));
  }
};

/// The pieces of one face, down to which its statements are shown.
struct Divider {
  const Claim& claim;
  RidgesSmoothCertificate& c;
  FaceProvers& provers;
  u32 face = 0;
  Method method{};  ///< of showing the statements that have two
  Chooser chooser{};

  /// Throws Undecided. Longer fibres if the feet are not found; other methods if the first ones
  /// fail.
  void divide_all(unsigned open, Bytes& out, FaceFindings& found) {
    const FaceFindings asked = found;
    for (int longer = 0;;) {
      found = asked;
      out.clear();
      const unsigned failed = divide(Piece::face(), 0, open, out, &found);
      if (failed == 0) return;
      auto& witness = c.face_records[face].witness;
      if (claim.surface.implicit && !found.box && longer < 2 && witness[0] > 0) {
        --witness[0];
        ++longer;
      } else if (flip(failed) == 0) {
        throw Undecided(fmt::format("face {}: {}", face, names_of(failed)));
      }
    }
  }

  /// Other methods for those of the statements that have them.
  unsigned flip(unsigned statements) {
    unsigned flipped = 0;
    for (unsigned j = 0; j < 2; ++j)
      if ((statements & kType << j) != 0 && !method.turn[j]) {
        method.turn[j] = true;
        flipped |= kType << j;
      }
    if ((statements & kPurple) != 0 && !method.cross) {
      method.cross = true;
      flipped |= kPurple;
    }
    return flipped;
  }

  /// Returns statements that the deepest pieces leave open.
  unsigned divide(const Piece& piece, int depth, unsigned open, Bytes& out, FaceFindings* found) {
    const SmoothFaceRecord& record = c.face_records[face];
    const auto no_zero = SmoothFaceRecord::kNoZero;
    const bool cheap =
        depth == 0 &&
        (record.in_patch || (record.verdict[0] == no_zero && record.verdict[1] == no_zero));
    int order = cheap ? 3 : depth < 2 ? 4 : 5;
    Method used = method;
    unsigned left = provers.left_open(face, piece, open, used, order, found, &chooser);
    if (left != 0 && cheap) {
      used = method;
      left = provers.left_open(face, piece, open, used, order = 4, found, &chooser);
    }
    if (left != 0 && depth == 0 && try_other_methods(left, order))
      return divide(piece, depth, open, out, found);
    const unsigned shown = open & ~left;
    out.push_back(static_cast<std::uint8_t>(order - 3 + (left != 0 ? DivisionNode::kDivided : 0U) +
                                            (used.steep ? DivisionNode::kSteep : 0U)));
    if (left != 0) out.push_back(static_cast<std::uint8_t>(shown));
    if ((shown & kPurple) != 0 && !used.cross)
      for (const double x : used.combination) put_f32(out, x);
    if (left == 0 || depth == kDepth) return left;
    for (std::size_t k = 0; k < 4; ++k)
      if (const unsigned failed = divide(piece.child(k), depth + 1, left, out, nullptr))
        return failed;
    return 0;
  }

  /// Is one of the statements shown on the whole face by its other method?
  bool try_other_methods(unsigned left, int order) {
    const Method before = method;
    const unsigned flipped = flip(left);
    if (flipped == 0) return false;
    Method used = method;
    const unsigned won =
        flipped & ~provers.left_open(face, Piece::face(), flipped, used, order, nullptr, &chooser);
    method = before;
    return flip(won) != 0;
  }
};

class FaceRecorder {
 public:
  FaceRecorder(const Claim& claim, RidgesSmoothCertificate& c)
      : claim_(claim), c_(c), provers_(claim) {}
  FaceRecorder(const FaceRecorder&) = delete;  // members point to provers_

  void prepare(u32 first, u32 last) { provers_.prepare(first, last, false); }

  FaceDraft record(u32 face) {
    face_ = divider_.face = crossings_.face = face;
    const bool implicit = claim_.surface.implicit;
    const SmoothFaceRecord& record = c_.face_records[face];
    FaceDraft draft;
    FaceFindings found;
    divider_.method = {};
    if (record.in_patch) {
      if (implicit) divider_.divide_all(kChart | kInside, draft.division, found);
      draft.box = found.box;
      return draft;
    }
    unsigned open = kRegular | kVerdict | kVerdict << 1;
    if (implicit) open |= kChart;
    for (unsigned j = 0; j < 2; ++j) {
      found.ask_slope[j] = found.ask_value[j] = 7;
      divider_.method.turn[j] = record.type[j] == 3;
      if (record.type[j] != 0) open |= kType << j;
    }
    divider_.method.cross = record.purple;
    if (record.type[0] != 0 && record.type[1] != 0) open |= kPurple;
    divider_.divide_all(open, draft.division, found);
    draft.box = found.box;
    for (std::size_t j = 0; j < 2; ++j)
      if (record.verdict[j] != SmoothFaceRecord::kNoZero) read_signs(j, found, draft);
    if (record.type[0] != 0 || record.type[1] != 0)
      draft.methods = (divider_.method.turn[0] ? 1U : 0U) | (divider_.method.turn[1] ? 2U : 0U) |
                      (divider_.method.cross ? 4U : 0U);
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t i = 0; divider_.method.turn[j] && i < 3; ++i)
        if (crossings_.is_crossed(j, i)) crossings_.put_crossing(j, i, draft.places);
    for (std::size_t i = 0; divider_.method.cross && i < 3; ++i)
      if (crossings_.is_crossed(0, i) && crossings_.is_crossed(1, i))
        put_f64(draft.places, crossings_.separating_point(i));
    return draft;
  }

  /// One sign on an edge, with the pieces that show it.
  bool record_segment(const Question& q, Bytes& out) {
    return record_segment(q, on_edge(q.edge, 0), on_edge(q.edge, 1), 0, out);
  }

 private:
  Question ask(std::size_t colour, Quantity quantity) const { return {face_, colour, quantity, 0}; }

  /// Corners and edges of a colour with a direction.
  void read_signs(std::size_t j, const FaceFindings& found, FaceDraft& draft) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (nonzero(found.slope[j][i])) draft.slope[j] |= 1U << i;
      if (nonzero(found.value[j][i])) draft.value[j] |= 1U << i;
      auto sign = found.corner[j][i];
      if (!nonzero(sign)) sign = provers_.at_point(ask(j, Quantity::value), on_edge(i, 0));
      if (!nonzero(sign) && is_domain_corner(i)) {
        draft.loose[j] |= 1U << i;
        sign = Sign::positive;
      }
      if (!nonzero(sign)) throw Undecided(fmt::format("face {}: sign at corner {}", face_, i));
      crossings_.corner[j][i] = *sign;
    }
  }
  /// A corner of the square, if no direction is periodic.
  bool is_domain_corner(std::size_t i) const {
    if (claim_.surface.implicit || claim_.surface.periodic[0] || claim_.surface.periodic[1])
      return false;
    return is_corner(c_.vertices[c_.faces[face_][i]]);
  }

  bool record_segment(const Question& q, const Barycentric& a, const Barycentric& b, int depth,
                      Bytes& out) {
    const int order = depth < 2 ? 4 : 5;
    const auto found =
        provers_.at_order(order, [&](auto& p) { return p.sign(q, Piece::segment(a, b)); });
    if (nonzero(found)) {
      out.push_back(static_cast<std::uint8_t>(order - 3));
      return true;
    }
    if (depth == kSegmentDepth) return false;
    out.push_back(static_cast<std::uint8_t>(order - 3 + DivisionNode::kDivided));
    const Barycentric half = midpoint(a, b);
    return record_segment(q, a, half, depth + 1, out) && record_segment(q, half, b, depth + 1, out);
  }

  const Claim& claim_;
  RidgesSmoothCertificate& c_;
  FaceProvers provers_;
  u32 face_ = 0;
  Divider divider_{claim_, c_, provers_};
  Crossings crossings_{provers_};
};

/// Which face decides which edge.
class EdgeRecorder {
 public:
  EdgeRecorder(const Claim& claim, RidgesSmoothCertificate& c, std::vector<FaceDraft>& drafts)
      : claim_(claim), c_(c), drafts_(drafts) {}

  void record() {
    const auto& edges = claim_.mesh.topology.edges;
    for (u32 e = 0; e < edges.size(); ++e)
      for (std::size_t j = 0; j < 2; ++j) assign(edges[e], j);
    for_all(
        open_.size(), [&] { return FaceRecorder(claim_, c_); },
        [&](FaceRecorder& recorder, std::size_t k) { divide(recorder, open_[k]); });
    for (Open& o : open_) {
      mark(o.chosen, o.colour, o.by_value);
      drafts_[o.chosen / 3].segments[o.colour][o.chosen % 3] = std::move(o.segments);
    }
    // The other edges of a face with divisions need some too.
    std::vector<std::array<u32, 2>> more;
    for (const Open& o : open_) more.push_back({o.chosen / 3, static_cast<u32>(o.colour)});
    std::sort(more.begin(), more.end());
    more.erase(std::unique(more.begin(), more.end()), more.end());
    for_all(
        more.size(), [&] { return FaceRecorder(claim_, c_); },
        [&](FaceRecorder& recorder, std::size_t k) { complete(recorder, more[k][0], more[k][1]); });
  }

 private:
  struct Open {
    std::array<u32, 2> side;  ///< or kNone
    std::size_t colour;
    bool slope_only;
    u32 chosen = kNone;
    bool by_value = false;
    Bytes segments;
  };

  bool is_loose(u32 vertex, std::size_t j) const {
    const auto& v = c_.vertices[vertex];
    return is_corner(v) && (c_.loose_corners >> loose_bit(v, j) & 1) != 0;
  }
  void mark(u32 side, std::size_t j, bool by_value) {
    drafts_[side / 3].edges[j] |= (by_value ? 9U : 1U) << side % 3;
  }

  void assign(const Edge& edge, std::size_t j) {
    std::array<u32, 2> side = {edge.forward, edge.backward};
    std::array<u32, 2> patch{};
    for (std::size_t k = 0; k < 2; ++k) {
      patch[k] = side[k] == kNone ? kNone : claim_.mesh.patch_of[side[k] / 3];
      if (patch[k] != kNone) side[k] = kNone;
    }
    if (patch[0] != kNone && patch[0] == patch[1]) return;
    const bool boundary = edge.forward == kNone || edge.backward == kNone;
    const bool loose = c_.loose_corners != 0 && (is_loose(edge.low, j) || is_loose(edge.high, j));
    if (loose && !boundary) return;
    for (const u32 s : side)
      if (s != kNone && !loose && c_.face_records[s / 3].verdict[j] == SmoothFaceRecord::kNoZero)
        return;
    for (const bool by_value : {false, true})
      for (const u32 s : side) {
        if (s == kNone || (by_value && loose)) continue;
        const FaceDraft& draft = drafts_[s / 3];
        if (((by_value ? draft.value : draft.slope)[j] >> s % 3 & 1U) == 0) continue;
        return mark(s, j, by_value);
      }
    open_.push_back({side, j, loose, kNone, false, {}});
  }

  void divide(FaceRecorder& recorder, Open& open) {
    for (const u32 side : open.side)
      for (const bool by_value : {false, true}) {
        if (side == kNone || (by_value && open.slope_only)) continue;
        open.segments.clear();
        const auto quantity = by_value ? Quantity::value : Quantity::along_edge;
        if (!recorder.record_segment({side / 3, open.colour, quantity, side % 3}, open.segments))
          continue;
        open.chosen = side;
        open.by_value = by_value;
        return;
      }
    const u32 any = open.side[0] != kNone ? open.side[0] : open.side[1];
    throw Undecided(fmt::format("face {}: number of {} crossings of edge {}", any / 3,
                                open.colour == 0 ? "blue" : "red", any % 3));
  }

  void complete(FaceRecorder& recorder, u32 face, std::size_t j) {
    FaceDraft& draft = drafts_[face];
    for (u32 i = 0; i < 3; ++i) {
      if ((draft.edges[j] >> i & 1U) == 0 || !draft.segments[j][i].empty()) continue;
      const bool by_value = (draft.edges[j] >> (3 + i) & 1U) != 0;
      const auto quantity = by_value ? Quantity::value : Quantity::along_edge;
      if (!recorder.record_segment({face, j, quantity, i}, draft.segments[j][i]))
        throw Undecided(fmt::format("face {}: crossings of edge {}", face, i));
    }
    draft.edges[j] |= 64;
  }

  const Claim& claim_;
  RidgesSmoothCertificate& c_;
  std::vector<FaceDraft>& drafts_;
  std::vector<Open> open_;
};

void append(Bytes& out, const Bytes& more) {
  for (const std::uint8_t byte : more) out.push_back(byte);
}

void write(const FaceDraft& draft, bool implicit, SmoothFaceRecord& record) {
  Bytes& out = record.witness;
  out.resize(implicit ? 1 : 0);
  if (draft.methods) out.push_back(static_cast<std::uint8_t>(*draft.methods));
  for (std::size_t j = 0; j < 2 && !record.in_patch; ++j)
    if (record.verdict[j] != SmoothFaceRecord::kNoZero)
      out.push_back(static_cast<std::uint8_t>(draft.edges[j]));
  append(out, draft.division);
  for (const auto& colour : draft.segments)
    for (const Bytes& segment : colour) append(out, segment);
  append(out, draft.places);
}

}  // namespace

std::vector<std::optional<Ranges>> record_faces(const Claim& claim, RidgesSmoothCertificate& c) {
  std::vector<FaceDraft> drafts(c.faces.size());
  constexpr std::size_t kTogether = FaceProvers::kTogether;
  for_all((drafts.size() + kTogether - 1) / kTogether, [&] { return FaceRecorder(claim, c); },
          [&](FaceRecorder& recorder, std::size_t group) {
            const auto first = static_cast<u32>(group * kTogether);
            const auto last = static_cast<u32>(std::min(first + kTogether, drafts.size()));
            recorder.prepare(first, last);
            for (u32 f = first; f < last; ++f) drafts[f] = recorder.record(f);
          });
  for (u32 f = 0; f < drafts.size(); ++f)
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t i = 0; i < 3; ++i)
        if ((drafts[f].loose[j] >> i & 1U) != 0)
          c.loose_corners = static_cast<std::uint8_t>(
              c.loose_corners | 1U << loose_bit(c.vertices[c.faces[f][i]], j));
  check_undrawn_arcs(claim);
  EdgeRecorder(claim, c, drafts).record();
  std::vector<std::optional<Ranges>> boxes;
  for (std::size_t f = 0; f < drafts.size(); ++f) {
    write(drafts[f], claim.surface.implicit, c.face_records[f]);
    boxes.push_back(drafts[f].box);
  }
  return boxes;
}

}  // namespace crest::certify::witness
