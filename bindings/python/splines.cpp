// SPDX-License-Identifier: GPL-3.0-or-later
// crest spline.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algorithms/splines/cubic_certificate.hpp"
#include "algorithms/splines/cubic_evaluate.hpp"
#include "algorithms/splines/cubic_fit.hpp"
#include "algorithms/splines/quadratic_certificate.hpp"
#include "bindings/python/systems.hpp"
#include "bindings/python/volume.hpp"
#include "certify/spline_cubic/encode.hpp"
#include "certify/verify.hpp"
#include "io/splines/isosurface_writer.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::python {
namespace {

using splines::Hit;
using splines::QuadraticSpline;
using splines::Ray;

void add_values(const std::vector<splines::ValueAndGradient>& values, Output& out) {
  std::vector<double> value;
  std::vector<kernel::Vec3> gradient;
  for (const auto& v : values) {
    value.push_back(v.value);
    gradient.push_back(v.gradient);
  }
  out.values["values"] = array_of(std::move(value));
  out.values["gradients"] = array_of(gradient);
}

std::vector<Ray> rays_of(const Arguments& a) {
  std::vector<Ray> rays;
  for (const auto& r : a.rows<6>("rays")) rays.push_back({{r[0], r[1], r[2]}, {r[3], r[4], r[5]}});
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (const char* const problem = splines::problem_of(rays[i]))
      throw kernel::InputError(fmt::format("rays[{}]: {}", i, problem));
  return rays;
}

void cast_rays(const Arguments& a, const QuadraticSpline& spline, const Progress& progress,
               Output& out) {
  const std::vector<Ray> rays = rays_of(a);
  const splines::RayCaster caster(spline, a.number("isovalue"));
  std::vector<Hit> hits(rays.size());
  progress.step("casting rays", [&] { caster.cast(rays, hits); });
  std::vector<std::uint8_t> hit;
  std::vector<double> t;
  std::vector<kernel::Vec3> place, gradient;
  std::vector<std::array<double, 2>> bracket;
  for (const Hit& h : hits) {
    hit.push_back(h.hit ? 1 : 0);
    t.push_back(h.hit ? h.t : NAN);
    bracket.push_back(h.hit ? std::array{h.t_lo, h.t_hi} : std::array<double, 2>{NAN, NAN});
    place.push_back(h.hit ? h.place : kernel::Vec3{NAN, NAN, NAN});
    gradient.push_back(h.hit ? h.gradient : kernel::Vec3{NAN, NAN, NAN});
  }
  out.values["hit"] = array_of(std::move(hit));
  out.values["t"] = array_of(std::move(t));
  out.values["t_bracket"] = array_of(bracket);
  out.values["place"] = array_of(place);
  out.values["gradient"] = array_of(gradient);
  if (a.flag("certificate"))
    out.values["data_digest"] = progress.step("composing the certificate", [&] {
      return out.certify(
          certify::encode(splines::rays_certificate(spline, caster.level(), rays, hits)));
    });
}

void make_mesh(const Arguments& a, const QuadraticSpline& spline, const Progress& progress,
               Output& out) {
  const auto surface = progress.step("isosurface", [&] {
    return splines::extract_isosurface(spline, a.number("isovalue"), a.integer("max_depth"));
  });
  std::string digest;
  if (surface.undecided.empty() && a.flag("certificate"))
    digest = progress.step("composing the certificate", [&] {
      return out.certify(
          certify::encode(splines::isosurface_certificate(spline, a.number("isovalue"), surface)));
    });
  out.geometries["geometry"] = io::geometry_of(io::isosurface_poly_data(surface, digest));
  out.values["undecided"] = array_of(surface.undecided);
  out.values["euler_characteristic"] = std::int64_t{surface.euler_characteristic};
  out.values["components"] = static_cast<std::int64_t>(surface.components);
  out.values["boundary_loops"] = static_cast<std::int64_t>(surface.boundary_loops);
  out.values["data_digest"] = digest;
}

splines::CubicOptions cubic_options(const Arguments& a) {
  splines::CubicOptions options;
  const std::string& smoothness = a.text("smoothness");
  options.smoothness = smoothness == "local"        ? splines::Smoothness::local
                       : smoothness == "sequential" ? splines::Smoothness::sequential
                                                    : splines::Smoothness::c1;
  if (a.has("n")) {
    std::array<kernel::Index, 3> cubes{};
    for (std::size_t k = 0; k < 3; ++k) cubes[k] = static_cast<kernel::Index>(a.numbers("n")[k]);
    options.cubes = cubes;
  }
  if (a.has("box")) {
    const auto& b = a.numbers("box");
    options.box = {kernel::Vec3{b[0], b[2], b[4]}, kernel::Vec3{b[1], b[3], b[5]}};
  }
  return options;
}

}  // namespace

/// Values at points, what rays hit, or the mesh of an isosurface: as `what` says.
Output run_spline_volume(const Arguments& a, const Progress& progress) {
  const QuadraticSpline spline(
      grid_of(a), a.text("border") == "extend" ? splines::Border::extend : splines::Border::none);
  Output out;
  const auto summary =
      progress.step("bounding coefficients", [&] { return splines::summarise(spline); });
  out.values["range"] = std::vector<double>{summary.low, summary.high};
  out.values["gradient_jump"] = summary.gradient_jump;
  if (a.text("what") == "values")
    add_values(progress.step("evaluating", [&] { return spline.evaluate(a.rows<3>("points")); }),
               out);
  else if (a.text("what") == "rays")
    cast_rays(a, spline, progress, out);
  else
    make_mesh(a, spline, progress, out);
  return out;
}

Output run_spline_samples(const Arguments& a, const Progress& progress) {
  const auto points = a.rows<3>("points");
  const auto& values = std::get<std::vector<double>>(a.array("values").data);
  const splines::CubicFit fit = progress.step(
      "fitting", [&] { return splines::fit_cubic(points, values, cubic_options(a)); });
  const auto error = progress.step("errors at the samples", [&] {
    return splines::error_at_samples(fit.model, points, values);
  });
  Output out;
  out.warnings = fit.warnings;
  if (fit.outside > 0)
    out.warnings.push_back(fmt::format("{} samples outside of the box are left out", fit.outside));
  if (a.flag("certificate"))
    out.values["data_digest"] = progress.step("composing the certificate", [&] {
      auto bytes =
          certify::encode(splines::cubic_certificate(fit.model, points, values, error.max));
      if (const certify::Verdict verdict = certify::verify(bytes); !verdict.accepted)
        throw std::runtime_error("the certificate's checker refuses it: " + verdict.reason);
      return out.certify(std::move(bytes));
    });
  if (a.has("evaluate"))
    add_values(progress.step("evaluating",
                             [&] { return splines::evaluate(fit.model, a.rows<3>("evaluate")); }),
               out);
  std::vector<double> cubes(fit.model.domain.cubes.begin(), fit.model.domain.cubes.end());
  const auto [low, high] = splines::coefficient_range(fit.model);
  out.values["cubes"] = std::move(cubes);
  out.values["range"] = std::vector<double>{low, high};
  out.values["gradient_jump"] = splines::gradient_jump(fit.model).bound;
  out.values["error_mean"] = error.mean;
  out.values["error_max"] = error.max;
  return out;
}

}  // namespace crest::python
