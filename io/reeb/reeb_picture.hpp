// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A surface with level lines and critical points, its Reeb graph beside it.
#include <string>

#include "io/picture/viewpoint.hpp"
#include "io/reeb/reeb_writer.hpp"

namespace crest::io {

/// Levels for a picture where none are asked for: evenly between the extremes.
std::vector<double> picture_levels(const std::vector<reeb::NodePlace>& places);

/// Writes .png or .svg, by the extension in any case. Left: the surface, tinted by the arc of the
/// graph that a point lies on, with the scene's level lines and its visible critical points. Right:
/// the graph, its arcs in the same colours, y the value (graph_layout.hpp has x). Where the values
/// are nearly a height, that direction points up.
/// Minima blue, saddles yellow, maxima red. `note`: a line of the legend.
/// Guarantees: the same bytes for the same scene; no half-written file.
/// Throws: kernel::InputError for another extension, a place that cannot be written or a direction
/// that is none.
void write_reeb_picture(const std::string& path, const ReebScene& scene,
                        const Viewpoint& viewpoint = {}, const std::string& note = {});

struct Scene;  // io/page/scene.hpp

/// The same for a page, with the values and the arcs of the graph through the surface.
/// `persistence`: of the graph's nodes.
Scene reeb_page_scene(const ReebScene& scene, const std::vector<double>& persistence,
                      const Viewpoint& viewpoint);

}  // namespace crest::io
