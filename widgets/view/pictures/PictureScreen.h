// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/PixelRect.h"
#include "scene/basics/Image.h"

#include <QImage>

#include <functional>
#include <memory>

namespace limn {

/// A picture over a background as 8 bits (Format_RGBA8888, opaque), rounded as picture files are.
QImage overBackground(const Image& picture, const glm::dvec3& background);

/// The same into a part of an image of four bytes a pixel, red first.
void putOverBackground(const Image& picture, const glm::dvec3& background, QImage& bytes,
                       const glm::ivec2& topLeft);

/// A complete picture of a side as everybody wants it: as drawn, and as shown and saved.
struct FinishedPicture {
  std::shared_ptr<const Image> image;
  QImage bytes; ///< over the background, rounded as a file is
  double contrast = 0.0;
};

/// Makes everything of a picture that was read back. Takes time with every pixel; needs no OpenGL, so that it
/// may run beside the event loop.
FinishedPicture finished(std::shared_ptr<const Image> image, const glm::dvec3& background);

class DrawingEngine;
struct Scene;

/// Pixels that a screen can show: those that it made room for.
class ShownPixels {
public:
  virtual ~ShownPixels() = default;
};

/// A picture that engines draw into, in 32-bit floats.
class PictureSheet : public ShownPixels {
public:
  /// Makes room for `size` pixels; keeps what is there where the size is the same. Throws Error.
  virtual void resize(const glm::ivec2& size) = 0;

  /// Lets an engine draw a tile of a picture as large as the sheet, and returns when it is drawn.
  virtual void draw(DrawingEngine& engine, const Scene& scene, const PixelRect& tile) = 0;

  /// Does work that draws into whatever is there to be drawn into, and returns when that is drawn.
  virtual void lend(const std::function<void()>& work) = 0;

  virtual Image read() const = 0;
  /// Reads the whole picture back as everybody wants it, over a background.
  virtual FinishedPicture finished(const glm::dvec3& background) const = 0;
  virtual bool isEmpty() const = 0;
};

/// A finished picture in 8 bits, rounded as a file is.
class FinishedSheet : public ShownPixels {
public:
  virtual void set(const FinishedPicture& picture) = 0;
};

/// Where pictures are drawn and shown: on the graphics card (GlScreen) or in memory (MemoryScreen).
class PictureScreen {
public:
  virtual ~PictureScreen() = default;

  virtual std::unique_ptr<PictureSheet> makeSheet() = 0;
  virtual std::unique_ptr<FinishedSheet> makeFinishedSheet() = 0;

  /// The time that a strip of a picture should take, ms: short where it holds up others.
  virtual double stripMs() const = 0;

  /// Comes before pieces of drawing: others may have drawn in between.
  virtual void reset() {}

  /// Begins to show pictures in `size` pixels, over a background.
  virtual void clear(const glm::ivec2& size, const glm::dvec3& background) = 0;

  /// Shows what lies in `part` of a picture that is stretched to `place`; pixels, y down.
  virtual void show(const ShownPixels& pixels, const PixelRect& place, const PixelRect& part,
                    const glm::dvec3& background) = 0;

  /// The signed difference of two pictures over the background, times `gain` (scene/view/CompareLayout).
  virtual void showDifference(const ShownPixels& left, const ShownPixels& right, const PixelRect& place,
                              const PixelRect& part, const glm::dvec3& background, double gain) = 0;

  /// What is shown since it was cleared, where that is in memory; null on the graphics card.
  virtual QImage frame() const { return {}; }
};

/// Pictures in textures, shown in the framebuffer that is bound when the screen is cleared. Needs the same
/// OpenGL context current for every call and the end of all that it made. Throws Error (openGl).
std::unique_ptr<PictureScreen> makeGlScreen();

/// Pictures in memory, shown in an image of its own; for engines that compute in memory. Needs no OpenGL and
/// belongs to no thread. `isCancelled` ends drawing with Cancelled (renderer/engine); it may be empty.
std::unique_ptr<PictureScreen> makeMemoryScreen(std::function<bool()> isCancelled);

} // namespace limn
