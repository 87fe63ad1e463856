// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Samples on a grid as VTK's image data, in their own type.
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "kernel/geometry/sampled_grid.hpp"

namespace crest::io {

/// The samples' bytes, little-endian, the first axis the fastest.
std::string sample_bytes(const kernel::SampledGrid& grid);

/// With the array `value`.
vtkSmartPointer<vtkImageData> image_data(const kernel::SampledGrid& grid);

}  // namespace crest::io
