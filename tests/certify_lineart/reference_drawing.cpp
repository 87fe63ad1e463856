// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify_lineart/reference_drawing.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace crest::tests {
namespace {

using certify::LineArtCertificate;
using certify::LineEdge;
using certify::LineEvent;
using kernel::Rational;
using u32 = std::uint32_t;
using Vec = std::array<Rational, 3>;
using Pair = std::array<u32, 2>;

struct Tie : std::runtime_error {
  Tie() : std::runtime_error("a tie") {}
};

/// -1 or 1.
int sign(const Rational& x) {
  if (x == 0) throw Tie();
  return x > 0 ? 1 : -1;
}

Vec exact(const std::array<double, 3>& p) {
  return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
}
Rational dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A vertex as (page x, page y, nearness): straight lines and planes stay straight.
Vec seen(const LineArtCertificate& c, const std::array<double, 3>& point) {
  const Vec p = exact(point), e = exact(c.eye);
  const std::array<Rational, 2> origin = {Rational(c.view.origin[0]), Rational(c.view.origin[1])},
                                scale = {Rational(c.view.scale[0]), Rational(c.view.scale[1])};
  if (c.parallel) {
    const Vec x = cross(exact(c.view.axes[1]), e), y = cross(e, x);
    return {scale[0] * dot(x, p) - origin[0], origin[1] - scale[1] * dot(y, p), dot(e, p)};
  }
  const Vec q = {p[0] - e[0], p[1] - e[1], p[2] - e[2]};
  const Rational depth = dot(exact(c.view.axes[2]), q);
  if (depth <= 0) throw Tie();
  return {(dot(exact(c.view.axes[0]), q) / depth - origin[0]) * scale[0],
          (origin[1] - dot(exact(c.view.axes[1]), q) / depth) * scale[1], 1 / depth};
}

Rational turn(const Vec& p, const Vec& q, const Vec& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}
Vec mix(const Vec& a, const Vec& b, const Rational& t) {
  Vec x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = (1 - t) * a[k] + t * b[k];
  return x;
}

struct Scene {
  explicit Scene(const LineArtCertificate& c) : data(c) {
    for (const auto& p : c.points) v.push_back(seen(c, p));
    for (u32 f = 0; f < c.faces.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const u32 a = c.faces[f][k], b = c.faces[f][(k + 1) % 3], third = c.faces[f][(k + 2) % 3];
        const Pair edge = {std::min(a, b), std::max(a, b)};
        balance[edge] += sign(turn(v[edge[0]], v[edge[1]], v[third]));
      }
  }

  /// The face's nearness above a point of the page; nothing beside it.
  std::optional<Rational> nearness(u32 f, const Vec& x) const {
    const auto& [p, q, r] = data.faces[f];
    const Rational area = turn(v[p], v[q], v[r]), i = turn(x, v[q], v[r]) / area,
                   j = turn(v[p], x, v[r]) / area, k = turn(v[p], v[q], x) / area;
    if (sign(i) < 0 || sign(j) < 0 || sign(k) < 0) return std::nullopt;
    return i * v[p][2] + j * v[q][2] + k * v[r][2];
  }
  bool holds(u32 f, u32 vertex) const {
    const auto& face = data.faces[f];
    return std::find(face.begin(), face.end(), vertex) != face.end();
  }
  /// Nearness of the face's plane less that of a vertex.
  Rational above(u32 f, u32 vertex) const {
    const auto& [p, q, r] = data.faces[f];
    const Rational area = turn(v[p], v[q], v[r]);
    return (turn(v[vertex], v[q], v[r]) * v[p][2] + turn(v[p], v[vertex], v[r]) * v[q][2] +
            turn(v[p], v[q], v[vertex]) * v[r][2]) /
               area -
           v[vertex][2];
  }

  const LineArtCertificate& data;
  std::vector<Vec> v;
  std::map<Pair, int> balance;
};

using Happening = std::pair<Rational, LineEvent>;

void crossings(const Scene& s, Pair edge, std::vector<Happening>& found) {
  const auto [a, b] = edge;
  for (const auto& [other, balance] : s.balance) {
    const auto [c, d] = other;
    if (balance == 0 || c == a || c == b || d == a || d == b) continue;
    const Rational at_a = turn(s.v[c], s.v[d], s.v[a]), at_b = turn(s.v[c], s.v[d], s.v[b]),
                   at_c = turn(s.v[a], s.v[b], s.v[c]), at_d = turn(s.v[a], s.v[b], s.v[d]);
    if (sign(at_a) == sign(at_b) || sign(at_c) == sign(at_d)) continue;
    const Rational t = at_a / (at_a - at_b);
    if (sign(mix(s.v[c], s.v[d], at_c / (at_c - at_d))[2] - mix(s.v[a], s.v[b], t)[2]) > 0)
      found.push_back({t, {LineEvent::kCrossing, c, d}});
  }
}

void piercings(const Scene& s, Pair edge, std::vector<Happening>& found) {
  for (u32 f = 0; f < s.data.faces.size(); ++f) {
    if (s.holds(f, edge[0]) || s.holds(f, edge[1])) continue;
    const Rational low = s.above(f, edge[0]), high = s.above(f, edge[1]);
    if (sign(low) == sign(high)) continue;
    const Rational t = low / (low - high);
    if (s.nearness(f, mix(s.v[edge[0]], s.v[edge[1]], t)))
      found.push_back({t, {LineEvent::kPiercing, f, 0}});
  }
}

u32 faces_in_front(const Scene& s, Pair edge, const Rational& t) {
  const Vec x = mix(s.v[edge[0]], s.v[edge[1]], t);
  u32 count = 0;
  for (u32 f = 0; f < s.data.faces.size(); ++f) {
    if (s.holds(f, edge[0]) && s.holds(f, edge[1])) continue;
    if (const auto h = s.nearness(f, x)) count += sign(*h - x[2]) > 0;
  }
  return count;
}

LineEdge describe(const Scene& s, Pair edge) {
  std::vector<Happening> found;
  crossings(s, edge, found);
  piercings(s, edge, found);
  std::sort(found.begin(), found.end(),
            [](const Happening& x, const Happening& y) { return x.first < y.first; });
  LineEdge line;
  line.low = edge[0];
  line.high = edge[1];
  Rational from = 0;
  for (std::size_t i = 0; i <= found.size(); ++i) {
    const Rational to = i < found.size() ? found[i].first : Rational(1);
    if (from == to) throw Tie();
    const u32 front = faces_in_front(s, edge, (2 * from + 3 * to) / 5);
    line.pieces.push_back({front, front});
    if (i < found.size()) line.breaks.push_back({found[i].second});
    from = to;
  }
  return line;
}

}  // namespace

std::optional<LineArtCertificate> reference_drawing(LineArtCertificate data) {
  try {
    const Scene scene(data);
    data.edges.clear();
    for (const auto& [edge, balance] : scene.balance) {
      const bool crease =
          std::find(data.creases.begin(), data.creases.end(), edge) != data.creases.end();
      if (balance != 0 || crease) data.edges.push_back(describe(scene, edge));
    }
    return data;
  } catch (const Tie&) {
    return std::nullopt;
  }
}

namespace {

bool crosses(const Scene& s, const LineEdge& line, const std::vector<Vec>& hatch) {
  // The places again, from the page.
  std::vector<Happening> found;
  crossings(s, {line.low, line.high}, found);
  piercings(s, {line.low, line.high}, found);
  std::vector<Rational> t = {0, 1};
  for (const auto& [at, event] : found) t.push_back(at);
  std::sort(t.begin(), t.end());
  for (std::size_t k = 0; k < line.pieces.size(); ++k) {
    if (line.pieces[k].hiding > 0) continue;
    const Vec u = mix(s.v[line.low], s.v[line.high], t[k]),
              w = mix(s.v[line.low], s.v[line.high], t[k + 1]);
    for (std::size_t i = 0; i + 1 < hatch.size(); ++i) {
      const Vec &p = hatch[i], &q = hatch[i + 1];
      if (sign(turn(p, q, u)) != sign(turn(p, q, w)) && sign(turn(u, w, p)) != sign(turn(u, w, q)))
        return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::array<double, 2>> hatch_on(const LineArtCertificate& drawing, u32 face,
                                            std::size_t corner, double reach) {
  std::array<double, 2> middle{}, towards{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec p = seen(drawing, drawing.points[drawing.faces[face][k]]);
    for (std::size_t n = 0; n < 2; ++n) {
      middle[n] += p[n].convert_to<double>() / 3;
      if (k == corner) towards[n] = p[n].convert_to<double>();
    }
  }
  return {
      middle,
      {middle[0] + reach * (towards[0] - middle[0]), middle[1] + reach * (towards[1] - middle[1])}};
}

std::optional<HatchTruth> reference_hatch(const LineArtCertificate& drawing,
                                          const std::vector<std::array<double, 2>>& hatch) {
  try {
    const Scene s(drawing);
    std::vector<Vec> points;
    for (const auto& p : hatch) points.push_back({Rational(p[0]), Rational(p[1]), 0});
    HatchTruth truth;
    Rational nearest;
    for (u32 f = 0; f < drawing.faces.size(); ++f) {
      const auto at = s.nearness(f, points[0]);
      if (!at || (!truth.faces.empty() && sign(*at - nearest) < 0)) continue;
      truth.faces = {f};
      nearest = *at;
    }
    for (const LineEdge& line : drawing.edges)
      if (s.balance.at({line.low, line.high}) != 0 && crosses(s, line, points))
        truth.crosses = true;
    return truth;
  } catch (const Tie&) {
    return std::nullopt;
  }
}

}  // namespace crest::tests
