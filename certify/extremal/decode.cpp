// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/decode.hpp"

#include <algorithm>
#include <cmath>

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {
namespace {

void require_form(bool condition, const char* what) {
  if (!condition) throw Malformed(what);
}

double read_number(ByteReader& reader) {
  const auto bits = reader.integer<std::uint64_t>();
  require_plain(is_plain(bits), "parameters");
  return std::bit_cast<double>(bits);
}

bool read_flag(ByteReader& reader) {
  const auto byte = reader.integer<std::uint8_t>();
  require_form(byte <= 1, "data section: a flag is neither 0 nor 1");
  return byte == 1;
}

void read_grid(ByteReader& reader, ExtremalData& data) {
  std::uint64_t nodes = 1;
  for (std::size_t k = 0; k < data.dimension; ++k) {
    data.nodes[k] = reader.integer<std::uint32_t>();
    require_form(data.nodes[k] >= 4, "data section: fewer than 4 nodes along an axis");
    const auto refined = ((std::uint64_t{data.nodes[k]} - 1) << data.refine) + 1;
    require_form(refined <= 0x40000000U / nodes, "data section: more than 2^30 nodes");
    nodes *= refined;
  }
  for (std::size_t k = 0; k < data.dimension; ++k) {
    data.spacing[k] = read_number(reader);
    require_form(data.spacing[k] >= 0x1p-60 && data.spacing[k] <= 0x1p60,
                 "data section: a spacing is not between 2^-60 and 2^60");
  }
}

void read_weights(ByteReader& reader, std::vector<double>& weights) {
  const std::size_t count = reader.integer<std::uint32_t>();
  require_form(count >= 1 && count <= 1025, "data section: not 1 to 1025 weights");
  reader.words(weights, count);
  for (const double w : weights)
    require_plain(is_plain(std::bit_cast<std::uint64_t>(w)), "weights");
}

/// Samples of type 8 and 9 are plain.
void require_plain_samples(const ExtremalData& data) {
  bool good = true;
  if (data.type == 9) {
    ByteReader reader(data.samples);
    while (reader.left() > 0) good = is_plain(reader.integer<std::uint64_t>()) && good;
  } else if (data.type == 8) {
    ByteReader reader(data.samples);
    while (reader.left() > 0) {
      const auto bits = reader.integer<std::uint32_t>();
      good = (bits & 0x7f800000U) != 0x7f800000U && bits != 0x80000000U && good;
    }
  }
  require_plain(good, "samples");
}

ExtremalData read_data(std::span<const std::uint8_t> section) {
  ByteReader reader(section);
  ExtremalData data;
  data.dimension = reader.integer<std::uint8_t>();
  require_form(data.dimension == 2 || data.dimension == 3,
               "data section: the dimension is neither 2 nor 3");
  data.type = reader.integer<std::uint8_t>();
  require_form(data.type < extremal_code::kSampleSize.size(),
               "data section: no such type of samples");
  data.valley = read_flag(reader);
  data.hessian = read_flag(reader);
  data.has_min_value = read_flag(reader);
  data.refine = reader.integer<std::uint8_t>();
  require_form(data.refine <= extremal_code::kMostRefined,
               "data section: refined more than 3 times");
  read_grid(reader, data);
  for (double* x : {&data.min_value, &data.min_strength, &data.sigma, &data.tensor_sigma})
    *x = read_number(reader);
  require_form(data.has_min_value || data.min_value == 0,
               "data section: a least value that is none");
  require_form(data.min_strength >= 0 && data.sigma >= 0 && data.tensor_sigma >= 0,
               "data section: a parameter is negative");
  for (auto* weights : {&data.weights, &data.tensor_weights}) {
    for (std::size_t k = 0; k < data.dimension; ++k) read_weights(reader, (*weights)[k]);
    for (std::size_t k = data.dimension; k < 3; ++k) (*weights)[k] = {1};
  }
  const std::uint64_t size = std::uint64_t{data.nodes[0]} * data.nodes[1] *
                             data.nodes[2] *  // 1 beyond the dimension
                             extremal_code::kSampleSize[data.type];
  const auto samples = reader.take(size);
  data.samples.assign(samples.begin(), samples.end());
  require_form(reader.left() == 0, "data section: bytes left over");
  require_plain_samples(data);
  return data;
}

/// A record takes `size` bytes: no length is believed before it is compared.
void require_length(const ByteReader& reader, std::size_t count, std::size_t size) {
  require_form(count <= reader.left() / size, "claim section: a list is longer than its bytes");
}

void read_bytes(ByteReader& reader, std::vector<std::uint8_t>& list, std::uint8_t most,
                const char* what) {
  const auto bytes = reader.take(reader.integer<std::uint32_t>());
  list.assign(bytes.begin(), bytes.end());
  require_form(std::ranges::all_of(list, [&](std::uint8_t code) { return code <= most; }), what);
}

template <class Row>
void read_rows(ByteReader& reader, std::vector<Row>& rows, std::size_t count, std::size_t d) {
  require_length(reader, count, 2 * d);
  rows.assign(count, Row{});
  for (Row& row : rows)
    for (std::size_t k = 0; k < d; ++k) row[k] = reader.integer<typename Row::value_type>();
}

/// The direction with kScale, or minus that, along its axis, the numbers beside it read.
ExtremalDirection read_direction(ByteReader& reader, unsigned axis, bool negative, std::size_t d) {
  ExtremalDirection v{};
  for (std::size_t k = 0; k < d; ++k)
    v[k] = k != axis  ? reader.integer<std::int16_t>()
           : negative ? static_cast<std::int16_t>(-extremal_code::kScale)
                      : extremal_code::kScale;
  return v;
}

/// What a listed cell's byte says.
struct CellByte {
  unsigned code, axis, gradient_axis;
  bool negative;
  CellByte(unsigned byte)
      : code(byte & ((1U << extremal_code::kAxis) - 1)),
        axis(byte >> extremal_code::kAxis & 3U),
        gradient_axis(byte >> extremal_code::kGradientAxis & 3U),
        negative(byte >> extremal_code::kNegative != 0) {}
  bool is_open() const { return code == extremal_code::kOpen; }
  bool is_regular() const { return code >= extremal_code::kRegular; }
  bool good(std::size_t d) const {
    return code <= extremal_code::kRegularExtremal && axis < d && gradient_axis < d &&
           (!is_open() || axis == 0) && (is_regular() || (gradient_axis == 0 && !negative));
  }
};

ExtremalComponent read_component(ByteReader& reader) {
  ExtremalComponent component;
  component.polygons = reader.integer<std::uint32_t>();
  component.euler_characteristic = reader.integer<std::int32_t>();
  component.loops = reader.integer<std::uint32_t>();
  const unsigned flags = reader.integer<std::uint8_t>();
  require_form(flags < 16, "claim section: a component has other flags");
  component.orientable = (flags & 1U) != 0;
  component.isotopic = (flags & 2U) != 0;
  component.extremal = (flags & 4U) != 0;
  component.cut = (flags & 8U) != 0;
  return component;
}

void read_cells(ByteReader& reader, ExtremalCertificate& c) {
  const std::size_t runs = reader.integer<std::uint32_t>();
  require_length(reader, runs, 8);
  c.cells.resize(runs);
  for (CellRun& run : c.cells) {
    run.first = reader.integer<std::uint32_t>();
    run.length = reader.integer<std::uint32_t>();
  }
  const std::size_t d = c.data.dimension;
  const auto bytes = reader.take(reader.integer<std::uint32_t>());
  std::size_t proven = 0, regular = 0;
  c.codes.reserve(bytes.size());
  for (const CellByte byte : bytes) {
    require_form(byte.good(d), "claim section: no such code of a cell");
    proven += byte.is_open() ? 0 : 1;
    regular += byte.is_regular() ? 1 : 0;
    c.codes.push_back(static_cast<std::uint8_t>(byte.code));
  }
  require_length(reader, proven, 2 * (d - 1));
  c.directions.reserve(proven);
  for (const CellByte byte : bytes)
    if (!byte.is_open()) c.directions.push_back(read_direction(reader, byte.axis, false, d));
  require_length(reader, regular, 2 * (d - 1));
  c.gradients.reserve(regular);
  for (const CellByte byte : bytes)
    if (byte.is_regular())
      c.gradients.push_back(read_direction(reader, byte.gradient_axis, byte.negative, d));
}

void read_trees(ByteReader& reader, ExtremalCertificate& c) {
  namespace code = extremal_code;
  const std::size_t d = c.data.dimension;
  reader.words(c.edges, reader.integer<std::uint32_t>());
  const auto bytes = reader.take(reader.integer<std::uint32_t>());
  c.trees.reserve(bytes.size());
  for (const std::uint8_t byte : bytes) {
    require_form(byte < d || byte == code::kSplitByte, "claim section: no such code of a node");
    c.trees.push_back(byte == code::kSplitByte ? code::kSplit : code::kLeaf);
  }
  const auto leaves = static_cast<std::size_t>(std::ranges::count(c.trees, code::kLeaf));
  require_length(reader, leaves, 2 * (d - 1));
  c.leaves.reserve(leaves);
  for (const std::uint8_t byte : bytes)
    if (byte != code::kSplitByte) c.leaves.push_back(read_direction(reader, byte, false, d));
}

}  // namespace

ExtremalCertificate decode_extremal(std::span<const std::uint8_t> data,
                                    std::span<const std::uint8_t> claims) {
  namespace code = extremal_code;
  ExtremalCertificate c;
  c.data = read_data(data);
  const std::size_t d = c.data.dimension;
  ByteReader reader(claims);
  read_cells(reader, c);
  read_trees(reader, c);
  read_bytes(reader, c.types, code::kUndecidedType, "claim section: no such type of an edge");
  read_bytes(reader, c.pairings, 1, "claim section: no such pairing of a face");
  read_rows(reader, c.vertices, reader.integer<std::uint32_t>(), d);
  const std::size_t points = reader.integer<std::uint32_t>();
  require_length(reader, points, 2);
  c.fan_points.resize(points);
  for (auto& point : c.fan_points) point = reader.integer<std::uint16_t>();
  c.odd_faces = reader.integer<std::uint32_t>();
  c.valences.two = reader.integer<std::uint32_t>();
  for (auto& count : c.valences.one) count = reader.integer<std::uint32_t>();
  c.valences.three = reader.integer<std::uint32_t>();
  const std::size_t components = reader.integer<std::uint32_t>();
  require_length(reader, components, 13);
  for (std::size_t i = 0; i < components; ++i) c.components.push_back(read_component(reader));
  require_form(reader.left() == 0, "claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
