// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes and images from files (io/formats/volume.hpp).
#include <string>
#include <string_view>
#include <vector>

#include "kernel/geometry/sampled_grid.hpp"

namespace crest::io {

struct Volume;  // io/formats/volume.hpp

struct VolumeSource {
  std::string field = {};  ///< of several arrays (.vti, .vtk); empty: the active or the only one
  std::string raw = {};  ///< "NX,NY,NZ,TYPE" of samples without a header, whatever the file's name
};

struct VolumeFile {
  kernel::SampledGrid grid;  ///< of an image or a volume of one slice: dimension 2
  std::vector<std::string> warnings;
};

/// Whether the file's name is that of a volume or an image (".nii.gz": by both extensions).
bool is_volume_name(const std::string& path);

/// Reads .nrrd .nhdr .mha .mhd .vti .vtk .nii .map .mrc .ccp4 .cube .inr .png .pgm .ppm .pnm,
/// each compressed by gzip, too. Every sample is kept in the file's type; NIfTI's slope is applied,
/// of colours the luminance taken. Guarantees: at least 4 nodes along each axis, all samples finite
/// and exact as doubles, positive spacings. Axes off right angles are taken as if at right angles,
/// with a warning. Throws: kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY", one line.
VolumeFile read_volume(const std::string& path, const VolumeSource& source = {});

/// The same for a file that is in memory: `name` gives the format and stands in messages. A header
/// of another file is refused.
VolumeFile read_volume_bytes(const std::string& name, std::string_view bytes,
                             const VolumeSource& source = {});

/// The same for samples; messages do without the file's name.
VolumeFile grid_of_volume(Volume volume);

}  // namespace crest::io
