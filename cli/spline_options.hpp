// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The options of crest spline.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/splines/cubic_model.hpp"
#include "cli/common_options.hpp"
#include "io/read/volume_reader.hpp"

namespace crest::cli {

struct SplineOptions {
  CommonOptions common;
  bool quadratic = false, cubic = false;
  std::string evaluate, values;  ///< points in, values out

  // Volumes.
  io::VolumeSource source;
  std::optional<double> isovalue;
  bool extend = false;  ///< --border extend
  std::string rays, hits, mesh;
  std::vector<double> camera;  ///< eye, target and perhaps the angle: 6 or 7 numbers
  int size = 512;              ///< of the picture
  int max_depth = 54;          ///< of the mesh's bisections

  // Tables.
  std::vector<std::string> columns;  ///< of x, y, z and the value; empty: of these names
  std::optional<splines::Smoothness> smoothness;
  std::vector<kernel::Index> cubes;  ///< none, one or three
  std::vector<double> box;           ///< none, two or six numbers
};

}  // namespace crest::cli
