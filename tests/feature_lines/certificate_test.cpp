// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 2: true certificates pass; mutants fail, resealed or rebound, unless they are true.
#include "algorithms/feature_lines/certificate.hpp"

#include <catch2/catch.hpp>
#include <iostream>

#include "certify/container/container.hpp"
#include "certify/features_mesh/decode.hpp"
#include "certify/verify.hpp"
#include "tests/feature_lines/meshes.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/failures.hpp"

using namespace crest::tests;
namespace fl = crest::feature_lines;
namespace cert = crest::certify;

namespace {

cert::FeaturesMeshCertificate decode(const cert::Bytes& bytes) {
  const auto container = cert::open_container(bytes);
  return cert::decode_features_mesh(container.data, container.claims);
}

bool same(const cert::BettiRecord& a, const Betti& b) {
  return a.euler == b.euler && a.components == b.b0 && a.loops == b.b1 && a.closed == b.b2;
}

/// The link of v, from the faces: the Betti numbers of the part with this mark are a point's.
bool link_is_point(const TriangleMesh& mesh, const Marks& marks, Index v, std::uint8_t mark) {
  std::set<Index> vertices;
  std::vector<std::set<Index>> edges;
  for (const Triangle& f : mesh.faces()) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (f[k] != v) continue;
      const Index a = f[(k + 1) % 3], b = f[(k + 2) % 3];
      if (marks[a] == mark) vertices.insert(a);
      if (marks[b] == mark) vertices.insert(b);
      if (marks[a] == mark && marks[b] == mark) edges.push_back({a, b});
    }
  }
  const Index rank = rank_mod_2(edges);
  return vertices.size() == rank + 1 && edges.size() == rank;
}

std::size_t marked_around(const TriangleMesh& mesh, const Marks& marks, Index v) {
  std::set<Index> around;
  for (const Triangle& f : mesh.faces()) {
    if (f[0] != v && f[1] != v && f[2] != v) continue;
    for (const Index w : f)
      if (w != v && marks[w]) around.insert(w);
  }
  return around.size();
}

/// The claim's truth from its definition, by brute force; nothing of the checker, no rings.
bool is_true(const cert::FeaturesMeshCertificate& c) {
  // The claim does not speak of positions: these have no degenerate triangle.
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < c.positions.size(); ++i) {
    const auto t = static_cast<double>(i);
    points.push_back({t, t * t, t * t * t});
  }
  TriangleMesh mesh;
  try {
    for (const Triangle& f : c.faces) {
      for (const Index v : f)
        if (v >= points.size()) return false;
    }
    mesh = TriangleMesh(points, c.faces);
  } catch (const std::exception&) {
    return false;
  }
  if (c.euler_characteristic != mesh.euler_characteristic()) return false;
  if (c.boundary_loops != mesh.boundary_loops()) return false;
  Marks marks = c.marked_before;
  for (const Index v : c.removed) {
    if (v >= marks.size() || !marks[v]) return false;
    if (!link_is_point(mesh, marks, v, 1) || !link_is_point(mesh, marks, v, 0)) return false;
    marks[v] = 0;
  }
  std::vector<Index> left;
  for (Index v = 0; v < marks.size(); ++v) {
    if (!marks[v]) continue;
    left.push_back(v);
    if (link_is_point(mesh, marks, v, 1) && link_is_point(mesh, marks, v, 0) &&
        marked_around(mesh, marks, v) != 1)
      return false;
  }
  if (left != c.marked_after) return false;
  for (std::size_t i = 0; i < c.dropped.size(); ++i) {
    const Index v = c.dropped[i];
    if (v >= marks.size() || !marks[v] || marked_around(mesh, marks, v) != 0) return false;
    if (i > 0 && c.dropped[i - 1] >= v) return false;
  }
  Marks lines = marks;
  for (const Index v : c.dropped) lines[v] = 0;
  return c.components == betti_by_ranks(mesh, lines, 1).b0 &&
         same(c.betti[0], betti_by_ranks(mesh, c.marked_before, 1)) &&
         same(c.betti[1], betti_by_ranks(mesh, c.marked_before, 0)) &&
         same(c.betti[2], betti_by_ranks(mesh, marks, 1)) &&
         same(c.betti[3], betti_by_ranks(mesh, marks, 0));
}

std::vector<cert::Bytes> originals() {
  std::vector<cert::Bytes> all;
  Random random(kSeed);
  for (const auto& [name, mesh] : sample_meshes()) {
    if (mesh.vertex_count() > 150) continue;  // the brute force is slow
    for (Index i = 0; i < 4; ++i) {
      const Marks region = random_marks(mesh, random, 0.1, i % 3);
      all.push_back(cert::encode(fl::make_certificate(mesh, fl::thin(mesh, region, i))));
    }
  }
  return all;
}

/// One record made wrong, or data exchanged.
void mutate(cert::FeaturesMeshCertificate& c, Random& random) {
  auto& list = random() % 2 ? c.removed : random() % 2 ? c.marked_after : c.dropped;
  const auto vertex = static_cast<Index>(random() % c.positions.size());
  switch (random() % 9) {
    case 8:
      random() % 2 ? ++c.components : --c.components;
      break;
    case 0:
      if (!list.empty()) list.erase(list.begin() + static_cast<long>(random() % list.size()));
      break;
    case 1:
      list.insert(list.begin() + static_cast<long>(random() % (list.size() + 1)), vertex);
      break;
    case 2:
      if (!list.empty()) list[random() % list.size()] = vertex;
      break;
    case 3:
      if (!list.empty()) std::swap(list[random() % list.size()], list[random() % list.size()]);
      break;
    case 4: {
      auto& b = c.betti[random() % 4];
      ++(random() % 3 == 0 ? b.components : random() % 2 ? b.loops : b.closed);
      if (random() % 2) b.euler += random() % 2 ? 1 : -1;
      break;
    }
    case 5:
      c.marked_before[vertex] ^= 1;
      break;
    case 6:
      std::swap(c.faces[random() % c.faces.size()][random() % 3],
                c.faces[random() % c.faces.size()][random() % 3]);
      break;
    default:
      random() % 2 ? ++c.boundary_loops : --c.boundary_loops;
      if (random() % 2) ++c.euler_characteristic;
  }
}

}  // namespace

TEST_CASE("certificates of thinnings are accepted under both arithmetics and true by brute force") {
  for (const cert::Bytes& bytes : originals()) {
    const auto verdict = cert::verify(bytes);
    INFO(verdict.reason);
    CHECK(verdict.accepted);
    CHECK(verdict.lines.size() == 5);
    CHECK(cert::verify(bytes, {cert::Arithmetic::mpfr, {}}).accepted);
    CHECK(is_true(decode(bytes)));
    CHECK(cert::encode(decode(bytes)) == bytes);
  }
}

TEST_CASE("edited claims and data are accepted only if true of their own data") {
  Random random(kSeed + 1);
  const auto all = originals();
  std::uint64_t mutants = 0, accepted = 0, resealed = 0;
  for (std::uint64_t i = 0; i < scaled(2000); ++i) {
    const cert::Bytes& original = all[random() % all.size()];
    auto c = decode(original);
    mutate(c, random);
    const cert::Bytes rebound = cert::encode(c);
    if (rebound == original) continue;
    ++mutants;
    const OnFailure shown([&] { return "mutant " + std::to_string(i); });
    // With the digest of the data it was made for, only the seal anew: other data are noticed.
    cert::Bytes sealed = rebound;
    std::copy(original.begin() + cert::kDigestOffset, original.begin() + cert::kLengthsOffset,
              sealed.begin() + cert::kDigestOffset);
    cert::reseal(sealed);
    if (cert::verify(sealed).accepted) {
      // Another order of the same removals, or another list of isolated points, can be true.
      CHECK(is_true(c));
      CHECK(c.marked_before == decode(original).marked_before);
      ++resealed;
    }
    const bool verdict = cert::verify(rebound).accepted;
    CHECK(verdict == is_true(c));
    accepted += verdict;
  }
  std::cout << "features-mesh: " << mutants << " edited records, " << accepted
            << " true and accepted, " << resealed << " of them true of the original data\n";
  CHECK(mutants > scaled(2000) / 2);
  CHECK(accepted * 5 < mutants);
}

TEST_CASE("edited bytes: resealed all rejected unless true, rebound only true ones accepted") {
  Random random(kSeed + 2);
  const auto all = originals();
  std::uint64_t mutants = 0, accepted = 0;
  for (std::uint64_t i = 0; i < scaled(2000); ++i) {
    cert::Bytes bytes = all[random() % all.size()];
    edit_bytes(bytes, random);
    ++mutants;
    const OnFailure shown([&] { return "mutant " + std::to_string(i); });
    cert::Bytes sealed = bytes;
    try {
      cert::reseal(sealed);
      cert::rebind(bytes);
    } catch (const std::invalid_argument&) {
      CHECK_FALSE(cert::verify(bytes).accepted);
      continue;
    }
    if (cert::verify(sealed).accepted) CHECK(is_true(decode(sealed)));
    if (!cert::verify(bytes).accepted) continue;
    ++accepted;
    CHECK(is_true(decode(bytes)));
  }
  std::cout << "features-mesh: " << mutants << " edited files, " << accepted
            << " accepted after rebinding, all true\n";
  CHECK(accepted > 0);  // a position moved: the claim does not speak of positions
}
