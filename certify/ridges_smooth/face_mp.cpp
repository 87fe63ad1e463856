// SPDX-License-Identifier: GPL-3.0-or-later
// Faces with Taylor models over MPFR intervals.
#include "certify/ridges_smooth/face_impl.hpp"

namespace crest::certify::smooth {

template class FaceProver<MpModel3>;
template class FaceProver<MpModel4>;
template class FaceProver<MpModel5>;

}  // namespace crest::certify::smooth
