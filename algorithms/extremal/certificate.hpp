// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 8 of what was extracted (certify/extremal/SPEC.md).
#include "algorithms/extremal/assembly.hpp"
#include "certify/extremal/records.hpp"

namespace crest::extremal {

/// The data section without the samples. `grid`: the samples'.
certify::ExtremalData data_of(const Grid& grid, const Options& options);
/// Sets the samples, of the narrowest type that holds them all.
void store_samples(const Volume& volume, certify::ExtremalData& data);
/// The same of a volume in slabs, in the order of its samples, each of which is read twice.
void store_samples(const std::vector<kernel::GridBox>& slabs,
                   const std::function<Volume(const kernel::GridBox&)>& read,
                   certify::ExtremalData& data);

/// All but the data section. `mesh` is that of extremal edges. Takes the cells of the assembly.
void record_claims(Assembly& assembly, const MeasuredMesh& mesh, certify::ExtremalCertificate& c);

}  // namespace crest::extremal
