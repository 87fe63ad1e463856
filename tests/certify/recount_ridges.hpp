// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The numbers of claim 1 that are functions of the data, counted from certify/ridges_mesh/SPEC.md
// by the shortest way there is: rationals, angles of 1000 bits, searches through all faces. For a
// few dozen faces. It shares no line with the checker, the producer or reference_ridges.hpp.
#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <map>
#include <stdexcept>

#include "certify/ridges_mesh/records.hpp"

namespace crest::tests {
namespace recount {

using Q = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                        boost::multiprecision::et_off>;
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<301>,
                                           boost::multiprecision::et_off>;
using V3 = std::array<Q, 3>;
inline V3 read(const double* p) {
  return {Q(p[0]), Q(p[1]), Q(p[2])};
}
inline Q dot(const V3& a, const V3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline V3 cross(const V3& a, const V3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline int sign(const Q& x) {
  return x.sign();
}
inline Real argument(const Q& y, const Q& x) {
  const Q size = std::max<Q>(abs(x), abs(y));
  return atan2(static_cast<Real>(Q(y / size)), static_cast<Real>(Q(x / size)));
}
inline Real pi() {
  return acos(Real(-1));
}

/// The mesh with angles in it.
class Surface {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  explicit Surface(const certify::MeshData& from) : data(from) {
    for (std::uint32_t f = 0; f < data.faces.size(); ++f)
      for (int i = 0; i < 3; ++i) sides[{corner(f, i), corner(f, i + 1)}] = {f, i};
  }

  std::uint32_t corner(std::uint32_t f, int i) const {
    return data.faces[f][static_cast<std::size_t>(i) % 3];
  }
  V3 d1(std::uint32_t v) const { return read(&data.monge[v][0]); }
  V3 n(std::uint32_t v) const { return read(&data.monge[v][3]); }
  V3 edge(std::uint32_t v, std::uint32_t w) const {
    const V3 a = read(data.positions[v].data()), b = read(data.positions[w].data());
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  }

  /// The angle of face f at v in space.
  Real angle(std::uint32_t v, std::uint32_t w, std::uint32_t u) const {
    const V3 e = edge(v, w), f = edge(v, u), normal = cross(e, f);
    const Q x = dot(e, f), size = dot(e, e) * dot(f, f);
    const Real c = static_cast<Real>(Q(x * x / size)),
               s = static_cast<Real>(Q(dot(normal, normal) / size));
    return atan2(sqrt(s), x < 0 ? Real(-sqrt(c)) : sqrt(c));
  }

  /// Around v: a(v, w) by w, the scaled angle by face, phi.
  struct Fan {
    std::map<std::uint32_t, Real> before, angle;
    Real phi = 0;
  };
  Fan fan(std::uint32_t v) const {
    std::uint32_t lowest = static_cast<std::uint32_t>(data.faces.size()), first = 0;
    bool closed = true;
    for (const auto& [pair, side] : sides) {
      if (pair.first != v) continue;
      if (!sides.count({pair.second, v})) {
        closed = false;
        first = pair.second;
      } else if (closed && side.first < lowest) {
        lowest = side.first;
        first = pair.second;
      }
    }
    Fan out;
    std::vector<std::uint32_t> ring;
    Real sum = 0;
    for (std::uint32_t w = first;;) {
      ring.push_back(w);
      out.before[w] = sum;
      const auto side = sides.find({v, w});
      if (side == sides.end()) break;
      const std::uint32_t u = corner(side->second.first, side->second.second + 2);
      out.angle[side->second.first] = angle(v, w, u);
      sum += out.angle[side->second.first];
      w = u;
      if (w == first) break;
    }
    if (closed)
      for (auto* angles : {&out.before, &out.angle})
        for (auto& [key, a] : *angles) a *= 2 * pi() / sum;
    const V3 d = d1(v), normal = n(v);
    for (std::size_t i = 3; i-- > 0;)
      if (d[i] != 0) out.phi = d[i] > 0 ? Real(0) : pi();
    for (const std::uint32_t w : ring) {
      const V3 e = edge(v, w);
      const Q x = dot(cross(normal, e), cross(normal, d)), y = dot(normal, cross(e, d));
      if (x == 0 && y == 0) continue;
      out.phi = out.before[w] + argument(y, x);
      break;
    }
    return out;
  }

  const certify::MeshData data;
  std::map<Pair, std::pair<std::uint32_t, int>> sides;  ///< directed: face, corner it leaves
};

class RidgesRecount : Surface {
 public:
  /// Requires: the faces are an oriented manifold of triangles with area, d1 and n are not zero.
  explicit RidgesRecount(const certify::MeshData& from) : Surface(from) {
    for (const auto& [pair, side] : sides) edges_.emplace(std::minmax(pair.first, pair.second), 0);
    for (auto& [pair, s] : edges_) s = acute(pair.first, pair.second);
    count_frames();
    count_faces();
  }

  /// As in the certificate.
  std::int32_t euler_characteristic = 0, twice_index_sum = 0;
  std::uint32_t boundary_loops = 0, conflict_triangles = 0, ambiguous_edges = 0;
  std::array<std::uint32_t, 2> zero_extremalities{};
  std::uint32_t against_faces = 0, equal_curvatures = 0, parallel_frames = 0;
  std::vector<int> twice_index;  ///< F

  /// Of a patch with these faces.
  std::uint32_t central_face(const std::vector<std::uint32_t>& faces) const {
    std::vector<std::pair<Q, std::uint32_t>> all;
    for (const std::uint32_t f : faces)
      for (int i = 0; i < 3 && twice_index[f] != 0; ++i) {
        const auto& m = data.monge[corner(f, i)];
        all.emplace_back(Q(m[6]) - Q(m[7]), f);
      }
    return std::min_element(all.begin(), all.end())->second;
  }

 private:
  int acute(std::uint32_t p, std::uint32_t q) {
    const V3 d = d1(p), e = d1(q);
    if (const int s = sign(dot(d, e)); s != 0) return s;
    ++ambiguous_edges;
    for (const auto& [i, j] : std::array<std::array<std::size_t, 2>, 6>{
             {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}})
      if (const int s = sign(d[i] * e[j] + d[j] * e[i]); s != 0) return s;
    throw std::logic_error("recount: a zero direction");
  }

  void count_frames() {
    for (std::uint32_t v = 0; v < data.monge.size(); ++v) {
      Q along = 0;
      for (const auto& [pair, side] : sides)
        if (pair.first == v)
          along +=
              dot(n(v), cross(edge(v, pair.second), edge(v, corner(side.first, side.second + 2))));
      const auto& m = data.monge[v];
      against_faces += along <= 0;
      equal_curvatures += m[6] == m[7];
      parallel_frames += cross(n(v), d1(v)) == V3{0, 0, 0};
      zero_extremalities[0] += m[8] == 0;
      zero_extremalities[1] += m[11] == 0;
    }
    euler_characteristic = static_cast<std::int32_t>(data.monge.size() + data.faces.size()) -
                           static_cast<std::int32_t>(edges_.size());
    // Along the boundary every vertex has one side that leaves it.
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [pair, side] : sides)
      if (!sides.count({pair.second, pair.first})) next[pair.first] = pair.second;
    while (!next.empty()) {
      ++boundary_loops;
      for (auto at = next.begin(); at != next.end();) {
        const std::uint32_t to = at->second;
        next.erase(at);
        at = next.find(to);
      }
    }
  }

  void count_faces() {
    std::vector<Fan> fans;
    for (std::uint32_t v = 0; v < data.monge.size(); ++v) fans.push_back(fan(v));
    const Real beyond = ldexp(Real(1), -200);
    std::map<Pair, Real> omega;
    for (const auto& [pair, s] : edges_) {
      const auto [v, w] = pair;
      Real x = fans[w].phi - fans[v].phi - (fans[w].before.at(v) + pi() - fans[v].before.at(w));
      if (s < 0) x += pi();
      while (x >= pi() + beyond) x -= 2 * pi();
      while (x < -pi() + beyond) x += 2 * pi();
      omega[{v, w}] = x;
      omega[{w, v}] = -x;
    }
    for (std::uint32_t f = 0; f < data.faces.size(); ++f) {
      Real turn = -pi();
      int product = 1;
      for (int i = 0; i < 3; ++i) {
        turn += omega.at({corner(f, i), corner(f, i + 1)}) + fans[corner(f, i)].angle.at(f);
        product *= edges_.at(std::minmax(corner(f, i), corner(f, i + 1)));
      }
      const Real twice = round(Real(turn / pi()));
      if (abs(Real(turn / pi() - twice)) > Real(1e-60))
        throw std::logic_error("recount: lemma 2 does not hold");
      twice_index.push_back(static_cast<int>(twice));
      twice_index_sum += twice_index.back();
      conflict_triangles += product < 0;
      if ((twice_index.back() % 2 != 0) != (product < 0))
        throw std::logic_error("recount: lemma 2 does not hold");
    }
  }

  std::map<Pair, int> edges_;  ///< lower, higher: s
};

}  // namespace recount

using recount::RidgesRecount;

}  // namespace crest::tests
