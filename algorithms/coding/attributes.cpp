// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/attributes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "algorithms/coding/container.hpp"
#include "algorithms/coding/items.hpp"
#include "algorithms/coding/real_form.hpp"
#include "algorithms/coding/triple_model.hpp"
#include "kernel/geometry/input_error.hpp"
#include "kernel/geometry/stop.hpp"

namespace crest::coding {
namespace {

using kernel::Attribute;
using kernel::NumberType;
using kernel::Site;

/// Components of an attribute, bytes of its name.
constexpr std::uint32_t kMost = 65535;

std::size_t places_of(Site site, Index vertices, Index faces) {
  return site == Site::vertices ? vertices : site == Site::faces ? faces : 3 * std::size_t{faces};
}

template <class T>
bool holds(std::uint64_t word) {
  const auto number = static_cast<std::int64_t>(word);
  return number == static_cast<std::int64_t>(static_cast<T>(number));
}

bool is_float(double x) {
  if (std::isfinite(x) && std::fabs(x) > std::numeric_limits<float>::max()) return false;
  return std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(x))) ==
         std::bit_cast<std::uint64_t>(x);
}

/// Is the word a number of the type?
bool fits(NumberType type, std::uint64_t word) {
  switch (type) {
    case NumberType::i8:
      return holds<std::int8_t>(word);
    case NumberType::u8:
      return holds<std::uint8_t>(word);
    case NumberType::i16:
      return holds<std::int16_t>(word);
    case NumberType::u16:
      return holds<std::uint16_t>(word);
    case NumberType::i32:
      return holds<std::int32_t>(word);
    case NumberType::u32:
      return holds<std::uint32_t>(word);
    case NumberType::f32:
      return is_float(std::bit_cast<double>(word));
    case NumberType::i64:
    case NumberType::u64:
    case NumberType::f64:
      break;
  }
  return true;
}

/// Integers in the order of the numbers.
std::int64_t integer_of(NumberType type, std::uint64_t word) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return static_cast<std::int64_t>(type == NumberType::u64 ? word ^ sign : word);
}
std::uint64_t word_of(NumberType type, std::int64_t integer) {
  return static_cast<std::uint64_t>(
      integer_of(type, static_cast<std::uint64_t>(integer)));  // its own inverse
}

std::array<std::uint8_t, 8> digest_of(const std::vector<Attribute>& attributes) {
  Bytes bytes;
  const auto put = [&](std::uint64_t x, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(x >> (8 * i)));
  };
  for (const Attribute& a : attributes) {
    put(static_cast<std::uint64_t>(a.site), 1);
    put(static_cast<std::uint64_t>(a.type), 1);
    put(a.components, 4);
    put(a.name.size(), 4);
    bytes.insert(bytes.end(), a.name.begin(), a.name.end());
    put(a.missing.size(), 4);
    for (const bool gap : a.missing) put(gap ? 1 : 0, 1);
    for (const std::uint64_t word : a.words) put(word, 8);
  }
  return digest_head(bytes);
}

/// One component of an attribute.
struct Channel {
  Attribute* attribute;
  std::uint32_t component;
};

/// The numbers of up to three channels at the same items.
template <class Range>
class GroupRoutine {
 public:
  GroupRoutine(Range& range, const Items& items, std::span<const Channel> channels)
      : range_(range), items_(items), channels_(channels), values_(items.count()) {}

  void run() {
    if constexpr (Range::kEncodes)
      for (std::size_t axis = 0; axis < channels_.size(); ++axis) take(axis);
    bool wide = false;
    for (std::size_t axis = 0; axis < channels_.size(); ++axis) {
      if (real(axis)) code_form(range_, reals_[axis].form);
      wide = wide || (real(axis) ? reals_[axis].form.wide() : type(axis) >= NumberType::i64);
    }
    std::array<Hint, 3> hints{};
    if constexpr (Range::kEncodes) hints = best_hints(wide);
    code_values(range_, wide, hints);
    for (std::size_t axis = 0; axis < channels_.size(); ++axis) {
      if (real(axis)) code_reals(axis);
      if constexpr (!Range::kEncodes) give(axis);
    }
  }

 private:
  NumberType type(std::size_t axis) const { return channels_[axis].attribute->type; }
  bool real(std::size_t axis) const { return is_real(type(axis)); }

  /// From the attribute.
  void take(std::size_t axis) {
    const std::size_t first = channels_[axis].component * items_.places();
    if (real(axis)) numbers_[axis].resize(items_.count());
    for (std::size_t place = 0; place < items_.places(); ++place) {
      const Index item = items_.at(place);
      if (item == kNone) continue;
      const std::uint64_t word = channels_[axis].attribute->words[first + place];
      if (real(axis))
        numbers_[axis][item] = std::bit_cast<double>(word);
      else
        values_[item][axis] = integer_of(type(axis), word);
    }
    if (!real(axis)) return;
    reals_[axis] = choose_form(numbers_[axis]);
    for (Index i = 0; i < items_.count(); ++i)
      values_[i][axis] = integer(reals_[axis].form, numbers_[axis][i]);
  }

  /// To the attribute, as its next component.
  void give(std::size_t axis) {
    std::vector<std::uint64_t>& words = channels_[axis].attribute->words;
    for (std::size_t place = 0; place < items_.places(); ++place) {
      const Index item = items_.at(place);
      words.push_back(item == kNone ? 0
                      : real(axis)  ? std::bit_cast<std::uint64_t>(numbers_[axis][item])
                                    : word_of(type(axis), values_[item][axis]));
      if (!fits(type(axis), words.back())) throw StreamError("has a number that its type lacks");
    }
  }

  std::array<Hint, 3> best_hints(bool wide) {
    return smallest(
               values_, channels_.size(), [&](auto&& each) { items_.each_pair(each); },
               [&](std::array<Hint, 3> hints) {
                 RangeEncoder trial;
                 code_values(trial, wide, hints);
                 return trial.finish();
               })
        .first;
  }

  template <class Coder>
  void code_values(Coder& range, bool wide, std::array<Hint, 3> hints) {
    with_model(range, std::span<Triple>(values_), channels_.size(), wide, hints, [&](auto&& model) {
      model.code_hints();
      std::vector<bool> known(items_.count(), false);
      for (const Index item : items_.sequence()) {
        kernel::stop_point();
        model.code(item, items_.around(item, known));
        known[item] = true;
      }
    });
  }

  void code_reals(std::size_t axis) {
    if constexpr (!Range::kEncodes)
      for (const Triple& value : values_)
        numbers_[axis].push_back(checked_number(reals_[axis].form, value[axis]));
    code_exceptions(range_, reals_[axis].exceptions, numbers_[axis]);
  }

  Range& range_;
  const Items& items_;
  std::span<const Channel> channels_;
  std::vector<Triple> values_;
  std::array<RealChannel, 3> reals_;
  std::array<std::vector<double>, 3> numbers_;
};

template <class Range>
class AttributeRoutine {
 public:
  AttributeRoutine(Range& range, const Surface& surface, std::vector<Attribute>& list,
                   std::size_t max_numbers)
      : range_(range), surface_(surface), list_(list), max_numbers_(max_numbers) {}

  void run() {
    code_list();
    check_size();
    const std::vector<Index> visits = visit_sequence(surface_);
    for (std::size_t i = 0; i < list_.size();) {
      Items items(surface_, list_[i].site);
      items.code(range_, visits, list_[i], gaps_[i]);
      const std::size_t end = group_end(i);
      std::vector<Channel> channels;
      for (; i < end; ++i)
        for (std::uint32_t c = 0; c < list_[i].components; ++c) {
          channels.push_back({&list_[i], c});
          if (channels.size() == 3) code_group(items, channels);
        }
      code_group(items, channels);
    }
    code_digest();
  }

 private:
  void code_list() {
    SmallNumber count, components, length;
    const std::uint32_t n = 1 + count.code(range_, static_cast<std::uint32_t>(list_.size() - 1));
    for (std::uint32_t i = 0; i < n; ++i) {
      if constexpr (!Range::kEncodes) list_.emplace_back();
      Attribute& a = list_[i];
      a.site = static_cast<Site>(code_below(range_, static_cast<std::uint32_t>(a.site), 3));
      a.type = static_cast<NumberType>(code_below(range_, static_cast<std::uint32_t>(a.type), 10));
      gaps_.push_back(code_bits(range_, a.missing.empty() ? 0 : 1, 1) == 1);
      a.components = 1 + components.code(range_, a.components - 1);
      const std::uint32_t size = length.code(range_, static_cast<std::uint32_t>(a.name.size()));
      if (!Range::kEncodes && std::max(a.components, size) > kMost)
        throw StreamError("has an attribute with more than 65535 components or bytes of its name");
      for (std::uint32_t k = 0; k < size; ++k) {
        if constexpr (!Range::kEncodes) a.name.push_back(0);
        a.name[k] = static_cast<char>(code_bits(range_, static_cast<unsigned char>(a.name[k]), 8));
      }
    }
  }

  void check_size() const {
    std::size_t left = max_numbers_;
    for (const Attribute& a : list_) {
      const std::size_t numbers =
          places_of(a.site, surface_.counts().vertices, surface_.face_count()) * a.components;
      if (numbers > left)
        throw kernel::InputError("section attributes: has more numbers than are allowed, " +
                                 std::to_string(max_numbers_) +
                                 "; allow more (--max-numbers) if you trust the file");
      left -= numbers;
    }
  }

  /// One number a place, everywhere: red, green and blue of PLY help each other.
  bool plain(std::size_t i) const {
    return list_[i].components == 1 && !gaps_[i] && list_[i].site != Site::corners;
  }
  std::size_t group_end(std::size_t i) const {
    std::size_t end = i + 1;
    while (plain(i) && end < list_.size() && end < i + 3 && plain(end) &&
           list_[end].site == list_[i].site && list_[end].type == list_[i].type)
      ++end;
    return end;
  }

  void code_group(const Items& items, std::vector<Channel>& channels) {
    if (!channels.empty()) GroupRoutine<Range>(range_, items, channels).run();
    channels.clear();
  }

  void code_digest() {
    const auto digest = digest_of(list_);
    for (const std::uint8_t byte : digest)
      if (code_bits(range_, byte, 8) != byte) throw StreamError("has another digest");
  }

  Range& range_;
  const Surface& surface_;
  std::vector<Attribute>& list_;
  std::size_t max_numbers_;
  std::vector<bool> gaps_;  ///< of each: has it places without numbers?
};

}  // namespace

void require_sound(const Attribute& a, Index vertices, Index faces) {
  const std::size_t places = places_of(a.site, vertices, faces);
  const auto refuse = [&](const char* problem, const char* remedy) {
    throw kernel::InputError("attribute '" + a.name + "': " + problem + "; " + remedy);
  };
  if (a.components == 0 || a.components > kMost)
    refuse("has not 1 to 65535 components", "split it");
  if (a.name.size() > kMost) refuse("has a name of more than 65535 bytes", "rename it");
  if (a.words.size() != places * a.components || (!a.missing.empty() && a.missing.size() != places))
    refuse("has not a number a place", "give all numbers");
  for (std::size_t i = 0; i < a.words.size(); ++i)
    if (a.has(i % places) ? !fits(a.type, a.words[i]) : a.words[i] != 0)
      refuse("has a number that its type lacks", "give it another type");
}

Bytes encode_attributes(const Surface& decoded, std::span<const Attribute> attributes) {
  std::vector<Attribute> list(attributes.begin(), attributes.end());
  RangeEncoder range;
  AttributeRoutine(range, decoded, list, std::numeric_limits<std::size_t>::max()).run();
  return range.finish();
}

std::vector<Attribute> decode_attributes(std::span<const std::uint8_t> bytes,
                                         const Surface& decoded, std::size_t max_numbers) {
  std::vector<Attribute> list;
  if (bytes.empty()) throw StreamError("is empty");
  RangeDecoder range(bytes);
  with_position(range, [&] {
    AttributeRoutine(range, decoded, list, max_numbers).run();
    range.finish();
  });
  return list;
}

Attribute rearranged(const Attribute& a, std::span<const Index> source) {
  Attribute result{a.name, a.site, a.type, a.components};
  result.words.reserve(a.words.size());
  for (std::size_t first = 0; first < a.words.size(); first += source.size())
    for (const Index place : source) result.words.push_back(a.words[first + place]);
  if (!a.missing.empty())
    for (const Index place : source) result.missing.push_back(a.missing[place]);
  return result;
}

}  // namespace crest::coding
