// SPDX-License-Identifier: GPL-3.0-or-later
// Stream lines where no separatrix ends: they find orbits, and notice where one would be missing.
#include <catch2/catch.hpp>

#include "algorithms/sampling/planar_fields.hpp"
#include "algorithms/vector_fields/certificate.hpp"
#include "certify/verify.hpp"
#include "tests/vector_fields/counts.hpp"

using namespace crest;
using namespace crest::tests;
using namespace crest::vector_fields;

namespace {

/// Square rings |x|max = size around a hole, eight vertices each, v = strength x + (-y, x) / 2
/// (specification, "Refereed", 6).
PlanarField rings(const std::vector<Vec2>& size_and_strength) {
  const std::array<Vec2, 8> round = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  PlanarField field;
  for (const auto& [size, strength] : size_and_strength)
    for (const Vec2& r : round) {
      const Vec2 p = {size * r[0], size * r[1]};
      field.points.push_back(p);
      field.vectors.push_back({strength * p[0] - p[1] / 2, strength * p[1] + p[0] / 2});
    }
  for (Index ring = 0; ring + 1 < size_and_strength.size(); ++ring)
    for (Index i = 0; i < 8; ++i) {
      const Index a = 8 * ring + i, b = 8 * ring + (i + 1) % 8;
      field.triangles.push_back({a, a + 8, b + 8});
      field.triangles.push_back({a, b + 8, b});
    }
  return field;
}

bool accepted(const certify::SkeletonCertificate& record) {
  return certify::verify(certify::encode(record)).accepted;
}

/// The same with the disk inside the first ring around vertex 0; linear, zero at the origin.
PlanarField filled(const std::vector<Vec2>& size_and_strength) {
  PlanarField ring = rings(size_and_strength), field;
  const Vec2 p = {0.1, 0.05};
  const double strength = size_and_strength[0][1];
  field.points = {p};
  field.vectors = {{strength * p[0] - p[1] / 2, strength * p[1] + p[0] / 2}};
  field.points.insert(field.points.end(), ring.points.begin(), ring.points.end());
  field.vectors.insert(field.vectors.end(), ring.vectors.begin(), ring.vectors.end());
  for (Index i = 0; i < 8; ++i) field.triangles.push_back({0, i + 1, (i + 1) % 8 + 1});
  for (const auto& [a, b, c] : ring.triangles) field.triangles.push_back({a + 1, b + 1, c + 1});
  return field;
}

/// The claim that two fields on rings are equal, without lines and orbits. Both have the last
/// eight vertices, and the first ones of the input are the output's.
certify::CompressionCertificate emptied(const PlanarField& input, const PlanarField& output) {
  certify::CompressionCertificate c;
  extract_skeleton(input, c.input);
  extract_skeleton(output, c.output);
  const auto all = static_cast<std::uint32_t>(input.points.size());
  const auto kept = static_cast<std::uint32_t>(output.points.size()) - 8;
  for (std::uint32_t v = 0; v < all; ++v)
    if (v < kept || v + 8 >= all) c.vertices.push_back(v);
  for (std::uint32_t z = 0; z < c.input.zeros.size(); ++z) c.zeros.push_back(z);
  for (auto* s : {&c.input, &c.output}) {
    s->separatrices.clear();
    s->orbits.clear();
    s->ends = {};
  }
  return c;
}

/// At how many places no line looks, by the checker.
void require_silent(const certify::CompressionCertificate& c, int places) {
  const auto verdict = certify::verify(certify::encode(c));
  INFO(verdict.reason);
  REQUIRE(verdict.accepted);
  const std::string words =
      "at " + std::to_string(places) + " sinks, sources, sides of orbits and loops";
  CHECK(std::any_of(verdict.lines.begin(), verdict.lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  }));
}

}  // namespace

TEST_CASE("Skeletons: witnesses find orbits that no separatrix reaches") {
  certify::SkeletonCertificate record;
  const Skeleton s = extract_skeleton(rings({{1, 1}, {1.5, -0.5}, {2, 1}}), record);
  CHECK(s.critical_points.empty());
  CHECK(s.switch_points.empty());
  CHECK(s.separatrices.empty());
  REQUIRE(s.orbits.size() == 2);
  CHECK(s.orbits[0].attracting != s.orbits[1].attracting);
  // From both loops, and between the orbits.
  REQUIRE(s.witnesses.size() >= 4);
  for (const Separatrix& w : s.witnesses) CHECK(w.end == EndKind::closed_orbit);
  const auto verdict = certify::verify(certify::encode(record));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  // Without the ring between every line crosses.
  const Skeleton through = extract_skeleton(rings({{1, 1}, {2, 1}}));
  CHECK(through.orbits.empty());
  REQUIRE(through.witnesses.size() == 1);
  CHECK(through.witnesses[0].end == EndKind::boundary);
}

TEST_CASE("Skeletons: false witnesses are refused") {
  certify::SkeletonCertificate record;
  extract_skeleton(rings({{1, 1}, {1.5, -0.5}, {2, 1}}), record);
  const auto refused = [&](const auto& edit) {
    bool all = true;
    for (std::size_t i = 0; i < record.separatrices.size(); ++i) {
      auto other = record;
      edit(other.separatrices[i]);
      all = all && !accepted(other);
    }
    return all;
  };
  CHECK(refused([](auto& w) { w.to = 1 - w.to; }));
  CHECK(refused([](auto& w) { w.backward ^= 1U; }));
  CHECK(refused([](auto& w) { w.from = 3 * 32; }));
  CHECK(refused([](auto& w) { w.legs[0].corner += 3; }));
  CHECK(refused([](auto& w) { w.legs[0].turns.pop_back(); }));
  CHECK(refused([](auto& w) { w.origin = certify::SkeletonOrigin::zero; }));
  // The line through another vertex is another line.
  CHECK(refused([](auto& w) { w.from = w.from % 3 == 2 ? w.from - 2 : w.from + 1; }));
}

TEST_CASE("Compression: witnesses stay, and see an orbit that is missing") {
  // One sink, inflow all around: no separatrix at all, but a line through a vertex, both ways.
  PlanarField field = field_of(sampling::lattice_field(1, 12));
  for (std::size_t i = 0; i < field.points.size(); ++i) {
    const double x = field.points[i][0] - 0.47, y = field.points[i][1] - 0.52;
    field.vectors[i] = {-x - y / 2, x / 2 - y};
  }
  certify::CompressionCertificate record;
  const Compression c = compress(field, {}, record);
  INFO(c.difference);
  REQUIRE(c.same_skeleton);
  CHECK(c.before.separatrices.empty());
  CHECK(c.before.witnesses.size() == 2);
  CHECK(c.after.witnesses.size() == 2);
  CHECK(c.field.triangles.size() < field.triangles.size() / 4);
  const auto verdict = certify::verify(certify::encode(record));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  // Rings with two orbits against the same without the one between.
  certify::CompressionCertificate wrong;
  extract_skeleton(rings({{1, 1}, {1.5, -0.5}, {2, 1}}), wrong.input);
  extract_skeleton(rings({{1, 1}, {2, 1}}), wrong.output);
  for (std::uint32_t v = 0; v < 24; ++v)
    if (v / 8 != 1) wrong.vertices.push_back(v);
  wrong.input.separatrices.resize(1);
  wrong.input.orbits.resize(1);
  wrong.input.ends = {0, 0, 0, 1, 0};
  REQUIRE(accepted(wrong.input));
  REQUIRE(accepted(wrong.output));
  wrong.separatrices = {0};
  CHECK_FALSE(certify::verify(certify::encode(wrong)).accepted);
}

TEST_CASE("Compression: what no line looked at is said") {
  const PlanarField two = rings({{1, 1}, {1.5, -0.5}, {2, 1}}), none = rings({{1, 1}, {2, 1}});
  const auto bare = emptied(two, none);
  require_silent(bare, 2);
  // A line from a loop that is given up at once tells nothing.
  auto begun = bare;
  certify::SkeletonCertificate with, without;
  extract_skeleton(two, with);
  extract_skeleton(none, without);
  REQUIRE(without.separatrices.size() == 1);
  const auto start = [](const auto& s, const auto& line) {
    return s.positions[s.triangles[line.from / 3][line.from % 3]];
  };
  const auto same =
      std::find_if(with.separatrices.begin(), with.separatrices.end(), [&](const auto& line) {
        return start(with, line) == start(without, without.separatrices[0]) &&
               line.backward == without.separatrices[0].backward;
      });
  REQUIRE(same != with.separatrices.end());
  begun.input.separatrices = {*same};
  begun.output.separatrices = without.separatrices;
  for (auto* s : {&begun.input, &begun.output}) {
    auto& line = s->separatrices[0];
    line.legs.resize(1);
    line.legs[0].turns.clear();
    line.legs[0].exceptions.clear();
    line.end = certify::SkeletonEnd::undecided;
    line.to = 0;
    line.reason = certify::OpenReason::budget;
    s->ends = {0, 0, 0, 0, 1};
  }
  begun.separatrices = {0};
  require_silent(begun, 2);
  // A loop that v leaves along a side at its first vertex is one region like another.
  PlanarField along_in = two, along_out = none;
  along_in.vectors[16] = along_out.vectors[8] = {0, 1};
  require_silent(emptied(along_in, along_out), 2);
}

TEST_CASE("Compression: a line into a sink looks around it if followed both ways") {
  const PlanarField two = filled({{1, -1}, {1.5, 1}, {2, -1}}), none = filled({{1, -1}, {2, -1}});
  auto c = emptied(two, none);
  REQUIRE(c.zeros.size() == 1);
  require_silent(c, 2);
  certify::SkeletonCertificate whole;
  extract_skeleton(two, whole);
  const auto into =
      std::find_if(whole.separatrices.begin(), whole.separatrices.end(),
                   [](const auto& line) { return line.end == certify::SkeletonEnd::zero; });
  REQUIRE(into != whole.separatrices.end());
  REQUIRE(into->from < 24);  // of the disk, the same in both
  for (auto* s : {&c.input, &c.output}) {
    s->traps = whole.traps;
    s->separatrices = {*into};
    s->ends = {1, 0, 0, 0, 0};
  }
  c.separatrices = {0};
  require_silent(c, 2);
}
