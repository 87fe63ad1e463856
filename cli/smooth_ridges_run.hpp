// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// crest ridges --surface, --param: certified ridges and umbilics of a smooth surface.
#include <optional>
#include <string>

#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "cli/common_options.hpp"

namespace crest::cli {

struct SmoothRidgesOptions {
  bool implicit = false;                ///< --surface and --box, else --param and --domain
  std::string surface, box;             ///< F in x, y, z; bounds, units of the expression
  std::string param, domain, periodic;  ///< x;y;z in u, v; u0,u1,v0,v1; u, v or uv
  std::string mesh;                     ///< --mesh; the triangulation
  std::optional<double> seconds;        ///< --seconds
  smooth_ridges::Options algorithm;
};

/// The help's group of the options below.
inline constexpr const char* kSmoothGroup = "Smooth surfaces";

void add_smooth_ridges_options(CLI::App& app, SmoothRidgesOptions& options);

/// common.input is the expression. Returns the exit code: 0 certified; 4 cells are undecided, or
/// stopped by --seconds or SIGINT; 1 not certified otherwise. Throws: kernel::InputError for
/// expressions, boxes and domains that are wrong (one line with the column), and for places that
/// cannot be written; UsageError.
int run_smooth_ridges(const CommonOptions& common, const SmoothRidgesOptions& options);

}  // namespace crest::cli
