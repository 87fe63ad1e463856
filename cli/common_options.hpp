// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The options every command has, in the same words.
#include <optional>
#include <string>

#include "io/clean/clean_up.hpp"
#include "io/picture/viewpoint.hpp"

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace crest::cli {

struct CommonOptions {
  std::string input;                 ///< INPUT; a file
  std::string output;                ///< -o; geometry, by extension
  std::string report;                ///< --report; JSON
  std::string certificate;           ///< --certificate; certify/SPEC.md
  std::string picture;               ///< --picture; .svg or .png
  std::string page;                  ///< --page; .html
  std::string command_line;          ///< as a shell would take it; without --threads and --quiet
  io::Viewpoint viewpoint;           ///< --view, --up; of pictures
  int threads = 0;                   ///< --threads; 0: as many as the machine has
  bool quiet = false;                ///< --quiet; no summary, no progress
  bool cite = false;                 ///< --cite; BibTeX of what the run used
  io::CleanOptions clean;            ///< --weld, --split, --outward; how INPUT is cleaned
  std::optional<std::int64_t> step;  ///< --step; of INPUT's fields
};

/// The group of the options that need a mesh.
inline constexpr const char* kMeshGroup = "Meshes";

/// What INPUT may be, for the help.
inline constexpr const char* kMeshFormats = ".off .obj .ply .stl .vtp .vtu .vtk .msh .pvtp .pvtu";

/// Refuses NaN, which CLI::Range lets pass, infinity and numbers below `least`.
CLI::Validator finite_number(double least);

/// --weld and --split, and for commands that need an orientation --outward.
void add_clean_options(CLI::App& app, io::CleanOptions& clean, bool oriented);

/// --step, of commands that read fields.
void add_step_option(CLI::App& app, CommonOptions& options);

/// --page, and the command line that it shows.
void add_page_option(CLI::App& app, CommonOptions& options);

/// --view and --up, of commands with pictures.
void add_view_options(CLI::App& app, io::Viewpoint& viewpoint);

/// --threads and --quiet, which every command has.
void add_run_options(CLI::App& app, CommonOptions& options);

/// Adds INPUT (checked by the reader, not by the parser: a missing file is bad input, exit code 3)
/// and the common options.
void add_common_options(CLI::App& app, CommonOptions& options, const std::string& input_help,
                        const std::string& output_help);

}  // namespace crest::cli
