// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The options of commands that read plane vector fields.
#include "io/read/planar_field_reader.hpp"

namespace CLI {
class App;
}

namespace crest::cli {

/// What INPUT may be, for the help.
extern const char* const kVectorFormats;

void add_vector_options(CLI::App& app, io::VectorRequest& request);

}  // namespace crest::cli
