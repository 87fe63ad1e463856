// SPDX-License-Identifier: GPL-3.0-or-later
// crest modes.
#include "algorithms/modes/modes.hpp"

#include <algorithm>
#include <stdexcept>

#include "algorithms/modes/certificate.hpp"
#include "algorithms/modes/curves_certificate.hpp"
#include "algorithms/modes/degenerate_curves.hpp"
#include "algorithms/modes/level_text.hpp"
#include "algorithms/modes/surface_geometry.hpp"
#include "bindings/python/systems.hpp"
#include "certify/modes_curves/encode.hpp"
#include "certify/verify.hpp"
#include "io/modes/mode_writer.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::python {
namespace {

std::vector<modes::SignedLevel> levels_of(const Arguments& a) {
  std::vector<modes::SignedLevel> levels;
  if (!a.has("mode")) return levels;
  for (const std::string& text : a.texts("mode")) {
    try {
      modes::SignedLevel level = modes::parse_level(text);
      if (!a.flag("signed")) level.sign = 0;
      const bool known = std::any_of(levels.begin(), levels.end(), [&](const auto& l) {
        return l.level.p == level.level.p && l.level.q == level.level.q && l.sign == level.sign;
      });
      if (!known) levels.push_back(level);
    } catch (const std::invalid_argument& error) {
      throw kernel::InputError(std::string("mode ") + error.what());
    }
  }
  return levels;
}

/// Claim 7, if its checker accepts it.
std::string certify_curves(const modes::ModeField& field, const modes::DegenerateCurves& curves,
                           Output& out) {
  auto bytes = certify::encode(
      modes::curves_certificate(field.mesh.points(), field.mesh.tets(), field.tensors, curves));
  const certify::Verdict verdict = certify::verify(bytes);
  if (verdict.accepted) return out.certify(std::move(bytes));
  out.warnings.push_back("no certificate of the curves, its checker does not accept it: " +
                         verdict.reason);
  return {};
}

void add_curves(const modes::ModeField& field, bool certify, const Progress& progress,
                io::ModeScene& scene, Output& out) {
  const modes::DegenerateCurves curves = progress.step("degenerate curves", [&] {
    return modes::degenerate_curves(field.mesh.points(), field.mesh.tets(), field.tensors);
  });
  scene.curves = curves.curves;
  out.values["undecided_curves"] =
      array_of(std::vector<kernel::Index>(curves.undecided.begin(), curves.undecided.end()));
  out.values["special"] =
      static_cast<std::int64_t>(curves.special_faces.size() + curves.special_tets.size());
  if (certify)
    scene.data_digest = progress.step("composing the certificate",
                                      [&] { return certify_curves(field, curves, out); });
}

/// The surfaces of one level into the scene, and its record unless another sign has brought it.
void add_level(const modes::ModeField& field, const modes::SignedLevel& wanted,
               const modes::ModeOptions& options, std::vector<certify::ModeLevel>& records,
               std::vector<kernel::Index>& undecided, io::ModeScene& scene) {
  certify::ModeLevel record;
  modes::ModeResult result = modes::extract(field, wanted.level, options, record);
  const bool known = std::any_of(records.begin(), records.end(), [&](const auto& r) {
    return r.numerator == record.numerator && r.denominator == record.denominator;
  });
  if (!known) records.push_back(std::move(record));
  for (modes::ModeSurface& surface : result.surfaces) {
    if (wanted.sign != 0 && surface.sign != wanted.sign) continue;
    modes::add_geometry(field, surface);
    scene.surfaces.push_back(std::move(surface));
  }
  undecided.insert(undecided.end(), result.undecided.begin(), result.undecided.end());
}

}  // namespace

Output run_modes(const Arguments& a, const Progress& progress) {
  const auto levels = levels_of(a);
  auto points = a.rows<3>("V");
  auto tets = a.cells<4>("T", points.size());
  modes::ModeField field{{std::move(points), std::move(tets)}, a.rows<6>("tensors")};
  modes::ModeOptions options;
  options.max_depth = a.integer("max_depth");
  options.budget = static_cast<std::uint64_t>(a.integer("budget"));
  options.deviation = a.number("deviation") * modes::diagonal(field);
  Output out;
  io::ModeScene scene;
  scene.min_magnitude = a.number("min_magnitude");
  const bool certify = a.flag("certificate");
  if (a.flag("degenerate")) add_curves(field, certify && levels.empty(), progress, scene, out);
  const modes::ZeroSet zeros =
      progress.step("looking for zeros", [&] { return modes::insert_zeros(field); });
  std::vector<certify::ModeLevel> records;
  std::vector<kernel::Index> undecided;
  for (const modes::SignedLevel& level : levels)
    progress.step("surfaces of a mode",
                  [&] { add_level(field, level, options, records, undecided, scene); });
  if (certify && !levels.empty())
    scene.data_digest = progress.step("composing the certificate", [&] {
      return out.certify(
          certify::encode(modes::make_certificate(field, zeros, std::move(records))));
    });
  out.geometries["geometry"] = io::geometry_of(io::mode_poly_data(scene));
  out.values["undecided"] = array_of(undecided);
  out.values["data_digest"] = scene.data_digest;
  return out;
}

}  // namespace crest::python
