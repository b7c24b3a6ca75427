// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/PictureScreen.h"

#include "engine/DrawingEngine.h"
#include "scene/PictureFigures.h"
#include "scene/Scene.h"
#include "scene/view/CompareLayout.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

// What Qt paints fastest; the same bytes as a finished picture's, whose fourth is not looked at.
constexpr QImage::Format sheetFormat = QImage::Format_RGBX8888;
constexpr QImage::Format frameFormat = QImage::Format_RGB32;

class MemoryPixels {
public:
  virtual ~MemoryPixels() = default;
  virtual const QImage& bytes() const = 0; ///< over the background
};

// Keeps each tile in 8 bits, too, so that showing what is there costs no more than painting it.
class MemorySheet final : public PictureSheet, public MemoryPixels {
public:
  explicit MemorySheet(std::function<bool()> isCancelled) : m_isCancelled(std::move(isCancelled)) {}

  void resize(const glm::ivec2& size) override {
    if (size == m_image.size)
      return;
    m_image = Image(size);
    m_bytes = QImage(size.x, size.y, sheetFormat);
    m_bytes.fill(Qt::black);
  }

  void draw(DrawingEngine& engine, const Scene& scene, const PixelRect& tile) override {
    const Image pixels = engine.draw(scene, m_image.size, tile, m_isCancelled).value();
    for (int y = 0; y < tile.size.y; ++y)
      std::copy_n(&pixels.at(0, y), tile.size.x, &m_image.at(tile.topLeft.x, tile.topLeft.y + y));
    putOverBackground(pixels, scene.image.background, m_bytes, tile.topLeft);
  }

  void lend(const std::function<void()>& work) override { work(); }
  Image read() const override { return m_image; }
  FinishedPicture finished(const glm::dvec3&) const override {
    QImage bytes = m_bytes.copy();
    bytes.reinterpretAsFormat(QImage::Format_RGBA8888);
    return {std::make_shared<const Image>(m_image), bytes, contrastOf(m_image)};
  }
  bool isEmpty() const override { return m_image.size.x == 0; }
  const QImage& bytes() const override { return m_bytes; }

private:
  std::function<bool()> m_isCancelled;
  Image m_image;
  QImage m_bytes;
};

class MemoryFinishedSheet final : public FinishedSheet, public MemoryPixels {
public:
  void set(const FinishedPicture& picture) override { m_bytes = picture.bytes; }
  const QImage& bytes() const override { return m_bytes; }

private:
  QImage m_bytes;
};

QRect asQt(const PixelRect& rect) {
  return {rect.topLeft.x, rect.topLeft.y, rect.size.x, rect.size.y};
}

QColor colorOf(const glm::dvec3& color) {
  return QColor::fromRgbF(static_cast<float>(color.r), static_cast<float>(color.g),
                          static_cast<float>(color.b));
}

// Levels of the part that differs most, right minus left.
int mostApart(QRgb left, QRgb right) {
  int most = qRed(right) - qRed(left);
  for (const int apart : {qGreen(right) - qGreen(left), qBlue(right) - qBlue(left)})
    if (std::abs(apart) > std::abs(most))
      most = apart;
  return most;
}

std::size_t placeOf(int apart) {
  const int place = apart + 255;
  return static_cast<std::size_t>(place);
}

// The colour of every difference from -255 to 255.
std::array<QRgb, 511> differenceColors(double gain) {
  std::array<QRgb, 511> colors{};
  for (int apart = -255; apart <= 255; ++apart) {
    const glm::dvec3 color =
        std::min(1.0, gain * std::abs(apart) / 255.0) * (apart < 0 ? leftBrighterColor : rightBrighterColor);
    colors[placeOf(apart)] = colorOf(color).rgb();
  }
  return colors;
}

// The left picture becomes the difference; both have the format of frames.
void keepDifference(QImage& left, const QImage& right, double gain) {
  const std::array<QRgb, 511> colors = differenceColors(gain);
  for (int y = 0; y < left.height(); ++y) {
    auto* row = reinterpret_cast<QRgb*>(left.scanLine(y));
    const auto* other = reinterpret_cast<const QRgb*>(right.constScanLine(y));
    for (int x = 0; x < left.width(); ++x)
      row[x] = colors[placeOf(mostApart(row[x], other[x]))];
  }
}

class MemoryScreen final : public PictureScreen {
public:
  explicit MemoryScreen(std::function<bool()> isCancelled) : m_isCancelled(std::move(isCancelled)) {}

  std::unique_ptr<PictureSheet> makeSheet() override { return std::make_unique<MemorySheet>(m_isCancelled); }
  std::unique_ptr<FinishedSheet> makeFinishedSheet() override {
    return std::make_unique<MemoryFinishedSheet>();
  }

  // Drawing ends where something else is asked for, so that strips need not be short; each ends with threads
  // that wait for the last one.
  double stripMs() const override { return 50.0; }

  void clear(const glm::ivec2& size, const glm::dvec3& background) override {
    m_frame = QImage(size.x, size.y, frameFormat);
    m_frame.fill(colorOf(background));
  }

  void show(const ShownPixels& pixels, const PixelRect& place, const PixelRect& part,
            const glm::dvec3&) override {
    paint(m_frame, pixels, place, part, {0, 0});
  }

  void showDifference(const ShownPixels& left, const ShownPixels& right, const PixelRect& place,
                      const PixelRect& part, const glm::dvec3&, double gain) override {
    QImage one(part.size.x, part.size.y, frameFormat);
    QImage other(part.size.x, part.size.y, frameFormat);
    paint(one, left, place, part, part.topLeft);
    paint(other, right, place, part, part.topLeft);
    keepDifference(one, other, gain);
    QPainter(&m_frame).drawImage(part.topLeft.x, part.topLeft.y, one);
  }

  QImage frame() const override { return m_frame; }

private:
  // Paints into an image whose upper left corner is `origin`.
  static void paint(QImage& image, const ShownPixels& pixels, const PixelRect& place, const PixelRect& part,
                    const glm::ivec2& origin) {
    const QImage& bytes = dynamic_cast<const MemoryPixels&>(pixels).bytes();
    QPainter painter(&image);
    painter.translate(-origin.x, -origin.y);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.setRenderHint(QPainter::SmoothPixmapTransform,
                          bytes.width() != place.size.x || bytes.height() != place.size.y);
    painter.setClipRect(asQt(part));
    painter.drawImage(asQt(place), bytes);
  }

  std::function<bool()> m_isCancelled;
  QImage m_frame;
};

} // namespace

std::unique_ptr<PictureScreen> makeMemoryScreen(std::function<bool()> isCancelled) {
  return std::make_unique<MemoryScreen>(std::move(isCancelled));
}

} // namespace limn
