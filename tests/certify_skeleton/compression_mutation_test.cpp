// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 10: wrong claims are rejected, every mutant bound anew; so is an output with one collapse
// more that changes the skeleton.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <iostream>
#include <map>

#include "certify/compression/decode.hpp"
#include "certify/compression/encode.hpp"
#include "certify/container/container.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_compression.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using C = CompressionCertificate;
using u32 = std::uint32_t;

struct Original {
  PlaneField field;
  C certificate;
};

const std::vector<Original>& originals() {
  static const auto all = [] {
    Random random(kSeed);
    std::vector<Original> list;
    const auto add = [&](const PlaneField& field, SkeletonNotion notion, std::size_t tries) {
      list.push_back({field, reference_compression(field, notion, tries, random)});
      const C& c = list.back().certificate;
      const Verdict verdict = verify(encode(c));
      INFO(verdict.reason);
      REQUIRE(verdict.accepted);
      REQUIRE(c.output.triangles.size() < c.input.triangles.size());
    };
    add(lattice_field(1, 4, 12, true), SkeletonNotion::original, 100);
    add(lattice_field(1, 4, 12, true), SkeletonNotion::strong, 60);
    add(lattice_field(4, 9, 36, false), SkeletonNotion::original, 40);  // an orbit
    add(grid_field(6, 6, 1,
                   [](double x, double y) {
                     return std::array{x * y - 5, x - y};  // zeros on vertices
                   }),
        SkeletonNotion::original, 60);
    REQUIRE_FALSE(list[2].certificate.orbits.empty());
    return list;
  }();
  return all;
}

Triangles triangles_of(const C& c) {
  Triangles all;
  for (const auto& t : c.output.triangles)
    all.push_back({c.vertices[t[0]], c.vertices[t[1]], c.vertices[t[2]]});
  return all;
}

/// Is what it states true? The claim is made anew, from its data.
bool is_true(const C& mutant) {
  const PlaneField field{mutant.input.positions, mutant.input.triangles, mutant.input.vectors};
  const C anew = claim_of(field, reference_skeleton(field), triangles_of(mutant), mutant.notion);
  if (!verify(encode(anew)).accepted || anew.zeros != mutant.zeros) return false;
  for (std::size_t i = 0; i < anew.separatrices.size(); ++i)
    if (!anew.input.separatrices[i].legs.empty() && anew.separatrices[i] != mutant.separatrices[i])
      return false;
  return true;
}

/// Whether the other producer finds another skeleton: a zero or switch point less or more, or
/// elsewhere, or a line that ends otherwise. Regions are not compared.
bool differs(const C& c) {
  if (c.input.zeros.size() != c.output.zeros.size() ||
      c.input.switches.size() != c.output.switches.size() ||
      std::count(c.zeros.begin(), c.zeros.end(), kNotStated) > 0)
    return true;
  for (std::size_t i = 0; i < c.separatrices.size(); ++i) {
    const auto& a = c.input.separatrices[i];
    if (c.separatrices[i] == kNotStated || a.end == SkeletonEnd::undecided) continue;
    const auto& b = c.output.separatrices[c.separatrices[i]];
    if (b.end == SkeletonEnd::undecided) continue;
    if (a.end != b.end || (a.end == SkeletonEnd::zero && c.zeros[a.to] != b.to)) return true;
  }
  return false;
}

/// Whether the checker accepts it, which must not be if it is false.
bool is_accepted(const C& mutant, bool is_false, std::map<std::string, std::size_t>& reasons) {
  const Verdict verdict = verify(encode(mutant));
  if (is_false) CHECK_FALSE(verdict.accepted);
  std::string reason = verdict.accepted ? "accepted" : verdict.reason;
  std::replace_if(
      reason.begin(), reason.end(), [](char x) { return x >= '0' && x <= '9'; }, '#');
  ++reasons[reason];
  return verdict.accepted;
}
void print(const std::map<std::string, std::size_t>& reasons) {
  for (const auto& [reason, count] : reasons) std::cout << "  " << count << " " << reason << "\n";
}

template <class List>
std::size_t pick(const List& list, Random& random) {
  return static_cast<std::size_t>(random() % list.size());
}

using Edit = std::function<bool(C&, Random&)>;

/// Two entries of a map that say something else exchanged.
Edit exchanged(std::vector<u32> C::*map) {
  return [map](C& c, Random& r) {
    auto& list = c.*map;
    if (list.size() < 2) return false;
    const auto i = pick(list, r), j = pick(list, r);
    if (i == j) return false;
    std::swap(list[i], list[j]);
    return true;
  };
}
Edit changed(std::vector<u32> C::*map) {
  return [map](C& c, Random& r) {
    auto& list = c.*map;
    if (list.empty()) return false;
    list[pick(list, r)] += r() % 2 == 0 ? 1 : 0x80000000U;
    return true;
  };
}
Edit shortened(std::vector<u32> C::*map) {
  return [map](C& c, Random&) { return !(c.*map).empty() && ((c.*map).pop_back(), true); };
}
Edit longer(std::vector<u32> C::*map) {
  return [map](C& c, Random&) {
    (c.*map).push_back(static_cast<u32>((c.*map).size()));
    return true;
  };
}

void recount(SkeletonCertificate& c) {
  c.ends = {};
  for (const auto& line : c.separatrices) ++c.ends[static_cast<std::size_t>(line.end)];
}
/// A separatrix with turns and an end, of the input or of the output.
SkeletonSeparatrix* decided(SkeletonCertificate& c, Random& r) {
  std::vector<SkeletonSeparatrix*> all;
  for (auto& line : c.separatrices)
    if (line.end != SkeletonEnd::undecided && line.legs[0].turns.size() > 1) all.push_back(&line);
  return all.empty() ? nullptr : all[pick(all, r)];
}
template <class Change>
Edit of_line(SkeletonCertificate C::*which, Change change) {
  return [which, change](C& c, Random& r) {
    SkeletonSeparatrix* line = decided(c.*which, r);
    return line != nullptr && change(*line, c.*which, r);
  };
}
template <class Change>
Edit of_triangle(Change change) {
  return [change](C& c, Random& r) {
    auto& list = c.output.triangles;
    return change(list[pick(list, r)], c, r);
  };
}

void make_undecided(SkeletonSeparatrix& line, SkeletonCertificate& c) {
  line.end = SkeletonEnd::undecided;
  line.to = 0;
  line.legs.clear();
  line.reason = OpenReason::budget;
  recount(c);
}

using Edits = std::vector<std::pair<std::string, Edit>>;

/// Of maps and triangles.
Edits false_maps() {
  return {
      {"zeros exchanged", exchanged(&C::zeros)},
      {"zero elsewhere", changed(&C::zeros)},
      {"zeros short", shortened(&C::zeros)},
      {"zeros long", longer(&C::zeros)},
      {"separatrix elsewhere", changed(&C::separatrices)},
      {"separatrices short", shortened(&C::separatrices)},
      {"separatrices long", longer(&C::separatrices)},
      {"orbit elsewhere", changed(&C::orbits)},
      {"orbits short", shortened(&C::orbits)},
      {"orbits long", longer(&C::orbits)},
      {"separatrices exchanged",
       [](C& c, Random& r) {
         const auto i = pick(c.separatrices, r), j = pick(c.separatrices, r);
         const auto &a = c.input.separatrices[i], &b = c.input.separatrices[j];
         const bool alike = a.legs.empty() && b.legs.empty() && a.origin == b.origin &&
                            a.from == b.from && a.backward == b.backward;
         if (i == j || alike) return false;
         std::swap(c.separatrices[i], c.separatrices[j]);
         return true;
       }},
      {"triangle turned",
       of_triangle([](auto& t, C&, Random&) { return std::swap(t[1], t[2]), true; })},
      {"triangle doubled", of_triangle([](auto& t, C& c, Random&) {
         const auto copy = t;
         return c.output.triangles.push_back(copy), true;
       })},
      {"triangle dropped", of_triangle([](auto& t, C& c, Random&) {
         t = c.output.triangles.back();
         return c.output.triangles.pop_back(), true;
       })},
      {"corner elsewhere", of_triangle([](auto& t, C& c, Random& r) {
         return t[0] = (t[0] + 1 + static_cast<u32>(r() % 2)) % static_cast<u32>(c.vertices.size()),
                true;
       })},
      {"an orbit of the output dropped",
       [](C& c, Random&) {
         return !c.output.orbits.empty() && (c.output.orbits.pop_back(), true);
       }},
  };
}

/// Of both skeletons.
void add_false_skeletons(Edits& all) {
  for (auto which : {&C::input, &C::output}) {
    const std::string whose = which == &C::input ? " of the input" : " of the output";
    all.push_back({"turn changed" + whose, of_line(which, [](auto& line, auto&, Random& r) {
                     auto& turns = line.legs[0].turns;
                     auto& turn = turns[pick(turns, r)];
                     turn = static_cast<Turn>((static_cast<unsigned>(turn) + 1 + r() % 2) % 3);
                     return true;
                   })});
    all.push_back({"end elsewhere" + whose,
                   of_line(which, [](auto& line, auto&, Random&) { return ++line.to, true; })});
    all.push_back({"end withheld" + whose, of_line(which, [](auto& line, auto& c, Random&) {
                     return make_undecided(line, c), true;
                   })});
    all.push_back({"separatrix dropped" + whose, [which](C& c, Random& r) {
                     auto& list = (c.*which).separatrices;
                     list.erase(list.begin() + static_cast<std::ptrdiff_t>(pick(list, r)));
                     recount(c.*which);
                     return true;
                   }});
    all.push_back(
        {"count" + whose, [which](C& c, Random&) { return ++(c.*which).index_sum, true; }});
    all.push_back({"zero dropped" + whose,
                   [which](C& c, Random&) { return (c.*which).zeros.pop_back(), true; }});
    all.push_back({"class changed" + whose, [which](C& c, Random& r) {
                     auto& zero = (c.*which).zeros[pick((c.*which).zeros, r)];
                     zero.kind = static_cast<ZeroClass>((static_cast<unsigned>(zero.kind) + 1) % 5);
                     return true;
                   }});
  }
}

Edits false_edits() {
  Edits all = false_maps();
  add_false_skeletons(all);
  // A separatrix in neither of both.
  all.push_back({"separatrix dropped from both", [](C& c, Random& r) {
                   const auto i = pick(c.separatrices, r);
                   const u32 j = c.separatrices[i];
                   const auto drop = [](auto& list, std::size_t at) {
                     list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
                   };
                   drop(c.input.separatrices, i);
                   drop(c.output.separatrices, j);
                   drop(c.separatrices, i);
                   for (u32& k : c.separatrices) k -= k > j;
                   recount(c.input);
                   recount(c.output);
                   return true;
                 }});
  return all;
}

}  // namespace

TEST_CASE("compression: false maps, meshes and skeletons are rejected") {
  Random random(kSeed);
  std::size_t made = 0, kinds = 0;
  for (const auto& [kind, edit] : false_edits()) {
    std::size_t of_kind = 0;
    for (const Original& original : originals())
      for (std::uint64_t i = 0; i < scaled(2); ++i) {
        C mutant = original.certificate;
        if (!edit(mutant, random)) continue;
        ++of_kind;
        INFO(kind);
        CHECK_FALSE(verify(encode(mutant)).accepted);
      }
    CHECK(of_kind > 0);
    made += of_kind;
    ++kinds;
  }
  std::cout << "compression: " << made << " false claims of " << kinds << " kinds, none accepted\n";
  CHECK(kinds == 31);
}

TEST_CASE("compression: one collapse more, and the skeleton is another") {
  Random random(kSeed);
  std::map<std::string, std::size_t> reasons;
  std::size_t illegal = 0, accepted = 0;
  for (std::uint64_t i = 0; i < scaled(1000) && illegal < scaled(40); ++i) {
    const Original& original = originals()[i % 4 == 3 ? 3 : 0];
    const Triangles triangles = triangles_of(original.certificate);
    const auto& t = triangles[pick(triangles, random)];
    const auto corner = static_cast<std::size_t>(random() % 3);
    const Triangles next = collapsed(original.field, triangles, t[corner], t[(corner + 1) % 3]);
    if (next.empty()) continue;
    const C mutant =
        claim_of(original.field, original.certificate.input, next, SkeletonNotion::original);
    const bool other = differs(mutant);
    illegal += other;
    accepted += is_accepted(mutant, other, reasons);
  }
  print(reasons);
  CHECK(illegal == scaled(40));
  CHECK(accepted > 0);
}

TEST_CASE("compression: one edge flipped more: a turned triangle, another skeleton, or the same") {
  Random random(kSeed);
  std::map<std::string, std::size_t> reasons;
  std::size_t illegal = 0, turned = 0, accepted = 0;
  for (std::uint64_t i = 0; i < scaled(2000) && illegal < scaled(12); ++i) {
    const Original& original = originals()[i % 4 == 3 ? 3 : 0];
    const Triangles triangles = triangles_of(original.certificate);
    const auto& t = triangles[pick(triangles, random)];
    const auto corner = static_cast<std::size_t>(random() % 3);
    const Triangles next = flipped(triangles, t[corner], t[(corner + 1) % 3]);
    if (next.empty()) continue;
    C mutant = original.certificate;
    if (!are_positive(original.field, next)) {
      // The other producer is not asked: what it states of the output is as it was.
      if (++turned > scaled(12)) continue;
      for (std::size_t k = 0; k < next.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
          mutant.output.triangles[k][c] = static_cast<u32>(
              std::lower_bound(mutant.vertices.begin(), mutant.vertices.end(), next[k][c]) -
              mutant.vertices.begin());
      CHECK_FALSE(is_accepted(mutant, true, reasons));
      continue;
    }
    mutant = claim_of(original.field, original.certificate.input, next, SkeletonNotion::original);
    const bool other = differs(mutant);
    illegal += other;
    accepted += is_accepted(mutant, other, reasons);
  }
  print(reasons);
  CHECK(illegal == scaled(12));
  CHECK(turned > 0);
  CHECK(accepted > 0);
}

TEST_CASE("compression: edited bytes, bound again, are rejected unless true") {
  Random random(kSeed);
  std::size_t mutants = 0, malformed = 0, accepted = 0;
  for (const Original& original : originals()) {
    const Bytes bytes = encode(original.certificate);
    const Container parts = open_container(bytes);
    for (std::uint64_t i = 0; i < scaled(60); ++i) {
      Bytes mutant = bytes;
      const std::size_t data = kHeaderSize + parts.data.size();
      const std::size_t at = i % 3 == 0 ? kHeaderSize + random() % parts.data.size()
                                        : data + random() % (mutant.size() - data);
      if (i % 16 == 1)
        mutant.resize(at);
      else
        mutant[at] ^= static_cast<std::uint8_t>(1U << random() % 8);
      CHECK_FALSE(verify(mutant).accepted);
      ++mutants;
      try {
        rebind(mutant);
        const Container container = open_container(mutant);
        const C c = decode_compression(container.data, container.claims);
        if (!verify(mutant).accepted) continue;
        ++accepted;
        CHECK(is_true(c));
      } catch (const std::exception&) {
        ++malformed;
        CHECK_FALSE(verify(mutant).accepted);
      }
    }
  }
  std::cout << "compression: " << mutants << " edited files, " << malformed << " malformed, "
            << accepted << " accepted, all true\n";
}
