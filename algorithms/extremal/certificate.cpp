// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace crest::extremal {
namespace {

/// Appends the samples, little-endian, as numbers of type Stored.
template <class Stored, class Sample>
void append(const std::vector<Sample>& samples, std::vector<std::uint8_t>& to) {
  const std::size_t size = to.size();
  to.resize(size + samples.size() * sizeof(Stored));
  std::uint8_t* at = to.data() + size;
  for (const Sample x : samples) {
    const auto stored = static_cast<Stored>(x + Sample(0));  // No negative zero.
    std::memcpy(at, &stored, sizeof(Stored));
    at += sizeof(Stored);
  }
}

/// Finds the narrowest type that holds all samples.
class NarrowestType {
 public:
  void see(const Volume& volume) {
    std::visit([&](const auto& samples) { see(samples); }, volume.samples);
  }
  std::uint8_t type() const {
    if (fits_[0]) return 1;
    if (fits_[1]) return 2;
    if (fits_[2]) return 3;
    return is_double_ ? 9 : 8;
  }

 private:
  template <class Sample>
  void see(const std::vector<Sample>& samples) {
    is_double_ = sizeof(Sample) == 8;
    static constexpr double kLow[] = {0, -32768, 0}, kHigh[] = {255, 32767, 65535};
    for (std::size_t i = 0; i < 3; ++i)
      fits_[i] = fits_[i] && std::all_of(samples.begin(), samples.end(), [&](Sample x) {
                   return static_cast<double>(x) >= kLow[i] && static_cast<double>(x) <= kHigh[i] &&
                          std::floor(x) == x;
                 });
  }
  std::array<bool, 3> fits_{true, true, true};
  bool is_double_ = false;
};

void append(const Volume& volume, certify::ExtremalData& data) {
  std::visit(
      [&](const auto& samples) {
        using Sample = typename std::decay_t<decltype(samples)>::value_type;
        switch (data.type) {
          case 1:
            return append<std::uint8_t>(samples, data.samples);
          case 2:
            return append<std::int16_t>(samples, data.samples);
          case 3:
            return append<std::uint16_t>(samples, data.samples);
          default:
            return append<Sample>(samples, data.samples);
        }
      },
      volume.samples);
}

void record_edges(const Records& records, certify::ExtremalCertificate& c) {
  for (const Index e : records.bisected.edges) c.edges.push_back(e / 3 * c.data.dimension + e % 3);
  c.trees = records.bisected.trees;
  c.leaves = records.bisected.leaves;
  for (const CriticalRecord& e : records.critical)
    c.types.push_back(e.state == EdgeState::merely_critical
                          ? certify::extremal_code::kMerelyCritical
                      : e.state == EdgeState::extremal ? certify::extremal_code::kExtremalEdge
                                                       : certify::extremal_code::kUndecidedType);
  for (const FaceRecord& f : records.faces) {
    c.odd_faces += f.odd() ? 1 : 0;
    if (f.ambiguous()) c.pairings.push_back(f.swapped ? 1 : 0);
  }
}

void record_mesh(const Options& options, const MeasuredMesh& mesh,
                 certify::ExtremalCertificate& c) {
  for (const SheetVertex& v : mesh.sheets.vertices) c.vertices.push_back(v.place);
  if (options.min_value || options.min_strength > 0)
    for (const SheetPolygon& p : mesh.sheets.polygons) c.fan_points.push_back(p.place);
  const auto count = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
  c.valences.two = count(mesh.trimmed.valence[1]);
  c.valences.three = count(mesh.trimmed.valence[2]);
  for (std::size_t i = 0; i < 5; ++i) c.valences.one[i] = count(mesh.trimmed.reasons[i]);
  for (std::size_t i = 0; i < mesh.measured.components.size(); ++i) {
    const Component& from = mesh.measured.components[i];
    const ComponentProof& proof = mesh.measured.proofs[i];
    certify::ExtremalComponent to;
    to.polygons = count(proof.polygons);
    to.euler_characteristic = static_cast<std::int32_t>(from.euler_characteristic);
    to.loops = count(c.data.dimension == 2 ? from.ends : from.boundary_loops);
    to.orientable = from.orientable;
    to.isotopic = from.isotopic.value_or(false);
    to.extremal = proof.extremal;
    to.cut = proof.cut;
    c.components.push_back(to);
  }
}

}  // namespace

certify::ExtremalData data_of(const Grid& grid, const Options& o) {
  certify::ExtremalData d;
  d.dimension = static_cast<std::uint8_t>(grid.dimension());
  d.valley = o.side == Side::valley;
  d.hessian = o.definition == Definition::hessian;
  d.refine = static_cast<std::uint8_t>(o.refine);
  for (std::size_t k = 0; k < d.dimension; ++k) {
    d.nodes[k] = static_cast<std::uint32_t>(grid.size[k]);
    d.spacing[k] = grid.spacing[k];
  }
  d.has_min_value = o.min_value.has_value();
  d.min_value = o.min_value.value_or(0);
  d.min_strength = o.min_strength;
  d.sigma = o.sigma;
  d.tensor_sigma = o.tensor_sigma.value_or(o.sigma);
  d.weights = smoothing_weights(grid, d.sigma);
  d.tensor_weights = {{{1}, {1}, {1}}};
  if (!d.hessian) d.tensor_weights = smoothing_weights(grid, d.tensor_sigma);
  return d;
}

void store_samples(const Volume& volume, certify::ExtremalData& data) {
  NarrowestType narrowest;
  narrowest.see(volume);
  data.type = narrowest.type();
  append(volume, data);
}

void store_samples(const std::vector<kernel::GridBox>& slabs,
                   const std::function<Volume(const kernel::GridBox&)>& read,
                   certify::ExtremalData& data) {
  NarrowestType narrowest;
  for (const kernel::GridBox& slab : slabs) narrowest.see(read(slab));
  data.type = narrowest.type();
  std::size_t count = 0;
  for (const kernel::GridBox& slab : slabs) count += slab.nodes();
  data.samples.reserve(count * certify::extremal_code::kSampleSize[data.type]);
  for (const kernel::GridBox& slab : slabs) append(read(slab), data);
}

void record_claims(Assembly& assembly, const MeasuredMesh& mesh, certify::ExtremalCertificate& c) {
  record_edges(assembly.records(), c);
  record_mesh(assembly.options(), mesh, c);
  CellRecords cells = assembly.take_cells();
  c.cells = std::move(cells.runs);
  c.codes = std::move(cells.codes);
  c.directions = std::move(cells.directions);
  c.gradients = std::move(cells.gradients);
}

}  // namespace crest::extremal
