// SPDX-License-Identifier: GPL-3.0-or-later
#define CREST_QUADRATIC_ROOT_SOURCE
#include "kernel/predicates/quadratic_root_order.hpp"
#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

template std::optional<Decision> sign_at_root(const Quadratic&, QuadraticRoot, const Quadratic&);
template std::optional<Decision> root_order(const Quadratic&, QuadraticRoot, const Quadratic&,
                                            QuadraticRoot);

CREST_INSTANTIATE_STAGES(QuadraticDiscriminant<Quadratic>)

}  // namespace crest::kernel
