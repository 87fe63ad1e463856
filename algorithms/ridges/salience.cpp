// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/salience.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/ridges/hysteresis.hpp"
#include "algorithms/ridges/prominence.hpp"
#include "algorithms/ridges/umbilic_regions.hpp"

namespace crest::ridges {
namespace {

/// The umbilic that stands for its region: of the region's own index if there is one, then of the
/// largest patch, then the first.
Index representative(const RidgeGraph& graph, const UmbilicRegion& region) {
  const auto rank = [&](Index u) {
    const Umbilic& umbilic = graph.umbilics[u];
    return std::pair(umbilic.twice_index == region.twice_index, umbilic.patch.size());
  };
  return *std::max_element(region.umbilics.begin(), region.umbilics.end(),
                           [&](Index u, Index v) { return rank(u) < rank(v); });
}

/// Of each umbilic: whether its region is one significant umbilic.
std::vector<bool> mark_umbilics(RidgeGraph& graph, const std::vector<UmbilicRegion>& regions) {
  std::vector<bool> significant(graph.umbilics.size());
  for (Umbilic& u : graph.umbilics) {
    u.level = 0;
    u.region_twice_index = 0;
  }
  for (const UmbilicRegion& region : regions) {
    if (region.twice_index != 0) {
      Umbilic& umbilic = graph.umbilics[representative(graph, region)];
      umbilic.region_twice_index = region.twice_index;
      umbilic.level = region.is_umbilic() ? 1 : 0;
    }
    for (const Index u : region.umbilics) significant[u] = region.is_umbilic();
  }
  return significant;
}

Profile profile_of(const kernel::TriangleMesh& mesh, const FitResult& fit, const Ridge& ridge,
                   const std::vector<bool>& significant_umbilic) {
  Profile p;
  p.loop = ridge.loop;
  int umbilics = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const RidgeEnd& end = ridge.ends[i];
    umbilics += end.kind == EndKind::umbilic && significant_umbilic[end.umbilic];
    p.holds[i] = end.kind == EndKind::boundary ||
                 (end.kind == EndKind::umbilic && significant_umbilic[end.umbilic]);
  }
  p.between_umbilics = umbilics == 2;
  const std::size_t n = ridge.crossings.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Crossing& c = ridge.crossings[i];
    const kernel::Edge& e = mesh.edges()[c.edge];
    p.radius.push_back((1 - c.weight) * fit.errors[e.v0].radius +
                       c.weight * fit.errors[e.v1].radius);
    if (i < ridge.segment_count())
      p.gap.push_back(kernel::distance(c.point, ridge.crossings[(i + 1) % n].point));
  }
  return p;
}

/// Of each crossing: whether its edge has an end on a crease.
std::vector<bool> at_creases(const kernel::TriangleMesh& mesh, const FitResult& fit,
                             const Ridge& ridge) {
  std::vector<bool> at;
  for (const Crossing& c : ridge.crossings) {
    const kernel::Edge& e = mesh.edges()[c.edge];
    at.push_back(fit.creases[e.v0] || fit.creases[e.v1]);
  }
  return at;
}

/// Calls visit(i, j, length) for the run's segments, from crossing i to j.
template <class Visit>
void for_segments(const Profile& p, const Run& run, Visit&& visit) {
  const std::size_t n = p.radius.size();
  const std::size_t segments = run.count - (p.loop && run.count == n ? 0 : 1);
  for (std::size_t s = 0; s < segments; ++s) {
    const std::size_t i = (run.first + s) % n;
    visit(i, (i + 1) % n, p.gap[i]);
  }
}

double length_of(const Profile& p, const Run& run) {
  double sum = 0;
  for_segments(p, run, [&](std::size_t, std::size_t, double length) { sum += length; });
  return sum;
}

/// The integral of min(drop, 2 max|k|).
double weight_of(const Profile& p, const Run& run, const Ridge& ridge,
                 const std::vector<double>& drops) {
  const auto height = [&](std::size_t i) {
    const Crossing& c = ridge.crossings[i];
    return std::min(drops[i], 2 * std::max(std::fabs(c.k1), std::fabs(c.k2)));
  };
  double sum = 0;
  for_segments(p, run, [&](std::size_t i, std::size_t j, double length) {
    sum += length * (height(i) + height(j)) / 2;
  });
  return sum;
}

void raise(Ridge& ridge, const Run& run, std::uint8_t level) {
  for (std::size_t i = 0; i < run.count; ++i) {
    std::uint8_t& l = ridge.crossings[(run.first + i) % ridge.crossings.size()].level;
    l = std::max(l, level);
  }
}

/// Sets the levels and the weight of a ridge and adds it to the report.
void mark_ridge(Ridge& ridge, Profile& p, const std::vector<bool>& at_crease,
                const std::vector<double>& drops, const SalienceOptions& options,
                SalienceReport& report) {
  const std::size_t n = ridge.crossings.size();
  const auto score = [&](std::size_t i, double z) {
    return at_crease[i] ? std::numeric_limits<double>::infinity() : z;
  };
  p.z.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    ridge.crossings[i].level = 0;
    p.z[i] = score(i, ridge.crossings[i].significance);
  }
  const Runs significant = hysteresis(p, options.z);
  for (std::size_t i = 0; i < n; ++i) {
    const Crossing& c = ridge.crossings[i];
    p.z[i] = on_crest(c, ridge.colour) ? score(i, c.crest_significance) : 0;
  }
  const Runs crest = hysteresis(p, options.z);

  report.length += length_of(p, {0, n});
  report.gaps_closed += static_cast<Index>(significant.closed + crest.closed);
  for (const Run& run : significant.kept) raise(ridge, run, 1);
  ridge.weight = 0;
  bool salient = false;
  for (const Run& run : crest.kept) {
    const double weight = weight_of(p, run, ridge, drops);
    ridge.weight = std::max(ridge.weight, weight);
    report.length_unweighted += length_of(p, run);
    const bool light = weight < options.min_weight;
    const Run shown = light ? crease_piece(p, run) : run;
    if (light && shown.count < 2) continue;
    salient = true;
    report.length_salient += length_of(p, shown);
    raise(ridge, shown, 2);
  }
  for_segments(p, {0, n}, [&](std::size_t i, std::size_t j, double length) {
    const bool kept = ridge.crossings[i].level > 0 && ridge.crossings[j].level > 0;
    report.length_significant += kept ? length : 0;
  });
  const bool real = salient || !significant.kept.empty();
  report.salient += salient;
  report.significant += real;
  report.insignificant += !real && significant.found == 0;
  report.short_runs += !real && significant.found > 0;
  report.not_crest += real && !salient && crest.kept.empty();
  report.light += real && !salient && !crest.kept.empty();
}

}  // namespace

SalienceReport mark_salience(const kernel::TriangleMesh& mesh, const FitResult& fit,
                             RidgeGraph& graph, const SalienceOptions& options) {
  SalienceReport report;
  std::vector<std::vector<double>> drops = mark_prominence(mesh, fit, graph);
  report.regions = umbilic_regions(mesh, fit, graph);
  const std::vector<bool> significant_umbilic = mark_umbilics(graph, report.regions);
  for (std::size_t r = 0; r < graph.ridges.size(); ++r) {
    Ridge& ridge = graph.ridges[r];
    Profile profile = profile_of(mesh, fit, ridge, significant_umbilic);
    const std::vector<bool> at_crease = at_creases(mesh, fit, ridge);
    for (std::size_t i = 0; i < at_crease.size(); ++i)
      if (at_crease[i]) drops[r][i] = std::numeric_limits<double>::infinity();
    mark_ridge(ridge, profile, at_crease, drops[r], options, report);
    for (const Crossing& c : ridge.crossings) {
      const kernel::Edge& e = mesh.edges()[c.edge];
      report.undetermined += fit.quality[e.v0].degree < 4 || fit.quality[e.v1].degree < 4;
    }
    const Crossing* tips[2] = {&ridge.crossings.front(), &ridge.crossings.back()};
    for (std::size_t i = 0; i < 2; ++i) {
      if (ridge.ends[i].kind != EndKind::umbilic || tips[i]->level < 2) continue;
      std::uint8_t& level = graph.umbilics[ridge.ends[i].umbilic].level;
      if (level > 0) level = 2;
    }
  }
  return report;
}

}  // namespace crest::ridges
