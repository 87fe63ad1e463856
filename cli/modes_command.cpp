// SPDX-License-Identifier: GPL-3.0-or-later
// crest modes: mode and neutral surfaces of symmetric tensor fields (paper 004).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <stdexcept>

#include "algorithms/modes/certificate.hpp"
#include "algorithms/modes/curves_certificate.hpp"
#include "algorithms/modes/degenerate_curves.hpp"
#include "algorithms/modes/level_text.hpp"
#include "algorithms/modes/surface_geometry.hpp"
#include "certify/certificate.hpp"
#include "certify/modes_curves/encode.hpp"
#include "certify/verify.hpp"
#include "cli/mesh_workers.hpp"
#include "cli/modes_curves_report.hpp"
#include "cli/modes_report.hpp"
#include "cli/run.hpp"
#include "io/formats/files.hpp"
#include "io/modes/domain_outline.hpp"
#include "io/modes/mode_writer.hpp"
#include "io/page/scene.hpp"
#include "io/read/tet_reader.hpp"

namespace crest::cli {
namespace {

struct ModesOptions {
  CommonOptions common;
  io::TensorRequest tensor;
  std::vector<std::string> modes;
  bool neutral = false, degenerate = false, keep_sign = false;
  modes::ModeOptions extraction;
  double min_magnitude = 0, deviation = 0;
};

/// A level and, with --signed, the sign that is kept.
struct Wanted {
  modes::Level level;
  int sign = 0;
  friend bool operator==(const Wanted& a, const Wanted& b) {
    return a.level.p == b.level.p && a.level.q == b.level.q && a.sign == b.sign;
  }
};

Wanted parse_mode(const std::string& text, bool keep_sign) {
  try {
    const modes::SignedLevel parsed = modes::parse_level(text);
    return {parsed.level, keep_sign ? parsed.sign : 0};
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--mode ") + error.what());
  }
}

std::vector<Wanted> parse_modes(const ModesOptions& o) {
  std::vector<Wanted> wanted;
  for (const std::string& text : o.modes) wanted.push_back(parse_mode(text, o.keep_sign));
  if (o.neutral) wanted.push_back({{0, 1}, 0});
  if (wanted.empty() && !o.degenerate)
    throw UsageError("give --mode MU, --neutral or --degenerate");
  std::vector<Wanted> different;
  for (const Wanted& w : wanted)
    if (std::find(different.begin(), different.end(), w) == different.end()) different.push_back(w);
  return different;
}

io::TensorFile read_input(Run& run, const ModesOptions& o) {
  io::TensorRequest request = o.tensor;
  request.step = o.common.step;
  auto file = run.step("read", "reading " + o.common.input,
                       [&] { return io::read_tensors(o.common.input, request); });
  for (const std::string& warning : file.warnings) run.warn(warning);
  if (file.max_asymmetry > 0)
    run.warn(fmt::format("'{}' is not symmetric (by up to {:.3g}): its symmetric part is taken",
                         file.field, file.max_asymmetry));
  return file;
}

/// Writes claim 7 if its checker accepts it: where it finds a place special that the extraction
/// decided, nothing is stated. Returns whether it did.
bool certify_curves(Run& run, const modes::ModeField& field, const modes::DegenerateCurves& curves,
                    io::ModeScene& scene) {
  return run.step("certificate", "writing the certificate", [&] {
    const auto bytes = certify::encode(
        modes::curves_certificate(field.mesh.points(), field.mesh.tets(), field.tensors, curves));
    const certify::Verdict verdict = certify::verify(bytes);
    if (!verdict.accepted) {
      run.warn("no certificate of the curves, its checker does not accept it: " + verdict.reason);
      return false;
    }
    scene.data_digest = certify::hex(certify::data_digest(bytes));
    run.write_certificate("modes-curves", bytes, curves.undecided.size());
    return true;
  });
}

/// Degenerate curves into the scene, the report and the summary. Returns whether all are decided,
/// and proven if `certify`.
bool add_curves(Run& run, const modes::ModeField& field, const io::TensorFile& file, bool certify,
                io::ModeScene& scene, std::string& summary) {
  const modes::DegenerateCurves curves = run.step("curves", "degenerate curves", [&] {
    return modes::degenerate_curves(field.mesh.points(), field.mesh.tets(), field.tensors,
                                    mesh_workers().faces);
  });
  run.report()["degenerate_curves"] = curves_to_json(curves, file.cell_of);
  if (const std::string warning = curves_warning(curves); !warning.empty()) run.warn(warning);
  summary += curves_summary(curves);
  scene.curves = curves.curves;
  const bool certified = !certify || certify_curves(run, field, curves, scene);
  return certified && curves.undecided.empty();
}

/// The files of the surfaces and curves.
void write_files(Run& run, const ModesOptions& o, const modes::ModeField& field,
                 io::ModeScene& scene) {
  if (run.wanted("-o") && io::lower_extension(o.common.output).ends_with("vtp"))
    run.step("geometry", "curvatures", [&] {
      for (auto& s : scene.surfaces) modes::add_geometry(field, s);
    });
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) { io::write_modes(path, scene); });
    const bool empty = std::all_of(scene.surfaces.begin(), scene.surfaces.end(),
                                   [](const auto& s) { return s.triangles.empty(); }) &&
                       scene.curves.empty();
    if (run.wanted("--picture") && empty)
      throw kernel::InputError(o.common.input +
                               ": surfaces: there are none; choose another mode for --picture");
    run.write("--picture", [&](const std::string& path) {
      io::write_mode_picture(path, scene, run.viewpoint());
    });
    run.show_page([&] { return io::mode_page_scene(scene, run.viewpoint()); });
  });
}

Outcome work(Run& run, const ModesOptions& o) {
  const auto wanted = parse_modes(o);
  io::TensorFile file = read_input(run, o);
  modes::ModeField field{std::move(file.mesh), std::move(file.tensors)};
  io::ModeScene scene;
  if (run.wanted("--picture") || run.wanted("--page"))
    scene.outline = io::domain_outline(field.mesh);
  std::string summary;
  const bool of_curves = wanted.empty() && run.wanted("--certificate");
  const bool curves_decided =
      !o.degenerate || add_curves(run, field, file, of_curves, scene, summary);
  const modes::ZeroSet zeros =
      run.step("zeros", "looking for zeros", [&] { return modes::insert_zeros(field); });
  scene.min_magnitude = o.min_magnitude;
  modes::ModeOptions extraction = o.extraction;
  extraction.deviation = o.deviation * modes::diagonal(field);
  ModesReport report(run.report(), field, file, zeros);
  std::vector<certify::ModeLevel> records;
  for (const Wanted& w : wanted) {
    certify::ModeLevel record;
    auto result = run.step("extract", fmt::format("mode {}", w.level.value()), [&] {
      const modes::Workers* workers = mesh_workers().modes;
      return run.with_input([&] {
        return run.wanted("--certificate")
                   ? modes::extract(field, w.level, extraction, record, workers)
                   : modes::extract(field, w.level, extraction, workers);
      });
    });
    const bool known = std::any_of(records.begin(), records.end(), [&](const auto& r) {
      return r.numerator == record.numerator && r.denominator == record.denominator;
    });
    if (!known) records.push_back(std::move(record));
    if (w.sign != 0)
      std::erase_if(result.surfaces, [&](const auto& s) { return s.sign != w.sign; });
    report.add(result);
    std::move(result.surfaces.begin(), result.surfaces.end(), std::back_inserter(scene.surfaces));
  }
  report.finish();
  summary = report.summary() + summary;
  for (const std::string& warning : report.warnings()) run.warn(warning);
  if (o.min_magnitude > 0)
    run.warn(
        "--min-magnitude leaves triangles out of the file only: counts and certificate are "
        "those of the whole field");
  if (run.wanted("--certificate") && !of_curves) {
    if (o.degenerate)
      run.warn("the certificate is about the surfaces; that of the curves: --degenerate alone");
    run.step("certificate", "writing the certificate", [&] {
      const auto bytes = certify::encode(modes::make_certificate(field, zeros, std::move(records)));
      if (run.wanted("-o") || run.wanted("--page") || run.wanted("--picture"))
        scene.data_digest = certify::hex(certify::data_digest(bytes));
      run.write_certificate("modes", bytes, report.undecided());
    });
  }
  write_files(run, o, field, scene);
  return {summary,
          {"qu2020mode"},
          report.exhausted()                          ? kExhausted
          : report.undecided() > 0 || !curves_decided ? kNotCertified
                                                      : kDone};
}

std::function<int()> add_modes(CLI::App& app) {
  auto options = std::make_shared<ModesOptions>();
  ModesOptions& o = *options;
  add_common_options(app, o.common,
                     "solids with a tensor at each point (.vtu .pvtu .vtk .msh .frd .mesh .nrrd)",
                     "surfaces (.vtp .pvtp .ply .obj)");
  app.add_option("--tensor", o.tensor.field, "the array (default: the only one of 6 or 9 numbers)")
      ->type_name("NAME");
  app.add_option("--order", o.tensor.order,
                 "of 6 numbers (default: the format's, xx,yy,zz,xy,yz,xz in VTK's)")
      ->type_name("WORDS");
  add_step_option(app, o.common);
  app.add_option("--mode", o.modes, "levels: decimals or fractions p/q; each gives +MU and -MU")
      ->delimiter(',')
      ->type_name("MU");
  app.add_flag("--neutral", o.neutral, "the neutral surface, mode 0");
  app.add_flag("--degenerate", o.degenerate,
               "the degenerate curves, mode 1 (linear) and -1 (planar)");
  app.add_flag("--signed", o.keep_sign, "of each MU the level of its sign alone");
  app.add_option("--max-depth", o.extraction.max_depth, "bisections of a tetrahedron (default: 40)")
      ->check(CLI::Range(0, 200))
      ->type_name("N");
  app.add_option("--budget", o.extraction.budget, "tests a tetrahedron (default: 100000)")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40))
      ->type_name("N");
  app.add_option("--deviation", o.deviation,
                 "refine triangles until they are this near to the surface, of the box's diagonal")
      ->check(finite_number(0))
      ->type_name("D");
  app.add_option("--min-magnitude", o.min_magnitude,
                 "leave triangles with a smaller |T| out of the file")
      ->check(finite_number(0))
      ->type_name("M");
  return [options] {
    return run_command({"modes", options->common, {".vtp", ".pvtp", ".ply", ".obj"}},
                       [&](Run& run) { return work(run, *options); });
  };
}

}  // namespace

extern const Command modes_command;
const Command modes_command = {
    "modes",
    "mode and neutral surfaces of a symmetric tensor field on tetrahedra",
    add_modes,
    {"crest modes stress.vtu --tensor stress --mode 0.5 -o modes.vtp --report report.json",
     "crest modes stress.vtu --neutral --certificate neutral.crest",
     "crest modes stress.vtu --degenerate -o curves.vtp --certificate curves.crest"}};

}  // namespace crest::cli
