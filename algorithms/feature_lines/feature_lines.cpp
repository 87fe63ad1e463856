// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/feature_lines/feature_lines.hpp"

#include <string>
#include <utility>

#include "kernel/geometry/coordinate_range.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::feature_lines {
namespace {

using kernel::TriangleMesh;

Marks feature_region(const TriangleMesh& mesh, const std::vector<double>& field, double value,
                     const Options& o) {
  Marks region = threshold_by_value(field, value);
  region = dilate(mesh, region, {o.neighbourhood, o.dilate});
  region = erode(mesh, region, {o.neighbourhood, o.erode});
  region = opening(mesh, region, {o.neighbourhood, o.open});
  return closing(mesh, region, {o.neighbourhood, o.close});
}

Marks result_of(const Thinning& thinning) {
  Marks marks = thinning.after;
  for (const Index v : thinning.dropped) marks[v] = 0;
  return marks;
}

void take_result(const TriangleMesh& mesh, Thinning thinning, FeatureLines& result) {
  result.thinning = std::move(thinning);
  ++result.thinnings;
  result.marks = result_of(result.thinning);
  result.graph = build_feature_graph(mesh, result.marks);
}

}  // namespace

Thinning thin(const TriangleMesh& mesh, Marks region, Index prune,
              const std::vector<double>& field) {
  Thinning t;
  t.before = region;
  Thinner thinner(mesh, std::move(region), field);
  thinner.skeletonize();
  thinner.pre_prune();
  thinner.prune(prune);
  t.after = thinner.marks();
  t.removed = thinner.removed();
  t.dropped = thinner.dropped();
  t.topology_before = topology_of(mesh, t.before);
  t.topology_after = topology_of(mesh, t.after);
  return t;
}

FeatureLines extract_feature_lines(const TriangleMesh& mesh, const std::vector<double>& field,
                                   const Options& o) {
  if (field.size() != mesh.vertex_count()) {
    throw kernel::InputError("field: has " + std::to_string(field.size()) + " values for " +
                             std::to_string(mesh.vertex_count()) +
                             " vertices; give one number a vertex");
  }
  kernel::require_carried(mesh.points());
  FeatureLines result;
  result.value = o.value      ? *o.value
                 : o.seek_gap ? gap_threshold(field, o.quantile)
                              : quantile_threshold(field, o.quantile);
  Marks region = feature_region(mesh, field, result.value, o);
  result.marked = count(region);
  take_result(mesh, thin(mesh, std::move(region), o.prune, field), result);
  if (o.min_patch > 1) {
    const Marks filled = fill_small_patches(result.graph, result.marks, o.min_patch);
    if (filled != result.marks) {
      const auto patches = result.graph.patch_sizes.size();
      take_result(mesh, thin(mesh, filled, o.prune, field), result);
      result.filled_patches = static_cast<Index>(patches - result.graph.patch_sizes.size());
    }
  }
  if (o.close_branches > 0) {
    Marks closed = result.marks;
    const auto paths = joining_paths(mesh, result.graph, {2, o.close_branches});
    for (const auto& path : paths)
      for (const Index v : path) closed[v] = 1;
    result.joined = static_cast<Index>(paths.size());
    if (result.joined > 0) take_result(mesh, thin(mesh, std::move(closed), o.prune, field), result);
  }
  return result;
}

}  // namespace crest::feature_lines
