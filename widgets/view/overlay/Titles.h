// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/OverlayParts.h"
#include "widgets/view/overlay/ViewOrder.h"
#include "widgets/view/pictures/PictureState.h"

#include <QString>
#include <QStringList>
#include <QTimer>
#include <QVariantAnimation>

#include <optional>
#include <vector>

namespace limn {

/// What a side is called: its model, or the projection where that is not lit.
QString sideTitle(const Scene& scene);

/// What a side of a comparison is called: where looks are compared, which one, and its model.
QString sideTitle(const Comparison& comparison, int side);

/// The few numbers that matter for a side, the most important first: error and drawing time where they are
/// known, then how it is lit: "SP 32" or "SP 1–64 · O 0–3". Of projections that are not lit it says so.
QStringList sideDetails(const Scene& scene, const SideState& told);

/// A label and where it stands.
struct PlacedLabel {
  SideLabel label;
  QRectF plate;
  QRectF steadyPlate; ///< while its numbers show: what yields to a label must not jump when they fade
};

/// The labels of the pictures, by position.
std::vector<PlacedLabel> labelsOf(const OverlaySource& source);

/// What a picture of a difference is called, and what it means.
struct DifferenceTitle {
  PlacedLabel label;
  Note note;
};

/// Whether the label of the picture at a position leaves its middle free, whatever it tells: in wide pictures
/// that have one label. There a letter can stand beside it, at the picture's very edge.
bool leavesMiddleFree(const OverlaySource& source, int position);

/// In the middle, under the models' labels where it does not fit between them; absent in other layouts.
std::optional<DifferenceTitle> differenceTitleOf(const OverlaySource& source);

/// The position of the label under a point that leads to a menu; -1 for none.
int labelAt(const OverlaySource& source, const QPointF& point);

/// What a tool tip says at a point; empty for nothing.
QString toolTipAt(const OverlaySource& source, const QPointF& point);

/// What a region hides: "Body only: table hidden", "2 labels hidden or faded", "Cut by hand, 1 piece hidden";
/// empty where it hides nothing. Where it `namesLabels`, up to three of them by their names.
QString regionText(const Region& region, bool namesLabels = false);

/// What of the volume the pictures hide, in the words of their notes: "Body only: table hidden · Cropped";
/// empty where they hide nothing.
QString hiddenText(const Comparison& comparison);

/// Tells that a part of the volume is hidden, and by what.
struct HiddenNote {
  HiddenBy by;
  Note note;
};

/// Those under the label of the picture that stands at `position`, one below the other; a click on one takes
/// back what it tells. They are as wide under the pointer as without it.
std::vector<HiddenNote> hiddenNotesOf(const OverlaySource& source, int position = 0);

/// The one on which a point of the view, logical pixels, lies.
std::optional<HiddenPlace> hiddenNoteAt(const OverlaySource& source, const QPointF& point);

/// How strongly the numbers of the labels show: fully for a few seconds, then they fade. Where the picture
/// they tell of takes longer than that, the seconds count from when it is complete.
class LabelFade : public QObject {
  Q_OBJECT

public:
  explicit LabelFade(QObject* parent = nullptr);

  void wake();
  void noteState(const PictureState& state);
  double opacity() const { return m_fade.currentValue().toDouble(); } ///< 0..1

signals:
  void changed();

private:
  void show();

  bool m_awaitsPicture = false;
  QVariantAnimation m_fade;
  QTimer m_stay;
};

} // namespace limn
