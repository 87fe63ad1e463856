// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/feature_lines/marks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <string>
#include <utility>

#include "algorithms/feature_lines/geodesic.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::feature_lines {
namespace {

using kernel::distance;
using kernel::TriangleMesh;

void require_numbers(const std::vector<double>& field) {
  for (std::size_t v = 0; v < field.size(); ++v) {
    if (std::isnan(field[v])) {
      throw kernel::InputError("vertex " + std::to_string(v) +
                               ": its field value is not a number; give a number to every vertex");
    }
  }
}

std::vector<double> sorted_numbers(std::vector<double> field) {
  if (field.empty()) throw kernel::InputError("field: has no values; give one a vertex");
  require_numbers(field);
  std::sort(field.begin(), field.end());
  return field;
}

std::size_t place_of(double quantile, std::size_t values) {
  const auto last = static_cast<double>(values - 1);
  return static_cast<std::size_t>(
      std::min(last, std::floor(quantile * static_cast<double>(values))));
}

/// The value above the widest gap among those that equal the one at `place` but for rounding.
double above_equal(const std::vector<double>& sorted, std::size_t place) {
  const double value = sorted[place];
  const double largest = std::max(std::fabs(sorted.front()), std::fabs(sorted.back()));
  const double least = value - std::max(0x1p-20 * std::fabs(value), 0x1p-36 * largest);
  std::size_t best = place;
  double widest = -1;
  for (std::size_t i = place; sorted[i] >= least; --i) {
    if (i == 0) return sorted[0];
    if (const double gap = sorted[i] - sorted[i - 1]; gap > widest) {
      widest = gap;
      best = i;
    }
  }
  return sorted[best];
}

Marks complement(Marks marks) {
  for (auto& mark : marks) mark ^= 1;
  return marks;
}

Marks grow_by_rings(const TriangleMesh& mesh, Marks marks, double size) {
  std::vector<Index> front, next;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (marks[v]) front.push_back(v);
  for (double ring = 1; ring <= size && !front.empty(); ++ring) {
    next.clear();
    for (const Index v : front) {
      for (const Index w : mesh.ring(v)) {
        if (marks[w]) continue;
        marks[w] = 1;
        next.push_back(w);
      }
    }
    front.swap(next);
  }
  return marks;
}

/// Dijkstra from all marked vertices at once, stopped at `size`.
Marks grow_by_paths(const TriangleMesh& mesh, Marks marks, double size) {
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<double> best(mesh.vertex_count(), std::nextafter(size, HUGE_VAL));
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!marks[v]) continue;
    best[v] = 0;
    queue.push({0, v});
  }
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > best[v]) continue;
    marks[v] = 1;
    for (const Index w : mesh.ring(v)) {
      const double e = d + distance(mesh.points()[v], mesh.points()[w]);
      if (e < best[w]) {
        best[w] = e;
        queue.push({e, w});
      }
    }
  }
  return marks;
}

Marks grow_by_geodesics(const TriangleMesh& mesh, const Marks& marks, double size) {
  const std::vector<double> distances = geodesic_distances(mesh, marks, size);
  Marks grown(marks.size());
  for (std::size_t v = 0; v < grown.size(); ++v) grown[v] = distances[v] <= size ? 1 : 0;
  return grown;
}

/// Walks the vertices of a ball that its centre reaches by edges inside the ball.
class BallWalker {
 public:
  explicit BallWalker(const TriangleMesh& mesh) : mesh_(mesh), seen_(mesh.vertex_count(), kNone) {}

  /// Calls visit(w) for each; stops and returns false as soon as it answers false.
  template <class Visit>
  bool walk(Index centre, double radius, Visit&& visit) {
    stack_.assign(1, centre);
    seen_[centre] = centre;
    while (!stack_.empty()) {
      const Index v = stack_.back();
      stack_.pop_back();
      if (!visit(v)) return false;
      for (const Index w : mesh_.ring(v)) {
        if (seen_[w] == centre) continue;
        seen_[w] = centre;
        if (distance(mesh_.points()[centre], mesh_.points()[w]) <= radius) stack_.push_back(w);
      }
    }
    return true;
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<Index> seen_;  ///< the last centre whose walk met the vertex
  std::vector<Index> stack_;
};

}  // namespace

Index count(const Marks& marks) {
  return static_cast<Index>(std::count(marks.begin(), marks.end(), std::uint8_t{1}));
}

Marks threshold_by_value(const std::vector<double>& field, double value) {
  require_numbers(field);
  Marks marks(field.size());
  for (std::size_t v = 0; v < field.size(); ++v) marks[v] = field[v] >= value ? 1 : 0;
  return marks;
}

double field_quantile(const std::vector<double>& field, double quantile) {
  const std::vector<double> sorted = sorted_numbers(field);
  return sorted[place_of(quantile, sorted.size())];
}

double quantile_threshold(const std::vector<double>& field, double quantile) {
  const std::vector<double> sorted = sorted_numbers(field);
  return above_equal(sorted, place_of(quantile, sorted.size()));
}

double gap_threshold(const std::vector<double>& field, double quantile) {
  const std::vector<double> sorted = sorted_numbers(field);
  const std::size_t n = sorted.size(), place = place_of(quantile, n), marked = n - place;
  std::size_t best = 0;
  double widest = sorted[place] > 0 ? sorted[place] / 4 : HUGE_VAL;
  for (std::size_t i = n - (marked + 1) / 2; i > 0 && i + 2 * marked >= n; --i) {
    const double gap = sorted[i] - sorted[i - 1];
    if (gap <= widest * (1 + 0x1p-10)) continue;
    widest = gap;
    best = i;
  }
  return best > 0 ? sorted[best] : above_equal(sorted, place);
}

Marks dilate(const TriangleMesh& mesh, const Marks& marks, const Structure& s) {
  if (s.size <= 0) return marks;
  if (s.kind == Neighbourhood::rings) return grow_by_rings(mesh, marks, s.size);
  if (s.kind == Neighbourhood::path) return grow_by_paths(mesh, marks, s.size);
  if (s.kind == Neighbourhood::geodesic) return grow_by_geodesics(mesh, marks, s.size);
  Marks grown = marks;
  BallWalker walker(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!marks[v]) continue;
    walker.walk(v, s.size, [&](Index w) {
      grown[w] = 1;
      return true;
    });
  }
  return grown;
}

Marks erode(const TriangleMesh& mesh, const Marks& marks, const Structure& s) {
  if (s.size <= 0) return marks;
  // These relations are symmetric (geodesic: nearly): eroding is dilating the complement.
  if (s.kind != Neighbourhood::euclidean) return complement(dilate(mesh, complement(marks), s));
  Marks kept = marks;
  BallWalker walker(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (marks[v]) kept[v] = walker.walk(v, s.size, [&](Index w) { return marks[w] != 0; }) ? 1 : 0;
  return kept;
}

Marks opening(const TriangleMesh& mesh, const Marks& marks, const Structure& s) {
  Marks opened = dilate(mesh, erode(mesh, marks, s), s);
  if (s.kind == Neighbourhood::geodesic)
    for (std::size_t v = 0; v < marks.size(); ++v) opened[v] &= marks[v];
  return opened;
}

Marks closing(const TriangleMesh& mesh, const Marks& marks, const Structure& s) {
  Marks closed = erode(mesh, dilate(mesh, marks, s), s);
  if (s.kind == Neighbourhood::geodesic)
    for (std::size_t v = 0; v < marks.size(); ++v) closed[v] |= marks[v];
  return closed;
}

}  // namespace crest::feature_lines
