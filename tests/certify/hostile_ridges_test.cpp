// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 1 on small meshes with numbers that no one would measure: what is accepted says what
// SPEC.md says of its data, by a count of its own.
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <set>

#include "certify/features_mesh/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify/recount_ridges.hpp"
#include "tests/certify/reeb_samples.hpp"
#include "tests/certify/reference_ridges.hpp"
#include "tests/support/failures.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using u32 = std::uint32_t;
using Monge = std::array<double, 14>;

template <std::size_t N>
double pick(const double (&numbers)[N], Random& random) {
  return numbers[random() % N];
}

/// Of every size that a double has, often the same.
double wild(Random& random) {
  static constexpr double kNumbers[] = {0,       1,           -1,          2,        0.5,    1e308,
                                        -1e308,  5e-324,      -5e-324,     0x1p-537, 1e-160, 1e160,
                                        0x1p-52, 1 + 0x1p-52, 1 - 0x1p-53, 0x1p-1022};
  return random() % 3 ? pick(kNumbers, random) : uniform(random);
}

/// Turns faces so that neighbours agree; false if that cannot be.
bool orient(Faces& faces) {
  std::vector<int> done(faces.size(), 0);
  for (std::size_t seed = 0; seed < faces.size(); ++seed) {
    if (done[seed]) continue;
    std::vector<std::size_t> stack = {seed};
    done[seed] = 1;
    while (!stack.empty()) {
      const auto f = faces[stack.back()];
      stack.pop_back();
      for (std::size_t g = 0; g < faces.size(); ++g)
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            const u32 a = f[i], b = f[(i + 1) % 3];
            const bool same = faces[g][j] == a && faces[g][(j + 1) % 3] == b && faces[g] != f;
            const bool other = faces[g][j] == b && faces[g][(j + 1) % 3] == a;
            if (same && done[g]) return false;
            if (same) std::swap(faces[g][1], faces[g][2]);
            if ((same || other) && !done[g]) {
              done[g] = 1;
              stack.push_back(g);
            }
          }
    }
  }
  return true;
}

enum class Numbers { plain, integers, wild, half_turns, needles, count };

void draw_positions(MeshData& data, Numbers kind, Random& random) {
  for (auto& p : data.positions)
    for (double& x : p) {
      x = uniform(random);
      if (kind == Numbers::integers) x = static_cast<double>(random() % 3) - 1;
      if (kind == Numbers::wild) x = wild(random);
      // Close to a line far away: angles down to 2^-240.
      if (kind == Numbers::needles)
        x = &x == p.data() ? std::ldexp(uniform(random), static_cast<int>(random() % 120))
                           : std::ldexp(uniform(random), -static_cast<int>(random() % 120));
    }
}

Monge frame(Numbers kind, Random& random) {
  Monge m{};
  for (double& x : m) x = kind == Numbers::wild ? wild(random) : uniform(random);
  if (kind == Numbers::integers)
    for (double& x : m) x = static_cast<double>(random() % 3) - 1;
  if (kind == Numbers::half_turns) {
    // On the plane z = 0, up or down: rotations by half a turn and a little, more or less than the
    // 2^-200 that decides.
    const int bits = static_cast<int>(random() % 31) + (random() % 2 ? 160 : 210);
    const double little = std::ldexp(random() % 2 ? 1 : -1, -bits);
    const bool along = random() % 2;
    m[0] = along ? 1 : little, m[1] = along ? little : 1, m[2] = 0;
    m[3] = 0, m[4] = 0, m[5] = random() % 2 ? 1 : -1;
  }
  if (random() % 8 == 0) std::copy(m.begin(), m.begin() + 3, m.begin() + 3);
  if (random() % 8 == 0) m[7] = m[6];
  if (random() % 8 == 0) m[8 + random() % 6] = 0;
  if (m[6] < m[7]) std::swap(m[6], m[7]);
  for (double& x : m) x += 0.0;
  return m;
}

MeshData draw_data(const ReebSurface& surface, Numbers kind, Random& random) {
  MeshData data;
  data.faces = surface.faces;
  data.positions.resize(surface.vertices);
  draw_positions(data, kind, random);
  if (kind == Numbers::half_turns)
    for (auto& p : data.positions) p[2] = 0;
  for (std::size_t v = 0; v < surface.vertices; ++v) data.monge.push_back(frame(kind, random));
  return data;
}

/// The numbers a certificate states, in the order of the claim section.
std::vector<u32*> numbers_of(RidgesMeshCertificate& c) {
  return {&c.boundary_loops,        &c.conflict_triangles,    &c.ambiguous_edges,
          &c.zero_extremalities[0], &c.zero_extremalities[1], &c.against_faces,
          &c.equal_curvatures,      &c.parallel_frames};
}

void check_recount(RidgesMeshCertificate c, const RidgesRecount& truth) {
  const std::vector<u32> found = {truth.boundary_loops,        truth.conflict_triangles,
                                  truth.ambiguous_edges,       truth.zero_extremalities[0],
                                  truth.zero_extremalities[1], truth.against_faces,
                                  truth.equal_curvatures,      truth.parallel_frames};
  std::vector<u32> stated;
  for (const u32* number : numbers_of(c)) stated.push_back(*number);
  CHECK(stated == found);
  CHECK(c.euler_characteristic == truth.euler_characteristic);
  CHECK(c.twice_index_sum == truth.twice_index_sum);
  std::vector<int> indices(c.data.faces.size(), 0);
  for (const auto& [f, twice] : c.face_indices) indices[f] = twice;
  CHECK(indices == truth.twice_index);
  for (const PatchRecord& patch : c.patches) CHECK(patch.centre == truth.central_face(patch.faces));
}

}  // namespace

TEST_CASE("what is accepted of small degenerate meshes is what a count of its own finds") {
  Random random(kSeed + 11);
  std::array<std::array<u32, 2>, 5> judged{};  // accepted, undecided by kind of numbers
  u32 lies = 0, frames = 0;
  for (std::uint64_t round = 0; round < scaled(6); ++round)
    for (ReebSurface surface : reeb_surfaces(random)) {
      if (!orient(surface.faces) || surface.faces.size() > 40) continue;
      for (std::size_t kind = 0; kind < static_cast<std::size_t>(Numbers::count); ++kind) {
        const MeshData data = draw_data(surface, static_cast<Numbers>(kind), random);
        const OnFailure shown([&] {
          return surface.name + ", kind " + std::to_string(kind) + ", round " +
                 std::to_string(round);
        });
        const ReferenceRidges ridges(data);
        if (!ridges.valid()) continue;
        const RidgesRecount truth(data);
        auto c = *ridges.certificate(round % 2 ? ridges.grown(6, random) : ridges.single_faces());
        check_recount(c, truth);
        const Verdict doubles = verify(encode(c)), mpfr = verify(encode(c), {Arithmetic::mpfr, {}});
        INFO(doubles.reason << " | " << mpfr.reason);
        CHECK((doubles.accepted || doubles.undecided));
        CHECK((mpfr.accepted || mpfr.undecided));
        ++judged[kind][doubles.accepted && mpfr.accepted ? 0 : 1];
        frames += c.against_faces + c.equal_curvatures + c.parallel_frames;
        for (u32* number : numbers_of(c)) {
          const u32 right = *number;
          for (const u32 wrong : {right + 1, right - 1, right + (1U << 31), ~right}) {
            *number = wrong;
            lies += verify(encode(c)).accepted;
          }
          *number = right;
        }
      }
    }
  std::cout << "claim 1 recounted, accepted and undecided by kind of numbers:";
  for (const auto& [accepted, undecided] : judged) std::cout << ' ' << accepted << '+' << undecided;
  std::cout << ", " << frames << " frames that no surface has\n";
  CHECK(lies == 0);
  for (const auto& [accepted, undecided] : judged) {
    CHECK(accepted > 0);
    CHECK(undecided == 0);
  }
}

TEST_CASE("a rotation nearer to a half turn than 2^-200 is +pi, from both sides") {
  // One triangle in the plane, the normal turned around at one corner: the rotations along its
  // sides are half a turn and t - u more, and u more.
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  data.faces = {{0, 1, 2}};
  data.monge = {{0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 1, 1},
                {1, 0, 0, 0, 0, -1, 1, 0, 1, 1, 1, 1, 1, 1},
                {0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 1, 1}};
  std::vector<int> indices;
  for (const int bits : {190, 198, 199, 202, 230, 260, 1000})
    for (const bool more : {true, false}) {
      data.monge[0][0] = std::ldexp(more ? 2 : 1, -bits);
      data.monge[1][1] = std::ldexp(more ? 1 : 2, -bits);
      INFO((more ? "+2^-" : "-2^-") << bits);
      const RidgesRecount truth(data);
      const ReferenceRidges ridges(data);
      const Bytes bytes = encode(*ridges.certificate(ridges.single_faces()));
      CHECK(ridges.twice_index() == truth.twice_index);
      CHECK(verify(bytes).accepted);
      CHECK(verify(bytes, {Arithmetic::mpfr, {}}).accepted);
      indices.push_back(truth.twice_index[0]);
    }
  // Beyond 2^-200 the sides differ, within they do not.
  CHECK(indices[0] != indices[1]);
  CHECK(indices[4] != indices[5]);
  CHECK(std::set<int>(indices.begin() + 6, indices.end()).size() == 1);
}

TEST_CASE("surfaces that cannot be oriented are no data of claims 1 and 2") {
  Random random(kSeed + 12);
  u32 refused = 0;
  for (ReebSurface surface : reeb_surfaces(random)) {
    if (orient(surface.faces)) continue;
    RidgesMeshCertificate c;
    c.data.faces = surface.faces;
    c.data.positions.resize(surface.vertices);
    draw_positions(c.data, Numbers::plain, random);
    for (std::size_t v = 0; v < surface.vertices; ++v)
      c.data.monge.push_back(frame(Numbers::plain, random));
    FeaturesMeshCertificate marks;
    marks.faces = surface.faces;
    marks.positions = c.data.positions;
    marks.marked_before.assign(surface.vertices, 0);
    for (const Bytes& bytes : {encode(c), encode(marks)})
      CHECK(verify(bytes).reason.find("disagree in orientation") != std::string::npos);
    ++refused;
  }
  CHECK(refused >= 4);
}
