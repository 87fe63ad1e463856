// SPDX-License-Identifier: GPL-3.0-or-later
// crest extremal: extremal curves and surfaces of images, volumes and points (paper 000).
#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "algorithms/extremal/extremal.hpp"
#include "algorithms/extremal/sampled_grid.hpp"
#include "certify/certificate.hpp"
#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "cli/extremal_report.hpp"
#include "cli/piece_work.hpp"
#include "cli/run.hpp"
#include "cli/volume_source.hpp"
#include "io/extremal/extremal_picture.hpp"
#include "io/extremal/extremal_writer.hpp"
#include "io/page/scene.hpp"
#include "io/read/point_reader.hpp"
#include "io/read/volume_reader.hpp"

namespace crest::cli {
namespace {

using certify::ExtremalCertificate;

struct ExtremalOptions {
  CommonOptions common;
  io::VolumeSource source;
  bool ridge = false, valley = false, surface = false;
  std::string definition;
  std::optional<double> sigma, tensor_sigma, min_value, min_strength;
  bool critical = false;
  std::optional<int> refine;
  std::optional<double> radius;
  std::optional<int> depth;
  kernel::Index blocks = 0;
  std::string restart;
};

void check(const ExtremalOptions& o) {
  if (o.ridge + o.valley + o.surface != 1)
    throw UsageError(
        "give one of --ridge, --valley (of a volume or an image), --surface (of points)");
  const bool volume = o.sigma || o.tensor_sigma || o.min_value || o.min_strength || o.refine ||
                      !o.definition.empty() || !o.source.raw.empty() || !o.source.field.empty() ||
                      o.blocks > 0 || !o.restart.empty();
  if (o.surface && volume)
    throw UsageError(
        "--surface takes --radius, --depth and --critical; the other options are for volumes");
  if (!o.surface && (o.radius || o.depth))
    throw UsageError("--radius and --depth are for points (--surface)");
}

io::VolumeFile read_volume(Run& run, const ExtremalOptions& o) {
  auto file = run.step("read", "reading " + o.common.input,
                       [&] { return io::read_volume(o.common.input, o.source); });
  for (const std::string& warning : file.warnings) run.warn(warning);
  return file;
}

/// What the allocator keeps of what was freed goes back to the system, where it can.
void release_memory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

/// Writes claim 8 if its checker accepts it: what is proven with no margin here may be refused
/// there. Returns the digest of its data; empty: none was written.
std::string certify_result(Run& run, std::optional<ExtremalCertificate>& certificate,
                           std::size_t undecided) {
  return run.step("certificate", "writing the certificate", [&]() -> std::string {
    const auto bytes = certify::encode(*certificate);
    certificate.reset();
    release_memory();  // the checker takes as much as the extraction did
    const certify::Verdict verdict = certify::verify(bytes);
    if (!verdict.accepted) {
      run.warn("no certificate, its checker does not accept it: " + verdict.reason);
      return {};
    }
    run.write_certificate("extremal", bytes, undecided);
    return certify::hex(certify::data_digest(bytes));
  });
}

Outcome finish(Run& run, const ExtremalOptions& o, const extremal::Result& result,
               const std::string& digest, const kernel::SampledGrid* image) {
  for (const std::string& warning : extremal_warnings(result)) run.warn(warning);
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) { io::write_extremal(path, result, digest); });
    if (run.wanted("--picture") && !image && result.polygons() == 0)
      throw kernel::InputError(o.common.input +
                               ": surface: there is none; choose other thresholds for --picture");
    run.write("--picture", [&](const std::string& path) {
      if (image)
        io::write_extremal_picture(path, result, *image);
      else
        io::write_extremal_picture(path, result, run.viewpoint());
    });
    run.show_page([&] {
      io::Scene scene = io::extremal_scene(result, image, run.viewpoint());
      scene.data_digest = digest;
      return scene;
    });
  });
  fill_report(run.report(), result);  // last: a long report takes as much as the mesh
  const bool certified =
      !run.wanted("--certificate") || (!digest.empty() && result.undecided.empty());
  return {extremal_summary(result), {"li2010extremal"}, certified ? kDone : kNotCertified};
}

extremal::Options options_of(const ExtremalOptions& o) {
  extremal::Options options;
  options.definition =
      o.definition == "hessian" ? extremal::Definition::hessian : extremal::Definition::structure;
  options.side = o.valley ? extremal::Side::valley : extremal::Side::ridge;
  options.sigma = o.sigma.value_or(1);
  options.tensor_sigma = o.tensor_sigma;
  options.min_value = o.min_value;
  options.min_strength = o.min_strength.value_or(0);
  options.critical = o.critical;
  options.refine = o.refine.value_or(0);
  return options;
}

/// Piece by piece: of volumes alone.
Outcome of_pieces(Run& run, const ExtremalOptions& o) {
  const io::VolumeBoxes boxes = run.step("read", "reading " + o.common.input,
                                         [&] { return io::VolumeBoxes(o.common.input, o.source); });
  for (const std::string& warning : boxes.warnings()) run.warn(warning);
  PieceJob job{o.common.input, o.source, frame_of(boxes.frame()), options_of(o), {}, {}, o.restart};
  const bool certified = run.wanted("--certificate");
  job.meshes = {!job.options.critical || certified, job.options.critical};
  const auto blocks = std::max(o.blocks, static_cast<kernel::Index>(piece_engine().least_pieces));
  job.owned = kernel::cut_grid(job.frame.size, kernel::parts_of(job.frame.size, blocks));
  run.report()["definition"] = o.definition.empty() ? "structure" : o.definition;
  run.report()["sigma"] = job.options.sigma;
  run.report()["blocks"] = job.owned.size();
  std::optional<ExtremalCertificate> certificate;
  if (certified) certificate.emplace();
  extremal::Result result =
      run.step("extract", fmt::format("extremal surface, {} blocks", job.owned.size()),
               [&] { return extract_pieces(job, boxes, certificate ? &*certificate : nullptr); });
  move_to_world(boxes.frame(), result);
  std::string digest;
  if (certificate) digest = certify_result(run, certificate, result.undecided.size());
  return finish(run, o, result, digest, nullptr);
}

Outcome of_volume(Run& run, const ExtremalOptions& o) {
  io::VolumeFile file = read_volume(run, o);
  const kernel::SampledGrid& grid = file.grid;
  const extremal::Options options = options_of(o);
  run.report()["definition"] = o.definition.empty() ? "structure" : o.definition;
  run.report()["sigma"] = options.sigma;
  std::optional<ExtremalCertificate> certificate;
  if (run.wanted("--certificate")) certificate.emplace();
  extremal::Result result = run.step("extract", "extremal surface", [&] {
    return run.with_input([&] {
      extremal::Volume volume = extremal::volume_of(grid);
      if (grid.dimension() == 3) file.grid.samples = {};
      return extremal::extract(std::move(volume), options, certificate ? &*certificate : nullptr);
    });
  });
  extremal::move_to_world(grid, result);
  std::string digest;
  if (certificate) digest = certify_result(run, certificate, result.undecided.size());
  return finish(run, o, result, digest, grid.dimension() == 2 ? &grid : nullptr);
}

Outcome of_points(Run& run, const ExtremalOptions& o) {
  auto file = run.step("read", "reading " + o.common.input,
                       [&] { return io::read_points(o.common.input); });
  for (const std::string& warning : file.warnings) run.warn(warning);
  const extremal::OrientedPoints points{std::move(file.points), std::move(file.normals)};
  const extremal::PointOptions options{o.radius, o.depth.value_or(10), o.critical};
  run.report()["points"] = points.points.size();
  if (run.wanted("--certificate"))
    run.warn("no certificate: the claim is about volumes and images, not about points");
  const extremal::Result result = run.step("extract", "surface of the points", [&] {
    return run.with_input([&] { return extremal::extract(points, options); });
  });
  return finish(run, o, result, "", nullptr);
}

Outcome work(Run& run, const ExtremalOptions& o) {
  check(o);
  if (o.surface) return of_points(run, o);
  const bool pieces = o.blocks > 0 || piece_engine().least_pieces > 1 || !o.restart.empty();
  return pieces ? of_pieces(run, o) : of_volume(run, o);
}

void add_volume_options(CLI::App& app, ExtremalOptions& o) {
  constexpr const char* group = "Volumes and images";
  app.add_flag("--ridge", o.ridge, "where the value is largest along n")->group(group);
  app.add_flag("--valley", o.valley, "where it is least")->group(group);
  app.add_option("--definition", o.definition,
                 "n: the dominant eigenvector of the structure tensor (default) or of the Hessian")
      ->check(CLI::IsMember({"structure", "hessian"}))
      ->type_name("WORD")
      ->group(group);
  app.add_option("--sigma", o.sigma,
                 "smoothing of the values, in smallest spacings (default 1); sheets closer than "
                 "about 3 become one")
      ->check(finite_number(0))
      ->type_name("S")
      ->group(group);
  app.add_option("--tensor-sigma", o.tensor_sigma, "of the structure tensor (default: --sigma)")
      ->check(finite_number(0))
      ->type_name("S")
      ->group(group);
  const auto any = finite_number(-HUGE_VAL);
  app.add_option("--min-value", o.min_value, "keep what has a smoothed value of L at least")
      ->check(any)
      ->type_name("L")
      ->group(group);
  app.add_option("--min-strength", o.min_strength,
                 "keep what has a second derivative along n of K at least (default 0)")
      ->check(finite_number(0))
      ->type_name("K")
      ->group(group);
  app.add_option("--refine", o.refine,
                 "halve the grid D times (default 0): the same field, of which more is proven")
      ->check(CLI::Range(0, extremal::kMostRefined))
      ->type_name("D")
      ->group(group);
  app.add_option("--blocks", o.blocks,
                 "work on the volume in so many blocks, one in memory at a time: the same bytes")
      ->check(CLI::Range(1, 1 << 20))
      ->type_name("N")
      ->group(group);
  app.add_option("--restart", o.restart,
                 "keep finished blocks in FOLDER, and go on from those that are there")
      ->type_name("FOLDER")
      ->group(group);
  add_volume_source(app, o.source, group);
}

void add_point_options(CLI::App& app, ExtremalOptions& o) {
  constexpr const char* group = "Points";
  app.add_flag("--surface", o.surface, "the surface of points whose normals may have any sign")
      ->group(group);
  app.add_option("--radius", o.radius,
                 "H of the weights, which vanish at 2 H (default: the median distance to the 10th "
                 "neighbour); below half the distance of two sheets, above what holds 15 evenly or "
                 "40 randomly spread neighbours within 2 H")
      ->check(finite_number(0))
      ->type_name("H")
      ->group(group);
  app.add_option("--depth", o.depth, "of the octree (default 10)")
      ->check(CLI::Range(1, 16))
      ->type_name("D")
      ->group(group);
}

std::function<int()> add_extremal(CLI::App& app) {
  auto options = std::make_shared<ExtremalOptions>();
  ExtremalOptions& o = *options;
  add_common_options(app, o.common,
                     "a volume or an image (.nrrd .mha .mhd .vti .pvti .vtk .nii .nii.gz .mrc .map "
                     ".cube .inr .png "
                     ".pgm), or points with normals (.xyz .pwn .ply .obj .off)",
                     "the surface or the curves (.vtp .pvtp .obj .ply)");
  app.add_flag("--critical", o.critical, "keep the merely critical part, too");
  add_volume_options(app, o);
  add_point_options(app, o);
  return [options] {
    return run_command({"extremal", options->common, {".vtp", ".pvtp", ".obj", ".ply"}},
                       [&](Run& run) { return work(run, *options); });
  };
}

}  // namespace

extern const Command extremal_command;
const Command extremal_command = {
    "extremal",
    "ridge and valley surfaces of volumes, curves of images, surfaces of points",
    add_extremal,
    {"crest extremal moebius.nrrd --ridge --min-value 0.4 -o sheet.vtp --certificate sheet.crest",
     "crest extremal strip.xyz --surface --radius 0.15 --depth 6 -o strip.vtp --picture "
     "strip.png"}};

}  // namespace crest::cli
