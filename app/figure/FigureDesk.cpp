// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/figure/FigureDesk.h"

#include "app/Settings.h"
#include "app/document/DocumentText.h"
#include "app/document/OpenDocument.h"
#include "app/figure/FigureDialog.h"
#include "app/figure/FigureFiles.h"
#include "app/figure/FigureOptions.h"
#include "app/figure/FigurePreview.h"
#include "app/figure/PanelSources.h"
#include "app/presets/PresetDesk.h"
#include "app/saving/SaveDialog.h"
#include "app/saving/SaveNotes.h"
#include "app/saving/SavingDesk.h"
#include "app/window/picture/ComparisonDesk.h"
#include "app/window/picture/EngineDesk.h"
#include "planes/GreyWindows.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"
#include "widgets/view/CompareView.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

namespace limn {
namespace {

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

FigureDesk::FigureDesk(const Parts& parts) : QObject(&parts.window), m_parts(parts) {
  m_soon.setSingleShot(true);
  m_soon.setInterval(restMs);
  connect(&m_soon, &QTimer::timeout, this, &FigureDesk::refreshSources);
  connect(&parts.saveFigure, &QAction::triggered, this, &FigureDesk::show);
  connect(&parts.session, &Session::sceneChanged, this, [this] { m_soon.start(); });
  connect(&parts.session, &Session::planesChanged, this, [this] { m_soon.start(); });
  connect(&m_work, &BackgroundWork::progressed, this, [this](double fraction) {
    if (m_dialog && m_dialog->isWorking())
      m_dialog->showProgress(fraction);
  });
  connect(&m_work, &BackgroundWork::failed, this, &FigureDesk::endWork);
}

void FigureDesk::show() {
  if (!m_parts.document.scene().volume)
    return;
  if (!m_dialog) {
    m_dialog = new FigureDialog(&m_parts.window);
    m_dialog->options().setSettings(m_parts.settings.figure());
    connect(m_dialog, &FigureDialog::edited, this, [this] {
      m_outcome.clear();
      refreshPreview();
    });
    connect(m_dialog, &FigureDialog::previewResized, this, &FigureDesk::refreshPreview);
    connect(m_dialog, &FigureDialog::saveRequested, this, &FigureDesk::save);
    connect(m_dialog, &FigureDialog::copyRequested, this, &FigureDesk::copy);
    connect(m_dialog, &FigureDialog::cancelled, this, [this] {
      m_work.cancel();
      endWork(tr("Cancelled; nothing was saved."));
    });
    connect(&m_dialog->options(), &FigureOptions::edited, this,
            [this](const FigureSettings& settings) { m_parts.settings.setFigure(settings); });
    connect(m_dialog, &QDialog::finished, this, [this] { m_work.cancel(); });
  }
  const bool isNew = !m_dialog->isVisible();
  m_dialog->show();
  m_dialog->raise();
  m_dialog->activateWindow();
  if (!isNew)
    return;
  m_drawn = {};
  m_outcome.clear();
  m_dialog->preview().setPictures({});
  refreshSources();
}

void FigureDesk::refreshSources() {
  const Scene& scene = m_parts.document.scene();
  m_isStale = m_dialog && m_dialog->isWorking();
  if (!m_dialog || !m_dialog->isVisible() || m_isStale)
    return;
  if (!scene.volume) {
    m_dialog->close();
    return;
  }
  const Histogram& histogram = m_parts.document.histogram();
  const bool isComparing = m_parts.view.compareLayout() != CompareLayout::single;
  const FigureIngredients from{scene,
                               m_parts.view.scenesOfSides(),
                               isComparing ? m_parts.comparison.comparedLook() : std::nullopt,
                               m_parts.comparison.remembered(),
                               m_parts.session.planes(),
                               firstWindow(*scene.volume, histogram),
                               m_parts.presets.fittedPresets(),
                               histogram};
  const std::vector<PanelSource> sources = panelSources(from);
  const bool isFirst = m_drawn.panels.empty();
  m_dialog->panelList().setSources(sources);
  if (isFirst) {
    m_dialog->panelList().choose(firstPanels(sources, from));
    FigureSettings settings = m_dialog->options().settings();
    settings.panelAspect = m_parts.view.pictureAspect();
    m_dialog->options().setSettings(settings);
  }
  refreshPreview();
}

// Marks at once, pictures as they come.
void FigureDesk::refreshPreview() {
  if (!m_dialog || m_dialog->isWorking())
    return;
  m_dialog->preview().setFigure(withKnownErrors(m_dialog->figure()));
  sayWhatItIs();
  const std::optional<Figure> shown = m_dialog->preview().asShown();
  if (!shown)
    return;
  const std::vector<QImage>& pictures = m_dialog->preview().pictures();
  const QSize size = figureLayout(*shown).pictureSize();
  const bool isDrawn =
      showSamePictures(*shown, m_drawn) && pictures.size() == shown->panels.size() &&
      std::ranges::all_of(pictures, [&](const QImage& picture) { return picture.size() == size; });
  if (isDrawn && !m_work.isRunning())
    return;
  drawPreview(showSamePictures(*shown, m_drawn) ? 1.0 : coarseShare);
}

void FigureDesk::drawPreview(double share) {
  const std::optional<Figure> shown = m_dialog->preview().asShown();
  if (!shown)
    return;
  const QSize size = (figureLayout(*shown).pictureSize() * share).expandedTo({8, 8});
  m_work.start([this, figure = *shown, share, size,
                order = drawnLike(m_parts.view)](const Effort& effort) -> BackgroundWork::Deliver {
    const MadeFigure made = drawPanels(figure, size, withEffort(order, effort));
    return [this, figure, made, share] {
      m_drawn = figure;
      m_notes = made.notes;
      m_dialog->preview().setPictures(made.pictures);
      sayWhatItIs();
      share < 1.0 ? drawPreview(1.0) : estimatePreview(figure);
    };
  });
}

// The last that is found out; until then the figure says nothing of it.
void FigureDesk::estimatePreview(const Figure& figure) {
  const Figure known = withKnownErrors(figure);
  const auto isKnown = [](const FigurePanel& panel) { return panel.plane || panel.errorLevels; };
  if (!figure.settings.shows(FigureMark::accuracy) || std::ranges::all_of(known.panels, isKnown))
    return;
  m_work.start(
      [this, figure, order = drawnLike(m_parts.view)](const Effort& effort) -> BackgroundWork::Deliver {
        const Figure estimated = withErrors(figure, withEffort(order, effort));
        return [this, estimated] {
          m_estimated = estimated.panels;
          m_dialog->preview().setFigure(withKnownErrors(m_dialog->figure()));
        };
      });
}

Figure FigureDesk::withKnownErrors(Figure figure) const {
  for (FigurePanel& panel : figure.panels) {
    if (panel.plane)
      continue;
    const auto known = std::ranges::find_if(
        m_estimated, [&](const FigurePanel& other) { return asDrawn(other) == asDrawn(panel); });
    if (m_dialog->isExact())
      panel.errorLevels = exactLevels;
    else if (known != m_estimated.end())
      panel.errorLevels = known->errorLevels;
  }
  return figure;
}

void FigureDesk::sayWhatItIs() {
  const Figure figure = m_dialog->preview().figure();
  try {
    const FigureLayout layout = figureLayout(figure);
    const double cm = 2.54 / figure.settings.dotsPerInch;
    const bool isInPixels = figure.settings.unit == FigureSettings::Unit::pixels;
    m_dialog->options().setUsualHeight(layout.size.height() * (isInPixels ? 1.0 : cm));
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
    m_dialog->describe(withNotes(text, m_notes), hasMemoryFor(layout, FigurePixels::bytes));
  } catch (const Error& error) {
    m_dialog->describe(translated(error), false);
  }
}

// What is to be drawn in the end.
Figure FigureDesk::wanted() const {
  Figure figure = m_dialog->figure();
  if (m_dialog->isExact())
    for (FigurePanel& panel : figure.panels)
      if (Quality& quality = panel.scene.quality; !quality.toleranceLevels) {
        quality.toleranceLevels = exactLevels;
        quality.fineness.reset();
      }
  return figure;
}

void FigureDesk::make(FigurePixels pixels,
                      const std::function<BackgroundWork::Deliver(const MadeFigure&)>& finish) {
  const Figure figure = wanted();
  m_dialog->showProgress(0.0);
  m_work.start([figure, pixels, finish, order = drawnLike(m_parts.view)](const Effort& effort) {
    constexpr double estimating = 0.15; // of the whole, in time
    const Figure estimated = withErrors(figure, withEffort(order, partOf(effort, 0.0, estimating)));
    return finish(makeFigure(estimated, withEffort(order, partOf(effort, estimating, 1.0)), pixels));
  });
}

void FigureDesk::save() {
  const QString path = askWhereToSave(m_dialog,
                                      {tr("Save the figure"),
                                       suggestedName(m_parts.document) + QStringLiteral("-figure.png"),
                                       {tr("PNG picture (*.png)"), tr("PDF with text as text (*.pdf)"),
                                        tr("TIFF picture (*.tif)"), tr("OpenEXR with floats (*.exr)")},
                                       QStandardPaths::writableLocation(QStandardPaths::PicturesLocation)},
                                      m_parts.settings);
  if (path.isEmpty())
    return;
  const std::filesystem::path file(path.toStdString());
  FigurePixels pixels = FigurePixels::bytes;
  try {
    pixels = pixelsFor(figureFormatOf(file));
  } catch (const Error& error) {
    return m_dialog->describe(translated(error), true);
  }
  const std::string volumePath = m_parts.document.volumePath();
  const NameInFile named =
      [volumePath, volume = m_parts.saving.volumeInPicture(), labels = m_parts.saving.labelsInPicture()](
          const std::string& name, const Volume&) { return name == volumePath ? volume : labels; };
  make(pixels, [this, file, path, named, volumePath](const MadeFigure& made) -> BackgroundWork::Deliver {
    const std::vector<std::string> volumes(made.figure.panels.size(), volumePath);
    writeFigure(file, made, figureDescription(made.figure, volumes, named));
    return [this, path, notes = made.notes] {
      endWork(withNotes(tr("Saved %1.").arg(QFileInfo(path).fileName()), notes));
      m_parts.notes.attempt([] {}, path);
    };
  });
}

void FigureDesk::copy() {
  make(FigurePixels::bytes, [this](const MadeFigure& made) -> BackgroundWork::Deliver {
    return [this, image = imageOf(made), notes = made.notes] {
      QApplication::clipboard()->setImage(image);
      endWork(withNotes(tr("Copied %1 × %2 pixels.").arg(image.width()).arg(image.height()), notes));
    };
  });
}

void FigureDesk::endWork(const QString& sentence) {
  if (!m_dialog)
    return;
  m_outcome = sentence;
  m_dialog->endProgress(sentence);
  sayWhatItIs();
  if (m_isStale)
    m_soon.start();
}

} // namespace limn
