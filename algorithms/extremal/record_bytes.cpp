// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/record_bytes.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace crest::extremal {
namespace {

class Writer {
 public:
  template <class T>
  void operator()(const T& x) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* from = reinterpret_cast<const std::uint8_t*>(&x);
    bytes.insert(bytes.end(), from, from + sizeof(T));
  }
  template <class T>
  void operator()(const std::vector<T>& list) {
    (*this)(std::uint64_t{list.size()});
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* from = reinterpret_cast<const std::uint8_t*>(list.data());
    bytes.insert(bytes.end(), from, from + list.size() * sizeof(T));
  }
  std::vector<std::uint8_t> bytes;
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}
  template <class T>
  void operator()(T& x) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(&x, take(sizeof(T)), sizeof(T));
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    std::uint64_t count = 0;
    (*this)(count);
    static_assert(std::is_trivially_copyable_v<T>);
    // By division: a product of 64 bits may wrap round.
    if (count > rest_.size() / sizeof(T)) throw std::runtime_error("records: they end too early");
    list.resize(count);
    if (count > 0) std::memcpy(list.data(), take(count * sizeof(T)), count * sizeof(T));
  }
  bool empty() const { return rest_.empty(); }

 private:
  const std::uint8_t* take(std::size_t count) {
    if (count > rest_.size()) throw std::runtime_error("records: they end too early");
    const std::uint8_t* r = rest_.data();
    rest_ = rest_.subspan(count);
    return r;
  }
  std::span<const std::uint8_t> rest_;
};

template <class Archive, class All>
void visit_all(Archive& a, All& r) {
  a(r.cells.runs);
  a(r.cells.codes);
  a(r.cells.directions);
  a(r.cells.gradients);
  a(r.cells.fit);
  a(r.bisected.edges);
  a(r.bisected.trees);
  a(r.bisected.leaves);
  a(r.critical);
  a(r.undecided);
  a(r.faces);
  a(r.sheets[0]);
  a(r.sheets[1]);
  a(r.counts);
}

}  // namespace

std::vector<std::uint8_t> to_bytes(const Records& records) {
  Writer w;
  visit_all(w, records);
  return std::move(w.bytes);
}

Records records_from(std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  Records r;
  visit_all(reader, r);
  if (!reader.empty()) throw std::runtime_error("records: bytes are left behind them");
  return r;
}

}  // namespace crest::extremal
