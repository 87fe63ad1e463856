// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 3: chosen lies, each tried everywhere it fits. All but the named fact is true.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <iostream>

#include "certify/verify.hpp"
#include "tests/certify/reeb_samples.hpp"
#include "tests/certify/reference_reeb.hpp"
#include "tests/support/environment.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using u32 = std::uint32_t;
struct Truth {
  ReebSurface surface;
  ReferenceReeb reference;
  ReebCertificate certificate;
};

void for_truths(std::uint64_t seed, std::size_t rounds,
                const std::function<void(const Truth&)>& visit) {
  Random random(seed);
  for (std::size_t round = 0; round < rounds; ++round)
    for (const ReebSurface& surface : reeb_surfaces(random))
      for (const int degree : {1, 2}) {
        ReferenceReeb reference(reeb_data(surface, degree, Values::mixed, random));
        ReebCertificate c = reference.certificate(random);
        visit({surface, std::move(reference), std::move(c)});
      }
}

/// An arc and the node its cut has, if any.
struct Line {
  u32 lower, upper, node;
  bool cut;
};
std::vector<Line> lines_of(const Truth& t) {
  std::vector<Line> lines;
  for (const auto& a : t.reference.arcs()) lines.push_back({a.lower, a.upper, a.node, false});
  for (const auto& cut : t.certificate.cuts) lines[cut.arc].cut = true;
  return lines;
}

/// The certificate with these arcs, each keeping its cut.
Verdict verdict_on(const Truth& t, std::vector<Line> lines) {
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) {
    return a.lower != b.lower ? a.lower < b.lower : a.upper < b.upper;
  });
  ReebCertificate c = t.certificate;
  c.arcs.clear();
  c.cuts.clear();
  for (const Line& line : lines) {
    if (line.cut) c.cuts.push_back({static_cast<u32>(c.arcs.size()), line.node});
    c.arcs.push_back({line.lower, line.upper});
  }
  return verify(encode(c));
}

bool same_arcs(const std::vector<Line>& a, const ReferenceReeb& truth) {
  std::vector<std::array<u32, 2>> x, y;
  for (const Line& line : a) x.push_back({line.lower, line.upper});
  for (const auto& arc : truth.arcs()) y.push_back({arc.lower, arc.upper});
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  return x == y;
}

}  // namespace

TEST_CASE("no two arcs may exchange their ends") {
  std::uint64_t lies = 0, rejected = 0, loops_moved = 0;
  for_truths(kSeed, 2, [&](const Truth& t) {
    const auto lines = lines_of(t);
    const std::size_t n = std::min<std::size_t>(lines.size(), 40);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        for (const bool upper : {true, false}) {
          auto lie = lines;
          upper ? std::swap(lie[i].upper, lie[j].upper) : std::swap(lie[i].lower, lie[j].lower);
          if (lie[i].lower >= lie[i].upper || lie[j].lower >= lie[j].upper) continue;
          if (same_arcs(lie, t.reference)) continue;
          ++lies;
          loops_moved += lines[i].cut || lines[j].cut;
          rejected += !verdict_on(t, lie).accepted;
        }
  });
  std::cout << "Reeb graph, ends of two arcs exchanged: " << lies << " lies, " << rejected
            << " rejected; " << loops_moved << " close a loop elsewhere\n";
  CHECK(rejected == lies);
  CHECK(lies > 10000);
  CHECK(loops_moved > 500);
}

TEST_CASE("no arc may begin or end at another node") {
  std::uint64_t lies = 0, rejected = 0;
  for_truths(kSeed + 1, 1, [&](const Truth& t) {
    const auto lines = lines_of(t);
    const auto nodes = static_cast<u32>(t.reference.critical().size());
    for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 30); ++i)
      for (u32 other = 0; other < nodes; ++other)
        for (const bool upper : {true, false}) {
          auto lie = lines;
          (upper ? lie[i].upper : lie[i].lower) = other;
          if (lie[i].lower >= lie[i].upper || same_arcs(lie, t.reference)) continue;
          ++lies;
          rejected += !verdict_on(t, lie).accepted;
        }
  });
  std::cout << "Reeb graph, one end moved: " << lies << " lies, " << rejected << " rejected\n";
  CHECK(rejected == lies);
  CHECK(lies > 5000);
}

TEST_CASE("a split told as a merge") {
  std::uint64_t lies = 0, rejected = 0;
  for_truths(kSeed + 2, 3, [&](const Truth& t) {
    const auto lines = lines_of(t);
    // p -> s, s -> a, s -> b becomes p -> s, q -> s, s -> a with b on q's arc instead.
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (std::size_t j = 0; j < lines.size(); ++j) {
        const u32 s = lines[i].lower;
        if (lines[j].lower >= s || lines[j].upper <= s) continue;
        auto lie = lines;
        lie[i].lower = lines[j].lower;  // q -> b
        lie[j].upper = s;               // q' -> s
        lie.push_back({s, lines[j].upper, 0, false});
        lie.erase(lie.begin() + static_cast<std::ptrdiff_t>(i));
        if (same_arcs(lie, t.reference)) continue;
        ++lies;
        rejected += !verdict_on(t, lie).accepted;
      }
  });
  std::cout << "Reeb graph, split as merge: " << lies << " lies, " << rejected << " rejected\n";
  CHECK(rejected == lies);
  CHECK(lies > 500);
}

TEST_CASE("a cut that a loop needs may not be missing") {
  std::uint64_t lies = 0, rejected = 0;
  for_truths(kSeed + 3, 2, [&](const Truth& t) {
    // A spanning tree is left: without any of the cuts a loop is.
    if (t.certificate.cuts.size() != static_cast<std::size_t>(t.reference.loops())) return;
    for (std::size_t i = 0; i < t.certificate.cuts.size(); ++i) {
      ReebCertificate c = t.certificate;
      c.cuts.erase(c.cuts.begin() + static_cast<std::ptrdiff_t>(i));
      ++lies;
      const Verdict verdict = verify(encode(c));
      rejected += !verdict.accepted &&
                  (verdict.reason.find("graph: ") == 0 || verdict.reason.find("cuts: ") == 0);
    }
  });
  CHECK(rejected == lies);
  CHECK(lies > 20);
}

TEST_CASE("a critical node of degree 2 may not be missing") {
  std::uint64_t lies = 0;
  for_truths(kSeed + 4, 3, [&](const Truth& t) {
    const auto nodes = static_cast<u32>(t.reference.critical().size());
    for (u32 s = 0; s < nodes; ++s) {
      auto lines = lines_of(t);
      const auto is_upper = [&](const Line& l) { return l.upper == s; };
      const auto is_lower = [&](const Line& l) { return l.lower == s; };
      if (std::count_if(lines.begin(), lines.end(), is_upper) != 1 ||
          std::count_if(lines.begin(), lines.end(), is_lower) != 1)
        continue;
      const auto above = std::find_if(lines.begin(), lines.end(), is_lower);
      std::find_if(lines.begin(), lines.end(), is_upper)->upper = above->upper;
      lines.erase(above);
      for (Line& line : lines) line.lower -= line.lower > s, line.upper -= line.upper > s;
      Truth lie = t;
      lie.certificate.critical_nodes.erase(lie.certificate.critical_nodes.begin() + s);
      const Verdict verdict = verdict_on(lie, lines);
      CHECK_FALSE(verdict.accepted);
      CHECK(verdict.reason.find("critical and not listed") != std::string::npos);
      ++lies;
    }
  });
  CHECK(lies > 10);
}
