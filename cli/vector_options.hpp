// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The options of commands that read plane vector fields.
#include <optional>
#include <string>

#include "algorithms/vector_fields/importance.hpp"
#include "io/read/planar_field_reader.hpp"
#include "io/vector_fields/skeleton_writer.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace crest::cli {

/// What INPUT may be, for the help.
extern const char* const kVectorFormats;

void add_vector_options(CLI::App& app, io::VectorRequest& request);

/// --close-up
void add_close_up_option(CLI::App& app, std::optional<io::PlaneWindow>& close_up);

/// --simplify and what belongs to it.
struct SimplifyOptions {
  std::optional<double> threshold;
  vector_fields::Laplacian laplacian = vector_fields::Laplacian::uniform;
  std::string smoothed;  ///< --smoothed
};

/// Returns --simplify itself.
CLI::Option* add_simplify_options(CLI::App& app, SimplifyOptions& options, const std::string& help);

}  // namespace crest::cli
