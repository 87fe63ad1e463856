// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Patches", condition 4, and "Enclosures along rays": the blow-up of an umbilic.
#include "certify/second/chart.hpp"

namespace crest::recheck {

using Balls = std::vector<Ball>;

/// Taylor coefficients by degree of I (3), the entries of A (3) and the coefficients of E (6), as
/// numbers that enclose them on all of a set.
struct Coefficients {
  std::array<std::vector<Balls>, 3> i, e;
  std::array<std::vector<Balls>, 4> a;
};
/// Of jets of degree 3 (of E: 2).
Coefficients coefficients(const Forms<Model>& f);

/// [low, high] in two coordinates, as two triangles.
struct Rectangle {
  std::array<Ball, 2> low, high;
  std::vector<Rectangle> children() const;
  /// The coordinates on (low, low), then (high, low) or (low, high), then (high, high).
  std::array<Model, 2> triangle(bool second) const;
};

/// An interval of t on one of the four sides.
struct Arc {
  int side;
  double t0, t1;
};
std::array<Ball, 2> ray_at(int side, double t);

enum class Kind { open, free, running, said };

/// What is said of the colours on an arc; `w` is a direction.
struct Statement {
  Arc arc;
  std::array<Kind, 2> kind;
  std::array<double, 2> combination;
  int w;
};

class Rays {
 public:
  Rays() = default;
  Rays(Coefficients at_umbilic, const Ball& length) : at_(std::move(at_umbilic)), length_(length) {}

  /// The signs of E_j (free) or dE_j / dt (running) on the arc, [D^k] over its sector.
  /// Throws: Open, Undefined.
  std::array<int, 2> show(const Statement& s, const Coefficients& sector) const;
  /// The sign of I(v1, w') at r = 0 and the end of an arc.
  int change_of_frame(const Arc& arc, int w, int next) const;

 private:
  void show_on(const Statement& s, const Coefficients& sector, const std::array<Model, 2>& at,
               std::array<int, 2>& signs) const;

  Coefficients at_;
  Ball length_;
};

/// An interval in the sequence of a colour once around.
struct RayInterval {
  bool free;
  int sign;    ///< of E_j, or running, of dE_j / dt
  int change;  ///< of the frame from this interval to the next
};
/// Throws: Rejected where neighbouring intervals do not fit.
int count_branches(const std::vector<RayInterval>& around);

}  // namespace crest::recheck
