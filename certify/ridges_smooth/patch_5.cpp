// SPDX-License-Identifier: GPL-3.0-or-later
// Umbilics with Taylor models of order 5.
#include "certify/ridges_smooth/patch_impl.hpp"

namespace crest::certify::smooth {

template class PatchProver<Model5>;

}  // namespace crest::certify::smooth
