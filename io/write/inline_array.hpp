// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The numbers of an array in VTK's XML formats. VTK's writer compresses one block after the other
// by zlib and holds the file in memory, twice at its end: of `crest curvature -o` that was nine
// tenths.
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "io/write/atomic_file.hpp"

namespace crest::io {

/// Hands on what stands in a DataArray of format "binary" in a file of compressor
/// vtkZLibDataCompressor and of header_type UInt32: the header (number of blocks; bytes of a block;
/// of the last one if it is smaller, else 0; of each when compressed), then the blocks as zlib
/// streams, both in base64. Blocks are compressed side by side by libdeflate's fastest level, which
/// is thrice as fast as zlib's 5 and no larger on numbers of meshes; a run of blocks of which the
/// first shrinks by less than an eighth, as doubles that were computed do, is stored as it is.
/// Guarantees: depends on the bytes, `block` and libdeflate, not on threads.
/// Requires: 0 < block < 2^31. Throws: std::bad_alloc.
/// Cost: linear; memory for the compressed array.
void write_inline_array(std::string_view bytes, std::size_t block, const Sink& sink);

/// The same of `size` bytes that are made block by block, in several threads: those from a place
/// on, as they stand somewhere or in the room given.
using BytesAt =
    std::function<std::string_view(std::size_t at, std::size_t size, std::vector<char>& room)>;
void write_inline_array(std::size_t size, const BytesAt& bytes, std::size_t block,
                        const Sink& sink);

}  // namespace crest::io
