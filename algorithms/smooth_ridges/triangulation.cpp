// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace crest::smooth_ridges {
namespace {

constexpr std::size_t next(std::size_t k) {
  return (k + 1) % 3;
}

/// Modulo 1, to a multiple of 2^-52.
double unit_coordinate(double x) {
  x -= std::floor(x);
  const double rounded = (x + 1) - 1;
  return rounded < 1 ? rounded : 0;
}

}  // namespace

std::vector<std::array<Index, 3>> pair_edges(const std::vector<Triangle>& faces) {
  struct Half {
    Index low, high;
    Index face;
    std::uint8_t edge;
    bool ascending;
  };
  std::vector<Half> halves;
  halves.reserve(3 * faces.size());
  for (Index f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = faces[f][k], b = faces[f][next(k)];
      halves.push_back({std::min(a, b), std::max(a, b), f, static_cast<std::uint8_t>(k), a < b});
    }
  std::sort(halves.begin(), halves.end(), [](const Half& x, const Half& y) {
    return std::tie(x.low, x.high, x.face) < std::tie(y.low, y.high, y.face);
  });
  std::vector<std::array<Index, 3>> neighbours(faces.size(), {kNone, kNone, kNone});
  const auto same = [&](std::size_t i, std::size_t j) {
    return j < halves.size() && halves[i].low == halves[j].low && halves[i].high == halves[j].high;
  };
  for (std::size_t i = 0; i < halves.size(); ++i) {
    if (!same(i, i + 1)) continue;
    const Half &x = halves[i], &y = halves[i + 1];
    if (same(i, i + 2) || x.ascending == y.ascending)
      throw std::invalid_argument(
          "an edge of the triangulation is in more than two faces, or in "
          "two that are oriented differently");
    neighbours[x.face][x.edge] = y.face;
    neighbours[y.face][y.edge] = x.face;
    ++i;
  }
  return neighbours;
}

Triangulation::Triangulation(std::vector<Vertex> vertices, std::vector<Triangle> faces,
                             std::vector<std::uint8_t> lifts, EdgeRules rules)
    : vertices_(std::move(vertices)),
      faces_(std::move(faces)),
      lifts_(std::move(lifts)),
      rules_(std::move(rules)) {
  neighbours_ = pair_edges(faces_);
  longest_.resize(faces_.size());
  ids_.resize(faces_.size());
  for (Index f = 0; f < faces_.size(); ++f) {
    choose_longest(f);
    ids_[f] = next_id_++;
  }
}

/// Bit 0: U, bit 1: V.
std::uint8_t Triangulation::lift_bits(Index face, std::size_t corner) const {
  const unsigned bits = lifts_[face] >> corner;
  return static_cast<std::uint8_t>((bits & 1) | ((bits >> 2) & 2));
}

Vertex Triangulation::corner(Index face, std::size_t k) const {
  Vertex v = vertices_[faces_[face][k]];
  if (is_implicit()) return v;
  const unsigned bits = lift_bits(face, k);
  v[0] += bits & 1;
  v[1] += bits >> 1;
  return v;
}

/// Corner `to` as seen from corner `from`, which is not lifted.
Vertex Triangulation::lifted(Index face, std::size_t from, std::size_t to) const {
  Vertex v = vertices_[faces_[face][to]];
  if (is_implicit()) return v;
  const int a = lift_bits(face, from), b = lift_bits(face, to);
  v[0] += (b & 1) - (a & 1);
  v[1] += (b >> 1) - (a >> 1);
  return v;
}

void Triangulation::choose_longest(Index face) {
  std::tuple<double, Index, Index> best{-1, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t a = k, b = next(k);
    if (faces_[face][a] > faces_[face][b]) std::swap(a, b);
    const Index low = faces_[face][a], high = faces_[face][b];
    const double length = rules_.length(vertices_[low], lifted(face, a, b));
    const std::tuple<double, Index, Index> key{std::isfinite(length) ? length : 0, high, low};
    if (key <= best) continue;
    best = key;
    longest_[face] = static_cast<std::uint8_t>(k);
  }
}

std::size_t Triangulation::edge_towards(Index neighbour, Index face) const {
  const auto& around = neighbours_[neighbour];
  return around[0] == face ? 0 : around[1] == face ? 1 : 2;
}

Index Triangulation::add_midpoint(Index face, std::size_t edge) {
  std::size_t a = edge, b = next(edge);
  if (faces_[face][a] > faces_[face][b]) std::swap(a, b);
  const Vertex from = vertices_[faces_[face][a]], to = lifted(face, a, b);
  Vertex middle{};
  if (is_implicit()) {
    middle = rules_.place(from, to);
  } else {
    for (std::size_t i = 0; i < 2; ++i) {
      middle[i] = (from[i] + to[i]) / 2;
      if (rules_.periodic[i]) middle[i] = unit_coordinate(middle[i]);
    }
  }
  vertices_.push_back(middle);
  return static_cast<Index>(vertices_.size() - 1);
}

/// The lift that puts the middle between the face's lifted ends.
std::uint8_t Triangulation::middle_lift(Index face, std::size_t edge, Index middle) const {
  if (is_implicit()) return 0;
  const Vertex a = corner(face, edge), b = corner(face, next(edge));
  unsigned bits = 0;
  for (std::size_t i = 0; i < 2; ++i)
    if ((a[i] + b[i]) / 2 - vertices_[middle][i] > 0.5) bits |= 1u << i;
  return static_cast<std::uint8_t>(bits);
}

void Triangulation::relink(Index face, Index old_neighbour, Index new_neighbour) {
  if (face == kNone) return;
  neighbours_[face][edge_towards(face, old_neighbour)] = new_neighbour;
}

/// (a, b, c), cut at the edge from a to b: (a, middle, c) stays, (middle, b, c) is new. The links
/// across the cut edge are left to the caller.
Index Triangulation::split(Index face, std::size_t edge, Index middle, std::uint8_t lift) {
  const std::size_t ka = edge, kb = next(edge), kc = next(kb);
  const Index a = faces_[face][ka], b = faces_[face][kb], c = faces_[face][kc];
  const Index across_bc = neighbours_[face][kb], across_ca = neighbours_[face][kc];
  const Index fresh = static_cast<Index>(faces_.size());
  faces_.push_back({middle, b, c});
  faces_[face] = {a, middle, c};
  neighbours_.push_back({kNone, across_bc, face});
  neighbours_[face] = {kNone, fresh, across_ca};
  relink(across_bc, face, fresh);
  if (!is_implicit()) {
    const auto pack = [](unsigned x, unsigned y, unsigned z) {
      return static_cast<std::uint8_t>((x & 1) | (y & 1) << 1 | (z & 1) << 2 | (x >> 1) << 3 |
                                       (y >> 1) << 4 | (z >> 1) << 5);
    };
    const unsigned la = lift_bits(face, ka), lb = lift_bits(face, kb), lc = lift_bits(face, kc);
    lifts_[face] = pack(la, lift, lc);
    lifts_.push_back(pack(lift, lb, lc));
  }
  longest_.push_back(0);
  ids_.push_back(0);
  for (const Index f : {face, fresh}) {
    choose_longest(f);
    ids_[f] = next_id_++;
  }
  return fresh;
}

/// At the longest edge, with the neighbour there if there is one.
void Triangulation::bisect(Index face) {
  const std::size_t edge = longest_[face];
  const Index other = neighbours_[face][edge];
  const Index middle = add_midpoint(face, edge);
  const std::uint8_t lift = middle_lift(face, edge, middle);
  if (other == kNone) {
    split(face, edge, middle, lift);
    return;
  }
  const std::size_t other_edge = edge_towards(other, face);
  const std::uint8_t other_lift = middle_lift(other, other_edge, middle);
  // face = (a, b, c), other = (b, a, d).
  const Index with_b = split(face, edge, middle, lift);
  const Index with_a = split(other, other_edge, middle, other_lift);
  neighbours_[face][0] = with_a;
  neighbours_[with_a][0] = face;
  neighbours_[with_b][0] = other;
  neighbours_[other][0] = with_b;
}

void Triangulation::refine(const std::vector<Index>& marked) {
  std::vector<std::uint64_t> before;
  for (const Index f : marked) before.push_back(ids_[f]);
  for (std::size_t i = 0; i < marked.size(); ++i)
    while (ids_[marked[i]] == before[i]) {
      Index f = marked[i];
      for (;;) {
        const Index other = neighbours_[f][longest_[f]];
        if (other == kNone || neighbours_[other][longest_[other]] == f) break;
        f = other;
      }
      bisect(f);
    }
}

std::vector<Index> Triangulation::face_components() const {
  std::vector<Index> component(faces_.size(), kNone), stack;
  Index count = 0;
  for (Index f = 0; f < faces_.size(); ++f) {
    if (component[f] != kNone) continue;
    stack.push_back(f);
    component[f] = count;
    while (!stack.empty()) {
      const Index g = stack.back();
      stack.pop_back();
      for (const Index n : neighbours_[g])
        if (n != kNone && component[n] == kNone) {
          component[n] = count;
          stack.push_back(n);
        }
    }
    ++count;
  }
  return component;
}

int Triangulation::euler_characteristic() const {
  std::size_t twice_edges = 0;
  for (const auto& around : neighbours_)
    for (const Index n : around) twice_edges += n == kNone ? 2 : 1;
  return static_cast<int>(vertices_.size()) - static_cast<int>(twice_edges / 2) +
         static_cast<int>(faces_.size());
}

}  // namespace crest::smooth_ridges
