// SPDX-License-Identifier: GPL-3.0-or-later
// crest compress: a plane vector field on fewer triangles with the same skeleton (paper 001, 5.3).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <stdexcept>

#include "algorithms/vector_fields/certificate.hpp"
#include "certify/certificate.hpp"
#include "certify/verify.hpp"
#include "cli/compression_report.hpp"
#include "cli/one_of.hpp"
#include "cli/run.hpp"
#include "cli/skeleton_report.hpp"
#include "cli/vector_options.hpp"
#include "io/page/scene.hpp"
#include "io/vector_fields/skeleton_writer.hpp"
#include "io/write/planar_field_writer.hpp"

namespace crest::cli {
namespace {

struct CompressOptions {
  CommonOptions common;
  io::VectorRequest vectors;
  vector_fields::CompressionOptions compression;
  SimplifyOptions simplify;
  std::optional<io::PlaneWindow> close_up;
};

/// Of both skeletons; where these differ, of the output's alone.
void write_certificate(Run& run, const certify::CompressionCertificate& record,
                       const vector_fields::Compression& result) {
  const bool simpler = result.importance.has_value();
  const auto bytes = simpler ? certify::encode(record.output) : certify::encode(record);
  // The checker shares no code with the compression: what it refuses is a bug on either side.
  if (const certify::Verdict verdict = certify::verify(bytes); !verdict.accepted)
    throw std::runtime_error("the certificate's checker refuses it: " + verdict.reason);
  run.write_certificate(simpler ? "skeleton" : "compression", bytes,
                        undecided_count(simpler ? result.after : result.before));
}

Outcome work(Run& run, const CompressOptions& o) {
  io::PlanarFieldFile file = run.step("read", "reading " + o.common.input, [&] {
    return io::read_planar_field(o.common.input, o.vectors);
  });
  for (const std::string& warning : file.warnings) run.warn(warning);
  const vector_fields::PlanarField field{std::move(file.points), std::move(file.vectors),
                                         std::move(file.triangles)};
  certify::CompressionCertificate record;
  const auto result = run.step("compress", "collapsing edges of '" + file.field + "'", [&] {
    return run.with_input([&] { return vector_fields::compress(field, o.compression, record); });
  });
  run.report()["vectors"] = file.field;
  report_compression(run.report(), field, o.compression, result);
  if (!result.same_skeleton)
    return {"the skeletons of the two fields are not proven equal, nothing is written: " +
                result.difference + "\n",
            {"roessl2005surfaces"},
            kNotCertified};
  if (run.wanted("--certificate"))
    run.step("certificate", "writing the certificate",
             [&] { write_certificate(run, record, result); });
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) {
      io::write_planar_field(path, result.field.points, result.field.triangles, file.field,
                             result.field.vectors);
    });
    run.write("--picture", [&](const std::string& path) {
      io::write_comparison_picture(path, {&field, &result.before, {}, o.close_up},
                                   {&result.field, &result.after});
    });
    run.write("--smoothed", [&](const std::string& path) {
      const auto at = vector_fields::blended(
          field, vector_fields::smoothed(field, o.simplify.laplacian), *o.simplify.threshold);
      io::write_planar_field(path, at.points, at.triangles, file.field, at.vectors);
    });
    run.show_page([&] { return io::skeleton_page_scene({&result.field, &result.after}); });
  });
  return {
      compression_summary(field, result),
      {"roessl2005surfaces"},
      undecided_count(result.before) > 0 || (result.importance && undecided_count(result.after) > 0)
          ? kNotCertified
          : kDone};
}

std::function<int()> add_compress(CLI::App& app) {
  using namespace vector_fields;
  auto options = std::make_shared<CompressOptions>();
  CompressOptions& o = *options;
  add_common_options(app, o.common, kVectorFormats, "the field on fewer triangles (.vtu)");
  add_vector_options(app, o.vectors);
  add_close_up_option(app, o.close_up);
  const std::map<std::string, Equivalence> notions = {{"strong", Equivalence::strong},
                                                      {"original", Equivalence::original},
                                                      {"relaxed", Equivalence::relaxed}};
  CLI::Option* simplify = add_simplify_options(
      app, o.simplify,
      "critical points that weigh less than W (0 to 1) may move and vanish in "
      "pairs; what weighs more stays as in original. The certificate, then, is "
      "of the output's skeleton alone");
  app.add_option("--equivalence", o.compression.equivalence,
                 "strong: all triangles that the skeleton meets stay; original: those of zeros "
                 "(default); relaxed: zeros may move")
      ->excludes(simplify)
      ->transform(one_of(notions))
      ->type_name("WORD");
  const std::map<std::string, CollapseTest> tests = {{"retrace", CollapseTest::retrace},
                                                     {"thesis", CollapseTest::thesis}};
  app.add_option("--test", o.compression.test,
                 "retrace (default), or thesis: also the order on rings, as printed")
      ->excludes(simplify)
      ->transform(one_of(tests))
      ->type_name("WORD");
  const std::map<std::string, CollapsePriority> priorities = {
      {"length", CollapsePriority::length},
      {"error", CollapsePriority::error},
      {"product", CollapsePriority::product}};
  app.add_option("--priority", o.compression.priority,
                 "short edges first, small differences of vectors, or small products of both "
                 "(default: product)")
      ->transform(one_of(priorities))
      ->type_name("WORD");
  app.add_flag(
      "--no-flips", [&o](std::int64_t) { o.compression.flips = false; },
      "collapses alone (default: where nothing collapses, vertices are taken out with other "
      "fillings of their holes and edges are flipped, by the same test)");
  return [options] {
    options->compression.simplify = options->simplify.threshold;
    options->compression.laplacian = options->simplify.laplacian;
    return run_command({"compress",
                        options->common,
                        {".vtu"},
                        {{"--smoothed", options->simplify.smoothed, {".vtu"}}}},
                       [&](Run& run) { return work(run, *options); });
  };
}

}  // namespace

extern const Command compress_command;
const Command compress_command = {
    "compress",
    "a plane vector field on fewer triangles with the same topological skeleton",
    add_compress,
    {"crest compress lattice.vtu -o small.vtu --certificate small.crest",
     "crest compress twin-bodden.vtu --vectors flow --equivalence relaxed -o bodden.vtu"}};

}  // namespace crest::cli
