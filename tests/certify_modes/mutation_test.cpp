// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 6: wrong claims are rejected. Every mutant is bound again; an accepted one must state what
// is true of its own data.
#include <catch2/catch.hpp>
#include <functional>
#include <iostream>
#include <map>

#include "certify/modes/decode.hpp"
#include "certify/modes/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_modes/byte_mutants.hpp"
#include "tests/certify_modes/modes_judge.hpp"
#include "tests/certify_modes/modes_samples.hpp"
#include "tests/support/failures.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

ModesInput small_random(Random& random, std::size_t tets) {
  ModesInput input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, -1, -1}};
  const std::vector<std::array<std::uint32_t, 4>> all = {{0, 1, 2, 3}, {4, 1, 2, 3}, {5, 1, 2, 0}};
  input.tets.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(tets));
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    std::array<double, 6> t{};
    for (double& x : t) x = static_cast<double>(static_cast<int>(random() % 19) - 9);
    input.tensors.push_back(t);
  }
  return input;
}

std::vector<ModesCertificate> make_originals() {
  Random random(kSeed);
  std::vector<ModesCertificate> all;
  for (const std::size_t tets : {1U, 2U, 3U})
    for (int i = 0; i < 2; ++i)
      all.push_back(reference_modes(small_random(random, tets), {{0, 1}, {1, 2}}));
  all.push_back(reference_modes(grid(1, -2, 2, kReferenceFields[3]), {{9, 10}}));
  LinearField centred = kReferenceFields[2];
  centred[0] = {};
  all.push_back(reference_modes(grid(1, -1, 1, centred), {{0, 1}}, 30, {{{0, 7}}}));
  for (const auto& c : all) {
    const Verdict verdict = verify(encode(c));
    INFO(verdict.reason);
    REQUIRE(verdict.accepted);
  }
  return all;
}

const std::vector<ModesCertificate>& originals() {
  static const auto all = make_originals();
  return all;
}

}  // namespace

TEST_CASE("modes: edited bytes, bound again, are rejected unless true") {
  Random random(kSeed);
  Tally tally;
  auto all = originals();
  for (const std::size_t i : {2U, 7U}) {
    all.push_back(all[i]);
    add_positions(all.back(), 1);
    REQUIRE(verify(encode(all.back())).accepted);
  }
  for (const auto& original : all) {
    try_bytes(encode(original), scaled(32), random, decode_modes,
              [&](const ModesCertificate& mutant) { tally.judge("byte", original, mutant); });
  }
  std::cout << "bytes: " << tally.mutants << " mutants, " << tally.accepted << " accepted, "
            << tally.compared << " of them made anew\n";
  CHECK(tally.mutants > 150);
}

namespace {

using Edit = std::function<bool(ModeLevel&, Random&)>;

template <class List>
std::size_t pick(const List& list, Random& random) {
  return static_cast<std::size_t>(random() % list.size());
}

/// Each returns whether it changed anything.
const std::vector<std::pair<std::string, Edit>> kEdits = {
    {"count changed",
     [](ModeLevel& l, Random& r) {
       auto& c = l.positive.components;
       if (c.empty()) return l.positive.touched += 1, true;
       auto& one = c[pick(c, r)];
       r() % 2 ? (void)++one.boundary_loops : (void)--one.euler_characteristic;
       return true;
     }},
    {"component dropped",
     [](ModeLevel& l, Random&) {
       auto& c = l.negative.components.empty() ? l.positive.components : l.negative.components;
       if (c.empty()) return false;
       c.pop_back();
       return true;
     }},
    {"root dropped",
     [](ModeLevel& l, Random& r) {
       if (l.roots.empty()) return false;
       const auto at = pick(l.roots, r);
       std::size_t seen = 0;
       for (auto& code : l.codes)
         if (code > 64 && code <= 70 && (seen += code - 64U) > at) {
           --code;
           break;
         }
       l.roots.erase(l.roots.begin() + static_cast<std::ptrdiff_t>(at));
       return true;
     }},
    {"root doubled",
     [](ModeLevel& l, Random& r) {
       if (l.roots.empty()) return false;
       const auto at = pick(l.roots, r);
       std::size_t seen = 0;
       for (auto& code : l.codes)
         if (code > 64 && code < 70 && (seen += code - 64U) > at) {
           ++code;
           break;
         }
       l.roots.insert(l.roots.begin() + static_cast<std::ptrdiff_t>(at), l.roots[at]);
       return true;
     }},
    {"level of a root turned",
     [](ModeLevel& l, Random& r) {
       if (l.roots.empty()) return false;
       auto& root = l.roots[pick(l.roots, r)];
       root.level = static_cast<std::int8_t>(-root.level);
       return true;
     }},
    {"enclosure moved",
     [](ModeLevel& l, Random& r) {
       if (l.roots.empty()) return false;
       auto& root = l.roots[pick(l.roots, r)];
       const double width = root.high - root.low;
       root.low += width, root.high += width;
       return true;
     }},
    {"enclosure of all",
     [](ModeLevel& l, Random& r) {
       if (l.roots.empty()) return false;
       auto& root = l.roots[pick(l.roots, r)];
       root.low = 0, root.high = 1;
       return true;
     }},
    {"arc dropped",
     [](ModeLevel& l, Random& r) {
       if (l.arcs.empty()) return false;
       l.arcs.erase(l.arcs.begin() + static_cast<std::ptrdiff_t>(pick(l.arcs, r)));
       return true;
     }},
    {"pairing swapped",
     [](ModeLevel& l, Random& r) {
       if (l.arcs.size() < 2) return false;
       const auto at = 1 + static_cast<std::size_t>(r() % (l.arcs.size() - 1));
       std::swap(l.arcs[at].second, l.arcs[at - 1].second);
       return l.arcs[at].second != l.arcs[at - 1].second;
     }},
    {"w turned",
     [](ModeLevel& l, Random& r) {
       if (l.tet_witnesses.empty()) return false;
       auto& w = l.tet_witnesses[pick(l.tet_witnesses, r)].w;
       for (auto& x : w) x = static_cast<std::int16_t>(-x);
       return true;
     }},
    {"w of a face turned",
     [](ModeLevel& l, Random& r) {
       if (l.face_witnesses.empty()) return false;
       auto& w = l.face_witnesses[pick(l.face_witnesses, r)].w;
       for (auto& x : w) x = static_cast<std::int16_t>(-x);
       return true;
     }},
    {"lambda times 2",
     [](ModeLevel& l, Random& r) {
       if (l.tet_witnesses.empty()) return false;
       auto& lambda = l.tet_witnesses[pick(l.tet_witnesses, r)].lambda;
       lambda *= r() % 2 ? 2 : 1000;
       return lambda != 0;
     }},
    {"pieces changed",
     [](ModeLevel& l, Random& r) {
       if (l.tet_witnesses.empty()) return false;
       ++l.tet_witnesses[pick(l.tet_witnesses, r)].pieces[r() % 2];
       return true;
     }},
    {"witnesses exchanged",
     [](ModeLevel& l, Random& r) {
       if (l.tet_witnesses.size() < 2) return false;
       const auto at = 1 + static_cast<std::size_t>(r() % (l.tet_witnesses.size() - 1));
       std::swap(l.tet_witnesses[at], l.tet_witnesses[at - 1]);
       return true;
     }},
    {"code changed",
     [](ModeLevel& l, Random& r) {
       if (l.codes.empty()) return false;
       auto& code = l.codes[pick(l.codes, r)];
       const auto before = code;
       code = static_cast<std::uint8_t>(r() % 10);
       return code != before;
     }},
    {"code changed to a neighbour",
     [](ModeLevel& l, Random& r) {
       if (l.codes.empty()) return false;
       auto& code = l.codes[pick(l.codes, r)];
       code = static_cast<std::uint8_t>(r() % 2 ? code + 1 : code - 1);
       return true;
     }},
    {"tetrahedron not listed",
     [](ModeLevel& l, Random&) {
       if (l.tets.empty()) return false;
       l.tets.pop_back();
       return true;
     }},
    {"all forgotten",
     [](ModeLevel& l, Random&) {
       if (l.tets.empty()) return false;
       l = {l.numerator, l.denominator, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, 0};
       return true;
     }},
    {"graph stated to be rejected",
     [](ModeLevel& l, Random& r) {
       if (l.tet_witnesses.empty()) return false;
       const auto at = pick(l.tet_witnesses, r);
       std::size_t seen = 0;
       // Tetrahedra come last: count from the end.
       for (auto code = l.codes.rbegin(); code != l.codes.rend(); ++code)
         if ((*code == 7 || *code == 8) && seen++ == l.tet_witnesses.size() - 1 - at) {
           *code = 6;
           l.tet_witnesses.erase(l.tet_witnesses.begin() + static_cast<std::ptrdiff_t>(at));
           return true;
         }
       return false;
     }},
    {"open cells not counted",
     [](ModeLevel& l, Random& r) {
       if (l.tet_witnesses.empty()) return false;
       for (auto code = l.codes.rbegin(); code != l.codes.rend(); ++code)
         if (*code == 7 || *code == 8) {
           *code = 9;
           l.tet_witnesses.pop_back();
           l.open_tets += static_cast<std::uint32_t>(r() % 2);
           return true;
         }
       return false;
     }},
};

}  // namespace

TEST_CASE("modes: edited records are rejected unless true") {
  Random random(kSeed);
  Tally tally;
  std::map<std::string, std::uint64_t> made;
  for (const auto& original : originals())
    for (const auto& [kind, edit] : kEdits)
      for (std::uint64_t i = 0; i < scaled(2); ++i) {
        ModesCertificate mutant = original;
        if (!edit(mutant.levels[pick(mutant.levels, random)], random)) continue;
        ++made[kind];
        tally.judge(kind, original, mutant);
      }
  for (const auto& [kind, count] : made)
    std::cout << kind << ": " << count << " mutants, " << tally.by_kind[kind] << " accepted\n";
  for (const auto& [kind, edit] : kEdits) {
    CAPTURE(kind);
    CHECK(made[kind] > 0);
  }
  for (const char* kind :
       {"count changed", "component dropped", "root dropped", "root doubled", "arc dropped",
        "pairing swapped", "w turned", "pieces changed", "all forgotten"}) {
    CAPTURE(kind);
    CHECK(tally.by_kind[kind] == 0);
  }
}
