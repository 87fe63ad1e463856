// SPDX-License-Identifier: GPL-3.0-or-later
// What needs no cleaning is told from what does, and gets the same mesh and the same counts.
#include "io/clean/sound_mesh.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "tests/io/clean_soups.hpp"
#include "tests/support/random.hpp"

using namespace crest::tests;
using crest::io::CleanOptions;
using crest::io::sound_mesh;

namespace {

/// Whether cleaning has nothing to do, though it may see something.
bool changes_nothing(const Soup& soup, const Cleaned& cleaned) {
  CleanUp done = cleaned.done;
  done.coincident_vertices = done.inside_out_parts = 0;
  return cleaned.error.empty() && words(done).empty() && cleaned.surface.points == soup.points &&
         cleaned.surface.faces.size() == soup.cells.size();
}

/// Returns whether the soup is sound.
bool check(const Soup& soup) {
  CleanUp done;
  const auto mesh = sound_mesh(soup, {}, done);
  const Cleaned slow = cleaned(soup);
  CHECK(mesh.has_value() == changes_nothing(soup, slow));
  if (!mesh) return false;
  CHECK(mesh->points() == slow.surface.points);
  CHECK(mesh->faces() == slow.surface.faces);
  CHECK(words(done) == words(slow.done));
  CHECK(done.inside_out_parts == slow.done.inside_out_parts);
  CHECK(done.coincident_vertices == slow.done.coincident_vertices);
  return true;
}

/// Copies of tetrahedra with or without their last face, turned over or not, at few places.
Soup random_parts(Random& random) {
  std::vector<Vec3> points;
  std::vector<Face> faces;
  for (std::size_t part = 0, parts = 1 + random() % 4; part < parts; ++part) {
    const auto base = static_cast<crest::io::Cells::Node>(points.size());
    const double at = static_cast<double>(random() % 3);
    for (const Vec3& p : kTetrahedronPoints) points.push_back({p[0] + at, p[1], p[2]});
    const bool over = random() % 2 == 0;
    for (std::size_t f = 0, many = 4 - random() % 2; f < many; ++f) {
      Face face = kTetrahedronFaces[f];
      for (auto& v : face) v += base;
      if (over) std::swap(face[1], face[2]);
      faces.push_back(face);
    }
  }
  return soup_of(points, faces);
}

/// One thing that is wrong with it, or nothing.
void damage(Soup& soup, Random& random) {
  std::vector<Face> faces;
  for (std::size_t c = 0; c < soup.cells.size(); ++c)
    faces.emplace_back(soup.cells.nodes(c).begin(), soup.cells.nodes(c).end());
  Face& face = faces[random() % faces.size()];
  switch (random() % 8) {
    case 0:
      std::swap(face[0], face[1]);
      break;
    case 1:
      face[0] = face[1];
      break;
    case 2:
      faces.push_back(face);
      break;
    case 3:
      soup.points.push_back({7, 7, 7});
      break;
    case 4:
      face[random() % 3] = static_cast<crest::io::Cells::Node>(random() % soup.points.size());
      break;
    case 5:
      soup.points[random() % soup.points.size()] = soup.points[0];
      break;
    case 6:
      soup.points[random() % soup.points.size()][0] = NAN;
      break;
    default:
      break;
  }
  soup = soup_of(soup.points, faces);
}

}  // namespace

TEST_CASE("sound meshes are those that cleaning does not change, with the same counts") {
  Random random(kSeed);
  std::size_t sound = 0;
  for (std::uint64_t trial = 0; trial < scaled(4000); ++trial) {
    Soup soup = random_parts(random);
    if (trial % 2 == 1) damage(soup, random);
    INFO("trial " << trial);
    sound += check(soup) ? 1 : 0;
  }
  CHECK(sound > scaled(2000));
  CHECK(sound < scaled(3500));
}

TEST_CASE("what options would change is not sound, nor are polygons, strips and missing points") {
  const Soup soup = soup_of(kTetrahedronPoints, kTetrahedronFaces);
  CleanUp done;
  CHECK(sound_mesh(soup, {}, done));
  CHECK(sound_mesh(soup, {.split = true}, done));
  CHECK_FALSE(sound_mesh(soup, {.weld = 0}, done));
  CHECK_FALSE(sound_mesh(soup, {.outward = true}, done));
  CHECK_FALSE(
      sound_mesh(soup_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}), {}, done));
  CHECK_FALSE(sound_mesh(soup_of(kTetrahedronPoints, {{0, 1, 4}}), {}, done));
  CHECK_FALSE(sound_mesh(soup_of(kTetrahedronPoints, {{0, 1, -1}}), {}, done));
  CHECK_FALSE(sound_mesh(Soup{}, {}, done));
}
