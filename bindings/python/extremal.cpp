// SPDX-License-Identifier: GPL-3.0-or-later
// crest extremal.
#include "algorithms/extremal/extremal.hpp"

#include <algorithm>

#include "algorithms/extremal/sampled_grid.hpp"
#include "bindings/python/systems.hpp"
#include "bindings/python/volume.hpp"
#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "io/extremal/extremal_writer.hpp"

namespace crest::python {
namespace {

extremal::Options options_of(const Arguments& a) {
  extremal::Options options;
  options.definition = a.text("definition") == "hessian" ? extremal::Definition::hessian
                                                         : extremal::Definition::structure;
  options.side = a.flag("valley") ? extremal::Side::valley : extremal::Side::ridge;
  options.sigma = a.number("sigma");
  options.tensor_sigma = a.maybe_number("tensor_sigma");
  options.min_value = a.maybe_number("min_value");
  options.min_strength = a.number("min_strength");
  options.critical = a.flag("critical");
  options.refine = a.integer("refine");
  return options;
}

void fill(const extremal::Result& result, const std::string& digest, Output& out) {
  out.geometries["geometry"] = io::geometry_of(io::extremal_poly_data(result, digest));
  out.values["h"] = result.h;
  out.values["undecided"] = static_cast<std::int64_t>(result.undecided.size());
  out.values["data_digest"] = digest;
}

}  // namespace

Output run_extremal(const Arguments& a, const Progress& progress) {
  kernel::SampledGrid grid = grid_of(a);
  certify::ExtremalCertificate record;
  const bool certify = a.flag("certificate");
  extremal::Result result = progress.step("extremal surface", [&] {
    return extremal::extract(extremal::volume_of(grid), options_of(a), certify ? &record : nullptr);
  });
  extremal::move_to_world(grid, result);
  grid.samples = {};
  Output out;
  std::string digest;
  if (certify) {
    progress.step("composing the certificate", [&] {
      auto bytes = certify::encode(record);
      record = {};  // the checker takes as much memory as the extraction did
      const certify::Verdict verdict = certify::verify(bytes);
      if (verdict.accepted)
        digest = out.certify(std::move(bytes));
      else
        out.warnings.push_back("no certificate, its checker does not accept it: " + verdict.reason);
    });
  }
  fill(result, digest, out);
  return out;
}

Output run_extremal_points(const Arguments& a, const Progress& progress) {
  const extremal::OrientedPoints points{a.rows<3>("points"), a.rows<3>("normals")};
  const extremal::PointOptions options{a.maybe_number("radius"), a.integer("depth"),
                                       a.flag("critical")};
  const extremal::Result result =
      progress.step("surface of the points", [&] { return extremal::extract(points, options); });
  Output out;
  fill(result, "", out);
  return out;
}

}  // namespace crest::python
