// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/figures/FigureFiles.h"

#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "io/PdfDescription.h"
#include "scene/basics/Error.h"
#include "widgets/figure/FigurePainting.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

#include <cmath>
#include <new>

namespace limn {
namespace {

namespace fs = std::filesystem;

// The bytes row by row, without what QImage leaves at the end of rows.
std::vector<std::uint8_t> tightBytes(const QImage& image, int channels) {
  std::vector<std::uint8_t> bytes;
  const auto row = static_cast<std::size_t>(image.width()) * channels;
  bytes.reserve(row * image.height());
  for (int y = 0; y < image.height(); ++y)
    bytes.insert(bytes.end(), image.constScanLine(y), image.constScanLine(y) + row);
  return bytes;
}

void writeAsBytes(const fs::path& path, const MadeFigure& made, const std::string& description) {
  const bool hasAlpha = made.figure.settings.page == FigureSettings::Page::transparent;
  BytePicture picture{
      {made.layout.size.width(), made.layout.size.height()}, hasAlpha, {}, made.figure.settings.dotsPerInch};
  picture.bytes =
      tightBytes(imageOf(made).convertToFormat(hasAlpha ? QImage::Format_RGBA8888 : QImage::Format_RGB888),
                 hasAlpha ? 4 : 3);
  writeBytes(path, picture, description);
}

// Everything around the pictures, and the marks on them, without the pictures.
QImage furnitureOf(const MadeFigure& made) {
  QImage image(made.layout.size, QImage::Format_ARGB32_Premultiplied);
  if (image.isNull())
    throw std::bad_alloc();
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  paintPage(painter, made.figure, made.layout);
  paintMarks(painter, made.figure, made.layout);
  return image;
}

// Where no mark covers a picture, its floats stay as they are.
Image floatFigure(const MadeFigure& made) {
  const QImage furniture = furnitureOf(made);
  Image figure({made.layout.size.width(), made.layout.size.height()});
  for (std::size_t panel = 0; panel < made.floats.size(); ++panel) {
    const QRect& place = made.layout.pictures[panel];
    for (int y = 0; y < place.height(); ++y)
      std::copy_n(&made.floats[panel].at(0, y), place.width(), &figure.at(place.left(), place.top() + y));
  }
  for (int y = 0; y < figure.size.y; ++y) {
    const auto* row = reinterpret_cast<const QRgb*>(furniture.constScanLine(y));
    for (int x = 0; x < figure.size.x; ++x)
      if (qAlpha(row[x]) > 0) {
        const glm::vec4 above =
            glm::vec4(qRed(row[x]), qGreen(row[x]), qBlue(row[x]), qAlpha(row[x])) / 255.0f;
        figure.at(x, y) = above + (1.0f - above.a) * figure.at(x, y);
      }
  }
  return figure;
}

// In memory first: the writer itself does not say where a disk is full.
void writeAsPdf(const fs::path& path, const MadeFigure& made, const std::string& description) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    const double pointsPerPixel = 72.0 / made.figure.settings.dotsPerInch;
    writer.setPageLayout(QPageLayout(
        QPageSize(QSizeF(made.layout.size) * pointsPerPixel, QPageSize::Point, {}, QPageSize::ExactMatch),
        QPageLayout::Portrait, QMarginsF()));
    writer.setTitle(QStringLiteral("Limn"));
    writer.setCreator(QStringLiteral("Limn"));
    writer.setDocumentXmpMetadata(QByteArray::fromStdString(pdfMetadata(description)));
    writer.setResolution(static_cast<int>(std::lround(made.figure.settings.dotsPerInch)));
    QPainter painter(&writer);
    // The writer counts whole dots per inch; the figure counts its own pixels.
    painter.setWindow(QRect(QPoint(0, 0), made.layout.size));
    paintFigure(painter, made.figure, made.layout, made.pictures);
  }
  writeFileAtomically(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

} // namespace

FigureFormat figureFormatOf(const fs::path& path) {
  const QString ending = QString::fromStdString(path.extension().string()).toLower();
  if (ending == QLatin1String(".png"))
    return FigureFormat::png;
  if (ending == QLatin1String(".tif") || ending == QLatin1String(".tiff"))
    return FigureFormat::tiff;
  if (ending == QLatin1String(".exr"))
    return FigureFormat::exr;
  if (ending == QLatin1String(".pdf"))
    return FigureFormat::pdf;
  throw Error(
      Error::Kind::usage,
      Message::tr("Cannot write %1: a figure needs the ending .png, .tif, .exr or .pdf.").arg(path.string()));
}

QImage imageOf(const MadeFigure& made) {
  return figureImage(made.figure, made.layout, made.pictures);
}

void writeFigure(const fs::path& path, const MadeFigure& made, const std::string& description) {
  switch (figureFormatOf(path)) {
  case FigureFormat::png:
  case FigureFormat::tiff:
    return writeAsBytes(path, made, description);
  case FigureFormat::exr:
    return writeImage(path, floatFigure(made), glm::dvec3(0.0), description);
  case FigureFormat::pdf:
    return writeAsPdf(path, made, description);
  }
}

} // namespace limn
