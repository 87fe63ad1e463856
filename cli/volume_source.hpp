// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a file becomes a volume, in the same words for all commands that read one.
#include <CLI/CLI.hpp>

#include "io/read/volume_reader.hpp"

namespace crest::cli {

/// --field and --raw.
inline void add_volume_source(CLI::App& app, io::VolumeSource& source, const char* group) {
  app.add_option("--field", source.field, "of several arrays (.vti, .vtk)")
      ->type_name("NAME")
      ->group(group);
  app.add_option("--raw", source.raw, "INPUT is NX NY NZ samples without a header, little-endian")
      ->type_name("NX,NY,NZ,TYPE")
      ->group(group);
}

}  // namespace crest::cli
