// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/compression/arrivals.hpp"

#include <algorithm>
#include <set>

#include "certify/container/reject.hpp"

namespace crest::certify::compression {
namespace {

/// A line where it arrives: places ascend, those that cross one side are compared by how they came.
struct Arrival {
  u32 line;
  std::size_t place;
  std::size_t cell;  ///< the last one that leaves through a side, of those that cross one
  bool crosses = false;
};

/// The loops' sides as places: four a side, its part at the tail, at the head, and the head.
class Shore {
 public:
  Shore(const Proof& proof, SignLadder& sign)
      : proof_(proof), sign_(sign), of_side_(proof.field.corners()) {
    const auto& loops = proof.domain.loops;
    starts_.assign(proof.boundary.region_count, 0);
    whole_.assign(proof.boundary.region_count, 0);
    for (u32 i = 0; i < loops.size(); ++i) {
      for (u32 k = 0; k < loops[i].size(); ++k) of_side_[loops[i][k]] = {i, k};
      whole_of_.push_back(find_starts(loops[i], proof.boundary.loops[i].zero != 0));
      if (whole_of_[i] != kNone) whole_[whole_of_[i]] = 1;
    }
  }

  u32 loop(u32 side) const { return of_side_[side][0]; }
  std::size_t in_side(u32 side, bool at_head) const { return 4 * of_side_[side][1] + at_head; }
  std::size_t at_head(u32 side) const { return 4 * of_side_[side][1] + 2; }
  bool is_whole(u32 region) const { return whole_[region] != 0; }
  /// The region that is all of a loop; kNone if it has others, or zeros.
  u32 whole_of(u32 loop) const { return whole_of_[loop]; }
  /// From the region's beginning on.
  std::size_t from_start(u32 region, u32 side, std::size_t place) const {
    const std::size_t all = 4 * proof_.domain.loops[loop(side)].size();
    return (place + all - starts_[region]) % all;
  }

 private:
  /// Returns whole_of().
  u32 find_starts(const std::vector<u32>& sides, bool zero) {
    const auto region = [&](std::size_t end) {
      return proof_.boundary.regions[sides[end / 2]][end % 2];
    };
    std::vector<std::size_t> ends;
    for (std::size_t end = 0; end < 2 * sides.size(); ++end)
      if (region(end) != kNone) ends.push_back(end);
    bool one = true;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const u32 here = region(ends[i]), before = region(ends[(i + ends.size() - 1) % ends.size()]);
      one = one && here == before;
      if (here != before) starts_[here] = 2 * ends[i] - ends[i] % 2;
    }
    if (!one || ends.empty()) return kNone;
    const u32 only = region(ends[0]);
    if (!zero) return only;
    // Between a zero and itself: it begins behind that.
    std::size_t at = 0;
    for (std::size_t end = 0; end < 2 * sides.size(); ++end) {
      const u32 side = sides[end / 2];
      if (is_zero(proof_.field.vector(end % 2 == 0 ? side : next_corner(side))) ||
          has_edge_zero(proof_.field, side, sign_))
        at = end;
    }
    const auto next = std::upper_bound(ends.begin(), ends.end(), at);
    const std::size_t first = next == ends.end() ? ends[0] : *next;
    starts_[only] = 2 * first - first % 2;
    return kNone;
  }

  const Proof& proof_;
  SignLadder& sign_;
  std::vector<std::array<u32, 2>> of_side_;  ///< loop, number along it
  std::vector<std::size_t> starts_;
  std::vector<u8> whole_;
  std::vector<u32> whole_of_;
};

/// ArrivalTable::silent.
std::size_t count_silent(const Proof& proof, const ArrivalTable& table, const Shore& shore) {
  const Domain& domain = proof.domain;
  const auto& lines = proof.stated.separatrices;
  std::set<std::pair<u32, bool>> followed;  // fans of lines through vertices that end; backward
  std::vector<u8> met(domain.loops.size(), 0);
  for (const auto& line : lines) {
    if (line.origin != SkeletonOrigin::vertex || line.end == SkeletonEnd::undecided) continue;
    const u32 fan = domain.fan[line.from];
    followed.insert({fan, line.backward != 0});
    if (domain.open[fan] != 0) met[shore.loop(previous_corner(domain.corners_of(fan).back()))] = 1;
  }
  // A line through an inner vertex would cross an orbit around the place on its other way.
  const auto tells = [&](u32 i) {
    if (lines[i].origin != SkeletonOrigin::vertex) return true;
    const u32 fan = domain.fan[lines[i].from];
    return domain.open[fan] != 0 || followed.count({fan, lines[i].backward == 0}) != 0;
  };
  std::size_t count = 0;
  const auto look = [&](const Place& place) {
    const auto found = table.orders.find(place);
    if (found != table.orders.end())
      for (const auto& group : found->second.lines)
        if (std::any_of(group.begin(), group.end(), tells)) return;
    ++count;
  };
  const auto& zeros = proof.stated.zeros;
  for (u32 z = 0; z < zeros.size(); ++z)
    if (zeros[z].kind == ZeroClass::source || zeros[z].kind == ZeroClass::sink)
      look({Place::zero, z});
  for (u32 i = 0; i < proof.stated.orbits.size(); ++i)
    for (const auto side : {Place::left_of_orbit, Place::right_of_orbit}) look({side, i});
  for (u32 i = 0; i < domain.loops.size(); ++i)
    if (const u32 region = shore.whole_of(i); region != kNone && met[i] == 0)
      look({Place::region, region});
  return count;
}

class ArrivalFinder {
 public:
  ArrivalFinder(const Proof& proof, const std::vector<Orbit>& orbits, SignLadder& sign)
      : proof_(proof), orbits_(orbits), comparison_(proof, sign), shore_(proof, sign) {}

  ArrivalTable run() {
    const auto count = static_cast<u32>(proof_.stated.separatrices.size());
    for (u32 i = 0; i < count; ++i) table_.paths.push_back(path_of(proof_, i));
    for (u32 i = 0; i < count; ++i) add(i);
    for (auto& [place, list] : lists_) sort(place, list);
    table_.silent = count_silent(proof_, table_, shore_);
    return std::move(table_);
  }

 private:
  const Domain& domain() const { return proof_.domain; }
  const Path& path(u32 line) const { return table_.paths[line]; }

  void add(u32 line) {
    const SkeletonSeparatrix& stated = proof_.stated.separatrices[line];
    switch (stated.end) {
      case SkeletonEnd::boundary:
        return add_to_shore(line, {Place::region, stated.to});
      case SkeletonEnd::orbit: {
        const Tail tail = tail_of(comparison_, path(line), orbits_[stated.to]);
        lists_[{tail.left ? Place::left_of_orbit : Place::right_of_orbit, stated.to}].push_back(
            {line, tail.cells, tail.apart, true});
        return;
      }
      case SkeletonEnd::zero: {
        const Component& zero = proof_.zeros.components[stated.to];
        if (zero.stated.place == ZeroPlace::line || zero.stated.place == ZeroPlace::region)
          return add_to_shore(line, {Place::wall, stated.to});
        if (zero.stated.place == ZeroPlace::triangle)
          return add_to_triangle(line, {Place::zero, stated.to});
        if (zero.stated.place == ZeroPlace::vertex && domain().open[zero.place] == 0)
          add_to_star(line, {Place::zero, stated.to}, zero.place);
        if (zero.stated.place == ZeroPlace::edge && domain().twin[zero.place] != kNone)
          add_to_edge(line, {Place::zero, stated.to}, zero.place);
        return;
      }
      default:
        return;
    }
  }

  void add_to_shore(u32 line, Place place) {
    const auto& cells = path(line).cells;
    const u32 exit = cells.back().exit;
    Arrival arrival{line, 0, cells.size() - 1, true};
    u32 side = exit;
    if (exit != kNone && domain().twin[exit] == kNone) {
      const bool at_head =
          place.kind == Place::region && proof_.boundary.regions[exit][0] != place.number;
      arrival.place = shore_.in_side(exit, at_head);
    } else {
      // Straight, to a vertex.
      const Spot spot = path(line).trace->straight.back().to;
      if (spot.kind != Spot::at_vertex || domain().open[domain().fan[spot.name]] == 0) return;
      side = previous_corner(domain().corners_of(domain().fan[spot.name]).back());
      arrival.place = shore_.at_head(side);
      arrival.crosses = false;
    }
    if (place.kind == Place::wall)
      place.loop = shore_.loop(side);
    else
      arrival.place = shore_.from_start(place.number, side, arrival.place);
    lists_[place].push_back(arrival);
  }

  void add_to_triangle(u32 line, const Place& place) {
    const std::size_t last = path(line).cells.size() - 1;
    const bool crosses = path(line).cells[last].entry == Entry::crossing;
    lists_[place].push_back({line, static_cast<std::size_t>(comparison_.place(path(line), last)),
                             last - crosses, crosses});
  }

  /// Where it comes into the triangles around a vertex for the last time.
  void add_to_star(u32 line, const Place& place, u32 fan) {
    const auto corners = domain().corners_of(fan);
    std::size_t i = path(line).cells.size() - 1;
    for (;; --i) {
      const Cell& cell = path(line).cells[i];
      const auto corner = std::find_if(corners.begin(), corners.end(),
                                       [&](u32 c) { return c / 3 == cell.name / 3; });
      require(corner != corners.end(), "separatrix {}: does not end at its zero", line);
      const u32 c = *corner;
      const bool spoke =
          cell.entry == Entry::crossing && (cell.name == c || cell.name == previous_corner(c));
      if (spoke) continue;
      // From the vertex after c on: 0, its side 1 to 3, the vertex before c 4.
      const int local =
          (comparison_.place(path(line), i) + 12 - 4 * static_cast<int>(c % 3)) % 12 - 4;
      require(local >= 0 && local <= 4, "separatrix {}: does not come to its zero from outside",
              line);
      const std::size_t all = 4 * corners.size();
      const std::size_t at =
          4 * static_cast<std::size_t>(corner - corners.begin()) + static_cast<std::size_t>(local);
      const bool crosses = cell.entry == Entry::crossing;
      lists_[place].push_back({line, at % all, i - crosses, crosses});
      return;
    }
  }

  /// Where it comes into the two triangles at a side for the last time.
  void add_to_edge(u32 line, const Place& place, u32 side) {
    const auto& cells = path(line).cells;
    const u32 twin = domain().twin[side];
    std::size_t i = cells.size() - 1;
    while (cells[i].entry == Entry::crossing && (cells[i].name == side || cells[i].name == twin))
      --i;
    const bool first = cells[i].name / 3 == side / 3;
    // From the head of the side on: 0, the next side 1 to 3, the vertex across 4, to the tail 8.
    const u32 head = next_corner(first ? side : twin);
    const int local = (comparison_.place(path(line), i) + 12 - 4 * static_cast<int>(head % 3)) % 12;
    require(cells[i].name / 3 == head / 3 && local <= 8,
            "separatrix {}: does not come to its zero from outside", line);
    const bool crosses = cells[i].entry == Entry::crossing;
    lists_[place].push_back(
        {line, static_cast<std::size_t>(local + (first ? 0 : 8)) % 16, i - crosses, crosses});
  }

  /// Where line a is, seen from b, of two at one place.
  Order compare(const Arrival& a, const Arrival& b) {
    if (!a.crosses || !b.crosses) return Order::same;
    return comparison_.compare(path(a.line), a.cell, path(b.line), b.cell);
  }

  void sort(const Place& place, std::vector<Arrival>& list) {
    // Counter-clockwise around a zero left is first; along a loop, its head at the left, last.
    const bool right_first = place.kind == Place::region || place.kind == Place::wall ||
                             place.kind == Place::right_of_orbit;
    const auto is_before = [&](const Arrival& a, const Arrival& b) {
      if (a.place != b.place) return a.place < b.place;
      return a.line != b.line && compare(a, b) == (right_first ? Order::right : Order::left);
    };
    std::stable_sort(list.begin(), list.end(), is_before);
    Arrivals& arrivals = table_.orders[place];
    arrivals.cyclic = place.kind != Place::region || shore_.is_whole(place.number);
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i == 0 || is_before(list[i - 1], list[i])) arrivals.lines.emplace_back();
      arrivals.lines.back().push_back(list[i].line);
    }
  }

  const Proof& proof_;
  const std::vector<Orbit>& orbits_;
  Comparison comparison_;
  Shore shore_;
  ArrivalTable table_;
  std::map<Place, std::vector<Arrival>> lists_;
};

}  // namespace

ArrivalTable find_arrivals(const Proof& proof, const std::vector<Orbit>& orbits, SignLadder& sign) {
  return ArrivalFinder(proof, orbits, sign).run();
}

}  // namespace crest::certify::compression
