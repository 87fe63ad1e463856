// SPDX-License-Identifier: GPL-3.0-or-later
// Umbilics with Taylor models over MPFR intervals.
#include "certify/ridges_smooth/patch_impl.hpp"

namespace crest::certify::smooth {

template class PatchProver<MpModel3>;
template class PatchProver<MpModel5>;

}  // namespace crest::certify::smooth
