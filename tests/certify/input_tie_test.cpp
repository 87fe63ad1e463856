// SPDX-License-Identifier: GPL-3.0-or-later
// --input: which files hold the mesh of a certificate, and what is said of their orientation.
#include <catch2/catch.hpp>

#include "certify/verify.hpp"
#include "tests/certify/reference_ridges.hpp"
#include "tests/certify/sample_meshes.hpp"
#include "tests/support/environment.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

Bytes bytes_of(const MeshData& data) {
  const ReferenceRidges ridges(data);
  return encode(*ridges.certificate(ridges.single_faces()));
}

/// Faces first .. last - 1 turned around.
MeshData turned(MeshData data, std::size_t first, std::size_t last) {
  for (std::size_t f = first; f < last; ++f) std::swap(data.faces[f][1], data.faces[f][2]);
  return data;
}

Verdict compare(const Bytes& certificate, const MeshData& with) {
  VerifyOptions options;
  options.input = InputMesh{"mesh.off", with.positions, with.faces};
  const Verdict verdict = verify(certificate, options);
  return verdict;
}

void check_words(const Verdict& verdict, const std::string& words) {
  INFO(verdict.reason);
  REQUIRE(verdict.accepted);
  REQUIRE(verdict.lines.size() == 7);
  INFO(verdict.lines[1]);
  CHECK(verdict.lines[1].find("the same positions and faces, " + words +
                              "; nothing ties the Monge data to it") != std::string::npos);
}

}  // namespace

TEST_CASE("a file's orientation is compared by component and said") {
  const MeshData one = ellipsoid(2, 1, 1.5, 2);
  const std::size_t n = one.faces.size();
  const Bytes certificate = bytes_of(one);
  check_words(compare(certificate, one), "oriented as in the file");
  MeshData rotated = one;
  for (auto& f : rotated.faces) f = {f[1], f[2], f[0]};
  check_words(compare(certificate, rotated), "oriented as in the file");
  check_words(compare(certificate, turned(one, 0, n)), "re-oriented 1 of 1 components");
  check_words(compare(certificate, turned(one, 0, 100)),
              "re-oriented 100 faces of 1 components that the file does not orient alike");

  MeshData two = one;
  const auto shift = static_cast<std::uint32_t>(one.positions.size());
  for (const auto& f : one.faces) two.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  for (const auto& p : one.positions) two.positions.push_back({p[0] + 9, p[1], p[2]});
  two.monge.insert(two.monge.end(), one.monge.begin(), one.monge.end());
  const Bytes of_two = bytes_of(two);
  check_words(compare(of_two, turned(two, n, 2 * n)), "re-oriented 1 of 2 components");
  check_words(compare(of_two, turned(two, 0, n + 3)),
              "re-oriented 1 of 2 components and 3 faces of 1 components that the file does not "
              "orient alike");
}

TEST_CASE("another mesh is rejected") {
  MeshData data = ellipsoid(1, 1, 1.5, 2);
  data.positions[3][0] = 0;
  const Bytes certificate = bytes_of(data);
  MeshData other = data;
  other.positions[3][0] = 5e-324;
  CHECK(compare(certificate, other).reason.find("vertex 3 is elsewhere") != std::string::npos);
  other = data;
  std::swap(other.faces[0], other.faces[1]);
  CHECK(compare(certificate, other).reason.find("face 0 has other corners") != std::string::npos);
}
