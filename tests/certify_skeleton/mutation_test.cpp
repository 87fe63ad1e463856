// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 9: wrong claims are rejected. Every mutant is bound again; an accepted one must state what
// is true of its own data.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <iostream>
#include <map>

#include "certify/container/container.hpp"
#include "certify/skeleton/decode.hpp"
#include "certify/skeleton/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_skeleton.hpp"
#include "tests/support/random.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using Certificate = SkeletonCertificate;

const std::vector<Certificate>& originals() {
  static const auto all = [] {
    std::vector<Certificate> list;
    list.push_back(reference_skeleton(lattice_field(1, 4, 12, true)));
    list.push_back(reference_skeleton(lattice_field(4, 9, 36, false)));  // an orbit
    list.push_back(reference_skeleton(grid_field(6, 6, 1, [](double x, double y) {
      return std::array{x * y - 5, x - y};  // zeros on vertices
    })));
    list.push_back(reference_skeleton(grid_field(6, 6, 1, [](double x, double y) {
      return y > 2 && y < 5 && x < 4 ? std::array{0.0, 0.0} : std::array{x - 3, y - 1};
    })));
    for (const auto& c : list) {
      const Verdict verdict = verify(encode(c));
      INFO(verdict.reason);
      REQUIRE(verdict.accepted);
    }
    REQUIRE_FALSE(list[1].orbits.empty());
    return list;
  }();
  return all;
}

/// What is stated of zeros, loops and switch points, in numbers.
std::vector<std::int64_t> points_of(const Certificate& c) {
  std::vector<std::int64_t> all;
  for (const auto& z : c.zeros)
    all.insert(all.end(), {z.triangle, static_cast<int>(z.place), static_cast<int>(z.kind), z.focus,
                           z.index, z.hyperbolic, z.elliptic});
  for (const auto& l : c.loops)
    all.insert(all.end(),
               {l.side, l.zero, l.winding, l.turning, l.interior, l.exterior, l.inflow, l.outflow});
  for (const auto& s : c.switches) all.insert(all.end(), {s.side, s.place, s.inside});
  all.push_back(c.index_sum);
  return all;
}

/// Separatrices and their ends; orbits by their side: an end in one says no more.
using Line = std::array<std::int64_t, 5>;
std::vector<Line> lines_of(const Certificate& c, bool decided) {
  std::vector<Line> all;
  for (const auto& line : c.separatrices) {
    const bool open = line.end == SkeletonEnd::undecided;
    if (open && decided) continue;
    const bool orbit = line.end == SkeletonEnd::orbit;
    all.push_back({static_cast<int>(line.origin), line.from, line.backward,
                   open ? -1 : static_cast<int>(line.end), open || orbit ? 0 : line.to});
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Of one field: the same points, as many lines, and no end that the other contradicts.
bool agree(const Certificate& a, const Certificate& b) {
  if (points_of(a) != points_of(b) || a.separatrices.size() != b.separatrices.size()) return false;
  std::map<std::array<std::int64_t, 3>, std::array<std::vector<Line>, 2>> by_origin;
  for (const int which : {0, 1})
    for (const Line& line : lines_of(which == 0 ? a : b, true))
      by_origin[{line[0], line[1], line[2]}][static_cast<std::size_t>(which)].push_back(line);
  for (const auto& [origin, both] : by_origin) {
    std::vector<Line> common;
    std::set_intersection(both[0].begin(), both[0].end(), both[1].begin(), both[1].end(),
                          std::back_inserter(common));
    // At most two lines of an origin and time: all that both decide must agree.
    const std::size_t lines = origin[0] == 0 ? 2 : 1;
    const std::size_t least =
        both[0].size() + both[1].size() > lines ? both[0].size() + both[1].size() - lines : 0;
    if (common.size() < least) return false;
  }
  return true;
}

struct Tally {
  std::uint64_t mutants = 0, accepted = 0, compared = 0;
  std::map<std::string, std::array<std::uint64_t, 2>> by_kind;

  void judge(const std::string& kind, const Certificate& original, const Certificate& mutant) {
    ++mutants;
    auto& [made, passed] = by_kind[kind];
    ++made;
    if (!verify(encode(mutant)).accepted) return;
    ++accepted;
    ++passed;
    CAPTURE(kind);
    const bool same_field = original.positions == mutant.positions &&
                            original.vectors == mutant.vectors &&
                            original.triangles == mutant.triangles;
    compared += !same_field;
    const auto anew =
        same_field ? original
                   : reference_skeleton({mutant.positions, mutant.triangles, mutant.vectors});
    CHECK(agree(anew, mutant));
  }
};

}  // namespace

TEST_CASE("skeleton: edited bytes, bound again, are rejected unless true") {
  Random random(kSeed);
  Tally tally;
  std::uint64_t malformed = 0;
  for (const auto& original : originals()) {
    const Bytes bytes = encode(original);
    const Container parts = open_container(bytes);
    const std::size_t data = kHeaderSize + parts.data.size();
    for (std::uint64_t i = 0; i < scaled(100); ++i) {
      Bytes mutant = bytes;
      const auto at = i % 4 == 0 ? kHeaderSize + random() % parts.data.size()
                                 : data + random() % (mutant.size() - data);
      if (i % 16 == 1)
        mutant.resize(at);
      else
        mutant[at] ^= static_cast<std::uint8_t>(1U << random() % 8);
      CHECK_FALSE(verify(mutant).accepted);
      try {
        rebind(mutant);
        const Container container = open_container(mutant);
        tally.judge("byte", original, decode_skeleton(container.data, container.claims));
      } catch (const std::exception&) {
        ++malformed;
        CHECK_FALSE(verify(mutant).accepted);
      }
    }
  }
  std::cout << "bytes: " << tally.mutants << " mutants, " << tally.accepted << " accepted, "
            << tally.compared << " of them made anew; " << malformed << " more malformed\n";
  CHECK(tally.mutants > 150);
}

namespace {

using Edit = std::function<bool(Certificate&, Random&)>;

template <class List>
std::size_t pick(const List& list, Random& random) {
  return static_cast<std::size_t>(random() % list.size());
}
/// A separatrix with turns and an end.
SkeletonSeparatrix* decided(Certificate& c, Random& r) {
  std::vector<SkeletonSeparatrix*> all;
  for (auto& line : c.separatrices)
    if (line.end != SkeletonEnd::undecided && line.legs[0].turns.size() > 1) all.push_back(&line);
  return all.empty() ? nullptr : all[pick(all, r)];
}
template <class Change>
Edit of_line(Change change) {
  return [change](Certificate& c, Random& r) {
    SkeletonSeparatrix* line = decided(c, r);
    return line != nullptr && change(*line, c, r);
  };
}
template <class List, class Change>
Edit of(List Certificate::*list, Change change) {
  return [list, change](Certificate& c, Random& r) {
    return !(c.*list).empty() && (change((c.*list)[pick(c.*list, r)], r), true);
  };
}
template <class List>
Edit dropped(List Certificate::*list) {
  return [list](Certificate& c, Random& r) {
    if ((c.*list).empty()) return false;
    (c.*list).erase((c.*list).begin() + static_cast<std::ptrdiff_t>(pick(c.*list, r)));
    return true;
  };
}
template <class List>
Edit doubled(List Certificate::*list) {
  return [list](Certificate& c, Random& r) {
    if ((c.*list).empty()) return false;
    const auto at = pick(c.*list, r);
    (c.*list).insert((c.*list).begin() + static_cast<std::ptrdiff_t>(at), (c.*list)[at]);
    return true;
  };
}
void recount(Certificate& c) {
  c.ends = {};
  for (const auto& line : c.separatrices) ++c.ends[static_cast<std::size_t>(line.end)];
}

using C = Certificate;
/// Kinds of which none may be accepted, and those of which some state the same.
const std::vector<std::pair<std::string, Edit>> kFalse = {
    {"zero dropped", dropped(&C::zeros)},
    {"zero doubled", doubled(&C::zeros)},
    {"zero elsewhere", of(&C::zeros, [](auto& z, Random&) { ++z.triangle; })},
    {"class changed", of(&C::zeros,
                         [](auto& z, Random& r) {
                           z.kind = static_cast<ZeroClass>(
                               (static_cast<unsigned>(z.kind) + 1 + r() % 4) % 5);
                         })},
    {"focus changed", of(&C::zeros, [](auto& z, Random&) { z.focus ^= 1U; })},
    {"place changed", of(&C::zeros,
                         [](auto& z, Random& r) {
                           z.place = static_cast<ZeroPlace>(
                               (static_cast<unsigned>(z.place) + 1 + r() % 4) % 5);
                         })},
    {"index changed",
     [](C& c, Random& r) {
       auto& z = c.zeros[pick(c.zeros, r)];
       if (z.index == kNoIndex) return false;
       const int step = r() % 2 == 0 ? 1 : -1;
       z.index += step;
       c.index_sum += step;
       return true;
     }},
    {"index withheld",
     [](C& c, Random& r) {
       auto& z = c.zeros[pick(c.zeros, r)];
       if (z.index == kNoIndex) return false;
       c.index_sum -= z.index;
       z.index = kNoIndex;
       return true;
     }},
    {"sectors changed", of(&C::zeros, [](auto& z, Random&) { ++z.hyperbolic, ++z.elliptic; })},
    {"winding and turning changed",
     of(&C::loops, [](auto& l, Random&) { ++l.winding, ++l.turning; })},
    {"loop dropped", dropped(&C::loops)},
    {"counts of a loop changed",
     of(&C::loops, [](auto& l, Random&) { ++l.interior, ++l.exterior; })},
    {"regions of a loop changed", of(&C::loops, [](auto& l, Random&) { ++l.inflow; })},
    {"loop meets a zero", of(&C::loops, [](auto& l, Random&) { l.zero ^= 1U; })},
    {"switch point dropped", dropped(&C::switches)},
    {"switch point turned", of(&C::switches, [](auto& s, Random&) { s.inside ^= 1U; })},
    {"switch point elsewhere", of(&C::switches, [](auto& s, Random&) { ++s.side; })},
    {"switch point of another kind", of(&C::switches,
                                        [](auto& s, Random&) {
                                          s.place = s.place == 2
                                                        ? std::uint8_t{0}
                                                        : static_cast<std::uint8_t>(s.place + 1);
                                        })},
    {"index sum", [](C& c, Random&) { return ++c.index_sum, true; }},
    {"ends", [](C& c, Random& r) { return ++c.ends[r() % 5], true; }},
    {"trap dropped",
     [](C& c, Random&) {
       const auto used = [&](const SkeletonTrap& t) {
         return std::any_of(c.separatrices.begin(), c.separatrices.end(), [&](const auto& line) {
           return line.end == SkeletonEnd::zero && line.to == t.zero;
         });
       };
       return std::erase_if(c.traps, used) > 0;
     }},
    {"trap doubled", doubled(&C::traps)},
    {"trap of another zero", of(&C::traps, [](auto& t, Random&) { ++t.zero; })},
    {"trap too large", of(&C::traps,
                          [](auto& t, Random&) {
                            for (double& x : t.form) x /= 4;
                          })},
    {"trap turned", of(&C::traps, [](auto& t, Random&) { t.form[0] = -t.form[0]; })},
    {"separatrix dropped",
     [](C& c, Random& r) { return dropped(&C::separatrices)(c, r) && (recount(c), true); }},
    {"separatrix doubled",
     [](C& c, Random& r) { return doubled(&C::separatrices)(c, r) && (recount(c), true); }},
    {"turn changed", of_line([](auto& line, C&, Random& r) {
       auto& turns = line.legs[0].turns;
       auto& turn = turns[pick(turns, r)];
       turn = static_cast<Turn>((static_cast<unsigned>(turn) + 1 + r() % 2) % 3);
       return true;
     })},
    {"turn dropped",
     of_line([](auto& line, C&, Random&) { return line.legs[0].turns.pop_back(), true; })},
    {"turn added", of_line([](auto& line, C&, Random& r) {
       return line.legs[0].turns.push_back(static_cast<Turn>(r() % 3)), true;
     })},
    {"time turned", of_line([](auto& line, C&, Random&) { return line.backward ^= 1U, true; })},
    {"end elsewhere", of_line([](auto& line, C&, Random& r) {
       line.to += r() % 2 == 0 ? 1 : 2;
       return true;
     })},
    {"end of another kind", of_line([](auto& line, C& c, Random& r) {
       line.end = static_cast<SkeletonEnd>((static_cast<unsigned>(line.end) + 1 + r() % 3) % 4);
       recount(c);
       return true;
     })},
    {"ends exchanged", of_line([](auto& line, C& c, Random& r) {
       auto& other = *decided(c, r);
       if (std::pair(line.end, line.to) == std::pair(other.end, other.to)) return false;
       std::swap(line.end, other.end);
       std::swap(line.to, other.to);
       return true;
     })},
    {"origins exchanged", of_line([](auto& line, C& c, Random& r) {
       auto& other = *decided(c, r);
       if (std::pair(line.origin, line.from) == std::pair(other.origin, other.from)) return false;
       std::swap(line.from, other.from);
       std::swap(line.origin, other.origin);
       return true;
     })},
    {"a ray twice", of_line([](auto& line, C& c, Random&) {
       for (auto& other : c.separatrices)
         if (&other != &line && other.from == line.from && other.backward == line.backward &&
             other.origin == line.origin) {
           other = line;
           recount(c);
           return true;
         }
       return false;
     })},
    {"start without length", of_line([](auto& line, C&, Random&) {
       auto& leg = line.legs[0];
       if (leg.kind != LegKind::ray) return false;
       leg.first = leg.second;
       return true;
     })},
    {"start turned round", of_line([](auto& line, C&, Random&) {
       auto& leg = line.legs[0];
       if (leg.kind == LegKind::point) return false;
       std::swap(leg.first, leg.second);
       return true;
     })},
    {"start through another side", of_line([](auto& line, C&, Random& r) {
       auto& corner = line.legs[0].corner;
       corner = 3 * (corner / 3) + (corner + 1 + static_cast<unsigned>(r() % 2)) % 3;
       return true;
     })},
    {"start of another kind", of_line([](auto& line, C&, Random& r) {
       auto& kind = line.legs[0].kind;
       kind = static_cast<LegKind>((static_cast<unsigned>(kind) + 1 + r() % 3) % 4);
       return true;
     })},
    {"reason without need",
     of_line([](auto& line, C&, Random&) { return line.reason = OpenReason::budget, true; })},
    {"orbit turned", of(&C::orbits, [](auto& o, Random&) { o.backward ^= 1U; })},
    {"orbit beside", of(&C::orbits, [](auto& o, Random&) { o.left = o.right; })},
    {"orbit with another turn", of(&C::orbits,
                                   [](auto& o, Random& r) {
                                     auto& turn = o.turns[pick(o.turns, r)];
                                     turn = static_cast<Turn>(
                                         (static_cast<unsigned>(turn) + 1 + r() % 2) % 3);
                                   })},
    {"orbit dropped", dropped(&C::orbits)},
    {"orbit through another side", of(&C::orbits, [](auto& o, Random&) { ++o.side; })},
};
const std::vector<std::pair<std::string, Edit>> kHarmless = {
    {"way forgotten", of_line([](auto& line, C& c, Random&) {
       line.legs.clear();
       line.end = SkeletonEnd::undecided;
       line.to = 0;
       line.reason = OpenReason::budget;
       recount(c);
       return true;
     })},
    {"other barriers", of_line([](auto& line, C&, Random& r) {
       auto& b = line.legs[0].barrier;
       b.degree = static_cast<std::uint8_t>(8 + r() % 8);
       b.angle = static_cast<std::uint16_t>(20 + r() % 24);
       return true;
     })},
    {"more bits", of_line([](auto& line, C&, Random&) {
       line.legs[0].barrier = {24, 80, 133, 0};
       return true;
     })},
    {"order of separatrices",
     [](C& c, Random& r) {
       if (c.separatrices.empty()) return false;
       std::swap(c.separatrices[pick(c.separatrices, r)], c.separatrices[pick(c.separatrices, r)]);
       return true;
     }},
    {"vector moved",
     [](C& c, Random& r) {
       auto& x = c.vectors[pick(c.vectors, r)][r() % 2];
       x += (r() % 2 == 0 ? 1e-6 : 0.5);
       return true;
     }},
    {"vertex moved",
     [](C& c, Random& r) {
       c.positions[pick(c.positions, r)][r() % 2] += (r() % 2 == 0 ? 1e-9 : 0.02);
       return true;
     }},
};

void try_all(const std::vector<std::pair<std::string, Edit>>& edits, std::uint64_t times,
             Tally& tally) {
  Random random(kSeed);
  for (const auto& original : originals())
    for (const auto& [kind, edit] : edits)
      for (std::uint64_t i = 0; i < times; ++i) {
        Certificate mutant = original;
        if (edit(mutant, random)) tally.judge(kind, original, mutant);
      }
  for (const auto& [kind, edit] : edits) {
    CAPTURE(kind);
    CHECK(tally.by_kind[kind][0] > 0);
  }
}

}  // namespace

TEST_CASE("skeleton: of edited records none is accepted") {
  Tally tally;
  try_all(kFalse, scaled(3), tally);
  for (const auto& [kind, counts] : tally.by_kind) {
    CAPTURE(kind);
    CHECK(counts[1] == 0);
  }
  std::cout << "records: " << tally.by_kind.size() << " kinds, " << tally.mutants << " mutants, "
            << tally.accepted << " accepted\n";
}

TEST_CASE("skeleton: edits that may leave the claim true") {
  Tally tally;
  try_all(kHarmless, scaled(4), tally);
  for (const auto& [kind, counts] : tally.by_kind)
    std::cout << kind << ": " << counts[0] << " mutants, " << counts[1] << " accepted\n";
  CHECK(tally.by_kind["way forgotten"][0] == tally.by_kind["way forgotten"][1]);
  CHECK(tally.by_kind["more bits"][1] > 0);
}
