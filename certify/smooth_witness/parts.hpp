// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The parts of record_witnesses(). Each throws Reject where a statement is not shown.
#include "certify/ridges_smooth/patches.hpp"
#include "certify/ridges_smooth/sheet.hpp"

namespace crest::certify::witness {

using smooth::Claim;
using smooth::Ranges;
using u32 = std::uint32_t;

/// The least k with 2^k >= x. Throws Reject unless x is positive and finite.
int exponent_above(double x, const char* what, std::size_t number);
inline double middle(const kernel::Range& r) {
  return r.low / 2 + r.high / 2;
}
/// Appends floats' and doubles' bytes.
void put_f32(Bytes& out, double x);
void put_f64(Bytes& out, double x);
/// A direction number near the larger eigenvector of the matrix (a b; c -a).
unsigned direction_near(double a, double b, double c);
/// a and b over the larger of the two, as floats.
std::array<double, 2> as_floats(double a, double b);
/// Combinations of two functions with these values that are worth trying.
std::vector<std::array<double, 2>> combinations(const std::array<kernel::Range, 2>& e);

/// Kind 0: exponents of lengths that the faces' feet are well within, or the patches' heights,
/// which get their graph here.
std::vector<int> face_reaches(const Claim& claim);
std::vector<int> patch_reaches(const smooth::Surface& surface, RidgesSmoothCertificate& c);

/// All faces' witnesses, and the loose corners. Requires: their first bytes (kind 0). Returns the
/// boxes of their images.
std::vector<std::optional<Ranges>> record_faces(const Claim& claim, RidgesSmoothCertificate& c);
void record_patches(const Claim& claim, RidgesSmoothCertificate& c);
void record_sheets(const Claim& claim, RidgesSmoothCertificate& c,
                   const std::vector<std::optional<Ranges>>& boxes);
/// Graph boxes and the tree.
void record_completeness(const Claim& claim, RidgesSmoothCertificate& c);

/// Pieces of a box with one sign each; false if the deepest leave it open.
bool record_box(smooth::BoxProver<kernel::Interval>& prover, const smooth::Box& box,
                const std::array<double, 3>* direction, std::uint8_t leaf, int depth, Bytes& out);

}  // namespace crest::certify::witness
