// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/encode.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "certify/container/compose.hpp"

namespace crest::certify {
namespace {

namespace code = extremal_code;

std::size_t sample_count(const ExtremalData& data) {
  std::size_t count = 1;
  for (std::size_t k = 0; k < data.dimension; ++k) count *= data.nodes[k];
  return count;
}

void require_fit(bool fits, const char* what) {
  if (!fits) throw std::invalid_argument(what);
}

void require_fit(const ExtremalData& data) {
  require_fit((data.dimension == 2 || data.dimension == 3) &&
                  data.type < code::kSampleSize.size() &&
                  data.samples.size() == sample_count(data) * code::kSampleSize.at(data.type),
              "certificate: extremal data that do not fit");
}

std::size_t data_size(const ExtremalData& data) {
  std::size_t size = 6 + data.dimension * std::size_t{12} + 4 * 8 + data.samples.size();
  for (std::size_t k = 0; k < data.dimension; ++k)
    size += 2 * 4 + 8 * (data.weights.at(k).size() + data.tensor_weights.at(k).size());
  return size;
}

void write_data(ByteWriter& out, const ExtremalData& data) {
  for (const std::uint8_t byte :
       {data.dimension, data.type, std::uint8_t{data.valley}, std::uint8_t{data.hessian},
        std::uint8_t{data.has_min_value}, data.refine})
    out.integer(byte);
  const std::size_t d = data.dimension;
  out.numbers(std::span(data.nodes).first(d));
  out.numbers(std::span(data.spacing).first(d));
  for (const double x : {data.min_value, data.min_strength, data.sigma, data.tensor_sigma})
    out.number(x);
  for (const auto* weights : {&data.weights, &data.tensor_weights})
    for (std::size_t k = 0; k < d; ++k) {
      out.count(weights->at(k).size());
      out.numbers(weights->at(k));
    }
  out.bytes(data.samples);
}

template <class Row>
void write_rows(ByteWriter& out, const std::vector<Row>& rows, std::size_t d) {
  for (const Row& row : rows)
    for (std::size_t k = 0; k < d; ++k) out.integer(row[k]);
}

void write_bytes(ByteWriter& out, const std::vector<std::uint8_t>& bytes) {
  out.count(bytes.size());
  out.bytes(bytes);
}

/// Where its size is largest, first of all.
std::uint8_t axis_of(const ExtremalDirection& v) {
  std::uint8_t axis = 0;
  for (std::uint8_t k = 1; k < 3; ++k)
    if (std::abs(v.at(k)) > std::abs(v.at(axis))) axis = k;
  require_fit(v.at(axis) != 0, "certificate: a direction is zero");
  return axis;
}
bool is_reversed(const ExtremalDirection& w) {
  return w.at(axis_of(w)) < 0;
}

/// The numbers beside its axis, where the one along it is made kScale in size.
void write_offsets(ByteWriter& out, const ExtremalDirection& v, bool reversed, std::size_t d) {
  const std::uint8_t axis = axis_of(v);
  const double scale = (reversed ? -1.0 : 1.0) * code::kScale / std::abs(v.at(axis));
  for (std::size_t k = 0; k < d; ++k)
    if (k != axis) out.integer(static_cast<std::int16_t>(std::lround(v.at(k) * scale)));
}

/// Calls f(code, w, a) for every cell, with what it has of these.
template <class Function>
void for_cells(const ExtremalCertificate& c, const Function& f) {
  std::size_t directions = 0, gradients = 0;
  for (const std::uint8_t cell : c.codes) {
    const ExtremalDirection* w = cell == code::kOpen ? nullptr : &c.directions[directions++];
    f(cell, w, cell < code::kRegular ? nullptr : &c.gradients[gradients++]);
  }
}

/// w as it is or reversed, whichever is positive along its axis, and a with it.
void write_cells(ByteWriter& out, const ExtremalCertificate& c) {
  const auto open = static_cast<std::size_t>(std::ranges::count(c.codes, code::kOpen));
  const auto regular = static_cast<std::size_t>(
      std::ranges::count_if(c.codes, [](std::uint8_t cell) { return cell >= code::kRegular; }));
  require_fit(c.directions.size() == c.codes.size() - open && c.gradients.size() == regular,
              "certificate: not a direction for every cell");
  using Direction = const ExtremalDirection*;
  out.count(c.codes.size());
  for_cells(c, [&](std::uint8_t cell, Direction w, Direction a) {
    unsigned byte = cell;
    if (w != nullptr) byte |= unsigned{axis_of(*w)} << code::kAxis;
    if (a != nullptr)
      byte |= unsigned{axis_of(*a)} << code::kGradientAxis |
              unsigned{is_reversed(*a) != is_reversed(*w)} << code::kNegative;
    out.integer(static_cast<std::uint8_t>(byte));
  });
  const std::size_t d = c.data.dimension;
  for (const ExtremalDirection& w : c.directions) write_offsets(out, w, is_reversed(w), d);
  for_cells(c, [&](std::uint8_t, Direction w, Direction a) {
    if (a != nullptr) write_offsets(out, *a, is_reversed(*w), d);
  });
}

void write_trees(ByteWriter& out, const ExtremalCertificate& c) {
  out.count(c.edges.size());
  out.numbers(c.edges);
  require_fit(c.leaves.size() == static_cast<std::size_t>(std::ranges::count(c.trees, code::kLeaf)),
              "certificate: not a direction for every leaf");
  out.count(c.trees.size());
  std::size_t leaf = 0;
  for (const std::uint8_t node : c.trees)
    out.integer(node == code::kLeaf ? axis_of(c.leaves[leaf++]) : code::kSplitByte);
  for (const ExtremalDirection& w : c.leaves)
    write_offsets(out, w, is_reversed(w), c.data.dimension);
}

void write_component(ByteWriter& out, const ExtremalComponent& component) {
  out.integer(component.polygons);
  out.integer(component.euler_characteristic);
  out.integer(component.loops);
  out.integer(static_cast<std::uint8_t>((component.orientable ? 1 : 0) |
                                        (component.isotopic ? 2 : 0) |
                                        (component.extremal ? 4 : 0) | (component.cut ? 8 : 0)));
}

void write_claims(ByteWriter& out, const ExtremalCertificate& c) {
  const std::size_t d = c.data.dimension;
  out.count(c.cells.size());
  for (const CellRun& run : c.cells) {
    out.integer(run.first);
    out.integer(run.length);
  }
  write_cells(out, c);
  write_trees(out, c);
  write_bytes(out, c.types);
  write_bytes(out, c.pairings);
  out.count(c.vertices.size());
  write_rows(out, c.vertices, d);
  out.count(c.fan_points.size());
  for (const auto point : c.fan_points) out.integer(point);
  out.integer(c.odd_faces);
  out.integer(c.valences.two);
  out.numbers(std::span(c.valences.one));
  out.integer(c.valences.three);
  out.count(c.components.size());
  for (const ExtremalComponent& component : c.components) write_component(out, component);
}

}  // namespace

EncodedData encode_data(const ExtremalData& data) {
  require_fit(data);
  return begin({kExtremal, kExtremalVersion}, data_size(data),
               [&](ByteWriter& out) { write_data(out, data); });
}

Bytes encode(EncodedData data, const ExtremalCertificate& c) {
  return finish(std::move(data), [&](ByteWriter& out) { write_claims(out, c); });
}

Bytes encode(const ExtremalCertificate& c) {
  return encode(encode_data(c.data), c);
}

}  // namespace crest::certify
