// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ridges and umbilics of a triangle mesh (paper 002, cases II and III): the public calls.
//
//   FitResult fit = fit_monge_forms(mesh, options.fit);         // section "Monge forms"
//   RidgeGraph graph = extract_ridge_graph(mesh, fit.forms);    // exact: a function of its input
//   FilterReport dropped = filter(graph, options.filter);       // section 7.2
#include <functional>
#include <string>
#include <utility>

#include "algorithms/ridges/ridge_graph.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::ridges {

struct Workers;  // pieces.hpp: who works on pieces of the mesh; none: this process on all of it

/// How the Monge forms are estimated (jet fitting, Cazals and Pouget 2003).
struct FitOptions {
  int rings = 0;        ///< rings of neighbours; 0: grow until min_points
  int min_points = 30;  ///< used when rings == 0
  double scale = 0;     ///< radius of the support in units of the input; 0: by rings
  int smooth = 0;       ///< smoothing steps of the extremalities
  int degree = 4;       ///< of the fitted polynomial, 3 or 4
  bool errors = false;  ///< estimate the curvatures' errors: a second fit to wider supports; and
                        ///< take the smallest supports by rings where they reach a crease
};

/// Shapes: one form and one quality a vertex. The same bytes for any number of threads and pieces.
/// Throws: kernel::InputError for coordinates out of range (kernel::require_carried).
FitResult fit_monge_forms(const kernel::TriangleMesh& mesh, const FitOptions& options,
                          const Workers* workers = nullptr);

/// Counts of the predicates' stages, by name, in a fixed order.
using PredicateReport = std::vector<std::pair<std::string, StageCounts>>;

/// How patches around umbilics are grown (section 8.1).
struct GraphOptions {
  double umbilic_patch =
      3;                ///< patch size, a multiple of the one-ring's greatest grade; 0: one face
  bool guarded = true;  ///< false: plain double decides (only to measure what exactness costs)
};

/// Section 8.2, the paper's method: minima of k1 - k2 over their patch, index on the contour.
struct PaperUmbilics {
  Index candidates = 0, plus = 0, minus = 0, other = 0;
};

/// The acute-rule ridge graph of the mesh for these Monge data, joined at umbilics.
/// Requires: forms.size() == V, every number finite, d1 and n non-zero, k1 >= k2.
/// Guarantees: what certify/ridges_mesh/SPEC.md defines, whatever threads and pieces; independent
/// of
///   the frames' signs where no d1 is parallel to its n. Cost: O(V) for bounded patches.
RidgeGraph extract_ridge_graph(const kernel::TriangleMesh& mesh,
                               const std::vector<kernel::MongeForm>& forms,
                               const GraphOptions& options = {}, PredicateReport* report = nullptr,
                               const Workers* workers = nullptr);

PaperUmbilics paper_umbilics(const kernel::TriangleMesh& mesh,
                             const std::vector<kernel::MongeForm>& forms, const RidgeGraph& graph,
                             double patch);

/// Which ridges are kept (section 7.2). Thresholds of 0 keep everything.
struct FilterOptions {
  double min_sharpness = 0;  ///< no unit (scale-independent)
  double min_strength = 0;   ///< no unit
  double min_length = 0;     ///< units of the input
  bool crest_only = false;   ///< elliptic, and the larger of |k1|, |k2|: pieces of ridges remain
  int min_level = 0;         ///< of the crossings (salience.hpp): pieces of ridges remain
};
struct FilterReport {
  Index by_sharpness = 0, by_strength = 0, by_length = 0, by_crest = 0, by_level = 0;  ///< ridges
};
/// Removes ridges in place. With crest_only or min_level a ridge is cut into the pieces that are
/// kept; their ends that are none of the ridge's are of kind cut.
FilterReport filter(RidgeGraph& graph, const FilterOptions& options);

/// Ends that are neither umbilic nor boundary (0 before a filter cuts ridges: theorem 2).
Index open_ends(const RidgeGraph& graph);

}  // namespace crest::ridges
