// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 10: the order in which lines arrive at a sink or source inside an edge.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "algorithms/vector_fields/certificate.hpp"
#include "certify/compression/bijection.hpp"
#include "certify/verify.hpp"
#include "tests/vector_fields/counts.hpp"

using namespace crest;
using namespace crest::tests;
using namespace crest::vector_fields;
using kernel::cross;
using kernel::dot;
using kernel::operator-;
using u32 = std::uint32_t;

namespace {

struct EdgeZero {
  u32 zero = 0;
  Vec2 at, p, q;  ///< the edge's ends
};

/// One zero inside a triangle moved to the middle of a side: opposite vectors at its ends.
std::optional<PlanarField> moved_to_side(const PlanarField& field, const CriticalPoint& zero,
                                         std::size_t side) {
  if (zero.where != ZeroPlace::triangle ||
      (zero.kind != ZeroKind::sink && zero.kind != ZeroKind::source))
    return std::nullopt;
  const auto& t = field.triangles[zero.simplex];
  PlanarField result = field;
  const Vec2 v = field.vectors[t[side]];
  result.vectors[t[(side + 1) % 3]] = {-v[0], -v[1]};
  return result;
}

/// Where a line comes into the two triangles at the edge for the last time.
Vec2 last_entry(const Separatrix& s, const EdgeZero& z) {
  const Vec2 e = z.q - z.p;
  for (std::size_t i = s.line.size(); i-- > 0;) {
    const Vec2 d = s.line[i] - z.p;
    if (std::fabs(cross(e, d)) > 1e-9 * dot(e, e)) return s.line[i];
  }
  return s.line.front();
}

/// The lines by the angle, seen from the zero, at which they come in.
std::vector<u32> by_angle(const Skeleton& s, const EdgeZero& z) {
  std::vector<std::pair<double, u32>> lines;
  for (u32 i = 0; i < s.separatrices.size() + s.witnesses.size(); ++i) {
    const std::size_t n = s.separatrices.size();
    const Separatrix& line = i < n ? s.separatrices[i] : s.witnesses[i - n];
    if (line.end != EndKind::critical_point || line.target != z.zero) continue;
    const Vec2 d = last_entry(line, z) - z.at;
    lines.push_back({std::atan2(d[1], d[0]), i});
  }
  std::sort(lines.begin(), lines.end());
  std::vector<u32> result;
  for (const auto& [angle, line] : lines) result.push_back(line);
  return result;
}

/// Claim 10 of a field and itself, as far as to its arrivals.
class Arrived {
 public:
  explicit Arrived(const certify::SkeletonCertificate& record)
      : proof_(record), sign_(certify::Arithmetic::doubles) {
    certify::Verdict verdict;
    prove_surface(proof_, sign_, verdict);
    prove_skeleton(proof_, sign_, certify::Arithmetic::doubles, verdict);
    std::vector<u32> all(record.positions.size());
    for (u32 i = 0; i < all.size(); ++i) all[i] = i;
    match_.emplace(certify::compression::match_surfaces(all, proof_, proof_, sign_));
    match_boundary(*match_);
    orbits_ = certify::compression::find_orbits(proof_, sign_);
    table = certify::compression::find_arrivals(proof_, orbits_, sign_);
    maps_.emplace(certify::compression::Maps{identity(record.zeros.size()),
                                             identity(record.orbits.size()),
                                             identity(record.separatrices.size())});
  }
  void check(const certify::compression::ArrivalTable& other) const {
    check_arrivals(*match_, table, other, *maps_);
  }
  certify::compression::ArrivalTable table;

 private:
  static certify::compression::Map identity(std::size_t n) {
    std::vector<u32> list(n);
    for (u32 i = 0; i < n; ++i) list[i] = i;
    return certify::compression::Map(list, n, "numbers");
  }
  certify::compression::Proof proof_;
  certify::SignLadder sign_;
  std::optional<certify::compression::Match> match_;
  std::vector<certify::compression::Orbit> orbits_;
  std::optional<certify::compression::Maps> maps_;
};

/// The zero inside an edge, if three lines arrive there.
std::optional<EdgeZero> busy_edge(const PlanarField& field, const Skeleton& s) {
  for (u32 z = 0; z < s.critical_points.size(); ++z) {
    const CriticalPoint& item = s.critical_points[z];
    if (item.where != ZeroPlace::edge) continue;
    const auto& t = field.triangles[item.simplex / 3];
    const EdgeZero edge{z, item.point, field.points[t[item.simplex % 3]],
                        field.points[t[(item.simplex + 1) % 3]]};
    if (by_angle(s, edge).size() >= 3) return edge;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("Compression: lines arrive at a sink inside an edge in the order of their angles") {
  std::size_t places = 0;
  for (std::uint64_t seed = 3; seed <= 8 && places < 6; ++seed) {
    const PlanarField field = field_of(sampling::lattice_field(seed, 24));
    const Skeleton before = extract_skeleton(field);
    for (const CriticalPoint& zero : before.critical_points)
      for (std::size_t side = 0; side < 3 && places < 6; ++side) {
        const auto moved = moved_to_side(field, zero, side);
        if (!moved) continue;
        certify::SkeletonCertificate record;
        const Skeleton s = extract_skeleton(*moved, record);
        const auto edge = busy_edge(*moved, s);
        if (!edge || !certify::verify(certify::encode(record)).accepted) continue;
        INFO("seed " << seed << ", zero " << edge->zero);
        const Arrived arrived(record);
        const certify::compression::Place place{certify::compression::Place::zero, edge->zero};
        REQUIRE(arrived.table.orders.count(place) == 1);
        std::vector<u32> found;
        for (const auto& group : arrived.table.orders.at(place).lines) {
          REQUIRE(group.size() == 1);
          found.push_back(group[0]);
        }
        const auto expected = by_angle(s, *edge);
        REQUIRE(found.size() == expected.size());
        std::rotate(found.begin(), std::find(found.begin(), found.end(), expected[0]), found.end());
        CHECK(found == expected);
        CHECK_NOTHROW(arrived.check(arrived.table));
        // Another one, of every two neighbours.
        for (std::size_t i = 0; i < found.size(); ++i) {
          auto other = arrived.table;
          auto& lines = other.orders.at(place).lines;
          std::swap(lines[i], lines[(i + 1) % lines.size()]);
          CHECK_THROWS(arrived.check(other));
        }
        ++places;
      }
  }
  CHECK(places >= 3);
}
