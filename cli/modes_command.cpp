// SPDX-License-Identifier: GPL-3.0-or-later
// crest modes: in the table through this file's name (cli/CMakeLists.txt).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "algorithms/modes/certificate.hpp"
#include "cli/run.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"

namespace crest::cli {
namespace {

struct Options {
  CommonOptions common;
};

modes::Input read_input(Run& run, const Options& o) {
  return run.step("read", "reading " + o.common.input, [&] {
    modes::Input input;
    io::read_named(o.common.input, [&] {
      const io::Soup soup = io::read_vtu(io::load(o.common.input), {});
      input.points = soup.points;
      for (std::size_t c = 0; c < soup.cells.size(); ++c) {
        const auto nodes = soup.cells.nodes(c);
        if (soup.cells.type(c) != io::CellType::tetrahedron || nodes.size() != 4)
          io::fail("cell " + std::to_string(soup.cell_tag(c)), "is no tetrahedron", "leave it out");
        auto& cell = input.cells.emplace_back();
        for (std::size_t k = 0; k < nodes.size(); ++k) {
          if (nodes[k] < 0 || static_cast<std::size_t>(nodes[k]) >= soup.points.size())
            io::fail("cell " + std::to_string(soup.cell_tag(c)), "has a node that does not exist",
                     "export the file again");
          cell[k] = static_cast<std::uint32_t>(nodes[k]);
        }
      }
    });
    return input;
  });
}

Outcome work(Run& run, const Options& o) {
  const modes::Input input = read_input(run, o);
  const auto census = run.step("count", "counting", [&] { return modes::take_census(input); });
  Report& report = run.report();
  report["points"] = input.points.size();
  report["cells"] = input.cells.size();
  report["places"] = census.distinct;
  report["used_points"] = census.used;
  run.write_certificate("modes", certify::encode(modes::make_certificate(input, census)));
  return {fmt::format("{} points at {} places, {} of them corners of {} tetrahedra\n",
                      input.points.size(), census.distinct, census.used, input.cells.size())};
}

std::function<int()> add(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CommonOptions& common = options->common;
  app.add_option("INPUT", common.input, "tetrahedra (.vtu)")->required();
  app.add_option("--report", common.report, "counts and times (.json)")->type_name("FILE");
  app.add_option("--certificate", common.certificate, "the counts' proof")->type_name("FILE");
  add_run_options(app, common);
  return [options] {
    return run_command({"modes", options->common, {}},
                       [&](Run& run) { return work(run, *options); });
  };
}

}  // namespace

extern const Command modes_command;
const Command modes_command = {
    "modes",
    "the points of tetrahedra, counted",
    add,
    {"crest modes cells.vtu", "crest modes cells.vtu --quiet --certificate census.crest"}};

}  // namespace crest::cli
