// SPDX-License-Identifier: GPL-3.0-or-later
// Faces with Taylor models of order 5.
#include "certify/ridges_smooth/face_impl.hpp"

namespace crest::certify::smooth {

template class FaceProver<Model5>;

}  // namespace crest::certify::smooth
