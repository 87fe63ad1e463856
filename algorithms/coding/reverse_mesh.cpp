// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/reverse_mesh.hpp"

#include "algorithms/coding/stream_error.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::coding {

Index ReverseMesh::pop() {
  if (gates_.empty()) throw StreamError("glues a triangle to a piece that is not there");
  const Index gate = gates_.back();
  gates_.pop_back();
  if (slots_[gate].triangles == 0) throw StreamError("glues a triangle to a gate that is used up");
  return gate;
}

void ReverseMesh::emit(Index a, Index b, Index c) {
  if (faces_.size() == max_faces_) throw StreamError("has more faces than are allowed");
  faces_.push_back({a, b, c});
}

void ReverseMesh::require_loop(Index s) const {
  const Index next = slots_[s].next;
  if (next == s || slots_[next].next == s)
    throw StreamError("makes a boundary of fewer than three edges");
}

void ReverseMesh::add_leaf() {
  const Index a = add_slot(vertices_), b = add_slot(vertices_ + 1), c = add_slot(vertices_ + 2);
  emit(vertices_, vertices_ + 1, vertices_ + 2);
  vertices_ += 3;
  link(a, b);
  link(b, c);
  link(c, a);
  gates_.push_back(a);
}

void ReverseMesh::add_left() {
  const Index c = pop(), b = slots_[c].next;
  const Index a = add_slot(vertices_++);
  emit(slots_[a].vertex, slots_[b].vertex, slots_[c].vertex);
  ++slots_[b].triangles;
  ++slots_[c].triangles;
  link(c, a);
  link(a, b);
  gates_.push_back(a);
}

void ReverseMesh::add_right() {
  const Index a = pop(), c = slots_[a].next;
  const Index b = add_slot(vertices_++);
  emit(slots_[a].vertex, slots_[b].vertex, slots_[c].vertex);
  ++slots_[a].triangles;
  ++slots_[c].triangles;
  link(a, b);
  link(b, c);
  gates_.push_back(a);
}

// The left gate runs from the tip to b, the right one from a to the tip.
void ReverseMesh::glue(Index left, Index right) {
  const Index b = slots_[left].next, tip = slots_[right].next;
  if (left == right || tip == left || b == right)
    throw StreamError("glues a triangle to neighbouring edges");
  emit(slots_[right].vertex, slots_[b].vertex, slots_[tip].vertex);
  joined_.emplace_back(slots_[left].vertex, slots_[tip].vertex);
  slots_[tip].triangles += slots_[left].triangles + 1;
  slots_[left].triangles = 0;
  ++slots_[right].triangles;
  ++slots_[b].triangles;
  link(slots_[left].previous, tip);
  link(right, b);
  require_loop(tip);
  require_loop(right);
  gates_.push_back(right);
}

void ReverseMesh::add_both() {
  const Index right = pop(), left = pop();
  glue(left, right);
}

void ReverseMesh::add_split(Index slot) {
  if (slot >= slots_.size() || slots_[slot].triangles == 0)
    throw StreamError("glues a triangle to an edge that is not on the boundary");
  glue(pop(), slot);
}

void ReverseMesh::close(bool left) {
  const Index gate = pop();
  const Index a = left ? slots_[gate].previous : gate;
  const Index tip = left ? gate : slots_[gate].next;
  const Index b = slots_[tip].next;
  if (slots_[tip].triangles < 2) throw StreamError("closes a vertex of fewer than three edges");
  emit(slots_[a].vertex, slots_[b].vertex, slots_[tip].vertex);
  slots_[tip].triangles = 0;
  ++slots_[a].triangles;
  ++slots_[b].triangles;
  link(a, b);
  require_loop(a);
  gates_.push_back(a);
}

void ReverseMesh::fill(std::size_t below) {
  const Index a = gate(below), b = slots_[a].next, c = slots_[b].next;
  if (slots_[a].triangles == 0 || slots_[c].next != a)
    throw StreamError("closes a boundary that has not three edges");
  emit(slots_[b].vertex, slots_[a].vertex, slots_[c].vertex);
}

std::vector<Triangle> ReverseMesh::take_faces(Index& vertices) {
  kernel::DisjointSets sets(vertices_);
  for (const auto& [v, w] : joined_) sets.unite(v, w);
  std::vector<Index> number(vertices_, kNone);
  vertices = 0;
  for (Index v = 0; v < vertices_; ++v)
    if (sets.find(v) == v) number[v] = vertices++;
  for (Triangle& face : faces_)
    for (Index& v : face) v = number[sets.find(v)];
  return std::move(faces_);
}

}  // namespace crest::coding
