// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From what a file says to a volume in the world: what volume_reader.hpp and volume_boxes.hpp
// share.
#include "io/formats/volume.hpp"
#include "io/read/volume_reader.hpp"
#include "kernel/geometry/piece.hpp"

namespace crest::io {

/// All but the samples. Throws kernel::InputError: axes that are none of space.
VolumeFile frame_of(const Volume& volume);

/// Throws kernel::InputError for a sample that is not finite, or an integer that no double holds;
/// its place is that in the whole of which `box` is a part.
void check_samples(const Samples& samples, int dimension, const kernel::GridBox& box);

/// Loads files by names relative to that of `path`'s folder.
std::function<FileBytes(const std::string& name)> companions_of(const std::string& path);

}  // namespace crest::io
