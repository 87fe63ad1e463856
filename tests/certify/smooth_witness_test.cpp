// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 4, version 2: what is recorded must be all of it, and what costs a hostile certificate
// could cause is bounded.
#include <catch2/catch.hpp>
#include <ctime>

#include "certify/container/reject.hpp"
#include "certify/ridges_smooth/box_pairs.hpp"
#include "certify/ridges_smooth/faces.hpp"
#include "certify/smooth_witness/record.hpp"
#include "certify/verify.hpp"
#include "tests/certify/sample_meshes.hpp"
#include "tests/certify/smooth_producer.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

std::string reason(const RidgesSmoothCertificate& c) {
  return verify(encode(c)).reason;
}

using Boxes = std::vector<std::array<crest::kernel::Range, 3>>;

Boxes random_boxes(std::size_t count, double size, Random& random) {
  Boxes boxes(count);
  for (auto& box : boxes)
    for (auto& side : box) {
      const double at = uniform(random);
      side = crest::kernel::Range{at, at + size * std::fabs(uniform(random))};
    }
  return boxes;
}

/// The unit square in two faces, (0, 0) a loose corner for blue, with a ridge past it.
struct LooseSquare {
  LooseSquare() {
    c.surface = parametric("u", "v", "u*v", {"0", "1", "0", "1"});
    c.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    c.faces = {{0, 1, 2}, {0, 2, 3}};
    c.face_records.resize(2);
    for (auto& record : c.face_records) record.verdict = {5, SmoothFaceRecord::kNoZero};
    c.loose_corners = 1;
    for (auto& face : faces) face.loose[0] = 1;
    // E_1 is taken for positive at vertex 0, negative at 1 and 2, positive at 3.
    faces[0].crossed[0] = 0b101;
    faces[1].crossed[0] = 0b011;
    for (auto& face : faces) face.decided[0] = 0b010;
    faces[0].slope[0][0] = faces[1].slope[0][2] = crest::kernel::Sign::negative;
  }
  void check() {
    const auto surface = smooth::parse_surface(c.surface);
    const auto mesh = smooth::check_mesh(c);
    smooth::check_edges({surface, c, mesh, Arithmetic::doubles}, faces);
  }

  RidgesSmoothCertificate c;
  std::vector<smooth::FaceResult> faces{2};
};

}  // namespace

TEST_CASE("smooth ridges: a witness that is short, long or of another order is rejected") {
  for (const auto& [name, original] : smooth_claims()) {
    INFO(name);
    const std::size_t f = original.faces.size() / 2;
    auto c = original;
    c.face_records[f].witness.clear();
    CHECK(reason(c).find("its witness ends early") != std::string::npos);
    c = original;
    c.face_records[f].witness.push_back(0);
    CHECK(reason(c).find("bytes left over") != std::string::npos);
    c = original;
    c.face_records[f].witness.back() = 3;
    CHECK(reason(c).find("no such order") != std::string::npos);
    if (c.patches.empty()) continue;
    c = original;
    c.patches[0].witness.pop_back();
    CHECK(reason(c).find("its witness ends early") != std::string::npos);
    c = original;
    c.patches[0].krawczyk = {};
    CHECK(reason(c).find("the umbilic") != std::string::npos);
  }
}

TEST_CASE("smooth ridges: recording again changes nothing") {
  for (const auto& [name, original] : smooth_claims()) {
    auto c = original;
    INFO(name);
    CHECK_FALSE(record_witnesses(c).has_value());
    CHECK(encode(c) == encode(original));
    ++c.surface.texts[2].back();  // another surface, perhaps no expression
    const auto open = record_witnesses(c);
    if (open) CHECK(open->find('\n') == std::string::npos);
  }
}

TEST_CASE("smooth ridges: version 1 is not known") {
  Bytes bytes = encode(smooth_claims()[0].certificate);
  bytes[8] = 1;
  rebind(bytes);
  CHECK(verify(bytes).reason.find("version") != std::string::npos);
}

TEST_CASE("smooth ridges: an expression of too many words is refused in one line") {
  auto c = smooth_claims()[0].certificate;
  std::string text = "0";
  for (std::size_t i = 0; i < kMostWords / 2; ++i) text += "+u";
  c.surface.texts[2] = text;
  CHECK(reason(c) ==
        "surface: z: 8193 numbers, names and operators; at most 8192 can be evaluated");
  c.surface.texts[2] = text.substr(2);
  CHECK(reason(c).find("words") == std::string::npos);
}

TEST_CASE("smooth ridges: no face has two loose corners") {
  LooseSquare square;
  CHECK_NOTHROW(square.check());
  SECTION("the opposite edge ends at another loose corner") {
    square.c.loose_corners |= 8;
    for (std::size_t f = 0; f < 2; ++f) square.faces[f].loose[0] = f == 0 ? 0b101 : 0b011;
    CHECK_THROWS_WITH(square.check(), "face 0: at two loose corners of the domain");
  }
  SECTION("another corner is loose for the other colour") {
    square.c.loose_corners |= 1U << (4 + 1);
    square.faces[0].loose[1] = 0b010;
    CHECK_THROWS_WITH(square.check(), "face 0: at two loose corners of the domain");
  }
  SECTION("a corner that is marked, and no face has a ridge there") {
    for (std::size_t f = 0; f < 2; ++f) {
      square.c.face_records[f].verdict[0] = SmoothFaceRecord::kNoZero;
      square.faces[f] = {};
    }
    CHECK_THROWS_WITH(square.check(), "vertex 0: its faces differ at a corner of the domain");
  }
  SECTION("an opposite edge that no face decides") {
    square.faces[0].decided[0] = 0;
    CHECK_THROWS_WITH(square.check(), Catch::Contains("no face decides its blue crossings"));
  }
  SECTION("a boundary edge without a sign of the derivative") {
    square.faces[0].slope[0][0].reset();
    CHECK_THROWS_WITH(square.check(), Catch::Contains("along the boundary at a corner"));
  }
  SECTION("opposite signs along the boundary") {
    square.faces[0].slope[0][0] = crest::kernel::Sign::positive;
    CHECK_THROWS_WITH(square.check(), Catch::Contains("a ridge at a corner of the domain"));
  }
}

TEST_CASE("smooth ridges: at a loose corner the arc may run through faces where it is not drawn") {
  LooseSquare square;
  auto& records = square.c.face_records;
  for (auto& record : records) record.type = {1, 0};
  const auto check = [&] {
    const auto surface = smooth::parse_surface(square.c.surface);
    const auto mesh = smooth::check_mesh(square.c);
    smooth::check_undrawn_arcs({surface, square.c, mesh, Arithmetic::doubles});
  };
  CHECK_NOTHROW(check());
  SECTION("arcs of two types") {
    records[1].type[0] = 2;
    CHECK_THROWS_WITH(check(), "vertex 0: two types at a corner of the domain");
  }
  SECTION("a face without the arc has one of the other colour") {
    records[1].type = {0, 1};
    CHECK_THROWS_WITH(check(), "face 1: an arc at a corner of the domain");
  }
  SECTION("a face without the arc whose G has no certain sign") {
    records[1].type = {0, 0};
    square.c.surface = parametric("u", "v", "u + v", {"0", "1", "0", "1"});
    CHECK_THROWS_WITH(check(), Catch::Contains("face 1: the type at a corner of the domain"));
  }
  SECTION("both colours") {
    square.c.loose_corners = 0b10001;
    CHECK_THROWS_WITH(check(), "vertex 0: ridges of both colours at a corner of the domain");
  }
}

TEST_CASE("boxes that meet are those that a comparison of all finds") {
  Random random(kSeed);
  for (const double size : {0.01, 0.3, 2.0}) {
    const Boxes a = random_boxes(60, size, random), b = random_boxes(90, size, random);
    std::vector<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t k = 0; k < b.size(); ++k) {
        bool meet = true;
        for (std::size_t d = 0; d < 3; ++d)
          meet = meet && a[i][d].low <= b[k][d].high && b[k][d].low <= a[i][d].high;
        if (meet) expected.emplace_back(i, k);
      }
    CHECK(smooth::meeting_boxes(a, b, expected.size()) == expected);
    if (!expected.empty())
      CHECK_THROWS_AS(smooth::meeting_boxes(a, b, expected.size() - 1), Reject);
  }
  // They touch.
  using Range = crest::kernel::Range;
  Boxes left(1), right(1);
  left[0] = {Range{0, 1}, Range{0, 1}, Range{0, 1}};
  right[0] = {Range{1, 2}, Range{0, 0}, Range{1, 1}};
  CHECK(smooth::meeting_boxes(left, right, 1).size() == 1);
}

TEST_CASE("many boxes over one another cost little more than few") {
  // Stacked: every pair meets in two of three directions.
  const auto seconds = [](std::size_t count) {
    Boxes boxes(count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto x = static_cast<double>(i);
      boxes[i] = {crest::kernel::Range{0, 1}, {x, x + 0.5}, {0, 1}};
    }
    const std::clock_t start = std::clock();
    CHECK(smooth::meeting_boxes(boxes, boxes, count).size() == count);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  CHECK(seconds(50000) < 60 * seconds(5000) + 1);  // all pairs: 100 times, and minutes
}
