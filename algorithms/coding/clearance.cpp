// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/clearance.hpp"

#include <algorithm>

#include "algorithms/coding/mixer.hpp"
#include "algorithms/coding/numbers.hpp"
#include "algorithms/coding/stream_error.hpp"

namespace crest::coding {
namespace {

constexpr std::uint32_t kMostRounds = 64;

/// Puts vertices back: a face with decision 1 becomes three. `wanted` (round, face), `split` (face)
/// after it has happened.
template <class Range, class Wanted, class Split>
void code_rounds(Range& range, std::uint32_t rounds, Index vertices, Index all, Index max_faces,
                 std::vector<Triangle>& faces, Wanted&& wanted, Split&& split) {
  Index next = vertices;
  for (std::uint32_t round = rounds; round > 0; --round) {
    std::array<Counter, 4> counters;  // by corners that were put back
    const std::size_t count = faces.size();
    for (std::size_t f = 0; f < count; ++f) {
      const auto [a, b, c] = faces[f];
      const int fresh = (a >= vertices ? 1 : 0) + (b >= vertices ? 1 : 0) + (c >= vertices ? 1 : 0);
      if (!code_alone(range, counters[static_cast<std::size_t>(fresh)], wanted(round, f))) continue;
      if (next == all) throw StreamError("has more vertices than the header says");
      if (faces.size() + 2 > max_faces) throw StreamError("has more faces than are allowed");
      faces[f] = {a, b, next};
      faces.push_back({b, c, next});
      faces.push_back({c, a, next++});
      split(f);
    }
  }
  if (next != all) throw StreamError("has fewer vertices than the header says");
}

/// How many vertices were taken out, in how many rounds.
struct Head {
  std::uint32_t removed = 0, rounds = 1;

  template <class Range>
  void code(Range& range) {
    removed = static_cast<std::uint32_t>(LargeNumber().code(range, removed));
    rounds = 1 + code_below(range, rounds - 1, kMostRounds);
  }
};

constexpr std::size_t kLengthBytes = 4;

}  // namespace

/// One round: vertices of which no two are of one face.
class Clearance::Round {
 public:
  Round(Index vertices, const std::vector<Triangle>& faces)
      : surface_(vertices, faces), merged_(faces.size(), false), gone_(vertices, false) {
    for (Index v = 0; v < vertices; ++v) look_at(v);
  }
  /// Fewer cost more decisions than they save.
  bool pays() const { return 256 * made_.size() >= merged_.size(); }

  void apply(Clearance& c) const {
    std::vector<Index> number(gone_.size(), kNone), left;
    c.vertices_ = 0;
    for (Index v = 0; v < gone_.size(); ++v)
      if (!gone_[v]) number[v] = c.vertices_++;
    std::vector<Triangle> faces;
    const auto keep = [&](Index node, Triangle face) {
      left.push_back(node);
      for (Index& v : face) v = number[v];
      faces.push_back(face);
    };
    for (std::size_t f = 0; f < merged_.size(); ++f)
      if (!merged_[f]) keep(c.left_[f], c.faces_[f]);
    ++c.rounds_;
    for (const Halves& halves : made_) {
      keep(static_cast<Index>(c.nodes_.size()),
           {surface_.from(halves[0]), surface_.from(halves[1]), surface_.from(halves[2])});
      Node& node = c.nodes_.emplace_back(Node{c.rounds_, {}});
      for (std::size_t k = 0; k < 3; ++k)
        node.children[k] = {c.left_[halves[k] / 3], halves[k] % 3};
    }
    c.left_ = std::move(left);
    c.faces_ = std::move(faces);
  }

 private:
  using Halves = std::array<Index, 3>;  ///< around a vertex, opposite to it

  void look_at(Index v) {
    if (surface_.twin(surface_.table().half_of(v)) == kNone) return;
    Halves halves{};
    std::size_t valence = 0;
    surface_.around(v, [&](Index h) {
      if (valence < 3) halves[valence] = next_half(h);
      ++valence;
    });
    if (valence != 3) return;
    // Both sides of one triangle must not be left: the faces outside are not one, and stay.
    Halves outside{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Index twin = surface_.twin(halves[k]);
      outside[k] = twin == kNone ? kNone : twin / 3;
      if (merged_[halves[k] / 3] || (twin != kNone && merged_[twin / 3])) return;
    }
    if (outside[0] != kNone && outside[0] == outside[1] && outside[1] == outside[2]) return;
    gone_[v] = true;
    for (const Index h : halves) merged_[h / 3] = true;
    made_.push_back(halves);
  }

  Surface surface_;
  std::vector<bool> merged_, gone_;  ///< faces, vertices
  std::vector<Halves> made_;
};

Clearance::Clearance(const Surface& surface)
    : vertices_(surface.counts().vertices),
      mesh_faces_(surface.face_count()),
      nodes_(mesh_faces_),
      faces_(surface.faces().begin(), surface.faces().end()) {
  for (Index f = 0; f < mesh_faces_; ++f) left_.push_back(f);
  while (static_cast<std::uint32_t>(rounds_) < kMostRounds) {
    const Round round(vertices_, faces_);
    if (!round.pays()) break;
    round.apply(*this);
  }
}

Bytes Clearance::finish(const Bytes& base, CodedOrder& order) const {
  std::vector<Turned> turned;
  for (const Index h : order.corners) turned.push_back({left_[h / 3], h % 3});
  const auto removed = static_cast<Index>(nodes_.size()) - mesh_faces_;
  RangeEncoder range;
  Head{removed, static_cast<std::uint32_t>(rounds_)}.code(range);
  code_rounds(
      range, static_cast<std::uint32_t>(rounds_), vertices_, vertices_ + removed, kNone,
      order.faces,
      [&](std::uint32_t round, std::size_t f) {
        return nodes_[turned[f].node].round == static_cast<int>(round);
      },
      [&](std::size_t f) {
        const Turned face = turned[f];
        const auto child = [&](Index k) {
          return nodes_[face.node].children[(face.first + k) % 3];
        };
        const std::array<Turned, 3> three = {child(0), child(1), child(2)};
        turned[f] = three[0];
        turned.insert(turned.end(), {three[1], three[2]});
      });
  order.corners.clear();
  for (const auto& [node, first] : turned) order.corners.push_back(3 * node + first);
  Bytes bytes(kLengthBytes);
  for (std::size_t i = 0; i < kLengthBytes; ++i)
    bytes[i] = static_cast<std::uint8_t>(base.size() >> (8 * i));
  for (const Bytes& part : {base, range.finish()})
    for (const std::uint8_t byte : part) bytes.push_back(byte);
  return bytes;
}

std::vector<Triangle> decode_cleared(
    std::span<const std::uint8_t> bytes, const Counts& counts, Index max_faces,
    const std::function<std::vector<Triangle>(std::span<const std::uint8_t>, const Counts&)>&
        decode_base) {
  std::size_t size = 0;
  for (std::size_t i = kLengthBytes; i-- > 0 && bytes.size() >= kLengthBytes;)
    size = size << 8 | bytes[i];
  if (bytes.size() < kLengthBytes || size > bytes.size() - kLengthBytes)
    throw StreamError("is shorter than it says");
  RangeDecoder range(bytes.subspan(kLengthBytes + size));
  Head head;
  head.code(range);
  Counts base = counts;
  if (head.removed >= counts.vertices) throw StreamError("has fewer vertices than the header says");
  base.vertices -= head.removed;
  std::vector<Triangle> faces = decode_base(bytes.subspan(kLengthBytes, size), base);
  with_position(range, [&] {
    code_rounds(
        range, head.rounds, base.vertices, counts.vertices, max_faces, faces,
        [](std::uint32_t, std::size_t) { return false; }, [](std::size_t) {});
    range.finish();
  });
  return faces;
}

}  // namespace crest::coding
