// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/SavingController.h"

#include "app/asking/FileDialogs.h"
#include "app/core/drawing/PictureMaker.h"
#include "app/document/DocumentText.h"
#include "app/document/PrivateNames.h"
#include "app/window/WindowContext.h"
#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "widgets/view/CompareView.h"

#include <QFileInfo>
#include <QLabel>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// What chance says of the pictures on screen, of the worse of two; absent until it does.
std::optional<PictureAccuracy> accuracyOf(const PictureState& state) {
  std::optional<ErrorByChance> worst;
  for (const SideState& side : state.sides) {
    if (!side.chance)
      return std::nullopt;
    if (!worst || side.chance->levels > worst->levels)
      worst = side.chance;
  }
  if (!worst)
    return std::nullopt;
  return PictureAccuracy{worst->levels, describe(*worst).english()};
}

Image parted(const Image& left, const Image& right, double wipe) {
  Image result = left;
  const int column = std::clamp(static_cast<int>(std::lround(wipe * left.size.x)), 0, left.size.x);
  for (int y = 0; y < left.size.y; ++y)
    for (int x = column; x < left.size.x; ++x)
      result.at(x, y) = right.at(x, y);
  return result;
}

// The part of a colour that differs most (scene/view/CompareLayout.h).
float mostApart(const glm::vec3& left, const glm::vec3& right) {
  float most = 0.0f;
  for (int channel = 0; channel < 3; ++channel)
    if (std::abs(right[channel] - left[channel]) > std::abs(most))
      most = right[channel] - left[channel];
  return most;
}

Image differenceOf(const Image& left, const Image& right, const glm::vec3& background) {
  const auto over = [&](const glm::vec4& pixel) {
    return glm::clamp(glm::vec3(pixel) + (1.0f - pixel.a) * background, 0.0f, 1.0f);
  };
  Image result(left.size);
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    const float apart = mostApart(over(left.pixels[i]), over(right.pixels[i]));
    const double strength = std::min(1.0, differenceGain * std::abs(static_cast<double>(apart)));
    result.pixels[i] =
        glm::vec4(glm::vec3(strength * (apart < 0.0f ? leftBrighterColor : rightBrighterColor)), 1.0f);
  }
  return result;
}

} // namespace

PictureSaving::PictureSaving(WindowContext& context)
    : QObject(&context.window), m_context(context), m_text(new QLabel(context.window.statusBar())),
      m_stop(new QToolButton(context.window.statusBar())) {
  const QAction* save = context.actions.add(
      QStringLiteral("savePicture"),
      {.text = tr("Save &picture…"),
       .place = {Menu::file, 2, 4},
       .shortcut = tr("Ctrl+Shift+S"),
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
  connect(m_stop, &QToolButton::clicked, this, &PictureSaving::forget);
  forget();
}

PictureContent PictureSaving::content() const {
  return {m_context.view.scenesOfSides(), m_context.view.compareLayout()};
}

void PictureSaving::ask() {
  const PictureContent asked = content();
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString path = askWhereToSave(&m_context.window,
                                      {tr("Save the picture"),
                                       suggestedName(m_context.document) + QStringLiteral(".png"),
                                       {tr("Pictures (*.png *.tif *.jpg *.exr)")},
                                       folder},
                                      m_context.settings);
  if (path.isEmpty())
    return;
  m_awaited.await(path, asked);
  look();
}

void PictureSaving::look() {
  const QString path = m_awaited.path();
  if (path.isEmpty())
    return;
  switch (m_awaited.look(content(), [this] { return m_context.view.restingImage(0).has_value(); })) {
  case AwaitedPicture::Outcome::waits:
    m_text->setText(tr("Saving %1 once the picture is complete").arg(QFileInfo(path).fileName()));
    m_text->show();
    m_stop->show();
    break;
  case AwaitedPicture::Outcome::complete:
    forget();
    emit complete(path);
    break;
  case AwaitedPicture::Outcome::changed:
    forget();
    m_context.notes.sayFailure(
        tr("The picture changed before it was complete, so it is not saved; save it again."));
    break;
  }
}

void PictureSaving::forget() {
  m_awaited.forget();
  m_text->hide();
  m_stop->hide();
}

Image comparedPicture(const Image& left, const Image& right, CompareLayout layout, double wipe,
                      const glm::dvec3& background) {
  if (layout == CompareLayout::wipe)
    return parted(left, right, wipe);
  return layout == CompareLayout::difference ? differenceOf(left, right, glm::vec3(background))
                                             : sideBySide(left, right);
}

SavingController::SavingController(WindowContext& context, std::function<SessionDocument()> session)
    : QObject(&context.window), m_context(context), m_session(std::move(session)) {
  const QAction* save =
      context.actions.add(QStringLiteral("saveSession"),
                          {.text = tr("&Save session"),
                           .place = {Menu::file, 2, 1},
                           .shortcut = QKeySequence::Save,
                           .toolTip = tr("Saves all of your work but the volume itself: look and camera, "
                                         "comparison, slices and panels."),
                           .needsVolume = true});
  const QAction* saveAs = context.actions.add(
      QStringLiteral("saveSessionAs"),
      {.text = tr("Save session &as…"), .place = {Menu::file, 2, 2}, .needsVolume = true});
  const QAction* scene =
      context.actions.add(QStringLiteral("saveScene"),
                          {.text = tr("Save look and ca&mera (scene)…"),
                           .place = {Menu::file, 2, 3},
                           .toolTip = tr("Saves how the volume is shown: curve, light, camera, crop. For "
                                         "another volume, or for the command line."),
                           .needsVolume = true});
  connect(save, &QAction::triggered, this, &SavingController::saveSession);
  connect(saveAs, &QAction::triggered, this, &SavingController::saveSessionAs);
  connect(scene, &QAction::triggered, this, &SavingController::saveScene);
}

void SavingController::saveSession() {
  m_context.document.sessionFile().isEmpty() ? saveSessionAs()
                                             : writeSession(m_context.document.sessionFile());
}

void SavingController::saveSessionAs() {
  const QString suggested = m_context.document.sessionFile().isEmpty()
                                ? suggestedName(m_context.document) + QStringLiteral("-session.limn.json")
                                : m_context.document.sessionFile();
  const QString path = askWhereToSave(
      &m_context.window,
      {tr("Save the session"), suggested, {tr("Limn session (*.limn.json)"), tr("Any JSON file (*.json)")}},
      m_context.settings);
  if (!path.isEmpty())
    writeSession(path);
}

void SavingController::saveScene() {
  const QString suggested = suggestedName(m_context.document) + QStringLiteral(".limn.json");
  const QString path = askWhereToSave(
      &m_context.window,
      {tr("Save look and camera"), suggested, {tr("Limn scene (*.limn.json)"), tr("Any JSON file (*.json)")}},
      m_context.settings);
  if (!path.isEmpty())
    writeScene(path);
}

void SavingController::writeSession(const QString& path) {
  SessionDocument session = m_session();
  const std::filesystem::path target(path.toStdString());
  session.scene.volume = volumeSeenFrom(target);
  session.scene.keep.labels = labelsSeenFrom(target);
  const auto write = [&] {
    writeFileAtomically(target, sessionToJson(session));
    m_context.document.settleIn(path, m_session());
    emit sessionSaved();
  };
  m_context.notes.attempt(write, path);
}

void SavingController::writeScene(const QString& path) {
  const std::filesystem::path target(path.toStdString());
  Scene scene = m_context.document.scene();
  scene.keep.source = labelsSeenFrom(target);
  SceneDocument document = documentOf(scene, volumeSeenFrom(target));
  document.measurements = m_context.session.measurements();
  document.views = m_context.session.views();
  m_context.notes.attempt([&] { writeFileAtomically(target, sceneToJson(document)); }, path);
}

void SavingController::writePicture(const QString& path) {
  const std::optional<Image> left = m_context.view.restingImage(0);
  if (!left) {
    m_context.notes.sayFailure(tr("The picture is not complete yet; save it again once it is."));
    return;
  }
  const CompareLayout layout = m_context.view.compareLayout();
  const std::optional<Image> right =
      pictureCount(layout) == 2 ? m_context.view.restingImage(1) : std::nullopt;
  Scene scene = m_context.view.sceneOfRestingImage(m_context.view.ownSide());
  scene.keep.source = labelsInPicture();
  const auto write = [&] {
    const glm::dvec3& background = m_context.document.scene().image.background;
    writeImage(path.toStdString(),
               right ? comparedPicture(*left, *right, layout, m_context.view.wipePosition(), background)
                     : *left,
               background,
               sceneToJson(scene, volumeInPicture(), accuracyOf(m_context.view.pictureState()),
                           m_context.session.measurements()));
  };
  m_context.notes.attempt(write, path);
}

std::string SavingController::volumeInPicture() const {
  return volumeSeenFrom(std::filesystem::path(m_context.document.volumePath()).parent_path() / "picture");
}

std::string SavingController::labelsInPicture() const {
  return labelsSeenFrom(std::filesystem::path(m_context.document.volumePath()).parent_path() / "picture");
}

// How a file at this place names the volume and the label map. A relative path survives moving both together;
// one that may name the patient is kept in the settings, and the file gets a name that stands for it.
std::string SavingController::seenFrom(const std::filesystem::path& file, const std::filesystem::path& named,
                                       const std::string& kind) const {
  if (!named.is_absolute())
    return named.string();
  std::string relative = named.lexically_relative(std::filesystem::absolute(file).parent_path()).string();
  const Volume& shown = *m_context.document.scene().volume;
  if (!pathMayNameThePatient(QString::fromStdString(relative), shown.info().patient))
    return relative;
  return m_context.settings.referenceTo(named.string(), kind);
}

std::string SavingController::volumeSeenFrom(const std::filesystem::path& file) const {
  return seenFrom(file, m_context.document.volumePath(),
                  plainFileName(*m_context.document.scene().volume).toStdString());
}

std::string SavingController::labelsSeenFrom(const std::filesystem::path& file) const {
  return seenFrom(file, m_context.document.scene().keep.source, "labels");
}

} // namespace limn
