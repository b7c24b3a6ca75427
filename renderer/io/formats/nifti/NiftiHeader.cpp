// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/nifti/NiftiHeader.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace limn {
namespace {

using namespace std::string_view_literals;

constexpr std::int32_t size1 = 348;
constexpr std::int32_t size2 = 540;

// Reads numbers at byte offsets in either byte order.
class Fields {
public:
  Fields(std::string_view bytes, bool bigEndian)
      : m_bytes(bytes), m_swap(bigEndian != (std::endian::native == std::endian::big)) {}

  template <class T>
  T at(std::size_t offset) const {
    std::array<char, sizeof(T)> raw{};
    std::copy_n(m_bytes.data() + offset, sizeof(T), raw.data());
    if (m_swap)
      std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
  }

  template <class T>
  double number(std::size_t offset) const {
    return static_cast<double>(at<T>(offset));
  }

  template <class T>
  glm::dvec3 triple(std::size_t offset) const {
    return {number<T>(offset), number<T>(offset + sizeof(T)), number<T>(offset + 2 * sizeof(T))};
  }

private:
  std::string_view m_bytes;
  bool m_swap;
};

template <class Length, class Real>
void readArrays(NiftiHeader& header, const Fields& fields, std::size_t dim, std::size_t pixdim,
                std::size_t rows) {
  for (std::size_t i = 0; i < 8; ++i) {
    header.dim[i] = fields.number<Length>(dim + i * sizeof(Length));
    header.pixdim[i] = fields.number<Real>(pixdim + i * sizeof(Real));
  }
  for (std::size_t row = 0; row < 3; ++row) {
    const std::size_t start = rows + row * 4 * sizeof(Real);
    header.sformRows[row] = {fields.triple<Real>(start), fields.number<Real>(start + 3 * sizeof(Real))};
  }
}

NiftiHeader parse1(std::string_view bytes, bool bigEndian) {
  const Fields fields(bytes, bigEndian);
  NiftiHeader header;
  header.version = 1;
  header.bigEndian = bigEndian;
  header.singleFile = bytes.substr(344, 4) == "n+1\0"sv;
  readArrays<std::int16_t, float>(header, fields, 40, 76, 280);
  header.datatype = fields.at<std::int16_t>(70);
  header.bitsPerVoxel = fields.at<std::int16_t>(72);
  header.voxelOffset = fields.number<float>(108);
  header.slope = fields.number<float>(112);
  header.intercept = fields.number<float>(116);
  header.units = fields.at<std::uint8_t>(123);
  header.qformCode = fields.at<std::int16_t>(252);
  header.sformCode = fields.at<std::int16_t>(254);
  header.quaternion = fields.triple<float>(256);
  header.quaternionOffset = fields.triple<float>(268);
  return header;
}

NiftiHeader parse2(std::string_view bytes, bool bigEndian) {
  const Fields fields(bytes, bigEndian);
  NiftiHeader header;
  header.version = 2;
  header.bigEndian = bigEndian;
  header.singleFile = bytes.substr(4, 4) == "n+2\0"sv;
  readArrays<std::int64_t, double>(header, fields, 16, 104, 400);
  header.datatype = fields.at<std::int16_t>(12);
  header.bitsPerVoxel = fields.at<std::int16_t>(14);
  header.voxelOffset = fields.number<std::int64_t>(168);
  header.slope = fields.at<double>(176);
  header.intercept = fields.at<double>(184);
  header.units = fields.at<std::int32_t>(500);
  header.qformCode = fields.at<std::int32_t>(344);
  header.sformCode = fields.at<std::int32_t>(348);
  header.quaternion = fields.triple<double>(352);
  header.quaternionOffset = fields.triple<double>(376);
  return header;
}

bool startsWithSize(std::string_view bytes, std::int32_t size, bool bigEndian) {
  return bytes.size() >= static_cast<std::size_t>(size) &&
         Fields(bytes, bigEndian).at<std::int32_t>(0) == size;
}

} // namespace

std::optional<NiftiHeader> parseNiftiHeader(std::string_view bytes) {
  for (const bool bigEndian : {false, true}) {
    if (startsWithSize(bytes, size1, bigEndian)) {
      const std::string_view magic = bytes.substr(344, 4);
      if (magic == "n+1\0"sv || magic == "ni1\0"sv)
        return parse1(bytes, bigEndian);
    }
    if (startsWithSize(bytes, size2, bigEndian)) {
      const std::string_view magic = bytes.substr(4, 4);
      if (magic == "n+2\0"sv || magic == "ni2\0"sv)
        return parse2(bytes, bigEndian);
    }
  }
  return std::nullopt;
}

bool isAnalyzeHeader(std::string_view bytes) {
  return (startsWithSize(bytes, size1, false) || startsWithSize(bytes, size1, true)) &&
         !parseNiftiHeader(bytes);
}

} // namespace limn
