// SPDX-License-Identifier: GPL-3.0-or-later
// Positions (docs/cmc-format.md, section 8).
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "certify/coding/decisions.hpp"
#include "certify/coding/stream.hpp"
#include "certify/surface/mesh_checks.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;
using i64 = std::int64_t;
using Wide = __int128;
using Patterns = std::vector<std::array<std::uint64_t, 3>>;

Wide floored(Wide a, Wide b) {
  const Wide q = a / b;
  return q * b > a ? q - 1 : q;
}
Wide mean(Wide sum, Wide m) {
  return floored(2 * sum + m, 2 * m);
}
int bit_length(Wide x) {
  auto size = static_cast<unsigned __int128>(x < 0 ? -x : x);
  int bits = 0;
  for (; size != 0; size >>= 1) ++bits;
  return bits;
}
int c63(i64 x) {
  return static_cast<int>(clamped(x, 0, 63));
}

/// The mesh as the section walks over it.
class Walk {
 public:
  Walk(const FaceList& faces, std::size_t vertices) : faces_(faces), first_(vertices, kNone) {
    const Topology topology = build_topology(faces, vertices);
    twin_.assign(topology.twin.begin(), topology.twin.end());
    for (u32 h = 3 * static_cast<u32>(faces.size()); h-- > 0;)
      if (twin_[h] != kNone) first_[start(h)] = h;
    for (u32 h = 0; h < twin_.size(); ++h)
      if (twin_[h] == kNone) first_[start(h)] = h;
  }

  u32 start(u32 h) const { return faces_[h / 3][h % 3]; }
  u32 end(u32 h) const { return start(next_corner(h)); }
  u32 third(u32 h) const { return start(previous_corner(h)); }
  u32 twin(u32 h) const { return twin_[h]; }
  template <class Visit>
  void around(u32 v, Visit&& visit) const {
    u32 h = first_[v];
    do {
      visit(h);
      h = twin_[previous_corner(h)];
    } while (h != kNone && h != first_[v]);
  }

 private:
  const FaceList& faces_;
  std::vector<u32> twin_, first_;
};

/// The order of visits: most predictions first.
class Visits {
 public:
  Visits(const Walk& walk, std::size_t vertices)
      : walk_(walk), known_(vertices, false), offered_(vertices, false), count_(vertices, 0) {}

  bool known(u32 v) const { return known_[v]; }
  std::optional<u32> next() {
    for (std::size_t q = queues_.size(); q-- > 0;)
      for (auto& [list, at] = queues_[q]; at < list.size();) {
        const u32 v = list[at++];
        if (!known_[v] && count_[v] == q) return v;
      }
    while (lowest_ < known_.size() && known_[lowest_]) ++lowest_;
    if (lowest_ == known_.size()) return std::nullopt;
    return static_cast<u32>(lowest_);
  }
  void coded(u32 v) {
    known_[v] = true;
    walk_.around(v, [&](u32 h) {
      const u32 a = walk_.end(h), b = walk_.third(h);
      for (const u32 w : {a, b}) {
        if (known_[w] || offered_[w]) continue;
        offered_[w] = true;
        queues_[0].first.push_back(w);
      }
      if (!known_[a]) return;
      if (const u32 across = walk_.twin(next_corner(h)); known_[b] && across != kNone) {
        const u32 d = walk_.third(across);
        if (!known_[d]) credit(d);
      }
      if (const u32 beside = walk_.twin(h); beside != kNone) {
        const u32 c = walk_.third(beside);
        if (known_[b] != known_[c]) credit(known_[b] ? c : b);
      }
    });
  }

 private:
  void credit(u32 d) {
    if (count_[d] == 15) return;
    queues_[++count_[d]].first.push_back(d);
  }

  const Walk& walk_;
  std::vector<bool> known_, offered_;
  std::vector<std::uint8_t> count_;
  std::array<std::pair<std::vector<u32>, std::size_t>, 16> queues_{};
  std::size_t lowest_ = 0;
};

/// What is known around a vertex.
struct Surroundings {
  std::vector<u32> neighbours;
  std::vector<std::array<u32, 3>> parallelograms;
};

Surroundings look_around(const Walk& walk, const Visits& visits, u32 v) {
  Surroundings s;
  const auto neighbour = [&](u32 w) {
    if (visits.known(w) && s.neighbours.size() < 16) s.neighbours.push_back(w);
  };
  walk.around(v, [&](u32 h) {
    const u32 a = walk.end(h), b = walk.third(h);
    neighbour(a);
    if (walk.twin(previous_corner(h)) == kNone) neighbour(b);
    const u32 across = walk.twin(next_corner(h));
    if (!visits.known(a) || !visits.known(b) || across == kNone) return;
    const u32 d = walk.third(across);
    if (visits.known(d) && s.parallelograms.size() < 16) s.parallelograms.push_back({a, b, d});
  });
  return s;
}

struct Prediction {
  Wide value = 0, spread = 0, pull = 0;
  int expected = 0, most = 0;  // bits
  int count = 0;               // of parallelograms, at most 3
};

/// What is added to predictions.
class Residuals {
 public:
  explicit Residuals(Decisions& in) : in_(in) {}

  /// Of the residual read last on the axis.
  int bits(std::size_t axis) const { return bits_[axis]; }
  /// A vertex has none there.
  void skip(std::size_t axis) { bits_[axis] = 0; }
  Wide read(std::size_t axis, const Prediction& p) {
    const int bits = bits_[axis] = read_bits(axis, p);
    if (bits == 0) {
      minus_[axis] = 0;
      return 0;
    }
    const bool negative = read_sign(axis, p, bits);
    minus_[axis] = negative;
    unsigned __int128 size = 1;
    std::size_t node = 1;
    int left = bits - 1;
    for (int k = 0; k < 3 && left > 0; ++k, --left) {
      const bool bit = in_.alone(size_[axis][static_cast<std::size_t>(bits)][node]);
      node = 2 * node + bit;
      size = size << 1 | bit;
    }
    size = size << left | in_.plain(left);
    const auto magnitude = static_cast<Wide>(size);
    return negative ? -magnitude : magnitude;
  }

 private:
  int read_bits(std::size_t axis, const Prediction& p) {
    const int one = axis == 0 ? 0 : c63(1 + bits_[axis - 1]);
    const int two = axis == 2 ? c63(1 + bits_[0]) : 0;
    const int e = p.expected, spread = c63(bit_length(p.spread)), pull = c63(bit_length(p.pull));
    const std::array<Line*, 6> lines = {
        &lines_(pack(1, axis, c63(e), p.count)), &lines_(pack(2, c63(e), spread, p.count)),
        &lines_(pack(3, axis, c63(e), pull)),    &lines_(pack(4, axis, c63(e), one, two)),
        &lines_(pack(5, spread, pull, c63(e))),  &lines_(pack(6, c63(e), c63(p.most), one))};
    const auto decide = [&](int d) {
      const auto i = static_cast<std::size_t>(d);
      return in_.mixed(lines, i, bit_mixers_[axis][i]);
    };
    if (decide(0)) {
      require(e < 64, "stream: a residual of more than 64 bits");
      int k = 1;
      while (e + k < 64 && decide(std::min(k, 7))) ++k;
      return e + k;
    }
    int k = 0;
    while (k < e && decide(8 + std::min(k, 7))) ++k;
    return e - k;
  }

  bool read_sign(std::size_t axis, const Prediction& p, int bits) {
    const int side = p.pull < 0 ? 2 : p.pull > 0 ? 1 : 0;
    const int s15 = std::min(c63(bit_length(p.pull) - bits + 8), 15);
    const int others = axis == 0 ? 0 : axis == 1 ? 1 + minus_[0] : 3 + 2 * minus_[1] + minus_[0];
    const std::array<Line*, 4> lines = {
        &lines_(pack(7, side, s15, p.count)), &lines_(pack(8, axis, side, others)),
        &lines_(pack(9, axis, side, c63(bits), s15)), &lines_(pack(10, axis, others))};
    return in_.mixed(lines, 0, sign_mixers_[axis]);
  }

  Decisions& in_;
  std::array<int, 3> bits_{}, minus_{};
  Lines lines_;
  std::array<std::array<Mixer, 16>, 3> bit_mixers_;
  std::array<Mixer, 3> sign_mixers_;
  std::array<std::array<std::array<Counter, 8>, 65>, 3> size_;
};

/// The integers of all vertices, axis by axis.
class IntegerDecoder {
 public:
  IntegerDecoder(Decisions& in, const Walk& walk, std::size_t vertices, i64 least, i64 greatest)
      : in_(in),
        walk_(walk),
        least_(least),
        greatest_(greatest),
        values_(vertices),
        lengths_(vertices),
        residuals_(in) {}

  std::vector<std::array<i64, 3>> run() {
    for (std::size_t axis = 0; axis < 3; ++axis) read_hint(axis);
    Visits visits(walk_, values_.size());
    std::optional<u32> before;
    while (const auto v = visits.next()) {
      const Surroundings around = look_around(walk_, visits, *v);
      for (std::size_t axis = 0; axis < 3; ++axis) read_axis(*v, axis, around, before);
      visits.coded(*v);
      before = v;
    }
    return std::move(values_);
  }

 private:
  void read_hint(std::size_t axis) {
    hint_[axis] = in_.below(3);
    if (hint_[axis] != 2) return;
    std::array<Counter, 30> size;
    std::array<Counter, 64> gap;
    const std::uint64_t n = 1 + in_.small(size);
    require(n <= values_.size(), "stream: a table of more values than vertices");
    Wide low = least_;
    for (std::uint64_t i = 0; i < n; ++i) {
      low += in_.large(gap);
      require(low <= greatest_, "stream: a table's value is out of range");
      table_[axis].push_back(static_cast<i64>(low++));
    }
  }

  Prediction predict(std::size_t axis, const Surroundings& s,
                     const std::optional<u32>& before) const {
    Prediction p;
    const auto N = static_cast<Wide>(s.neighbours.size()),
               n = static_cast<Wide>(s.parallelograms.size());
    Wide near = 0, lengths = 0;
    for (const u32 w : s.neighbours) {
      near += values_[w][axis];
      lengths += lengths_[w][axis];
      p.most = std::max(p.most, static_cast<int>(lengths_[w][axis]));
    }
    if (N > 0) {
      near = mean(near, N);
      p.expected = static_cast<int>(floored(2 * lengths + N, 2 * N));
    }
    p.count = static_cast<int>(std::min<Wide>(n, 3));
    if (n == 0) {
      p.value = N > 0 ? near : before ? Wide{values_[*before][axis]} : 0;
      return p;
    }
    Wide sum = 0, low = 0, high = 0;
    for (std::size_t i = 0; i < s.parallelograms.size(); ++i) {
      const auto& [a, b, d] = s.parallelograms[i];
      const Wide x = Wide{values_[a][axis]} + values_[b][axis] - values_[d][axis];
      sum += x;
      low = i == 0 ? x : std::min(low, x);
      high = i == 0 ? x : std::max(high, x);
    }
    p.value = std::min<Wide>(std::max<Wide>(mean(sum, n), least_), greatest_);
    p.spread = high - low;
    p.pull = near - p.value;
    return p;
  }

  void read_axis(u32 v, std::size_t axis, const Surroundings& around,
                 const std::optional<u32>& before) {
    if (hint_[axis] == 1 && repeats(v, axis, around)) return;
    const Prediction p = predict(axis, around, before);
    const Wide residual = residuals_.read(axis, p);
    Wide value = p.value + residual;
    if (hint_[axis] == 2) {
      const Wide index = base(table_[axis], p.value) + residual;
      require(index >= 0 && index < static_cast<Wide>(table_[axis].size()),
              "stream: no such value in a table");
      value = table_[axis][static_cast<std::size_t>(index)];
    }
    require(value >= least_ && value <= greatest_, "stream: a coordinate is out of range");
    values_[v][axis] = static_cast<i64>(value);
    lengths_[v][axis] = static_cast<std::uint8_t>(residuals_.bits(axis));
  }

  static Wide base(const std::vector<i64>& table, Wide at) {
    const auto above =
        std::lower_bound(table.begin(), table.end(), at, [](i64 x, Wide y) { return Wide{x} < y; });
    if (above == table.begin()) return 0;
    const auto index = above - table.begin();
    if (above == table.end()) return index - 1;
    return at - *(above - 1) <= *above - at ? index - 1 : index;
  }

  bool repeats(u32 v, std::size_t axis, const Surroundings& around) {
    std::array<i64, 3> tried{};
    std::size_t count = 0;
    for (const u32 w : around.neighbours) {
      const i64 x = values_[w][axis];
      if (count == 3) break;
      if (std::find(tried.begin(), tried.begin() + static_cast<std::ptrdiff_t>(count), x) !=
          tried.begin() + static_cast<std::ptrdiff_t>(count))
        continue;
      if (in_.alone(repeat_[axis][count])) {
        values_[v][axis] = x;
        lengths_[v][axis] = 0;
        residuals_.skip(axis);
        return true;
      }
      tried[count++] = x;
    }
    return false;
  }

  Decisions& in_;
  const Walk& walk_;
  i64 least_, greatest_;
  std::vector<std::array<i64, 3>> values_;
  std::vector<std::array<std::uint8_t, 3>> lengths_;
  std::array<std::uint64_t, 3> hint_{};
  std::array<std::vector<i64>, 3> table_;
  std::array<std::array<Counter, 3>, 3> repeat_;
  Residuals residuals_;
};

constexpr i64 kMost53 = i64{1} << 53;

/// The double that an integer means in a form; section 8's table.
double meaning(std::uint64_t form, std::uint64_t exponent, i64 k) {
  double power = 1;
  for (std::uint64_t i = 0; i < exponent; ++i) power *= 10;  // exact up to 10^22
  require(form > 1 || (k >= -kMost53 && k <= kMost53), "stream: a decimal of more than 53 bits");
  if (form == 0) return static_cast<double>(k) / power;
  if (form == 1) return static_cast<float>(static_cast<double>(k) / power);
  if (form == 2) {
    require(k >= -(i64{1} << 31) && k < i64{1} << 31, "stream: no pattern of a float");
    const i64 pattern = k >= 0 ? k : -(i64{1} << 31) - k - 1;
    return std::bit_cast<float>(static_cast<std::int32_t>(pattern));
  }
  const i64 least = std::numeric_limits<i64>::min();
  return std::bit_cast<double>(k >= 0 ? k : static_cast<i64>(Wide{least} - k - 1));
}

Patterns decode_exact(Decisions& in, const Walk& walk, std::size_t vertices) {
  std::array<std::uint64_t, 3> form{}, exponent{};
  bool whole = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    form[axis] = in.plain(2);
    whole = whole || form[axis] == 3;
    if (form[axis] <= 1) exponent[axis] = in.below(23);
  }
  using Limits = std::numeric_limits<i64>;
  const auto integers = IntegerDecoder(in, walk, vertices, whole ? Limits::min() : -kMost53,
                                       whole ? Limits::max() : kMost53)
                            .run();
  Patterns patterns(vertices);
  for (std::size_t v = 0; v < vertices; ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      patterns[v][axis] =
          std::bit_cast<std::uint64_t>(meaning(form[axis], exponent[axis], integers[v][axis]));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<Counter, 30> number, skipped;
    std::uint64_t vertex = 0;
    for (std::uint64_t left = in.small(number); left > 0; --left) {
      vertex += in.small(skipped);
      require(vertex < vertices, "stream: an exception at no vertex");
      patterns[static_cast<std::size_t>(vertex++)][axis] = in.plain(64);
    }
  }
  return patterns;
}

Patterns decode_steps(Decisions& in, const Walk& walk, std::size_t vertices) {
  const std::uint64_t pattern = in.plain(64);
  const auto step = std::bit_cast<double>(pattern);
  require(std::isnormal(step) && step > 0, "stream: the step is no normal positive number");
  int exponent = 0;
  const double digits = std::frexp(step, &exponent) * 0x1p20;
  require(digits == std::floor(digits), "stream: the step has more than 20 bits");
  const i64 most = (i64{1} << 31) - 1;
  const auto integers = IntegerDecoder(in, walk, vertices, -most, most).run();
  Patterns patterns(vertices);
  for (std::size_t v = 0; v < vertices; ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      patterns[v][axis] =
          std::bit_cast<std::uint64_t>(static_cast<double>(integers[v][axis]) * step);
  return patterns;
}

}  // namespace

Patterns decode_positions(std::span<const std::uint8_t> section, const FaceList& faces,
                          std::size_t vertices, int mode) {
  Decisions in(section);
  const Walk walk(faces, vertices);
  Patterns patterns =
      mode == 1 ? decode_exact(in, walk, vertices) : decode_steps(in, walk, vertices);
  in.finish();
  for (const auto& point : patterns)
    for (const std::uint64_t pattern : point)
      require((pattern >> 52 & 0x7ff) != 0x7ff, "stream: a coordinate is not finite");
  return patterns;
}

}  // namespace crest::certify
