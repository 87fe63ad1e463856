// SPDX-License-Identifier: GPL-3.0-or-later
// crest skeleton: the topological skeleton of a plane vector field (paper 001, chapter 5).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

#include "algorithms/vector_fields/certificate.hpp"
#include "certify/certificate.hpp"
#include "certify/verify.hpp"
#include "cli/run.hpp"
#include "cli/skeleton_report.hpp"
#include "cli/vector_options.hpp"
#include "io/page/scene.hpp"
#include "io/read/planar_field_reader.hpp"
#include "io/vector_fields/skeleton_writer.hpp"
#include "io/write/planar_field_writer.hpp"

namespace crest::cli {
namespace {

struct SkeletonOptions {
  CommonOptions common;
  io::VectorRequest vectors;
  SimplifyOptions simplify;
  std::optional<io::PlaneWindow> close_up;
  std::string paths;
};

/// Weights with the field that they come from.
struct Simplification {
  std::vector<kernel::Vec2> smooth;
  vector_fields::Importance importance;
  vector_fields::Skeleton part;  ///< what is important
};

Simplification simplify(const vector_fields::PlanarField& field,
                        const vector_fields::Skeleton& skeleton, const SimplifyOptions& o) {
  Simplification s;
  s.smooth = vector_fields::smoothed(field, o.laplacian);
  s.importance = vector_fields::weigh(field, s.smooth, skeleton);
  s.part = vector_fields::important_part(skeleton, s.importance, *o.threshold);
  return s;
}

Outcome work(Run& run, const SkeletonOptions& o) {
  io::PlanarFieldFile file = run.step("read", "reading " + o.common.input, [&] {
    return io::read_planar_field(o.common.input, o.vectors);
  });
  for (const std::string& warning : file.warnings) run.warn(warning);
  const vector_fields::PlanarField field{std::move(file.points), std::move(file.vectors),
                                         std::move(file.triangles)};
  certify::SkeletonCertificate record;
  const auto skeleton = run.step("skeleton", "skeleton of '" + file.field + "'", [&] {
    return run.with_input([&] { return vector_fields::extract_skeleton(field, record); });
  });
  run.report()["vectors"] = file.field;
  std::optional<Simplification> simpler;
  if (o.simplify.threshold)
    simpler = run.step("simplify", "weighing critical points",
                       [&] { return simplify(field, skeleton, o.simplify); });
  const Json words = skeleton_in_words(field, skeleton, simpler ? &simpler->importance : nullptr);
  for (const auto& [key, value] : std::get<Json::Members>(words.value())) run.report()[key] = value;
  if (simpler)
    run.report()["simplify"] =
        importance_in_words(simpler->importance, *o.simplify.threshold, o.simplify.laplacian);
  io::SkeletonScene scene{&field, simpler ? &simpler->part : &skeleton, {}, o.close_up};
  if (run.wanted("--certificate"))
    run.step("certificate", "writing the certificate", [&] {
      const auto bytes = certify::encode(record);
      // The checker shares no code with the extraction: what it refuses is a bug on either
      // side.
      if (const certify::Verdict verdict = certify::verify(bytes); !verdict.accepted)
        throw std::runtime_error("the certificate's checker refuses it: " + verdict.reason);
      scene.data_digest = certify::hex(certify::data_digest(bytes));
      run.write_certificate("skeleton", bytes, undecided_count(skeleton));
    });
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) { io::write_skeleton(path, scene); });
    run.write("--picture",
              [&](const std::string& path) { io::write_skeleton_picture(path, scene); });
    run.show_page([&] { return io::skeleton_page_scene(scene); });
    run.write("--smoothed", [&](const std::string& path) {
      const auto at = vector_fields::blended(field, simpler->smooth, *o.simplify.threshold);
      io::write_planar_field(path, at.points, at.triangles, file.field, at.vectors);
    });
    run.write("--paths", [&](const std::string& path) {
      io::write_paths(path, skeleton, simpler->importance);
    });
  });
  std::string summary = skeleton_summary(skeleton);
  if (simpler) summary += importance_summary(simpler->importance, *o.simplify.threshold);
  return {summary, {"roessl2005surfaces"}, undecided_count(skeleton) > 0 ? kNotCertified : kDone};
}

std::function<int()> add_skeleton(CLI::App& app) {
  auto options = std::make_shared<SkeletonOptions>();
  SkeletonOptions& o = *options;
  add_common_options(app, o.common, kVectorFormats, "the skeleton (.vtp)");
  add_vector_options(app, o.vectors);
  add_close_up_option(app, o.close_up);
  CLI::Option* simplify = add_simplify_options(
      app, o.simplify,
      "weigh critical points and separatrices from 0 to 1; -o and --picture show "
      "those of weight W or more; weights are not certified");
  app.add_option("--paths", o.paths,
                 "the ways of critical points to the smoothed field, the time as z (.vtp)")
      ->needs(simplify)
      ->type_name("FILE");
  return [options] {
    return run_command({"skeleton",
                        options->common,
                        {".vtp"},
                        {{"--smoothed", options->simplify.smoothed, {".vtu"}},
                         {"--paths", options->paths, {".vtp"}}}},
                       [&](Run& run) { return work(run, *options); });
  };
}

}  // namespace

extern const Command skeleton_command;
const Command skeleton_command = {
    "skeleton",
    "zeros, switch points, separatrices and closed orbits of a plane vector field",
    add_skeleton,
    {"crest skeleton lattice.vtu -o skeleton.vtp --certificate skeleton.crest",
     "crest skeleton twin-bodden.vtu --vectors flow --picture bodden.png --page bodden.html"}};

}  // namespace crest::cli
