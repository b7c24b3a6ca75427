// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/SavingController.h"

#include "app/asking/FileDialogs.h"
#include "app/core/drawing/ComparedSides.h"
#include "app/core/drawing/PathDrawing.h"
#include "app/core/drawing/PictureMaker.h"
#include "app/core/drawing/StatedAccuracy.h"
#include "app/document/DocumentText.h"
#include "app/document/PrivateNames.h"
#include "app/files/saving/ComparedPicture.h"
#include "app/files/saving/DrawingTime.h"
#include "app/files/saving/PictureSaving.h"
#include "app/window/WindowContext.h"
#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "widgets/Translated.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"

#include <QFileInfo>
#include <QImage>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>

#include <algorithm>

namespace limn {
namespace {

constexpr int toldForMs = 4000;

// Of pictures at rest that chance does not know yet, or not for sure, what the status bar tells: of the worse
// of two. Absent where it tells none.
std::optional<PictureAccuracy> estimatedAccuracy(const PictureState& state) {
  double worst = 0.0;
  for (const SideState& side : state.sides) {
    const bool holds = side.chance || side.measuredLevels || (side.isResolved && side.isLightMeasured);
    const std::optional<double> levels = levelsOf(side);
    if (!state.resting || !holds || !levels || side.paths)
      return std::nullopt;
    worst = std::max(worst, *levels);
  }
  return accuracyByEstimate(worst);
}

// What paths or chance say of the pictures on screen, of the worse of two, or else an estimate; absent until
// they do.
std::optional<PictureAccuracy> accuracyOf(const PictureState& state) {
  std::vector<PathFigures> paths;
  for (const SideState& side : state.sides)
    if (side.paths)
      paths.push_back(*side.paths);
  if (!paths.empty() && paths.size() == state.sides.size())
    return accuracyOf(paths);
  std::optional<ErrorByChance> worst;
  for (const SideState& side : state.sides) {
    if (!side.chance)
      return estimatedAccuracy(state);
    if (!worst || side.chance->levels > worst->levels)
      worst = side.chance;
  }
  if (!worst)
    return std::nullopt;
  return accuracyByChance(*worst);
}

glm::dvec3 groundOf(PictureOptions::Ground ground, const glm::dvec3& shown) {
  return ground == PictureOptions::Ground::white   ? glm::dvec3(1.0)
         : ground == PictureOptions::Ground::black ? glm::dvec3(0.0)
                                                   : shown;
}

QString suggestedSession(const OpenDocument& document) {
  if (!document.sessionFile().isEmpty())
    return document.sessionFile();
  if (!document.sparedSession().isEmpty())
    return freePathBeside(document.sparedSession());
  return suggestedName(document) + QStringLiteral("-session.limn.json");
}

// What becomes of a session file that somebody else has changed.
enum class ChangedFile { kept, replaced, savedElsewhere };

ChangedFile askAboutChanged(QWidget& parent, const QString& file) {
  QMessageBox box(QMessageBox::Warning, SavingController::tr("Replace the changed session?"),
                  SavingController::tr("%1 was changed elsewhere since it was opened or saved here.")
                      .arg(QFileInfo(file).fileName()),
                  QMessageBox::Cancel, &parent);
  box.setObjectName(QStringLiteral("changedSession"));
  box.setInformativeText(
      SavingController::tr("Replacing it loses what was saved there; another name keeps both."));
  const QPushButton* replace = box.addButton(SavingController::tr("Replace"), QMessageBox::DestructiveRole);
  QPushButton* elsewhere = box.addButton(SavingController::tr("Save as…"), QMessageBox::AcceptRole);
  box.setDefaultButton(elsewhere);
  box.exec();
  return box.clickedButton() == replace     ? ChangedFile::replaced
         : box.clickedButton() == elsewhere ? ChangedFile::savedElsewhere
                                            : ChangedFile::kept;
}

} // namespace

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
  const QAction* saveAs =
      context.actions.add(QStringLiteral("saveSessionAs"), {.text = tr("Save session &as…"),
                                                            .place = {Menu::file, 2, 2},
                                                            .shortcut = tr("Ctrl+Shift+S"),
                                                            .needsVolume = true});
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
  connect(&m_drawing, &BackgroundWork::progressed, this, [this](double fraction) {
    emit drawing(tr("%1: %2 %").arg(m_drawn, QString::number(static_cast<int>(100.0 * fraction))) +
                 m_left.text(fraction));
  });
  connect(&m_drawing, &BackgroundWork::failed, this, [this](const QString& sentence) {
    m_isWriting = false;
    emit drawing({});
    m_context.notes.sayFailure(sentence);
  });
}

void SavingController::saveSession() {
  const QString file = m_context.document.sessionFile();
  if (file.isEmpty())
    return saveSessionAs();
  if (!m_context.document.sessionFileWasChanged())
    return writeSession(file);
  const ChangedFile answer = askAboutChanged(m_context.window, file);
  if (answer == ChangedFile::replaced)
    writeSession(file);
  else if (answer == ChangedFile::savedElsewhere)
    askForSession(freePathBeside(file));
}

void SavingController::saveSessionAs() {
  askForSession(suggestedSession(m_context.document));
}

void SavingController::askForSession(const QString& suggested) {
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
  m_context.planes.endLooseDrag(); // what lacks places is not saved
  SessionDocument session = m_session();
  const std::filesystem::path target(path.toStdString());
  session.scene.volume = volumeSeenFrom(target);
  session.scene.keep.labels = labelsSeenFrom(target, session.scene.keep.labels);
  for (std::string& mask : session.scene.keep.moreLabels)
    mask = labelsSeenFrom(target, mask);
  const auto write = [&] {
    const std::string text = sessionToJson(session);
    writeFileAtomically(target, text);
    m_context.document.settleIn(path, m_session(), digestOf(text));
    emit sessionSaved();
  };
  m_context.notes.attempt(write, path);
}

void SavingController::writeScene(const QString& path) {
  m_context.planes.endLooseDrag(); // what lacks places is not saved
  const std::filesystem::path target(path.toStdString());
  Scene scene = m_context.document.scene();
  nameSources(scene.keep, [&](const std::string& labels) { return labelsSeenFrom(target, labels); });
  SceneDocument document = documentOf(scene, volumeSeenFrom(target));
  document.measurements = m_context.session.measurements();
  document.views = m_context.session.views();
  m_context.notes.attempt([&] { writeFileAtomically(target, sceneToJson(document)); }, path);
}

/// How drawn sides become the picture that is saved.
struct SavingController::Arrangement {
  CompareLayout layout = CompareLayout::single;
  double wipe = 0.5;
  glm::dvec3 background{0.0};
  SavedMarks marks;
  OverlaySource overlay;

  Image of(const std::vector<Image>& sides) const;
};

Image SavingController::Arrangement::of(const std::vector<Image>& sides) const {
  Image image = sides.size() == 2 ? comparedPicture(sides[0], sides[1], layout, wipe, background) : sides[0];
  if (!marks.any())
    return image;
  return withMarks(image, savedMarksImage(overlay, marks, {image.size.x, image.size.y}));
}

/// A picture on its way into a file: all that the file tells beside its pixels. It holds no volume, because
/// it may be kept for long.
struct SavingController::PictureFile {
  std::string path;
  PictureOptions options;
  glm::dvec3 background{0.0};
  double dotsPerInch = 0.0; ///< 0: nothing is said
  std::string description;
  QString exactness{}; ///< of paths, once it is drawn

  /// Throws Error.
  void write(const Image& image) const;
};

// The picture at rest as it is written without marks on the ground of the screen: the bits of the command
// line.
void SavingController::PictureFile::write(const Image& image) const {
  const bool isTransparent = options.ground == PictureOptions::Ground::transparent;
  const bool saysMore = isTransparent || dotsPerInch > 0.0;
  if (!saysMore || !takesBytes(path))
    return writeImage(path, image, background, description);
  BytePicture bytes = isTransparent ? bytesWithAlpha(image) : bytesOverBackground(image, background);
  bytes.dotsPerInch = dotsPerInch;
  writeBytes(path, bytes, description);
}

void SavingController::writePicture(const QString& path, const PictureOptions& options) {
  m_context.planes.endLooseDrag(); // what lacks places is not saved
  const CompareView& view = m_context.view;
  const CompareLayout layout = view.compareLayout();
  std::vector<Image> sides;
  for (int side = 0; side < pictureCount(layout); ++side) {
    const std::optional<Image> picture = m_context.view.restingImage(side);
    if (!picture)
      return m_context.notes.sayFailure(tr("The picture is not complete yet; save it again once it is."));
    sides.push_back(*picture);
  }
  const int beside = standingCount(view.order().geometry);
  const glm::ivec2 onScreen = savedSize(view.order().geometry);
  const QSize screen(onScreen.x, onScreen.y), size = sizeInFile(options, screen, beside);
  bool isOnScreen = size == screen;
  std::vector<Scene> scenes;
  const PictureState shown = view.pictureState();
  for (std::size_t side = 0; side < sides.size(); ++side) {
    scenes.push_back(view.sceneOfRestingImage(static_cast<int>(side)));
    isOnScreen = isOnScreen && isAsSaved(scenes.back(), shown.sides.at(side));
  }
  if (!isOnScreen)
    for (Scene& drawn : scenes)
      drawn.quality.paths.reset(); // as many as are asked for, and not those on screen
  Scene scene = scenes.at(static_cast<std::size_t>(view.ownSide()));
  nameSources(scene.keep, [this](const std::string& labels) { return labelsInPicture(labels); });
  // Drawn again from its file it is as large.
  const glm::ivec2 its(size.width() / beside, size.height());
  scene.image.width = its.x;
  scene.image.height = its.y;
  scene.image.background = groundOf(options.ground, m_context.document.scene().image.background);
  const glm::dvec3 background = scene.image.background;
  const Arrangement arrangement{
      layout, view.wipePosition(), background, options.marks, {view.order(), shown}};
  PictureFile file{path.toStdString(), options, background, 0.0, {}};
  if (options.size == PictureOptions::Size::print)
    file.dotsPerInch = printDotsPerInch;
  else if (!isOnScreen) // on paper it is as large as on screen
    file.dotsPerInch = scaleOf(options, screen) * view.logicalDpiX() * view.devicePixelRatioF();
  SceneDocument document = documentOf(scene, volumeInPicture());
  document.measurements = m_context.session.measurements();
  document.sides = savedSides(view.order().comparison);
  if (isOnScreen) {
    file.description = sceneToJson(document, accuracyOf(shown));
    if (m_context.notes.attempt([&] { file.write(arrangement.of(sides)); }, path))
      sayGround(path, options);
    return;
  }
  drawPicture(file, document, arrangement, scenes, its);
}

void SavingController::drawPicture(const PictureFile& file, const SceneDocument& document,
                                   const Arrangement& arrangement, const std::vector<Scene>& scenes,
                                   const glm::ivec2& size) {
  const QString name = QFileInfo(QString::fromStdString(file.path)).fileName();
  const int columns = arrangement.layout == CompareLayout::sideBySide ? 2 * size.x : size.x;
  m_drawn = tr("Drawing %1, %2 × %3 pixels").arg(name, QString::number(columns), QString::number(size.y));
  m_left.begin(scenes.size());
  emit drawing(m_drawn);
  m_drawing.start([this, file, document, arrangement, scenes, size,
                   order = m_context.drawnLikeTheView()](const Effort& effort) -> BackgroundWork::Deliver {
    MakingOptions told = order;
    told.effort = effort; // each of two sides has its half of it
    std::vector<Image> sides(scenes.size());
    PictureFile drawn = file;
    std::vector<PathFigures> paths;
    makeEach(scenes, size, told, [&](std::size_t index, MadePicture picture) {
      if (picture.paths) {
        paths.push_back(*picture.paths);
        drawn.exactness += QLatin1Char(' ') + translated(sentenceOf(*picture.paths));
      }
      sides[index] = std::move(picture.image);
    });
    const bool areOfPaths = paths.size() == scenes.size();
    drawn.description = sceneToJson(document, areOfPaths ? std::optional(accuracyOf(paths)) : std::nullopt);
    return written(drawn, std::make_shared<const Image>(arrangement.of(sides)), nullptr);
  });
}

/// A drawn picture that could not be written, and why.
struct SavingController::Unwritten {
  PictureFile file;
  std::shared_ptr<const Image> image;
  QString sentence;

  std::size_t bytes() const { return image->pixels.size() * sizeof(glm::vec4); }
  QString name() const { return QFileInfo(QString::fromStdString(file.path)).fileName(); }
};

// Seconds of a large one. Until what became of the file is told it counts as being written: it cannot be
// cancelled any more.
BackgroundWork::Deliver SavingController::written(const PictureFile& file,
                                                  const std::shared_ptr<const Image>& image,
                                                  const std::shared_ptr<const Unwritten>& offered) {
  try {
    m_isWriting = true;
    file.write(*image);
  } catch (const Error& error) {
    return [this, file, image, offered, failure = error.sentence()] {
      m_isWriting = false;
      emit drawing({});
      std::erase(m_unwritten, offered);
      m_unwritten.push_back(std::make_shared<const Unwritten>(file, image, translated(failure)));
      giveUpOldest();
      offerElsewhere();
    };
  }
  return [this, offered, exactness = file.exactness.trimmed(), path = QString::fromStdString(file.path),
          options = file.options] {
    m_isWriting = false;
    emit drawing({});
    if (std::erase(m_unwritten, offered) > 0)
      offerElsewhere();
    m_context.notes.attempt([] {}, path); // it is there
    if (!exactness.isEmpty())
      m_context.messages.show(MessageBar::Kind::note, exactness);
    sayGround(path, options);
  };
}

// The latest are kept, as many as fit: however many fail, the memory is not filled with them.
void SavingController::giveUpOldest() {
  std::size_t bytes = 0;
  auto first = m_unwritten.end();
  while (first != m_unwritten.begin() && (bytes == 0 || bytes + (*std::prev(first))->bytes() <= m_mostKept))
    bytes += (*--first)->bytes();
  QStringList names;
  for (auto one = m_unwritten.begin(); one != first; ++one)
    names << (*one)->name();
  m_unwritten.erase(m_unwritten.begin(), first);
  if (!names.isEmpty())
    m_context.messages.show(MessageBar::Kind::warning,
                            tr("Lost, because the memory kept for pictures that could not be written is full "
                               "of later ones: %1.")
                                .arg(names.join(QStringLiteral(", "))));
}

// What took long to draw is kept until it is written or its offer is dismissed, whatever else is said. The
// others are offered once the one that failed last is gone.
void SavingController::offerElsewhere() {
  if (m_unwritten.empty())
    return m_context.unwritten.hide();
  QStringList others;
  for (std::size_t n = m_unwritten.size() - 1; n-- > 0;)
    others << m_unwritten[n]->sentence;
  const std::shared_ptr<const Unwritten>& offered = m_unwritten.back();
  m_context.unwritten.show(MessageBar::Kind::error, offered->sentence, others,
                           {tr("Save elsewhere…"), [this, offered] { saveElsewhere(offered); }},
                           {{}, [this, dismissed = std::weak_ptr(offered)] {
                              std::erase(m_unwritten, dismissed.lock());
                              offerElsewhere();
                            }});
}

void SavingController::saveElsewhere(const std::shared_ptr<const Unwritten>& offered) {
  if (m_drawing.isRunning())
    return m_context.notes.sayFailure(anotherIsDrawn());
  const QString path = askForPicturePlace(m_context);
  if (path.isEmpty())
    return;
  if (m_drawing.isRunning()) // it began while the place was looked for
    return m_context.notes.sayFailure(anotherIsDrawn());
  PictureFile other = offered->file;
  other.path = path.toStdString();
  m_drawn = tr("Writing %1").arg(QFileInfo(path).fileName());
  emit drawing(m_drawn);
  m_isWriting = true;
  m_drawing.start([this, other, offered](const Effort&) { return written(other, offered->image, offered); });
}

QStringList SavingController::unwritten() const {
  QStringList names;
  for (auto one = m_unwritten.rbegin(); one != m_unwritten.rend(); ++one)
    names << (*one)->name();
  return names;
}

void SavingController::sayGround(const QString& path, const PictureOptions& options) {
  if (const QString remark = groundRemark(path, options); !remark.isEmpty())
    m_context.messages.show(MessageBar::Kind::warning, remark);
}

// What becomes of a file that is being written is told: only then is it known whether its picture is lost.
void SavingController::cancelPicture() {
  if (m_drawing.isRunning() && m_isWriting) {
    m_context.window.statusBar()->showMessage(tr("Too late to cancel: the file is being written."),
                                              toldForMs);
    return emit drawing(m_drawn);
  }
  m_drawing.cancel();
  emit drawing({}); // of work that was ended nothing more is told
}

std::string SavingController::volumeInPicture() const {
  return volumeSeenFrom(std::filesystem::path(m_context.document.volumePath()).parent_path() / "picture");
}

std::string SavingController::labelsInPicture(const std::string& labels) const {
  return labelsSeenFrom(std::filesystem::path(m_context.document.volumePath()).parent_path() / "picture",
                        labels);
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

std::string SavingController::labelsSeenFrom(const std::filesystem::path& file,
                                             const std::string& labels) const {
  return seenFrom(file, labels, "labels");
}

} // namespace limn
