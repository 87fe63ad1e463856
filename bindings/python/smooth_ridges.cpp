// SPDX-License-Identifier: GPL-3.0-or-later
// crest ridges of a smooth surface.
#include "algorithms/smooth_ridges/smooth_ridges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "algorithms/smooth_ridges/surface.hpp"
#include "bindings/python/systems.hpp"
#include "certify/ridges_smooth/encode.hpp"
#include "io/ridges/smooth_ridge_picture.hpp"
#include "io/ridges/smooth_ridge_writer.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::python {
namespace {

using smooth_ridges::Surface;

Surface surface_of(const Arguments& a) {
  const bool implicit = a.has("surface");
  try {
    if (implicit) {
      Surface::Box box{};
      std::copy_n(a.numbers("box").begin(), box.size(), box.begin());
      return Surface::implicit(a.text("surface"), box);
    }
    std::array<std::string, 3> coordinates;
    std::array<std::string, 4> domain;
    std::copy_n(a.texts("param").begin(), 3, coordinates.begin());
    std::copy_n(a.texts("domain").begin(), 4, domain.begin());
    const std::string& periodic = a.text("periodic");
    const auto has = [&](char c) { return periodic.find(c) != std::string::npos; };
    return Surface::parametric(coordinates, domain, {has('u'), has('v')});
  } catch (const kernel::ExpressionError& error) {
    throw kernel::InputError((implicit ? "surface: " : "param: ") + std::string(error.what()));
  } catch (const std::invalid_argument& error) {
    throw kernel::InputError((implicit ? "surface: " : "param: ") + std::string(error.what()));
  }
}

}  // namespace

Output run_smooth_ridges(const Arguments& a, const Progress& progress) {
  const Surface surface = surface_of(a);
  smooth_ridges::Options options;
  if (a.has("start_faces")) options.start_faces = a.integer("start_faces");
  options.refinement.max_depth = a.integer("max_depth");
  options.refinement.max_faces = static_cast<std::size_t>(a.integer("budget"));
  options.refinement.progress = [&](int round, std::size_t faces, std::size_t left) {
    progress.show(fmt::format("round {}: {} faces, {} undecided", round, faces, left));
  };
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = a.maybe_number("seconds");
  options.stop = [&] {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    return progress.stopped() || (seconds && spent.count() >= *seconds);
  };
  const auto result =
      progress.step(surface.is_implicit() ? "searching the box" : "placing the first triangles",
                    [&] { return smooth_ridges::smooth_ridges(surface, options); });
  Output out;
  std::string digest;
  if (result.certified) digest = out.certify(certify::encode(result.certificate));
  out.geometries["geometry"] = io::geometry_of(io::smooth_ridge_poly_data(result, digest));
  out.geometries["mesh"] = io::geometry_of(io::smooth_mesh_poly_data(result, digest));
  if (a.has("picture")) {
    io::PictureOptions picture;
    picture.view = viewpoint_of(a).view;
    picture.up = viewpoint_of(a).up;
    io::write_smooth_picture(a.text("picture"), result, picture);
  }
  std::vector<std::string> reasons = result.obstacles;
  for (const auto& cell : result.undecided) reasons.push_back(cell.reason);
  out.values["certified"] = result.certified;
  out.values["stopped"] = result.stopped;
  out.values["obstacles"] = std::move(reasons);
  out.values["undecided"] = static_cast<std::int64_t>(result.undecided.size());
  out.values["euler_characteristic"] = std::int64_t{result.euler_characteristic};
  out.values["components"] = static_cast<std::int64_t>(result.components);
  out.values["boundary_loops"] = static_cast<std::int64_t>(result.boundary_loops);
  out.values["data_digest"] = digest;
  return out;
}

}  // namespace crest::python
