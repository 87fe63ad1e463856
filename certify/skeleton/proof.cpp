// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/proof.hpp"

#include <memory>
#include <mutex>

#include "certify/container/parallel.hpp"
#include "certify/container/prove.hpp"
#include "certify/skeleton/embedding.hpp"

namespace crest::certify::skeleton {
namespace {

bool same(const SkeletonZero& a, const SkeletonZero& b) {
  return a.triangle == b.triangle && a.place == b.place && a.kind == b.kind && a.focus == b.focus &&
         a.index == b.index && a.hyperbolic == b.hyperbolic && a.elliptic == b.elliptic;
}
bool same(const SkeletonSwitch& a, const SkeletonSwitch& b) {
  return a.side == b.side && a.place == b.place && a.inside == b.inside;
}
bool same(const SkeletonLoop& a, const SkeletonLoop& b) {
  return a.side == b.side && a.zero == b.zero && a.winding == b.winding && a.turning == b.turning &&
         a.interior == b.interior && a.exterior == b.exterior && a.inflow == b.inflow &&
         a.outflow == b.outflow;
}

std::string in_words(const SkeletonZero& z) {
  return fmt::format("triangle {}, place {}, class {}, focus {}, index {}, sectors {} {}",
                     z.triangle, int(z.place), int(z.kind), z.focus, z.index, z.hyperbolic,
                     z.elliptic);
}
std::string in_words(const SkeletonSwitch& s) {
  return fmt::format("side {}, place {}, inside {}", s.side, s.place, s.inside);
}
std::string in_words(const SkeletonLoop& l) {
  return fmt::format(
      "side {}, zero {}, winding {}, turning {}, inside {}, outside {}, inflow {}, "
      "outflow {}",
      l.side, l.zero, l.winding, l.turning, l.interior, l.exterior, l.inflow, l.outflow);
}

template <class Record>
void require_same(const std::vector<Record>& stated, const std::vector<Record>& found,
                  const char* what) {
  require_equal(static_cast<std::int64_t>(stated.size()), found.size(), what);
  for (std::size_t i = 0; i < stated.size(); ++i)
    require(same(stated[i], found[i]), "{} {}: {} stated, {} found", what, i, in_words(stated[i]),
            in_words(found[i]));
}

/// A ladder of signs a thread, the counts added up.
struct Workshop {
  std::mutex mutex;
  Work work;
  SignCounts signs;

  struct Worker {
    Worker(Workshop& shop, Arithmetic arithmetic) : home(shop), sign(arithmetic) {}
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    ~Worker() {
      const std::lock_guard lock(home.mutex);
      home.work.cells += done.cells;
      home.work.pieces += done.pieces;
      home.work.exact_pieces += done.exact_pieces;
      home.signs.calls += sign.counts().calls;
      home.signs.interval += sign.counts().interval;
      home.signs.exact += sign.counts().exact;
    }
    void add(const Work& w) {
      done.cells += w.cells;
      done.pieces += w.pieces;
      done.exact_pieces += w.exact_pieces;
    }
    Workshop& home;
    SignLadder sign;
    Work done;
  };
};

std::vector<std::unique_ptr<Trap>> check_traps(const SkeletonCertificate& c, const Field& field,
                                               const Domain& domain, const ZeroSet& zeros) {
  std::vector<std::unique_ptr<Trap>> traps(zeros.components.size());
  for (std::size_t i = 0; i < c.traps.size(); ++i) {
    require(i == 0 || c.traps[i - 1].zero < c.traps[i].zero, "traps: not ascending");
    auto trap = std::make_unique<Trap>(field, domain, zeros, c.traps[i]);
    traps[c.traps[i].zero] = std::move(trap);
  }
  return traps;
}

/// Steps 4 to 6.
void check_lines(const SkeletonCertificate& c, const Context& context, Arithmetic arithmetic,
                 Proof& proof, Verdict& verdict) {
  Workshop shop;
  const auto owned = check_traps(c, context.field, context.domain, context.zeros);
  Traps traps;
  for (const auto& trap : owned) traps.push_back(trap.get());
  prove(verdict, "traps: {} sinks and sources that keep what enters", c.traps.size());
  const auto make = [&] { return std::make_unique<Workshop::Worker>(shop, arithmetic); };
  proof.orbits.resize(c.orbits.size());
  parallel_for(c.orbits.size(), make, [&](auto& worker, std::size_t i) {
    worker->add(check_orbit(context, static_cast<u32>(i), worker->sign, proof.orbits[i]));
  });
  prove(verdict, "closed orbits: {} chains of cells that return into themselves", c.orbits.size());
  proof.claimed.resize(c.separatrices.size());
  proof.lines.resize(c.separatrices.size());
  parallel_for(c.separatrices.size(), make, [&](auto& worker, std::size_t i) {
    worker->add(check_line(context, traps, static_cast<u32>(i), worker->sign, proof.claimed[i],
                           proof.lines[i]));
  });
  check_completeness(context, proof.claimed);
  std::array<u32, 5> ends{};
  std::size_t witnesses = 0;
  for (const auto& line : c.separatrices) {
    ++ends[static_cast<std::size_t>(line.end)];
    witnesses += line.origin == SkeletonOrigin::vertex;
  }
  for (std::size_t k = 0; k < ends.size(); ++k) require_equal(c.ends[k], ends[k], "ends");
  prove(verdict,
        "separatrices: {}, lines through vertices: {}; {} end in zeros, {} in switch points, {} at "
        "the boundary, {} in closed orbits, {} are undecided; {} triangles crossed between {} "
        "one-way arcs, {} of them proven in rationals",
        c.separatrices.size() - witnesses, witnesses, ends[0], ends[1], ends[2], ends[3], ends[4],
        shop.work.cells, shop.work.pieces, shop.work.exact_pieces);
  verdict.signs.calls += shop.signs.calls;
  verdict.signs.interval += shop.signs.interval;
  verdict.signs.exact += shop.signs.exact;
}

}  // namespace

void prove_surface(Proof& proof, SignLadder& sign, Verdict& verdict) {
  proof.domain = build_domain(proof.field, sign);
  check_embedding(proof.field, proof.domain, sign);
  prove(verdict,
        "data: a domain in the plane of {} positive triangles, {} of them with no flow; digests "
        "match",
        proof.field.triangles(), proof.domain.dead);
}

void prove_skeleton(Proof& proof, SignLadder& sign, Arithmetic arithmetic, Verdict& verdict) {
  const SkeletonCertificate& c = proof.stated;
  const Field& field = proof.field;
  proof.zeros = find_zeros(field, proof.domain, sign);
  std::vector<SkeletonZero> found;
  std::int64_t indices = 0;
  for (const Component& component : proof.zeros.components) {
    found.push_back(component.stated);
    if (component.stated.index != kNoIndex) indices += component.stated.index;
  }
  require_same(c.zeros, found, "zeros");
  prove(verdict, "zeros: {} components, with their classes, indices and sectors", found.size());
  proof.boundary = find_boundary(field, proof.domain, sign);
  require_same(c.loops, proof.boundary.loops, "loops");
  require_same(c.switches, proof.boundary.switches, "switch points");
  require_equal(c.index_sum, indices, "index sum");
  require_equal(indices, winding_around_rest(field, proof.domain, proof.zeros, sign),
                "sum of indices and winding");
  prove(verdict, "boundary: {} loops, {} switch points; the indices sum to {}, the winding",
        proof.boundary.loops.size(), proof.boundary.switches.size(), indices);
  Budget budget{static_cast<std::int64_t>(16 * field.corners() + 1024), std::int64_t{1} << 20U};
  check_lines(c, {c, field, proof.domain, proof.zeros, proof.boundary, budget}, arithmetic, proof,
              verdict);
  verdict.signs.calls += sign.counts().calls;
  verdict.signs.interval += sign.counts().interval;
  verdict.signs.exact += sign.counts().exact;
}

}  // namespace crest::certify::skeleton
