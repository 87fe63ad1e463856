// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes_curves/places.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/exact/tensor_field.hpp"

namespace crest::certify::curves {
namespace {

/// Calls found(i, place of list[i] among the faces). Both ascend.
template <class Found>
void find_all(const std::vector<std::array<u32, 3>>& list, const std::vector<TetFace>& faces,
              const Found& found) {
  require(std::ranges::is_sorted(list, std::less_equal<>()), "faces: not ascending");
  for (u32 i = 0; i < list.size(); ++i) {
    const u32 face = find_face(faces, list[i]);
    require(face != kNoTet, "faces: no face ({}, {}, {})", list[i][0], list[i][1], list[i][2]);
    found(i, face);
  }
}

}  // namespace

Places::Places(const ModesCurvesCertificate& c, Verdict& verdict) : c_(c) {
  read_tets(verdict);
  read_special();
  read_faces();
  read_points();
  read_arcs();
}

void Places::read_tets(Verdict& verdict) {
  require(c_.points.size() >= 4 && !c_.tets.empty() && c_.tets.size() < modes::kNone / 16,
          "data: no tetrahedra, or too many");
  tets_ = c_.tets;
  for (auto& t : tets_) {
    std::ranges::sort(t);
    require(t[3] < c_.points.size(), "data: no vertex {}", t[3]);
    require(t[0] != t[1] && t[1] != t[2] && t[2] != t[3], "data: a tetrahedron has a corner twice");
  }
  faces_ = list_faces(tets_, c_.points.size());
  prove(verdict, "data: {} vertices, {} tetrahedra; digests match", c_.points.size(),
        c_.tets.size());
}

void Places::read_special() {
  require(std::ranges::is_sorted(c_.special_tets, std::less_equal<>()) &&
              (c_.special_tets.empty() || c_.special_tets.back() < tets_.size()),
          "special tetrahedra: not ascending, or not there");
  special_tet_.assign(tets_.size(), 0);
  for (const u32 t : c_.special_tets) special_tet_[t] = 1;
  special_face_.assign(faces_.size(), 0);
  find_all(c_.special_faces, faces_, [&](u32, u32 face) { special_face_[face] = 1; });
}

void Places::read_faces() {
  listed_.assign(faces_.size(), kNoTet);
  face_of_.resize(c_.faces.size());
  around_.assign(tets_.size(), {kNoTet, kNoTet, kNoTet, kNoTet});
  find_all(c_.faces, faces_, [&](u32 i, u32 face) {
    require(!special_face(face), "special faces: one has points");
    listed_[face] = i;
    face_of_[i] = face;
    for (const u32 t : faces_[face].tets) {
      if (t == kNoTet) continue;
      const auto& corners = faces_[face].corners;
      for (unsigned k = 0; k < 4; ++k)
        if (std::ranges::find(corners, tets_[t][k]) == corners.end()) around_[t][k] = i;
    }
  });
}

void Places::read_points() {
  boxes_.resize(c_.faces.size());
  for (u32 i = 0; i < c_.face_points.size(); ++i) {
    const DegeneratePoint& p = c_.face_points[i];
    require(p.face < c_.faces.size() && (i == 0 || c_.face_points[i - 1].face <= p.face),
            "points: not by face");
    require(p.type == 1 || p.type == -1, "points: type {}", int{p.type});
    for (unsigned k = 0; k < 2; ++k)
      require(std::isfinite(p.low[k]) && std::isfinite(p.high[k]), "points: {} has no box", i);
    for (const Box& box : boxes_[p.face]) {
      bool apart = false;
      for (unsigned k = 0; k < 2; ++k) apart |= box.high[k] <= p.low[k] || p.high[k] <= box.low[k];
      require(apart, "points: the boxes of {} and {} overlap", box.listed, i);
    }
    require(boxes_[p.face].size() < 4, "points: more than four on a face");
    boxes_[p.face].push_back({p.low, p.high, p.type, i});
  }
  for (std::size_t f = 0; f < boxes_.size(); ++f)
    require(!boxes_[f].empty(), "faces: {} has no point", f);
}

void Places::read_arcs() {
  const auto key = [](const DegenerateArc& a) { return std::tuple(a.tet, a.points); };
  first_arc_.assign(tets_.size() + 1, 0);
  for (std::size_t i = 0; i < c_.arcs.size(); ++i) {
    require(c_.arcs[i].tet < tets_.size() && (i == 0 || key(c_.arcs[i - 1]) < key(c_.arcs[i])),
            "arcs: not ascending");
    for (const u32 p : c_.arcs[i].points)
      require(p < c_.face_points.size(), "arcs: no point {}", p);
    ++first_arc_[c_.arcs[i].tet + 1];
  }
  for (std::size_t t = 0; t < tets_.size(); ++t) first_arc_[t + 1] += first_arc_[t];
}

}  // namespace crest::certify::curves
