// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/valence_code.hpp"

#include <algorithm>
#include <array>

#include "algorithms/coding/stream_error.hpp"
#include "algorithms/coding/valence_model.hpp"
#include "kernel/geometry/stop.hpp"

namespace crest::coding {
namespace {

/// The mesh that is coded: what comes next, and which slot is where.
class Original {
 public:
  /// `surface` is used up: vertices are marked when met, and of half-edges along active loops the
  /// twin, which is not needed any more, gives way to the slot.
  Original(ClosedSurface& surface, CodedOrder& order) : s_(surface), order_(order) {
    order_.corners.reserve(s_.faces);
    edge_.reserve(s_.vertices);
  }

  bool has_extra() const { return s_.extra(s_.from(s_.starts[component_])); }
  void start() {
    gate_ = s_.starts[component_++];
    for (const Index h : {gate_, next(gate_), previous(gate_)}) {
      meet(s_.from(h));
      edge_.push_back(kNone);
    }
    // The loop runs against the triangle: its slots are corners 0, 2, 1.
    const auto base = static_cast<Index>(edge_.size() - 3);
    put(base, s_.twin(previous(gate_)));
    put(base + 2, s_.twin(next(gate_)));
    put(base + 1, s_.twin(gate_));
    finish();
  }
  /// The valence of the k-th corner of the first triangle.
  Index start_valence(std::size_t k) const {
    Index h = s_.starts[component_];
    for (; k > 0; --k) h = next(h);
    return s_.valence[s_.from(h)] & ~kMark;
  }
  void approach(Index f) { gate_ = edge_[f]; }
  bool is_new() const { return (s_.valence[apex()] & kMark) == 0; }
  bool apex_is_extra() const { return s_.extra(apex()); }
  Index valence() const { return s_.valence[apex()] & ~kMark; }
  /// The triangle at the gate is joined to the slot x, a new one or the second half of one.
  void join(Index f, Index x) {
    if (x == edge_.size()) edge_.push_back(kNone);
    meet(apex());
    put(f, s_.twin(previous(gate_)));
    put(x, s_.twin(next(gate_)));
    finish();
  }
  void force(Index before) {
    put(before, s_.twin(next(gate_)));
    finish();
  }
  void close() { finish(); }
  /// The slot that the triangle at the gate meets; `after`: its free edges between the triangle and
  /// its next slot.
  Index meeting(Index& after) const {
    after = 0;
    Index g = next(s_.twin(previous(gate_)));
    for (; (s_.twin(g) & kMark) == 0; g = next(s_.twin(g))) ++after;
    return s_.twin(g) & ~kMark;
  }
  /// What the first half of a split slot keeps: nothing changes for the edge that stays.
  void split(Index x, Index second) {
    edge_.push_back(kNone);
    put(second, edge_[x]);
  }

 private:
  static constexpr Index kMark = Index{1} << 31;

  static Index next(Index h) { return ClosedSurface::next(h); }
  static Index previous(Index h) { return ClosedSurface::previous(h); }
  Index apex() const { return s_.from(previous(gate_)); }
  void put(Index slot, Index h) {
    edge_[slot] = h;
    s_.twin(h) = slot | kMark;
  }
  void meet(Index v) { s_.valence[v] |= kMark; }
  void finish() {
    if (gate_ / 4 < s_.faces) order_.corners.push_back(gate_ - gate_ / 4);
  }

  ClosedSurface& s_;
  CodedOrder& order_;
  std::vector<Index> edge_;  ///< of a slot: the half-edge to the next slot, on the side to come
  Index gate_ = kNone, component_ = 0;
};

/// For decoding: there is nothing to look at.
struct NoOriginal {
  bool has_extra() const { return false; }
  void start() {}
  Index start_valence(std::size_t) const { return 0; }
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
        vertex_model_(range),
        split_model_(range) {
    for (auto& row : new_)
      for (Counter& counter : row) counter = Counter((1 << 22) / 200 * 199, 4);
  }

  void run() {
    for (Index c = 0; c < counts_.components; ++c) {
      start();
      for (Index f = loops_.take(); f != kNone; f = loops_.take()) {
        kernel::stop_point();
        step(f);
      }
    }
    if (vertices_ != counts_.vertices || loops_left_ > 0)
      throw StreamError("has fewer vertices or boundary loops than the header says");
  }
  std::vector<Triangle>& faces() { return faces_; }
  Index splits() const { return splits_; }

 private:
  /// A slot of a new vertex, which is kNone if it is an extra one.
  Index add_vertex(std::uint32_t valence, bool extra) {
    Slot slot{kNone, 0, 0, static_cast<std::int32_t>(valence) - 2, kExtraKind, 0};
    if (extra) {
      --loops_left_;
      return loops_.add(slot);
    }
    if (vertices_ == counts_.vertices) throw StreamError("has more vertices than the header says");
    slot.vertex = vertices_++;
    slot.kind = kind_of(valence);
    return loops_.add(slot);
  }
  void emit(Index a, Index b, Index c) {
    if (a == kNone || b == kNone || c == kNone) return;
    if (faces_.size() == max_faces_) throw StreamError("has more faces than are allowed");
    faces_.push_back({a, b, c});
  }

  void start() {
    const bool open = loops_left_ > 0 && code_alone(range_, open_, mesh_.has_extra());
    const Index base = loops_.size();
    for (Index k = 0; k < 3; ++k) {
      const bool extra = open && k == 0;
      add_vertex(vertex_model_.code_first(k, extra, mesh_.start_valence(k)), extra);
    }
    mesh_.start();
    loops_.link(base, base + 2);
    loops_.link(base + 2, base + 1);
    loops_.link(base + 1, base);
    for (Index k = 0; k < 3; ++k) {
      loops_[base + k].opposite = loops_[base + (k + 1) % 3].kind;
      loops_.wait(base + k);
    }
    emit(loops_[base].vertex, loops_[base + 1].vertex, loops_[base + 2].vertex);
  }

  void step(Index f) {
    mesh_.approach(f);
    const Index n = loops_[f].next;
    if (loops_[f].free == 0) return force(f, n);
    const auto least15 = [](std::int32_t x) { return static_cast<std::size_t>(std::min(x, 15)); };
    Counter& counter = new_[least15(loops_[f].free)][least15(loops_[n].free)];
    if (code_alone(range_, counter, mesh_.is_new()))
      extend(f, n);
    else
      meet(f, n);
  }

  /// The triangle between the neighbours of f, which is used up.
  void force(Index f, Index n) {
    const Index p = loops_[f].previous;
    emit(loops_[f].vertex, loops_[n].vertex, loops_[p].vertex);
    loops_[f].free = -1;
    if (loops_[n].next == p) {
      if (loops_[n].free != 0 || loops_[p].free != 0)
        throw StreamError("closes a loop at which edges are missing");
      loops_[n].free = loops_[p].free = -1;
      mesh_.close();
      return;
    }
    if (loops_[n].free == 0 || loops_[p].free == 0)
      throw StreamError("has a vertex with more edges than its valence");
    mesh_.force(p);
    loops_[p].opposite = loops_[f].kind;
    loops_.link(p, n);
    for (const Index s : {p, n}) {
      --loops_[s].free;
      loops_.wait(s);
    }
  }

  void extend(Index f, Index n) {
    const auto [valence, extra] = vertex_model_.code_next(
        loops_, f, {mesh_.valence(), mesh_.apex_is_extra()}, loops_left_ > 0);
    const Index x = add_vertex(valence, extra);
    mesh_.join(f, x);
    emit(loops_[f].vertex, loops_[n].vertex, loops_[x].vertex);
    close_gate(f, n, x, x);
    loops_.wait(x);
    loops_.wait(n);
    loops_.wait(f);
  }

  /// Between f and n there are now f -> second and first -> n, the two sides of the tip.
  void close_gate(Index f, Index n, Index first, Index second) {
    loops_.link(f, second);
    loops_.link(first, n);
    loops_[first].opposite = loops_[f].kind;
    loops_[f].opposite = loops_[n].kind;
    --loops_[f].free;
    --loops_[n].free;
  }

  /// The triangle meets a slot, which splits the loop or joins another.
  void meet(Index f, Index n) {
    ++splits_;
    Index after = 0;
    const Index wanted = mesh_.meeting(after), x = split_model_.code(loops_, f, wanted);
    const auto inner = static_cast<std::uint32_t>(loops_[x].free - 2);
    const std::uint32_t second_free = code_below(range_, after, inner + 1);
    const Index second = loops_.add(Slot(loops_[x]));
    mesh_.split(x, second);
    mesh_.join(f, x);
    emit(loops_[f].vertex, loops_[n].vertex, loops_[x].vertex);
    loops_.link(second, loops_[x].next);
    loops_[x].free = static_cast<std::int32_t>(inner - second_free);
    loops_[second].free = static_cast<std::int32_t>(second_free);
    close_gate(f, n, x, second);
    for (const Index s : {x, second, n, f}) loops_.wait(s);
  }

  Range& range_;
  Mesh& mesh_;
  const Counts& counts_;
  Index max_faces_, loops_left_, vertices_ = 0, splits_ = 0;
  std::vector<Triangle> faces_;
  ActiveLoops loops_;
  VertexModel<Range> vertex_model_;
  SplitModel<Range> split_model_;
  std::array<std::array<Counter, 16>, 16> new_;
  Counter open_;
};

}  // namespace

Bytes encode_valences(const Surface& surface, CodedOrder& order) {
  ClosedSurface closed(surface);
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
  return with_position(range, [&] {
    routine.run();
    range.finish();
    return std::move(routine.faces());
  });
}

}  // namespace crest::coding
