// SPDX-License-Identifier: GPL-3.0-or-later
// crest lineart: a pen-and-ink drawing (paper 001, section 3.5).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/line_art/certificate.hpp"
#include "algorithms/line_art/line_art.hpp"
#include "algorithms/line_art/sheets.hpp"
#include "certify/lineart/encode.hpp"
#include "certify/verify.hpp"
#include "cli/lineart_report.hpp"
#include "cli/one_of.hpp"
#include "cli/run.hpp"
#include "io/line_art/buffer_files.hpp"
#include "io/line_art/drawing_writer.hpp"
#include "io/line_art/sidecar.hpp"
#include "io/line_art/view_choice.hpp"
#include "io/page/scene.hpp"
#include "io/read/face_soup_reader.hpp"
#include "io/write/atomic_file.hpp"

namespace crest::cli {
namespace {

using kernel::Vec3;

enum class Style { contours, streamlines, fishbone };

struct LineArtOptions {
  CommonOptions common;
  Style style = Style::fishbone;
  io::ViewChoice view;
  std::string crease = "60";
  double line_width = 0.35;
  line_art::HatchOptions hatch;
  std::string sidecar, save_sidecar, luminance, save_buffers;
};

/// Numbers between commas.
template <std::size_t N>
void add_numbers(CLI::App& app, const char* name, std::optional<std::array<double, N>>& numbers,
                 const char* type, const char* help) {
  const auto take = [name, &numbers](const std::string& text) {
    std::array<double, N> x{};
    const std::vector<std::string> words = CLI::detail::split(text, ',');
    for (std::size_t k = 0; k < N; ++k)
      if (words.size() != N || !CLI::detail::lexical_cast(words[k], x[k]) || !std::isfinite(x[k]))
        throw CLI::ValidationError(name, fmt::format("{} is not {} finite numbers", text, N));
    numbers = x;
  };
  app.add_option_function<std::string>(name, take, help)->type_name(type);
}

std::optional<double> crease_of(const LineArtOptions& o) {
  if (o.crease == "none") return std::nullopt;
  double degrees = 0;
  if (!CLI::detail::lexical_cast(o.crease, degrees) || !(degrees >= 0 && degrees <= 180))
    throw UsageError("--crease: " + o.crease + " is neither none nor degrees from 0 to 180");
  return degrees;
}

/// Reads any faces, or a mesh with its principal directions.
struct Input {
  std::vector<Vec3> points;
  std::vector<kernel::Triangle> faces;
  kernel::TriangleMesh mesh;
  std::vector<line_art::PrincipalFrame> frames;
};

void read_surface(Run& run, Input& input) {
  io::MeshFile file = run.read_mesh();
  input.mesh = std::move(file.mesh);
  input.points = input.mesh.points();
  input.faces = input.mesh.faces();
  const curvature::Result estimate = run.step("curvature", "curvature", [&] {
    return run.with_input([&] { return curvature::estimate(input.mesh, {}); });
  });
  for (kernel::Index v = 0; v < input.mesh.vertex_count(); ++v) {
    const curvature::PointCurvature& c = estimate.vertices[v];
    input.frames.push_back({c.k1, c.k2, c.d1, c.d2, estimate.normals[v]});
  }
}

Input read_input(Run& run, const LineArtOptions& o) {
  Input input;
  if (o.style == Style::contours) {
    io::FaceSoup file = run.read([](const std::string& path) { return io::read_face_soup(path); });
    input.points = std::move(file.points);
    input.faces = std::move(file.faces);
    return input;
  }
  try {
    read_surface(run, input);
  } catch (const kernel::InputError& error) {
    // What --split would mend is no bar to contours.
    const std::string words = error.what();
    if (words.find("--split") == std::string::npos) throw;
    throw kernel::InputError(words + ", or draw the contours alone with --style contours");
  }
  return input;
}

Outcome work(Run& run, const LineArtOptions& o) {
  if (o.style == Style::contours)
    for (const std::string* file : {&o.sidecar, &o.luminance, &o.save_buffers})
      if (!file->empty()) throw UsageError("--style contours takes no files that steer hatches");
  line_art::Drawing drawing;
  const std::optional<double> crease = crease_of(o);
  const Input input = read_input(run, o);
  run.with_input([&] {
    drawing.scene = line_art::weld(input.points, input.faces);
    drawing.view = line_art::make_view(io::view_request(o.view, drawing.scene), drawing.scene);
  });
  drawing.contours = run.step("contours", "contours", [&] {
    return line_art::find_contours(drawing.scene, drawing.view, {crease});
  });
  run.step("strokes", "strokes of contours", [&] {
    drawing.lines =
        line_art::draw_contours(drawing.scene, drawing.view, drawing.contours, {o.line_width});
  });
  if (o.style != Style::contours) {
    run.step("sheets", "faces through one another",
             [&] { drawing.one_sheet = !line_art::meeting_faces(drawing.scene); });
    line_art::HatchOptions hatch = o.hatch;
    hatch.crease = crease;
    if (!o.sidecar.empty()) hatch.steering = io::read_sidecar(o.sidecar, drawing.view);
    hatch.look = [&](line_art::Buffers& buffers) {
      for (const char* file : io::kBufferFiles)
        run.write(std::string("--save-buffers") + file, [&](const std::string& path) {
          io::write_atomically(path, io::buffer_file(file, buffers, drawing.lines.strokes));
        });
      if (!o.luminance.empty()) io::read_luminance(o.luminance, buffers);
    };
    hatch.style = o.style == Style::streamlines ? line_art::HatchStyle::streamlines
                                                : line_art::HatchStyle::fishbone;
    line_art::add_hatches(
        drawing, input.mesh, input.frames, hatch,
        [&](const char* name, const std::function<void()>& part) { run.step(name, name, part); });
  }
  drawing.title = std::filesystem::path(o.common.input).filename().string();
  report_line_art(run.report(), drawing);
  if (run.wanted("--certificate"))
    run.step("certificate", "writing the certificate", [&] {
      const auto bytes = certify::encode(line_art::line_art_record(drawing));
      // The checker shares no code with the drawing: what it refuses is a bug on either side.
      if (const certify::Verdict verdict = certify::verify(bytes); !verdict.accepted)
        throw std::runtime_error("the certificate's checker refuses it: " + verdict.reason);
      run.write_certificate("lineart", bytes);
    });
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) { io::write_drawing(path, drawing); });
    run.write("--save-sidecar", [&](const std::string& path) {
      io::write_atomically(path, io::sidecar_of(drawing));
    });
    run.show_page([&] { return io::drawing_scene(drawing); });
  });
  return {line_art_summary(drawing), {"roessl2005surfaces"}};
}

void add_view(CLI::App& app, LineArtOptions& o) {
  add_numbers(app, "--view", o.view.angles, "AZ,EL", "from where: azimuth, elevation in degrees");
  const auto take_up = [&o](const std::string& text) {
    Vec3 v{};
    const std::vector<std::string> words = CLI::detail::split(text, ',');
    for (std::size_t k = 0; k < 3; ++k)
      if (words.size() != 3 || !CLI::detail::lexical_cast(words[k], v[k]))
        throw CLI::ValidationError("--up", text + " is not three numbers X,Y,Z");
    o.view.up = v;
  };
  app.add_option_function<std::string>("--up", take_up, "what points up in the drawing")
      ->type_name("X,Y,Z");
  add_numbers(app, "--camera", o.view.camera, "EX,EY,EZ,TX,TY,TZ", "eye and target");
  app.add_option("--perspective", o.view.perspective, "seen from a point, the view DEG wide")
      ->check(CLI::Range(1.0, 170.0))
      ->type_name("DEG");
}

void add_hatch(CLI::App& app, line_art::HatchOptions& o) {
  const std::map<std::string, bool> fields = {{"line", false}, {"cross", true}};
  app.add_option("--field", o.cross_field, "line (default) or cross: what is smoothed")
      ->transform(one_of(fields))
      ->type_name("WORD");
  const std::map<std::string, line_art::ToneStyle> tones = {
      {"width", line_art::ToneStyle::width},
      {"bands", line_art::ToneStyle::bands},
      {"length", line_art::ToneStyle::length}};
  app.add_option("--tone", o.tone_style, "width (default), bands or length")
      ->transform(one_of(tones))
      ->type_name("WORD");
  app.add_flag("--cross-hatch", o.cross_hatch, "a second layer where it is darker than cmin");
  app.add_option("--spacing", o.tone.spacing, "of hatches, mm (default: 0.8)")
      ->check(CLI::Range(0.2, 20.0))
      ->type_name("MM");
  app.add_option("--smooth", o.smooth, "length of the field's smoothing, spacings (default: 10)")
      ->check(CLI::Range(0.0, 1000.0))
      ->type_name("L");
  const auto numbers = [&app](const char* name, std::size_t count, const char* type,
                              const char* help,
                              std::function<void(const std::vector<double>&)> take) {
    app.add_option_function<std::string>(
           name,
           [name, count, take](const std::string& text) {
             std::vector<double> x;
             for (const std::string& word : CLI::detail::split(text, ',')) {
               x.push_back(0);
               if (!CLI::detail::lexical_cast(word, x.back()) || !std::isfinite(x.back()))
                 throw CLI::ValidationError(name, word + " is not a finite number");
             }
             if (x.size() != count)
               throw CLI::ValidationError(name, fmt::format("{} is not {} numbers", text, count));
             take(x);
           },
           help)
        ->type_name(type);
  };
  numbers("--light", 3, "X,Y,Z", "where light comes from: right, up, towards the eye",
          [&o](const std::vector<double>& x) {
            o.light.light = {x[0], x[1], x[2]};
          });
  numbers("--tones", 2, "CMIN,CMAX", "darkest and brightest tone of hatches (default: 0.35,0.95)",
          [&o](const std::vector<double>& x) {
            if (!(x[0] >= 0 && x[0] < x[1] && x[1] <= 1))
              throw CLI::ValidationError("--tones", "cmin and cmax ascend within 0 to 1");
            o.tone.darkest = x[0];
            o.tone.brightest = x[1];
          });
}

std::function<int()> add_lineart(CLI::App& app) {
  auto options = std::make_shared<LineArtOptions>();
  LineArtOptions& o = *options;
  app.add_option("INPUT", o.common.input,
                 std::string("a mesh, or any faces with --style contours (") + kMeshFormats + ")")
      ->required();
  app.add_option("-o,--output", o.common.output, "the drawing (.svg .pdf .eps .vtp)")
      ->type_name("FILE");
  app.add_option("--report", o.common.report, "counts and times (.json)")->type_name("FILE");
  app.add_option("--certificate", o.common.certificate, "proof for crest-verify (.crest)")
      ->type_name("FILE");
  add_page_option(app, o.common);
  add_view(app, o);
  add_clean_options(app, o.common.clean, true);
  const std::map<std::string, Style> styles = {{"contours", Style::contours},
                                               {"streamlines", Style::streamlines},
                                               {"fishbone", Style::fishbone}};
  app.add_option("--style", o.style, "contours, streamlines or fishbone (default)")
      ->transform(one_of(styles))
      ->type_name("WORD");
  app.add_option("--crease", o.crease, "draw edges sharper than DEG, or none (default: 60)")
      ->type_name("DEG");
  app.add_option("--width", o.view.width, "of the page, mm (default: 160)")
      ->check(CLI::Range(10.0, 5000.0))
      ->type_name("MM");
  app.add_option("--line-width", o.line_width, "of contours, mm (default: 0.35)")
      ->check(CLI::Range(0.02, 10.0))
      ->type_name("MM");
  add_hatch(app, o.hatch);
  app.add_option("--sidecar", o.sidecar, "steer by a file like that of --save-sidecar (.json)")
      ->type_name("FILE");
  app.add_option("--luminance", o.luminance, "tone to draw (.png), as --save-buffers writes it")
      ->type_name("FILE");
  app.add_option("--save-buffers", o.save_buffers,
                 "luminance, normals, curvature, LIC (.png), all (.vti)")
      ->type_name("PREFIX");
  app.add_option("--save-sidecar", o.save_sidecar, "what makes the drawing again (.json)")
      ->type_name("FILE");
  add_run_options(app, o.common);
  app.add_flag("--cite", o.common.cite, "print the references this run used (BibTeX)");
  return [options] {
    std::vector<OutputFile> files = {{"--save-sidecar", options->save_sidecar, {".json"}}};
    if (!options->save_buffers.empty())
      for (const char* file : io::kBufferFiles)
        files.push_back({std::string("--save-buffers") + file, options->save_buffers + file, {}});
    return run_command({"lineart", options->common, {".svg", ".pdf", ".eps", ".vtp"}, files},
                       [&](Run& run) { return work(run, *options); });
  };
}

}  // namespace

extern const Command lineart_command;
const Command lineart_command = {
    "lineart",
    "a pen-and-ink drawing: exact contours, hatches along principal directions",
    add_lineart,
    {"crest lineart ellipsoid.off -o drawing.svg --certificate drawing.crest",
     "crest lineart blend.obj --style contours --camera 3,2,4,0,0,0 -o contours.pdf"}};

}  // namespace crest::cli
