// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/ComparedPicture.h"

#include "app/core/sources/BuiltInPresets.h"
#include "widgets/presets/PresetModel.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <QFileInfo>
#include <QImage>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Also of one that was remembered; the name over its picture says whether it was modified or moved onto the
// volume's values.
std::string nameInFile(const ComparedLook& look) {
  for (const Preset& preset : builtInPresets())
    if (presetWords(QString::fromStdString(preset.name)) == QString::fromStdString(look.names[0]) &&
        preset.transferFunction == look.shown.transferFunction)
      return preset.name;
  return lookWithoutName;
}

} // namespace

Image withMarks(Image image, const QImage& marks) {
  for (int y = 0; y < image.size.y; ++y) {
    const auto* row = reinterpret_cast<const QRgb*>(marks.constScanLine(y));
    for (int x = 0; x < image.size.x; ++x) {
      const glm::vec4 mark = glm::vec4(qRed(row[x]), qGreen(row[x]), qBlue(row[x]), qAlpha(row[x])) / 255.0f;
      image.at(x, y) = mark + (1.0f - mark.a) * image.at(x, y);
    }
  }
  return image;
}

glm::ivec2 savedSize(const ViewGeometry& geometry) {
  const std::vector<PixelRect> pictures = pictureRects(geometry);
  if (pictures.empty())
    return deviceSize(geometry);
  const glm::ivec2& one = pictures.front().size;
  return {geometry.layout == CompareLayout::sideBySide ? 2 * one.x : one.x, one.y};
}

bool takesBytes(const std::string& path) {
  const QString ending = QFileInfo(QString::fromStdString(path)).suffix().toLower();
  return ending == QStringLiteral("png") || ending.startsWith(QStringLiteral("tif"));
}

BytePicture bytesWithAlpha(const Image& image) {
  BytePicture picture{image.size, true, {}, 0.0};
  picture.bytes.reserve(4 * image.pixels.size());
  const auto byte = [](float value) {
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
  };
  for (const glm::vec4& pixel : image.pixels) {
    const float alpha = std::clamp(pixel.a, 0.0f, 1.0f);
    const glm::vec3 color = alpha > 0.0f ? glm::vec3(pixel) / alpha : glm::vec3(0.0f);
    for (int channel = 0; channel < 3; ++channel)
      picture.bytes.push_back(byte(color[channel]));
    picture.bytes.push_back(byte(alpha));
  }
  return picture;
}

ShownSides savedSides(const Comparison& shown) {
  if (shown.layout == CompareLayout::single)
    return {};
  if (!shown.look)
    return {shown.layout, shown.models[0], shown.models[1], shown.wipe};
  const Scene left = sceneOfSide(shown, 0);
  return {shown.layout, left.shading.model, sceneOfSide(shown, 1).shading.model, shown.wipe,
          presetOf(left, nameInFile(*shown.look))};
}

} // namespace limn
