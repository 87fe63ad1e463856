// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/valence_code.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "algorithms/coding/mixer.hpp"
#include "algorithms/coding/numbers.hpp"
#include "algorithms/coding/stream_error.hpp"

namespace crest::coding {
namespace {

constexpr std::size_t kContexts = 6;
constexpr int kLineBits = 16;
constexpr std::uint8_t kExtra = 15;  ///< class of an extra vertex; of others min(valence, 13)

/// A corner of an active loop, and the edge to the next one.
struct Slot {
  Index vertex, next, previous;
  std::int32_t free;            ///< edges between its two neighbours still to come; -1: no more there
  std::uint8_t kind, opposite;  ///< classes of its vertex and of that across the edge
};

std::uint8_t class_of(std::uint32_t valence) { return static_cast<std::uint8_t>(std::min(valence, 13u)); }

/// Slots by free edges; of those with the fewest the latest first.
class Waiting {
 public:
  void add(const std::vector<Slot>& slots, Index s) {
    const auto k = static_cast<std::size_t>(std::min(slots[s].free, kMost));
    stacks_[k].push_back({s, slots[s].free});
    least_ = std::min(least_, k);
  }
  /// kNone if there is none.
  Index take(const std::vector<Slot>& slots) {
    for (; least_ < stacks_.size(); ++least_) {
      auto& stack = stacks_[least_];
      while (!stack.empty()) {
        const auto [s, free] = stack.back();
        stack.pop_back();
        if (slots[s].free == free) return s;
      }
    }
    return kNone;
  }

 private:
  static constexpr std::int32_t kMost = 63;
  struct Entry {
    Index slot;
    std::int32_t free;
  };
  std::array<std::vector<Entry>, kMost + 1> stacks_;
  std::size_t least_ = 0;
};

/// The mesh that is coded: what comes next, and which slot is where.
class Original {
 public:
  Original(const ClosedSurface& surface, CodedOrder& order)
      : s_(surface),
        order_(order),
        seen_(surface.valence.size(), 0),
        done_(surface.origin.size() / 3, 0),
        slot_(surface.origin.size(), kNone) {}

  bool has_extra() const { return s_.extra(s_.from(s_.starts[component_])); }
  void start() {
    gate_ = s_.starts[component_++];
    for (const Index h : {gate_, next(gate_), previous(gate_)}) {
      meet(s_.from(h));
      edge_.push_back(kNone);
    }
    // The loop runs against the triangle: its slots are corners 0, 2, 1.
    const auto base = static_cast<Index>(edge_.size() - 3);
    put(base, s_.twin[previous(gate_)]);
    put(base + 2, s_.twin[next(gate_)]);
    put(base + 1, s_.twin[gate_]);
    finish(gate_);
  }
  /// The valence of the k-th corner of the first triangle.
  Index start_valence(int k) const {
    Index h = s_.starts[component_];
    for (; k > 0; --k) h = next(h);
    return s_.valence[s_.from(h)];
  }
  void approach(Index f) { gate_ = edge_[f]; }
  Index slots() const { return static_cast<Index>(edge_.size()); }
  bool is_new() const { return !seen_[apex()]; }
  bool apex_is_extra() const { return s_.extra(apex()); }
  Index valence() const { return s_.valence[apex()]; }
  /// The triangle at the gate is joined to the slot x, a new one or the second half of one.
  void join(Index f, Index x) {
    if (x == edge_.size()) edge_.push_back(kNone);
    meet(apex());
    put(f, s_.twin[previous(gate_)]);
    put(x, s_.twin[next(gate_)]);
    finish(gate_);
  }
  void force(Index before) {
    put(before, s_.twin[next(gate_)]);
    finish(gate_);
  }
  void close() { finish(gate_); }
  /// The slot that the triangle at the gate meets; `after`: its free edges between the triangle and
  /// its next slot.
  Index meeting(Index& after) const {
    after = 0;
    Index g = next(s_.twin[previous(gate_)]);
    for (; !done_[s_.twin[g] / 3]; g = next(s_.twin[g])) ++after;
    return slot_[g];
  }
  /// What the first half of a split slot keeps: nothing changes for the edge that stays.
  void split(Index x, Index second) {
    edge_.push_back(kNone);
    put(second, edge_[x]);
  }

 private:
  static Index next(Index h) { return kernel::next_half(h); }
  static Index previous(Index h) { return kernel::previous_half(h); }
  Index apex() const { return s_.from(previous(gate_)); }
  void put(Index slot, Index h) {
    edge_[slot] = h;
    slot_[h] = slot;
  }
  void meet(Index v) { seen_[v] = 1; }
  void finish(Index h) {
    done_[h / 3] = 1;
    if (h / 3 < s_.faces) order_.corners.push_back(h);
  }

  const ClosedSurface& s_;
  CodedOrder& order_;
  std::vector<std::uint8_t> seen_, done_;
  std::vector<Index> slot_;  ///< of a half-edge along an active loop
  std::vector<Index> edge_;  ///< of a slot: the half-edge to the next slot, on the side to come
  Index gate_ = kNone, component_ = 0;
};


/// For decoding: there is nothing to look at.
struct NoOriginal {
  bool has_extra() const { return false; }
  void start() {}
  Index start_valence(int) const { return 0; }
  void approach(Index) {}
  bool is_new() const { return false; }
  bool apex_is_extra() const { return false; }
  Index valence() const { return 0; }
  void join(Index, Index) {}
  void force(Index) {}
  void close() {}
  Index meeting(Index&) const { return kNone; }
  void split(Index, Index) {}
};

template <class Range, class Mesh>
class ValenceRoutine {
 public:
  ValenceRoutine(Range& range, Mesh& mesh, const Counts& counts, Index max_faces)
      : range_(range),
        mesh_(mesh),
        counts_(counts),
        max_faces_(max_faces),
        loops_left_(counts.loops),
        lines_(kLineBits) {
    for (auto& row : new_)
      for (Counter& counter : row) counter = Counter((1 << 22) / 200 * 199, 4);
  }

  void run() {
    for (Index c = 0; c < counts_.components; ++c) {
      start();
      for (Index f = waiting_.take(slots_); f != kNone; f = waiting_.take(slots_)) step(f);
    }
    if (vertices_ != counts_.vertices || loops_left_ > 0)
      throw StreamError("has fewer vertices or boundary loops than the header says");
  }
  std::vector<Triangle>& faces() { return faces_; }
  Index splits() const { return splits_; }

 private:
  struct Vertex {
    Index number;  ///< kNone: an extra one
    std::uint32_t valence;
    std::uint8_t kind() const { return number == kNone ? kExtra : class_of(valence); }
  };

  Vertex add_vertex(std::uint32_t valence, bool extra) {
    if (extra) {
      --loops_left_;
      return {kNone, valence};
    }
    if (vertices_ == counts_.vertices) throw StreamError("has more vertices than the header says");
    return {vertices_++, valence};
  }
  Index add_slot(const Vertex& v, std::int32_t free, std::uint8_t opposite) {
    slots_.push_back({v.number, 0, 0, free, v.kind(), opposite});
    return static_cast<Index>(slots_.size() - 1);
  }
  void link(Index a, Index b) {
    slots_[a].next = b;
    slots_[b].previous = a;
  }
  void emit(Index a, Index b, Index c) {
    if (a == kNone || b == kNone || c == kNone) return;
    if (faces_.size() == max_faces_) throw StreamError("has more faces than are allowed");
    faces_.push_back({a, b, c});
  }
  void wait(Index s) { waiting_.add(slots_, s); }

  void start() {
    const bool open = loops_left_ > 0 && code_alone(range_, open_, mesh_.has_extra());
    std::array<Vertex, 3> v;
    for (int k = 0; k < 3; ++k) {
      const bool extra = open && k == 0;
      const std::uint32_t x =
          (extra ? loop_length_ : start_valence_).code(range_, mesh_.start_valence(k) - 3) + 3;
      v[static_cast<std::size_t>(k)] = add_vertex(x, extra);
    }
    mesh_.start();
    const Index base = static_cast<Index>(slots_.size());
    for (std::size_t k = 0; k < 3; ++k)
      add_slot(v[k], static_cast<std::int32_t>(v[k].valence) - 2, v[(k + 1) % 3].kind());
    link(base, base + 2);
    link(base + 2, base + 1);
    link(base + 1, base);
    for (Index k = 0; k < 3; ++k) wait(base + k);
    emit(v[0].number, v[1].number, v[2].number);
  }
  void step(Index f) {
    mesh_.approach(f);
    const Index n = slots_[f].next;
    if (slots_[f].free == 0) return force(f, n);
    Counter& counter = new_[least15(slots_[f].free)][least15(slots_[n].free)];
    if (code_alone(range_, counter, mesh_.is_new()))
      extend(f, n);
    else
      meet(f, n);
  }
  static std::size_t least15(std::int32_t x) { return static_cast<std::size_t>(std::min(x, 15)); }

  /// The triangle between the neighbours of f, which is used up.
  void force(Index f, Index n) {
    const Index p = slots_[f].previous;
    emit(slots_[f].vertex, slots_[n].vertex, slots_[p].vertex);
    slots_[f].free = -1;
    if (slots_[n].next == p) {
      if (slots_[n].free != 0 || slots_[p].free != 0)
        throw StreamError("closes a loop at which edges are missing");
      slots_[n].free = slots_[p].free = -1;
      mesh_.close();
      return;
    }
    if (slots_[n].free == 0 || slots_[p].free == 0)
      throw StreamError("has a vertex with more edges than its valence");
    mesh_.force(p);
    slots_[p].opposite = slots_[f].kind;
    link(p, n);
    --slots_[n].free;
    --slots_[p].free;
    wait(p);
    wait(n);
  }

  void extend(Index f, Index n) {
    const Vertex v = code_vertex(f, n);
    const Index x = add_slot(v, static_cast<std::int32_t>(v.valence) - 2, slots_[f].kind);
    mesh_.join(f, x);
    emit(slots_[f].vertex, slots_[n].vertex, v.number);
    slots_[f].opposite = slots_[n].kind;
    --slots_[f].free;
    --slots_[n].free;
    link(f, x);
    link(x, n);
    wait(x);
    wait(n);
    wait(f);
  }

  Vertex code_vertex(Index f, Index n) {
    const Context<kContexts> context = contexts(f, n);
    const auto row = static_cast<std::size_t>(std::min(slots_[f].free, 3));
    const auto decide = [&](std::size_t number, bool bit) {
      return code_mixed(range_, context, number, weights_[row][number], bit);
    };
    const std::uint32_t wanted = mesh_.valence();
    const bool extra = mesh_.apex_is_extra();
    if (decide(0, !extra && wanted == 6)) return add_vertex(6, false);
    if (decide(1, !extra && wanted < 6)) {
      if (decide(2, wanted == 5)) return add_vertex(5, false);
      return add_vertex(decide(3, wanted == 4) ? 4 : 3, false);
    }
    for (std::uint32_t k = 7; k < 13; ++k)
      if (decide(k - 3, !extra && wanted == k)) return add_vertex(k, false);
    if (loops_left_ > 0 && code_alone(range_, closes_, extra))
      return add_vertex(loop_length_.code(range_, wanted - 3) + 3, true);
    return add_vertex(large_.code(range_, wanted - 13) + 13, false);
  }

  Context<kContexts> contexts(Index sf, Index sn) {
    const Slot &f = slots_[sf], &n = slots_[sn], &p = slots_[f.previous], &nn = slots_[n.next];
    const auto dev = [](std::uint8_t kind) { return kind == kExtra ? 0 : int{kind} - 6; };
    const auto odd = [](std::uint8_t kind) { return kind != 6 ? 1 : 0; };
    const int five = dev(f.kind) + dev(n.kind) + dev(f.opposite) + dev(p.kind) + dev(nn.kind);
    const int five_odd = odd(f.kind) + odd(n.kind) + odd(f.opposite) + odd(p.kind) + odd(nn.kind);
    const int all = five + dev(f.kind) + dev(n.kind) + dev(p.opposite) + dev(n.opposite);
    const int all_odd = five_odd + odd(p.opposite) + odd(n.opposite);
    const auto ff = static_cast<std::uint64_t>(std::min(f.free, 15)),
               fn = static_cast<std::uint64_t>(std::min(n.free, 15)),
               fp = static_cast<std::uint64_t>(std::min(p.free, 15));
    const auto pack = [](std::uint64_t which, std::initializer_list<std::uint64_t> parts) {
      for (const std::uint64_t part : parts) which = which << 6 | part;
      return which;
    };
    return {
        &plain_,
        &lines_.of(pack(1, {f.kind, n.kind, std::min<std::uint64_t>(ff, 3)})),
        &lines_.of(pack(2, {static_cast<std::uint64_t>(five + 32) & 63, static_cast<std::uint64_t>(five_odd), ff})),
        &lines_.of(pack(3, {static_cast<std::uint64_t>(std::clamp(all, -32, 31) + 32), static_cast<std::uint64_t>(all_odd), ff, fn})),
        &lines_.of(pack(4, {f.kind, n.kind, f.opposite, p.kind, ff == 1 ? 1u : 0u})),
        &lines_.of(pack(5, {p.kind, fp, f.kind, p.opposite, n.opposite}))};
  }

  /// The triangle meets a slot, which splits the loop or joins another.
  void meet(Index f, Index n) {
    Index after = 0;
    ++splits_;
    const Index x = code_slot(f, mesh_.meeting(after));
    const auto inner = slots_[x].free - 2;
    const auto second_free = static_cast<std::int32_t>(
        code_below(range_, after, static_cast<std::uint32_t>(inner) + 1));
    const Index second = static_cast<Index>(slots_.size());
    slots_.push_back(slots_[x]);
    mesh_.split(x, second);
    mesh_.join(f, x);
    emit(slots_[f].vertex, slots_[n].vertex, slots_[x].vertex);
    link(second, slots_[x].next);
    link(f, second);
    link(x, n);
    slots_[x].opposite = slots_[f].kind;
    slots_[f].opposite = slots_[n].kind;
    slots_[x].free = inner - second_free;
    slots_[second].free = second_free;
    --slots_[f].free;
    --slots_[n].free;
    for (const Index s : {x, second, n, f}) wait(s);
  }

  /// A slot with two free edges or more, by its distance along the loop or by number.
  Index code_slot(Index f, Index wanted) {
    const auto [same, ahead, distance] = find(f, wanted);
    if (code_alone(range_, same_loop_, same)) {
      const bool forward = code_alone(range_, forward_, ahead);
      std::uint32_t left = distance_.code(range_, distance);
      const Index n = slots_[f].next;
      Index s = forward ? slots_[slots_[n].next].next : slots_[slots_[f].previous].previous;
      for (;; s = forward ? slots_[s].next : slots_[s].previous) {
        if (s == f || s == n) throw StreamError("splits a loop at a slot that is not there");
        if (slots_[s].free >= 2 && left-- == 0) break;
      }
      if (s == slots_[f].previous || s == slots_[n].next)
        throw StreamError("splits a loop into one of two edges");
      return s;
    }
    const Index s = code_below(range_, wanted, static_cast<std::uint32_t>(slots_.size()));
    if (slots_[s].free < 2 || s == f || s == slots_[f].next || s == slots_[f].previous ||
        s == slots_[slots_[f].next].next)
      throw StreamError("joins a slot that has no free edges");
    return s;
  }

  struct Place {
    bool same, ahead;
    std::uint32_t distance;
  };
  /// Walks both ways at once, so that the cost is the shorter distance.
  Place find(Index f, Index wanted) const {
    if (wanted == kNone) return {};
    const Index n = slots_[f].next;
    Index ahead = slots_[slots_[n].next].next, behind = slots_[slots_[f].previous].previous;
    std::uint32_t passed_ahead = 0, passed_behind = 0;
    bool ahead_ends = false, behind_ends = false;
    while (!ahead_ends || !behind_ends) {
      ahead_ends = ahead_ends || ahead == f;
      behind_ends = behind_ends || behind == n;
      if (!ahead_ends) {
        if (ahead == wanted) return {true, true, passed_ahead};
        passed_ahead += slots_[ahead].free >= 2 ? 1 : 0;
        ahead = slots_[ahead].next;
      }
      if (!behind_ends) {
        if (behind == wanted) return {true, false, passed_behind};
        passed_behind += slots_[behind].free >= 2 ? 1 : 0;
        behind = slots_[behind].previous;
      }
    }
    return {false, false, 0};
  }

  Range& range_;
  Mesh& mesh_;
  const Counts& counts_;
  Index max_faces_, loops_left_, vertices_ = 0, splits_ = 0;
  std::vector<Triangle> faces_;
  std::vector<Slot> slots_;
  Waiting waiting_;
  Lines lines_;
  Line plain_{};
  std::array<std::array<Weights<kContexts>, 10>, 4> weights_;
  std::array<std::array<Counter, 16>, 16> new_;
  Counter open_, closes_, same_loop_, forward_;
  SmallNumber start_valence_, loop_length_, large_, distance_;
};

}  // namespace

Bytes encode_valences(const Surface& surface, CodedOrder& order) {
  const ClosedSurface closed(surface);
  Original original(closed, order);
  RangeEncoder range;
  ValenceRoutine routine(range, original, surface.counts(), kNone);
  routine.run();
  order.faces = std::move(routine.faces());
  order.splits = routine.splits();
  return range.finish();
}

std::vector<Triangle> decode_valences(std::span<const std::uint8_t> bytes, const Counts& counts,
                                      Index max_faces) {
  RangeDecoder range(bytes);
  NoOriginal none;
  ValenceRoutine routine(range, none, counts, max_faces);
  routine.run();
  range.finish();
  return std::move(routine.faces());
}

}  // namespace crest::coding
