// SPDX-License-Identifier: GPL-3.0-or-later
// crest encode, crest decode.
#include "algorithms/coding/coding.hpp"

#include <bit>
#include <type_traits>

#include "algorithms/coding/certificate.hpp"
#include "algorithms/coding/verify.hpp"
#include "bindings/python/systems.hpp"
#include "certify/coding/encode.hpp"

namespace crest::python {
namespace {

using coding::Method;
using coding::Places;
using kernel::Attribute;

coding::EncodeOptions encode_options_of(const Arguments& a) {
  coding::EncodeOptions options;
  for (const Method method : {Method::valence, Method::fan, Method::zigzag, Method::fixed})
    if (a.text("method") == coding::name_of(method)) options.method = method;
  options.keep_order = a.flag("keep_order");
  if (a.has("tolerance")) {
    options.tolerance = a.number("tolerance");
    options.places = Places::rounded;
  }
  if (a.flag("connectivity_only")) options.places = Places::none;
  return options;
}

void fill(const coding::StreamInfo& info, Output& out) {
  out.values["method"] = std::string(coding::name_of(info.method));
  out.values["components"] = std::int64_t{info.components};
  out.values["handles"] = std::int64_t{info.handles};
  out.values["boundary_loops"] = std::int64_t{info.loops};
}

// Python hands attributes over as attribute_names, attribute_sites and arrays attribute0, ...;
// gaps0, ... are 1 at places without numbers.
constexpr const char* kSites[] = {"vertices", "faces", "corners"};

template <class T>
std::uint64_t word_of(T x) {
  if constexpr (std::is_floating_point_v<T>)
    return std::bit_cast<std::uint64_t>(static_cast<double>(x));
  else
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
}

template <class T>
T number_of(std::uint64_t word) {
  if constexpr (std::is_floating_point_v<T>)
    return static_cast<T>(std::bit_cast<double>(word));
  else
    return static_cast<T>(word);
}

Attribute attribute_of(const std::string& name, const std::string& site, const Array& array) {
  Attribute out{name};
  for (const kernel::Site s : {kernel::Site::faces, kernel::Site::corners})
    if (site == kSites[static_cast<std::size_t>(s)]) out.site = s;
  out.type = static_cast<kernel::NumberType>(array.data.index());
  out.components = static_cast<std::uint32_t>(array.shape[1]);
  std::visit(
      [&](const auto& numbers) {
        for (std::size_t c = 0; c < out.components; ++c)
          for (std::size_t i = c; i < numbers.size(); i += out.components)
            out.words.push_back(word_of(numbers[i]));
      },
      array.data);
  return out;
}

std::vector<Attribute> attributes_of(const Arguments& a) {
  std::vector<Attribute> attributes;
  if (!a.has("attribute_names")) return attributes;
  const auto &names = a.texts("attribute_names"), &sites = a.texts("attribute_sites");
  for (std::size_t i = 0; i < names.size(); ++i) {
    attributes.push_back(
        attribute_of(names[i], sites[i], a.array("attribute" + std::to_string(i))));
    const std::string gaps = "gaps" + std::to_string(i);
    if (!a.has(gaps)) continue;
    const auto& gone = std::get<std::vector<std::uint8_t>>(a.array(gaps).data);
    attributes.back().missing.assign(gone.begin(), gone.end());
  }
  return attributes;
}

template <class T>
void fill_numbers(const Attribute& a, std::vector<T>& numbers) {
  const std::size_t places = a.places();
  numbers.resize(a.words.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i % places * a.components + i / places] = number_of<T>(a.words[i]);
}

/// The types of numbers are those of samples, in the same order.
template <std::size_t Type = 0>
Array numbers_of(const Attribute& a) {
  using Samples = kernel::SampledGrid::Samples;
  if constexpr (Type + 1 < std::variant_size_v<Samples>)
    if (static_cast<std::size_t>(a.type) != Type) return numbers_of<Type + 1>(a);
  std::variant_alternative_t<Type, Samples> numbers;
  fill_numbers(a, numbers);
  return {{a.places(), a.components}, std::move(numbers)};
}

void add_attributes(const std::vector<Attribute>& attributes, Output& out) {
  std::vector<std::string> names, sites;
  for (const Attribute& a : attributes) {
    const std::string i = std::to_string(names.size());
    names.push_back(a.name);
    sites.push_back(kSites[static_cast<std::size_t>(a.site)]);
    out.values["attribute" + i] = numbers_of(a);
    if (!a.missing.empty())
      out.values["gaps" + i] =
          array_of(std::vector<std::uint8_t>(a.missing.begin(), a.missing.end()));
  }
  out.values["attribute_names"] = std::move(names);
  out.values["attribute_sites"] = std::move(sites);
}

}  // namespace

Output run_encode(const Arguments& a, const Progress& progress) {
  const auto points = a.rows<3>("V");
  const auto faces = a.cells<3>("F", points.size());
  const coding::EncodeOptions options = encode_options_of(a);
  const std::vector<Attribute> attributes = attributes_of(a);
  const auto count = static_cast<kernel::Index>(points.size());
  const coding::Encoded encoded = progress.step(
      "encoding", [&] { return coding::encode(count, faces, points, options, attributes); });
  const double largest = progress.step("decoding again", [&] {
    return coding::verify(encoded, faces, points, options, attributes);
  });
  Output out;
  fill(encoded.info, out);
  if (a.flag("certificate"))
    out.values["data_digest"] = progress.step("composing the certificate", [&] {
      return out.certify(
          certify::encode(coding::make_certificate(encoded, faces, points, options, 0)));
    });
  out.values["vertex_order"] = array_of(encoded.vertex_order);
  out.values["largest_error"] = largest;
  out.values["connectivity_bytes"] = static_cast<std::int64_t>(encoded.info.sizes.connectivity);
  out.values["geometry_bytes"] = static_cast<std::int64_t>(encoded.info.sizes.geometry);
  out.values["attribute_bytes"] = static_cast<std::int64_t>(encoded.info.sizes.attributes);
  out.values["stream"] = array_of(encoded.stream);
  return out;
}

Output run_decode(const Arguments& a, const Progress& progress) {
  const auto& stream = std::get<std::vector<std::uint8_t>>(a.array("stream").data);
  const coding::Decoded decoded = progress.step("decoding", [&] {
    return coding::decode(stream, {.faces = static_cast<kernel::Index>(a.integer("max_faces")),
                                   .numbers = static_cast<std::size_t>(a.integer("max_numbers"))});
  });
  Output out;
  fill(decoded.info, out);
  if (decoded.info.places != Places::none) out.values["V"] = array_of(decoded.points);
  out.values["F"] = array_of(decoded.faces);
  out.values["vertices"] = std::int64_t{decoded.info.vertices};
  add_attributes(decoded.attributes, out);
  return out;
}

}  // namespace crest::python
