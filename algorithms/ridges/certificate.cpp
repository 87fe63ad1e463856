// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/certificate.hpp"

#include <utility>

#include "algorithms/ridges/pieces.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::ridges {
namespace {

/// As a certificate has it, with one form of zero.
std::array<double, 14> row_of(const kernel::MongeForm& m) {
  std::array<double, 14> row = {m.d1[0], m.d1[1], m.d1[2], m.n[0], m.n[1], m.n[2], m.k1,
                                m.k2,    m.b0,    m.b1,    m.b2,   m.b3,   m.c0,   m.c4};
  for (double& x : row) x += 0.0;
  return row;
}

certify::DataRows rows_of(const kernel::TriangleMesh& mesh,
                          const std::vector<kernel::MongeForm>& forms) {
  return {mesh.faces(), mesh.points(), [&forms](std::size_t v) { return row_of(forms[v]); }};
}

certify::MeshData data_of(const kernel::TriangleMesh& mesh,
                          const std::vector<kernel::MongeForm>& forms) {
  certify::MeshData data;
  data.faces = mesh.faces();
  data.positions = mesh.points();
  for (Vec3& p : data.positions)
    for (double& x : p) x += 0.0;
  for (const kernel::MongeForm& form : forms) data.monge.push_back(row_of(form));
  return data;
}

certify::RidgeRecord record_of(const Ridge& ridge) {
  certify::RidgeRecord r;
  r.flags = static_cast<std::uint8_t>((ridge.colour == Colour::red ? 1 : 0) | (ridge.loop ? 2 : 0));
  for (std::size_t i = 0; i < 2; ++i) {
    const bool at_umbilic = ridge.ends[i].kind == EndKind::umbilic;
    r.end_kind[i] = static_cast<std::uint8_t>(ridge.ends[i].kind);
    r.end_patch[i] = at_umbilic ? ridge.ends[i].umbilic : 0;
  }
  for (std::size_t i = 0; i < ridge.crossings.size(); ++i) {
    const unsigned segment =
        i < ridge.third_order.size() ? static_cast<unsigned>(ridge.third_order[i]) : 0;
    r.nodes.push_back(
        {ridge.crossings[i].edge,
         static_cast<std::uint8_t>(static_cast<unsigned>(ridge.crossings[i].type) | segment << 2)});
  }
  return r;
}

certify::RidgesMeshCertificate claims_of(const kernel::TriangleMesh& mesh,
                                         const RidgeGraph& graph) {
  certify::RidgesMeshCertificate c;
  c.euler_characteristic = mesh.euler_characteristic();
  c.boundary_loops = mesh.boundary_loops();
  c.twice_index_sum = graph.twice_index_sum;
  c.conflict_triangles = graph.conflict_triangles;
  c.ambiguous_edges = graph.ambiguous_edges;
  c.zero_extremalities = {graph.zero_extremalities[0], graph.zero_extremalities[1]};
  c.against_faces = graph.against_faces;
  c.equal_curvatures = graph.equal_curvatures;
  c.parallel_frames = graph.parallel_frames;
  for (const FaceIndex& i : graph.face_indices)
    c.face_indices.push_back({i.face, static_cast<std::int8_t>(i.twice_index)});
  for (const Umbilic& u : graph.umbilics)
    c.patches.push_back({u.face, static_cast<std::int8_t>(u.twice_index),
                         static_cast<std::uint8_t>(u.kind), static_cast<std::uint8_t>(u.coherent),
                         u.patch});
  for (const Ridge& r : graph.ridges) {
    ++c.counts[(r.colour == Colour::red ? 2u : 0u) + (r.loop ? 0u : 1u)];
    c.ridges.push_back(record_of(r));
  }
  return c;
}

}  // namespace

certify::RidgesMeshCertificate make_certificate(const kernel::TriangleMesh& mesh,
                                                const std::vector<kernel::MongeForm>& forms,
                                                const RidgeGraph& graph) {
  certify::RidgesMeshCertificate c = claims_of(mesh, graph);
  c.data = data_of(mesh, forms);
  return c;
}

ClaimedRidges extract_claimed(const kernel::TriangleMesh& mesh,
                              const std::vector<kernel::MongeForm>& forms,
                              const GraphOptions& options, PredicateReport* report,
                              const Workers* workers) {
  ClaimedRidges result;
  // Before the two threads: workers may be asked by the calling thread alone.
  const Decisions decided = decide_all(mesh, forms, options.guarded, workers);
  const certify::DataRows rows = rows_of(mesh, forms);
  kernel::parallel_invoke([&] { result.graph = graph_of(mesh, forms, options, decided, report); },
                          [&] { result.data_digest = certify::digest_of(rows); });
  result.envelope =
      certify::encode_envelope(claims_of(mesh, result.graph), rows, result.data_digest);
  return result;
}

void hand_on_certificate(const certify::Envelope& envelope, const kernel::TriangleMesh& mesh,
                         const std::vector<kernel::MongeForm>& forms,
                         const certify::TakePiece& take) {
  certify::hand_on(envelope, rows_of(mesh, forms), take);
}

CertifiedRidges extract_certified(const kernel::TriangleMesh& mesh,
                                  const std::vector<kernel::MongeForm>& forms,
                                  const GraphOptions& options, PredicateReport* report,
                                  const Workers* workers) {
  ClaimedRidges claimed = extract_claimed(mesh, forms, options, report, workers);
  CertifiedRidges result{std::move(claimed.graph), {}, claimed.data_digest};
  hand_on_certificate(claimed.envelope, mesh, forms, [&](std::span<const std::uint8_t> piece) {
    result.certificate.insert(result.certificate.end(), piece.begin(), piece.end());
  });
  return result;
}

}  // namespace crest::ridges
