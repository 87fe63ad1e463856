// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/vertices.hpp"

#include <tbb/blocked_range.h>

#include "kernel/arithmetic/approximate.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {
namespace {

using kernel::Integer;
using kernel::MaybeSign;
using kernel::Sign;

MaybeSign certain(double x, double error) {
  if (x > error) return Sign::positive;
  if (x < -error) return Sign::negative;
  return std::nullopt;
}

}  // namespace

Vertices::Vertices(std::span<const Symmetric> tensors, int scale, const Level& level)
    : given_(tensors),
      scale_(scale),
      level_(level),
      mesh_size_(static_cast<Index>(tensors.size())) {
  tensors_.reserve(tensors.size());
  for (const Symmetric& t : tensors) tensors_.push_back(deviator(t, scale));
}

Index Vertices::add(Index a, Index b, std::uint8_t n) {
  const Deviator &ta = tensors_[a], &tb = tensors_[b];
  Deviator t;
  const double s = (64 - n) / 64.0, r = n / 64.0;
  for (std::size_t k = 0; k < 6; ++k) t.t[k] = s * ta.t[k] + r * tb.t[k];
  // Two products and a sum, each rounded once, of parts of the larger end.
  t.error = std::fmax(ta.error, tb.error) * (1 + 0x1p-50) +
            4 * kernel::kUnitRoundoff * std::fmax(ta.largest(), tb.largest()) + 0x1p-1070;
  tensors_.push_back(t);
  cuts_.push_back({a, b, n});
  return size() - 1;
}

const ExactTensor& Vertices::exact_one(Index v) {
  if (const auto found = exact_.find(v); found != exact_.end()) return found->second;
  ExactTensor t;
  if (!is_cut(v)) {
    t = exact_deviator(given_[v], scale_);
  } else {
    const Cut c = cut(v);
    const ExactTensor &a = exact_one(c.a), &b = exact_one(c.b);
    const long low = std::min(a.exponent, b.exponent);
    for (std::size_t k = 0; k < 6; ++k)
      t.t[k] = Integer(64 - c.n) * (a.t[k] << static_cast<unsigned long>(a.exponent - low)) +
               Integer(c.n) * (b.t[k] << static_cast<unsigned long>(b.exponent - low));
    t.exponent = low - 6;
  }
  return exact_.emplace(v, std::move(t)).first->second;
}

void Vertices::find_signs() {
  std::vector<PointSigns> found(mesh_size_);
  using Range = tbb::blocked_range<Index>;
  kernel::parallel_for(Range(0, mesh_size_, 1024), [&](const Range& range) {
    for (Index v = range.begin(); v < range.end(); ++v)
      if (!is_zero(v)) found[v] = signs_at(v);
  });
  signs_ = std::move(found);
}

PointSigns Vertices::signs_at(Index v) {
  // The bounds of forms.hpp, for one tensor.
  const Deviator& t = tensors_[v];
  constexpr double u = kernel::kUnitRoundoff;
  const double m = t.largest() + t.error;
  const double n = product(t.t, t.t), c = product(anticommutator(t.t, t.t), t.t);
  const double ne = 19 * m * t.error + 60 * u * m * m,
               ce = 170 * m * m * t.error + 800 * u * m * m * m;
  const double q = 3 * static_cast<double>(level_.q) * static_cast<double>(level_.q),
               p = 2 * static_cast<double>(level_.p) * static_cast<double>(level_.p);
  const double nm = n + ne, cm = std::fabs(c) + ce;
  // 2 F, whose two terms take at most 8 roundings.
  const double f = q * c * c - p * n * n * n;
  const double fe =
      1.01 * (2 * q * cm * ce + 3 * p * nm * nm * ne + 10 * u * (q * cm * cm + p * nm * nm * nm)) +
      0x1p-1000;
  MaybeSign det = certain(c, ce + 0x1p-1000), level = certain(f, fe);
  if (level_.neutral()) level = det;
  return det && level ? PointSigns{*level, *det} : exact_signs(v);
}

PointSigns Vertices::exact_signs(Index v) {
  const std::lock_guard lock(*mutex_);
  const auto [at, fresh] = exact_signs_.try_emplace(v);
  if (fresh) {
    const auto& x = exact_one(v).t;
    const Integer en = product(x, x), ec = product(anticommutator(x, x), x);
    const Sign det = kernel::sign_of(ec);
    const Sign f = level_.neutral()
                       ? det
                       : kernel::sign_of(Integer(3) * level_.q * level_.q * ec * ec -
                                         Integer(2) * level_.p * level_.p * en * en * en);
    at->second = {f, det};
  }
  return at->second;
}

}  // namespace crest::modes
