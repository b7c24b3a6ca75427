// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace limn {

/// Values as bytes that travel from rank to rank, all of which run the same program on the same kind of
/// machine. A value that tells its `fields()`, references to all that it is made of, travels as those.
class Carried {
public:
  explicit Carried(std::string bytes = {}) : m_bytes(std::move(bytes)) {}

  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(values.size());
    m_bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }

  template <class T>
  void take(T& value) {
    m_bytes.copy(reinterpret_cast<char*>(&value), sizeof value, m_at);
    m_at += sizeof value;
  }
  template <class T>
  void take(std::vector<T>& values) {
    std::size_t count = 0;
    take(count);
    values.resize(count);
    m_bytes.copy(reinterpret_cast<char*>(values.data()), count * sizeof(T), m_at);
    m_at += count * sizeof(T);
  }

  const std::string& bytes() const { return m_bytes; }

private:
  std::string m_bytes;
  std::size_t m_at = 0;
};

template <class Part>
std::string asText(Part part) {
  Carried carried;
  std::apply([&](auto&... fields) { (carried.put(fields), ...); }, part.fields());
  return carried.bytes();
}

template <class Part>
Part fromText(const std::string& text) {
  Carried carried(text);
  Part part;
  std::apply([&](auto&... fields) { (carried.take(fields), ...); }, part.fields());
  return part;
}

} // namespace limn
