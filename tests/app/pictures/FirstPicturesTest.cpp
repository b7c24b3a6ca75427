// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/opening/SeriesDialog.h"
#include "app/pictures/ContactSheet.h"
#include "app/pictures/PicturedWindow.h"
#include "app/pictures/SharedVolumes.h"
#include "scene/volume/Histogram.h"

#include <cstdio>

// The first picture of every volume at hand, as the window opens it.

namespace limn {
namespace {

class FirstPictures : public test::PicturedWindow {
protected:
  // Opens it; of several series the one that is offered first. Empty, or why there is nothing to see.
  QString openFirst(const QString& source) {
    const auto before = scene().volume;
    if (!open(source))
      return QStringLiteral("it does not come to an end");
    if (auto* dialog = window->findChild<SeriesDialog*>()) {
      QTest::keyClick(dialog, Qt::Key_Return);
      if (!test::waitUntil([this] { return !window->loader().isLoading(); }))
        return QStringLiteral("it does not come to an end");
    }
    return scene().volume == before ? messages().sentence() : QString();
  }

  // Whether the voxels were seen before, in a file of another kind.
  bool isSeen() {
    const Histogram histogram = histogramOf(*scene().volume);
    const glm::ivec3 dims = scene().volume->grid().dims;
    for (const auto& [otherDims, other] : m_seen)
      if (dims == otherDims && other == histogram)
        return true;
    m_seen.emplace_back(dims, histogram);
    return false;
  }

  QImage pictureOnly() {
    const QImage all = shown();
    const double scale = window->devicePixelRatioF();
    const QRect place(view().mapTo(window.get(), QPoint(0, 0)) * scale, view().size() * scale);
    return all.copy(place);
  }

private:
  std::vector<std::pair<glm::ivec3, Histogram>> m_seen;
};

TEST_F(FirstPictures, ofEveryVolumeAtHand) {
  const char* const shared = std::getenv("LIMN_SHARED");
  std::vector<std::string> sources{"sample", "phantom:1"};
  if (shared)
    for (const std::filesystem::path& path : test::volumesBelow(std::filesystem::path(shared) / "data"))
      sources.push_back(path.string());
  else
    std::puts("LIMN_SHARED names no folder of volumes: the sheet has the sample and the phantom alone.");
  std::vector<test::NamedPicture> pictures;
  for (const std::string& source : sources) {
    const std::string name =
        source.substr(shared && source.starts_with(shared) ? std::string(shared).size() : 0);
    if (const QString why = openFirst(QString::fromStdString(source)); !why.isEmpty())
      std::printf("left out: %s: %s\n", name.c_str(), qPrintable(why));
    else if (isSeen())
      std::printf("left out: %s: the same voxels as one before\n", name.c_str());
    else
      pictures.push_back({QStringLiteral("%1\n%2").arg(QString::fromStdString(name),
                                                       QString::fromStdString(session().preset().name)),
                          pictureOnly()});
  }
  int page = 0;
  for (const QImage& sheet : test::contactSheet(pictures, 2, 3, {736, 412}))
    album->add(sheet, QStringLiteral("first-pictures-%1").arg(++page));
  EXPECT_GE(pictures.size(), 1u);
}

} // namespace
} // namespace limn
