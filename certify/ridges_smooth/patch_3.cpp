// SPDX-License-Identifier: GPL-3.0-or-later
// Umbilics with Taylor models of order 3.
#include "certify/ridges_smooth/patch_impl.hpp"

namespace crest::certify::smooth {

template class PatchProver<Model3>;

}  // namespace crest::certify::smooth
