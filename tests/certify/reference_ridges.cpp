// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify/reference_ridges.hpp"

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <set>
#include <stdexcept>

namespace crest::tests {
namespace {

using Q = boost::multiprecision::mpq_rational;
using Real100 = boost::multiprecision::mpfr_float_100;
using u32 = std::uint32_t;
using V3 = std::array<Q, 3>;

int sgn(const Q& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}
V3 vec(const double* p) {
  return {Q(p[0]), Q(p[1]), Q(p[2])};
}
V3 sub(const V3& a, const V3& b) {
  return {Q(a[0] - b[0]), Q(a[1] - b[1]), Q(a[2] - b[2])};
}
Q dot(const V3& a, const V3& b) {
  return Q(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}
V3 cross(const V3& a, const V3& b) {
  return {Q(a[1] * b[2] - a[2] * b[1]), Q(a[2] * b[0] - a[0] * b[2]), Q(a[0] * b[1] - a[1] * b[0])};
}
Q det(const V3& a, const V3& b, const V3& c) {
  return dot(a, cross(b, c));
}
bool is_zero(const V3& a) {
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

}  // namespace

ReferenceRidges::ReferenceRidges(const certify::MeshData& data) : data_(data) {
  valid_ = build_edges() && build_rings() && check_numbers();
  if (!valid_) return;
  decide_signs();
  if (!find_indices<long double>(1e-9L) && !find_indices<Real100>(pow(Real100(2), -200)))
    throw std::logic_error("reference: an index is not clear");
}

bool ReferenceRidges::build_edges() {
  std::set<std::set<u32>> corner_sets;
  std::set<Pair> directed;
  for (const auto& f : data_.faces) {
    for (const u32 v : f)
      if (v >= data_.positions.size()) return false;
    if (!corner_sets.insert({f[0], f[1], f[2]}).second) return false;
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) return false;
    for (std::size_t i = 0; i < 3; ++i)
      if (!directed.insert({f[i], f[(i + 1) % 3]}).second) return false;
  }
  for (const auto& [a, b] : directed) edge_number_[{std::min(a, b), std::max(a, b)}] = 0;
  for (auto& [pair, number] : edge_number_) {
    number = edges_.size();
    edges_.push_back(pair);
  }
  edge_faces_.resize(edges_.size());
  for (u32 f = 0; f < data_.faces.size(); ++f)
    for (const Side& side : sides(f)) edge_faces_[side.edge].push_back(f);
  return true;
}

std::array<ReferenceRidges::Side, 3> ReferenceRidges::sides(u32 face) const {
  std::array<Side, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const u32 a = data_.faces[face][i], b = data_.faces[face][(i + 1) % 3];
    out[i] = {edge_number_.at({std::min(a, b), std::max(a, b)}), a, b};
  }
  return out;
}

bool ReferenceRidges::build_rings() {
  rings_.resize(data_.positions.size());
  std::vector<std::map<u32, std::pair<u32, u32>>> after(rings_.size());  // w_k -> (w_k+1, face)
  std::vector<u32> start(rings_.size());
  for (u32 f = 0; f < data_.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& face = data_.faces[f];
      auto& steps = after[face[i]];
      if (steps.empty()) start[face[i]] = face[(i + 1) % 3];
      steps[face[(i + 1) % 3]] = {face[(i + 2) % 3], f};
    }
  for (std::size_t v = 0; v < rings_.size(); ++v) {
    const auto& steps = after[v];
    if (steps.empty()) return false;
    std::set<u32> ends;
    for (const auto& [from, to] : steps) ends.insert(to.first);
    Ring& ring = rings_[v];
    ring.closed = true;
    for (const auto& [from, to] : steps)
      if (!ends.count(from)) {
        ring.closed = false;
        start[v] = from;
      }
    u32 w = start[v];
    do {
      ring.neighbours.push_back(w);
      const auto step = steps.find(w);
      if (step == steps.end()) break;
      ring.faces.push_back(step->second.second);
      w = step->second.first;
    } while (w != start[v]);
    if (ring.faces.size() != steps.size()) return false;
  }
  return true;
}

bool ReferenceRidges::check_numbers() const {
  for (const auto& f : data_.faces) {
    const V3 a = vec(data_.positions[f[0]].data());
    const V3 b = vec(data_.positions[f[1]].data());
    const V3 c = vec(data_.positions[f[2]].data());
    if (is_zero(cross(sub(b, a), sub(c, a)))) return false;
  }
  for (const auto& m : data_.monge)
    if (is_zero(vec(&m[0])) || is_zero(vec(&m[3])) || m[6] < m[7]) return false;
  return true;
}

void ReferenceRidges::decide_signs() {
  for (const auto& [p, q] : edges_) {
    const V3 d = vec(&data_.monge[p][0]), e = vec(&data_.monge[q][0]);
    int s = sgn(dot(d, e));
    if (s == 0) {
      ++ambiguous_;
      const Q terms[] = {d[0] * e[0],
                         d[1] * e[1],
                         d[2] * e[2],
                         d[0] * e[1] + d[1] * e[0],
                         d[0] * e[2] + d[2] * e[0],
                         d[1] * e[2] + d[2] * e[1]};
      for (const Q& term : terms)
        if (s == 0) s = sgn(term);
    }
    acute_.push_back(s);
  }
}

/// False if some rotation or index is not `clear` of the next decision. Real's own tie (omega =
/// pi) is taken only by the type whose precision is behind `clear`.
template <class Real>
bool ReferenceRidges::find_indices(Real clear) {
  using std::abs, std::atan2, std::sqrt, std::round;
  const bool last = std::is_same_v<Real, Real100>;
  const Real pi = atan2(Real(0), Real(-1));
  const auto real = [](const Q& x) { return static_cast<Real>(x); };
  std::vector<std::map<u32, Real>> before(rings_.size()), angle(rings_.size());
  std::vector<Real> phi(rings_.size(), Real(0));
  for (u32 v = 0; v < rings_.size(); ++v) {
    const Ring& ring = rings_[v];
    const V3 at = vec(data_.positions[v].data());
    const auto edge = [&](u32 w) { return sub(vec(data_.positions[w].data()), at); };
    Real sum = 0;
    for (std::size_t k = 0; k < ring.faces.size(); ++k) {
      const V3 e = edge(ring.neighbours[k]);
      const V3 f = edge(ring.neighbours[(k + 1) % ring.neighbours.size()]);
      const V3 normal = cross(e, f);
      // Scaled by the larger one: the quotient of rationals has no exponent range.
      const Q x = dot(e, f), y2 = dot(normal, normal);
      Real a;
      if (x == 0)
        a = pi / 2;
      else
        a = atan2(Real(sqrt(real(Q(y2 / (x * x))))), Real(x > 0 ? 1 : -1));
      angle[v][ring.faces[k]] = a;
      before[v][ring.neighbours[k]] = sum;
      sum += a;
    }
    if (ring.closed) {
      for (auto& entry : angle[v]) entry.second *= 2 * pi / sum;
      for (auto& entry : before[v]) entry.second *= 2 * pi / sum;
    } else {
      before[v][ring.neighbours.back()] = sum;
    }
    const V3 n = vec(&data_.monge[v][3]), d = vec(&data_.monge[v][0]);
    // Kept if d is parallel to n: 0 or pi by the sign of d's first coordinate that is not zero.
    if (d[0] < 0 || (d[0] == 0 && (d[1] < 0 || (d[1] == 0 && d[2] < 0)))) phi[v] = pi;
    for (const u32 w : ring.neighbours) {
      const Q x = dot(cross(n, edge(w)), cross(n, d)), y = det(n, edge(w), d);
      if (x == 0 && y == 0) continue;
      const Q size = std::max(Q(abs(x)), Q(abs(y)));
      phi[v] = before[v][w] + atan2(real(Q(y / size)), real(Q(x / size)));
      break;
    }
  }
  std::vector<Real> omega;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto& [v, w] = edges_[e];
    Real x = phi[w] - phi[v] - (before[w].at(v) + pi - before[v].at(w));
    if (acute_[e] < 0) x += pi;
    x -= 2 * pi * round(Real(x / (2 * pi)));
    if (abs(abs(x) - pi) < clear) {
      if (!last) return false;
      x = pi;
    }
    omega.push_back(x);
  }
  twice_index_.clear();
  for (u32 f = 0; f < data_.faces.size(); ++f) {
    Real turn = -pi;
    for (const Side& side : sides(f)) {
      turn += side.from < side.to ? omega[side.edge] : Real(-omega[side.edge]);
      turn += angle[side.from].at(f);
    }
    const Real twice = round(Real(turn / pi));
    if (!(abs(turn / pi - twice) < Real(1e-9))) return false;
    twice_index_.push_back(static_cast<int>(twice));
  }
  return true;
}

int ReferenceRidges::beta(std::size_t colour, u32 v) const {
  const auto& m = data_.monge[v];
  for (const double x : {m[colour == 0 ? 8 : 11], m[0], m[1], m[2]})
    if (x != 0) return x > 0 ? 1 : -1;
  return 0;
}

bool ReferenceRidges::crossed(std::size_t colour, std::size_t edge) const {
  const auto& [p, q] = edges_[edge];
  return acute_[edge] * beta(colour, p) * beta(colour, q) < 0;
}

unsigned ReferenceRidges::crossing_type(std::size_t colour, std::size_t edge) const {
  const auto second = [&](u32 v) {
    const auto& m = data_.monge[v];
    const Q k1 = m[6], k2 = m[7], b1 = m[9], b2 = m[10], c0 = m[12], c4 = m[13];
    return colour == 0 ? Q(3 * b1 * b1 + (k1 - k2) * (c0 - 3 * k1 * k1 * k1))
                       : Q(3 * b2 * b2 + (k2 - k1) * (c4 - 3 * k2 * k2 * k2));
  };
  const auto& [p, q] = edges_[edge];
  Q bp = abs(Q(data_.monge[p][colour == 0 ? 8 : 11]));
  Q bq = abs(Q(data_.monge[q][colour == 0 ? 8 : 11]));
  if (bp == 0 && bq == 0) bp = bq = 1;
  const int s = sgn(Q(bq * second(p) + bp * second(q)));
  return s < 0 ? 1 : s > 0 ? 2 : 0;
}

unsigned ReferenceRidges::segment_type(std::size_t colour, u32 face) const {
  const auto all = sides(face);
  std::size_t i = 0;
  while (crossed(colour, all[(i + 1) % 3].edge)) ++i;  // side i + 1 is across from corner i
  const std::array<u32, 3> v = {all[i].from, all[i].to, all[(i + 2) % 3].from};
  const auto position = [&](u32 w) { return vec(data_.positions[w].data()); };
  const auto point = [&](u32 p, u32 q) {
    const Q bp = abs(Q(data_.monge[p][colour == 0 ? 8 : 11]));
    const Q bq = abs(Q(data_.monge[q][colour == 0 ? 8 : 11]));
    const Q t = bp + bq == 0 ? Q(1) / 2 : Q(bp / (bp + bq));
    V3 r;
    for (std::size_t c = 0; c < 3; ++c)
      r[c] = position(p)[c] + t * (position(q)[c] - position(p)[c]);
    return r;
  };
  const V3 step = sub(point(v[0], v[2]), point(v[0], v[1]));
  const V3 normal = cross(sub(position(v[1]), position(v[0])), sub(position(v[2]), position(v[0])));
  int sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& m = data_.monge[v[c]];
    const V3 d = vec(&m[0]), u = colour == 0 ? d : cross(vec(&m[3]), d);
    sum += (c == 0 ? 1 : -1) * beta(colour, v[c]) * sgn(det(u, step, normal));
  }
  if (sum == 0) return 0;
  if (colour == 0) return sum > 0 ? 1 : 2;
  return sum < 0 ? 1 : 2;
}

u32 ReferenceRidges::least_gap_corner(u32 face) const {
  const auto gap = [&](u32 v) { return Q(Q(data_.monge[v][6]) - Q(data_.monge[v][7])); };
  u32 best = data_.faces[face][0];
  for (const u32 v : data_.faces[face])
    if (gap(v) < gap(best)) best = v;
  return best;
}

u32 ReferenceRidges::central_face(const std::vector<u32>& faces) const {
  std::set<std::pair<Q, u32>> order;
  for (const u32 f : faces) {
    const auto& m = data_.monge[least_gap_corner(f)];
    if (twice_index_[f] != 0) order.emplace(Q(Q(m[6]) - Q(m[7])), f);
  }
  return order.empty() ? static_cast<u32>(data_.faces.size()) : order.begin()->second;
}

void ReferenceRidges::count_frames(certify::RidgesMeshCertificate& out) const {
  std::vector<V3> sum(data_.positions.size(), V3{0, 0, 0});
  for (const auto& f : data_.faces) {
    const auto at = [&](std::size_t i) { return vec(data_.positions[f[i]].data()); };
    const V3 normal = cross(sub(at(1), at(0)), sub(at(2), at(0)));
    for (const u32 v : f)
      for (std::size_t i = 0; i < 3; ++i) sum[v][i] += normal[i];
  }
  for (std::size_t v = 0; v < sum.size(); ++v) {
    const V3 d = vec(&data_.monge[v][0]), n = vec(&data_.monge[v][3]);
    out.against_faces += dot(n, sum[v]) <= 0;
    out.equal_curvatures += Q(data_.monge[v][6]) == Q(data_.monge[v][7]);
    out.parallel_frames += is_zero(cross(n, d));
  }
}

unsigned ReferenceRidges::kind(u32 face) const {
  const auto& m = data_.monge[least_gap_corner(face)];
  const Q b0 = m[8], b1 = m[9], b2 = m[10], b3 = m[11], a = b0 * b3 - b1 * b2;
  const int s = sgn(Q(a * a - 4 * (b0 * b2 - b1 * b1) * (b1 * b3 - b2 * b2)));
  return s > 0 ? 1 : s < 0 ? 3 : 0;
}

}  // namespace crest::tests
