// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes and images as they stand in a file, and their readers: bytes to samples. Each throws
// kernel::InputError without the file's name and allocates nothing on the strength of a count that
// the bytes are too few for.
// Own code but for VTI: VTK's readers want a file, allocate what a header announces, crash (PNG)
// and lose what is wanted here (NIfTI: the slope; MRC: the order of axes; PNM: 16 bits; NRRD: all,
// where VTK's MPI modules are linked, too).
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/binary.hpp"
#include "io/formats/files.hpp"
#include "io/formats/soup.hpp"
#include "kernel/geometry/sampled_grid.hpp"

class vtkImageData;

namespace crest::io {

using Samples = kernel::SampledGrid::Samples;

struct Volume {
  std::vector<std::size_t> size;    ///< of any number of axes, the first the fastest
  std::vector<kernel::Vec3> steps;  ///< from sample to sample along each axis, in the world
  kernel::Vec3 origin{};            ///< of the first sample
  Samples samples{};
  std::vector<std::string> warnings{};
};

/// What a reader may ask for besides its bytes.
struct VolumeRequest {
  std::string field = {};  ///< of several arrays; empty: the only or the active one
  /// Loads the file that a header names, by a name relative to the header's.
  std::function<FileBytes(const std::string& name)> companion = {};
};

Volume read_nrrd(std::string_view bytes, const VolumeRequest& request);
Volume read_meta_image(std::string_view bytes, const VolumeRequest& request);
Volume read_vti(std::string_view bytes, const VolumeRequest& request);
Volume read_pvti(std::string_view bytes, const VolumeRequest& request);
Volume read_structured_points(std::string_view bytes, const VolumeRequest& request);
Volume read_nifti(std::string_view bytes, const VolumeRequest& request);
Volume read_mrc(std::string_view bytes, const VolumeRequest& request);
Volume read_cube(std::string_view bytes, const VolumeRequest& request);
Volume read_inrimage(std::string_view bytes, const VolumeRequest& request);
/// The samples of image data, of the array of points that is named, active or the only one.
Volume volume_of(vtkImageData& data, const std::string& field);
/// Images in row 0 = the topmost; y points up, as VTK has it. Of colours the luminance.
Volume read_png(std::string_view bytes, const VolumeRequest& request);
Volume read_pnm(std::string_view bytes, const VolumeRequest& request);

/// Samples without a header, little-endian. `shape`: "NX,NY,NZ,TYPE".
Volume read_raw(std::string_view bytes, const std::string& shape);

/// a b c .. Throws where that exceeds what memory may hold.
std::size_t product(const std::vector<std::size_t>& size);

/// The samples that the bytes hold. Throws unless these are as many as the size says.
Samples load_samples(NumberType type, std::string_view bytes, const std::vector<std::size_t>& size,
                     bool big_endian);

/// Numbers whose type is not known in the narrowest type that holds them all exactly.
Samples narrowed(const Field::Numbers& numbers);

/// Sets rows, which go down, and size of an image of one, or of three colours; their luminance.
void set_image(Volume& image, std::size_t width, std::size_t height, std::size_t colours,
               const Samples& samples);

/// Unpacks gzip or zlib, all of it, up to `limit` bytes. Throws where it is damaged or longer.
std::string inflated(std::string_view bytes, std::size_t limit = std::string_view::npos);

}  // namespace crest::io
