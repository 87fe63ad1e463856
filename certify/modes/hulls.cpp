// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of forms on simplices: doubles, then integers.
#include <fmt/ranges.h>

#include "certify/container/reject.hpp"
#include "certify/modes/faces.hpp"

namespace crest::certify::modes {
namespace {

template <class Number, std::size_t n>
Hull level_hull(const SimplexForms<Number, n>& forms, const Level& level) {
  return level.neutral ? hull(forms.cube()) : hull(forms.pair(level));
}

template <std::size_t n>
std::string in_words(const std::array<u32, n>& corners) {
  return fmt::format("simplex ({})", fmt::join(corners, ", "));
}

template <std::size_t n>
void check_rejected_simplex(const LevelContext& context, const std::array<u32, n>& corners,
                            Worker& worker) {
  ++worker.counts.calls;
  const auto products = approximate_products<n>(context.field, corners);
  Hull found = level_hull(SimplexForms<double, n>(products), context.level);
  if (found == Hull::unknown) {
    ++worker.counts.exact;
    const auto exact = exact_products<n>(worker.exact, corners);
    found = level_hull(SimplexForms<Integer, n>(exact), context.level);
  }
  require(found != Hull::mixed,
          "{}: stated to be free of the level, the coefficients do not say so", in_words(corners));
  if (found == Hull::nonnegative)
    require(zero_free(worker.exact, corners), "{}: the tensor is zero in it", in_words(corners));
}

template <class Number, std::size_t n>
Hull witness_hull(const SimplexForms<Number, n>& forms, const Direction<n>& w,
                  std::optional<double> lambda, const Level& level) {
  if (!lambda) return hull(forms.plain(w));
  if (level.neutral) return hull(forms.neutral_witness(w, *lambda));
  return hull(forms.witness(w, *lambda, level));
}

template <std::size_t n>
void check_simplex_witness(const LevelContext& context, const std::array<u32, n>& corners,
                           const Direction<n>& w, std::optional<double> lambda, Worker& worker) {
  ++worker.counts.calls;
  const auto products = approximate_products<n>(context.field, corners);
  Hull found = witness_hull(SimplexForms<double, n>(products), w, lambda, context.level);
  if (found == Hull::unknown) {
    ++worker.counts.exact;
    const auto exact = exact_products<n>(worker.exact, corners);
    found = witness_hull(SimplexForms<Integer, n>(exact), w, lambda, context.level);
  }
  require(found == Hull::positive, "{}: its witness is none", in_words(corners));
}

}  // namespace

void check_rejected(const LevelContext& context, const std::array<u32, 2>& corners,
                    Worker& worker) {
  check_rejected_simplex(context, corners, worker);
}
void check_rejected(const LevelContext& context, const std::array<u32, 3>& corners,
                    Worker& worker) {
  check_rejected_simplex(context, corners, worker);
}
void check_rejected(const LevelContext& context, const std::array<u32, 4>& corners,
                    Worker& worker) {
  check_rejected_simplex(context, corners, worker);
}
void check_witness(const LevelContext& context, const std::array<u32, 3>& corners,
                   const Direction<3>& w, std::optional<double> lambda, Worker& worker) {
  check_simplex_witness(context, corners, w, lambda, worker);
}
void check_witness(const LevelContext& context, const std::array<u32, 4>& corners,
                   const Direction<4>& w, std::optional<double> lambda, Worker& worker) {
  check_simplex_witness(context, corners, w, lambda, worker);
}

}  // namespace crest::certify::modes
