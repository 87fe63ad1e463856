// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The system's calls: contours alone, or with hatches. README.md has the theory.
#include <functional>

#include "algorithms/line_art/buffers.hpp"
#include "algorithms/line_art/line_art_result.hpp"
#include "algorithms/line_art/tone.hpp"

namespace crest::line_art {

enum class HatchStyle : std::uint8_t { streamlines, fishbone };
enum class ToneStyle : std::uint8_t { width, bands, length };

struct HatchOptions {
  HatchStyle style = HatchStyle::fishbone;
  bool cross_field = false;
  ToneStyle tone_style = ToneStyle::width;
  bool cross_hatch = false;
  ToneOptions tone;
  LightOptions light;
  double smooth = 10;  ///< L, in spacings
  std::optional<double> crease = 60;
  Steering steering = {};
  std::function<void(Buffers&)> look = {};  ///< at the frame buffer before it is used
};

/// Times a part of the work under its name.
using Phase = std::function<void(const char* name, const std::function<void()>& work)>;

/// Adds hatches to a drawing of the mesh that has its contours. Requires: one frame a vertex; the
/// scene was welded from the mesh's points and faces. Guarantees: no hatch meets a visible contour;
/// the same for any number of threads.
void add_hatches(Drawing& drawing, const kernel::TriangleMesh& mesh,
                 const std::vector<PrincipalFrame>& frames, const HatchOptions& options,
                 const Phase& phase);

}  // namespace crest::line_art
