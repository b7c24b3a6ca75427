// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QList>
#include <QStackedWidget>

#include <array>
#include <cstddef>
#include <optional>

class QComboBox;
class QLabel;
class QToolButton;

namespace limn {

class GradientOpacityEditor;
class TransferFunctionEditor;

/// The two curves of opacity, over the value and over the gradient, one at a time; a switch beside their
/// numbers chooses.
class CurvePanel : public QStackedWidget {
  Q_OBJECT

public:
  explicit CurvePanel(QWidget* parent = nullptr);

  TransferFunctionEditor* valueEditor() const { return m_value; }
  GradientOpacityEditor* gradientEditor() const { return m_gradient; }

  /// Whether there is a volume; without one nothing here can be changed.
  void setVolumeOpen(bool isOpen);

  void showGradient(bool shown);
  bool gradientIsShown() const { return currentIndex() == 1; }

  /// What the switch says of the curve over the gradient.
  enum class GradientState {
    off,
    on,
    unused ///< set, but of no account in this picture
  };
  void setGradientState(GradientState state);

  /// A label that has a curve of its own.
  struct LabelCurve {
    std::size_t place = 0; ///< in the list of labels
    QString name;
    QColor color;
    bool operator==(const LabelCurve&) const = default;
  };
  /// Whose curve over the value can be chosen beside the one for all tissue, and whose is in hand; none: that
  /// one.
  void setLabelCurves(const QList<LabelCurve>& curves, std::optional<std::size_t> inHand);

protected:
  void resizeEvent(QResizeEvent* event) override;

signals:
  /// The curve over the gradient came into view or left it.
  void gradientShown(bool shown);
  /// The curve of a label was taken in hand; none: the one for all tissue.
  void curveChosen(std::optional<std::size_t> place);

private:
  /// The two buttons, one pair on each page.
  struct Switch {
    QLabel* name;
    QToolButton* value;
    QToolButton* gradient;
  };
  QWidget* makeSwitch(Switch& made);

  TransferFunctionEditor* m_value;
  GradientOpacityEditor* m_gradient;
  QComboBox* m_whose;
  QList<LabelCurve> m_labelCurves;
  std::array<Switch, 2> m_switches;
};

} // namespace limn
