// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/volume/RegionDesk.h"

#include "app/document/Session.h"
#include "app/opening/OpenDialog.h"
#include "app/opening/SparseReports.h"
#include "app/window/MessageBar.h"
#include "io/labels/LabelReader.h"
#include "scene/volume/Orientation.h"
#include "widgets/Translated.h"

#include <QAction>
#include <QFileInfo>
#include <QRegularExpression>

namespace limn {
namespace {

// Labels stay open, each shown wholly; a body goes.
Region shownWholly(Region region) {
  if (region.kind != Region::Kind::labels)
    return {};
  std::fill(region.weights.begin(), region.weights.end(), 1.0);
  return region;
}

} // namespace

RegionDesk::RegionDesk(Parts parts) : QObject(&parts.window), m_parts(parts) {
  connect(&m_parts.bodyOnly, &QAction::triggered, this, &RegionDesk::setBodyOnly);
  connect(&m_work, &BackgroundWork::progressed, this,
          [this](double done) { emit progressed(done, m_doing); });
  connect(&m_work, &BackgroundWork::failed, this, [this](const QString& sentence) {
    end();
    m_parts.messages.show(MessageBar::Kind::error, sentence);
  });
}

void RegionDesk::askForLabels() {
  const QString path = askWhatToOpen(
      &m_parts.window,
      {.title = tr("Open the labels of this volume"),
       .filters = {tr("Segmentations (*.nrrd *.nhdr *.nii *.nii.gz *.dcm *.mha *.mhd *.vti *.vtk)"),
                   tr("All files (*)")}},
      m_parts.settings);
  if (!path.isEmpty())
    openLabels(path);
}

void RegionDesk::openLabels(const QString& path) {
  start(tr("Opening labels"), tr("open labels"), [path](const Volume& volume, const Progress& progress) {
    return FoundRegion{readLabels(path.toStdString(), gridOfFile(volume), progress), {}};
  });
}

void RegionDesk::setBodyOnly(bool isOn) {
  const QString gesture = tr("body only");
  if (!isOn)
    showEverything();
  else if (m_body.kind == Region::Kind::body)
    keep({m_body, {}}, gesture);
  else
    start(tr("Looking for the body"), gesture, bodyOf);
}

void RegionDesk::showEverything() {
  cancel();
  m_parts.session.setKeep(shownWholly(m_parts.session.scene().keep),
                          {nextGestureId(), tr("show everything")});
}

void RegionDesk::showScene(const Scene& scene) {
  if (scene.volume != m_volume) {
    cancel();
    m_volume = scene.volume;
    m_body = {};
  }
  if (scene.keep.kind == Region::Kind::body)
    m_body = scene.keep;
  m_parts.bodyOnly.setChecked(scene.keep.kind == Region::Kind::body);
}

void RegionDesk::start(const QString& what, const QString& gesture, Work work) {
  cancel();
  if (!m_volume)
    return;
  m_doing = what;
  emit progressed(-1.0, what);
  m_work.start([this, volume = m_volume, gesture,
                work = std::move(work)](const Effort& effort) -> BackgroundWork::Deliver {
    const Progress progress{SparseReports([&effort](double done, const Message&) { effort.report(done); }),
                            effort.isCancelled};
    return [this, found = work(*volume, progress), gesture] {
      end();
      keep(found, gesture);
    };
  });
}

// One or the other is kept; what gave way comes back by one click.
void RegionDesk::tellReplaced(const Region& before, const Region& now) {
  if (before.kind == now.kind || before.kind == Region::Kind::all || now.kind == Region::Kind::all)
    return;
  const bool wasBody = before.kind == Region::Kind::body;
  const QString gesture = wasBody ? tr("body only") : tr("labels again");
  m_parts.messages.show(
      MessageBar::Kind::question,
      wasBody ? tr("The labels stand in the place of Body only: one of the two decides what is kept.")
              : tr("Body only stands in the place of the labels: one of the two decides what is kept."),
      {}, {wasBody ? tr("Body only again") : tr("Labels again"), [this, before, gesture] {
             m_parts.messages.hide();
             m_parts.session.setKeep(before, {nextGestureId(), gesture});
           }});
}

void RegionDesk::keep(const FoundRegion& found, const QString& gesture) {
  const Region before = m_parts.session.scene().keep;
  m_parts.session.setKeep(found.region, {nextGestureId(), gesture});
  tellReplaced(before, found.region);
  if (!found.remark.empty() && isRestricting(found.region))
    m_parts.messages.show(MessageBar::Kind::warning, translated(found.remark), {},
                          {tr("Show everything"), [this] { showEverything(); }});
  else if (!found.remark.empty())
    m_parts.messages.show(MessageBar::Kind::warning, translated(found.remark));
  showScene(m_parts.session.scene());
}

void RegionDesk::cancel() {
  if (!m_work.isRunning())
    return;
  m_work.cancel();
  end();
}

void RegionDesk::end() {
  emit ended();
  // A box that was checked for what did not come of it.
  m_parts.bodyOnly.setChecked(m_parts.session.scene().keep.kind == Region::Kind::body);
}

bool isNamedLikeLabels(const QString& path) {
  static const QRegularExpression word(
      QStringLiteral("(^|[._ -])(seg|segmentation|label|labels|labelmap|mask)([._ -]|$)"),
      QRegularExpression::CaseInsensitiveOption);
  return word.match(QFileInfo(path).fileName()).hasMatch();
}

} // namespace limn
