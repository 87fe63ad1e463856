// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/lineart/contours.hpp"

#include <cmath>

#include "certify/container/reject.hpp"
#include "certify/lineart/span.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;
using kernel::Rational;
using kernel::Sign;

/// Two numbers of a point that all points of its sight line share, enclosed.
PlaneBox picture_box(const LineArtCertificate& c, const std::array<double, 3>& p) {
  std::array<Span, 2> place{};
  if (c.parallel) {
    // With e_k the largest coordinate, (e_k p_i - e_i p_k) does not change along e.
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::fabs(c.eye[i]) > std::fabs(c.eye[k])) k = i;
    // By a power of two, so that products neither vanish nor overflow for the direction's sake.
    int exponent = 0;
    std::frexp(c.eye[k], &exponent);
    const auto direction = [&](std::size_t i) {
      const double x = std::ldexp(c.eye[i], -exponent);
      return i == k ? Span(x) : Span(x, x);  // the least numbers lose digits
    };
    for (std::size_t n = 0; n < 2; ++n) {
      const std::size_t i = (k + 1 + n) % 3;
      place[n] = direction(k) * Span(p[i]) - direction(i) * Span(p[k]);
    }
  } else {
    std::array<Span, 3> along;
    for (std::size_t n = 0; n < 3; ++n)
      for (std::size_t k = 0; k < 3; ++k)
        along[n] = along[n] + Span(c.view.axes[n][k]) * (Span(p[k]) - Span(c.eye[k]));
    for (std::size_t n = 0; n < 2; ++n) place[n] = along[n] / along[2];
  }
  return box_of(place);
}

/// A dyadic number between two rationals, of few digits: the k-th that is tried.
Rational between(const Rational& from, const Rational& to, unsigned k) {
  // Steps of 2^-n are below a quarter of the gap, and smaller for later tries.
  Rational step = 1;
  while (4 * step > to - from) step /= 2;
  step /= boost::multiprecision::mpz_int(1) << (2 * k);
  const Rational middle = (from + to) / 2 / step;
  const boost::multiprecision::mpz_int whole = numerator(middle) / denominator(middle);
  return Rational(whole + (k % 2 == 0 ? 0 : 1)) * step;
}

}  // namespace

/// A place where something may change; without an event it only parts pieces.
struct Contours::Candidate {
  Rational t;
  std::optional<LineEvent> event;
};

Contours::Contours(const LineArtCertificate& c) : c_(c), o_(c) {
  for (const auto& [p, q, r] : c.faces) {
    face_side_.push_back(o_.sign(kEye, id_of(p), id_of(q), id_of(r)));
    plain_side_.push_back(o_.plain_sign(kEye, id_of(p), id_of(q), id_of(r)));
  }
  for (const auto& p : c.points) vertex_box_.push_back(picture_box(c, p));
  collect_edges();
  const auto boxes = [&](const auto& items, auto corners) {
    std::vector<PlaneBox> list;
    for (const auto& item : items) {
      PlaneBox box;
      for (const u32 v : corners(item)) box.add(vertex_box_[v]);
      list.push_back(box);
    }
    return list;
  };
  faces_ = std::make_unique<BoxTree>(boxes(c.faces, [](const auto& face) { return face; }));
  occluders_ = std::make_unique<BoxTree>(boxes(occluding_, [](const SceneEdge& e) {
    return std::array{e.low, e.high};
  }));
}

Contours::~Contours() = default;

void Contours::collect_edges() {
  struct Side {
    u32 low, high, face;
    bool turned;
  };
  std::vector<Side> sides;
  for (u32 f = 0; f < c_.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const u32 a = c_.faces[f][k], b = c_.faces[f][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), f, b < a});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return std::array{s.low, s.high, s.face} < std::array{t.low, t.high, t.face};
  });
  std::size_t listed = 0;
  for (std::size_t i = 0, n = 0; i < sides.size(); i = n) {
    int balance = 0, plain_balance = 0;
    for (n = i; n < sides.size() && sides[n].low == sides[i].low && sides[n].high == sides[i].high;
         ++n) {
      const int way = sides[n].turned ? -1 : 1;
      const Sign plain = plain_side_[sides[n].face];
      balance += way * (face_side_[sides[n].face] == Sign::positive ? 1 : -1);
      plain_balance += plain == Sign::zero ? 0 : way * (plain == Sign::positive ? 1 : -1);
    }
    SceneEdge edge{sides[i].low, sides[i].high, balance != 0, balance == 0 && plain_balance != 0,
                   false};
    const std::array<u32, 2> ends = {edge.low, edge.high};
    if (listed < c_.creases.size() && c_.creases[listed] == ends) {
      edge.crease = true;
      ++listed;
    }
    if (edge.occluding) occluding_.push_back(edge);
    if (edge.occluding || edge.rim || edge.crease) drawn_.push_back(edge);
  }
  require(listed == c_.creases.size(), "crease {}: is no edge of a face, or not in ascending order",
          listed);
}

void Contours::add_crossings(EdgeEnds ends, const PlaneBox& box,
                             std::vector<Candidate>& found) const {
  const PointId a = ends.a, b = ends.b;
  occluders_->query(box, [&](u32 i) {
    const SceneEdge& other = occluding_[i];
    const PointId c = id_of(other.low), d = id_of(other.high);
    if (c == a || c == b || d == a || d == b) return;
    if (o_.sign(kEye, c, d, a) == o_.sign(kEye, c, d, b)) return;
    if (o_.sign(kEye, a, b, c) == o_.sign(kEye, a, b, d)) return;
    // On the other edge the place seen is on d's side of the plane a b c, and in front on e's.
    if (o_.sign(a, b, c, kEye) != o_.sign(a, b, c, d)) return;
    found.push_back(
        {o_.limit(kEye, c, d, ends), LineEvent{LineEvent::kCrossing, other.low, other.high}});
  });
}

bool Contours::touches(u32 face, EdgeEnds ends) const {
  const std::array<PointId, 3> v = {id_of(c_.faces[face][0]), id_of(c_.faces[face][1]),
                                    id_of(c_.faces[face][2])};
  const auto on_plane = [&](PointId x) {
    return std::find(v.begin(), v.end(), x) != v.end() ||
           o_.plain_sign(v[0], v[1], v[2], x) == Sign::zero;
  };
  return plain_side_[face] != Sign::zero && on_plane(ends.a) && on_plane(ends.b);
}

void Contours::add_face_events(EdgeEnds ends, const PlaneBox& box, std::vector<Candidate>& found,
                               std::vector<u32>& touching) const {
  const PointId a = ends.a, b = ends.b;
  faces_->query(box, [&](u32 f) {
    const std::array<PointId, 3> v = {id_of(c_.faces[f][0]), id_of(c_.faces[f][1]),
                                      id_of(c_.faces[f][2])};
    const auto has = [&](PointId x) { return std::find(v.begin(), v.end(), x) != v.end(); };
    if (has(a) && has(b)) return;
    if (!has(a) && !has(b) && o_.sign(v[0], v[1], v[2], a) != o_.sign(v[0], v[1], v[2], b)) {
      const Sign side = o_.sign(a, b, v[0], v[1]);
      if (side == o_.sign(a, b, v[1], v[2]) && side == o_.sign(a, b, v[2], v[0]))
        found.push_back({o_.limit(v[0], v[1], v[2], ends), LineEvent{LineEvent::kPiercing, f, 0}});
    }
    if (!touches(f, ends)) return;
    touching.push_back(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId c = v[k], d = v[(k + 1) % 3];
      if (c == a || c == b || d == a || d == b) continue;
      if (o_.sign(kEye, c, d, a) != o_.sign(kEye, c, d, b))
        found.push_back({o_.limit(kEye, c, d, ends), std::nullopt});
    }
  });
}

/// Nothing where one of the determinants vanishes.
std::optional<bool> Contours::in_front(u32 face, EdgeEnds ends, const EdgePoint& at) const {
  const std::array<PointId, 3> v = {id_of(c_.faces[face][0]), id_of(c_.faces[face][1]),
                                    id_of(c_.faces[face][2])};
  std::optional<Sign> first;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto side = o_.sign_at(kEye, v[k], v[(k + 1) % 3], ends, at);
    if (!side) return std::nullopt;
    if (first && *first != *side) return false;
    first = side;
  }
  const auto behind = o_.sign_at(v[0], v[1], v[2], ends, at);
  if (!behind) return std::nullopt;
  // [p, q, r, e] is minus [e, p, q, r].
  return *behind == face_side_[face];
}

LinePiece Contours::count(EdgeEnds ends, const PlaneBox& box, const std::vector<u32>& touching,
                          const Rational& from, const Rational& to) const {
  for (unsigned attempt = 0;; ++attempt) {
    const Rational t = between(from, to, attempt);
    if (t <= from || t >= to) continue;
    const EdgePoint at(t);
    LinePiece piece;
    bool good = true;
    faces_->query(box, [&](u32 f) {
      const auto has = [&](PointId x) {
        return id_of(c_.faces[f][0]) == x || id_of(c_.faces[f][1]) == x ||
               id_of(c_.faces[f][2]) == x;
      };
      if (!good || (has(ends.a) && has(ends.b))) return;
      const auto front = in_front(f, ends, at);
      good = front.has_value();
      if (!good || !*front) return;
      ++piece.front;
      piece.hiding += std::find(touching.begin(), touching.end(), f) == touching.end();
    });
    if (good) return piece;
  }
}

FoundEdge Contours::find(const SceneEdge& edge) const {
  FoundEdge found;
  found.edge = edge;
  const EdgeEnds ends = {id_of(edge.low), id_of(edge.high)};
  found.end_on = o_.end_on(ends);
  if (found.end_on) return found;
  PlaneBox box = vertex_box_[edge.low];
  box.add(vertex_box_[edge.high]);
  std::vector<Candidate> candidates;
  std::vector<u32> touching;
  add_crossings(ends, box, candidates);
  add_face_events(ends, box, candidates, touching);
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& s, const Candidate& t) {
    if (const int order = s.t.compare(t.t); order != 0) return order < 0;
    return s.event < t.event;
  });
  std::vector<LineBreak> breaks;
  for (const Candidate& candidate : candidates) {
    if (candidate.t == 0 || candidate.t == 1) {
      if (candidate.event) (candidate.t == 0 ? found.busy_low : found.busy_high) = true;
      continue;
    }
    if (breaks.empty() || breaks.back().t != candidate.t) breaks.push_back({candidate.t, {}});
    if (candidate.event) breaks.back().events.push_back(*candidate.event);
  }
  Rational from = 0;
  for (std::size_t i = 0; i <= breaks.size(); ++i) {
    const Rational to = i < breaks.size() ? breaks[i].t : Rational(1);
    const LinePiece piece = count(ends, box, touching, from, to);
    // A place where nothing happens is none.
    if (i > 0 && breaks[i - 1].events.empty() && piece == found.pieces.back())
      found.breaks.pop_back();
    else
      found.pieces.push_back(piece);
    if (i < breaks.size()) found.breaks.push_back(breaks[i]);
    from = to;
  }
  return found;
}

}  // namespace crest::certify
