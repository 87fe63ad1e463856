// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Statements about one face, or a piece of it, with one model type (SPEC.md, "Triangulation",
// "Faces outside patches" and "Witnesses").
#include <span>
#include <tuple>
#include <vector>

#include "certify/ridges_smooth/foot.hpp"
#include "certify/ridges_smooth/forms.hpp"
#include "certify/ridges_smooth/mesh.hpp"

namespace crest::certify::smooth {

enum Statement : unsigned {
  kChart = 1,    ///< (F), (J)
  kRegular = 2,  ///< F_m has one sign (kind 0), (R)
  kVerdict = 4,  ///< of blue; red: times 2
  kType = 16,    ///< of blue; red: times 2
  kPurple = 64,
  kInside = 128  ///< of a face in a patch
};

/// How the statements of a piece are shown.
struct Method {
  std::array<bool, 2> turn{};  ///< kType by det(grad E_j, grad G_j), else by the sign of G_j
  bool cross = false;          ///< kPurple by det(grad E1, grad E2), else by a combination
  bool steep = false;
  std::array<double, 2> combination{};  ///< of E1 and E2

  static Method of_byte(unsigned bits) {
    return {{(bits & 1U) != 0, (bits & 2U) != 0}, (bits & 4U) != 0, false, {}};
  }
};

/// Who makes witnesses chooses here while a piece is evaluated; a checker has none.
class Advisor {
 public:
  virtual ~Advisor() = default;
  virtual bool steep(const kernel::Range& a11) = 0;
  /// Combinations of two functions worth trying; their values, and derivatives by both coordinates.
  virtual std::vector<std::array<double, 2>> combinations(
      const std::array<std::array<kernel::Range, 3>, 2>& e) = 0;
};

/// E_j, its derivative along an edge of the face, or G_j.
enum class Quantity : std::uint8_t { value, along_edge, growth };
struct Question {
  std::uint32_t face;
  std::size_t colour;  ///< 0 blue, 1 red
  Quantity quantity;
  std::size_t edge;  ///< from this corner to the next
};

/// Found on the whole piece on the way; by colour for those with a direction c.
struct FaceFindings {
  /// In: bits of edges where the derivative along them, or E_j, is asked for.
  std::array<unsigned, 2> ask_slope{}, ask_value{};
  std::optional<std::array<kernel::Range, 3>> box;  ///< kind 0: of the image
  /// Of E_j at the corners and on the edges, of the derivative along the edges.
  std::array<std::array<kernel::MaybeSign, 3>, 2> corner{}, value{}, slope{};
};

/// Not for two threads at a time.
template <class M>
class FaceProver {
 public:
  FaceProver(const Surface& surface, const RidgesSmoothCertificate& c) : surface_(surface), c_(c) {}

  /// The statements of `open` that are not proven on the piece. `findings` may be null; so is the
  /// advisor of a checker, and then the method is only read.
  unsigned prove(std::uint32_t face, const Piece& piece, unsigned open, Method& method,
                 FaceFindings* findings, Advisor* advisor = nullptr);
  /// The one sign on the piece, if it is certain.
  kernel::MaybeSign sign(const Question& q, const Piece& piece);

  /// Kind 0: the points of S over the piece, their derivatives by l1 and l2 at constant sum.
  struct Image {
    std::array<M, 3> x;
    std::array<std::array<M, 3>, 2> derivative;
  };
  std::optional<Image> image(std::uint32_t face, const Piece& piece, bool with_derivatives);

  template <int K>
  struct Extremality {
    Local<M, K> e;
    std::array<Local<M, K>, 2> v;
    M growth() const;                   ///< G; K >= 1
    M turn() const;                     ///< det(grad E, grad G); K = 2
    M slope(double x, double y) const;  ///< (x, y) . grad E
  };
  /// What is known of a whole face before its statements are asked for (FaceLanes), as far as it
  /// came: the foot; F_m > 0 and (R), then all.
  template <int K>
  struct WholeFace {
    std::uint32_t face = 0;
    bool placed = false, regular = false, steep = false;
    std::array<M, 3> x, m, gradient;  ///< kind 0; grad F in the face's frame
    M s;
    std::array<bool, 2> no_zero{};      ///< of colours that are said to have none
    std::array<Extremality<K>, 2> e{};  ///< of the others; K = 1
  };
  /// Of the next faces.
  template <int K>
  void prepare(std::vector<WholeFace<K>> faces) {
    std::get<K>(prepared_) = std::move(faces);
  }

 private:
  using Vector3 = std::array<M, 3>;
  using Vector2 = std::array<M, 2>;
  /// The point Phi(l) on the piece. Kind 0: x, m, s; kind 1: u, v.
  struct Place {
    Vector3 x, m;
    M s, u, v;
  };
  template <int K>
  struct Jets {
    Forms<M, K> forms;
    std::array<Vector2, 3> edge;  ///< derivative of the coordinates along each edge
  };

  M affine(std::uint32_t face, std::size_t coordinate, const Piece& piece,
           const std::array<M, 3>& l) const;
  std::optional<Place> place(std::uint32_t face, const Piece& piece);
  /// x_j - x_i + s (N_j - N_i): along an edge at constant s.
  Vector3 step(const Place& at, std::uint32_t face, std::size_t i, std::size_t j) const;
  bool keeps_orientation(const Place& at, std::uint32_t face) const;
  template <int K>
  std::optional<Jets<K>> jets(const Place& at, std::uint32_t face, bool with_edges);
  /// Jets::edge. gradient: kind 0, of F in the face's frame.
  std::array<Vector2, 3> edges(const Place& at, std::uint32_t face, const Vector3& gradient) const;
  template <int K>
  unsigned prove_order(const Place& at, std::uint32_t face, unsigned open, Method& method,
                       FaceFindings* findings, Advisor* advisor);
  /// The same by what is prepared, or nothing if that is not the face.
  template <int K>
  std::optional<unsigned> prove_prepared(std::uint32_t face, unsigned open, Method& method,
                                         FaceFindings* findings, Advisor* advisor);
  /// The statements on the colours with a direction.
  template <int K>
  unsigned prove_colour(std::size_t j, const SmoothFaceRecord& record, const Extremality<K>& e,
                        unsigned open, const Method& method);
  /// Of the statements those that the foot alone shows are taken off.
  void prove_chart(const Place& at, std::uint32_t face, unsigned& open,
                   FaceFindings* findings) const;
  template <int K>
  bool prove_type(std::size_t j, const SmoothFaceRecord& record, const Extremality<K>& e,
                  bool by_turn);
  template <int K>
  bool prove_purple(const Local<M, K>& x, const Local<M, K>& y, Method& method, Advisor* advisor);
  template <int K>
  void find_signs(std::size_t j, const Extremality<K>& e, const std::array<Vector2, 3>& edge,
                  FaceFindings& findings);
  template <int K>
  kernel::MaybeSign sign_order(const Question& q, const Place& at);

  SurfaceEvaluator<M> surface_;
  const RidgesSmoothCertificate& c_;
  std::tuple<std::vector<WholeFace<0>>, std::vector<WholeFace<1>>> prepared_;
};

}  // namespace crest::certify::smooth
