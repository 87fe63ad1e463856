// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of forms on simplices: doubles, eight simplices at once, then integers.
#include <fmt/ranges.h>

#include "certify/container/reject.hpp"
#include "certify/modes/faces.hpp"
#include "kernel/arithmetic/wide_clones.hpp"

namespace crest::certify::modes {
namespace {

/// Witnesses that all have lambda, or none; lanes that are left over repeat the last.
template <std::size_t n>
struct EightWitnesses {
  std::array<Lanes, n> w;
  Lanes lambda;
  bool plain;

  /// lambda speaks of the tensors as they are; but for mu = 0 the forms' degrees differ.
  EightWitnesses(std::span<const Witnessed<n>> list, const Products<Lanes, n>& products,
                 bool neutral)
      : plain(!list[0].lambda) {
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      const Witnessed<n>& at = list[std::min(lane, list.size() - 1)];
      for (std::size_t k = 0; k < n; ++k) w[k].x[lane] = at.w[k];
      lambda.x[lane] = std::ldexp(at.lambda.value_or(0), neutral ? 0 : -products.exponent[lane]);
    }
  }
};

template <std::size_t n>
Hulls level_hulls_of(const Products<Lanes, n>& products, const Level& level) {
  const SimplexForms<Lanes, n> forms(products);
  return level.neutral ? hulls(forms.cube()) : hulls(forms.pair(level));
}
template <std::size_t n>
Hulls witness_hulls_of(const Products<Lanes, n>& products, const EightWitnesses<n>& witnesses,
                       const Level& level) {
  const SimplexForms<Lanes, n> forms(products);
  const auto& [w, lambda, plain] = witnesses;
  if (plain) return hulls(forms.plain(w));
  if (level.neutral) return hulls(forms.neutral_witness(w, lambda));
  return hulls(forms.witness(w, lambda, level));
}

CREST_WIDE_CLONES Hulls level_hulls(const Products<Lanes, 3>& products, const Level& level) {
  return level_hulls_of(products, level);
}
CREST_WIDE_CLONES Hulls level_hulls(const Products<Lanes, 4>& products, const Level& level) {
  return level_hulls_of(products, level);
}
CREST_WIDE_CLONES Hulls witness_hulls(const Products<Lanes, 3>& products,
                                      const EightWitnesses<3>& witnesses, const Level& level) {
  return witness_hulls_of(products, witnesses, level);
}
CREST_WIDE_CLONES Hulls witness_hulls(const Products<Lanes, 4>& products,
                                      const EightWitnesses<4>& witnesses, const Level& level) {
  return witness_hulls_of(products, witnesses, level);
}

template <std::size_t n>
Hull exact_level_hull(const LevelContext& context, const std::array<u32, n>& corners,
                      Worker& worker) {
  ++worker.counts.exact;
  const auto products = exact_products<n>(worker.exact, corners);
  const SimplexForms<Integer, n> forms(products);
  return context.level.neutral ? hull(forms.cube()) : hull(forms.pair(context.level));
}
template <std::size_t n>
Hull exact_witness_hull(const LevelContext& context, const Witnessed<n>& simplex, Worker& worker) {
  ++worker.counts.exact;
  const auto products = exact_products<n>(worker.exact, simplex.corners);
  const SimplexForms<Integer, n> forms(products);
  const auto& [corners, w, lambda] = simplex;
  if (!lambda) return hull(forms.plain(w));
  if (context.level.neutral) return hull(forms.neutral_witness(w, *lambda));
  return hull(forms.witness(w, *lambda, context.level));
}

/// Calls check(part) for successive parts of eight at most.
template <class Simplex, class Check>
void by_eights(std::span<const Simplex> list, Worker& worker, const Check& check) {
  worker.counts.calls += list.size();
  for (std::size_t first = 0; first < list.size(); first += Lanes::count)
    check(list.subspan(first, std::min(Lanes::count, list.size() - first)));
}

template <std::size_t n>
void check_all_rejected(const LevelContext& context, std::span<const std::array<u32, n>> simplices,
                        Worker& worker) {
  by_eights(simplices, worker, [&](const auto& part) {
    const Hulls hulls = level_hulls(approximate_products(context.field, part), context.level);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Hull found =
          hulls[i] == Hull::unknown ? exact_level_hull(context, part[i], worker) : hulls[i];
      require(found != Hull::mixed,
              "simplex ({}): stated to be free of the level, the coefficients do not say so",
              fmt::join(part[i], ", "));
      if (found == Hull::nonnegative)
        require(zero_free(worker.exact, part[i]), "simplex ({}): the tensor is zero in it",
                fmt::join(part[i], ", "));
    }
  });
}

template <std::size_t n>
void check_all_witnesses(const LevelContext& context, std::span<const Witnessed<n>> simplices,
                         Worker& worker) {
  by_eights(simplices, worker, [&](const auto& part) {
    std::vector<std::array<u32, n>> corners;
    for (const auto& simplex : part) corners.push_back(simplex.corners);
    const auto products =
        approximate_products(context.field, std::span<const std::array<u32, n>>(corners));
    const Hulls hulls = witness_hulls(
        products, EightWitnesses<n>(part, products, context.level.neutral), context.level);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Hull found =
          hulls[i] == Hull::unknown ? exact_witness_hull(context, part[i], worker) : hulls[i];
      require(found == Hull::positive, "simplex ({}): its witness is none",
              fmt::join(part[i].corners, ", "));
    }
  });
}

template <std::size_t n>
void check_by_kind(const LevelContext& context, std::span<const Witnessed<n>> simplices,
                   Worker& worker) {
  std::vector<Witnessed<n>> kinds[2];
  for (const auto& simplex : simplices) kinds[simplex.lambda ? 1 : 0].push_back(simplex);
  for (const auto& kind : kinds) check_all_witnesses<n>(context, kind, worker);
}

}  // namespace

void check_rejected(const LevelContext& context, std::span<const std::array<u32, 3>> simplices,
                    Worker& worker) {
  check_all_rejected(context, simplices, worker);
}
void check_rejected(const LevelContext& context, std::span<const std::array<u32, 4>> simplices,
                    Worker& worker) {
  check_all_rejected(context, simplices, worker);
}
void check_witnesses(const LevelContext& context, std::span<const Witnessed<3>> simplices,
                     Worker& worker) {
  check_by_kind(context, simplices, worker);
}
void check_witnesses(const LevelContext& context, std::span<const Witnessed<4>> simplices,
                     Worker& worker) {
  check_by_kind(context, simplices, worker);
}

}  // namespace crest::certify::modes
