// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 9, skeleton: the topological skeleton of a planar piecewise linear vector field (SPEC.md).
#include <memory>
#include <mutex>

#include "certify/container/checker.hpp"
#include "certify/container/parallel.hpp"
#include "certify/container/prove.hpp"
#include "certify/skeleton/decode.hpp"
#include "certify/skeleton/embedding.hpp"
#include "certify/skeleton/lines.hpp"
#include "certify/surface/input_tie.hpp"

namespace crest::certify {
namespace {

using namespace skeleton;

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
                 Verdict& verdict) {
  Workshop shop;
  const auto owned = check_traps(c, context.field, context.domain, context.zeros);
  Traps traps;
  for (const auto& trap : owned) traps.push_back(trap.get());
  prove(verdict, "traps: {} sinks and sources that keep what enters", c.traps.size());
  const auto make = [&] { return std::make_unique<Workshop::Worker>(shop, arithmetic); };
  parallel_for(c.orbits.size(), make, [&](auto& worker, std::size_t i) {
    worker->add(check_orbit(context, static_cast<u32>(i), worker->sign));
  });
  prove(verdict, "closed orbits: {} chains of cells that return into themselves", c.orbits.size());
  std::vector<Claimed> claimed(c.separatrices.size());
  parallel_for(c.separatrices.size(), make, [&](auto& worker, std::size_t i) {
    worker->add(check_line(context, traps, static_cast<u32>(i), worker->sign, claimed[i]));
  });
  check_completeness(context, std::move(claimed));
  std::array<u32, 5> ends{};
  for (const auto& line : c.separatrices) ++ends[static_cast<std::size_t>(line.end)];
  for (std::size_t k = 0; k < ends.size(); ++k) require_equal(c.ends[k], ends[k], "ends");
  prove(verdict,
        "separatrices: {}; {} end in zeros, {} in switch points, {} at the boundary, {} in closed "
        "orbits, {} are undecided; {} triangles crossed between {} one-way arcs, {} of them proven "
        "in rationals",
        c.separatrices.size(), ends[0], ends[1], ends[2], ends[3], ends[4], shop.work.cells,
        shop.work.pieces, shop.work.exact_pieces);
  verdict.signs.calls += shop.signs.calls;
  verdict.signs.interval += shop.signs.interval;
  verdict.signs.exact += shop.signs.exact;
}

void verify_skeleton(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                     const VerifyOptions& options, Verdict& verdict) {
  const SkeletonCertificate c = decode_skeleton(data, claims);
  const Field field(c);
  SignLadder sign(options.arithmetic);
  const Domain domain = build_domain(field, sign);
  check_embedding(field, sign);
  prove(verdict,
        "data: a domain in the plane of {} positive triangles, {} of them with no flow; digests "
        "match",
        field.triangles(), domain.dead);
  if (options.input) {
    std::vector<std::array<double, 3>> flat;
    for (const auto& [x, y] : c.positions) flat.push_back({x, y, 0});
    const std::string oriented = check_input(*options.input, flat, c.triangles);
    prove(verdict,
          "input: {} holds the same positions and faces, {}; nothing ties the vectors to it",
          options.input->name, oriented);
  }
  const ZeroSet zeros = find_zeros(field, domain, sign);
  std::vector<SkeletonZero> found;
  std::int64_t indices = 0;
  for (const Component& component : zeros.components) {
    found.push_back(component.stated);
    if (component.stated.index != kNoIndex) indices += component.stated.index;
  }
  require_same(c.zeros, found, "zeros");
  prove(verdict, "zeros: {} components, with their classes, indices and sectors", found.size());
  const Boundary boundary = find_boundary(field, domain, sign);
  require_same(c.loops, boundary.loops, "loops");
  require_same(c.switches, boundary.switches, "switch points");
  require_equal(c.index_sum, indices, "index sum");
  require_equal(indices, winding_around_rest(field, domain, zeros, sign),
                "sum of indices and winding");
  prove(verdict, "boundary: {} loops, {} switch points; the indices sum to {}, the winding",
        boundary.loops.size(), boundary.switches.size(), indices);
  verdict.signs = sign.counts();
  Budget budget{static_cast<std::int64_t>(16 * field.corners() + 1024), std::int64_t{1} << 20U};
  check_lines(c, {c, field, domain, zeros, boundary, budget}, options.arithmetic, verdict);
}

}  // namespace

extern const ClaimChecker skeleton_claim;
const ClaimChecker skeleton_claim = {kSkeleton, kSkeletonVersion, "skeleton", verify_skeleton};

}  // namespace crest::certify
