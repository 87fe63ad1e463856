// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/curvature/curvature.hpp"

#include <algorithm>
#include <string>

#include "algorithms/curvature/pieces.hpp"
#include "algorithms/curvature/tangent.hpp"
#include "kernel/geometry/coordinate_range.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::curvature {
namespace {

constexpr std::array<const char*, kMethods.size()> kNames = {"np", "ne",  "cf",          "qf",
                                                             "qt", "jet", "normal-cycle"};

void require_normals(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals) {
  if (normals.size() != mesh.vertex_count()) {
    throw kernel::InputError("normals: there are " + std::to_string(normals.size()) + " for " +
                             std::to_string(mesh.vertex_count()) +
                             " vertices; give one normal a vertex");
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const double squared = dot(normals[v], normals[v]);
    if (!(squared > 0) || !std::isfinite(squared)) {
      throw kernel::InputError("vertex " + std::to_string(v) +
                               ": its normal is zero or not finite; repair or estimate normals");
    }
  }
}

void check(const kernel::TriangleMesh& mesh, const Options& options) {
  if (mesh.vertex_count() == 0) throw kernel::InputError("mesh: it is empty; give a mesh");
  kernel::require_carried(mesh.points());
  if (!options.normals.empty())
    require_normals(mesh, options.normals);
  else if (options.method == Method::np)
    throw kernel::InputError("normals: np needs them; give a file with normals or use ne");
}

void count(const std::vector<VertexFlags>& flags, Result& result) {
  result.lowered = result.complex = result.undetermined = 0;
  for (const VertexFlags& f : flags) {
    result.lowered += f.lowered ? 1 : 0;
    result.complex += f.complex ? 1 : 0;
    result.undetermined += f.undetermined ? 1 : 0;
  }
}

}  // namespace

const char* name_of(Method method) {
  return kNames[static_cast<std::size_t>(method)];
}

std::optional<Method> method_of(std::string_view name) {
  for (const Method method : kMethods)
    if (name == name_of(method)) return method;
  return std::nullopt;
}

std::vector<Vec3> area_weighted_normals(const kernel::TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertex_count());
  area_weighted_normals(mesh, normals);
  return normals;
}

void area_weighted_normals(const kernel::TriangleMesh& mesh, std::vector<Vec3>& normals) {
  const auto& points = mesh.points();
  for_each_index(mesh.vertex_count(), [&](Index v) {
    const auto ring = mesh.ring(v);
    const bool open = mesh.on_boundary(v);
    Vec3 sum{}, first{};
    Vec3 before = points[open ? ring.front() : ring.back()] - points[v];
    for (std::size_t j = open ? 1 : 0; j < ring.size(); ++j) {
      const Vec3 next = points[ring[j]] - points[v];
      const Vec3 n = cross(before, next);
      if (j < 2) first = n;
      sum = sum + n;
      before = next;
    }
    double squared = dot(sum, sum);
    if (!(squared > 0)) {
      sum = first;
      squared = dot(sum, sum);
    }
    // Slivers whose area underflows leave no direction at all.
    normals[v] = squared > 0 ? 1 / std::sqrt(squared) * sum : Vec3{0, 0, 1};
  });
}

void collect_rings(const kernel::TriangleMesh& mesh, Index v, int rings, std::size_t points,
                   std::vector<Index>& out) {
  out.assign(1, v);
  std::size_t begin = 0;
  for (int ring = 0; ring < rings || out.size() - 1 < points; ++ring) {
    const std::size_t end = out.size();
    for (std::size_t i = begin; i < end; ++i) {
      const auto around = mesh.ring(out[i]);
      out.insert(out.end(), around.begin(), around.end());
    }
    // New ones: those of the new ring that are in neither of the last two rings.
    const auto at = [&](std::size_t i) { return out.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(end), out.end());
    out.erase(std::unique(at(end), out.end()), out.end());
    const std::size_t inner = begin;
    std::size_t keep = end;
    for (std::size_t i = end; i < out.size(); ++i) {
      const bool old = std::binary_search(at(inner), at(end), out[i]) ||
                       std::find(out.begin(), at(inner), out[i]) != at(inner);
      if (!old) out[keep++] = out[i];
    }
    out.resize(keep);
    if (keep == end) return;
    begin = end;
  }
}

Result estimate(const kernel::TriangleMesh& mesh, const Options& options, const Workers* workers) {
  Result result;
  if (workers == nullptr || workers->pieces <= 1) {
    estimate(mesh, options, result);
    return result;
  }
  check(mesh, options);
  count(estimate_pieces(mesh, options, *workers, result), result);
  return result;
}

void estimate(const kernel::TriangleMesh& mesh, const Options& options, Result& result) {
  check(mesh, options);
  count(estimate_all(mesh, options, result), result);
}

std::vector<VertexFlags> estimate_all(const kernel::TriangleMesh& mesh, const Options& options,
                                      Result& result) {
  if (options.normals.empty()) {
    result.normals.resize(mesh.vertex_count());
    area_weighted_normals(mesh, result.normals);
  } else {
    result.normals = options.normals;
  }
  result.vertices.resize(mesh.vertex_count());
  std::vector<VertexFlags> flags(mesh.vertex_count());
  switch (options.method) {
    case Method::np:
    case Method::ne:
      normal_based(mesh, result.normals, result.vertices, flags);
      break;
    case Method::normal_cycle:
      normal_cycle(mesh, result.normals, options.rings, result.vertices, flags);
      break;
    default:
      fit(mesh, result.normals, options, result.vertices, flags);
  }
  for_each_index(mesh.vertex_count(), [&](Index v) {
    if (is_finite(result.vertices[v]) && !flags[v].undetermined) return;
    result.vertices[v] = {};
    flags[v] = {false, false, true};
  });
  return flags;
}

Distances distances(const std::vector<PointCurvature>& estimates,
                    const std::vector<PointCurvature>& exact) {
  Distances sum;
  const auto angle = [](const Vec3& a, const Vec3& b) {
    const Vec3 n = cross(a, b);
    return std::atan2(norm(n), std::abs(dot(a, b)));  // arccos |a b|, also near 1
  };
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    const PointCurvature &a = estimates[i], &b = exact[i];
    sum.K += (a.K - b.K) * (a.K - b.K);
    sum.H += (a.H - b.H) * (a.H - b.H);
    sum.P += 0.5 *
             std::min(angle(a.d1, b.d1) + angle(a.d2, b.d2), angle(a.d1, b.d2) + angle(a.d2, b.d1));
  }
  const double s = 1 / static_cast<double>(estimates.size());
  return {sum.K * s, sum.H * s, sum.P * s};
}

}  // namespace crest::curvature
