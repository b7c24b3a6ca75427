// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/VolumeBytes.h"

namespace limn::test {

/// The fields of a NIfTI header that the tests vary.
struct NiftiFields {
  int version = 1;
  bool bigEndian = false;
  bool isPair = false;
  std::array<int, 8> dim{3, 2, 3, 4, 1, 1, 1, 1};
  int datatype = 4; ///< int16
  std::array<double, 8> pixdim{1, 2, 3, 4, 0, 0, 0, 0};
  double slope = 0.0;
  double intercept = 0.0;
  int units = 2; ///< mm
  int qformCode = 0;
  int sformCode = 0;
  std::array<double, 3> quaternion{0, 0, 0};
  std::array<double, 3> offset{0, 0, 0};
  std::array<double, 12> rows{};
};

/// Writes numbers at byte offsets (offsets: nifti1.h and nifti2.h).
class NiftiWriter {
public:
  explicit NiftiWriter(const NiftiFields& fields)
      : m_big(fields.bigEndian), m_bytes(fields.version == 1 ? 348 : 540, '\0') {
    if (fields.version == 1)
      write<float, std::int16_t>(fields, {0, 40, 70, 76, 108, 112, 252, 256, 268, 280});
    else
      write<double, std::int64_t>(fields, {0, 16, 12, 104, 168, 176, 344, 352, 376, 400});
  }
  const std::string& bytes() const { return m_bytes; }

private:
  struct Offsets {
    std::size_t size, dim, datatype, pixdim, voxels, slope, codes, quaternion, offset, rows;
  };

  template <class T>
  void put(std::size_t at, T value) {
    m_bytes.replace(at, sizeof(T), bytesOf(std::vector<T>{value}, m_big));
  }

  template <class Real, class Length>
  void write(const NiftiFields& fields, const Offsets& at) {
    const bool isFirst = fields.version == 1;
    put<std::int32_t>(at.size, isFirst ? 348 : 540);
    for (std::size_t i = 0; i < 8; ++i) {
      put<Length>(at.dim + i * sizeof(Length), static_cast<Length>(fields.dim[i]));
      put<Real>(at.pixdim + i * sizeof(Real), static_cast<Real>(fields.pixdim[i]));
    }
    put<std::int16_t>(at.datatype, static_cast<std::int16_t>(fields.datatype));
    put<Real>(at.slope, static_cast<Real>(fields.slope));
    put<Real>(at.slope + sizeof(Real), static_cast<Real>(fields.intercept));
    for (std::size_t i = 0; i < 3; ++i) {
      put<Real>(at.quaternion + i * sizeof(Real), static_cast<Real>(fields.quaternion[i]));
      put<Real>(at.offset + i * sizeof(Real), static_cast<Real>(fields.offset[i]));
    }
    for (std::size_t i = 0; i < 12; ++i)
      put<Real>(at.rows + i * sizeof(Real), static_cast<Real>(fields.rows[i]));
    if (isFirst) {
      put<std::int16_t>(at.codes, static_cast<std::int16_t>(fields.qformCode));
      put<std::int16_t>(at.codes + 2, static_cast<std::int16_t>(fields.sformCode));
      put<float>(at.voxels, fields.isPair ? 0.0f : 352.0f);
      m_bytes[123] = static_cast<char>(fields.units);
      m_bytes.replace(344, 4, fields.isPair ? std::string("ni1\0", 4) : std::string("n+1\0", 4));
    } else {
      put<std::int32_t>(at.codes, fields.qformCode);
      put<std::int32_t>(at.codes + 4, fields.sformCode);
      put<std::int64_t>(at.voxels, fields.isPair ? 0 : 544);
      put<std::int32_t>(500, fields.units);
      m_bytes.replace(4, 8, std::string(fields.isPair ? "ni2\0\r\n\032\n" : "n+2\0\r\n\032\n", 8));
    }
  }

  bool m_big;
  std::string m_bytes;
};

/// A whole single-file NIfTI: header, four flag bytes, voxels.
inline std::string niftiFile(const NiftiFields& fields, const std::string& voxels) {
  return NiftiWriter(fields).bytes() + std::string(4, '\0') + voxels;
}

} // namespace limn::test
