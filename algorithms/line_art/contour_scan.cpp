// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/contour_scan.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace crest::line_art {
namespace {

using kernel::Decision, kernel::EventPlane, kernel::Sign, kernel::Stage;

PageBox box_of(const std::vector<PagePoint>& seen, std::span<const Index> corners) {
  PageBox box;
  for (const Index v : corners) box.add(seen[v]);
  return box;
}

CellFrame frame_of(const Scene& scene, const std::vector<PagePoint>& seen) {
  double sum = 0;
  for (const kernel::Triangle& f : scene.faces)
    sum += std::hypot(seen[f[0]].x - seen[f[1]].x, seen[f[0]].y - seen[f[1]].y);
  return {seen, sum / static_cast<double>(scene.faces.size()), scene.faces.size()};
}

CellLists face_lists(const CellFrame& frame, const Scene& scene,
                     const std::vector<PagePoint>& seen) {
  return {frame, static_cast<Index>(scene.faces.size()), [&](Index f) {
            const kernel::Triangle& t = scene.faces[f];
            return std::array<const PagePoint*, 3>{&seen[t[0]], &seen[t[1]], &seen[t[2]]};
          }};
}

std::array<const PagePoint*, 2> ends_of(const std::vector<PagePoint>& seen, const ContourEdge& e) {
  return {&seen[e.a], &seen[e.b]};
}

}  // namespace

ScanScene::ScanScene(const Scene& scene_in, const View& view, std::vector<ContourEdge> edges_in,
                     FaceSides sides_in)
    : scene(scene_in),
      sight(view.eye, scene.points),
      seen(view.see(scene.points)),
      sides(std::move(sides_in)),
      frame(frame_of(scene, seen)),
      faces(face_lists(frame, scene, seen)),
      occluders(frame, static_cast<Index>(edges_in.size()),
                [&](Index e) { return ends_of(seen, edges_in[e]); }),
      around_begin(scene.points.size() + 1, 0),
      edges(std::move(edges_in)) {
  for (const kernel::Triangle& f : scene.faces) face_boxes.push_back(box_of(seen, f));
  std::vector<bool> wanted(scene.points.size());
  for (const ContourEdge& e : edges) {
    edge_boxes.push_back(box_of(seen, std::array{e.a, e.b}));
    wanted[e.a] = wanted[e.b] = true;
  }
  for (const kernel::Triangle& f : scene.faces)
    for (const Index v : f) around_begin[v + 1] += wanted[v];
  for (std::size_t v = 1; v < around_begin.size(); ++v) around_begin[v] += around_begin[v - 1];
  around.resize(around_begin.back());
  std::vector<Index> next(around_begin.begin(), around_begin.end() - 1);
  for (Index f = 0; f < scene.faces.size(); ++f)
    for (const Index v : scene.faces[f])
      if (wanted[v]) around[next[v]++] = f;
}

bool EdgeScan::has(Index face, Index v) const {
  const kernel::Triangle& f = s_.scene.faces[face];
  return f[0] == v || f[1] == v || f[2] == v;
}

Index EdgeScan::faces_before(Index v) {
  const PagePoint* const corner[] = {&s_.seen[v]};
  const PageBox box = box_of(s_.seen, std::array{v});
  s_.faces.gather(s_.frame, corner, found_);
  Index count = 0;
  for (const Index f : found_) {
    const PageBox& other = s_.face_boxes[f];
    if (other.near1 < box.near0 || !other.meets(box) || has(f, v)) continue;
    count += s_.sight.covers(s_.scene.faces[f], v, counts);
  }
  return count;
}

/// Is the face (a, p, q), which does not have b, in front of where ab begins.
bool EdgeScan::wedge_before(const kernel::Triangle& f, Index a, Index b) {
  const std::size_t k = f[0] == a ? 0 : f[1] == a ? 1 : 2;
  const Index p = f[(k + 1) % 3], q = f[(k + 2) % 3];
  const Sign turn = s_.sight.side(a, p, q, counts).sign;
  if (s_.sight.side(a, p, b, counts).sign != turn || s_.sight.side(a, b, q, counts).sign != turn)
    return false;
  // [a, p, q, e] = -[e, a, p, q].
  return s_.sight.volume(a, p, q, b, counts).sign == turn;
}

Index EdgeScan::faces_at(Index a, Index b) {
  Index count = 0;
  for (const Index f : s_.around_vertex(a))
    if (!has(f, b)) count += wedge_before(s_.scene.faces[f], a, b);
  return count;
}

void EdgeScan::find_crossings(Index edge) {
  const ContourEdge& e = s_.edges[edge];
  const PageBox& box = s_.edge_boxes[edge];
  s_.occluders.gather(s_.frame, ends_of(s_.seen, e), found_);
  for (const Index other : found_) {
    const ContourEdge& o = s_.edges[other];
    const PageBox& obox = s_.edge_boxes[other];
    if (!o.occluding || o.a == e.a || o.a == e.b || o.b == e.a || o.b == e.b) continue;
    if (obox.near1 < box.near0 || !obox.meets(box)) continue;
    const Sign at_b = s_.sight.side(o.a, o.b, e.b, counts).sign;
    if (s_.sight.side(o.a, o.b, e.a, counts).sign == at_b) continue;
    if (s_.sight.side(e.a, e.b, o.a, counts).sign == s_.sight.side(e.a, e.b, o.b, counts).sign)
      continue;
    if (!s_.sight.in_front(e.a, e.b, o.a, o.b, counts)) continue;
    const int gain = static_cast<int>(o.left) - static_cast<int>(o.right);
    events.push_back({SightEvent::Kind::crossing, other, at_b == Sign::positive ? gain : -gain,
                      s_.sight.place(e.a, e.b, {o.a, o.b}, counts)});
  }
}

void EdgeScan::find_piercings(Index edge) {
  const ContourEdge& e = s_.edges[edge];
  const PageBox& box = s_.edge_boxes[edge];
  s_.faces.gather(s_.frame, ends_of(s_.seen, e), found_);
  for (const Index f : found_) {
    const PageBox& other = s_.face_boxes[f];
    if (other.near1 < box.near0 || other.near0 > box.near1 || !other.meets(box)) continue;
    const auto [p, q, r] = s_.scene.faces[f];
    const bool has_a = has(f, e.a), has_b = has(f, e.b);
    if (has_a && has_b) continue;
    // A corner is in the plane whatever moves.
    const Decision a =
        has_a ? Decision{Sign::zero, Stage::symbolic} : s_.sight.volume(p, q, r, e.a, counts);
    const Decision b =
        has_b ? Decision{Sign::zero, Stage::symbolic} : s_.sight.volume(p, q, r, e.b, counts);
    if (a.stage == Stage::symbolic && b.stage == Stage::symbolic && s_.sides.flat[f] == 0)
      touching_.push_back(f);
    if (has_a || has_b || a.sign == b.sign) continue;
    const Sign turn = s_.sight.volume(e.a, e.b, p, q, counts).sign;
    if (s_.sight.volume(e.a, e.b, q, r, counts).sign != turn ||
        s_.sight.volume(e.a, e.b, r, p, counts).sign != turn)
      continue;
    // [p, q, r, e] = -[e, p, q, r]: b is behind the face if its sign is the face's.
    const int change = static_cast<int>(b.sign) == s_.sides.sign[f] ? 1 : -1;
    events.push_back(
        {SightEvent::Kind::piercing, f, change, s_.sight.place(e.a, e.b, {p, q, r}, counts)});
  }
}

/// When a face that touches the edge is in front of it: one contact event a change.
void EdgeScan::add_contact(Index a, Index b, Index face) {
  const kernel::Triangle& f = s_.scene.faces[face];
  bool before = has(face, a) ? wedge_before(f, a, b) : s_.sight.covers(f, a, counts);
  touching_start_ += before;
  const auto add = [&](const EventPlane& plane) {
    events.push_back({SightEvent::Kind::contact, face, 0, s_.sight.place(a, b, plane, counts)});
  };
  const std::size_t first = events.size();
  for (std::size_t k = 0; k < 3; ++k) {
    const Index p = f[k], q = f[(k + 1) % 3];
    if (p == a || p == b || q == a || q == b) continue;
    if (s_.sight.crosses(a, b, p, q, counts) && s_.sight.in_front(a, b, p, q, counts)) add({p, q});
  }
  if (!has(face, a) && !has(face, b) && s_.sight.pierces(a, b, f, counts)) add({f[0], f[1], f[2]});
  std::stable_sort(events.begin() + static_cast<std::ptrdiff_t>(first), events.end(),
                   [&](const SightEvent& x, const SightEvent& y) {
                     return s_.sight.event_order(a, b, x.place, y.place, counts) == Sign::negative;
                   });
  for (std::size_t i = first; i < events.size(); ++i) {
    events[i].change = before ? -1 : 1;
    before = !before;
  }
}

void EdgeScan::make_pieces(Index a, Index b) {
  int in_front = static_cast<int>(start), touching = static_cast<int>(touching_start_);
  double from = 0;
  bool ended = false;
  const auto close = [&](double to) {
    pieces.push_back({from, to, static_cast<Index>(in_front), static_cast<Index>(touching)});
    from = to;
  };
  for (std::size_t i = 0, end = 0; i < events.size(); i = end) {
    int change = 0, contact = 0;
    bool seen = false;
    for (end = i; end < events.size() &&
                  (end == i || s_.sight.event_order(a, b, events[i].place, events[end].place,
                                                    counts) == Sign::zero);
         ++end) {
      const bool touches = events[end].kind == SightEvent::Kind::contact;
      (touches ? contact : change) += events[end].change;
      seen = seen || !touches;
    }
    const kernel::EventPlace& place = events[i].place;
    if (place.at_end() && !ended) {
      close(1);
      ended = true;
    } else if ((seen || contact != 0) && !place.at_start() && !ended) {
      close(place.guess());
    }
    in_front += change;
    touching += contact;
    if (in_front < 0) throw std::logic_error("contours: fewer than no faces in front");
  }
  if (!ended) close(1);
  finish = static_cast<Index>(in_front);
}

void EdgeScan::scan(Index edge, const std::vector<Index>& far) {
  const ContourEdge& e = s_.edges[edge];
  events.clear();
  pieces.clear();
  touching_.clear();
  touching_start_ = 0;
  find_crossings(edge);
  find_piercings(edge);
  for (const Index f : touching_) add_contact(e.a, e.b, f);
  std::stable_sort(events.begin(), events.end(), [&](const SightEvent& x, const SightEvent& y) {
    return s_.sight.event_order(e.a, e.b, x.place, y.place, counts) == Sign::negative;
  });
  start = far[e.a] + faces_at(e.a, e.b);
  make_pieces(e.a, e.b);
  if (finish != far[e.b] + faces_at(e.b, e.a))
    throw std::logic_error("contours: faces in front do not balance on edge " +
                           std::to_string(e.a) + "-" + std::to_string(e.b));
}

}  // namespace crest::line_art
