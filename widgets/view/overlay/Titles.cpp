// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/Titles.h"

#include "scene/regions/BodyAndLabels.h"
#include "widgets/ValueText.h"
#include "widgets/properties/ProjectionSection.h"
#include "widgets/shading/ModelSection.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/panels/PictureStatusText.h"

#include <QObject>

#include <algorithm>
#include <utility>

namespace limn {
namespace {

QString number(double value) {
  return digitsNumber(value, 4);
}

QString rangeText(const CoefficientRange& range) {
  return QStringLiteral("%1–%2").arg(number(range.atFlat), number(range.atBoundary));
}

QString modelText(const Shading& shading) {
  switch (shading.model) {
  case ShadingModel::none:
    return {};
  case ShadingModel::classic:
    return QObject::tr("SP %1").arg(number(shading.exponent));
  case ShadingModel::enhanced:
  case ShadingModel::robust:
    return QObject::tr("SP %1 · O %2").arg(rangeText(shading.exponentRange), rangeText(shading.opacityRange));
  case ShadingModel::physical:
    return shading.physical.density == 1.0 ? QString()
                                           : QObject::tr("density %1").arg(number(shading.physical.density));
  }
  return {};
}

QString lightingText(const Shading& shading) {
  const QString model = modelText(shading);
  return model.isEmpty() || !(shading.gradientSmoothing > 0.0)
             ? model
             : QObject::tr("%1 · normals smoothed by %2 mm")
                   .arg(model, digitsNumber(shading.gradientSmoothing, 3));
}

// Without the numbers of the last picture at rest, which is not the one that is seen.
SideState whileMoving(SideState state) {
  state.completeMs.reset();
  return state;
}

SideLabel labelOf(const OverlaySource& source, int position) {
  const int side = sideShownAt(source.comparison, position);
  const Scene scene = sceneOfSide(source.comparison, side);
  const bool isDrawn = side < static_cast<int>(source.state.sides.size());
  SideLabel label;
  label.title = sideTitle(source.comparison, side);
  label.leadsToMenu = usesLight(scene.projection);
  const SideState state = isDrawn ? source.state.sides[static_cast<std::size_t>(side)] : SideState{};
  label.details = sideDetails(scene, source.state.resting ? state : whileMoving(state));
  label.hovered = position == source.hovered.label;
  label.detailsOpacity = label.hovered ? 1.0 : source.labelOpacity;
  return label;
}

// Where two labels over one picture part: at the border of the wipe, unless that leaves one of them no room.
double partingOf(const OverlaySource& source, const QRectF& picture) {
  constexpr double least = 160.0;
  const bool isWipe = source.geometry.layout == CompareLayout::wipe;
  return isWipe && picture.width() > 2 * least
             ? std::clamp(wipeX(source.geometry), picture.left() + least, picture.right() - least)
             : picture.center().x();
}

// How far a label goes that leaves room for a letter in the middle.
double besideMiddle(const OverlaySource& source, const QRectF& picture) {
  return picture.center().x() - letterSize(source.font).width() / 2;
}

QRectF plateOf(const OverlaySource& source, int position, const SideLabel& label) {
  QRectF side = pictureRect(source.geometry, position);
  const CompareLayout layout = source.geometry.layout;
  const bool isShared = layout == CompareLayout::wipe || layout == CompareLayout::difference;
  if (isShared) { // two labels share one picture: each has its part
    const double parting = partingOf(source, side);
    position == 0 ? side.setRight(parting) : side.setLeft(parting);
  } else if (leavesMiddleFree(source, position)) {
    side.setRight(besideMiddle(source, side));
  }
  return labelPlate(source.font, label, side, isShared && position == 1 ? Qt::AlignRight : Qt::AlignLeft);
}

// What lines cut away and what pieces hide are told apart; empty where nothing is taken away.
QString cutText(const Region& region) {
  if (!isCutAway(region))
    return {};
  int lines = 0, hidden = 0, alone = 0;
  for (const Cut& cut : region.cuts) {
    if (!takesAway(cut))
      continue;
    const auto* piece = std::get_if<ConnectedPiece>(&cut.how);
    ++(!piece ? lines : piece->fate == ConnectedPiece::Fate::hidden ? hidden : alone);
  }
  QStringList parts;
  if (lines > 0)
    parts << QObject::tr("cut by hand");
  if (hidden > 0)
    parts << (hidden == 1 ? QObject::tr("1 piece hidden") : QObject::tr("%1 pieces hidden").arg(hidden));
  if (alone > 0)
    parts << QObject::tr("only one piece");
  return parts.join(QStringLiteral(", "));
}

// Whether a click brings back only what was cut away: who wants that keeps hidden what else is.
bool bringsCutsBack(const Region& region) {
  return isCutAway(region) && isRestricting(withoutCuts(region));
}

// What it tells, and what a click on it does.
struct HiddenWords {
  HiddenBy by;
  QString atRest;
  QString underPointer;
};

std::vector<HiddenWords> hiddenWords(const Comparison& comparison) {
  const Scene& scene = comparison.scene;
  std::vector<HiddenWords> words;
  if (const QString region = regionText(scene.keep); !region.isEmpty())
    words.push_back({HiddenBy::region, region,
                     bringsCutsBack(scene.keep) ? QObject::tr("Show what was cut away")
                                                : QObject::tr("Show everything")});
  if (scene.crop != CropBox{} && !comparison.cropHidesNothing)
    words.push_back({HiddenBy::crop, QObject::tr("Cropped"), QObject::tr("Reset crop")});
  return words;
}

constexpr int stayMs = 4000; // after the pointer rests
constexpr int fadeMs = 400;

} // namespace

bool leavesMiddleFree(const OverlaySource& source, int position) {
  constexpr double least = 320.0; // for title, error and time of every model, logical pixels
  const CompareLayout layout = source.geometry.layout;
  const QRectF picture = pictureRect(source.geometry, position);
  return layout != CompareLayout::wipe && layout != CompareLayout::difference &&
         besideMiddle(source, picture) - picture.left() - 2 * overlayMargin >= least;
}

QString sideTitle(const Scene& scene) {
  return usesLight(scene.projection) ? modelName(scene.shading.model) : projectionName(scene.projection);
}

QString sideTitle(const Comparison& comparison, int side) {
  QString title = sideTitle(sceneOfSide(comparison, side));
  if (!comparison.look || comparison.layout == CompareLayout::single)
    return title;
  const std::string& name = comparison.look->names[static_cast<std::size_t>(side)];
  return QStringLiteral("%1 · %2").arg(QString::fromStdString(name), title);
}

QStringList sideDetails(const Scene& scene, const SideState& told) {
  const SideState state = asShown(told);
  QStringList parts;
  if (state.chance || state.measuredLevels)
    parts << QObject::tr("within %1 levels").arg(promisedLevels(*levelsOf(state)));
  else if (state.estimate && !state.isRough && state.isResolved)
    parts << QObject::tr("within %1 levels").arg(levelsText(state.estimate->p99_9));
  if (state.completeMs)
    parts << timeText(*state.completeMs);
  const QString lighting = usesLight(scene.projection) ? lightingText(scene.shading)
                                                       : QObject::tr("unlit, the same with every model");
  if (!lighting.isEmpty())
    parts << lighting;
  return parts;
}

std::vector<PlacedLabel> labelsOf(const OverlaySource& source) {
  std::vector<PlacedLabel> labels;
  for (int position = 0; position < pictureCount(source.geometry.layout); ++position) {
    const SideLabel label = labelOf(source, position);
    SideLabel steady = label;
    steady.detailsOpacity = 1.0;
    labels.push_back({label, plateOf(source, position, label), plateOf(source, position, steady)});
  }
  return labels;
}

std::optional<DifferenceTitle> differenceTitleOf(const OverlaySource& source) {
  if (source.geometry.layout != CompareLayout::difference)
    return std::nullopt;
  const std::vector<PlacedLabel> labels = labelsOf(source);
  std::vector<QRectF> plates{labels[0].steadyPlate, labels[1].steadyPlate};
  for (const HiddenNote& hidden : hiddenNotesOf(source, 0))
    plates.push_back(hidden.note.plate);
  DifferenceTitle title;
  title.label.label.title = QObject::tr("%2 minus %1, ×%3")
                                .arg(sideTitle(source.comparison, 0), sideTitle(source.comparison, 1))
                                .arg(differenceGain);
  title.label.label.leadsToMenu = false;
  QRectF plate = labelPlate(source.font, title.label.label, source.view(), Qt::AlignHCenter);
  plate.moveTop(clearRowBelow(plate.top(), plate.size(), {plate.center().x()}, plates));
  title.label.plate = title.label.steadyPlate = plate;
  title.note =
      noteAt(source.font, QObject::tr("Black where both are equal, brighter the more they differ"),
             {plate.center().x(), 0.0}, Qt::AlignHCenter, source.geometry.size.width() - 2 * overlayMargin);
  title.note.plate.moveTop(clearRowBelow(plate.bottom() + overlayMargin / 3, title.note.plate.size(),
                                         {plate.center().x()}, plates));
  return title;
}

int labelAt(const OverlaySource& source, const QPointF& point) {
  const std::vector<PlacedLabel> labels = labelsOf(source);
  for (std::size_t position = 0; position < labels.size(); ++position)
    if (labels[position].label.leadsToMenu && labels[position].plate.contains(point))
      return static_cast<int>(position);
  return -1;
}

// Only over titles, notes, scale and cube: a tool tip anywhere else would cover the picture.
QString toolTipAt(const OverlaySource& source, const QPointF& point) {
  if (source.hovered.hidden && source.hovered.hidden->by == HiddenBy::region &&
      bringsCutsBack(source.comparison.scene.keep))
    return QObject::tr("A click shows what was cut away again; a second one shows everything.");
  if (source.hovered.hidden)
    return source.hovered.hidden->by == HiddenBy::crop
               ? QObject::tr(
                     "The crop box cuts a part of the volume off. A click shows all of it again; B shows "
                     "the box.")
               : QObject::tr(
                     "A part of the volume is hidden. A click shows everything again; View ▸ Body only "
                     "hides the table and what else lies beside the body.");
  if (const std::optional<std::size_t> face = cubeFaceAt(source, point))
    return cubeFaces(source.volume())[cubeFaceLedTo(source, *face)].meaning;
  if (source.comparison.scene.camera.projection == Camera::Projection::perspective)
    if (const std::optional<ScaleMark> scale = scaleMarkOf(source); scale && scale->plate.contains(point))
      return QObject::tr("<p>What lies nearer looks larger: the length holds at the depth of the turning "
                         "point (pivot). View ▸ "
                         "Orthographic has one scale everywhere.</p>");
  for (const PlacedLabel& one : labelsOf(source))
    if (one.plate.contains(point) && fittingTitle(source.font, one.label, one.plate) != one.label.title)
      return QStringLiteral("<p>%1</p>").arg(one.label.title.toHtmlEscaped());
  const std::optional<DifferenceTitle> title = differenceTitleOf(source);
  if (!title || !(title->label.plate.contains(point) || title->note.plate.contains(point)))
    return {};
  return QObject::
      tr("<p>Black where both sides show the same; blue where the left side is brighter, orange where the "
         "right side is, by the part of the colour that differs most. Differences are shown %1 times as "
         "large as they are.</p>")
          .arg(differenceGain);
}

// "liver, spleen, left kidney and 4 more"
static QString namesOfWeighed(const Region& region, std::size_t count) {
  constexpr qsizetype most = 3;
  QStringList names;
  for (std::size_t place = 0; place < count; ++place)
    if (region.weights[place] != 1.0) {
      const Label& label = region.labels->labels()[place];
      names << (label.name.empty() ? QString::number(label.value) : QString::fromStdString(label.name));
    }
  const QString first = names.mid(0, most).join(QObject::tr(", "));
  return names.size() <= most ? first
                              : QObject::tr("%1 and %2 more", "names").arg(first).arg(names.size() - most);
}

QString regionText(const Region& region, bool namesLabels) {
  if (!isRestricting(region))
    return {};
  const QString cut = cutText(region);
  if (!cut.isEmpty() && region.kind == Region::Kind::body)
    return QObject::tr("Only the body, %1", "what was cut").arg(cut);
  QStringList notes;
  const auto own = region.weights.begin() + static_cast<std::ptrdiff_t>(listedLabels(region));
  const auto weighed =
      std::count_if(region.weights.begin(), own, [](double weight) { return weight != 1.0; });
  if (hidesTable(region))
    notes << QObject::tr("Body only: table hidden");
  if (region.kind == Region::Kind::labels && weighed > 0) {
    const QString what = weighed == 1 ? QObject::tr("1 label hidden or faded")
                                      : QObject::tr("%1 labels hidden or faded").arg(weighed);
    notes << (namesLabels
                  ? QObject::tr("%1: %2", "labels hidden, their names")
                        .arg(what,
                             namesOfWeighed(region, static_cast<std::size_t>(own - region.weights.begin())))
                  : what);
  }
  if (!cut.isEmpty())
    notes << cut.left(1).toUpper() + cut.mid(1);
  return notes.join(QStringLiteral(" · "));
}

QString hiddenText(const Comparison& comparison) {
  QStringList texts;
  for (const HiddenWords& words : hiddenWords(comparison))
    texts << words.atRest;
  return texts.join(QStringLiteral(" · "));
}

std::vector<HiddenNote> hiddenNotesOf(const OverlaySource& source, int position) {
  if (source.geometry.size.height() < leastHeightForNotes)
    return {};
  QRectF above = labelsOf(source)[static_cast<std::size_t>(position)].steadyPlate;
  const double room = pictureRect(source.geometry, position).width() - 2 * overlayMargin;
  const auto noteWith = [&](const QString& words) {
    return noteAt(source.font, words, {above.left(), 0.0}, Qt::AlignLeft, room);
  };
  std::vector<HiddenNote> notes;
  for (const HiddenWords& words : hiddenWords(source.comparison)) {
    const Note atRest = noteWith(words.atRest);
    const Note underPointer = noteWith(words.underPointer);
    Note note = source.hovered.hidden == HiddenPlace{position, words.by} ? underPointer : atRest;
    note.plate.setWidth(std::max(atRest.plate.width(), underPointer.plate.width()));
    note.plate.moveTop(above.bottom() + overlayMargin / 2);
    above = note.plate;
    notes.push_back({words.by, note});
  }
  return notes;
}

std::optional<HiddenPlace> hiddenNoteAt(const OverlaySource& source, const QPointF& point) {
  for (int position = 0; position < standingCount(source.geometry); ++position)
    for (const HiddenNote& hidden : hiddenNotesOf(source, position))
      if (hidden.note.plate.contains(point))
        return HiddenPlace{position, hidden.by};
  return std::nullopt;
}

LabelFade::LabelFade(QObject* parent) : QObject(parent) {
  m_fade.setDuration(fadeMs);
  m_fade.setStartValue(1.0);
  m_fade.setEndValue(0.0);
  connect(&m_fade, &QVariantAnimation::valueChanged, this, &LabelFade::changed);
  m_stay.setSingleShot(true);
  m_stay.setInterval(stayMs);
  connect(&m_stay, &QTimer::timeout, this, [this] { m_fade.start(); });
}

void LabelFade::wake() {
  m_awaitsPicture = true;
  show();
}

void LabelFade::noteState(const PictureState& state) {
  const bool isComplete = !state.sides.empty() && std::ranges::all_of(state.sides, [](const SideState& side) {
    return side.completeMs.has_value();
  });
  if (isComplete && std::exchange(m_awaitsPicture, false))
    show();
}

void LabelFade::show() {
  const bool wasFading =
      m_fade.state() == QAbstractAnimation::Running || m_fade.currentTime() == m_fade.totalDuration();
  m_fade.stop();
  m_fade.setCurrentTime(0);
  m_stay.start();
  if (wasFading)
    emit changed();
}

} // namespace limn
