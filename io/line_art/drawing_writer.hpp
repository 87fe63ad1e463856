// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Drawings as files: .svg in mm, in groups; .pdf and .eps; .vtp in space.
#include <string>

#include "algorithms/line_art/line_art_result.hpp"

template <class T>
class vtkSmartPointer;
class vtkPolyData;

namespace crest::io {

/// By the extension. No fonts; the same bytes for the same drawing.
/// Throws: kernel::InputError for another extension or a place that cannot be written.
void write_drawing(const std::string& path, const line_art::Drawing& drawing);

/// Each format's bytes.
std::string svg_of(const line_art::Drawing& drawing);
std::string pdf_of(const line_art::Drawing& drawing);
std::string eps_of(const line_art::Drawing& drawing);
std::string vtp_of(const line_art::Drawing& drawing);

/// What the .vtp file holds.
vtkSmartPointer<vtkPolyData> drawing_poly_data(const line_art::Drawing& drawing);

struct Scene;  // io/page/scene.hpp

/// The drawing in space for a page, as .vtp has it, over its surface; seen from where it is drawn.
Scene drawing_scene(const line_art::Drawing& drawing);

}  // namespace crest::io
