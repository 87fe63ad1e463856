// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/face_lanes.hpp"

#include <algorithm>
#include <bit>

#include "algorithms/smooth_ridges/frame_jet.hpp"

namespace crest::smooth_ridges {
namespace {

using kernel::Lanes, kernel::LaneMask, kernel::LaneRanges;
using Model = kernel::TaylorLanes<4>;
using Models = std::array<Model, 3>;
template <int K>
using Field = kernel::Jet<Model, 2, K>;

LaneMask positive(const LaneRanges& r) {
  LaneMask mask = 0;
  for (std::size_t l = 0; l < Lanes::count; ++l) mask |= LaneMask{r.low.x[l] > 0} << l;
  return mask;
}
bool has(LaneMask mask, std::size_t l) {
  return (mask >> l & 1) != 0;
}

/// The lanes that are not live become copies of one that is. Requires: there is one.
template <class... Values>
void revive(LaneMask live, Values&... values) {
  const auto from = static_cast<std::size_t>(std::countr_zero(live));
  for (std::size_t l = 0; l < Lanes::count; ++l)
    if (!has(live, l)) (copy_lane(values, from, l), ...);
}
Model polynomial(Model m) {
  m.radius() = 0;
  return m;
}

/// By lanes: of F, or of U and V.
struct ChartLanes {
  LaneMask live = 0;
  Models x, m;
  Model s;
  Lanes h = 0;
};

struct FrameLanes {
  std::array<Frame, Lanes::count> number;
  std::array<kernel::Vector3<Lanes>, 3> vectors;

  void set(std::size_t l, const Frame& frame) {
    number[l] = frame;
    const auto exact = frame_vectors(frame);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) vectors[k][i].x[l] = exact[k][i];
  }
};

/// The directions w of the faces, chosen on the way unless they are known; who passes, and whose
/// principal vectors have no enclosure though they are regular.
struct Selection {
  LaneMask live = kernel::kAllLanes, wide = 0;
  bool known = false;
  std::array<std::uint8_t, Lanes::count> w{};
};

using Faces = std::span<const Corners* const>;
const Corners& face(Faces faces, std::size_t l) {
  return *faces[std::min(l, faces.size() - 1)];
}

/// Charts of the lanes.
struct LaneCharts {
  explicit LaneCharts(const Surface& surface) : implicit(surface.is_implicit()), charts(surface) {
    if (implicit) f0.emplace(surface), f1.emplace(surface);
  }

  static Model linear(Faces faces, std::size_t k) {
    std::array<Lanes, 3> at;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t l = 0; l < Lanes::count; ++l) at[i].x[l] = face(faces, l)[i][k];
    return Model::linear(at[0], at[1], at[2]);
  }

  /// Charts::operator(). False: something is undefined.
  bool chart(Faces faces, ChartLanes& c) {
    for (std::size_t k = 0; k < (implicit ? 3 : 2); ++k) c.x[k] = linear(faces, k);
    c.live = kernel::kAllLanes;
    if (!implicit) return true;
    for (std::size_t k = 0; k < 3; ++k) c.m[k] = linear(faces, 3 + k);
    for (std::size_t l = 0; l < Lanes::count; ++l)
      c.h.x[l] = l < faces.size() ? charts.guess_reach(*faces[l]) : c.h.x[l - 1];
    const Models p = c.x;
    if (!solve_fibres(c)) return false;
    if (c.live == 0) return true;
    for (std::size_t l = 0; l < faces.size(); ++l)
      if (has(c.live, l) && !jacobian_is_positive(*faces[l], c.h.x[l]))
        c.live &= ~(LaneMask{1} << l);
    for (std::size_t k = 0; k < 3; ++k) c.x[k] = p[k] + c.s * c.m[k];
    return true;
  }

  /// Charts::solve_fibres of c.x: c.s, the last c.h, and who has them.
  bool solve_fibres(ChartLanes& c) {
    constexpr int kTries = 4;
    Models p = c.x, m = c.m;
    Lanes h = c.h;
    LaneMask open = c.live, solved = 0;
    for (int i = 0; i < kTries; ++i) {
      for (std::size_t l = 0; l < Lanes::count; ++l)
        if (!(h.x[l] < HUGE_VAL)) open &= ~(LaneMask{1} << l);
      if (open == 0) break;
      revive(open, p[0], p[1], p[2], m[0], m[1], m[2], h);
      if (!step(p, m, h, open)) return false;
      for (std::size_t l = 0; l < Lanes::count; ++l) {
        if (!has(open, l) || !(needed.x[l] < h.x[l])) continue;
        open &= ~(LaneMask{1} << l);
        solved |= LaneMask{1} << l;
        c.h.x[l] = h.x[l];
        for (std::size_t r = 0; r < c.s.rows.size(); ++r) c.s.rows[r].x[l] = s.rows[r].x[l];
      }
      for (std::size_t l = 0; l < Lanes::count; ++l) h.x[l] = 2 * needed.x[l];
    }
    c.live = solved;
    if (solved != 0) revive(solved, c.s);
    return true;
  }
  /// One try for the open lanes, of which some may fail.
  bool step(Models& p, Models& m, const Lanes& h, LaneMask& open) {
    const Model fibre = Model::around(0, h);
    Models at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = p[k] + fibre * m[k];
    const auto f = (*f1)(at);
    Model slope = f.coefficient(1, 0, 0) * m[0] + f.coefficient(0, 1, 0) * m[1] +
                  f.coefficient(0, 0, 1) * m[2];
    if (!is_defined(f) || !is_defined(slope)) return false;
    open &= positive(slope.range());
    if (open == 0) return true;
    revive(open, slope);
    const Model inverse_slope = inverse(slope);
    const Model start = polynomial(-(polynomial(f[0]) * polynomial(inverse_slope)));
    for (std::size_t k = 0; k < 3; ++k) at[k] = p[k] + start * m[k];
    const auto value = (*f0)(at);
    s = start - value[0] * inverse_slope;
    if (!is_defined(value) || !is_defined(s)) return false;
    const LaneRanges reached = start.range(), r = s.range();
    for (std::size_t l = 0; l < Lanes::count; ++l)
      needed.x[l] = std::max({-r.low.x[l], r.high.x[l], -reached.low.x[l], reached.high.x[l]});
    return true;
  }

  bool implicit;
  Charts<FaceModel> charts;
  std::optional<ImplicitMap<Model, 0>> f0;
  std::optional<ImplicitMap<Model, 1>> f1;
  Model s;           ///< of the latest step
  Lanes needed = 0;  ///< by it
};

}  // namespace

struct FaceLanes::State {
  explicit State(const Surface& surface) : implicit(surface.is_implicit()), charts(surface) {
    if (implicit)
      f3.emplace(surface), f4.emplace(surface);
    else
      x3.emplace(surface), x4.emplace(surface);
  }

  /// Without derivatives.
  bool values(Faces faces, ChartLanes& c, std::span<Start> starts) {
    Extremalities<0, Model> out;
    Selection who;
    LaneMask& live = who.live = c.live;
    if (implicit) {
      FrameLanes frame;
      const auto any = static_cast<std::size_t>(std::countr_zero(live));
      for (std::size_t l = 0; l < Lanes::count; ++l)
        frame.set(l, nearest_frame(mean_normal(face(faces, has(live, l) ? l : any))));
      auto f = in_frame((*f3)(c.x), frame.vectors);
      if (!is_defined(f)) return false;
      live &= positive(f.coefficient(0, 0, 1).range());
      for (std::size_t l = 0; l < starts.size(); ++l) {
        if (has(c.live, l)) starts[l].frame = frame.number[l];
        if (has(live, l)) starts[l].passed = Passed::slope;
      }
      if (live == 0) return true;
      revive(live, f);
      const GraphGeometry<Model, 3> graph{GraphJet<Model, 3>::of(f, 2)};
      if (!measure<0>(graph, out, who)) return false;
    } else if (!measure<0>(MapGeometry<Model, 3>{(*x3)({c.x[0], c.x[1]})}, out, who)) {
      return false;
    }
    for (std::size_t l = 0; l < starts.size(); ++l) {
      if (!has(live, l)) continue;
      starts[l].passed = has(who.wide, l) ? Passed::wide : Passed::regular;
      starts[l].w = who.w[l];
      if (!has(who.wide, l)) extract(out, l, starts[l].values);
    }
    return true;
  }

  template <int K>
  static void extract(const Extremalities<K, Model>& from, std::size_t l, Extremalities<K>& to) {
    for (std::size_t j = 0; j < 2; ++j) {
      to.e[j] = lane_of(from.e[j], l);
      for (std::size_t d = 0; d < 2; ++d) to.v[j][d] = lane_of(from.v[j][d], l);
    }
  }

  /// FaceTest's: `live` loses who is not regular. False: something is undefined.
  template <int K, class Geometry>
  static bool measure(const Geometry& geometry, Extremalities<K, Model>& out, Selection& who) {
    LaneMask& live = who.live;
    const auto forms = forms_of<K>(geometry);
    const auto shape = shape_of(forms.i, forms.l);
    auto squared = squared_sigma(shape);
    if (!is_defined(squared)) return false;
    live &= positive(squared[0].range());
    if (live == 0) return true;
    revive(live, squared);
    auto sigma = sqrt(squared);
    if (!is_defined(sigma)) return false;
    const LaneMask narrow = positive(sigma[0].range());
    std::array<Lanes, 2> w;
    for (std::size_t l = 0; l < Lanes::count; ++l) {
      std::uint8_t& number = who.w[l];
      if (!who.known)
        number = has(live, l) ? along_first(shape.a[0].rows[0].x[l], shape.b[0].rows[0].x[l],
                                            shape.c[0].rows[0].x[l], sigma[0].rows[0].x[l])
                              : std::uint8_t{0};
      for (std::size_t d = 0; d < 2; ++d) w[d].x[l] = direction(number)[d];
    }
    const auto aw = times(shape, w);
    const auto along = transverse(forms.i, aw, w);
    if (!is_defined(along)) return false;
    live &= positive(along[0].range());
    who.wide = live & ~narrow;
    if ((live & narrow) == 0) return true;
    if (who.wide != 0) revive(live & narrow, sigma);
    out.v[0] = first_principal(aw, sigma, w);
    out.v[1] = second_principal(forms.i, out.v[0]);
    for (std::size_t j = 0; j < 2; ++j) out.e[j] = extremality(forms, out.v[j]);
    return is_defined(out.e[0]) && is_defined(out.e[1]);
  }

  bool implicit;
  LaneCharts charts;
  std::optional<ImplicitMap<Model, 3>> f3;
  std::optional<ImplicitMap<Model, 4>> f4;
  std::optional<ParametricMap<Model, 3>> x3;
  std::optional<ParametricMap<Model, 4>> x4;
};

FaceLanes::FaceLanes(const Surface& surface) : state_(std::make_unique<State>(surface)) {}
FaceLanes::~FaceLanes() = default;
FaceLanes::FaceLanes(FaceLanes&&) noexcept = default;

bool FaceLanes::start(std::span<const Corners* const> faces, std::span<Start> starts) {
  ChartLanes c;
  if (!state_->charts.chart(faces, c)) return false;
  const std::array<LaneRanges, 3> image = {c.x[0].range(), c.x[1].range(), c.x[2].range()};
  for (std::size_t l = 0; l < faces.size(); ++l) {
    starts[l].passed = has(c.live, l) ? Passed::chart : Passed::none;
    if (!has(c.live, l)) continue;
    Chart<FaceModel>& chart = starts[l].chart;
    for (std::size_t k = 0; k < 3; ++k) chart.x[k] = c.x[k].lane(l), chart.m[k] = c.m[k].lane(l);
    chart.s = c.s.lane(l);
    chart.h = c.h.x[l];
    for (std::size_t k = 0; k < 3; ++k) starts[l].image[k] = image[k][l];
    if (!state_->implicit) Charts<FaceModel>::directions(chart, *faces[l]);
  }
  if (c.live == 0) return true;
  revive(c.live, c.x[0], c.x[1], c.x[2]);
  return state_->values(faces, c, starts);
}

bool FaceLanes::derive(std::span<const Start* const> starts, std::span<Derived> derived) {
  const auto start = [&](std::size_t l) -> const Start& {
    return *starts[std::min(l, starts.size() - 1)];
  };
  Models x;
  Selection who{.known = true};
  FrameLanes frame;
  for (std::size_t l = 0; l < kCount; ++l) {
    for (std::size_t k = 0; k < 3; ++k) x[k].set_lane(l, start(l).chart.x[k]);
    who.w[l] = start(l).w;
    frame.set(l, start(l).frame);
  }
  Extremalities<1, Model> out;
  if (state_->implicit) {
    const auto by_xyz = (*state_->f4)(x);
    const auto f = in_frame(by_xyz, frame.vectors);
    if (!is_defined(f) || positive(f.coefficient(0, 0, 1).range()) != kernel::kAllLanes)
      return false;
    const GraphGeometry<Model, 4> graph{GraphJet<Model, 4>::of(f, 2)};
    if (!State::measure<1>(graph, out, who)) return false;
    for (std::size_t l = 0; l < derived.size(); ++l)
      derived[l].gradient = {by_xyz.coefficient(1, 0, 0).lane(l),
                             by_xyz.coefficient(0, 1, 0).lane(l),
                             by_xyz.coefficient(0, 0, 1).lane(l)};
  } else if (!State::measure<1>(MapGeometry<Model, 4>{(*state_->x4)({x[0], x[1]})}, out, who)) {
    return false;
  }
  for (std::size_t l = 0; l < derived.size(); ++l) {
    if (!has(who.live, l)) continue;
    derived[l].passed = has(who.wide, l) ? Passed::wide : Passed::regular;
    if (!has(who.wide, l)) State::extract(out, l, derived[l].values);
  }
  return true;
}

}  // namespace crest::smooth_ridges
