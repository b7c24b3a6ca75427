// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Files.h"

#include "app/core/sources/LookSource.h"
#include "app/document/DocumentText.h"
#include "app/files/exports/DicomDialog.h"
#include "app/files/exports/TurntableDialog.h"
#include "app/window/WindowContext.h"
#include "widgets/controls/MessageBar.h"

#include <QDirIterator>
#include <QDropEvent>
#include <QFileInfo>
#include <QFontMetricsF>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QString>
#include <QUrl>
#include <QWidget>

#include <string>
#include <utility>
#include <vector>

namespace limn {
namespace {

// Of one image beside others, which alone shows little; nothing of other volumes.
QString folderOfSingleImage(const Volume& volume, const std::string& path) {
  const QFileInfo file(QString::fromStdString(path));
  if (volume.info().format != "DICOM" || volume.grid().dims.z != 1 || !file.isFile())
    return {};
  QDirIterator files(file.absolutePath(), QDir::Files);
  files.next();
  return files.hasNext() ? file.absolutePath() : QString();
}

QStringList filesIn(const QMimeData& data) {
  QStringList paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile())
      paths << url.toLocalFile();
  return paths;
}

} // namespace

RemarksController::RemarksController(WindowContext& context, OpeningController& opening)
    : QObject(&context.window), m_context(context), m_opening(opening) {
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene& scene) { followScene(scene); });
  // Queued: what was loaded is shown first, or left.
  connect(&opening, &OpeningController::loaded, this,
          [this](const LoadedScene& loaded, const Histogram&, const Request& request) {
            QMetaObject::invokeMethod(
                this, [this, loaded, request] { lookForLooks(loaded, request); }, Qt::QueuedConnection);
          });
}

void RemarksController::show(const LoadedScene& loaded, const Request& request) {
  m_notes = loaded.notes;
  m_figure = loaded.morePanels.empty() ? QString() : request.source;
  m_ofFigure = {};
  if (!m_figure.isEmpty()) { // a button does here what the command would
    m_ofFigure = loaded.morePanels.front();
    std::erase(m_notes, loaded.morePanels.back());
  }
  m_volume = m_context.session.scene().volume;
  say();
}

void RemarksController::say() {
  const QStringList remarks = remarksOn(*m_volume, m_notes);
  m_said = remarks.value(0);
  if (remarks.isEmpty())
    return;
  const MessageBar::Action setSpacing{tr("Set spacing…"), [this] {
                                        const auto& open = m_context.session.scene().volume;
                                        m_opening.askForSpacing(m_context.document.request(),
                                                                open ? open->grid().spacingMm
                                                                     : glm::dvec3(1.0));
                                      }};
  const MessageBar::Action setOrientation{tr("Set orientation…"),
                                          [this] { m_context.actions.find("setOrientation").trigger(); }};
  const QString folder = folderOfSingleImage(*m_volume, m_context.document.volumePath());
  const MessageBar::Action openFolder{tr("Open its folder"), [this, folder] { m_opening.open(folder); }};
  const MessageBar::Action showFigure{tr("Show the figure"), [this] { showWhole(); }};
  const VolumeInfo& info = m_volume->info();
  // What is measured comes before what is shown.
  const MessageBar::Action action = !folder.isEmpty()        ? openFolder
                                    : !info.spacingKnown     ? setSpacing
                                    : !info.orientationKnown ? setOrientation
                                    : !m_figure.isEmpty()    ? showFigure
                                                             : MessageBar::Action{};
  // Where something can be set right it is said each time: what is measured depends on it.
  const std::string path = m_context.document.volumePath();
  const QString all = remarks.join(QLatin1Char(' '));
  if (action.text.isEmpty() && m_context.settings.isDismissed(path, all)) {
    m_said.clear();
    return;
  }
  const auto remember = [this, path, all] { m_context.settings.setDismissed(path, all); };
  m_context.messages.show(MessageBar::Kind::warning, m_said, remarks.mid(1), action,
                          action.text.isEmpty() ? MessageBar::Action{{}, remember} : MessageBar::Action{});
}

// Once it is seen whole nothing is left to be said of its panels.
void RemarksController::showWhole() {
  std::erase(m_notes, m_ofFigure);
  const QString figure = std::exchange(m_figure, {});
  m_context.messages.hide();
  if (m_volume)
    say();
  emit figureAsked(figure);
}

// The same voxels, placed otherwise: a person said how they lie.
void RemarksController::followScene(const Scene& scene) {
  if (!m_volume || scene.volume == m_volume)
    return;
  const bool isPlacedAnew = scene.volume && scene.volume->sharesVoxelsWith(*m_volume);
  m_volume = isPlacedAnew ? scene.volume : nullptr;
  if (!isPlacedAnew || !isSaid())
    return;
  m_context.messages.hide();
  say();
}

bool RemarksController::isSaid() const {
  return !m_said.isEmpty() && m_context.messages.sentence() == m_said && !m_context.messages.isHidden();
}

RemarksController::Memory RemarksController::memory() const {
  return {m_notes, m_figure, m_ofFigure, isSaid()};
}

void RemarksController::takeOver(const Memory& memory) {
  m_notes = memory.notes;
  m_figure = memory.figure;
  m_ofFigure = memory.ofFigure;
  m_volume = m_context.session.scene().volume;
  if (memory.isSaid)
    say();
}

// Only of a series that was opened itself, not of what names one.
void RemarksController::lookForLooks(const LoadedScene& loaded, const Request& request) {
  m_searching.cancel();
  if (loaded.scene.volume != m_context.document.scene().volume || !loaded.dicom || loaded.session ||
      request.source.toStdString() != loaded.volumePath)
    return;
  m_searching.start([this, volume = loaded.scene.volume, dicom = loaded.dicom,
                     series = loaded.read.series](const Effort& effort) -> BackgroundWork::Deliver {
    Progress progress;
    progress.isCancelled = effort.isCancelled;
    const std::vector<std::filesystem::path> found = looksBeside(*dicom, series, progress);
    return [this, volume, found] {
      QStringList looks;
      for (const std::filesystem::path& look : found)
        looks << QString::fromStdString(look.string());
      offer(volume, looks);
    };
  });
}

// Nobody is named: a file may be called after its patient.
void RemarksController::offer(const std::shared_ptr<const Volume>& volume, const QStringList& looks) {
  m_isWaiting = false;
  if (looks.isEmpty() || m_context.document.scene().volume != volume)
    return;
  if (m_context.messages.isAsking()) { // of two questions the first comes first
    m_isWaiting = true;
    connect(
        &m_context.messages, &MessageBar::wanted, this, [this, volume, looks] { offer(volume, looks); },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
    return;
  }
  QStringList details;
  if (!m_context.messages.isHidden()) // what was said of the series stays to be read
    details << m_context.messages.sentence();
  const QString sentence =
      looks.size() == 1
          ? tr("Beside this series lies a look that belongs to it.")
          : tr("Beside this series lie %1 looks that belong to it; this is the newest.").arg(looks.size());
  m_context.messages.show(MessageBar::Kind::question, sentence, details,
                          {tr("Show the look"), [this, look = looks.first()] { m_opening.open(look); }},
                          {tr("Not now"), {}});
}

DropHint::DropHint(QWidget& window) : QWidget(&window) {
  setObjectName(QStringLiteral("dropHint"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

void DropHint::showOver(const QString& text) {
  m_text = text;
  setAccessibleName(text);
  setGeometry(parentWidget()->rect());
  raise();
  show();
  update();
}

// What is below stays to be seen.
void DropHint::paintEvent(QPaintEvent*) {
  constexpr double margin = 6.0;
  const QColor accent = palette().color(QPalette::Highlight);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(margin, margin, -margin, -margin);
  QColor veil = accent;
  veil.setAlphaF(0.12f);
  painter.setPen(QPen(accent, 3.0, Qt::DashLine));
  painter.setBrush(veil);
  painter.drawRoundedRect(frame, 10.0, 10.0);
  QFont large = font();
  large.setPointSizeF(1.3 * large.pointSizeF());
  painter.setFont(large);
  const QSizeF words = QFontMetricsF(large).size(Qt::TextSingleLine, m_text) + QSizeF(40.0, 20.0);
  QRectF plate(QPointF(0.0, 0.0), words);
  plate.moveCenter(frame.center());
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::Window));
  painter.drawRoundedRect(plate, 8.0, 8.0);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(plate, Qt::AlignCenter, m_text);
}

DropController::DropController(QWidget& window) : QObject(&window), m_hint(new DropHint(window)) {
  window.setAcceptDrops(true);
  window.installEventFilter(this);
}

bool DropController::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::DragLeave)
    m_hint->hide();
  if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
    return QObject::eventFilter(watched, event);
  auto& drop = static_cast<QDropEvent&>(*event); // a drag that enters is one, too
  const QStringList paths = filesIn(*drop.mimeData());
  if (paths.isEmpty())
    return false;
  drop.acceptProposedAction();
  if (event->type() == QEvent::DragEnter) {
    m_hint->showOver(paths.size() == 1 ? tr("Let go to open %1").arg(QFileInfo(paths.front()).fileName())
                                       : tr("Let go to open %1 files").arg(paths.size()));
  } else {
    m_hint->hide();
    tell(paths);
  }
  return true;
}

void DropController::tell(const QStringList& paths) {
  QStringList looks, others;
  for (const QString& path : paths)
    (holdsLooks(path) ? looks : others) << path;
  if (!looks.isEmpty())
    emit looksDropped(looks);
  if (!others.isEmpty())
    emit sourcesDropped(others);
}

Files::Files(WindowContext& context, FileSources sources)
    : QObject(&context.window), m_context(context), m_sources(std::move(sources)), m_pictures(context),
      m_saving(context, m_sources.session), m_slices(context), m_safety(context, m_sources.session),
      m_opening(context, [this] { return m_safety.savingOfNow(); }), m_remarks(context, m_opening),
      m_drops(context.window) {
  const QAction* close = context.actions.add(QStringLiteral("closeVolume"), {.text = tr("&Close volume"),
                                                                             .place = {Menu::file, 3, 1},
                                                                             .shortcut = QKeySequence::Close,
                                                                             .needsVolume = true});
  const std::function<FigureDialog&()> figures = offerExport<FigureDialog>(
      context, QStringLiteral("saveFigure"), FigureDialog::look(), m_sources.looks, &m_saving);
  connect(&m_remarks, &RemarksController::figureAsked, this,
          [this, figures](const QString& file) { figures().reopen(file, m_opening.optionsNow()); });
  offerExport<TurntableDialog>(context, QStringLiteral("saveTurntable"), TurntableDialog::look(), &m_saving);
  offerExport<SurfaceDialog>(context, QStringLiteral("exportSurface"), SurfaceDialog::look(),
                             m_sources.curve);
  offerExport<DicomDialog>(context, QStringLiteral("saveDicom"), DicomDialog::look());
  connect(close, &QAction::triggered, this, &Files::closeRequested);
  connect(&m_pictures, &PictureSaving::complete, &m_saving, &SavingController::writePicture);
  connect(&m_pictures, &PictureSaving::pathsWanted, this, &Files::savedPathsWanted);
  connect(&m_pictures, &PictureSaving::cancelled, &m_saving, &SavingController::cancelPicture);
  connect(&m_saving, &SavingController::drawing, &m_pictures, &PictureSaving::sayDrawing);
  connect(&m_safety, &SessionSafety::saveRequested, &m_saving, &SavingController::saveSession);
  connect(&m_safety, &SessionSafety::restoreRequested, &m_opening, &OpeningController::restore);
  connect(&m_saving, &SavingController::sessionSaved, &m_safety, &SessionSafety::noteChange);
  connect(&m_saving, &SavingController::sessionSaved, this, [this] {
    const OpenDocument& document = m_context.document;
    const QString& file = document.sessionFile();
    m_opening.remember(file, labelOf(document, file), document.volumePath());
  });
}

QStringList Files::underWay() const {
  QStringList underWay;
  if (const QString picture = m_pictures.underWay(); !picture.isEmpty())
    underWay << picture;
  for (const ExportDialog* dialog : m_context.window.findChildren<ExportDialog*>())
    if (dialog->isWorking())
      underWay << dialog->windowTitle() + QStringLiteral(": ") + dialog->said();
  return underWay;
}

bool Files::isBusy() const {
  return m_opening.loader().isLoading() || !underWay().isEmpty() || m_slices.isBusy() ||
         !m_saving.unwritten().isEmpty();
}

// Asked once, whatever would be lost.
bool Files::mayQuit() {
  const QStringList drawn = underWay();
  const QStringList unwritten = m_saving.unwritten();
  if (drawn.isEmpty() && unwritten.isEmpty())
    return true;
  QStringList lost;
  if (!drawn.isEmpty())
    lost << tr("A file is not finished yet. If Limn ends now, it will not be.");
  if (!unwritten.isEmpty())
    lost << tr("A drawn picture could not be written to its file. If Limn ends now, it is lost.");
  QMessageBox box(QMessageBox::Warning, drawn.isEmpty() ? tr("Not saved yet") : tr("Still drawing"),
                  lost.join(QLatin1Char(' ')), QMessageBox::NoButton, &m_context.window);
  box.setObjectName(QStringLiteral("stillDrawing"));
  box.setInformativeText((drawn + unwritten).join(QLatin1Char('\n')));
  QPushButton* stay =
      box.addButton(drawn.isEmpty() ? tr("Keep it") : tr("Let it finish"), QMessageBox::RejectRole);
  const QPushButton* quit = box.addButton(tr("End all the same"), QMessageBox::DestructiveRole);
  box.setDefaultButton(stay);
  box.exec();
  return box.clickedButton() == quit;
}

void Files::noteOpened(const LoadedScene& loaded, const Request& request) {
  const OpenDocument& document = m_context.document;
  m_remarks.show(loaded, request);
  if (request.isUnsavedSession) {
    m_safety.takeOver(request.source, !loaded.sparesSession());
  } else {
    m_context.document.settle(m_sources.session());
    m_safety.noteChange();
  }
  const SourceOptions& options = document.request().options;
  m_opening.remember(document.request().source, labelOf(document), document.volumePath(),
                     options.dicom ? options.read.series.value_or(0) : 0);
}

} // namespace limn
