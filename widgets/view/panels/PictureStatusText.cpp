// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/PictureStatusText.h"

#include "scene/steps/RayFrame.h"
#include "widgets/Translated.h"
#include "widgets/ValueText.h"

#include <QLocale>
#include <QObject>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// As few digits as give the number back exactly.
QString exactNumber(double value) {
  return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

// "1/4", "5/16", "0.3": fractions of powers of two, which are exact.
QString fractionText(double value) {
  for (double denominator = 2.0; denominator <= 1024.0 && value < 1.0; denominator *= 2.0)
    for (const double numerator : {1.0, 3.0, 5.0})
      if (value * denominator == numerator)
        return QStringLiteral("%1/%2").arg(numerator).arg(denominator);
  return QLocale().toString(value, 'g', QLocale::FloatingPointShortest);
}

// The side that lies farthest from its exact picture.
const SideState& worstOf(const PictureState& state) {
  return *std::ranges::max_element(state.sides, [](const auto& a, const auto& b) {
    return levelsOf(a).value_or(0.0) < levelsOf(b).value_or(0.0);
  });
}

bool isKnown(const PictureState& state) {
  return std::ranges::all_of(state.sides, [](const SideState& side) { return levelsOf(side).has_value(); });
}

bool isLightMeasured(const PictureState& state) {
  return std::ranges::all_of(state.sides, [](const SideState& side) {
    return side.isLightMeasured || side.measuredLevels || side.chance;
  });
}

bool isResolved(const PictureState& state) {
  return std::ranges::all_of(state.sides, [](const SideState& side) {
    return side.isResolved || side.measuredLevels || side.chance;
  });
}

// Pixels were drawn to see how far the picture lies off; an estimate alone goes by how it changes with the
// step.
bool isChecked(const PictureState& state) {
  return std::ranges::all_of(
      state.sides, [](const SideState& side) { return side.paths || side.measuredLevels || side.chance; });
}

bool hasPaths(const PictureState& state) {
  return std::ranges::any_of(state.sides, [](const SideState& side) { return side.paths.has_value(); });
}

QString pathCount(int paths) {
  return paths == 1 ? QObject::tr("1 path") : QObject::tr("%1 paths").arg(paths);
}

// Of physical light, whose error is that of chance.
QString pathsText(const PathFigures& paths) {
  if (!paths.rmsLevels)
    return QObject::tr("%1, estimating…").arg(pathCount(paths.paths));
  return QObject::tr("within %1 levels RMS after %2")
      .arg(levelsText(*paths.rmsLevels), pathCount(paths.paths));
}

QString worstText(const SideState& worst) {
  if (worst.paths)
    return pathsText(*worst.paths);
  if (worst.chance)
    return QObject::tr("99.9 % of pixels within %1 of 255 levels (95 % sure)")
        .arg(promisedLevels(worst.chance->levels));
  if (worst.measuredLevels)
    return QObject::tr("within %1 of 255 levels, measured in a smaller picture")
        .arg(promisedLevels(*worst.measuredLevels));
  return (worst.isRough ? QObject::tr("estimated within about %1 of 255 levels")
                        : QObject::tr("estimated within %1 of 255 levels"))
      .arg(levelsText(worst.estimate->p99_9));
}

// Where one of two pictures was measured it is told whose number this is.
QString estimateText(const PictureState& state) {
  if (!isResolved(state))
    return QObject::tr("not resolved");
  if (!isLightMeasured(state))
    return QObject::tr("shadows not measured");
  for (const SideState& side : state.sides)
    if (side.paths && !side.paths->rmsLevels)
      return pathsText(*side.paths);
  if (!isKnown(state))
    return QObject::tr("estimating…");
  const SideState& worst = worstOf(state);
  QString text = worstText(worst);
  if (state.sides.size() < 2 || std::ranges::none_of(state.sides, tellsMeasured))
    return text;
  return (&worst == &state.sides.front() ? QObject::tr("left %1") : QObject::tr("right %1")).arg(text);
}

// Of the side whose values may lie farthest off.
std::optional<Coarseness> coarsenessOf(const PictureState& state) {
  std::optional<Coarseness> worst;
  for (const SideState& side : state.sides)
    if (side.coarseness && (!worst || side.coarseness->largestError > worst->largestError))
      worst = side.coarseness;
  return worst;
}

// A bound: rounded up.
QString coarsenessText(const Coarseness& coarseness) {
  return QObject::tr(
             "The volume does not lie in memory: while something moves the picture is drawn from 1/%1 of "
             "the voxels along each axis, whose values differ by at most %2 % of the range; at rest from "
             "all of them.")
      .arg(coarseness.reduction)
      .arg(fixedNumber(std::ceil(1000.0 * coarseness.largestError) / 10.0, 1));
}

// A hundredth of white: what an eye just tells apart of two fields that touch (Weber's law).
constexpr double nearlyExactLevels = 2.55;

// The same of single pixels among others that are accurate; details as fine as they need more contrast to be
// seen than fields do.
constexpr double singleLevels = 2.0 * nearlyExactLevels;

// By the law a picture is accurate to the screen by the 99.9th percentile of its colour values; of the pixels
// that were drawn it is known, too, beside what they say of all others.
bool areAccurate(const PictureState& state) {
  return std::ranges::all_of(
      state.sides, [](const SideState& side) { return side.chance && side.chance->p99_9 <= screenLevels; });
}

QString badgeText(const PictureState& state) {
  if (const std::optional<Coarseness> coarseness = coarsenessOf(state))
    return QObject::tr("○ preview, voxels %1× coarser").arg(coarseness->reduction);
  if (!state.resting)
    return QObject::tr("○ preview");
  const bool isWithin = isResolved(state) && isLightMeasured(state) && isKnown(state) &&
                        *levelsOf(worstOf(state)) <= screenLevels;
  if (isWithin && isChecked(state))
    return QObject::tr("● exact to the screen");
  if (state.refines)
    return QObject::tr("◐ refining");
  const bool isNear =
      !isKnown(state) || *levelsOf(worstOf(state)) <= (areAccurate(state) ? singleLevels : nearlyExactLevels);
  // No step would make it exact, or nothing but an estimate says that it is.
  if (isResolved(state) && isNear && (isWithin || state.refinementEnd == RefinementEnd::withinHalfALevel))
    return QObject::tr("○ nearly exact");
  return isResolved(state) ? QObject::tr("○ not exact") : QObject::tr("○ not resolved");
}

// The step of a preview is in the tool tip: what strikes is its resolution.
QString previewText(const SideState& side) {
  if (side.coarseness)
    return QObject::tr("preview from 1/%1 of the voxels along each axis").arg(side.coarseness->reduction);
  if (side.imageScale >= 1.0)
    return QObject::tr("preview, step %1").arg(stepText(side.stepVoxels));
  return QObject::tr("preview at %1 resolution").arg(fractionText(side.imageScale));
}

struct EndText {
  QString step; ///< %1: the step
  QString sentence;
};

EndText textOf(RefinementEnd end) {
  switch (end) {
  case RefinementEnd::withinHalfALevel:
    return {QObject::tr("refined, step %1"),
            QObject::tr(
                "The steps are meant to cost half a level at most: smaller ones would show no difference.")};
  case RefinementEnd::smallestStep:
    return {QObject::tr("smallest step, %1"),
            QObject::tr("No smaller step is drawn: it would take long and show little.")};
  case RefinementEnd::sampleLimit:
    return {QObject::tr("smallest possible step, %1"),
            QObject::tr("With a smaller step rays would need more samples than the driver allows.")};
  case RefinementEnd::patience:
    return {QObject::tr("smallest practical step, %1"),
            QObject::tr("The next smaller step would take too long on this machine.")};
  case RefinementEnd::gridOfLight:
    return {QObject::tr("step %1, light approximate"),
            QObject::tr("Shadows and occlusion come from few paths or a grid of light, which smaller steps "
                        "do not make finer; with a tolerance the processor follows more paths, which takes "
                        "some minutes.")};
  case RefinementEnd::failed:
    return {QObject::tr("step %1, not refined"), QObject::tr("Refining the picture failed.")};
  }
  return {};
}

// What was drawn says that the steps did not do what they are meant for.
bool isFartherOff(const PictureState& state) {
  return std::ranges::any_of(
      state.sides, [](const SideState& side) { return side.chance && side.chance->levels > screenLevels; });
}

EndText endText(const PictureState& state) {
  if (state.refinementEnd == RefinementEnd::withinHalfALevel && isFartherOff(state))
    return {textOf(*state.refinementEnd).step,
            QObject::tr("Single pixels lie farther off than the steps are meant for; \"Show where it is not "
                        "exact\" in the accuracy panel shows where.")};
  if (state.refinementEnd)
    return textOf(*state.refinementEnd);
  if (state.refines)
    return {QObject::tr("step %1, refining"),
            QObject::tr("The picture is being drawn again with smaller steps.")};
  if (state.resting && !hasPaths(state))
    return {QObject::tr("step %1"),
            QObject::tr("It stays as it is while \"Sharpen while nothing moves\" is off in the settings, "
                        "and while accuracy is measured.")};
  return {QObject::tr("step %1"), {}};
}

// Under a tolerance there is no one step to tell.
QString restingText(const PictureState& state) {
  const SideState& side = state.sides.front();
  if (side.paths)
    return state.refines ? QObject::tr("random paths, refining") : QObject::tr("random paths");
  return endText(state).step.arg(side.toleranceLevels ? QObject::tr("chosen by error")
                                                      : stepText(side.stepVoxels));
}

QString measuredText(double levels) {
  return QObject::tr("999 of 1000 colour values of a smaller picture of the same scene were measured to lie "
                     "within %1 levels of the exact one; black and white are 255 levels apart.")
      .arg(promisedLevels(levels));
}

QString chanceText(const ErrorByChance& chance) {
  return translated(describe(chance)) + QLatin1Char(' ') +
         QObject::tr("Of the colour values of the pixels that were drawn 999 of 1000 lie within %1 levels of "
                     "the exact picture.")
             .arg(promisedLevels(chance.p99_9)) +
         QLatin1Char(' ');
}

QString explanationOf(const PictureState& state) {
  if (!isResolved(state))
    return QObject::tr("Not resolved: a band of the curve is narrower than what the value changes by within "
                       "one step, so the picture may miss it and no number would be right. Pre-integrated "
                       "steps, or smaller ones, see it.");
  if (!isLightMeasured(state))
    return QObject::tr("OpenGL looks shadows and occlusion up on a grid and cannot say what that is off by. "
                       "Pictures that are "
                       "sharpened while nothing moves the processor draws once more, and says it.");
  if (!isKnown(state))
    return QObject::tr("How far the picture lies from the exact one is being estimated.");
  if (const std::optional<PathFigures>& paths = worstOf(state).paths; paths && paths->rmsLevels)
    return QObject::tr(
               "Light follows random paths through tissue, and what they differ by tells how far the "
               "picture lies from the exact one: %1 of 255 levels on average (RMS), 999 of 1000 colour "
               "values within %2. Four times as many paths halve it.")
        .arg(levelsText(*paths->rmsLevels), levelsText(*paths->p99_9Levels));
  const std::optional<double> measured = worstOf(state).measuredLevels;
  if (const std::optional<ErrorByChance>& chance = worstOf(state).chance)
    return chanceText(*chance) +
           (measured ? measuredText(*measured) : QObject::tr("Black and white are 255 levels apart."));
  if (measured)
    return measuredText(*measured);
  QString text = QObject::tr("999 of 1000 colour values of the picture are estimated to lie within %1 levels "
                             "of the exact picture; black and white are 255 levels apart.")
                     .arg(levelsText(worstOf(state).estimate->p99_9));
  if (worstOf(state).isRough)
    text += QLatin1Char(' ') + QObject::tr("Estimated from a smaller picture.");
  if (state.sides.front().imageScale < 1.0)
    text += QLatin1Char(' ') +
            QObject::tr("The preview also has fewer pixels than the window; that comes on top.");
  return text;
}

// The accuracy panel tells the right one's.
QString worseText(const PictureState& state) {
  const bool areTold = isResolved(state) && isLightMeasured(state) && isKnown(state);
  if (state.sides.size() < 2 || !areTold || levelsOf(state.sides[0]) == levelsOf(state.sides[1]))
    return {};
  return &worstOf(state) == &state.sides.front()
             ? QObject::tr("This is the left picture; the right one lies closer to its exact one.")
             : QObject::tr("This is the right picture; the left one lies closer to its exact one.");
}

QString numbersText(const PictureState& state, const Scene& scene) {
  const SideState& side = state.sides.front();
  QStringList parts;
  if (side.paths) {
    parts << QObject::tr("%1 of each pixel").arg(pathCount(side.paths->paths));
  } else if (side.toleranceLevels) {
    parts << QObject::tr("steps chosen by error, meant for %1 of 255 levels")
                 .arg(exactNumber(*side.toleranceLevels));
  } else if (scene.volume) {
    const double mm = side.stepVoxels * smallestSpacingMm(scene.volume->grid());
    parts << QObject::tr("step %1 of the smallest voxel spacing, %2 mm")
                 .arg(fractionText(side.stepVoxels))
                 .arg(digitsNumber(mm, 3));
  }
  // Of one picture one error is told.
  const bool isEstimated = isResolved(state) && isKnown(state) && worstOf(state).estimate &&
                           !worstOf(state).paths && !worstOf(state).measuredLevels && !worstOf(state).chance;
  if (isEstimated) {
    const ErrorEstimate& estimate = *worstOf(state).estimate;
    const QString errors = QObject::tr("99.9th percentile %1, mean %2 levels")
                               .arg(digitsNumber(estimate.p99_9, 3))
                               .arg(digitsNumber(estimate.mean, 2));
    // Only halvings show an order.
    parts << (side.toleranceLevels
                  ? errors
                  : QObject::tr("%1, observed order %2").arg(errors).arg(fixedNumber(estimate.order, 2)));
  }
  parts << state.renderer << state.engineReason;
  parts.removeAll(QString());
  return parts.join(QLatin1Char('\n'));
}

// What is known of the light of a side, which would say little to most over the picture itself.
QString lightText(const SideState& side) {
  QStringList parts;
  if (side.contrast)
    parts << QObject::tr("contrast %1 (RMS)").arg(fixedNumber(*side.contrast, 3));
  if (side.overflow)
    parts << QObject::tr("%1 % of the pixels brighter than white and cut off")
                 .arg(fixedNumber(100.0 * side.overflow->share, 1));
  return parts.join(QStringLiteral(", "));
}

QString lightTexts(const PictureState& state) {
  QStringList lines;
  for (std::size_t side = 0; side < state.sides.size() && state.resting; ++side)
    if (const QString text = lightText(state.sides[side]); !text.isEmpty())
      lines << (state.sides.size() == 1 ? QObject::tr("Light: %1.")
                : side == 0             ? QObject::tr("Light at the left: %1.")
                                        : QObject::tr("Light at the right: %1."))
                   .arg(text);
  return lines.join(QLatin1Char('\n'));
}

QString engineText(const PictureState& state) {
  return drawsWithOpenGl(state.engine) ? QObject::tr("OpenGL") : QObject::tr("processor");
}

} // namespace

QString timeText(double ms) {
  if (ms < 1000.0)
    return QObject::tr("%1 ms").arg(fixedNumber(ms, ms < 9.95 ? 1 : 0));
  return QObject::tr("%1 s").arg(fixedNumber(ms / 1000.0, 1));
}

QString stepText(double stepVoxels) {
  return (stepVoxels > 1.0 ? QObject::tr("%1 voxels") : QObject::tr("%1 voxel"))
      .arg(fractionText(stepVoxels));
}

QString levelsText(double levels) {
  return fixedNumber(std::clamp(levels, 0.1, 255.0), levels < 9.95 ? 1 : 0);
}

QString PictureStatusText::line() const {
  QStringList parts{estimate, step, time, engine};
  parts.removeAll(QString());
  return parts.join(QStringLiteral(" · "));
}

PictureStatusText pictureStatusText(const PictureState& told, const Scene& scene) {
  if (told.sides.empty())
    return {};
  PictureState state = told;
  for (SideState& side : state.sides)
    side = asShown(side);
  PictureStatusText text;
  text.badge = badgeText(state);
  text.estimate = estimateText(state);
  text.step = state.resting ? restingText(state) : previewText(state.sides.front());
  double ms = 0.0;
  for (const SideState& side : state.sides)
    ms += side.shownMs;
  text.time = timeText(ms);
  text.engine = engineText(state);
  // Those sentences are about steps.
  const QString end = hasPaths(state) ? QString() : endText(state).sentence;
  QStringList lines{explanationOf(state), worseText(state), end, numbersText(state, scene),
                    lightTexts(state)};
  if (const std::optional<Coarseness> coarseness = coarsenessOf(state))
    lines.prepend(coarsenessText(*coarseness));
  lines.removeAll(QString());
  text.toolTip = lines.join(QLatin1Char('\n'));
  return text;
}

std::vector<PictureStatusText> commonStatusTexts() {
  PictureState state;
  state.sides.resize(1);
  SideState& side = state.sides.front();
  side.estimate = ErrorEstimate{188.0, 0.0, 1.0};
  side.stepVoxels = 1.0 / 64.0;
  side.imageScale = 3.0 / 16.0;
  side.shownMs = 888.0;
  const PictureStatusText preview = pictureStatusText(state, {});
  state.resting = state.refines = true;
  side.shownMs = 88800.0;
  const PictureStatusText refining = pictureStatusText(state, {});
  side.estimate = ErrorEstimate{screenLevels, 0.0, 1.0};
  const PictureStatusText exact = pictureStatusText(state, {});
  side.chance = ErrorByChance{0.88, 0.0, 0.88, chancePixels};
  return {preview, refining, exact, pictureStatusText(state, {})};
}

} // namespace limn
