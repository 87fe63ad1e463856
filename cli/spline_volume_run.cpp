// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/spline_volume_run.hpp"

#include <fmt/format.h>

#include <cmath>

#include "algorithms/splines/pinhole.hpp"
#include "algorithms/splines/quadratic_certificate.hpp"
#include "certify/certificate.hpp"
#include "cli/spline_points_run.hpp"
#include "io/page/scene.hpp"
#include "io/splines/isosurface_writer.hpp"
#include "io/splines/quadratic_model_file.hpp"
#include "io/splines/ray_picture.hpp"
#include "io/splines/table.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::cli {
namespace {

using splines::Hit;
using splines::Pinhole;
using splines::QuadraticSpline;
using splines::Ray;

void check(const SplineOptions& o) {
  if (!o.columns.empty() || o.smoothness || !o.cubes.empty() || !o.box.empty())
    throw UsageError("--columns, --smoothness, -n and --box are for tables of samples");
  const bool mesh = !o.mesh.empty() || !o.common.page.empty();
  const bool level = !o.rays.empty() || !o.common.picture.empty() || mesh;
  if (level && !o.isovalue)
    throw UsageError("--rays, --picture, --mesh and --page need --isovalue");
  if (!level && o.isovalue)
    throw UsageError("--isovalue is for --rays, --picture, --mesh and --page");
  if (!o.camera.empty() && o.common.picture.empty()) throw UsageError("--camera is for --picture");
  const int claims = !o.rays.empty() + !o.common.picture.empty() + mesh;
  if (!o.common.certificate.empty() && claims != 1)
    throw UsageError("--certificate is for one of --rays, --picture and --mesh (--page)");
}

QuadraticSpline read_spline(Run& run, const SplineOptions& o) {
  return run.step("read", "reading " + o.common.input, [&] {
    const auto header = io::read_quadratic_header(o.common.input);
    io::VolumeFile file = io::read_volume(o.common.input, o.source);
    splines::Border border = o.extend ? splines::Border::extend : splines::Border::none;
    if (header) {
      header->restore(file.grid);
      border = header->border;
    } else {
      for (const std::string& warning : file.warnings) run.warn(warning);
    }
    return run.with_input([&] { return QuadraticSpline(std::move(file.grid), border); });
  });
}

std::vector<Ray> read_rays(Run& run, const std::string& path) {
  const io::Table table = run.step("read", "reading " + path, [&] {
    return io::read_table(path, {"ox", "oy", "oz", "dx", "dy", "dz"});
  });
  std::vector<Ray> rays(table.rows);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      rays[i].origin[k] = table.columns[k][i];
      rays[i].direction[k] = table.columns[3 + k][i];
    }
    if (const char* const problem = splines::problem_of(rays[i]))
      throw kernel::InputError(fmt::format("{}: ray {}: {}", path, i, problem));
  }
  return rays;
}

Pinhole camera_of(const SplineOptions& o, const QuadraticSpline& spline) {
  if (o.camera.empty()) return splines::automatic_view(spline, o.size);
  Pinhole camera;
  camera.width = camera.height = o.size;
  for (std::size_t k = 0; k < 3; ++k) {
    camera.eye[k] = o.camera[k];
    camera.target[k] = o.camera[3 + k];
  }
  if (o.camera.size() == 7) camera.angle = o.camera[6];
  if (camera.eye == camera.target || !(camera.angle > 0 && camera.angle < 180))
    throw UsageError("--camera: eye and target must differ, the angle be between 0 and 180");
  return camera;
}

void write_hits(const std::string& path, const std::vector<Hit>& hits) {
  const std::vector<std::string> names = {"hit", "t",  "t_lo", "t_hi", "x", "y", "z",
                                          "gx",  "gy", "gz",   "i",    "j", "k", "tetrahedron"};
  std::vector<std::vector<double>> columns(names.size(), std::vector<double>(hits.size(), NAN));
  for (std::size_t r = 0; r < hits.size(); ++r) {
    const Hit& h = hits[r];
    columns[0][r] = h.hit;
    if (!h.hit) continue;
    const std::array<double, 13> row = {h.t,
                                        h.t_lo,
                                        h.t_hi,
                                        h.place[0],
                                        h.place[1],
                                        h.place[2],
                                        h.gradient[0],
                                        h.gradient[1],
                                        h.gradient[2],
                                        static_cast<double>(h.cube[0]),
                                        static_cast<double>(h.cube[1]),
                                        static_cast<double>(h.cube[2]),
                                        static_cast<double>(h.tetrahedron)};
    for (std::size_t c = 0; c < row.size(); ++c) columns[c + 1][r] = row[c];
  }
  const std::vector<std::span<const double>> views(columns.begin(), columns.end());
  io::write_table(path, names, views);
}

/// What rays did, for the report and the summary.
class RayWork {
 public:
  RayWork(Run& run, const QuadraticSpline& spline, double level) : run_(run), spline_(spline) {
    run.step("prepare", "bounding cubes", [&] { caster_.emplace(spline, level); });
  }
  std::vector<Hit> cast(const std::vector<Ray>& rays) {
    std::vector<Hit> hits(rays.size());
    counts_ += run_.step("rays", "casting rays", [&] { return caster_->cast(rays, hits); });
    run_.step("certificate", "certifying", [&] { certify(rays, hits); });
    return hits;
  }
  std::string finish() {
    const auto each = [&](std::uint64_t n) {
      return counts_.cast == 0 ? 0.0 : static_cast<double>(n) / static_cast<double>(counts_.cast);
    };
    run_.report()["rays"] = {{"cast", counts_.cast},
                             {"hits", counts_.hits},
                             {"tangent", counts_.tangent},
                             {"climbed", counts_.climbed},
                             {"cubes_per_ray", each(counts_.cubes)},
                             {"tetrahedra_per_ray", each(counts_.tetrahedra)},
                             {"active_cubes", caster_->active().count()}};
    return fmt::format("{} rays, {} hit, {} touch; rationals decided {}\n", counts_.cast,
                       counts_.hits, counts_.tangent, counts_.climbed);
  }

 private:
  void certify(const std::vector<Ray>& rays, const std::vector<Hit>& hits) {
    if (!run_.wanted("--certificate")) return;
    run_.write_certificate("spline-rays", certify::encode(splines::rays_certificate(
                                              spline_, caster_->level(), rays, hits)));
  }
  Run& run_;
  const QuadraticSpline& spline_;
  std::optional<splines::RayCaster> caster_;
  splines::RayCounts counts_;
};

std::string cast_rays(Run& run, const SplineOptions& o, const QuadraticSpline& spline) {
  if (o.rays.empty() && o.common.picture.empty()) return {};
  std::optional<std::vector<Ray>> given;
  if (!o.rays.empty()) given = read_rays(run, o.rays);
  const Pinhole camera = camera_of(o, spline);
  RayWork work(run, spline, *o.isovalue);
  if (given) {
    const auto hits = work.cast(*given);
    run.write("--hits", [&](const std::string& path) { write_hits(path, hits); });
  }
  if (!o.common.picture.empty()) {
    const auto hits = work.cast(camera.rays());
    run.write("--picture",
              [&](const std::string& path) { io::write_ray_picture(path, camera, hits); });
  }
  return work.finish();
}

/// Whether all of the surface is proven.
bool make_mesh(Run& run, const SplineOptions& o, const QuadraticSpline& spline,
               std::string& lines) {
  if (o.mesh.empty() && o.common.page.empty()) return true;
  const auto surface = run.step("isosurface", "isosurface", [&] {
    return run.with_input(
        [&] { return splines::extract_isosurface(spline, *o.isovalue, o.max_depth); });
  });
  Json undecided = Json::array();
  for (const auto& place : surface.undecided) undecided.push_back(place);
  run.report()["isosurface"] = {{"vertices", surface.points.size()},
                                {"triangles", surface.triangles.size()},
                                {"euler_characteristic", surface.euler_characteristic},
                                {"components", surface.components},
                                {"boundary_loops", surface.boundary_loops},
                                {"undecided_cells", undecided},
                                {"depth", surface.depth},
                                {"coincident", surface.coincident},
                                {"exact_corners", surface.exact_corners}};
  lines += fmt::format(
      "isosurface: {} triangles, {} components, Euler characteristic {}, {} boundary loops\n",
      surface.triangles.size(), surface.components, surface.euler_characteristic,
      surface.boundary_loops);
  if (surface.coincident > 0)
    run.warn(
        fmt::format("{} vertices of the mesh coincide with others, {} corners of tetrahedra lie "
                    "on the isosurface: shift --isovalue by 0.3141593 of the data's step, say",
                    surface.coincident, surface.exact_corners));
  const bool proven = surface.undecided.empty();
  std::string digest;
  if (!proven) {
    const auto& p = surface.undecided.front();
    run.warn(
        fmt::format("{} tetrahedra are undecided at depth {}, the first at {:.6g} {:.6g} {:.6g}: "
                    "the isosurface touches a face or has no gradient there; no certificate; "
                    "take another --isovalue close by{}",
                    surface.undecided.size(), surface.depth, p[0], p[1], p[2],
                    o.max_depth < 54 ? ", or --max-depth 54" : ""));
  } else if (run.wanted("--certificate")) {
    run.step("certificate", "certifying", [&] {
      const auto bytes =
          certify::encode(splines::isosurface_certificate(spline, *o.isovalue, surface));
      run.write_certificate("spline-isosurface", bytes);
      digest = certify::hex(certify::data_digest(bytes));
    });
  }
  run.step("write", "writing the isosurface", [&] {
    run.write("--mesh",
              [&](const std::string& path) { io::write_isosurface(path, surface, digest); });
  });
  run.show_page([&] {
    io::Scene scene = io::isosurface_scene(surface, run.viewpoint());
    scene.data_digest = digest;
    return scene;
  });
  return proven;
}

}  // namespace

Outcome run_volume(Run& run, const SplineOptions& o) {
  check(o);
  const QuadraticSpline spline = read_spline(run, o);
  const auto summary =
      run.step("coefficients", "bounding coefficients", [&] { return splines::summarise(spline); });
  Report& report = run.report();
  const auto& n = spline.cubes();
  for (const double x : {summary.low, summary.high, summary.gradient_jump})
    if (!std::isfinite(x))
      throw kernel::InputError(
          "samples: coefficients of the spline are beyond doubles; divide the samples by a number");
  report["spline"] = "quadratic";
  report["cubes"] = n;
  report["coefficients"] = spline.grid().count();
  report["range"] = std::array{summary.low, summary.high};
  report["gradient_jump"] = {{"max", summary.gradient_jump}, {"where", summary.where}};
  evaluate_points(run, o,
                  [&](std::span<const kernel::Vec3> points) { return spline.evaluate(points); });
  std::string lines =
      fmt::format("quadratic spline of {} x {} x {} cubes, coefficients {:.6g} to {:.6g}\n", n[0],
                  n[1], n[2], summary.low, summary.high);
  lines += cast_rays(run, o, spline);
  const bool proven = make_mesh(run, o, spline, lines);
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) { io::write_quadratic_model(path, spline); });
  });
  return {lines, {"roessl2005surfaces"}, proven ? kDone : kNotCertified};
}

}  // namespace crest::cli
