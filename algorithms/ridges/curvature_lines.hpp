// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lines of curvature on a mesh, followed from edge to edge. In a triangle whose principal vectors
// agree by the acute rule on all three sides the direction at barycentric coordinates l is the sum
// of l_i d_i, projected into the plane; the line crosses the triangle by the midpoint rule. Other
// triangles (conflicts, frames at right angles) are passed straight on while the line is not longer
// than a given reach. Where the directions on both sides of an edge lead to it, the line slides
// along it to its end.
#include <array>
#include <vector>

#include "algorithms/ridges/ridges.hpp"

namespace crest::ridges {

/// The direction fields of both colours, made where they are asked for: lines visit few of the
/// faces, and all of them would be 112 bytes a face. Requires: mesh and forms stay.
class CurvatureLines {
 public:
  CurvatureLines(const kernel::TriangleMesh& mesh, const std::vector<kernel::MongeForm>& forms)
      : mesh_(mesh), forms_(forms) {}

  /// Velocities of barycentric coordinates 1 and 2 (that of 0 is minus their sum).
  using Velocity = std::array<double, 2>;
  struct Field {
    std::array<Velocity, 3> corner{};   ///< d at the corners, signs agreeing with corner 0's
    std::array<std::int8_t, 3> sign{};  ///< those signs; 0: the triangle is not coherent
    bool coherent() const { return sign[0] != 0; }
  };

  const kernel::TriangleMesh& mesh() const { return mesh_; }
  Field field(Index f, Colour c) const;                     ///< some 150 operations
  Velocity velocity(Index f, const Vec3& direction) const;  ///< of a direction, projected
  Vec3 direction(Index f, const Velocity& v) const;
  /// The principal direction at the point (1 - weight) p + weight q of edge (p, q); 0 if those of
  /// its ends are perpendicular.
  Vec3 direction_on(Index edge, double weight, Colour c) const;
  Vec3 principal(Index v, Colour c) const {
    return c == Colour::blue ? forms_[v].d1 : kernel::minimal_direction(forms_[v]);
  }

 private:
  const kernel::TriangleMesh& mesh_;
  const std::vector<kernel::MongeForm>& forms_;
};

/// A walk along a line of curvature from a point on an edge.
class LineWalk {
 public:
  /// From the point (1 - weight) p + weight q of edge (p, q); forward: along direction_on, else
  /// against it. straight: the length from which nothing is passed straight on.
  LineWalk(const CurvatureLines& lines, Index edge, double weight, Colour colour, bool forward,
           double straight);

  /// Goes on to where the line leaves the triangle. False: it ends here.
  bool step();

  double length() const { return length_; }
  /// Where the walk is: (1 - weight()) vertex(0) + weight() vertex(1).
  Index vertex(int i) const { return ends_[static_cast<std::size_t>(i)]; }
  double weight() const { return weight_; }

 private:
  using Velocity = CurvatureLines::Velocity;
  struct Exit {
    std::size_t corner;  ///< the line leaves through the side opposite
    double time;
  };
  void enter(Index face, Index p, Index q);
  void enter_at(Index vertex);
  void look();
  enum class Lead { in, back, nowhere };
  Lead velocity_here(Velocity& v);
  bool slide();
  void go_to(const Vec3& next);
  Exit exit(const Velocity& v) const;
  void move(const Velocity& v, const Exit& exit);

  const CurvatureLines& lines_;
  Colour colour_;
  double straight_;
  Index face_ = kernel::kNone;
  CurvatureLines::Field field_;  ///< of that face, if known_: few walks use their last one
  bool known_ = false;
  std::array<double, 3> at_{};  ///< barycentric
  std::size_t from_ = 0;        ///< the corner opposite the side of entry
  int sign_ = 0;     ///< of the field at corner 0, as the line uses it; 0: take direction_'s
  int carried_ = 0;  ///< the same at ends_[0], from the face before
  Vec3 direction_{}, point_{};
  double length_ = 0;
  int steps_ = 0;
  std::array<Index, 2> ends_{};
  double weight_ = 0;
};

}  // namespace crest::ridges
