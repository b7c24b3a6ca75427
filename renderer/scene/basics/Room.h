// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Descriptor.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace limn {

/// Where the large arrays of one volume lie: in memory where there is none of these (a null pointer), else in
/// files on disk without a name, which only this process sees and which end with it. What lies there is
/// mapped: the system keeps it in memory while there is some and writes it to the disk when others need that.
/// A file that holds voxels as they are needed lies in it where it is.
/// Safe on several threads; always owned by a shared pointer.
class Room : public std::enable_shared_from_this<Room> {
public:
  /// In `folder`, by default the one that `chosenFolder` names.
  explicit Room(std::filesystem::path folder = {}) : m_folder(std::move(folder)) {}

  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;

  /// $TMPDIR, else /var/tmp; never one that itself lies in memory. Throws Error where there is none.
  static std::filesystem::path chosenFolder();

  std::filesystem::path folder() const { return m_folder.empty() ? chosenFolder() : m_folder; }

  /// So many bytes for an array, all zero; fewer than `smallest` lie in memory and are not zero. Throws Error
  /// (other) with what is needed and what is free where the disk is too small or cannot be written.
  void* take(std::size_t bytes);
  /// Gives back what `take` gave for so many bytes.
  void giveBack(void* place, std::size_t bytes) noexcept;

  /// So many bytes of a file from `offset` on, mapped where they are and never written. Throws Error (other)
  /// where the file is shorter or cannot be mapped.
  std::shared_ptr<const std::byte> mapped(const std::filesystem::path& file, std::uint64_t offset,
                                          std::size_t bytes);

  /// Whether all that was put here is still there: false for good once a mapped file became shorter or a disk
  /// failed, and zeros were read instead.
  bool isWhole() const;

  /// Bytes on the disk now; mapped files are not counted.
  std::uint64_t taken() const { return m_taken; }

  /// Throws the Error of `take` where the disk has no room for so many bytes.
  void require(std::uint64_t bytes) const;

  /// Arrays of fewer bytes are not worth a file.
  static constexpr std::size_t smallest = std::size_t{1} << 16;

private:
  // A file that was mapped, and how long it must be.
  struct MappedFile {
    Descriptor file;
    std::uint64_t least = 0;
  };

  std::filesystem::path m_folder;
  std::atomic<std::uint64_t> m_taken{0};
  std::atomic<bool> m_isDamaged{false};
  mutable std::mutex m_mutex;
  std::vector<MappedFile> m_files;
};

/// Puts arrays into a room, or into memory where there is none. Elements that are made without a value stay
/// as they are found there.
template <class T>
class RoomAllocator {
public:
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
  using value_type = T;
  using propagate_on_container_copy_assignment = std::true_type;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  RoomAllocator(std::shared_ptr<Room> room = {}) noexcept : m_room(std::move(room)) {}
  template <class Other>
  RoomAllocator(const RoomAllocator<Other>& other) noexcept : m_room(other.room()) {}

  T* allocate(std::size_t count) {
    if (!m_room)
      return std::allocator<T>().allocate(count);
    if (count > static_cast<std::size_t>(-1) / sizeof(T))
      throw std::bad_array_new_length();
    return static_cast<T*>(m_room->take(count * sizeof(T)));
  }
  void deallocate(T* place, std::size_t count) noexcept {
    if (m_room)
      m_room->giveBack(place, count * sizeof(T));
    else
      std::allocator<T>().deallocate(place, count);
  }

  template <class Other>
  void construct(Other*) noexcept {}
  template <class Other, class... Arguments>
  void construct(Other* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }

  const std::shared_ptr<Room>& room() const { return m_room; }

  template <class Other>
  friend bool operator==(const RoomAllocator& a, const RoomAllocator<Other>& b) {
    return a.room() == b.room();
  }

private:
  std::shared_ptr<Room> m_room;
};

/// For large arrays of plain values that are written in pieces of work (compare UninitialisedVector):
/// `RoomVector<T>(count, room)`.
template <class T>
using RoomVector = std::vector<T, RoomAllocator<T>>;

} // namespace limn
