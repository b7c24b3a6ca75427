// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/volume/Histogram.h"
#include "scene/volume/Volume.h"
#include "widgets/Gesture.h"
#include "widgets/curve/SpringSlider.h"
#include "widgets/curve/picture/CanvasPicture.h"
#include "widgets/curve/picture/CurveEdits.h"

#include <QWidget>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

class QAbstractButton;
class QBoxLayout;
class QFrame;
class QLabel;
class QToolButton;

namespace limn {

class PointFields;
class TransferFunctionCanvas;

/// The tissue of a value that was pinned in the picture, and two buttons that show less or more of it.
class TissueButtons : public QWidget {
  Q_OBJECT

public:
  explicit TissueButtons(QWidget* parent = nullptr);

  /// `unit` "HU" names the tissue; `range` is the volume's, `decimals` what values are told with.
  void setValue(double value, const QString& unit, const ValueRange& range, int decimals);

  void setTransferFunction(const TransferFunction& function) { m_function = function; }

signals:
  /// The whole function, with more or less opacity around the value.
  void functionEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);

private:
  QToolButton* button(const QString& text, const QString& toolTip, double (*change)(double));

  TransferFunction m_function;
  double m_value = 0.0;
  QString m_unit;
  ValueRange m_range;
  QString m_text; ///< of the value
  QLabel* m_label;
};

/// Shows a transfer function over the volume's histogram and asks for edits: the plot with its mouse and key
/// gestures, the numbers of the selected point, and sliders that raise or shift the whole curve, which a
/// button has where they find no room. It owns no undo: every edit goes out with its gesture, and
/// setTransferFunction brings back what became of it. Esc during a drag sends the function from before under
/// the same gesture.
class TransferFunctionEditor : public QWidget {
  Q_OBJECT

public:
  explicit TransferFunctionEditor(CurveSubject subject = CurveSubject::value, QWidget* parent = nullptr);

  /// Puts a control before the numbers of the selected point, after the others there or at a place of theirs.
  void addLeading(QWidget* control, int place = -1);

  /// Puts a control before the one that shows all values.
  void addTrailing(QWidget* control);

  /// Whether the curve can be edited; it can unless said otherwise. The histogram shows in any case.
  void setEditable(bool editable);

  void setTransferFunction(const TransferFunction& function);

  /// Drawn behind the curve. Its range is the volume's, and the plot shows all of it when it
  /// changes; a histogram without counts stands for no volume.
  void setHistogram(const Histogram& histogram);

  /// Shown after values. "HU" also names tissues.
  void setUnit(const QString& unit);

  /// Marks the value under the pointer in the picture.
  void setMark(const std::optional<ValueMark>& mark);

  /// Marks a value until another is pinned or its mark is removed from the plot's menu, and offers less or
  /// more of its tissue until a point is selected.
  void setPinnedValue(std::optional<double> value);

  TransferFunctionCanvas* canvas() const { return m_canvas; }

signals:
  void transferFunctionEdited(const limn::TransferFunction& function, const limn::Gesture& gesture);
  /// The value under the pointer in the plot.
  void valueHovered(std::optional<double> value);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  QWidget* makeControlRow();
  void connectCanvas();
  void connectSliders();
  void showSelection();
  void showPinOrPoints();
  void openDetails(std::size_t index);
  const TransferFunction& pullBase(std::uint64_t gestureId);
  void pull(const SpringSlider& slider, const TransferFunction& function, const Gesture& gesture);
  void forgetPulls();
  double shiftOf(double position) const;
  int typedDecimals() const;
  void openMore();
  void takeBackMore();
  std::array<QWidget*, 3> toolsInOrder() const; ///< of the row
  void placeTools();
  int toolsWithRoom() const;
  void showIcons();

  ValueRange m_range{0.0, 1.0}; // before the sliders, whose first read-out needs it
  TransferFunctionCanvas* m_canvas;
  PointFields* m_fields;
  TissueButtons* m_tissue; ///< in the place of the fields when a value was pinned last
  bool m_pinIsLatest = false;
  bool m_isEditable = true;
  SpringSlider* m_opacity;
  SpringSlider* m_shift;
  QBoxLayout* m_row = nullptr;
  int m_leading = 0;                 ///< controls before the numbers
  int m_trailing = 0;                ///< controls before the last one
  std::array<QWidget*, 3> m_tools{}; ///< in the row as long as there is room, the first longest
  QAbstractButton* m_fine;
  QAbstractButton* m_showAll;
  QToolButton* m_more;           ///< has the tools that find no room
  QFrame* m_morePanel = nullptr; ///< in which they stand while it is open
  TransferFunction m_pullBase;
  TransferFunction m_pulled; ///< what the last pull made of it
  std::uint64_t m_pullId = 0;
};

} // namespace limn
