// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/smooth_ridges_run.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <chrono>
#include <stdexcept>
#include <vector>

#include "algorithms/smooth_ridges/surface.hpp"
#include "certify/ridges_smooth/encode.hpp"
#include "cli/interrupt.hpp"
#include "cli/run.hpp"
#include "cli/smooth_ridges_report.hpp"
#include "io/page/scene.hpp"
#include "io/ridges/smooth_ridge_picture.hpp"
#include "io/ridges/smooth_ridge_writer.hpp"

namespace crest::cli {
namespace {

using kernel::InputError;
using smooth_ridges::SmoothRidges;
using smooth_ridges::Surface;

/// The parts between separators, without blanks around them.
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    const std::size_t first = text.find_first_not_of(' ', at);
    std::string part;
    if (first < end) part = text.substr(first, text.find_last_not_of(' ', end - 1) + 1 - first);
    parts.push_back(part);
    at = end + 1;
  }
  return parts;
}

double number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end)
    throw InputError("--box: '" + text + "' is not a number");
  return value;
}

Surface::Box box_of(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 2 && parts.size() != 6) {
    throw InputError(fmt::format(
        "--box: {} numbers; give 2 (lower and upper bound of all axes) or 6 (x0,x1,y0,y1,z0,z1)",
        parts.size()));
  }
  Surface::Box box{};
  for (std::size_t i = 0; i < 6; ++i) box[i] = number(parts[parts.size() == 2 ? i % 2 : i]);
  return box;
}

template <std::size_t N>
std::array<std::string, N> parts_of(const std::string& option, const std::string& text,
                                    char separator, const char* shape) {
  const std::vector<std::string> parts = split(text, separator);
  if (parts.size() != N) {
    throw InputError(
        fmt::format("{}: {} expressions; give {}: {}", option, parts.size(), N, shape));
  }
  std::array<std::string, N> result;
  std::copy(parts.begin(), parts.end(), result.begin());
  return result;
}

Surface parse_surface(const SmoothRidgesOptions& o) {
  const char* option = o.implicit ? "--surface: " : "--param: ";
  try {
    if (o.implicit) return Surface::implicit(o.surface, box_of(o.box));
    const auto has = [&](char c) { return o.periodic.find(c) != std::string::npos; };
    return Surface::parametric(parts_of<3>("--param", o.param, ';', "x;y;z in u, v"),
                               parts_of<4>("--domain", o.domain, ',', "u0,u1,v0,v1"),
                               {has('u'), has('v')});
  } catch (const InputError&) {
    throw;
  } catch (const kernel::ExpressionError& error) {
    throw InputError(std::string(option) + error.what());
  } catch (const std::invalid_argument& error) {
    throw InputError(std::string(option) + error.what());
  }
}

SmoothRidges extract(const Surface& surface, const SmoothRidgesOptions& o, const Run& run) {
  smooth_ridges::Options options = o.algorithm;
  options.refinement.progress = [&](int round, std::size_t faces, std::size_t left) {
    run.show(fmt::format("round {}: {} faces, {} undecided", round, grouped(faces), grouped(left)));
  };
  const Interrupt interrupt;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  options.stop = [&] {
    return interrupt.requested() ||
           (o.seconds && std::chrono::duration<double>(Clock::now() - start).count() >= *o.seconds);
  };
  run.show(surface.is_implicit() ? "searching the box" : "placing the first triangles");
  return smooth_ridges::smooth_ridges(surface, options);
}

std::vector<std::string> used_references(bool implicit, bool certificate) {
  std::vector<std::string> keys = {"cazals2004ridges", "cazals2005topologically",
                                   "makino2003taylor", "krawczyk1969newton",
                                   "rivara1984algorithms"};
  if (implicit) keys.push_back("plantinga2004isotopic");
  if (certificate) keys.push_back("mcconnell2011certifying");
  return keys;
}

int exit_code(const SmoothRidges& result) {
  if (result.certified) return kDone;
  return result.stopped || !result.undecided.empty() ? kExhausted : kNotCertified;
}

void write_results(Run& run, const SmoothRidges& result, const std::string& digest) {
  run.write("-o", [&](const std::string& path) { io::write_smooth_ridges(path, result, digest); });
  run.write("--mesh",
            [&](const std::string& path) { io::write_smooth_mesh(path, result, digest); });
  run.write("--picture", [&](const std::string& path) {
    io::PictureOptions picture;
    picture.view = run.viewpoint().view;
    picture.up = run.viewpoint().up;
    io::write_smooth_picture(path, result, picture);
  });
  run.show_page([&] {
    io::PictureOptions picture;
    picture.view = run.viewpoint().view;
    picture.up = run.viewpoint().up;
    io::Scene scene = io::smooth_ridge_scene(result, picture);
    scene.data_digest = digest;
    return scene;
  });
}

Outcome work(Run& run, const SmoothRidgesOptions& o) {
  const Surface surface = parse_surface(o);
  const SmoothRidges result = extract(surface, o, run);
  certify::Bytes bytes;
  std::string digest;
  if (result.certified) {
    bytes = run.step("certificate", "composing the certificate",
                     [&] { return certify::encode(result.certificate); });
    digest = certify::hex(certify::data_digest(bytes));
  }
  run.step("write", "writing", [&] {
    write_results(run, result, digest);
    if (result.certified) run.write_certificate("ridges-smooth", bytes);
  });
  const SmoothRidgesRun all{surface, result, bytes.size(), digest};
  fill_report(run.report(), all);
  return {summary_text(all), used_references(o.implicit, run.wanted("--certificate")),
          exit_code(result)};
}

}  // namespace

void add_smooth_ridges_options(CLI::App& app, SmoothRidgesOptions& o) {
  const auto add = [&](const char* name, auto& value, const char* type, const char* help) {
    return app.add_option(name, value, help)->type_name(type)->group(kSmoothGroup);
  };
  auto* surface = add("--surface", o.surface, "F", "the closed surface F(x, y, z) = 0 in --box");
  auto* box = add("--box", o.box, "B", "bounds lo,hi of all axes, or x0,x1,y0,y1,z0,z1");
  auto* param = add("--param", o.param, "'X;Y;Z'", "the surface (X, Y, Z)(u, v) over --domain");
  auto* domain = add("--domain", o.domain, "D", "u0,u1,v0,v1; constants like 2*pi are allowed");
  surface->needs(box);
  box->needs(surface);
  param->needs(domain);
  domain->needs(param);
  add("--periodic", o.periodic, "u|v|uv", "directions in which --param closes up")
      ->check(CLI::IsMember({"u", "v", "uv"}))
      ->needs(param);
  add("--start-faces", o.algorithm.start_faces, "N",
      "faces of the first triangulation, about (1500; --param: 400)")
      ->check(CLI::Range(8, 10000000));
  add("--max-depth", o.algorithm.refinement.max_depth, "N", "rounds of refinement at most")
      ->check(CLI::Range(0, 1000));
  add("--budget", o.algorithm.refinement.max_faces, "N", "faces at most")
      ->check(CLI::Range(8, 1000000000));
  add("--seconds", o.seconds, "S",
      "stop after so long, as Ctrl-C does: what is proven is written, no certificate, exit 4")
      ->check(CLI::PositiveNumber);
  add("--mesh", o.mesh, "FILE", "the triangulation (.vtp .off .obj .ply)");
}

int run_smooth_ridges(const CommonOptions& common, const SmoothRidgesOptions& options) {
  return run_command({"ridges",
                      common,
                      {".vtp", ".obj", ".ply"},
                      {{"--mesh", options.mesh, {".vtp", ".off", ".obj", ".ply"}}}},
                     [&](Run& run) { return work(run, options); });
}

}  // namespace crest::cli
