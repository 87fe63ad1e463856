// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files whose samples stand one after the other, so that a box of them can be read alone.
#include <optional>

#include "io/formats/volume.hpp"

namespace crest::io {

struct PlainSamples {
  Volume volume;  ///< without samples
  NumberType type = NumberType::u8;
  bool big_endian = false;
  std::size_t offset = 0;  ///< of the first in the file
};

/// --raw NX,NY,NZ,TYPE.
PlainSamples plain_raw(const std::string& shape);
/// Nothing if the samples are not plain, or in another file. Throws as read_nrrd() does of headers.
std::optional<PlainSamples> plain_nrrd(std::string_view bytes);

/// Throws kernel::InputError if there are not as many bytes of samples.
void check_length(const PlainSamples& samples, std::size_t file_size);

}  // namespace crest::io
