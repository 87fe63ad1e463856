// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/positions.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <atomic>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

#include "algorithms/modes/mode_function.hpp"
#include "kernel/geometry/disjoint_sets.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {
namespace {

using CornerWeights = std::array<double, 4>;
using Planar = std::array<double, 2>;
using Link = std::array<std::size_t, 2>;

/// More are not looked at (certify/modes/SPEC.md).
constexpr std::size_t kMostVertices = 1024;

/// Points of a plane, each wrong by at most `error`: what these decide is decided.
class Plane {
 public:
  std::vector<Planar> points;
  double error = 0;

  int turn(std::size_t a, std::size_t b, std::size_t c) const {
    const auto [u, v] = arms(a, b, c);
    const double cross = u[0] * v[1] - u[1] * v[0], room = this->room(u, v);
    return cross > room ? 1 : cross < -room ? -1 : 0;
  }
  /// Segments that meet in common ends only, and there not along a line.
  bool is_simple(const std::vector<Link>& segments) const {
    for (std::size_t i = 0; i < segments.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (!are_clear(segments[i], segments[k])) return false;
    return true;
  }
  /// Whether a point is inside a polygon; nothing where that is not clear.
  std::optional<bool> holds(const std::vector<std::size_t>& polygon, std::size_t point) const {
    bool inside = false;
    // Aslant: points of one facet have often one coordinate.
    const auto rises = [&](std::size_t i) -> std::optional<bool> {
      const double gap =
          points[i][1] - points[point][1] + 0.618 * (points[i][0] - points[point][0]);
      if (std::fabs(gap) <= 8 * error) return {};
      return gap > 0;
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      const auto from = rises(a), to = rises(b);
      if (!from || !to) return {};
      if (*from == *to) continue;
      const int side = turn(a, b, point);
      if (side == 0) return {};
      inside ^= (side > 0) == *to;
    }
    return inside;
  }

 private:
  std::pair<Planar, Planar> arms(std::size_t a, std::size_t b, std::size_t c) const {
    const auto &p = points[a], &q = points[b], &r = points[c];
    return {{q[0] - p[0], q[1] - p[1]}, {r[0] - p[0], r[1] - p[1]}};
  }
  double room(const Planar& u, const Planar& v) const {
    const double sum = std::fabs(u[0]) + std::fabs(u[1]) + std::fabs(v[0]) + std::fabs(v[1]);
    return 4 * error * sum + 16 * error * error;
  }
  bool fork(std::size_t a, std::size_t b, std::size_t c) const {
    if (b == c) return false;
    if (turn(a, b, c) != 0) return true;
    const auto [u, v] = arms(a, b, c);
    return u[0] * v[0] + u[1] * v[1] < -room(u, v);
  }
  bool are_apart(const Link& s, const Link& t) const {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [a, b] = std::minmax(points[s[0]][k], points[s[1]][k]);
      const auto [c, d] = std::minmax(points[t[0]][k], points[t[1]][k]);
      if (b + 4 * error < c || d + 4 * error < a) return true;
    }
    return false;
  }
  bool are_clear(const Link& s, const Link& t) const {
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k)
        if (s[i] == t[k]) return fork(s[i], s[1 - i], t[1 - k]);
    return are_apart(s, t) || turn(s[0], s[1], t[0]) * turn(s[0], s[1], t[1]) > 0 ||
           turn(t[0], t[1], s[0]) * turn(t[0], t[1], s[1]) > 0;
  }
};

/// The projection along w of barycentrics.
class Projection {
 public:
  explicit Projection(const std::array<std::int16_t, 4>& w) {
    std::size_t drop = 0, n = 0;
    for (std::size_t i = 1; i < 4; ++i)
      if (std::abs(w[i]) > std::abs(w[drop])) drop = i;
    for (std::size_t i = 0; i < 4 && n < 2; ++i)
      if (i != drop) kept_[n++] = {i, static_cast<double>(w[i]) / w[drop]};
    drop_ = drop;
  }
  Planar operator()(const CornerWeights& b) const {
    return {b[kept_[0].first] - b[drop_] * kept_[0].second,
            b[kept_[1].first] - b[drop_] * kept_[1].second};
  }

 private:
  std::array<std::pair<std::size_t, double>, 2> kept_;
  std::size_t drop_;
};

/// The polylines of one side on faces, projected: of the cell or face at hand.
class Paths {
 public:
  /// An arc's ends, as numbers of points, and what lies between.
  struct Path {
    Index arc;
    std::vector<std::size_t> points;
  };

  Paths(Faces& faces, const RecordedPositions& positions, const certify::ModeLevel& record)
      : faces_(faces), positions_(positions), record_(record) {}

  const Plane& plane() const { return plane_; }
  const std::vector<Path>& list() const { return paths_; }
  void clear() {
    plane_.points.clear();
    plane_.error = 1e-13;
    point_of_.clear();
    known_.clear();
    paths_.clear();
  }
  /// Adds the paths of a side on a face. False if one along a side of its leaf has no inner point.
  template <class Project>
  bool add(const std::array<Index, 4>& corners, Index f, Side side, const Project& project) {
    bool good = true;
    faces_.for_each_leaf(f, [&](Index leaf) {
      const Face& face = faces_.face(leaf);
      if (face.arc_count == 0) return;
      const auto roots = roots_around(face);
      std::array<CornerWeights, 3> w;
      for (std::size_t k = 0; k < 3; ++k) w[k] = weights(corners, face.corners[k]);
      for (Index a = face.first_arc; a < face.first_arc + face.arc_count; ++a) {
        const Arc& arc = faces_.arcs()[a];
        if (arc.side != side) continue;
        Path path{a, {}};
        const auto end = [&](std::size_t i) {
          const Start& s = roots[arc.numbers[i]];
          const auto [at, fresh] = point_of_.try_emplace(arc.roots[i], plane_.points.size());
          if (fresh)
            plane_.points.push_back(project(between(w[s.edge], w[(s.edge + 1) % 3], s.place)));
          path.points.push_back(at->second);
        };
        const auto& inner = positions_.points[a];
        good =
            good && (inner.count > 0 || roots[arc.numbers[0]].edge != roots[arc.numbers[1]].edge);
        end(0);
        for (std::size_t i = 0; i < inner.count; ++i) {
          const auto [x, y] = record_.points[inner.first + i];
          CornerWeights b;
          for (std::size_t k = 0; k < 4; ++k)
            b[k] = x * w[0][k] + y * w[1][k] + (1 - x - y) * w[2][k];
          path.points.push_back(plane_.points.size());
          plane_.points.push_back(project(b));
        }
        end(1);
        paths_.push_back(std::move(path));
      }
    });
    return good;
  }
  /// Whether a walk from the first comes past all. False, too, where there are many.
  bool are_one_loop() const {
    if (paths_.empty() || paths_.size() > 16) return false;
    unsigned left = (1U << paths_.size()) - 2;
    std::size_t end = paths_[0].points.back();
    for (std::size_t i = 0; i < paths_.size();) {
      const auto& [from, to] = std::pair(paths_[i].points.front(), paths_[i].points.back());
      if ((left >> i & 1U) == 0 || (from != end && to != end)) {
        ++i;
        continue;
      }
      left &= ~(1U << i);
      end = from == end ? to : from;
      i = 0;
    }
    return left == 0;
  }
  std::vector<Link> segments() const {
    std::vector<Link> r;
    for (const Path& path : paths_)
      for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
        r.push_back({path.points[i], path.points[i + 1]});
    return r;
  }

 private:
  struct Start {
    std::size_t edge;  ///< of the face
    double place;      ///< from its corner on
  };
  /// The roots around a face, as they are numbered there.
  boost::container::small_vector<Start, 12> roots_around(const Face& face) {
    boost::container::small_vector<Start, 12> all;
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge& edge = faces_.edge(face.edges[k]);
      boost::container::small_vector<double, 8> places;
      list_places(face.edges[k], places);
      const bool backward = edge.first != face.corners[k];
      if (backward) std::reverse(places.begin(), places.end());
      const double length = edge.to - edge.from;
      // Places on a line err by some 2^-53, and so do the edge's ends.
      plane_.error = std::fmax(plane_.error, 1e-13 + 4e-15 / length);
      for (const double x : places) {
        const double s = (x - edge.from) / length;
        all.push_back({k, backward ? 1 - s : s});
      }
    }
    return all;
  }
  /// Of an edge's roots, on its line.
  void list_places(Index e, boost::container::small_vector<double, 8>& places) {
    const Edge& edge = faces_.edge(e);
    if (edge.middle != kNone) {
      for (const Index part : edge.part) list_places(part, places);
      return;
    }
    const Index first = positions_.places[e];
    if (first == kNone) return;
    for (std::size_t i = 0; i < faces_.roots(e).count; ++i)
      places.push_back(edge.from + record_.root_places[first + i] * (edge.to - edge.from));
  }

  CornerWeights weights(const std::array<Index, 4>& corners, Index vertex) {
    const auto at = std::find(corners.begin(), corners.end(), vertex);
    if (at != corners.end()) {
      CornerWeights b{};
      b[static_cast<std::size_t>(at - corners.begin())] = 1;
      return b;
    }
    if (const auto found = known_.find(vertex); found != known_.end()) return found->second;
    const Cut& c = faces_.vertices().cut(vertex);
    return known_[vertex] = between(weights(corners, c.a), weights(corners, c.b), c.n / 64.0);
  }
  static CornerWeights between(const CornerWeights& a, const CornerWeights& b, double t) {
    CornerWeights r;
    for (std::size_t i = 0; i < 4; ++i) r[i] = a[i] + t * (b[i] - a[i]);
    return r;
  }

  Faces& faces_;
  const RecordedPositions& positions_;
  const certify::ModeLevel& record_;
  Plane plane_;
  std::unordered_map<Index, std::size_t> point_of_;  ///< by root
  std::unordered_map<Index, CornerWeights> known_;
  std::vector<Path> paths_;
};

class Counter {
 public:
  Counter(Extraction& extraction, const RecordedPositions& positions,
          const certify::ModeLevel& record)
      : extraction_(extraction), paths_(extraction.faces(), positions, record) {}

  struct Sum {
    std::uint32_t placed = 0, not_placed = 0;
    void add(std::size_t count, bool good) {
      (good ? placed : not_placed) += static_cast<std::uint32_t>(count);
    }
  };
  Sum of_cell(Index c, Side side) {
    Sum sum;
    const Cell& cell = extraction_.cells().cell(c);
    if (cell.state != State::graph || cell.part[0] != kNone) return sum;
    const std::size_t n = cell.pieces[static_cast<std::size_t>(static_cast<int>(side) + 1)];
    if (n > 0) sum.add(n, is_placed(cell, side, n));
    return sum;
  }
  Sum of_cone(const Cone& cone, Side side) {
    Sum sum;
    if (cone.zeros.size() != 1 || cone.open) return sum;
    paths_.clear();
    const std::array<Index, 4> corners = {cone.others[0], cone.others[1], cone.others[2], kNone};
    bool good = paths_.add(corners, extraction_.face_of(cone), side, [](const CornerWeights& b) {
      return Planar{b[0], b[1]};
    });
    kernel::DisjointSets curves(static_cast<Index>(paths_.plane().points.size()));
    for (const Paths::Path& path : paths_.list())
      curves.unite(static_cast<Index>(path.points.front()), static_cast<Index>(path.points.back()));
    std::vector<Index> names;
    for (const Paths::Path& path : paths_.list())
      names.push_back(curves.find(static_cast<Index>(path.points.front())));
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    good = good && paths_.plane().points.size() <= kMostVertices &&
           paths_.plane().is_simple(paths_.segments());
    sum.add(names.size(), good);
    return sum;
  }

 private:
  bool is_placed(const Cell& cell, Side side, std::size_t count) {
    paths_.clear();
    const Projection project(cell.witness.w);
    for (const Index f : cell.faces)
      if (!paths_.add(cell.corners, f, side, project)) return false;
    if (paths_.plane().points.size() > kMostVertices ||
        !paths_.plane().is_simple(paths_.segments()))
      return false;
    if (count == 1 && paths_.are_one_loop()) return true;
    std::map<Index, const Paths::Path*> path_of;
    for (const Paths::Path& path : paths_.list()) path_of[path.arc] = &path;
    const auto pieces =
        CellTopology(extraction_.faces(), cell.faces, cell.witness.w).pieces(side, count);
    std::vector<std::vector<std::size_t>> polygons;
    for (const Piece& piece : pieces)
      for (const Loop& loop : piece) {
        polygons.emplace_back();
        for (const LoopArc& a : loop) {
          auto points = path_of.at(a.arc)->points;
          if (!a.forward) std::reverse(points.begin(), points.end());
          polygons.back().insert(polygons.back().end(), points.begin(), points.end() - 1);
        }
      }
    return are_nested(polygons, count == polygons.size());
  }
  /// Disks: none holds another. One piece: one polygon holds the others, which hold none.
  bool are_nested(const std::vector<std::vector<std::size_t>>& polygons, bool disks) const {
    std::size_t outer = 0;
    for (const auto& polygon : polygons) {
      std::size_t held = 0;
      for (const auto& other : polygons) {
        if (&other == &polygon) continue;
        const auto holds = paths_.plane().holds(polygon, other[0]);
        if (!holds) return false;
        held += *holds ? 1 : 0;
      }
      if (held == 0) continue;
      if (disks || held + 1 != polygons.size()) return false;
      ++outer;
    }
    return disks || outer == 1;
  }

  Extraction& extraction_;
  Paths paths_;
};

}  // namespace

void count_placed(Extraction& extraction, const RecordedPositions& positions,
                  certify::ModeLevel& record) {
  std::vector<Side> sides = {Side::plus, Side::minus};
  if (extraction.level().neutral()) sides = {Side::neutral};
  std::atomic<std::uint32_t> placed{0}, not_placed{0};
  const auto run = [&](std::size_t size, const auto& sum_of) {
    using Range = tbb::blocked_range<std::size_t>;
    kernel::parallel_for(Range(0, size, 256), [&](const Range& range) {
      Counter counter(extraction, positions, record);
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        for (const Side side : sides) {
          const auto sum = sum_of(counter, i, side);
          placed += sum.placed;
          not_placed += sum.not_placed;
        }
    });
  };
  run(extraction.cells().size(), [](Counter& counter, std::size_t i, Side side) {
    return counter.of_cell(static_cast<Index>(i), side);
  });
  run(extraction.cones().size(), [&](Counter& counter, std::size_t i, Side side) {
    return counter.of_cone(extraction.cones()[i], side);
  });
  record.placed = placed;
  record.not_placed = not_placed;
}

/// The mode's gradient on the unit sphere is at most 3, so that an error of the tensor counts 3
/// times relative to its size, and a little more in second order; 64 roundings are more than there
/// are of numbers below 8.
template <std::size_t n>
bool is_near(const Vertices& vertices, const std::array<Index, n>& corners,
             const std::array<double, n>& weights, double level) {
  constexpr double kNear = 0x1p-40, kUnit = 0x1p-53;
  Symmetric t{};
  double error = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Deviator& corner = vertices.tensor(corners[i]);
    for (std::size_t k = 0; k < 6; ++k) t[k] += weights[i] * corner.t[k];
    error = std::fmax(error, corner.error + 24 * kUnit * corner.largest());
  }
  const double square = product(t, t);
  const double relative = 3 * error / std::sqrt(square);  // nine entries
  // Its cube is far from underflow.
  return square > 0x1p-500 && relative < 1e-6 &&
         std::fabs(ModeFunction::mode(t) - level) + 3.01 * relative + 512 * kUnit < kNear;
}

template bool is_near<2>(const Vertices&, const std::array<Index, 2>&, const std::array<double, 2>&,
                         double);
template bool is_near<3>(const Vertices&, const std::array<Index, 3>&, const std::array<double, 3>&,
                         double);
template bool is_near<4>(const Vertices&, const std::array<Index, 4>&, const std::array<double, 4>&,
                         double);

bool is_embedded(const kernel::TetMesh& mesh) {
  using Range = tbb::blocked_range<std::size_t>;
  std::vector<signed char> signs(mesh.tets().size());  // of the corners in ascending order
  std::atomic<bool> good{true};
  kernel::parallel_for(Range(0, signs.size(), 4096), [&](const Range& range) {
    for (std::size_t t = range.begin(); t < range.end(); ++t) {
      const auto given = mesh.tets()[t];
      int sign = mesh.orientation(static_cast<Index>(t));
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = i + 1; k < 4; ++k)
          if (given[i] > given[k]) sign = -sign;
      if (sign == 0) good = false;
      signs[t] = static_cast<signed char>(sign);
    }
  });
  if (!good) return false;
  // The side of a face, corners ascending, on which the other corner is.
  const auto side = [&](std::size_t face, Index tet) {
    const auto& faces = mesh.faces_of(tet);
    const auto apart = std::find(faces.begin(), faces.end(), face) - faces.begin();
    return apart % 2 == 1 ? signs[tet] : -signs[tet];
  };
  kernel::parallel_for(Range(0, mesh.faces().size(), 4096), [&](const Range& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f) {
      const auto& tets = mesh.faces()[f].tets;
      if (tets[1] != kernel::TetMesh::kNoTet && side(f, tets[0]) == side(f, tets[1])) good = false;
    }
  });
  return good;
}

}  // namespace crest::modes
