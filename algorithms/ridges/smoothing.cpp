// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/smoothing.hpp"

#include <array>

#include "kernel/predicates/acute_rule.hpp"

namespace crest::ridges {

void smooth_extremalities(const kernel::TriangleMesh& mesh, std::vector<kernel::MongeForm>& forms,
                          int steps) {
  std::vector<std::array<double, 2>> smoothed(steps > 0 ? forms.size() : 0);
  for (int step = 0; step < steps; ++step) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      double sum0 = 0, sum3 = 0;
      for (Index w : mesh.ring(v)) {
        const bool same =
            kernel::acute_rule(forms[v].d1, forms[w].d1).sign == kernel::Sign::positive;
        sum0 += same ? forms[w].b0 : -forms[w].b0;
        sum3 += same ? forms[w].b3 : -forms[w].b3;
      }
      const double n = static_cast<double>(mesh.ring(v).size());
      smoothed[v] = {(forms[v].b0 + sum0 / n) / 2 + 0.0, (forms[v].b3 + sum3 / n) / 2 + 0.0};
    }
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      forms[v].b0 = smoothed[v][0];
      forms[v].b3 = smoothed[v][1];
    }
  }
}

}  // namespace crest::ridges
