// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/prominence.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/geometry/parallel.hpp"

namespace crest::ridges {
namespace {

double mix(double a, double b, double weight) {
  return weight == 0 ? a : (1 - weight) * a + weight * b;  // infinities do not meet zero
}

/// A point of a walk.
struct Place {
  double k, wide, error, length;
};

Place place_of(const FitResult& fit, Colour c, Index p, Index q, double weight, double length) {
  const bool blue = c == Colour::blue;
  const kernel::MongeForm &m = fit.forms[p], &n = fit.forms[q];
  const CurvatureError &a = fit.errors[p], &b = fit.errors[q];
  return {blue ? mix(m.k1, n.k1, weight) : mix(m.k2, n.k2, weight),
          blue ? mix(a.wide_k1, b.wide_k1, weight) : mix(a.wide_k2, b.wide_k2, weight),
          blue ? mix(a.k1, b.k1, weight) : mix(a.k2, b.k2, weight), length};
}

/// What a thread's walks use again and again, by side.
struct Buffers {
  std::vector<Place> places;
  std::vector<std::pair<std::size_t, double>> differences;
};

/// One side's walk, made as far as it is asked for.
class Side {
 public:
  Side(const CurvatureLines& lines, const FitResult& fit, const Crossing& x, Colour colour,
       bool forward, double radius, std::vector<Place>& places)
      : fit_(fit),
        colour_(colour),
        walk_(lines, x.edge, x.weight, colour, forward, radius),
        reach_(4 * radius),
        places_(places) {
    places_.clear();
  }

  double window() const { return reach_ / 8; }  ///< R / 2

  /// The i-th place within reach, or null. Valid until a later one is asked for.
  const Place* at(std::size_t i) {
    while (i >= places_.size()) {
      if (ended_ || !walk_.step() || walk_.length() > reach_) {
        ended_ = true;
        return nullptr;
      }
      places_.push_back(place_of(fit_, colour_, walk_.vertex(0), walk_.vertex(1), walk_.weight(),
                                 walk_.length()));
    }
    return &places_[i];
  }

 private:
  const FitResult& fit_;
  Colour colour_;
  LineWalk walk_;
  double reach_;
  std::vector<Place>& places_;
  bool ended_ = false;
};

struct Measure {
  double significance = 0, drop = 0;
};

/// The largest z and drop of a side, as far as it is followed.
class Descent {
 public:
  /// beyond: the peak's place, if it is on this side.
  Descent(Side& side, const Place& x, const Place& peak, int sense, double beyond,
          std::vector<std::pair<std::size_t, double>>& differences)
      : side_(side), x_(x), peak_(peak), sense_(sense), beyond_(beyond), largest_(differences) {
    largest_.clear();
  }

  const Measure& so_far() const { return measure_; }

  /// Goes on by a place. False: the side has ended.
  bool step() {
    const Place* y = ended_ ? nullptr : side_.at(next_);
    const double drop = y ? sense_ * (peak_.k - y->k) : -1;
    ended_ = drop < 0;  // a higher place: within an edge there is none
    if (ended_) return false;
    const std::size_t i = next_++;
    if (y->length < beyond_) return true;
    const double model = model_error(i, *y);
    if (!(drop > 0)) return true;
    const double noise = x_.error * x_.error + y->error * y->error;
    const double variance = noise + std::max(0.0, model * model - noise) / 4;
    measure_.significance = std::max(measure_.significance, drop / std::sqrt(variance));
    measure_.drop = std::max(measure_.drop, drop);
    return true;
  }

 private:
  /// The largest |drop - drop'| of the places up to i, y, that are no farther than R / 2 back.
  double model_error(std::size_t i, const Place& y) {
    const double here = std::fabs((peak_.k - y.k) - (peak_.wide - y.wide));
    while (side_.at(first_)->length < std::max(beyond_, y.length - side_.window())) ++first_;
    while (largest_.size() > front_ && largest_.back().second <= here) largest_.pop_back();
    largest_.emplace_back(i, here);
    while (largest_[front_].first < first_) ++front_;
    return largest_[front_].second;
  }

  Side& side_;
  const Place &x_, &peak_;
  int sense_;
  double beyond_;
  /// From front_ on places of the window, each with a larger difference than all later ones.
  std::vector<std::pair<std::size_t, double>>& largest_;
  std::size_t front_ = 0, first_ = 0, next_ = 0;
  Measure measure_;
  bool ended_ = false;
};

/// The lesser side's; a side is followed only while it is the lesser.
Measure measure(std::array<Side*, 2> sides, const Place& x, int sense, double edge,
                std::array<Buffers, 2>& buffers) {
  Place peak = x;
  const Side* on = nullptr;
  for (Side* side : sides)
    for (std::size_t i = 0; const Place* y = side->at(i); ++i) {
      if (y->length > edge) break;
      if (!(sense * y->k > sense * peak.k)) continue;
      peak = *y;
      on = side;
    }
  const auto beyond = [&](const Side* side) { return on == side ? peak.length : 0; };
  Descent a(*sides[0], x, peak, sense, beyond(sides[0]), buffers[0].differences);
  Descent b(*sides[1], x, peak, sense, beyond(sides[1]), buffers[1].differences);
  const auto least = [&](double Measure::*of) {
    const auto lesser_steps = [&] { return (a.so_far().*of <= b.so_far().*of ? a : b).step(); };
    while (lesser_steps()) {
    }
    return std::min(a.so_far().*of, b.so_far().*of);
  };
  return {least(&Measure::significance), least(&Measure::drop)};
}

/// 1: a maximum of k, -1: a minimum, 0: neither is claimed.
int sense_of_type(const Crossing& x, Colour colour) {
  const int elliptic = colour == Colour::blue ? 1 : -1;
  return x.type == RidgeType::elliptic ? elliptic : x.type == RidgeType::hyperbolic ? -elliptic : 0;
}

double mean_edge_length(const kernel::TriangleMesh& mesh) {
  double sum = 0;
  for (const kernel::Edge& e : mesh.edges())
    sum += kernel::distance(mesh.points()[e.v0], mesh.points()[e.v1]);
  return sum / mesh.edge_count();
}

/// Sets the crossing's numbers; returns the prominence as a maximum of |k| if it is on the crest.
double mark(const CurvatureLines& lines, const FitResult& fit, double edge, Colour colour,
            Crossing& x, std::array<Buffers, 2>& buffers) {
  x.significance = x.prominence = x.crest_significance = 0;
  const kernel::Edge& e = lines.mesh().edges()[x.edge];
  const Place here = place_of(fit, colour, e.v0, e.v1, x.weight, 0);
  if (std::isinf(here.error)) return 0;
  const double radius = mix(fit.errors[e.v0].radius, fit.errors[e.v1].radius, x.weight);
  Side ahead(lines, fit, x, colour, true, radius, buffers[0].places);
  Side behind(lines, fit, x, colour, false, radius, buffers[1].places);
  const std::array<Side*, 2> sides = {&ahead, &behind};
  const int sense = sense_of_type(x, colour);
  const int crest_sense = !on_crest(x, colour) ? 0 : colour == Colour::blue ? 1 : -1;
  Measure typed, crest;
  if (sense != 0) typed = measure(sides, here, sense, edge, buffers);
  if (crest_sense != 0)
    crest = sense == crest_sense ? typed : measure(sides, here, crest_sense, edge, buffers);
  x.significance = typed.significance;
  x.prominence = typed.drop;
  x.crest_significance = crest.significance;
  return crest.drop;
}

}  // namespace

bool on_crest(const Crossing& c, Colour colour) {
  return colour == Colour::blue ? c.k1 > std::fabs(c.k2) : -c.k2 > std::fabs(c.k1);
}

std::vector<std::vector<double>> mark_prominence(const kernel::TriangleMesh& mesh,
                                                 const FitResult& fit, RidgeGraph& graph) {
  const CurvatureLines lines(mesh, fit.forms);
  const double edge = mean_edge_length(mesh);
  std::vector<std::vector<double>> drops(graph.ridges.size());
  std::vector<std::size_t> begin = {0};  // of each ridge among all crossings
  for (std::size_t r = 0; r < graph.ridges.size(); ++r) {
    drops[r].resize(graph.ridges[r].crossings.size());
    begin.push_back(begin.back() + drops[r].size());
  }
  tbb::enumerable_thread_specific<std::array<Buffers, 2>> buffers;
  kernel::parallel_for(
      tbb::blocked_range<std::size_t>(0, begin.back(), 256), [&](const auto& range) {
        std::array<Buffers, 2>& own = buffers.local();
        auto r = static_cast<std::size_t>(
            std::upper_bound(begin.begin(), begin.end(), range.begin()) - begin.begin() - 1);
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          while (i >= begin[r + 1]) ++r;
          Ridge& ridge = graph.ridges[r];
          drops[r][i - begin[r]] =
              mark(lines, fit, edge, ridge.colour, ridge.crossings[i - begin[r]], own);
        }
      });
  return drops;
}

}  // namespace crest::ridges
