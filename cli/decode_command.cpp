// SPDX-License-Identifier: GPL-3.0-or-later
// crest decode: the mesh of a stream.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "algorithms/coding/coding.hpp"
#include "cli/attribute_report.hpp"
#include "cli/run.hpp"
#include "io/formats/files.hpp"
#include "io/write/mesh_writer.hpp"

namespace crest::cli {
namespace {

struct DecodeOptions {
  CommonOptions common;
  coding::DecodeLimits limits;
};

coding::Decoded decode_file(const std::string& path, const coding::DecodeLimits& limits) {
  coding::Decoded decoded;
  io::read_named(path, [&] {
    if (io::lower_extension(path) != ".cmc")
      io::fail("file", "its extension is not .cmc", "give a stream of crest encode");
    const io::FileBytes bytes = io::load(path);
    const std::string_view text = bytes;
    decoded =
        coding::decode({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, limits);
  });
  return decoded;
}

Outcome work(Run& run, const DecodeOptions& o) {
  const coding::Decoded decoded = run.step("decode", "decoding " + o.common.input,
                                           [&] { return decode_file(o.common.input, o.limits); });
  const coding::StreamInfo& info = decoded.info;
  std::vector<kernel::Vec3> points = decoded.points;
  if (info.places == coding::Places::none) {
    run.warn("the stream has no places: all vertices are at the origin");
    points.resize(info.vertices);
  }
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) {
      for (const std::string& name :
           io::write_mesh(path, points, decoded.faces, decoded.attributes))
        run.warn(fmt::format("left out the attribute {}: {} has no place for it", name,
                             io::lower_extension(path)));
    });
  });
  Report& report = run.report();
  report["vertices"] = info.vertices;
  report["faces"] = info.faces;
  report["components"] = info.components;
  report["handles"] = info.handles;
  report["boundary_loops"] = info.loops;
  report["method"] = coding::name_of(info.method);
  report["attributes"] = to_json(std::span(decoded.attributes));
  return {fmt::format("mesh: {} vertices, {} faces, {} components, {} handles, {} boundary loops\n",
                      info.vertices, info.faces, info.components, info.handles, info.loops)};
}

std::function<int()> add_decode(CLI::App& app) {
  auto options = std::make_shared<DecodeOptions>();
  CommonOptions& common = options->common;
  app.add_option("INPUT", common.input, "stream (.cmc)")->required();
  app.add_option("-o,--output", common.output, "the mesh (.off .obj .ply .vtp)")->type_name("FILE");
  app.add_option("--report", common.report, "counts and times (.json)")->type_name("FILE");
  app.add_option("--max-faces", options->limits.faces,
                 "refuse streams of more faces (default 2^28)")
      ->check(CLI::Range(kernel::Index{1}, kernel::kNone / 3))
      ->type_name("N");
  app.add_option("--max-numbers", options->limits.numbers,
                 "refuse streams with more numbers in their attributes (default 2^27)")
      ->type_name("N");
  add_run_options(app, common);
  return [options] {
    return run_command({"decode", options->common, {".off", ".obj", ".ply", ".vtp"}},
                       [&](Run& run) { return work(run, *options); });
  };
}

}  // namespace

extern const Command decode_command;
const Command decode_command = {
    "decode",
    "the mesh of a stream that crest encode wrote",
    add_decode,
    {"crest decode ellipsoid.cmc -o ellipsoid.ply",
     "crest decode ellipsoid.cmc -o ellipsoid.off --report decode.json"}};

}  // namespace crest::cli
