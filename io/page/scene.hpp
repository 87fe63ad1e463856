// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a page shows: surfaces, lines and points with attributes, words about the run. Every system
// fills one; the page knows no system.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/picture/camera.hpp"
#include "io/picture/drawing.hpp"
#include "io/write/vtk_columns.hpp"

namespace crest::io {

/// How numbers become colours.
enum class ColourMap : std::uint8_t {
  sequential,  ///< from the least to the largest
  diverging,   ///< the same on both sides of zero
  pale,        ///< likewise, for what other things are drawn on
  grey,        ///< likewise, of images
  labels       ///< whole numbers from 0 on, a tint each; -1 has none
};

/// A number a vertex or a face, as many as there are.
struct SceneField {
  std::string name;
  std::vector<double> values;
  bool per_face = false;
  ColourMap map = ColourMap::sequential;
};

struct SceneSurface {
  std::string name;
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  std::vector<SceneField> fields = {};  ///< the first one is shown, if `coloured`
  bool coloured = true;
  std::optional<Rgb> colour = {};  ///< else a light grey
  double opacity = 1;              ///< below 1 it hides nothing and cannot be picked
};

/// A line of the legend, with which items come and go.
struct SceneKind {
  std::string label;
  Rgb colour;
  double width = 1;  ///< of lines and points, in the page's own widths
  bool shown = true;
};

/// A column of the items' numbers that a slider filters by: those at least as large stay.
struct SceneFilter {
  std::string column, label;
  std::optional<double> start = {};  ///< where the slider stands at first; else all is shown
};

/// What the numbers of a column mean, from 0 on; a number without a word is not said.
struct SceneWords {
  std::string column;
  std::vector<std::string> words;
};

/// Items of one sort (ridges, critical points, ...): each has a row of attributes and is drawn as
/// runs of places, a run of one place as a point.
struct SceneLayer {
  struct Run {
    std::uint32_t item, kind, first;  ///< first: of its places, which reach to the next run's
  };

  std::string name;
  std::vector<SceneKind> kinds;
  std::vector<SceneFilter> filters = {};
  std::vector<SceneWords> words = {};
  Columns rows = {};
  std::uint32_t item_count = 0;
  std::vector<Run> runs = {};
  std::vector<kernel::Vec3> places = {};

  /// Starts an item and returns where its row goes.
  Columns& add_item() {
    ++item_count;
    return rows;
  }
  /// Requires: an item, and at least one place.
  void add_run(std::uint32_t kind, std::span<const kernel::Vec3> points) {
    runs.push_back({item_count - 1, kind, static_cast<std::uint32_t>(places.size())});
    places.insert(places.end(), points.begin(), points.end());
  }
  /// A polyline whose segments have kinds: `kind_of(i)` of that from point i to i + 1 (in a loop
  /// the last one returns to the first); a negative kind is not drawn.
  template <class KindOf>
  void add_line(const std::vector<kernel::Vec3>& points, bool loop, const KindOf& kind_of) {
    const std::size_t n = points.size(), segments = n < 2 ? 0 : n - (loop ? 0 : 1);
    std::vector<kernel::Vec3> run;
    for (std::size_t i = 0; i < segments;) {
      const int kind = kind_of(i);
      run.assign(1, points[i]);
      do run.push_back(points[++i % n]);
      while (i < segments && kind_of(i) == kind);
      if (kind >= 0) add_run(static_cast<std::uint32_t>(kind), run);
    }
  }
};

struct Scene {
  std::string title;  ///< what it shows; the run adds of what
  std::vector<SceneSurface> surfaces = {};
  std::vector<SceneLayer> layers = {};  ///< later ones are drawn over earlier ones
  std::optional<Camera> camera = {};    ///< else the one a picture of the first surface has
  bool flat = false;                    ///< in a plane: it is moved, not turned
  std::string note = {};                ///< of the legend: that this is a subset, and why
  std::string data_digest = {};         ///< hex, of the run's certificate
};

/// What is known of a run besides its scene.
struct PageContext {
  std::string command;  ///< the line that made the page
  std::string version;  ///< of the program
  std::string summary;  ///< the terminal's lines
  std::vector<std::string> warnings = {};
  std::string certificate = {};  ///< its bytes; empty: none
};

/// The surface of any mesh.
template <class Mesh>
SceneSurface scene_surface(const std::string& name, const Mesh& mesh) {
  return {name, mesh.points(), {mesh.faces().begin(), mesh.faces().end()}};
}

}  // namespace crest::io
