// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes with a symmetric tensor at each sample, as diffusion imaging has them, as tetrahedra.
#include <string_view>

#include "io/read/tet_reader.hpp"

namespace crest::io {

/// NRRD, the first of four axes being the tensor's: 6 numbers (xx xy xz yy yz zz, or as the request
/// orders them), 7 with a mask before them, 9. Each cube of samples becomes six tetrahedra round
/// the diagonal from its lowest corner, so that neighbours fit. Outside the mask the tensor is 0.
/// Tensors stay in the file's measurement frame: modes do not depend on it. Throws: as
/// read_tensors.
TensorFile read_tensor_volume(std::string_view bytes, const TensorRequest& request);

}  // namespace crest::io
