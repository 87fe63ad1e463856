// SPDX-License-Identifier: GPL-3.0-or-later
// crest encode: a triangle mesh as a small stream, verified before it appears.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <memory>

#include "algorithms/coding/certificate.hpp"
#include "algorithms/coding/coding.hpp"
#include "algorithms/coding/verify.hpp"
#include "certify/certificate.hpp"
#include "certify/coding/encode.hpp"
#include "cli/attribute_report.hpp"
#include "cli/run.hpp"
#include "io/formats/files.hpp"
#include "io/read/surface_reader.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/text.hpp"

namespace crest::cli {
namespace {

using coding::Places;

struct EncodeCommandOptions {
  CommonOptions common;
  coding::EncodeOptions coding;
  std::string method = "auto", permutation;
  bool exact = false, connectivity_only = false;
  CLI::Option* tolerance = nullptr;
};

void add_encode_options(CLI::App& app, EncodeCommandOptions& o) {
  auto* exact = app.add_flag("--exact", o.exact, "places bit for bit (default)");
  o.tolerance = app.add_option("--tolerance", o.coding.tolerance,
                               "places within this distance, in units of the input");
  o.tolerance->check(finite_number(0))->type_name("T")->excludes(exact);
  app.add_flag("--connectivity-only", o.connectivity_only, "neither places nor attributes")
      ->excludes(exact)
      ->excludes(o.tolerance);
  app.add_option("--method", o.method,
                 "how the connectivity is coded; auto (default) keeps the smallest of valence, fan "
                 "and static; valence alone is faster")
      ->check(CLI::IsMember({"auto", "valence", "fan", "zigzag", "static"}))
      ->type_name("METHOD");
  app.add_flag("--keep-order", o.coding.keep_order, "code the order of vertices and faces, too");
  app.add_option("--permutation", o.permutation,
                 "text: line i is the input's vertex that is decoded as vertex i, from 0 (.txt)")
      ->type_name("FILE");
}

void check_options(EncodeCommandOptions& o) {
  if (o.tolerance->count() > 0) {
    if (o.coding.tolerance == 0)
      throw UsageError("--tolerance 0: take --exact, or a positive number");
    o.coding.places = Places::rounded;
  }
  if (o.connectivity_only) o.coding.places = Places::none;
  for (const coding::Method method : {coding::Method::valence, coding::Method::fan,
                                      coding::Method::zigzag, coding::Method::fixed})
    if (o.method == coding::name_of(method)) o.coding.method = method;
}

void report_stream(Report& report, const EncodeCommandOptions& o, const coding::Encoded& e,
                   double largest) {
  const coding::StreamInfo& info = e.info;
  report["vertices"] = info.vertices;
  report["faces"] = info.faces;
  report["components"] = info.components;
  report["handles"] = info.handles;
  report["boundary_loops"] = info.loops;
  report["splits"] = e.splits;
  report["method"] = coding::name_of(info.method);
  report["clearance"] = info.cleared;
  report["bytes"] = {{"connectivity", info.sizes.connectivity},
                     {"geometry", info.sizes.geometry},
                     {"attributes", info.sizes.attributes},
                     {"header", info.sizes.header},
                     {"total", info.sizes.total()}};
  const auto per_vertex = [&](std::size_t bytes) {
    return 8.0 * static_cast<double>(bytes) / info.vertices;
  };
  report["bits_per_vertex"] = {{"connectivity", per_vertex(info.sizes.connectivity)},
                               {"geometry", per_vertex(info.sizes.geometry)}};
  if (info.places == Places::rounded)
    report["tolerance"] = {{"asked", o.coding.tolerance}, {"largest_error", largest}};
}

std::string summary(const coding::Encoded& e, std::span<const kernel::Attribute> attributes) {
  const coding::StreamInfo& info = e.info;
  const double bits = 8.0 / info.vertices;
  std::string names;
  for (const kernel::Attribute& a : attributes)
    names += (names.empty() ? "" : ", ") + io::one_line(a.name);
  if (!names.empty())
    names = fmt::format("attributes: {} bytes, {}\n", info.sizes.attributes, names);
  return fmt::format(
             "mesh: {} vertices, {} faces, {} components, {} handles, {} boundary loops\n"
             "stream: {} bytes; connectivity {} ({:.3f} bits a vertex, {}), places {} ({:.2f})\n",
             info.vertices, info.faces, info.components, info.handles, info.loops,
             info.sizes.total(), info.sizes.connectivity,
             bits * static_cast<double>(info.sizes.connectivity), coding::name_of(info.method),
             info.sizes.geometry, bits * static_cast<double>(info.sizes.geometry)) +
         names;
}

void write_permutation(const std::string& path, const coding::Encoded& e,
                       const io::FileNumbers& numbers) {
  io::Text text;
  for (const kernel::Index v : e.vertex_order) text.add("{}\n", numbers.vertex(v));
  io::write_atomically(path, text.text());
}

Outcome work(Run& run, const EncodeCommandOptions& o) {
  const io::SurfaceFile file = run.read([&](const std::string& path) {
    return io::read_surface(path, o.coding.places != Places::none);
  });
  const coding::Encoded encoded = run.step("encode", "encoding", [&] {
    return run.with_input([&] {
      return coding::encode(static_cast<kernel::Index>(file.points.size()), file.faces, file.points,
                            o.coding, file.attributes);
    });
  });
  const double largest = run.step("verify", "decoding again", [&] {
    return coding::verify(encoded, file.faces, file.points, o.coding, file.attributes);
  });
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) {
      io::write_atomically(
          path, {reinterpret_cast<const char*>(encoded.stream.data()), encoded.stream.size()});
    });
    run.write("--permutation",
              [&](const std::string& path) { write_permutation(path, encoded, file.numbers); });
    if (!run.wanted("--certificate")) return;
    const certify::Bytes certificate = certify::encode(
        coding::make_certificate(encoded, file.faces, file.points, o.coding,
                                 static_cast<kernel::Index>(file.cleanup.unused_vertices)));
    run.report()["data_digest"] = certify::hex(certify::data_digest(certificate));
    run.write_certificate("coding", certificate);
  });
  report_stream(run.report(), o, encoded, largest);
  run.report()["attributes"] = to_json(std::span(file.attributes));
  return {summary(encoded, file.attributes),
          {"roessl2005surfaces", "touma1998triangle", "alliez2001valence"}};
}

int run_encode(EncodeCommandOptions& o) {
  check_options(o);
  return run_command({"encode", o.common, {".cmc"}, {{"--permutation", o.permutation, {".txt"}}}},
                     [&](Run& run) { return work(run, o); });
}

std::function<int()> add_encode(CLI::App& app) {
  auto options = std::make_shared<EncodeCommandOptions>();
  CommonOptions& common = options->common;
  app.add_option("INPUT", common.input, fmt::format("mesh ({})", kMeshFormats))->required();
  app.add_option("-o,--output", common.output, "the stream (.cmc)")->type_name("FILE");
  app.add_option("--report", common.report, "counts, bytes and times (.json)")->type_name("FILE");
  app.add_option(
         "--certificate", common.certificate,
         "that the stream decodes to the mesh (crest-verify checks it with a decoder of its "
         "own)")
      ->type_name("FILE");
  add_encode_options(app, *options);
  add_run_options(app, common);
  app.add_flag("--cite", common.cite, "print the references this run used (BibTeX)");
  return [options] { return run_encode(*options); };
}

}  // namespace

extern const Command encode_command;
const Command encode_command = {
    "encode",
    "a triangle mesh as a small stream, lossless or within a tolerance",
    add_encode,
    {"crest encode ellipsoid.off -o ellipsoid.cmc --certificate ellipsoid.crest",
     "crest encode ellipsoid.off --tolerance 0.001 --method valence -o coarse.cmc",
     "crest encode ellipsoid.off --keep-order -o ordered.cmc"}};

}  // namespace crest::cli
