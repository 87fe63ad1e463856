// SPDX-License-Identifier: GPL-3.0-or-later
// Methods fan, zigzag, static (docs/cmc-format.md, sections 6 and 7).
#include <algorithm>

#include "certify/coding/decisions.hpp"
#include "certify/coding/stream.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;
constexpr u32 kNoGate = 0xffffffffu;

struct Edge {
  u32 vertex, next, previous, tri;
  bool alive = true;
};

/// Pieces of surface with their boundaries, and the stack of gates (section 6).
class Gluing {
 public:
  explicit Gluing(std::size_t faces) : most_faces_(faces) {}

  std::size_t slots() const { return edges_.size(); }
  std::size_t depth() const { return stack_.size(); }
  const Edge& edge(u32 s) const { return edges_[s]; }
  /// The gate `below` under the top one.
  u32 gate(std::size_t below) const {
    return below < stack_.size() ? stack_[stack_.size() - 1 - below] : kNoGate;
  }

  void leaf() {
    const u32 a = make(1), b = make(1), c = make(1);
    join(a, b);
    join(b, c);
    join(c, a);
    appear(a, b, c);
    stack_.push_back(a);
  }
  void left() {
    const u32 c = pop(), b = edges_[c].next, a = make(1);
    appear(a, b, c);
    ++edges_[b].tri;
    ++edges_[c].tri;
    join(c, a);
    join(a, b);
    stack_.push_back(a);
  }
  void right() {
    const u32 a = pop(), c = edges_[a].next, b = make(1);
    appear(a, b, c);
    ++edges_[a].tri;
    ++edges_[c].tri;
    join(a, b);
    join(b, c);
    stack_.push_back(a);
  }
  void both() {
    const u32 r = pop();
    join_pieces(pop(), r);
  }
  void split(u32 r) {
    require(r < edges_.size() && edges_[r].alive, "stream: a split at a slot that is gone");
    join_pieces(pop(), r);
  }
  void close(bool left) {
    const u32 top = pop();
    const u32 c = left ? top : edges_[top].next, a = left ? edges_[c].previous : top,
              b = edges_[c].next;
    require(edges_[c].tri >= 2, "stream: a vertex of fewer than three faces");
    appear(a, b, c);
    edges_[c].alive = false;
    ++edges_[a].tri;
    ++edges_[b].tri;
    join(a, b);
    require_three(a);
    stack_.push_back(a);
  }
  /// The triangle of a closed component that was left out.
  void cap(u32 a) {
    require(edges_[a].alive, "stream: a closed piece's gate is gone");
    const u32 b = edges_[a].next, c = edges_[b].next;
    require(edges_[c].next == a && a != b && b != c && a != c,
            "stream: a closed piece's last boundary has not three edges");
    appear(b, a, c);
  }
  const std::vector<u32>& stack() const { return stack_; }

  FaceList take(u32 vertices) {
    UnionFind sets(made_);
    for (const auto& [v, w] : same_) sets.join(v, w);
    std::vector<u32> least(made_, kNoGate), number(made_);
    u32 count = 0;
    for (u32 v = 0; v < made_; ++v) {
      u32& name = least[sets.find(v)];
      if (name == kNoGate) name = count++;
      number[v] = name;
    }
    require(count == vertices, "stream: {} vertices, the header says {}", count, vertices);
    for (auto& face : faces_)
      for (u32& v : face) v = number[v];
    return std::move(faces_);
  }

 private:
  u32 make(u32 tri) {
    edges_.push_back({made_++, 0, 0, tri});
    return static_cast<u32>(edges_.size() - 1);
  }
  u32 pop() {
    require(!stack_.empty(), "stream: no piece is left to glue");
    const u32 top = stack_.back();
    stack_.pop_back();
    require(edges_[top].alive, "stream: a gate is gone");
    return top;
  }
  void join(u32 s, u32 t) {
    edges_[s].next = t;
    edges_[t].previous = s;
  }
  void require_three(u32 s) const {
    const u32 t = edges_[s].next;
    require(t != s && edges_[t].next != s, "stream: a boundary of fewer than three edges");
  }
  void appear(u32 a, u32 b, u32 c) {
    require(faces_.size() < most_faces_, "stream: more faces than the mesh has");
    faces_.push_back({edges_[a].vertex, edges_[b].vertex, edges_[c].vertex});
  }
  void join_pieces(u32 l, u32 r) {
    const u32 b = edges_[l].next, c = edges_[r].next, before = edges_[l].previous;
    require(l != r && c != l && b != r, "stream: a piece glued to its own edge");
    appear(r, b, c);
    same_.push_back({edges_[l].vertex, edges_[c].vertex});
    edges_[c].tri += edges_[l].tri + 1;
    ++edges_[r].tri;
    ++edges_[b].tri;
    join(before, c);
    join(r, b);
    edges_[l].alive = false;
    require_three(c);
    require_three(r);
    stack_.push_back(r);
  }

  std::size_t most_faces_;
  u32 made_ = 0;
  std::vector<Edge> edges_;
  std::vector<u32> stack_;
  std::vector<std::pair<u32, u32>> same_;
  FaceList faces_;
};

enum Type : int { kLeaf = 0, kLeft = 1, kRight = 2, kBoth = 3 };

class StripDecoder {
 public:
  StripDecoder(std::span<const std::uint8_t> section, const StreamCounts& counts, int method,
               std::size_t faces)
      : in_(section), counts_(counts), method_(method), glue_(faces) {}

  FaceList run() {
    std::vector<bool> closed(counts_.components, counts_.loops == 0);
    if (counts_.components > 1 && counts_.loops > 0)
      for (std::size_t c = 0; c < closed.size(); ++c) closed[c] = in_.plain(1) != 0;
    const auto open = static_cast<std::int64_t>(std::count(closed.begin(), closed.end(), false));
    splits_ = 2 * std::int64_t{counts_.handles} + counts_.loops - open;
    require(splits_ >= 0, "stream: fewer loops than open components");
    const std::int64_t nodes =
        std::int64_t{counts_.vertices} - 2 * std::int64_t{counts_.components} + 2 * splits_;
    for (std::int64_t n = 0; n < nodes; ++n) method_ == 3 ? static_node() : node();
    in_.finish();
    require(glue_.depth() == closed.size() && splits_ == 0, "stream: pieces or splits are left");
    for (std::size_t c = 0; c < closed.size(); ++c)
      if (closed[c]) glue_.cap(glue_.stack()[c]);
    return glue_.take(counts_.vertices);
  }

 private:
  void add(Type type) {
    if (type == kLeaf) glue_.leaf();
    if (type == kLeft) glue_.left();
    if (type == kRight) glue_.right();
    if (type != kBoth) return;
    if (splits_ > 0 && in_.alone(split_)) {
      --splits_;
      glue_.split(static_cast<u32>(in_.below(glue_.slots())));
    } else {
      glue_.both();
    }
  }

  bool likely() { return in_.with(2654435769u, 32); }
  void static_node() {
    std::uint64_t length = 1;
    if (!likely())
      for (length = 2; likely();) ++length;
    if (length == 1) {
      if (!likely())
        add(kLeaf);
      else if (!likely())
        add(kLeft);
      else
        add(likely() ? kRight : kBoth);
      return;
    }
    add(likely() ? (length % 2 == 1 ? kLeft : kRight) : kBoth);
    for (std::uint64_t k = length - 1; k > 0; --k) glue_.close(k % 2 == 1);
  }

  /// Triangles at the vertices of a gate and its neighbours; 0 if there is no such gate.
  struct Around {
    int before = 0, first = 0, second = 0, after = 0;
  };
  Around around(u32 gate) const {
    if (gate == kNoGate) return {};
    const auto tri = [&](u32 s) { return static_cast<int>(std::min(glue_.edge(s).tri, 15u)); };
    const Edge& e = glue_.edge(gate);
    return {tri(e.previous), tri(gate), tri(e.next), tri(glue_.edge(e.next).next)};
  }

  void node() {
    const Around top = around(glue_.gate(0)), low = around(glue_.gate(1));
    const std::array<Line*, 6> lines = {
        &lines_(pack(1, last_[0])),
        &lines_(pack(2, top.first, top.second, last_[0])),
        &lines_(pack(3, top.first, top.second, low.first, low.second)),
        &lines_(pack(4, last_[0], last_[1], last_[2])),
        &lines_(pack(5, top.before, top.first, top.second, top.after)),
        &lines_(pack(6, top.second, low.first, last_[0], last_[1]))};
    const auto decide = [&](std::size_t d) { return in_.mixed(lines, d, type_mixers_[d]); };
    const bool left = decide(0), right = decide(left ? 1 : 2);
    const Type type = left ? (right ? kBoth : kLeft) : (right ? kRight : kLeaf);
    add(type);
    const std::uint64_t length = method_ == 1 ? fan_length(type) : zigzag_length(type);
    last_ = {16 * type + static_cast<int>(std::min<std::uint64_t>(length, 15)), last_[0], last_[1]};
  }

  /// A decision with the contexts of the length so far.
  bool longer(std::uint64_t length, int type, std::size_t decision, int weights) {
    const Around g = around(glue_.gate(0));
    const auto k = static_cast<int>(std::min<std::uint64_t>(length, 7));
    const int kind = 8 * type + k;
    return decide_length(lines_of(g, kind, type, k), decision, weights);
  }
  std::array<Line*, 6> lines_of(const Around& g, int kind, int type, int k) {
    return {&lines_(pack(11, kind)),
            &lines_(pack(12, g.first, g.second, kind)),
            &lines_(pack(13, g.before, g.first, g.second, g.after)),
            &lines_(pack(14, g.first, g.before, type)),
            &lines_(pack(15, g.second, g.after, type, std::min(k, 1))),
            &lines_(pack(16, g.first, g.second, last_[0], last_[1], kind))};
  }
  bool decide_length(const std::array<Line*, 6>& lines, std::size_t decision, int weights) {
    return in_.mixed(lines, decision, length_mixers_[static_cast<std::size_t>(weights)]);
  }

  std::uint64_t fan_length(Type type) {
    std::uint64_t length = 1;
    if (type == kLeaf || type == kLeft) return length;
    while (longer(length, type, 0,
                  (type == kBoth ? 8 : 0) + static_cast<int>(std::min<std::uint64_t>(length, 7)))) {
      glue_.close(true);
      ++length;
    }
    return length;
  }

  std::uint64_t zigzag_length(Type type) {
    std::uint64_t length = 1;
    if (type == kLeaf) return length;
    const auto lines = lines_of(around(glue_.gate(0)), 8 * type + 1, type, 1);
    if (!decide_length(lines, 0, 4 * type)) return length;
    const bool even = type == kRight || (type == kBoth && decide_length(lines, 1, 4 * type + 1));
    if (!even) {
      glue_.close(false);
      ++length;
    }
    glue_.close(true);
    ++length;
    while (longer(length, type, 2, 4 * type + 2)) {
      glue_.close(false);
      glue_.close(true);
      length += 2;
    }
    return length;
  }

  Decisions in_;
  const StreamCounts& counts_;
  int method_;
  Gluing glue_;
  std::int64_t splits_ = 0;
  Counter split_;
  Lines lines_;
  std::array<Mixer, 3> type_mixers_;
  std::array<Mixer, 16> length_mixers_;
  std::array<int, 3> last_{};
};

}  // namespace

FaceList decode_strips(std::span<const std::uint8_t> section, const StreamCounts& counts,
                       int method, std::size_t faces) {
  return StripDecoder(section, counts, method, faces).run();
}

}  // namespace crest::certify
