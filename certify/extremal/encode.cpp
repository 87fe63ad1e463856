// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/encode.hpp"

#include "certify/container/compose.hpp"

namespace crest::certify {
namespace {

std::size_t sample_count(const ExtremalData& data) {
  std::size_t count = 1;
  for (std::size_t k = 0; k < data.dimension; ++k) count *= data.nodes[k];
  return count;
}

void require_fit(const ExtremalData& data) {
  const bool fits =
      (data.dimension == 2 || data.dimension == 3) &&
      data.type < extremal_code::kSampleSize.size() &&
      data.samples.size() == sample_count(data) * extremal_code::kSampleSize.at(data.type);
  if (!fits) throw std::invalid_argument("certificate: extremal data that do not fit");
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
  write_bytes(out, c.codes);
  write_rows(out, c.directions, d);
  write_rows(out, c.gradients, d);
  out.count(c.edges.size());
  out.numbers(c.edges);
  write_bytes(out, c.trees);
  write_rows(out, c.leaves, d);
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
