// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/pieces.hpp"

#include <algorithm>

namespace crest::extremal {
namespace {

/// The fields of all of a piece's nodes.
Fields fields_of(const Volume& part, const kernel::GridPiece& piece, const Options& options) {
  return {part, options, as_node(piece.all.low)};
}

}  // namespace

Volume part_of(const Volume& volume, const kernel::GridBox& box) {
  Volume r{box.size(), volume.spacing, volume.origin, {}};
  std::visit(
      [&](const auto& samples) {
        std::decay_t<decltype(samples)> part;
        part.reserve(box.nodes());
        for (Index z = box.low[2]; z < box.high[2]; ++z)
          for (Index y = box.low[1]; y < box.high[1]; ++y) {
            const auto row =
                samples.begin() +
                static_cast<std::ptrdiff_t>((std::size_t{z} * volume.size[1] + y) * volume.size[0]);
            part.insert(part.end(), row + box.low[0], row + box.high[0]);
          }
        r.samples = std::move(part);
      },
      volume.samples);
  return r;
}

kernel::GridPiece piece_of(const VolumeFrame& frame, const Options& options,
                           const kernel::GridBox& owned) {
  check_frame({frame.size, frame.spacing, frame.origin, {}}, options);
  return kernel::with_halo(frame.size, owned, halo_of(frame.grid(), options));
}

Records records_of(const Volume& part, const kernel::GridPiece& piece, const Options& options,
                   const Meshes& meshes) {
  return Extraction(fields_of(part, piece, options), options, piece).records(meshes);
}

std::vector<AtPlace> values_of(const Volume& part, const kernel::GridPiece& piece,
                               const Options& options, std::span<const Vec3> places) {
  return values_at(fields_of(part, piece, options), refined(piece, options.refine), places);
}

Owners::Owners(const VolumeFrame& frame, const Options& options, std::vector<kernel::GridBox> owned)
    : levels_(options.refine), owned_(std::move(owned)) {
  size_ = refined(kernel::whole_grid(frame.size), levels_).size;
}

std::size_t Owners::of(const Vec3& place) const {
  const Node cell = owner_of(size_, place);
  kernel::GridSize v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = static_cast<Index>(cell[k] >> levels_);
  const auto at = std::find_if(owned_.begin(), owned_.end(),
                               [&](const kernel::GridBox& box) { return box.has(v); });
  return static_cast<std::size_t>(at - owned_.begin());
}

Result assemble(const VolumeFrame& frame, const Options& options, Records joined,
                const ValuesAt& values, certify::ExtremalCertificate* certificate) {
  Assembly assembly(refined(frame.grid(), options.refine), options, std::move(joined));
  MeasuredMesh mesh = assembly.mesh(options.critical);
  if (certificate != nullptr) {
    certificate->data = data_of(frame.grid(), options);
    // Not by ?:, which would copy the mesh, the largest of all that there is by now.
    if (options.critical)
      record_claims(assembly, assembly.mesh(false), *certificate);
    else
      record_claims(assembly, mesh, *certificate);
  }
  assembly.drop_faces();
  return assembly.result(std::move(mesh), values);
}

Result extract_in_pieces(const VolumeFrame& frame, const Options& options,
                         const std::vector<kernel::GridBox>& owned, const ReadBox& read,
                         certify::ExtremalCertificate* certificate) {
  const Meshes meshes{!options.critical || certificate != nullptr, options.critical};
  std::vector<Records> records;
  for (const kernel::GridBox& box : owned) {
    const kernel::GridPiece piece = piece_of(frame, options, box);
    records.push_back(records_of(read(piece.all), piece, options, meshes));
  }
  const Owners owners(frame, options, owned);
  const auto values = [&](std::span<const Vec3> places) {
    std::vector<std::vector<std::size_t>> of_piece(owned.size());
    for (std::size_t i = 0; i < places.size(); ++i) of_piece[owners.of(places[i])].push_back(i);
    std::vector<AtPlace> r(places.size());
    for (std::size_t p = 0; p < owned.size(); ++p) {
      if (of_piece[p].empty()) continue;
      std::vector<Vec3> own;
      for (const std::size_t i : of_piece[p]) own.push_back(places[i]);
      const kernel::GridPiece piece = piece_of(frame, options, owned[p]);
      const auto got = values_of(read(piece.all), piece, options, own);
      for (std::size_t i = 0; i < got.size(); ++i) r[of_piece[p][i]] = got[i];
    }
    return r;
  };
  return assemble(frame, options, join(std::move(records)), values, certificate);
}

}  // namespace crest::extremal
