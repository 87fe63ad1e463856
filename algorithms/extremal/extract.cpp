// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/pieces.hpp"

namespace crest::extremal {

Result extract(const Volume& volume, const Options& options,
               certify::ExtremalCertificate* certificate) {
  const Meshes meshes{!options.critical || certificate != nullptr, options.critical};
  std::optional<Extraction> piece(std::in_place, Fields(volume, options), options);
  Records records = piece->records(meshes);
  const Fields fields = piece->take_fields();
  const kernel::GridPiece whole = piece->piece();
  piece.reset();
  Result result = assemble(
      {volume.size, volume.spacing, volume.origin}, options, std::move(records),
      [&](std::span<const Vec3> places) { return values_at(fields, whole, places); }, certificate);
  if (certificate != nullptr) store_samples(volume, certificate->data);
  return result;
}

}  // namespace crest::extremal
