// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/exports/TurntableDialog.h"

#include "app/document/DocumentText.h"
#include "app/files/saving/ComparedPicture.h"
#include "app/files/saving/DrawingTime.h"
#include "app/files/saving/SavingController.h"
#include "io/scenefile/SceneFile.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberField.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/overlay/SavedOverlay.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// A driver's and a video's frames are no larger.
constexpr double mostSide = 8192.0;

constexpr double noticed = 0.98; // what begins smaller than that is seen to

constexpr int settledMs = 120; // what changes again within that is not asked about

// Most players need them (app/core/making/Turntable).
double evenSide(double pixels) {
  return 2.0 * std::floor(pixels / 2.0);
}

// What stands in a saved picture that turns: neither titles, nor what was measured, which other sides hide.
constexpr SavedMarks marksOfTurn{false, true, true, true, false};

// As in the window, of a frame that is as high as its picture.
MarkPicture marksOver(OverlaySource window, const glm::ivec2& size) {
  const int height = std::max(1, window.geometry.size.height());
  window.geometry.layout = CompareLayout::single;
  window.geometry.size = QSize(std::max(1, height * size.x / size.y), height);
  window.comparison.layout = CompareLayout::single;
  window.comparison.look.reset();
  window.comparison.turnsAboutMm.reset(); // it turns about the camera's target
  return [window](Image picture, const Scene& scene) {
    OverlaySource shown = window;
    shown.comparison.scene = scene;
    const QImage marks = savedMarksImage(shown, marksOfTurn, {picture.size.x, picture.size.y});
    return withMarks(std::move(picture), marks);
  };
}

// Whoever sees something measured in the window looks for it in the frames.
QString unmeasuredText(const Comparison& shown) {
  return shown.measures.empty() ? QString() : TurntableDialog::tr("What was measured is not in its frames.");
}

// What no mark in its frames tells: what is hidden, and of a video, which carries no scene, the model in any
// case.
QString untoldText(const Comparison& shown, const Scene& scene, bool isVideo) {
  const QString hidden = hiddenText(shown);
  if (hidden.isEmpty() && !isVideo)
    return {};
  QStringList untold{sideTitle(scene)};
  if (!hidden.isEmpty())
    untold << hidden;
  return TurntableDialog::tr("Its frames do not say what they show: %1.")
      .arg(untold.join(QStringLiteral(" · ")));
}

} // namespace

TurntableDialog::TurntableDialog(WindowContext& context, const SavingController* saving)
    : ExportDialog(context, {QStringLiteral("turntable"), tr("Drawing the turntable"), tr("Cancelled.")}),
      m_saving(*saving), m_width(new NumberField(16.0, mostSide, 0, this)),
      m_height(new NumberField(16.0, mostSide, 0, this)), m_frames(new NumberField(2.0, mostFrames, 0, this)),
      m_perSecond(new NumberField(1.0, 240.0, 0, this)), m_angle(new NumberField(1.0, 360.0, 1, this)),
      m_turn(new QuietComboBox(this)),
      m_marks(new QCheckBox(tr("&Letters, scale and \"Not for diagnosis\""), this)),
      m_kind(new QuietComboBox(this)), m_picture(new QuietComboBox(this)), m_start(new QuietComboBox(this)),
      m_form(new QFormLayout) {
  setWindowTitle(tr("Save a turntable"));
  m_kind->setObjectName(QStringLiteral("turntableKind"));
  m_picture->setObjectName(QStringLiteral("turntablePicture"));
  m_start->setObjectName(QStringLiteral("turntableStart"));
  m_start->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_frames->setObjectName(QStringLiteral("turntableFrames"));
  m_width->setObjectName(QStringLiteral("turntableWidth"));
  m_height->setObjectName(QStringLiteral("turntableHeight"));
  m_width->setAccessibleName(tr("Width in pixels"));
  m_height->setAccessibleName(tr("Height in pixels"));
  m_frames->setNumber(90.0);
  m_perSecond->setNumber(25.0);
  const QRectF picture = context.view.logicalRect(0);
  m_width->setNumber(evenSide(picture.width()));
  m_height->setNumber(evenSide(picture.height()));
  m_angle->setNumber(360.0);
  m_angle->setSuffix(QStringLiteral("°"));
  m_angle->setObjectName(QStringLiteral("turntableAngle"));
  m_angle->setAccessibleName(tr("Angle of the turn"));
  m_turn->setObjectName(QStringLiteral("turntableTurn"));
  m_turn->addItems({tr("Whole turn"), tr("Half turn"), tr("Another angle")});
  m_marks->setObjectName(QStringLiteral("turntableMarks"));
  m_marks->setChecked(true);
  layOut(!videoProgram().empty());
  m_soon.setSingleShot(true);
  m_soon.setInterval(settledMs);
  connect(&m_soon, &QTimer::timeout, this, [this] {
    if (saysLength())
      showLength();
  });
  connect(&context.session, &Session::measurementsChanged, &m_soon, qOverload<>(&QTimer::start));
  connect(&context.session, &Session::viewsChanged, this, [this](const std::vector<NamedView>& views) {
    setStarts(views);
    m_soon.start();
  });
  // How long drawing takes is known once the picture on screen is complete.
  connect(&context.view, &CompareView::told, this, [this](const ViewNews& news) {
    if (news.state.resting && saysLength())
      sayLength();
  });
  for (NumberField* field : {m_frames, m_perSecond, m_width, m_height, m_angle})
    connect(field, &NumberField::numberEdited, this, &TurntableDialog::showLength);
  for (const QComboBox* box : {m_kind, m_picture, m_start})
    connect(box, &QComboBox::activated, this, &TurntableDialog::showLength);
  connect(m_turn, &QComboBox::activated, this, &TurntableDialog::takeTurn);
  connect(m_angle, &NumberField::numberEdited, this, &TurntableDialog::showTurn);
  showLength();
}

ActionLook TurntableDialog::look() {
  return {.text = tr("Save &turntable…"),
          .place = {Menu::file, 2, 6},
          .toolTip = tr("Saves the picture from all around, as frames or a video.")};
}

void TurntableDialog::layOut(bool hasVideo) {
  m_kind->addItem(tr("Frames in a folder (PNG)"));
  if (hasVideo)
    m_kind->addItem(tr("Video (MP4)"));
  auto* size = new QHBoxLayout;
  size->addWidget(m_width, 1);
  size->addWidget(new QLabel(QStringLiteral("×"), this));
  size->addWidget(m_height, 1);
  size->addWidget(new QLabel(tr("pixels"), this));
  m_form->addRow(tr("Save &as"), m_kind);
  m_form->addRow(tr("&Picture"), m_picture);
  m_form->addRow(tr("&Begins at"), m_start);
  m_form->addRow(tr("Size"), size);
  auto* turn = new QHBoxLayout;
  turn->addWidget(m_turn, 1);
  turn->addWidget(m_angle);
  auto* ofTurn = new QLabel(tr("&Turn"), this);
  ofTurn->setBuddy(m_turn);
  m_form->addRow(ofTurn, turn);
  m_form->addRow(tr("&Frames"), m_frames);
  m_form->addRow(tr("Frames per s&econd"), m_perSecond);
  m_form->addRow(QString(), m_marks);
  if (!hasVideo) {
    auto* missing = new QLabel(tr("A video can be made once the program ffmpeg is installed."), this);
    missing->setWordWrap(true);
    m_form->addRow(missing);
  }
  auto* save = new QPushButton(tr("&Save…"), this);
  save->setObjectName(QStringLiteral("turntableSave"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(outOfUseWhileWorking(m_form));
  addFoot(column, save);
  column->setStretchFactor(text(), 1);
  setMinimumWidth(440);
  connect(save, &QPushButton::clicked, this, &TurntableDialog::save);
}

// What was asked before is ended.
void TurntableDialog::showLength() {
  m_sizeAtFirst.reset();
  sayLength();
  if (!isVisible() || !m_context.session.scene().volume)
    return;
  m_fitting.start([this, turntable = wanted()](const Effort& effort) -> BackgroundWork::Deliver {
    return [this, size = sizeAtFirst(turntable, effort)] {
      m_sizeAtFirst = size;
      if (saysLength())
        sayLength();
    };
  });
}

bool TurntableDialog::saysLength() const {
  return isVisible() && said() == m_length;
}

void TurntableDialog::showScene(const Scene&) {
  m_soon.start();
}

// Closed, it keeps no volume.
void TurntableDialog::done(int result) {
  ExportDialog::done(result);
  if (isVisible())
    return;
  m_fitting.cancel();
  m_soon.stop();
}

void TurntableDialog::sayLength() {
  const double angle = m_angle->number();
  const double step = angle < 360.0 ? angle / (frames() - 1) : angle / frames();
  QStringList parts{tr("%1° about the patient's upright axis: a frame each %2°, %3 s.")
                        .arg(m_angle->textFromValue(angle), QLocale().toString(step, 'f', 1),
                             QLocale().toString(frames() / framesPerSecond(), 'f', 1))};
  if (const glm::ivec2 its = size(); its.x != m_width->number() || its.y != m_height->number())
    parts
        << tr("A video has even sides: %1 × %2 pixels.").arg(QString::number(its.x), QString::number(its.y));
  if (m_sizeAtFirst && *m_sizeAtFirst < noticed)
    parts << tr("It begins at %1 % of the size on screen, so that nothing is cut off while it turns.")
                 .arg(qRound(100.0 * *m_sizeAtFirst));
  parts << unmeasuredText(m_context.view.order().comparison) << drawingText();
  parts.removeAll(QString());
  m_length = parts.join(QLatin1Char(' '));
  say(m_length);
}

// By what the picture on screen took.
QString TurntableDialog::drawingText() const {
  const PictureState shown = m_context.view.pictureState();
  const auto side = static_cast<std::size_t>(std::max(0, m_picture->currentIndex()));
  const std::vector<PixelRect> places = pictureRects(m_context.view.order().geometry);
  if (side >= shown.sides.size() || places.empty() || !m_context.session.scene().volume)
    return {};
  const glm::dvec2 onScreen = places.front().size, its = size();
  const double timesThePixels = its.x * its.y / std::max(1.0, onScreen.x * onScreen.y);
  return framesTimeText(m_context.view.sceneOfSide(static_cast<int>(side)), m_context.view.engine(),
                        shown.sides[side], timesThePixels, frames());
}

void TurntableDialog::takeTurn(int choice) {
  if (choice < 2) {
    m_angle->setNumber(choice == 0 ? 360.0 : 180.0);
    return showLength();
  }
  m_angle->setFocus();
  m_angle->selectAll();
}

void TurntableDialog::showTurn() {
  m_turn->setCurrentIndex(m_angle->number() == 360.0 ? 0 : m_angle->number() == 180.0 ? 1 : 2);
}

bool TurntableDialog::isVideo() const {
  return m_kind->currentIndex() == 1;
}

glm::ivec2 TurntableDialog::size() const {
  const glm::dvec2 typed(m_width->number(), m_height->number());
  return isVideo() ? glm::ivec2(evenSide(typed.x), evenSide(typed.y)) : glm::ivec2(typed);
}

void TurntableDialog::setPictures(const QStringList& names, int usual) {
  QStringList before;
  for (int i = 0; i < m_picture->count(); ++i)
    before << m_picture->itemText(i);
  if (names == before)
    return;
  m_picture->clear();
  m_picture->addItems(names);
  m_picture->setCurrentIndex(usual);
  m_form->setRowVisible(m_picture, names.size() > 1);
}

// One that was chosen stays so, if it is still there.
void TurntableDialog::setStarts(const std::vector<NamedView>& views) {
  const QString before = m_start->currentText();
  m_start->clear();
  m_start->addItem(tr("What the picture shows"));
  for (const NamedView& view : views)
    m_start->addItem(QString::fromStdString(view.name));
  m_start->setCurrentIndex(std::max(0, m_start->findText(before)));
  m_form->setRowVisible(m_start, !views.empty());
}

int TurntableDialog::frames() const {
  return static_cast<int>(m_frames->number());
}

double TurntableDialog::framesPerSecond() const {
  return m_perSecond->number();
}

void TurntableDialog::begin(bool isNew) {
  const std::vector<Scene> scenes = m_context.view.scenesOfSides();
  setPictures(scenes.size() < 2 ? QStringList{sideTitle(scenes.front())}
                                : QStringList{tr("Left: %1").arg(sideTitle(scenes[0])),
                                              tr("Right: %1").arg(sideTitle(scenes[1]))},
              m_context.view.ownSide());
  setStarts(m_context.session.views());
  if (isNew && !isWorking())
    QTimer::singleShot(0, this, [this] { // once it is seen
      if (!isWorking())
        showLength();
    });
  else
    m_soon.start();
}

Turntable TurntableDialog::wanted() const {
  Turntable turntable;
  turntable.scene = m_context.view.sceneOfSide(std::max(0, m_picture->currentIndex()));
  if (const auto& views = m_context.session.views(); m_start->currentIndex() > 0)
    turntable.scene.camera = views.at(static_cast<std::size_t>(m_start->currentIndex()) - 1).camera;
  nameSources(turntable.scene.keep,
              [this](const std::string& labels) { return m_saving.labelsInPicture(labels); });
  turntable.size = size();
  turntable.frames = frames();
  turntable.angleDeg = m_angle->number();
  turntable.cameraAspect = m_context.view.pictureAspect();
  turntable.framesPerSecond = framesPerSecond();
  return turntable;
}

void TurntableDialog::save() {
  const QString name = suggestedName(m_context.document) + QStringLiteral("-turntable");
  const bool isVideo = this->isVideo();
  const Turntable turntable = wanted();
  m_framesDrawn = turntable.frames;
  m_isVideoDrawn = isVideo;
  setTelling(std::min(aHundredth, 1.0 / turntable.frames));
  setCancelled(isVideo ? tr("Cancelled; no video was saved.")
                       : tr("Cancelled; frames that were drawn stay in their folder."));
  const Comparison& shown = m_context.view.order().comparison;
  const QStringList untold{untoldText(shown, turntable.scene, isVideo), unmeasuredText(shown)};
  exportTo({.title = isVideo ? tr("Save the video") : tr("Save the frames in a new folder"),
            .suggested = isVideo ? name + QStringLiteral(".mp4") : name + QStringLiteral(".frames"),
            .filters = {isVideo ? tr("Video (*.mp4)") : tr("Folder of frames (*.frames)")},
            .isPicture = true},
           [turntable, untold,
            mark = m_marks->isChecked()
                       ? marksOver({m_context.view.order(), m_context.view.pictureState()}, turntable.size)
                       : MarkPicture(),
            order = m_context.drawnLikeTheView(), volume = m_saving.volumeInPicture(),
            measurements = m_context.session.measurements()](const std::string& path, const Effort& effort) {
             MakingOptions making = order;
             making.effort = effort;
             const DescribeScene describe = [&](const Scene& scene) {
               SceneDocument document = documentOf(scene, volume);
               document.measurements = measurements;
               document.sides.emplace(); // one picture
               return sceneToJson(document);
             };
             writeTurntable(path, turntable, making, describe, mark);
             QStringList told{tr("Saved %1.").arg(QFileInfo(QString::fromStdString(path)).fileName())};
             told += untold;
             told.removeAll(QString());
             return Outcome{told.join(QLatin1Char(' '))};
           });
}

QString TurntableDialog::doing(double fraction) const {
  const auto drawn = static_cast<int>(atOnePace(fraction) * m_framesDrawn);
  return tr("Drawing frame %1 of %2…").arg(std::min(m_framesDrawn, drawn + 1)).arg(m_framesDrawn);
}

double TurntableDialog::atOnePace(double fraction) const {
  return shareDrawn(fraction, m_isVideoDrawn);
}

} // namespace limn
