// SPDX-License-Identifier: GPL-3.0-or-later
// Umbilics with Taylor models over MPFR intervals.
#include "certify/ridges_smooth/patch_impl.hpp"

namespace crest::certify::smooth {

template class PatchProver<MpModel>;

}  // namespace crest::certify::smooth
