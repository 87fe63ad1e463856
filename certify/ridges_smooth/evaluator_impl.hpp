// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SurfaceEvaluator for the translation units that instantiate it, one a model type.
#include "certify/ridges_smooth/substitution.hpp"

namespace crest::certify::smooth {

template <class M>
M SurfaceEvaluator<M>::value(const Point& x) {
  if (!value_) {
    const auto convert = [](const kernel::Constant& c) {
      return kernel::as_enclosure(c, static_cast<const M*>(nullptr));
    };
    value_.emplace(surface_.texts[0], convert, M(1.0));
  }
  return (*value_)(x);
}

template <class M>
template <int n>
kernel::Jet<M, 3, n> SurfaceEvaluator<M>::implicit(const Point& x) {
  using Jet = kernel::Jet<M, 3, n>;
  auto& program = std::get<Program<3, n>>(implicit_);
  if (!program) program = kernel::jet_evaluator<M, 3, n>(surface_.texts[0]);
  const std::array<Jet, 3> at = {Jet::variable(0, x[0]), Jet::variable(1, x[1]),
                                 Jet::variable(2, x[2])};
  return (*program)(at);
}

template <class M>
template <int n>
kernel::Jet<M, 3, n> SurfaceEvaluator<M>::implicit(const Point& x, const Frame& frame) {
  if constexpr (!MpModel<M>) {
    return in_frame(implicit<n>(x), frame);
  } else {
    // Without weights that are rounded to doubles.
    using Jet = kernel::Jet<M, 3, n>;
    auto& program = std::get<Program<3, n>>(implicit_);
    if (!program) program = kernel::jet_evaluator<M, 3, n>(surface_.texts[0]);
    std::array<Jet, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = Jet::constant(x[i]);
      // Of degree one the last variable comes first.
      for (std::size_t k = 0; k < 3; ++k)
        if (frame[k][i] != 0) at[i].set(3 - k, M(frame[k][i]));
    }
    return (*program)(at);
  }
}

template <class M>
template <int n>
std::array<kernel::Jet<M, 2, n>, 3> SurfaceEvaluator<M>::immersion(const M& u, const M& v) {
  using Jet = kernel::Jet<M, 2, n>;
  auto& program = std::get<Program<2, n>>(immersion_);
  if (!program)
    program = kernel::jet_evaluator<M, 2, n>(std::span(surface_.texts).template first<3>());
  if (domain_.empty()) {
    std::array<M, 4> bound;
    const auto convert = [](const kernel::Constant& c) {
      return kernel::as_enclosure(c, static_cast<const M*>(nullptr));
    };
    for (std::size_t k = 0; k < 4; ++k)
      bound[k] = kernel::Evaluator<M>(surface_.texts[3 + k], convert, M(1.0))({});
    domain_ = {bound[0], bound[1] - bound[0], bound[2], bound[3] - bound[2]};
  }
  const auto along = [&](std::size_t k, const M& t) {
    Jet x = Jet::constant(domain_[k] + domain_[k + 1] * t);
    x.set(2 - k / 2, domain_[k + 1]);  // of degree one the last variable comes first
    return x;
  };
  const std::array<Jet, 2> at = {along(0, u), along(2, v)};
  return program->template all<3>(at);
}

}  // namespace crest::certify::smooth

/// Instantiates everything for the model type M.
#define CREST_SMOOTH_EVALUATOR(M)                                                             \
  template M SurfaceEvaluator<M>::value(const Point&);                                        \
  template kernel::Jet<M, 3, 1> SurfaceEvaluator<M>::implicit<1>(const Point&);               \
  template kernel::Jet<M, 3, 3> SurfaceEvaluator<M>::implicit<3>(const Point&, const Frame&); \
  template kernel::Jet<M, 3, 4> SurfaceEvaluator<M>::implicit<4>(const Point&, const Frame&); \
  template kernel::Jet<M, 3, 5> SurfaceEvaluator<M>::implicit<5>(const Point&, const Frame&); \
  template kernel::Jet<M, 3, 5> SurfaceEvaluator<M>::implicit<5>(const Point&);               \
  template std::array<kernel::Jet<M, 2, 3>, 3> SurfaceEvaluator<M>::immersion<3>(const M&,    \
                                                                                 const M&);   \
  template std::array<kernel::Jet<M, 2, 4>, 3> SurfaceEvaluator<M>::immersion<4>(const M&,    \
                                                                                 const M&);   \
  template std::array<kernel::Jet<M, 2, 5>, 3> SurfaceEvaluator<M>::immersion<5>(const M&, const M&)

/// What FaceLanes asks for, with n derivatives: models side by side.
#define CREST_SMOOTH_LANES_EVALUATOR(M, n)                                      \
  template M SurfaceEvaluator<M>::value(const Point&);                          \
  template kernel::Jet<M, 3, 1> SurfaceEvaluator<M>::implicit<1>(const Point&); \
  template kernel::Jet<M, 3, n> SurfaceEvaluator<M>::implicit<n>(const Point&); \
  template std::array<kernel::Jet<M, 2, n>, 3> SurfaceEvaluator<M>::immersion<n>(const M&, const M&)
