// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/join_soups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

#include "io/formats/files.hpp"
#include "io/formats/vtk_input.hpp"

namespace crest::io {
namespace {

constexpr const char* kWritePieces = "write the files again";

/// -0 is 0; what is no number is like itself.
std::tuple<std::uint64_t, std::uint64_t, std::uint64_t> bits(const kernel::Vec3& p) {
  const auto of = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };
  return {of(p[0]), of(p[1]), of(p[2])};
}

/// For each point of all pieces its number among those that stay.
struct Merged {
  std::vector<std::size_t> number, kept;  ///< kept: which of all
  std::size_t apart = 0;
};

Merged merge(const std::vector<Soup>& pieces) {
  std::vector<kernel::Vec3> points;
  std::vector<std::size_t> piece_of;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    points.insert(points.end(), pieces[k].points.begin(), pieces[k].points.end());
    piece_of.resize(points.size(), k);
  }
  std::vector<std::size_t> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(bits(points[a]), a) < std::pair(bits(points[b]), b);
  });
  Merged r;
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    bool twice = false;
    for (end = i + 1; end < order.size() && bits(points[order[end]]) == bits(points[order[i]]);
         ++end)
      twice = twice || piece_of[order[end]] == piece_of[order[end - 1]];
    const bool shared = piece_of[order[i]] != piece_of[order[end - 1]];
    if (twice && shared) r.apart += end - i;
    for (std::size_t k = i; k < end; ++k) first[order[k]] = twice ? order[k] : order[i];
  }
  r.number.resize(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (first[v] == v) {
      r.number[v] = r.kept.size();
      r.kept.push_back(v);
    } else {
      r.number[v] = r.number[first[v]];
    }
  }
  return r;
}

/// Throws unless the field has so many rows, or none were asked for.
std::size_t components_of(const Field& field, std::size_t rows) {
  const auto components = static_cast<std::size_t>(std::max(field.components, 0));
  if (field.size() != 0 && field.size() != rows * components)
    fail(fmt::format("field '{}'", one_line(field.name)),
         fmt::format("has {} numbers, {} are needed", field.size(), rows * components),
         kWritePieces);
  return components;
}

/// The fields of all pieces that have rows. `rows`, `fields`: of a piece.
template <class Rows, class Fields>
std::vector<Field> joined(const std::vector<Soup>& pieces, const Rows& rows, const Fields& fields) {
  std::vector<Field> result;
  bool begun = false;
  for (const Soup& piece : pieces) {
    if (rows(piece) == 0) continue;
    for (const Field& field : fields(piece)) components_of(field, rows(piece));
    if (!begun) {
      result = fields(piece);
      begun = true;
      continue;
    }
    std::erase_if(result, [&](Field& field) {
      const auto& others = fields(piece);
      const auto other = std::find_if(others.begin(), others.end(), [&](const Field& f) {
        return f.name == field.name && f.components == field.components;
      });
      if (other == others.end()) return true;
      if (other->type != field.type || other->numbers.index() != field.numbers.index())
        fail(fmt::format("field '{}'", one_line(field.name)),
             "has numbers of another type in another piece", kWritePieces);
      field.normals = field.normals && other->normals;
      std::visit(
          [&](auto& numbers) {
            const auto& more = std::get<std::decay_t<decltype(numbers)>>(other->numbers);
            numbers.insert(numbers.end(), more.begin(), more.end());
          },
          field.numbers);
      return false;
    });
  }
  return result;
}

/// The rows that stay, of so many.
void keep_rows(Field& field, const std::vector<std::size_t>& kept, std::size_t rows) {
  const std::size_t components = components_of(field, rows);
  std::visit(
      [&](auto& numbers) {
        if (numbers.empty()) return;
        std::decay_t<decltype(numbers)> stay;
        stay.reserve(kept.size() * components);
        for (const std::size_t i : kept)
          for (std::size_t k = 0; k < components; ++k) stay.push_back(numbers[i * components + k]);
        numbers = std::move(stay);
      },
      field.numbers);
}

}  // namespace

Soup join(std::vector<Soup> pieces) {
  const Merged merged = merge(pieces);
  Soup soup;
  soup.point_fields = joined(
      pieces, [](const Soup& s) { return s.points.size(); },
      [](const Soup& s) -> const std::vector<Field>& { return s.point_fields; });
  soup.cell_fields = joined(
      pieces, [](const Soup& s) { return s.cells.size(); },
      [](const Soup& s) -> const std::vector<Field>& { return s.cell_fields; });
  for (Field& field : soup.point_fields) keep_rows(field, merged.kept, merged.number.size());
  soup.points.resize(merged.kept.size());
  std::size_t before = 0;
  std::vector<Cells::Node> nodes;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Soup& piece = pieces[k];
    for (std::size_t v = piece.points.size(); v-- > 0;)
      soup.points[merged.number[before + v]] = piece.points[v];
    for (std::size_t c = 0; c < piece.cells.size(); ++c) {
      nodes.clear();
      for (const Cells::Node v : piece.cells.nodes(c)) {
        if (v < 0 || static_cast<std::size_t>(v) >= piece.points.size())
          fail(fmt::format("piece {}", k),
               fmt::format("cell {} names point {}, there are {}", c, v, piece.points.size()),
               kWritePieces);
        nodes.push_back(
            static_cast<Cells::Node>(merged.number[before + static_cast<std::size_t>(v)]));
      }
      soup.cells.add(piece.cells.type(c), nodes);
    }
    before += piece.points.size();
    for (const std::string& warning : piece.warnings)
      soup.warnings.push_back(fmt::format("piece {}: {}", k, warning));
    pieces[k] = {};
  }
  if (merged.apart > 0)
    soup.warnings.push_back(
        fmt::format("{} points of several pieces coincide where a piece has two of them: they stay "
                    "apart",
                    merged.apart));
  return soup;
}

void leave_out_ghosts(Soup& soup) {
  constexpr std::uint64_t duplicate = 1, refined = 8, hidden = 32;  // of vtkDataSetAttributes
  const auto is_ghost_type = [](const Field& field) { return field.name == kGhostType; };
  std::erase_if(soup.point_fields, is_ghost_type);
  const auto found = std::find_if(soup.cell_fields.begin(), soup.cell_fields.end(), is_ghost_type);
  if (found == soup.cell_fields.end()) return;
  const Field types = std::move(*found);
  std::erase_if(soup.cell_fields, is_ghost_type);
  std::vector<std::size_t> kept;
  const auto* numbers = std::get_if<std::vector<std::int64_t>>(&types.numbers);
  if (!numbers || numbers->size() != soup.cells.size()) return;
  for (std::size_t c = 0; c < numbers->size(); ++c)
    if ((static_cast<std::uint64_t>((*numbers)[c]) & (duplicate | refined | hidden)) == 0)
      kept.push_back(c);
  if (kept.size() == soup.cells.size()) return;
  soup.warnings.push_back(
      fmt::format("{} ghost cells (vtkGhostType) are left out", soup.cells.size() - kept.size()));
  Cells cells;
  for (const std::size_t c : kept) cells.add(soup.cells.type(c), soup.cells.nodes(c));
  soup.cells = std::move(cells);
  for (Field& field : soup.cell_fields) keep_rows(field, kept, types.size());
  soup.cell_tags.assign(kept.begin(), kept.end());
}

}  // namespace crest::io
