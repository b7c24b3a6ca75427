// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/paths/Majorants.h"

#include "cpu/paths/PathTerms.h"
#include "scene/basics/StableMath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn::cpu {
namespace {

// Scalars in so many classes, and the largest of 1, 2, 4, … of them together: two look-ups bound any range.
constexpr int scalarClasses = 2048;
constexpr int spans = 12;

// A float of a field, and that of a range, may round to different classes.
constexpr double roundingOfScalars = 1e-5;

// An extinction computed in float may exceed the one computed here.
constexpr double roundingOfExtinctions = 1.0 + 1e-5;

class LargestExtinctions {
public:
  LargestExtinctions(const TransferFunction& function, const MajorantKey& key) {
    const double width = key.range.highest - key.range.lowest;
    const double unit = width > 0.0 ? width : 1.0;
    const auto value = [&](double place) { return key.range.lowest + unit * place; };
    for (std::vector<float>& span : m_spans)
      span.resize(scalarClasses);
    for (int i = 0; i < scalarClasses; ++i) {
      const double opacity =
          largestOpacityWithin(function, value(double(i) / scalarClasses - roundingOfScalars),
                               value(double(i + 1) / scalarClasses + roundingOfScalars));
      m_spans[0][i] =
          static_cast<float>(std::min(minusLog1mOpacity(key.mostFactor * opacity) * roundingOfExtinctions *
                                          key.lengthMm / function.unitDistanceMm,
                                      double(mostExtinction)));
    }
    for (int k = 1; k < spans; ++k)
      for (int i = 0; i < scalarClasses; ++i)
        m_spans[k][i] =
            std::max(m_spans[k - 1][i], m_spans[k - 1][std::min(i + (1 << (k - 1)), scalarClasses - 1)]);
  }

  float within(const glm::vec2& range) const {
    const int low = classOf(range.x);
    const int high = std::max(classOf(range.y), low);
    const int count = high - low + 1;
    int k = 0;
    while ((2 << k) <= count)
      ++k;
    return std::max(m_spans[k][low], m_spans[k][high - (1 << k) + 1]);
  }

private:
  static int classOf(float scalar) {
    return static_cast<int>(std::clamp(scalar * scalarClasses, 0.0f, float(scalarClasses - 1)));
  }

  std::array<std::vector<float>, spans> m_spans;
};

} // namespace

void Majorants::find(const MajorantKey& key, const BlockRanges& ranges, const BlockLooks& looks,
                     const BlockWeights& weights, const std::shared_ptr<Room>& room, const Effort& effort) {
  std::vector<LargestExtinctions> largest;
  for (const TransferFunction& function : key.functions)
    largest.emplace_back(function, key);
  const glm::ivec3 blocks = ranges.blocks();
  m_ofBlocks = RoomVector<float>(static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z, room);
  forEachPiece(blocks.z, effort, [&](int z) {
    std::size_t place = static_cast<std::size_t>(z) * blocks.x * blocks.y;
    for (int y = 0; y < blocks.y; ++y)
      for (int x = 0; x < blocks.x; ++x, ++place) {
        float most = 0.0f;
        if (weights.empty() || weights[place] != BlockWeight::none)
          for (std::size_t look = 0; look < largest.size(); ++look)
            if (largest.size() == 1 || (looks[place] >> look & 1) != 0)
              most = std::max(most, largest[look].within(ranges.at({x, y, z})));
        m_ofBlocks[place] = most;
      }
  });
}

} // namespace limn::cpu
