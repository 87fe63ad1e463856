// SPDX-License-Identifier: GPL-3.0-or-later
// Method valence (docs/cmc-format.md, section 5).
#include <algorithm>
#include <optional>

#include "certify/coding/decisions.hpp"
#include "certify/coding/stream.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;
constexpr int kExtra = 15;
constexpr u32 kNoSlot = 0xffffffffu;

struct Slot {
  u32 vertex, next, previous;
  std::uint64_t free;
  int opposite;  // a class
  bool alive = true;
  u32 pushed = 0;  // the latest push
};

/// Active loops of slots, and what is decoded of the closed surface.
class Loops {
 public:
  Loops(const StreamCounts& counts, std::size_t faces)
      : most_vertices_(counts.vertices), most_faces_(faces), loops_left_(counts.loops) {}

  Slot& operator[](u32 s) { return slots_[s]; }
  std::size_t size() const { return slots_.size(); }
  u32 loops_left() const { return loops_left_; }
  int class_of_vertex(u32 v) const { return class_[v]; }
  int class_of(u32 s) const { return class_[slots_[s].vertex]; }
  u32 make_vertex(bool extra, std::uint64_t valence) {
    if (extra) {
      require(loops_left_ > 0, "stream: more loops than the header says");
      --loops_left_;
      class_.push_back(kExtra);
      number_.push_back(kNoSlot);
    } else {
      require(real_ < most_vertices_, "stream: more vertices than the header says");
      class_.push_back(static_cast<int>(std::min<std::uint64_t>(valence, 13)));
      number_.push_back(real_++);
    }
    return static_cast<u32>(class_.size() - 1);
  }
  u32 make_slot(u32 vertex, std::uint64_t free, int opposite) {
    slots_.push_back({vertex, 0, 0, free, opposite});
    return static_cast<u32>(slots_.size() - 1);
  }
  void join(u32 s, u32 t) {
    slots_[s].next = t;
    slots_[t].previous = s;
  }
  void push(u32 s) {
    slots_[s].pushed = ++pushes_;
    const std::uint64_t heap = std::min<std::uint64_t>(slots_[s].free, 63);
    heaps_[static_cast<std::size_t>(heap)].push_back({s, pushes_});
  }
  /// The slot to go on with: of the fewest free edges, the latest.
  std::optional<u32> pop() {
    for (auto& heap : heaps_)
      while (!heap.empty()) {
        const auto [s, when] = heap.back();
        if (slots_[s].alive && slots_[s].pushed == when) return s;
        heap.pop_back();
      }
    return std::nullopt;
  }
  void appear(u32 a, u32 b, u32 c) {
    // A face has at most three boundary edges, each in one triangle of an extra vertex.
    require(triangles_++ < 4 * most_faces_, "stream: more triangles than the mesh has");
    const std::array<u32, 3> face = {number_[slots_[a].vertex], number_[slots_[b].vertex],
                                     number_[slots_[c].vertex]};
    if (std::find(face.begin(), face.end(), kNoSlot) != face.end()) return;
    require(faces_.size() < most_faces_, "stream: more faces than the mesh has");
    faces_.push_back(face);
  }
  void decrease(u32 s) {
    require(slots_[s].free > 0, "stream: a vertex has more edges than its valence");
    --slots_[s].free;
  }

  FaceList take() {
    require(real_ == most_vertices_ && loops_left_ == 0, "stream: vertices or loops are missing");
    return std::move(faces_);
  }

 private:
  u32 most_vertices_;
  std::size_t most_faces_, triangles_ = 0;
  u32 loops_left_, real_ = 0, pushes_ = 0;
  std::vector<int> class_;
  std::vector<u32> number_;  // of vertices, kNoSlot for extra ones
  std::vector<Slot> slots_;
  std::array<std::vector<std::pair<u32, u32>>, 64> heaps_;
  FaceList faces_;
};

/// Valences of new vertices.
class Valences {
 public:
  Valences(Decisions& in, Loops& slots) : in_(in), slots_(slots) {}

  std::uint64_t loop_length() { return 3 + in_.small(loop_length_); }
  /// Of corner k where a component begins, `last` the class of the one before it there.
  std::uint64_t first(std::size_t k, int last) {
    const auto& [b0, b1, b2] = before_;
    const std::array<Line*, 6> lines = {&plain_,
                                        &lines_(pack(6, k)),
                                        &lines_(pack(7, k, last)),
                                        &lines_(pack(8, k, before_[k])),
                                        &lines_(pack(9, k, before_[k], last)),
                                        &lines_(pack(10, k, b0, b1, b2, last))};
    return read_symbol(lines, 0, false).second;
  }

  /// The classes where a component began.
  void began(const std::array<int, 3>& classes) { before_ = classes; }
  std::pair<bool, std::uint64_t> next(u32 slot_f, u32 slot_n) {
    const u32 slot_p = slots_[slot_f].previous, slot_nn = slots_[slot_n].next;
    const int f = slots_.class_of(slot_f), n = slots_.class_of(slot_n), p = slots_.class_of(slot_p),
              nn = slots_.class_of(slot_nn);
    const int x = slots_[slot_f].opposite, xp = slots_[slot_p].opposite,
              xn = slots_[slot_n].opposite;
    const auto dev = [](int c) { return c == kExtra ? 0 : c - 6; };
    const auto odd = [](int c) { return c != 6 ? 1 : 0; };
    const int five = dev(f) + dev(n) + dev(x) + dev(p) + dev(nn),
              o5 = odd(f) + odd(n) + odd(x) + odd(p) + odd(nn),
              all = five + dev(f) + dev(n) + dev(xp) + dev(xn), o7 = o5 + odd(xp) + odd(xn);
    const auto free = [&](u32 s, std::uint64_t most) { return std::min(slots_[s].free, most); };
    const auto ff = free(slot_f, 15), fn = free(slot_n, 15), fp = free(slot_p, 15);
    const std::array<Line*, 6> lines = {&plain_,
                                        &lines_(pack(1, f, n, std::min<std::uint64_t>(ff, 3))),
                                        &lines_(pack(2, (five + 96) % 64, o5, ff)),
                                        &lines_(pack(3, clamped(all, -32, 31) + 32, o7, ff, fn)),
                                        &lines_(pack(4, f, n, x, p, ff == 1 ? 1 : 0)),
                                        &lines_(pack(5, p, fp, f, xp, xn))};
    return read_symbol(lines, static_cast<std::size_t>(free(slot_f, 3)), true);
  }

 private:
  /// Whether the vertex is an extra one; its valence.
  std::pair<bool, std::uint64_t> read_symbol(const std::array<Line*, 6>& lines, std::size_t row,
                                             bool may_be_extra) {
    const auto decide = [&](std::size_t d) { return in_.mixed(lines, d, mixers_[row][d]); };
    if (decide(0)) return {false, 6};
    if (decide(1)) {
      if (decide(2)) return {false, 5};
      return {false, decide(3) ? 4 : 3};
    }
    for (std::size_t d = 4; d < 10; ++d)
      if (decide(d)) return {false, d + 3};
    if (may_be_extra && slots_.loops_left() > 0 && in_.alone(extra_)) return {true, loop_length()};
    return {false, 13 + in_.small(large_)};
  }

  Decisions& in_;
  Loops& slots_;
  Counter extra_;
  std::array<Counter, 30> loop_length_, large_;
  std::array<int, 3> before_{};  // classes of the corners where the component before began
  Line plain_;
  Lines lines_;
  std::array<std::array<Mixer, 10>, 4> mixers_;
};

class ValenceDecoder {
 public:
  ValenceDecoder(std::span<const std::uint8_t> section, const StreamCounts& counts,
                 std::size_t faces)
      : in_(section),
        components_(counts.components),
        slots_(counts, faces),
        valences_(in_, slots_) {
    for (auto& row : new_)
      for (Counter& counter : row) counter = {(1 << 22) / 200 * 199, 4};
  }

  FaceList run() {
    for (u32 c = 0; c < components_; ++c) {
      begin_component();
      while (const auto f = slots_.pop()) step(*f);
    }
    in_.finish();
    return slots_.take();
  }

 private:
  void begin_component() {
    const bool extra = slots_.loops_left() > 0 && in_.alone(open_);
    std::array<u32, 3> corner{}, slot{};
    std::array<std::uint64_t, 3> valence{};
    std::array<int, 3> classes{};
    int last = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_extra = extra && k == 0;
      valence[k] = is_extra ? valences_.loop_length() : valences_.first(k, last);
      corner[k] = slots_.make_vertex(is_extra, valence[k]);
      classes[k] = last = slots_.class_of_vertex(corner[k]);
    }
    valences_.began(classes);
    for (std::size_t k = 0; k < 3; ++k)
      slot[k] =
          slots_.make_slot(corner[k], valence[k] - 2, slots_.class_of_vertex(corner[(k + 1) % 3]));
    slots_.join(slot[0], slot[2]);
    slots_.join(slot[2], slot[1]);
    slots_.join(slot[1], slot[0]);
    for (const u32 s : slot) slots_.push(s);
    slots_.appear(slot[0], slot[1], slot[2]);
  }

  void step(u32 f) {
    const u32 n = slots_[f].next, p = slots_[f].previous;
    if (slots_[f].free == 0) {
      forced(f, n, p);
      return;
    }
    const auto capped = [&](u32 s) {
      return static_cast<std::size_t>(std::min<std::uint64_t>(slots_[s].free, 15));
    };
    if (in_.alone(new_[capped(f)][capped(n)]))
      new_vertex(f, n);
    else
      old_slot(f, n, p);
  }

  void forced(u32 f, u32 n, u32 p) {
    slots_.appear(f, n, p);
    slots_[f].alive = false;
    if (slots_[n].next == p) {
      require(slots_[n].free == 0 && slots_[p].free == 0, "stream: edges are left in a last face");
      slots_[n].alive = slots_[p].alive = false;
      return;
    }
    slots_.decrease(n);
    slots_.decrease(p);
    slots_[p].opposite = slots_.class_of(f);
    slots_.join(p, n);
    slots_.push(p);
    slots_.push(n);
  }

  void new_vertex(u32 f, u32 n) {
    const auto [extra, valence] = valences_.next(f, n);
    const u32 x =
        slots_.make_slot(slots_.make_vertex(extra, valence), valence - 2, slots_.class_of(f));
    slots_.appear(f, n, x);
    slots_[f].opposite = slots_.class_of(n);
    slots_.decrease(f);
    slots_.decrease(n);
    slots_.join(f, x);
    slots_.join(x, n);
    slots_.push(x);
    slots_.push(n);
    slots_.push(f);
  }

  u32 walk_to_slot(u32 f, u32 n, u32 p) {
    const u32 nn = slots_[n].next;
    if (!in_.alone(same_)) {
      const auto x = static_cast<u32>(in_.below(slots_.size()));
      require(slots_[x].alive && slots_[x].free >= 2, "stream: a face at a slot without edges");
      return x;
    }
    const bool ahead = in_.alone(ahead_);
    std::uint64_t left = in_.small(distance_);
    for (u32 x = ahead ? slots_[nn].next : slots_[p].previous;;
         x = ahead ? slots_[x].next : slots_[x].previous) {
      require(x != f && x != n, "stream: a face beyond the end of its loop");
      if (slots_[x].free >= 2 && left-- == 0) return x;
    }
  }

  void old_slot(u32 f, u32 n, u32 p) {
    const u32 x = walk_to_slot(f, n, p);
    require(x != f && x != n && x != p && x != slots_[n].next, "stream: a face on its own edge");
    const std::uint64_t k = slots_[x].free - 2, b = in_.below(k + 1);
    const u32 y = slots_.make_slot(slots_[x].vertex, b, slots_[x].opposite);
    slots_.appear(f, n, x);
    slots_.join(y, slots_[x].next);
    slots_.join(f, y);
    slots_.join(x, n);
    slots_[x].opposite = slots_.class_of(f);
    slots_[f].opposite = slots_.class_of(n);
    slots_[x].free = k - b;
    slots_.decrease(f);
    slots_.decrease(n);
    for (const u32 s : {x, y, n, f}) slots_.push(s);
  }

  Decisions in_;
  u32 components_;
  Loops slots_;
  Valences valences_;
  Counter open_, same_, ahead_;
  std::array<Counter, 30> distance_;
  std::array<std::array<Counter, 16>, 16> new_;
};

}  // namespace

FaceList decode_valences(std::span<const std::uint8_t> section, const StreamCounts& counts,
                         std::size_t faces) {
  return ValenceDecoder(section, counts, faces).run();
}

}  // namespace crest::certify
