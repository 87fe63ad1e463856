// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 5: true certificates pass; mutants fail, resealed or rebound, unless they are true.
#include <catch2/catch.hpp>
#include <iostream>

#include "algorithms/feature_lines/certificate.hpp"
#include "certify/container/container.hpp"
#include "certify/sharp_edges/decode.hpp"
#include "certify/verify.hpp"
#include "tests/feature_lines/meshes.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/failures.hpp"

using namespace crest::tests;
namespace fl = crest::feature_lines;
namespace cert = crest::certify;
using crest::kernel::DecimalAngle;

namespace {

cert::SharpEdgesCertificate certificate_of(const TriangleMesh& mesh, const std::string& degrees) {
  const DecimalAngle angle(degrees);
  return fl::make_certificate(mesh, angle, fl::extract_sharp_lines(mesh, angle, {}));
}

cert::SharpEdgesCertificate decode_sharp(const cert::Bytes& bytes) {
  const auto container = cert::open_container(bytes);
  return cert::decode_sharp_edges(container.data, container.claims);
}

using Edge = std::pair<Index, Index>;

/// Each edge's faces, from the faces alone.
std::map<Edge, std::vector<Index>> faces_of_edges(const std::vector<Triangle>& faces) {
  std::map<Edge, std::vector<Index>> sides;
  for (Index f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      sides[std::minmax(faces[f][k], faces[f][(k + 1) % 3])].push_back(f);
  return sides;
}

/// The angle of two faces in degrees, in long double: good to some 1e-15 on these meshes.
double angle_of(const cert::SharpEdgesCertificate& c, Index f, Index g) {
  using Vector = std::array<long double, 3>;
  const auto normal = [&](Index face) {
    Vector a, b;
    for (std::size_t i = 0; i < 3; ++i) {
      const long double at = c.positions[c.faces[face][0]][i];
      a[i] = c.positions[c.faces[face][1]][i] - at;
      b[i] = c.positions[c.faces[face][2]][i] - at;
    }
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Vector m = normal(f), n = normal(g);
  const Vector x = {m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2],
                    m[0] * n[1] - m[1] * n[0]};
  const auto dot = [](const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  return static_cast<double>(std::atan2(std::sqrt(dot(x, x)), dot(m, n)) * 180 /
                             3.141592653589793238462643383279502884L);
}

/// 1: above, -1: below, 0: equal, as far as 1e-11 degrees tell: on these meshes angles that near
/// are equal.
int compare(double angle, double degrees) {
  return std::abs(angle - degrees) < 1e-11 ? 0 : angle > degrees ? 1 : -1;
}

/// The claim's truth from its definition, without the checker or the producer.
bool is_true(const cert::SharpEdgesCertificate& c) {
  TriangleMesh mesh;
  try {
    for (const Triangle& f : c.faces)
      for (const Index v : f)
        if (v >= c.positions.size()) return false;
    mesh = TriangleMesh(c.positions, c.faces);
    const DecimalAngle angle(c.angle);
  } catch (const std::exception&) {
    return false;
  }
  if (c.euler_characteristic != mesh.euler_characteristic()) return false;
  if (c.boundary_loops != mesh.boundary_loops()) return false;
  const double degrees = std::stod(c.angle);
  std::vector<Index> sharp, group(c.faces.size());
  std::map<Index, Index> degree;
  for (Index f = 0; f < group.size(); ++f) group[f] = f;
  Index number = 0, ties = 0;
  for (const auto& [edge, faces] : faces_of_edges(c.faces)) {
    const Index e = number++;
    if (faces.size() != 2) continue;
    const int side = compare(angle_of(c, faces[0], faces[1]), degrees);
    ties += side == 0;
    if (side > 0) {
      sharp.push_back(e);
      ++degree[edge.first];
      ++degree[edge.second];
    } else {
      const Index from = group[faces[0]], to = group[faces[1]];
      std::replace(group.begin(), group.end(), from, to);
    }
  }
  Index ends = 0, nodes = 0;
  for (const auto& [v, n] : degree) {
    ends += n == 1;
    nodes += n >= 3;
  }
  return sharp == c.sharp && ties == c.ties && ends == c.ends && nodes == c.nodes &&
         std::set<Index>(group.begin(), group.end()).size() == c.patches;
}

std::vector<cert::Bytes> sharp_originals() {
  std::vector<cert::Bytes> all;
  for (const auto& [name, mesh] : sample_meshes()) {
    if (mesh.vertex_count() > 150) continue;
    for (const char* degrees : {"0.5", "20", "45", "60", "89.9", "90", "120"})
      all.push_back(cert::encode(certificate_of(mesh, degrees)));
  }
  return all;
}

/// One record made wrong, or data exchanged.
void mutate(cert::SharpEdgesCertificate& c, Random& random) {
  const auto at = [&](std::size_t size) { return static_cast<Index>(random() % size); };
  const auto step = [&](auto& number) { random() % 2 ? ++number : --number; };
  switch (random() % 10) {
    case 0:
      if (!c.sharp.empty()) c.sharp.erase(c.sharp.begin() + at(c.sharp.size()));
      break;
    case 1:
      c.sharp.insert(c.sharp.begin() + at(c.sharp.size() + 1), at(3 * c.faces.size() / 2));
      break;
    case 2:
      if (!c.sharp.empty()) c.sharp[at(c.sharp.size())] = at(3 * c.faces.size() / 2);
      break;
    case 3:
      if (!c.sharp.empty()) std::swap(c.sharp[at(c.sharp.size())], c.sharp[at(c.sharp.size())]);
      break;
    case 4:
      step(random() % 2 ? c.ends : c.nodes);
      break;
    case 5:
      step(random() % 2 ? c.patches : c.ties);
      break;
    case 6:
      c.positions[at(c.positions.size())][random() % 3] += random() % 2 ? 0.25 : 2.0;
      break;
    case 7:
      c.angle =
          std::vector<std::string>{"10",    "30", "45",  "90",   "90.",      "9",  "x",
                                   "1.2.3", "",   "200", "44.9", "89.99999", "060"}[random() % 13];
      break;
    case 8:
      std::swap(c.faces[at(c.faces.size())][random() % 3],
                c.faces[at(c.faces.size())][random() % 3]);
      break;
    default:
      step(c.boundary_loops);
      if (random() % 2) step(c.euler_characteristic);
  }
}

}  // namespace

TEST_CASE("certificates of sharp edges are accepted under both arithmetics and true") {
  for (const cert::Bytes& bytes : sharp_originals()) {
    const auto verdict = cert::verify(bytes);
    INFO(verdict.reason);
    CHECK(verdict.accepted);
    CHECK(verdict.lines.size() == 4);
    CHECK(cert::verify(bytes, {cert::Arithmetic::mpfr, {}}).accepted);
    CHECK(is_true(decode_sharp(bytes)));
    CHECK(cert::encode(decode_sharp(bytes)) == bytes);
  }
}

TEST_CASE("the checker of sharp edges and the producer agree where angles are near or equal") {
  // Corner (x, y) of the fold's second sheet: normals (0, 1) and (-y, x).
  for (const auto& [x, y, degrees, sharp, ties] :
       std::vector<std::tuple<double, double, const char*, int, int>>{
           {1, 1, "45", 0, 1},
           {1, 1, "44.99999999999999999999999999999999", 1, 0},
           {1, 1, "45.00000000000000000000000000000001", 0, 0},
           {2, 1, "26.565051177077989351572193720453", 1, 0},
           {2, 1, "26.565051177077989351572193720454", 0, 0},
           {0, 1, "90", 0, 1},
           {0x1p-80, 1, "90", 0, 0},
           {-0x1p-80, 1, "90", 1, 0},
           {-1, 1, "135", 0, 1},
           {1, 0, "0", 0, 1},
           {1, 0x1p-300, "0", 1, 0}}) {
    const TriangleMesh mesh({{0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {x, y, 0}}, {{0, 1, 2}, {1, 0, 3}});
    const auto c = certificate_of(mesh, degrees);
    INFO(x << " " << y << " " << degrees);
    CHECK(c.sharp.size() == static_cast<std::size_t>(sharp));
    CHECK(c.ties == static_cast<Index>(ties));
    const auto verdict = cert::verify(cert::encode(c));
    INFO(verdict.reason);
    CHECK(verdict.accepted);
    auto wrong = c;
    if (sharp)
      wrong.sharp.clear(), wrong.ends = 0, wrong.patches = 1;
    else
      wrong.sharp = {0}, wrong.ends = 2, wrong.patches = 2, wrong.ties = 0;
    CHECK_FALSE(cert::verify(cert::encode(wrong)).accepted);
  }
}

TEST_CASE("edited claims of sharp edges are accepted only if true of their own data") {
  Random random(kSeed + 11);
  const auto all = sharp_originals();
  std::uint64_t mutants = 0, accepted = 0;
  for (std::uint64_t i = 0; i < scaled(2500); ++i) {
    const cert::Bytes& original = all[random() % all.size()];
    auto c = decode_sharp(original);
    mutate(c, random);
    const cert::Bytes rebound = cert::encode(c);
    if (rebound == original) continue;
    ++mutants;
    const OnFailure shown([&] { return "mutant " + std::to_string(i); });
    // With the digest of the data it was made for: nothing else is true of them.
    cert::Bytes sealed = rebound;
    std::copy(original.begin() + cert::kDigestOffset, original.begin() + cert::kLengthsOffset,
              sealed.begin() + cert::kDigestOffset);
    cert::reseal(sealed);
    CHECK_FALSE(cert::verify(sealed).accepted);
    const bool verdict = cert::verify(rebound).accepted;
    CHECK(verdict == is_true(c));
    accepted += verdict;
  }
  std::cout << "sharp-edges: " << mutants << " edited records, " << accepted
            << " true of their own data and accepted\n";
  CHECK(mutants > scaled(2500) / 2);
  CHECK(accepted > 0);
  CHECK(accepted * 5 < mutants);
}

TEST_CASE("edited bytes of sharp edges: only true ones are accepted") {
  Random random(kSeed + 12);
  const auto all = sharp_originals();
  std::uint64_t mutants = 0, accepted = 0;
  for (std::uint64_t i = 0; i < scaled(2000); ++i) {
    cert::Bytes bytes = all[random() % all.size()];
    edit_bytes(bytes, random);
    ++mutants;
    const OnFailure shown([&] { return "mutant " + std::to_string(i); });
    try {
      cert::rebind(bytes);
    } catch (const std::invalid_argument&) {
      CHECK_FALSE(cert::verify(bytes).accepted);
      continue;
    }
    if (!cert::verify(bytes).accepted) continue;
    ++accepted;
    // Bits that move a point by less than the brute force can see are the checker's alone to judge.
    const auto c = decode_sharp(bytes);
    bool near = false;
    for (const auto& [edge, faces] : faces_of_edges(c.faces))
      near = near || (faces.size() == 2 &&
                      std::abs(angle_of(c, faces[0], faces[1]) - std::stod(c.angle)) < 1e-9);
    if (!near) CHECK(is_true(c));
  }
  std::cout << "sharp-edges: " << mutants << " edited files, " << accepted
            << " accepted after rebinding\n";
  CHECK(accepted > 0);
}
