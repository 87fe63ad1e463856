// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where numbers of an attribute stand: at vertices, at faces, or at wedges: corners around a vertex
// that have the same ones (docs/cmc-format.md, "Attributes").
#include <algorithm>
#include <array>
#include <vector>

#include "algorithms/coding/mixer.hpp"
#include "algorithms/coding/surface.hpp"
#include "algorithms/coding/visit_order.hpp"
#include "kernel/geometry/attribute.hpp"

namespace crest::coding {

/// The order of visits, whole: a vertex a time.
std::vector<Index> visit_sequence(const Surface& surface);

/// Places without numbers are no items.
class Items {
 public:
  Items(const Surface& surface, kernel::Site site) : surface_(surface), site_(site) {}

  std::size_t places() const {
    return site_ == kernel::Site::vertices ? surface_.counts().vertices
           : site_ == kernel::Site::faces  ? surface_.face_count()
                                           : 3 * std::size_t{surface_.face_count()};
  }
  /// Items are numbered below it.
  Index count() const { return count_; }
  /// Of a place; kNone: of none.
  Index at(std::size_t place) const { return of_[place]; }
  /// In the order in which their numbers are coded.
  const std::vector<Index>& sequence() const { return sequence_; }

  /// `known`: the items that are coded.
  Surroundings around(Index item, const std::vector<bool>& known) const;
  /// Calls `each` with pairs of items next to one another.
  template <class Each>
  void each_pair(Each&& each) const {
    const auto pair = [&](Index a, Index b) {
      if (a != kNone && b != kNone) each(a, b);
    };
    for (Index h = 0; h < 3 * surface_.face_count(); ++h)
      if (site_ != kernel::Site::faces)
        pair(item_of(h), item_of(next_half(h)));
      else if (surface_.twin(h) != kNone)
        pair(of_[h / 3], of_[surface_.twin(h) / 3]);
  }

  /// Codes where `attribute`, of this site, has numbers, and which corners have the same.
  template <class Range>
  void code(Range& range, const std::vector<Index>& visits, kernel::Attribute& attribute,
            bool gaps);

 private:
  Index item_of(Index h) const {
    return of_[site_ == kernel::Site::vertices ? surface_.from(h) : h];
  }
  template <class Each>
  void each_place(const std::vector<Index>& visits, Each&& each) const {
    if (site_ == kernel::Site::vertices)
      for (const Index v : visits) each(v);
    else if (site_ == kernel::Site::faces)
      for (Index f = 0; f < surface_.face_count(); ++f) each(f);
    else
      for (const Index v : visits) surface_.around(v, each);
  }
  template <class Range>
  void code_gaps(Range& range, const std::vector<Index>& visits, kernel::Attribute& attribute);
  template <class Range>
  void code_wedges(Range& range, Index v, const kernel::Attribute& attribute);

  const Surface& surface_;
  kernel::Site site_;
  Index count_ = 0;
  std::vector<Index> of_, sequence_;
  std::vector<Index> corners_;     ///< of wedges, one after another
  std::vector<std::size_t> ends_;  ///< of each wedge in corners_
  std::vector<Index> turn_;        ///< the corners of one vertex
  std::array<std::array<Counter, 3>, 3> seam_;
  Counter closing_;
};

/// Have two places the same numbers?
bool equal_at(const kernel::Attribute& attribute, std::size_t p, std::size_t q);

template <class Range>
void Items::code_gaps(Range& range, const std::vector<Index>& visits,
                      kernel::Attribute& attribute) {
  std::array<Counter, 2> counter;
  bool before = false;
  if constexpr (!Range::kEncodes) attribute.missing.assign(places(), false);
  each_place(visits, [&](Index place) {
    before = code_alone(range, counter[before ? 1 : 0], attribute.missing[place]);
    if constexpr (!Range::kEncodes) attribute.missing[place] = before;
  });
}

template <class Range>
void Items::code_wedges(Range& range, Index v, const kernel::Attribute& attribute) {
  turn_.clear();
  surface_.around(v, [&](Index h) { turn_.push_back(h); });
  std::vector<bool> starts(turn_.size(), true);
  std::size_t seams = 0;
  for (std::size_t i = 1; i < turn_.size(); ++i) {
    const Index h = turn_[i], before = turn_[i - 1];
    if (attribute.has(h) && attribute.has(before)) {
      // The same edge, seen from its other end.
      const Index here = of_[next_half(h)], there = of_[surface_.twin(h)];
      const std::size_t other = here == kNone && there == kNone ? 0 : here == there ? 1 : 2;
      Counter& counter = seam_[std::min<std::size_t>(seams, 2)][other];
      starts[i] = code_alone(range, counter, Range::kEncodes && !equal_at(attribute, h, before));
    } else {
      starts[i] = attribute.has(h) || attribute.has(before);
    }
    seams += starts[i] ? 1 : 0;
  }
  const Index first = turn_.front(), last = turn_.back();
  if (seams >= 2 && surface_.twin(first) != kNone && attribute.has(first) && attribute.has(last) &&
      code_alone(range, closing_, Range::kEncodes && equal_at(attribute, first, last))) {
    starts[0] = false;
    const auto last_start = std::find(starts.rbegin(), starts.rend(), true).base() - 1;
    const auto shift = last_start - starts.begin();
    std::rotate(starts.begin(), last_start, starts.end());
    std::rotate(turn_.begin(), turn_.begin() + shift, turn_.end());
  }
  for (std::size_t i = 0; i < turn_.size(); ++i) {
    if (!attribute.has(turn_[i])) continue;
    if (starts[i]) {
      sequence_.push_back(count_++);
      ends_.push_back(corners_.size());
    }
    corners_.push_back(turn_[i]);
    ends_.back() = corners_.size();
    of_[turn_[i]] = count_ - 1;
  }
}

template <class Range>
void Items::code(Range& range, const std::vector<Index>& visits, kernel::Attribute& attribute,
                 bool gaps) {
  of_.assign(places(), kNone);
  if (gaps) code_gaps(range, visits, attribute);
  if (site_ == kernel::Site::corners) {
    for (const Index v : visits) code_wedges(range, v, attribute);
    return;
  }
  count_ = static_cast<Index>(places());
  each_place(visits, [&](Index place) {
    if (!attribute.has(place)) return;
    of_[place] = place;
    sequence_.push_back(place);
  });
}

}  // namespace crest::coding
