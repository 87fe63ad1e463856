// SPDX-License-Identifier: GPL-3.0-or-later
// crest strips.
#include "algorithms/strips/strips.hpp"

#include <stdexcept>

#include "algorithms/strips/tree_links.hpp"
#include "algorithms/strips/vertex_cache.hpp"
#include "bindings/python/systems.hpp"
#include "io/strips/strip_writer.hpp"

namespace crest::python {

Output run_strips(const Arguments& a, const Progress& progress) {
  const kernel::TriangleMesh mesh = mesh_of(a);
  strips::StripOptions options;
  options.swaps = !a.flag("no_swaps");
  options.effort = a.integer("effort");
  const kernel::CornerTable table(mesh.vertex_count(), mesh.faces());
  const strips::Strips found = progress.step("joining faces", [&] {
    return strips::strips_of(table, mesh.faces(), strips::tree_links(table, mesh.faces()), options);
  });
  const strips::Strips ordered = progress.step("ordering strips", [&] {
    return strips::in_cache_order(found, mesh.vertex_count(), strips::kCacheEntries);
  });
  if (!progress.step("checking", [&] { return strips::covers(ordered, mesh.faces()); }))
    throw std::runtime_error("strips: they are not the faces of the mesh");
  Output out;
  out.geometries["geometry"] = io::geometry_of(io::strip_poly_data(mesh.points(), ordered));
  out.values["swaps"] = static_cast<std::int64_t>(ordered.swaps);
  out.values["acmr"] = strips::average_cache_miss_ratio(ordered, mesh.vertex_count(),
                                                        mesh.face_count(), strips::kCacheEntries);
  return out;
}

}  // namespace crest::python
