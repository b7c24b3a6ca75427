// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace limn {

/// Memory that programs could still get, bytes; nothing where the system does not tell.
std::optional<std::uint64_t> freeMemory();

/// How much memory a process keeps for itself; what lies in a Room or in a mapped file is not counted.
class MemoryBudget {
public:
  /// Half of the memory that is free now, or of all where the system does not tell.
  MemoryBudget();
  explicit MemoryBudget(std::uint64_t bytes) : m_bytes(bytes) {}

  std::uint64_t bytes() const { return m_bytes; }

  /// Voxels of at most so many bytes lie in memory. The other two thirds are for what engines make of them.
  double voxelBytes() const { return static_cast<double>(m_bytes) / 3.0; }

  /// The same budget, under which all voxels are mapped that lie in a file as they are kept, however few:
  /// what is not needed of them is not read.
  MemoryBudget mappingAll() const {
    MemoryBudget mapping = *this;
    mapping.m_mapsAll = true;
    return mapping;
  }

  /// Voxels of more bytes are mapped where they can be.
  double unmappedBytes() const { return m_mapsAll ? 0.0 : voxelBytes(); }

  /// The least MB (10⁶ bytes) by which voxels of so many bytes lie in memory.
  static std::uint64_t leastMbFor(std::uint64_t voxelBytes) { return (3 * voxelBytes + 999'999) / 1'000'000; }

  /// What the program needs whatever it shows, for itself and for pictures.
  static constexpr std::uint64_t least = 64'000'000;

private:
  std::uint64_t m_bytes;
  bool m_mapsAll = false;
};

} // namespace limn
