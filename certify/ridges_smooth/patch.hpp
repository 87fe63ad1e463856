// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One umbilic with one model type (SPEC.md, "Patches"): the surface over a piece
// of the plane of its two coordinates, the umbilic's box (2, 5), the blow-up (4).
#include "certify/ridges_smooth/blow_up.hpp"
#include "certify/ridges_smooth/foot.hpp"

namespace crest::certify::smooth {

/// Points of the coordinate plane within `error` of a triangle, in each coordinate.
struct PlaneTriangle {
  std::array<std::array<double, 2>, 3> corner;
  double error;
};

/// Not for two threads at a time.
template <class M>
class PatchProver {
 public:
  /// sign: of F_m on the patch (kind 0), +1 or -1.
  PatchProver(const Surface& surface, const SmoothPatchRecord& patch, double sign);

  /// 2: the umbilic lies in U0.
  bool has_umbilic();
  /// 5: the sign of det D(a, b) on U0.
  kernel::MaybeSign index();
  /// 4: the number of branches of each colour. Nothing if undecided.
  std::optional<std::array<std::uint32_t, 2>> branches();
  /// An enclosure of h on U0 (kind 0).
  std::optional<kernel::Range> height();

 private:
  /// Intervals of 2 / 2^kFirstDepth; new enclosures at every kSectorStep-th depth up to
  /// kSectorDepth.
  static constexpr int kFirstDepth = 2, kSectorStep = 3, kSectorDepth = 8, kDepth = 14;

  /// All forms with second derivatives, the first two with third ones.
  struct PlaneForms {
    Forms<M, 2> forms;
    FirstSecond<M, 3> second;
  };
  /// An interval of t on a side of Q where a colour is decided.
  struct Leaf {
    int side;
    double t0, t1;
    std::size_t sector;  ///< in sectors_
    bool branch;         ///< E_t has the sign, else E
    int sign;
  };
  struct Sector {
    FanSector<M> fan;
    std::array<double, 2> w;
  };

  std::optional<std::array<M, 3>> lift(const PlaneTriangle& triangle);
  std::optional<PlaneForms> forms(const PlaneTriangle& triangle);
  double height_near(const std::array<double, 2>& at);
  bool find_centre();
  std::optional<Sector> make_sector(int side, double t0, double t1);
  /// Appends leaves for the colours of `open` (bits); false if undecided at the greatest depth.
  bool divide(int side, double t0, double t1, int depth, std::size_t sector, unsigned open);
  std::optional<int> turn(const Leaf& from, const Leaf& to);
  std::optional<std::uint32_t> count(const std::vector<Leaf>& leaves);

  SurfaceEvaluator<M> surface_;
  const SmoothPatchRecord& patch_;
  double sign_;
  std::size_t p_, q_, m_;  ///< kind 0: the axes of the coordinates and of the height
  double radius_, slack_;  ///< at least R1; what rounding adds to a coordinate
  std::optional<kernel::Evaluator<kernel::Jet<double, 3, 1>>> approximate_;
  std::optional<FanCentre<M>> centre_;
  std::vector<Sector> sectors_;
  std::array<std::vector<Leaf>, 2> leaves_;
};

}  // namespace crest::certify::smooth
