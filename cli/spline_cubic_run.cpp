// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/spline_cubic_run.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "algorithms/splines/cubic_certificate.hpp"
#include "algorithms/splines/cubic_evaluate.hpp"
#include "algorithms/splines/cubic_fit.hpp"
#include "certify/spline_cubic/encode.hpp"
#include "certify/verify.hpp"
#include "cli/spline_points_run.hpp"
#include "io/formats/files.hpp"
#include "io/splines/cubic_model_file.hpp"
#include "io/splines/table.hpp"

namespace crest::cli {
namespace {

using kernel::Vec3;
using splines::CubicModel;
using splines::Smoothness;

constexpr const char* kSmoothness[] = {"c1", "local", "sequential"};

splines::CubicOptions fit_options(const SplineOptions& o) {
  splines::CubicOptions options;
  options.smoothness = o.smoothness.value_or(Smoothness::c1);
  if (o.cubes.size() == 1) options.cubes = {o.cubes[0], o.cubes[0], o.cubes[0]};
  if (o.cubes.size() == 3) options.cubes = {o.cubes[0], o.cubes[1], o.cubes[2]};
  if (o.box.size() == 2)
    options.box = {Vec3{o.box[0], o.box[0], o.box[0]}, Vec3{o.box[1], o.box[1], o.box[1]}};
  if (o.box.size() == 6)
    options.box = {Vec3{o.box[0], o.box[2], o.box[4]}, Vec3{o.box[1], o.box[3], o.box[5]}};
  return options;
}

void report_model(Run& run, const CubicModel& model) {
  Report& report = run.report();
  report["spline"] = "cubic";
  report["smoothness"] = kSmoothness[static_cast<std::size_t>(model.smoothness)];
  report["cubes"] = model.domain.cubes;
  report["coefficients"] = 10 * model.vertices.size() + 4 * model.centres.size();
  const auto [low, high] = splines::coefficient_range(model);
  report["range"] = std::array{low, high};
  const splines::GradientJump jump = splines::gradient_jump(model);
  report["gradient_jump"]["max"] = jump.bound;
  report["gradient_jump"]["where"] = jump.where;
  if (jump.bound == 0) report["gradient_jump"]["where"] = Json();
}

std::string model_summary(const CubicModel& model) {
  const auto [nx, ny, nz] = model.domain.cubes;
  const double jump = splines::gradient_jump(model).bound;
  return fmt::format(
      "cubic spline: {} x {} x {} cubes, {}\n", nx, ny, nz,
      model.smoothness == Smoothness::c1
          ? std::string("exactly C1")
          : fmt::format("{}, gradients jump by at most {:.3g} inside cubes",
                        kSmoothness[static_cast<std::size_t>(model.smoothness)], jump));
}

void certify_fit(Run& run, const CubicModel& model, std::span<const Vec3> points,
                 std::span<const double> values, double max_error) {
  run.step("certificate", "writing the certificate", [&] {
    const auto bytes =
        certify::encode(splines::cubic_certificate(model, points, values, max_error));
    // The checker shares no code with the fit: what it refuses is a bug on either side.
    if (const certify::Verdict verdict = certify::verify(bytes); !verdict.accepted)
      throw std::runtime_error("the certificate's checker refuses it: " + verdict.reason);
    run.write_certificate("spline-cubic", bytes);
  });
}

Outcome finish(Run& run, const SplineOptions& o, const CubicModel& model, std::string summary) {
  run.step("report", "reporting", [&] { report_model(run, model); });
  evaluate_points(run, o, [&](std::span<const Vec3> p) { return splines::evaluate(model, p); });
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) { io::write_cubic_model(path, model); });
  });
  return {model_summary(model) + std::move(summary), {"roessl2005surfaces"}};
}

Outcome of_table(Run& run, const SplineOptions& o) {
  const auto names =
      o.columns.empty() ? std::vector<std::string>{"x", "y", "z", "value"} : o.columns;
  const io::Table table = run.step("read", "reading " + o.common.input,
                                   [&] { return io::read_table(o.common.input, names); });
  const std::vector<Vec3> points = points_of(table.columns);
  const std::vector<double>& values = table.columns[3];
  const splines::CubicFit fit = run.step("fit", "fitting", [&] {
    return run.with_input([&] { return splines::fit_cubic(points, values, fit_options(o)); });
  });
  for (const std::string& warning : fit.warnings) run.warn(warning);
  if (fit.outside > 0)
    run.warn(fmt::format("{} samples outside of the box are left out", fit.outside));
  const auto error = run.step("errors", "errors at the samples",
                              [&] { return splines::error_at_samples(fit.model, points, values); });
  auto& report = run.report()["fit"];
  report["samples"] = fit.samples;
  report["outside"] = fit.outside;
  report["empty_cubes"] = fit.empty_cubes;
  report["local_fits"] = fit.local_fits;
  report["degrees"] = fit.degrees;
  report["points_per_fit"] = fit.samples_per_fit;
  report["error_mean"] = error.mean;
  report["error_max"] = error.max;
  report["error_bound"] = splines::error_bound(fit.model, error.max);
  const auto& d = fit.degrees;
  const std::string summary = fmt::format(
      "fit: {} samples, {} local fits of degree 0 to 3: {}, {}, {}, {}\n"
      "errors at the samples: mean {:.3g}, max {:.3g}\n",
      fit.samples, fit.local_fits, d[0], d[1], d[2], d[3], error.mean, error.max);
  if (run.wanted("--certificate")) certify_fit(run, fit.model, points, values, error.max);
  return finish(run, o, fit.model, summary);
}

Outcome of_model(Run& run, const SplineOptions& o) {
  if (o.smoothness || !o.cubes.empty() || !o.box.empty() || !o.columns.empty())
    throw UsageError("--smoothness, -n, --box and --columns are for tables: " + o.common.input +
                     " holds a spline");
  const CubicModel model = run.step("read", "reading " + o.common.input,
                                    [&] { return io::read_cubic_model(o.common.input); });
  if (run.wanted("--certificate"))
    run.warn("no certificate: the claim is about a spline and its samples; fit them");
  Outcome outcome = finish(run, o, model, "");
  if (run.wanted("--certificate")) outcome.exit_code = kNotCertified;
  return outcome;
}

}  // namespace

bool is_cubic_input(const std::string& path) {
  const std::string extension = io::lower_extension(path);
  return extension == ".csv" || extension == ".tsv" || extension == ".txt" ||
         io::is_cubic_model(path);
}

Outcome run_cubic(Run& run, const SplineOptions& o) {
  if (o.quadratic) throw UsageError("--quadratic is for volumes");
  if (o.isovalue || !o.rays.empty() || !o.hits.empty() || !o.mesh.empty() || !o.camera.empty() ||
      !o.common.picture.empty() || !o.common.page.empty() || o.extend || !o.source.raw.empty() ||
      !o.source.field.empty())
    throw UsageError(
        "--isovalue, --rays, --hits, --mesh, --picture, --page, --camera, --border, --raw and "
        "--field are for splines of volumes; sample a cubic one by --evaluate");
  return io::is_cubic_model(o.common.input) ? of_model(run, o) : of_table(run, o);
}

}  // namespace crest::cli
