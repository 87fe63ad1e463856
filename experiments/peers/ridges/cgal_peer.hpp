// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// CGAL's ridge pipeline (Monge_via_jet_fitting, Umbilics, Ridges) on a mesh, timed phase by phase.
#include <chrono>
#include <utility>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::peers {

class Stopwatch {
 public:
  /// Seconds since the last call or the construction.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct CgalOptions {
  std::size_t min_points = 30;  ///< rings are added until the fit has as many
  double umbilic_size = 2;      ///< CGAL's patch size, a multiple of the one-ring
};

/// Lines of one colour, merged where they share a mesh edge.
struct MergedLines {
  int lines = 0, components = 0, loops = 0, open_ends = 0;
};

struct CgalResult {
  double mesh = 0, gather = 0, fit = 0, umbilics = 0, setup = 0, blue = 0, red = 0, crest = 0;  // s
  int plus = 0, minus = 0, other = 0;  ///< umbilics by index +1/2, -1/2, anything else
  MergedLines blue_lines, red_lines;
  double total() const { return gather + fit + umbilics + setup + blue + red + crest; }
  double index_sum() const { return 0.5 * (plus - minus); }
};

/// Throws: std::runtime_error where CGAL refuses a face.
CgalResult run_cgal(const kernel::TriangleMesh& mesh, const CgalOptions& options = {});

/// The same in a process of its own, which ends after so many seconds of processor time.
/// Throws: std::runtime_error, in words for a table, if it did not finish.
CgalResult run_cgal_within(unsigned seconds, const kernel::TriangleMesh& mesh,
                           const CgalOptions& options = {});

}  // namespace crest::peers
