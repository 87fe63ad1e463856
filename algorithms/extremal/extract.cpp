// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/certificate.hpp"

namespace crest::extremal {

Result extract(const Volume& volume, const Options& options,
               certify::ExtremalCertificate* certificate) {
  const Extraction e(Fields(volume, options), options);
  const MeasuredMesh mesh = e.mesh(options.critical);
  if (certificate != nullptr)
    *certificate = make_certificate(volume, e, options.critical ? e.mesh(false) : mesh);
  return e.result(mesh);
}

}  // namespace crest::extremal
