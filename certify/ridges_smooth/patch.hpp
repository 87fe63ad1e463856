// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One umbilic with one model type (SPEC.md, "Patches" and "Witnesses"): the surface over a piece
// of the plane of its two coordinates, the umbilic's box (2, 5), the blow-up (4).
#include "certify/ridges_smooth/blow_up.hpp"
#include "certify/ridges_smooth/foot.hpp"
#include "certify/ridges_smooth/witness.hpp"

namespace crest::certify::smooth {

/// Points of the coordinate plane within `error` of a triangle, in each coordinate.
struct PlaneTriangle {
  std::array<std::array<double, 2>, 3> corner;
  double error;
};

/// An interval of t on a side of Q.
struct RayInterval {
  int side;
  double t0, t1;

  double middle() const { return t0 / 2 + t1 / 2; }
  RayInterval half(bool second) const {
    return second ? RayInterval{side, middle(), t1} : RayInterval{side, t0, middle()};
  }
};

/// Codes of a colour on an interval.
enum RayCode : unsigned { kOpen = 0, kFree = 1, kRunning = 2, kSaidAbove = 3 };

/// Not for two threads at a time.
template <class M>
class PatchProver {
 public:
  /// sign: of F_m on the patch (kind 0), +1 or -1; reach: h of its fibres (kind 0).
  PatchProver(const Surface& surface, const SmoothPatchRecord& patch, double sign, double reach);

  /// 2: the umbilic lies in U0.
  bool has_umbilic();
  /// 5: the sign of det D(a, b) on U0.
  kernel::MaybeSign index();
  /// An enclosure of h on U0 (kind 0).
  std::optional<kernel::Range> height();
  /// 4: the number of branches of each colour. Throws Undecided.
  std::array<std::uint32_t, 2> branches(WitnessReader& in);

  // What those are made of, and what makes a witness.

  /// D(a, b) on U0, by rows; nothing if undecided.
  std::optional<std::array<kernel::Range, 4>> derivative();
  /// P_11, P_12, P_21 at r = 0 on the middle ray. Requires: derivative().
  std::array<kernel::Range, 3> shape_along(const RayInterval& t) const;
  /// Encloses on the triangle of rays, with the direction number w. False: undecided.
  bool add_sector(const RayInterval& t, unsigned w);
  /// The number of the sector that intervals are in: the latest added, or that used.
  std::size_t sector() const { return sector_; }
  void use_sector(std::size_t sector) { sector_ = sector; }
  /// On the two triangles of (r, t) of an interval; nothing if undecided, or without a sector.
  using Forms2 = std::array<RayForms<M>, 2>;
  std::optional<Forms2> interval(const RayInterval& t) const;
  /// The one sign of E_j (free), or of dE_j/dt (running); 0 if undecided.
  static int free_sign(const Forms2& f, std::size_t j);
  static int running_sign(const Forms2& f, std::size_t j, const std::array<double, 2>& combination);

 private:
  static constexpr int kDepth = 16;
  static constexpr std::size_t kNoSector = SIZE_MAX;

  /// All forms with second derivatives, the first two with third ones.
  struct PlaneForms {
    Forms<M, 2> forms;
    FirstSecond<M, 3> second;
  };
  struct Leaf {
    RayInterval t;
    std::size_t sector;  ///< in sectors_
    bool running;        ///< E_t has the sign, else E
    int sign;
  };
  struct Sector {
    FanSector<M> fan;
    std::array<double, 2> w;
  };

  std::optional<std::array<M, 3>> lift(const PlaneTriangle& triangle);
  std::optional<PlaneForms> forms(const PlaneTriangle& triangle);
  bool find_centre();
  /// Appends a leaf of colour j, whose forms are f; in MPFR, of lower order than the witness was
  /// made with, perhaps those of parts. False: undecided.
  bool say(const RayInterval& t, const std::optional<Forms2>& f, std::size_t j, RayCode code,
           const std::array<double, 2>& combination, int further);
  /// Appends leaves for the colours of `open` (bits).
  void divide(const RayInterval& t, int depth, unsigned open, WitnessReader& in);
  std::optional<int> turn(const Leaf& from, const Leaf& to);
  std::optional<std::uint32_t> count(const std::vector<Leaf>& leaves);

  SurfaceEvaluator<M> surface_;
  const SmoothPatchRecord& patch_;
  double sign_, reach_;
  std::size_t p_, q_, m_;  ///< kind 0: the axes of the coordinates and of the height
  double radius_, slack_;  ///< at least R1; what rounding adds to a coordinate
  std::optional<FanCentre<M>> centre_;
  std::vector<Sector> sectors_;
  std::size_t sector_ = kNoSector;
  std::array<std::vector<Leaf>, 2> leaves_;
};

}  // namespace crest::certify::smooth
