// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/figure/FigureDialog.h"

#include "app/document/DocumentText.h"
#include "app/figures/FigureFiles.h"
#include "app/figures/FigureOptions.h"
#include "app/files/figure/FigurePreview.h"
#include "app/files/figure/FigureSources.h"
#include "app/files/saving/SavingController.h"
#include "io/AtomicFile.h"
#include "planes/GreyWindows.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/view/CompareView.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <map>
#include <vector>

namespace limn {
namespace {

constexpr int sideWidth = 450; // room for names of looks with their models, and on small screens

// The first picture of a preview has so many pixels each way as a share of the last, so that it comes at
// once.
constexpr double coarseShare = 0.3;
constexpr int restMs = 120;

// What a scene is drawn with that shall be as exact as a screen shows.
constexpr double exactLevels = 0.5;

// A panel but for what its picture does not show.
FigurePanel asDrawn(FigurePanel panel) {
  panel.name.clear();
  panel.errorLevels.reset();
  panel.paths.reset();
  panel.cropHidesNothing.reset();
  panel.isStated = panel.isAim = false;
  return panel;
}

bool showSamePictures(const Figure& a, const Figure& b) {
  return a.settings.page == b.settings.page && std::ranges::equal(a.panels, b.panels, {}, asDrawn, asDrawn);
}

MakingOptions withEffort(MakingOptions order, const Effort& effort) {
  order.effort = effort;
  return order;
}

QString withNotes(QString text, const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    text += QLatin1Char(' ') + QString::fromStdString(note);
  return text;
}

} // namespace

FigureDialog::FigureDialog(WindowContext& context, std::function<FigureLooks()> looks,
                           const SavingController* saving)
    : ExportDialog(context,
                   {QStringLiteral("figure"), tr("Making the figure"), tr("Cancelled; nothing was saved.")}),
      m_looks(std::move(looks)), m_saving(*saving), m_preview(new FigurePreview(this)),
      m_panels(new PanelList(this)), m_options(new FigureOptions(this)),
      m_exact(new QCheckBox(tr("As exact as a screen shows"), this)) {
  setWindowTitle(tr("Save a figure"));
  m_exact->setObjectName(QStringLiteral("figureExact"));
  m_exact->setToolTip(tr("Draws within half a level of 255 of the exact picture, which takes longer than the "
                         "window's own steps."));
  m_exact->setChecked(true);
  QWidget* side = makeSide();
  connect(this, &ExportDialog::workingChanged, side, &QWidget::setDisabled);
  auto* row = new QHBoxLayout;
  row->addWidget(m_preview, 1);
  row->addWidget(side);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  addButtons(column);
  m_options->setSettings(context.settings.figure());
  m_soon.setSingleShot(true);
  m_soon.setInterval(restMs);
  connectParts();
  resize(1146, 660);
}

ActionLook FigureDialog::look() {
  return {.text = tr("Save &figure…"),
          .place = {Menu::file, 2, 5},
          .shortcut = tr("Ctrl+Shift+F"),
          .toolTip =
              tr("Makes a figure to publish: pictures with names, scale, curve and notes, as PNG, TIFF, "
                 "EXR or PDF.")};
}

void FigureDialog::connectParts() {
  const auto refresh = [this] {
    m_outcome.clear();
    refreshPreview();
  };
  connect(m_panels, &PanelList::edited, this, refresh);
  connect(m_options, &FigureOptions::edited, this, refresh);
  connect(m_exact, &QCheckBox::clicked, this, refresh);
  connect(m_preview, &FigurePreview::resized, this, &FigureDialog::refreshPreview);
  connect(m_options, &FigureOptions::edited, this,
          [this](const FigureSettings& settings) { m_context.settings.setFigure(settings); });
  connect(&m_soon, &QTimer::timeout, this, &FigureDialog::refreshSources);
  connect(&m_reading, &BackgroundWork::failed, this, &FigureDialog::say);
  connect(&m_work, &BackgroundWork::progressed, this, [this](double fraction) {
    if (!isWorking() && !m_preview->awaiting().isEmpty())
      sayPreview(fraction);
  });
  connect(&m_work, &BackgroundWork::failed, m_preview, [this] { m_preview->setAwaiting({}); });
  connect(this, &ExportDialog::workingChanged, this, [this](bool isWorking) {
    m_preview->setAwaiting({});
    if (!isWorking && m_preview->pictures().empty()) // the work took the place of the preview's
      m_soon.start();
  });
  connect(&m_context.session, &Session::planesChanged, this, [this] { m_soon.start(); });
  connect(&m_context.session, &Session::viewsChanged, this, [this] { m_soon.start(); });
}

QWidget* FigureDialog::makeSide() {
  auto* side = new QWidget;
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(8, 12, 8, 4);
  column->setSpacing(12);
  column->addWidget(m_panels);
  column->addWidget(m_options);
  column->addWidget(m_exact);
  column->addStretch();
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus); // its fields have it
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(side);
  scroll->setFixedWidth(sideWidth);
  return scroll;
}

void FigureDialog::addButtons(QVBoxLayout* column) {
  auto* save = new QPushButton(tr("&Save…"), this);
  auto* copy = new QPushButton(tr("&Copy"), this);
  save->setObjectName(QStringLiteral("figureSave"));
  copy->setObjectName(QStringLiteral("figureCopy"));
  copy->setToolTip(tr("Copies the figure to the clipboard, in full size."));
  connect(save, &QPushButton::clicked, this, &FigureDialog::save);
  connect(copy, &QPushButton::clicked, this, &FigureDialog::copy);
  addFoot(column, save, copy);
}

void FigureDialog::begin(bool isNew) {
  if (!isNew)
    return;
  forget();
  m_outcome.clear();
  show(); // the preview is as large as it is seen
  refreshSources();
}

void FigureDialog::showScene(const Scene&) {
  m_soon.start();
}

// Closed, it keeps no volume.
void FigureDialog::done(int result) {
  ExportDialog::done(result);
  if (isVisible())
    return;
  m_work.cancel();
  m_reading.cancel();
  m_soon.stop();
  forget();
}

void FigureDialog::forget() {
  m_drawn = {};
  m_made.clear();
  m_estimated.clear();
  m_saved.clear();
  m_showsSaved = false;
  m_savedOf.reset();
  m_notes.clear();
  m_preview->setPictures({});
  m_preview->setFigure({});
  m_panels->setSources({});
}

void FigureDialog::reopen(const QString& file, const SourceOptions& options) {
  present();
  m_reading.start([this, file, options, shown = m_context.document.scene().volume](
                      const Effort& effort) -> BackgroundWork::Deliver {
    const std::optional<LoadedFigure> figure =
        loadFigure(file.toStdString(), options, {{}, effort.isCancelled});
    return [this, figure, shown] {
      if (!figure || m_context.document.scene().volume != shown)
        return;
      m_saved = sourcesOf(*figure);
      m_showsSaved = false;
      m_savedOf = shown;
      m_options->setSettings(figure->settings);
      refreshSources();
    };
  });
}

Figure FigureDialog::askedFigure() const {
  return {m_options->settings(), m_panels->panels()};
}

bool FigureDialog::isExact() const {
  return m_exact->isChecked();
}

void FigureDialog::setExact(bool isExact) {
  m_exact->setChecked(isExact);
}

void FigureDialog::refreshSources() {
  const Scene& scene = m_context.document.scene();
  m_isStale = isWorking();
  if (!isVisible() || m_isStale || !scene.volume)
    return;
  const Histogram& histogram = m_context.document.histogram();
  const FigureLooks looks = m_looks();
  const bool isComparing = m_context.view.compareLayout() != CompareLayout::single;
  // A file keeps the camera alone: its scale holds at the depth of the target.
  const auto turningThere = [&](auto seen) {
    seen.camera = withTargetAsDeepAs(seen.camera, m_context.view.turnsAbout());
    return seen;
  };
  const auto allTurningThere = [&](auto seen) {
    std::ranges::transform(seen, seen.begin(), turningThere);
    return seen;
  };
  const FigureIngredients from{turningThere(scene),
                               allTurningThere(m_context.view.scenesOfSides()),
                               isComparing ? looks.compared : std::nullopt,
                               looks.remembered,
                               m_context.session.planes(),
                               m_context.session.measurements(),
                               firstWindow(*scene.volume, histogram),
                               looks.presets,
                               allTurningThere(m_context.session.views()),
                               histogram,
                               looks.fitted};
  std::vector<PanelSource> sources = panelSources(from);
  const bool isFirst = m_drawn.panels.empty();
  std::vector<std::size_t> first;
  if (m_savedOf.lock() == scene.volume)
    for (const PanelSource& saved : m_saved) {
      first.push_back(sources.size());
      sources.push_back(saved);
    }
  m_panels->setSources(sources);
  if (!first.empty() && !std::exchange(m_showsSaved, true)) {
    m_panels->choose(first);
  } else if (isFirst && first.empty()) {
    m_panels->choose(firstPanels(sources, from));
    FigureSettings settings = m_options->settings();
    settings.panelAspect = m_context.view.pictureAspect();
    m_options->setSettings(settings);
  }
  refreshPreview();
}

// Marks at once, pictures as they come.
void FigureDialog::refreshPreview() {
  if (isWorking() || m_panels->panels().empty())
    return;
  m_preview->setFigure(withWhatIsKnown(askedFigure()));
  sayWhatItIs();
  const std::optional<Figure> shown = m_preview->asShown();
  if (!shown)
    return;
  const std::vector<QImage>& pictures = m_preview->pictures();
  const QSize size = figureLayout(*shown).pictureSize();
  const bool isDrawn =
      showSamePictures(*shown, m_drawn) && pictures.size() == shown->panels.size() &&
      std::ranges::all_of(pictures, [&](const QImage& picture) { return picture.size() == size; });
  if (isDrawn && !m_work.isRunning())
    return;
  drawPreview(showSamePictures(*shown, m_drawn) ? 1.0 : coarseShare);
}

void FigureDialog::drawPreview(double share) {
  const std::optional<Figure> shown = m_preview->asShown();
  if (!shown)
    return;
  const QSize size = (figureLayout(*shown).pictureSize() * share).expandedTo({8, 8});
  sayPreview(0.0);
  m_work.start([this, figure = *shown, share, size,
                order = m_context.drawnLikeTheView()](const Effort& effort) -> BackgroundWork::Deliver {
    const MadeFigure made = drawPanels(figure, size, withEffort(order, effort));
    return [this, figure, made, share] {
      m_drawn = figure;
      m_made = made.figure.panels;
      m_notes = made.notes;
      m_preview->setFigure(withWhatIsKnown(askedFigure()));
      m_preview->setPictures(made.pictures);
      m_preview->setAwaiting({});
      sayWhatItIs();
      share < 1.0 ? drawPreview(1.0) : estimatePreview(figure);
    };
  });
}

// The last that is found out; until then the figure says nothing of it.
void FigureDialog::estimatePreview(const Figure& figure) {
  const Figure known = withWhatIsKnown(figure);
  const auto isKnown = [](const FigurePanel& panel) {
    return panel.plane || panel.errorLevels || isPhysical(panel.scene);
  };
  if (!figure.settings.shows(FigureMark::accuracy) || std::ranges::all_of(known.panels, isKnown))
    return;
  m_work.start(
      [this, figure, order = m_context.drawnLikeTheView()](const Effort& effort) -> BackgroundWork::Deliver {
        const Figure estimated = withErrors(figure, withEffort(order, effort));
        return [this, estimated] {
          m_estimated = estimated.panels;
          m_preview->setFigure(withWhatIsKnown(askedFigure()));
        };
      });
}

Figure FigureDialog::withWhatIsKnown(Figure figure) const {
  for (FigurePanel& panel : figure.panels) {
    if (panel.plane)
      continue;
    const auto drawn = std::ranges::find_if(
        m_drawn.panels, [&](const FigurePanel& other) { return asDrawn(other) == asDrawn(panel); });
    const auto at = static_cast<std::size_t>(drawn - m_drawn.panels.begin());
    if (drawn != m_drawn.panels.end() && at < m_made.size()) {
      panel.cropHidesNothing = m_made[at].cropHidesNothing;
    }
    if (isPhysical(panel.scene))
      continue;
    const auto known = std::ranges::find_if(
        m_estimated, [&](const FigurePanel& other) { return asDrawn(other) == asDrawn(panel); });
    panel.isAim = isExact();
    if (panel.isAim)
      panel.errorLevels = exactLevels;
    else if (known != m_estimated.end())
      panel.errorLevels = known->errorLevels;
  }
  return figure;
}

void FigureDialog::sayWhatItIs() {
  const Figure figure = m_preview->figure();
  try {
    const FigureLayout layout = figureLayout(figure);
    const double cm = 2.54 / figure.settings.dotsPerInch;
    const bool isInPixels = figure.settings.unit == FigureSettings::Unit::pixels;
    m_options->setUsualHeight(layout.size.height() * (isInPixels ? 1.0 : cm));
    QString text = tr("%1 × %2 pixels, %3 × %4 cm; each picture %5 × %6.")
                       .arg(layout.size.width())
                       .arg(layout.size.height())
                       .arg(fixedNumber(cm * layout.size.width(), 1))
                       .arg(fixedNumber(cm * layout.size.height(), 1))
                       .arg(layout.pictureSize().width())
                       .arg(layout.pictureSize().height());
    if (const std::string memory = memoryNote(layout, FigurePixels::bytes); !memory.empty())
      text += QLatin1Char(' ') + QString::fromStdString(memory);
    if (!m_outcome.isEmpty())
      text.prepend(m_outcome + QLatin1Char('\n'));
    describe(withNotes(text, m_notes), hasMemoryFor(layout, FigurePixels::bytes));
  } catch (const Error& error) {
    describe(translated(error), false);
  }
}

// What is to be drawn in the end. Slices take no time.
Figure FigureDialog::wanted() {
  Figure all = askedFigure();
  setPictures(static_cast<std::size_t>(
      std::ranges::count_if(all.panels, [](const FigurePanel& panel) { return !panel.plane; })));
  if (isExact())
    for (FigurePanel& panel : all.panels)
      if (Quality& quality = panel.scene.quality; !quality.toleranceLevels) {
        quality.toleranceLevels = exactLevels;
        quality.fineness.reset();
        quality.ownWeights = false;
      }
  return all;
}

void FigureDialog::describe(const QString& text, bool canBeMade) {
  say(text);
  setStartable(canBeMade && !isWorking());
}

void FigureDialog::save() {
  const QString usual = suggestedName(m_context.document) + QStringLiteral("-figure.png");
  const std::string volumePath = m_context.document.volumePath();
  const Figure figure = wanted();
  std::map<std::string, std::string> names; // found here: the settings are no thread's beside this one
  for (const FigurePanel& panel : figure.panels)
    for (const std::string& labels : sourcesOf(panel.scene.keep))
      names[labels] = m_saving.labelsInPicture(labels);
  names[volumePath] = m_saving.volumeInPicture();
  const NameInFile named = [names](const std::string& name, const Volume&) { return names.at(name); };
  exportTo({.title = tr("Save the figure"),
            .suggested = usual,
            .filters = {tr("PNG picture (*.png)"), tr("PDF with text as text (*.pdf)"),
                        tr("TIFF picture (*.tif)"), tr("OpenEXR with floats (*.exr)")},
            .isPicture = true},
           [figure, named, volumePath, order = m_context.drawnLikeTheView()](const std::string& path,
                                                                             const Effort& effort) {
             const FigurePixels pixels = pixelsFor(figureFormatOf(path));
             requireWritable(path);
             const MadeFigure made = makeFigure(figure, withEffort(order, effort), pixels);
             const std::vector<std::string> volumes(made.figure.panels.size(), volumePath);
             writeFigure(path, made, figureDescription(made, volumes, named));
             return Outcome{withNotes(tr("Saved %1.").arg(QFileInfo(QString::fromStdString(path)).fileName()),
                                      made.notes)};
           });
}

void FigureDialog::copy() {
  run([figure = wanted(), order = m_context.drawnLikeTheView()](const Effort& effort) {
    const MadeFigure made = makeFigure(figure, withEffort(order, effort));
    const QImage image = imageOf(made);
    return Outcome{withNotes(tr("Copied %1 × %2 pixels.").arg(image.width()).arg(image.height()), made.notes),
                   [image] { QApplication::clipboard()->setImage(image); }};
  });
}

void FigureDialog::sayOutcome(const QString& sentence) {
  m_outcome = sentence;
  sayWhatItIs();
  if (m_isStale)
    m_soon.start();
}

QString FigureDialog::doing(double fraction) const {
  return tr("Drawing the figure: %1 %").arg(qRound(100.0 * fraction));
}

// On a slow machine the first picture takes long.
void FigureDialog::sayPreview(double fraction) {
  m_preview->setAwaiting(fraction > 0.0 ? tr("Drawing the preview: %1 %").arg(qRound(100.0 * fraction))
                                        : tr("Drawing the preview…"));
}

} // namespace limn
