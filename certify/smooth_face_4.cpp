// SPDX-License-Identifier: GPL-3.0-or-later
// Faces with Taylor models of order 4.
#include "certify/smooth_face_impl.hpp"

namespace crest::certify::smooth {

template class FaceProver<Model4>;

}  // namespace crest::certify::smooth
