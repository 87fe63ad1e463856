// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "algorithms/extremal/pieces.hpp"

namespace crest::extremal {
namespace {

/// The samples as the certificate has them, where one is wanted.
certify::ExtremalData samples_of(const Volume& volume,
                                 const certify::ExtremalCertificate* certificate) {
  certify::ExtremalData r;
  if (certificate != nullptr) store_samples(volume, r);
  return r;
}

/// What is no longer needed is thrown away before the next step.
Result extract(Fields fields, const VolumeFrame& frame, const Options& options,
               certify::ExtremalCertificate* certificate, certify::ExtremalData samples) {
  const Meshes meshes{!options.critical || certificate != nullptr, options.critical};
  std::optional<Extraction> piece(std::in_place, std::move(fields), options);
  Records records = piece->records(meshes);
  fields = piece->take_fields();
  const kernel::GridPiece whole = piece->piece();
  piece.reset();
  Result result = assemble(
      frame, options, std::move(records),
      [&](std::span<const Vec3> places) { return values_at(fields, whole, places); }, certificate);
  if (certificate != nullptr) {
    certificate->data.type = samples.type;
    certificate->data.samples = std::move(samples.samples);
  }
  return result;
}

}  // namespace

Result extract(const Volume& volume, const Options& options,
               certify::ExtremalCertificate* certificate) {
  return extract(Fields(volume, options), {volume.size, volume.spacing, volume.origin}, options,
                 certificate, samples_of(volume, certificate));
}

Result extract(Volume&& volume, const Options& options, certify::ExtremalCertificate* certificate) {
  Fields fields(volume, options);
  certify::ExtremalData samples = samples_of(volume, certificate);
  const VolumeFrame frame{volume.size, volume.spacing, volume.origin};
  volume.samples = {};
  return extract(std::move(fields), frame, options, certificate, std::move(samples));
}

}  // namespace crest::extremal
