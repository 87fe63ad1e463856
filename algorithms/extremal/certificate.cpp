// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace crest::extremal {
namespace {

/// Little-endian bytes of the samples as numbers of type Stored.
template <class Stored, class Sample>
std::vector<std::uint8_t> bytes_of(const std::vector<Sample>& samples) {
  std::vector<std::uint8_t> r(samples.size() * sizeof(Stored));
  std::uint8_t* to = r.data();
  for (const Sample x : samples) {
    const auto stored = static_cast<Stored>(x + Sample(0));  // No negative zero.
    std::memcpy(to, &stored, sizeof(Stored));
    to += sizeof(Stored);
  }
  return r;
}

/// The narrowest type that holds them all.
template <class Sample>
void store_samples(const std::vector<Sample>& samples, certify::ExtremalData& data) {
  const auto whole = [&](double low, double high) {
    return std::all_of(samples.begin(), samples.end(), [&](Sample x) {
      return static_cast<double>(x) >= low && static_cast<double>(x) <= high && std::floor(x) == x;
    });
  };
  if (whole(0, 255)) {
    data.type = 1;
    data.samples = bytes_of<std::uint8_t>(samples);
  } else if (whole(-32768, 32767)) {
    data.type = 2;
    data.samples = bytes_of<std::int16_t>(samples);
  } else if (whole(0, 65535)) {
    data.type = 3;
    data.samples = bytes_of<std::uint16_t>(samples);
  } else {
    data.type = sizeof(Sample) == 4 ? 8 : 9;
    data.samples = bytes_of<Sample>(samples);
  }
}

certify::ExtremalData data_of(const Volume& volume, const Extraction& e) {
  const Options& o = e.options();
  certify::ExtremalData d;
  d.dimension = static_cast<std::uint8_t>(volume.dimension());
  d.valley = o.side == Side::valley;
  d.hessian = o.definition == Definition::hessian;
  d.refine = static_cast<std::uint8_t>(o.refine);
  for (std::size_t k = 0; k < d.dimension; ++k) {
    d.nodes[k] = volume.size[k];
    d.spacing[k] = volume.spacing[k];
  }
  d.has_min_value = o.min_value.has_value();
  d.min_value = o.min_value.value_or(0);
  d.min_strength = o.min_strength;
  d.sigma = o.sigma;
  d.tensor_sigma = o.tensor_sigma.value_or(o.sigma);
  for (std::size_t k = 0; k < 3; ++k) {
    d.weights[k] = e.fields().scalar_weights()[k];
    d.tensor_weights[k] = {1};
    if (!d.hessian) d.tensor_weights[k] = e.fields().tensor_weights()[k];
  }
  std::visit([&](const auto& samples) { store_samples(samples, d); }, volume.samples);
  return d;
}

void record_cells(const Extraction& e, certify::ExtremalCertificate& c) {
  const Cells& cells = e.cells();
  const std::size_t count = e.fields().grid().nodes();
  for (std::size_t v = 0; v < count; ++v) {
    const CellState s = cells.state(v);
    if (s == CellState::unlisted) continue;
    const auto id = static_cast<std::uint32_t>(v);
    if (!c.cells.empty() && c.cells.back().first + c.cells.back().length == id)
      ++c.cells.back().length;
    else
      c.cells.push_back({id, 1});
    // By the definition by Hess regular cells prove nothing: they are said to pass the cone test.
    const bool regular = cells.regular(v) && !c.data.hessian;
    const bool cone = cells.regular(v) && c.data.hessian;
    c.codes.push_back(static_cast<std::uint8_t>(cone ? CellState::cone : s));
    if (s == CellState::open) continue;
    c.directions.push_back(cells.direction(v));
    if (regular) c.gradients.push_back(cells.proof(v).gradient);
  }
}

void record_edges(const Extraction& e, certify::ExtremalCertificate& c) {
  for (const BisectedEdge& b : e.edges().bisected()) {
    c.edges.push_back(b.edge / 3 * c.data.dimension + b.edge % 3);
    c.trees.insert(c.trees.end(), b.transport.tree.begin(), b.transport.tree.end());
    for (const Leaf& leaf : b.transport.leaves) c.leaves.push_back(leaf.w);
  }
  for (const CriticalEdge& critical : e.edges().critical_edges()) {
    const EdgeState s = e.edges().state(critical.edge);
    c.types.push_back(s == EdgeState::merely_critical ? certify::extremal_code::kMerelyCritical
                      : s == EdgeState::extremal      ? certify::extremal_code::kExtremalEdge
                                                      : certify::extremal_code::kUndecidedType);
  }
  const Grid& g = e.fields().grid();
  for (const Index f : crossed_faces(e.fields(), e.edges())) {
    const Face face = e.faces().face(g.node(f / 3), f % 3);
    c.odd_faces += face.odd() ? 1 : 0;
    if (face.ambiguous()) c.pairings.push_back(face.swapped ? 1 : 0);
  }
}

void record_mesh(const Extraction& e, const MeasuredMesh& mesh, certify::ExtremalCertificate& c) {
  for (const SheetVertex& v : mesh.sheets.vertices) c.vertices.push_back(v.place);
  if (e.options().min_value || e.options().min_strength > 0)
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

certify::ExtremalCertificate make_certificate(const Volume& volume, const Extraction& extraction,
                                              const MeasuredMesh& mesh) {
  certify::ExtremalCertificate c;
  c.data = data_of(volume, extraction);
  record_cells(extraction, c);
  record_edges(extraction, c);
  record_mesh(extraction, mesh, c);
  return c;
}

}  // namespace crest::extremal
