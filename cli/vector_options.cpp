// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/vector_options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>

#include "cli/common_options.hpp"
#include "cli/one_of.hpp"

namespace crest::cli {

const char* const kVectorFormats =
    "a plane mesh or grid with vectors (.vtu .vtp .pvtu .pvtp .vtk .msh .vti .vtr .vts .nrrd .nc, "
    "winds .json, "
    "velocimetry .txt .vec)";

void add_vector_options(CLI::App& app, io::VectorRequest& request) {
  app.add_option("--vectors", request.field, "the array (default: the only one of 2 or 3 numbers)")
      ->type_name("NAME");
  app.add_flag("--cell-to-point", request.cell_to_point,
               "take vectors of cells: at a point the mean of those around it");
  const std::map<std::string, io::Diagonal> diagonals = {
      {"up", io::Diagonal::up}, {"down", io::Diagonal::down}, {"short", io::Diagonal::shorter}};
  app.add_option("--diagonal", request.diagonal, "of grids' cells: up, down or short (default: up)")
      ->transform(one_of(diagonals))
      ->type_name("WORD");
  app.add_option("--slice", request.slice, "the layer of a grid with several, from 0")
      ->check(CLI::Range(0, 1'000'000'000))
      ->type_name("K");
  app.add_flag("--all", request.all, "keep points that the file flags as bad");
}

void add_close_up_option(CLI::App& app, std::optional<io::PlaneWindow>& close_up) {
  const auto take = [&close_up](const std::string& text) {
    double x[4];
    const std::vector<std::string> words = CLI::detail::split(text, ',');
    for (std::size_t k = 0; k < 4; ++k)
      if (words.size() != 4 || !CLI::detail::lexical_cast(words[k], x[k]) || !std::isfinite(x[k]))
        throw CLI::ValidationError("--close-up", text + " is not four numbers X0,Y0,X1,Y1");
    if (!(x[0] < x[2] && x[1] < x[3]))
      throw CLI::ValidationError("--close-up", "x0 < x1 and y0 < y1 are corners");
    close_up = io::PlaneWindow{{x[0], x[1]}, {x[2], x[3]}};
  };
  app.add_option_function<std::string>("--close-up", take,
                                       "the part of the plane that --picture shows")
      ->type_name("X0,Y0,X1,Y1");
}

CLI::Option* add_simplify_options(CLI::App& app, SimplifyOptions& options,
                                  const std::string& help) {
  using vector_fields::Laplacian;
  auto* simplify = app.add_option("--simplify", options.threshold, help)
                       ->check(finite_number(0) & CLI::Range(0.0, 1.0))
                       ->type_name("W");
  const std::map<std::string, Laplacian> laplacians = {{"uniform", Laplacian::uniform},
                                                       {"cotan", Laplacian::cotan}};
  app.add_option("--laplacian", options.laplacian,
                 "of the smoothed field that gives weights: uniform (default) or cotan")
      ->transform(one_of(laplacians))
      ->needs(simplify)
      ->type_name("WORD");
  app.add_option("--smoothed", options.smoothed,
                 "the field at time W of its way to the smoothed one (.vtu)")
      ->needs(simplify)
      ->type_name("FILE");
  return simplify;
}

}  // namespace crest::cli
