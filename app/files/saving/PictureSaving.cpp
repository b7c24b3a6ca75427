// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/PictureSaving.h"

#include "app/asking/FileDialogs.h"
#include "app/document/DocumentText.h"
#include "app/files/saving/ComparedPicture.h"
#include "app/files/saving/DrawingTime.h"
#include "app/window/WindowContext.h"
#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "scene/effects/EffectPlan.h"
#include "widgets/view/CompareView.h"

#include <QFileInfo>
#include <QLabel>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace limn {

static constexpr int cancelledToldForMs = 4000;

QString anotherIsDrawn() {
  return PictureSaving::tr(
      "Another picture is being drawn into its file; wait until it is there, or cancel it "
      "in the status bar.");
}

QString askForPicturePlace(WindowContext& context) {
  return askWhereToSave(&context.window,
                        {.title = PictureSaving::tr("Save the picture"),
                         .suggested = suggestedName(context.document) + QStringLiteral(".png"),
                         .filters = {PictureSaving::tr("Pictures (*.png *.tif *.jpg *.exr)")},
                         .isPicture = true},
                        context.settings);
}

PictureSaving::PictureSaving(WindowContext& context)
    : QObject(&context.window), m_context(context), m_text(new QLabel(context.window.statusBar())),
      m_stop(new QToolButton(context.window.statusBar())) {
  const QAction* save = context.actions.add(
      QStringLiteral("savePicture"),
      {.text = tr("Save &picture…"),
       .place = {Menu::file, 2, 4},
       .shortcut = tr("Ctrl+Shift+P"),
       .toolTip = tr("Saves the picture on screen at full quality, with its scene inside."),
       .icon = QStringLiteral("snapshot"),
       .iconText = tr("Snapshot"),
       .tool = {ToolPlace::atTheEnd, 1},
       .needsVolume = true});
  connect(save, &QAction::triggered, this, &PictureSaving::ask);
  m_stop->setObjectName(QStringLiteral("stopWaiting"));
  m_stop->setText(tr("Cancel"));
  m_stop->setAccessibleName(tr("Cancel: saving the picture"));
  m_stop->setMaximumHeight(m_text->sizeHint().height());
  m_stop->setStyleSheet(QStringLiteral("padding: 0px 4px; margin: 0px; text-decoration: underline;"));
  context.window.statusBar()->insertPermanentWidget(2, m_text);
  context.window.statusBar()->insertPermanentWidget(3, m_stop);
  // Once the event loop is back: the view may be drawing.
  connect(&context.view, &CompareView::told, this, [this] {
    if (!m_awaited.path().isEmpty())
      QTimer::singleShot(0, this, &PictureSaving::look);
  });
  // Nobody tells of a picture that stays as it is.
  connect(&context.actions.find("refineAtRest"), &QAction::toggled, this, &PictureSaving::look,
          Qt::QueuedConnection);
  connect(m_stop, &QToolButton::clicked, this, [this] {
    forget();
    m_context.window.statusBar()->showMessage(tr("Cancelled; nothing was saved."), cancelledToldForMs);
    emit cancelled();
  });
  forget();
}

PictureContent PictureSaving::content() const {
  return {m_context.view.scenesOfSides(), m_context.view.compareLayout()};
}

void PictureSaving::ask() {
  if (m_isDrawing)
    return m_context.notes.sayFailure(anotherIsDrawn());
  const PictureContent asked = content();
  const glm::ivec2 screen = savedSize(m_context.view.order().geometry);
  const std::optional<PictureOptions> options = askHowToSave(
      {screen.x, screen.y}, m_context.settings, &m_context.window, PictureKind::view, told(asked.scenes));
  if (!options)
    return;
  const QString path = askForPicturePlace(m_context);
  const auto requirePlace = [&] { // before anything is drawn for it
    requirePictureEnding(path.toStdString());
    requireWritable(path.toStdString());
  };
  if (path.isEmpty() || !m_context.notes.attempt(requirePlace))
    return;
  m_awaited.await(path, asked, *options);
  look();
}

// By what the screen's pictures took; what is as it stands there takes no time.
DrawingTold PictureSaving::told(const std::vector<Scene>& asked) {
  DrawingTold told;
  for (const Scene& scene : asked)
    if (isPhysical(scene))
      told.paths = savedPathsText(scene.shading.physical);
  if (m_context.session.planes().layout != PlaneLayout::pictureOnly)
    told.remark =
        tr("The 3D picture is saved without the slices: a right click on a slice saves that one, and "
           "File ▸ Save figure puts both in one file.");
  const ViewGeometry& geometry = m_context.view.order().geometry;
  const glm::ivec2 onScreen = savedSize(geometry);
  told.beside = standingCount(geometry);
  told.changePaths = [this] { emit pathsWanted(); };
  told.seconds = [this, asked,
                  screen = QSize(onScreen.x, onScreen.y)](const QSize& size) -> std::optional<double> {
    const double timesThePixels =
        double(size.width()) * size.height() / (double(screen.width()) * screen.height());
    const std::vector<SideState> sides = m_context.view.pictureState().sides; // of now: they go on
    double all = 0.0;
    bool isOnScreen = size == screen;
    for (std::size_t side = 0; side < asked.size() && side < sides.size(); ++side) {
      const std::optional<double> seconds = secondsToDraw(asked[side], sides[side], timesThePixels);
      if (!seconds)
        return std::nullopt;
      all += *seconds;
      isOnScreen = isOnScreen && isAsSaved(asked[side], sides[side]);
    }
    return isOnScreen ? 0.0 : all;
  };
  return told;
}

void PictureSaving::look() {
  const QString path = m_awaited.path();
  if (path.isEmpty())
    return;
  switch (m_awaited.look(content(), [this] { return isFinished(m_context.view.pictureState()); })) {
  case AwaitedPicture::Outcome::waits:
    say(waitingText(QFileInfo(path).fileName()));
    break;
  case AwaitedPicture::Outcome::complete:
    forget();
    emit complete(path, m_awaited.options());
    break;
  case AwaitedPicture::Outcome::changed:
    forget();
    m_context.notes.sayFailure(
        tr("The picture changed before it was complete, so it is not saved; save it again."));
    break;
  }
}

// A file is looked at for longer than the screen: it gets what the screen shows in the end, with what is
// known of its error. Physical light gains for minutes; how many paths a saved picture has is asked for by
// itself.
bool PictureSaving::isFinished(const PictureState& state) const {
  const std::vector<Scene> scenes = m_context.view.scenesOfSides();
  return state.resting &&
         (state.isFinal || !m_context.view.refinesAtRest() || std::ranges::any_of(scenes, isPhysical));
}

QString PictureSaving::waitingText(const QString& file) const {
  const PictureState state = m_context.view.pictureState();
  if (!state.resting)
    return tr("Saving %1 once the picture is complete").arg(file);
  if (state.refinementEnd)
    return tr("Saving %1 once it is known how exact the picture is").arg(file);
  if (state.refinementFraction <= 0.0)
    return tr("Saving %1 once the picture is refined").arg(file);
  return tr("Saving %1 once the picture is refined: %2 %")
      .arg(file, QString::number(static_cast<int>(100.0 * state.refinementFraction)));
}

void PictureSaving::forget() {
  m_awaited.forget();
  say({});
}

void PictureSaving::sayDrawing(const QString& text) {
  const bool wasDrawing = std::exchange(m_isDrawing, !text.isEmpty());
  if (m_isDrawing != wasDrawing)
    m_context.view.pauseRefinement(m_isDrawing);
  say(text);
}

QString PictureSaving::underWay() const {
  return m_isDrawing || !m_awaited.path().isEmpty() ? m_text->text() : QString();
}

void PictureSaving::say(const QString& text) {
  m_text->setText(text);
  m_text->setVisible(!text.isEmpty());
  m_stop->setVisible(!text.isEmpty());
}

} // namespace limn
