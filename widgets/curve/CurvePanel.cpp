// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/CurvePanel.h"

#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/curve/TransferFunctionEditor.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace limn {
namespace {

QToolButton* makeButton(const QString& text, const QString& name, const QString& help) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setAccessibleName(name);
  button->setToolTip(help);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

} // namespace

CurvePanel::CurvePanel(QWidget* parent)
    : QStackedWidget(parent), m_value(new TransferFunctionEditor), m_gradient(new GradientOpacityEditor) {
  addWidget(m_value);
  addWidget(m_gradient);
  m_value->addLeading(makeSwitch(m_switches[0]));
  m_gradient->editor()->addLeading(makeSwitch(m_switches[1]), 0);
  setGradientState(GradientState::off);
  showGradient(false);
}

void CurvePanel::setVolumeOpen(bool isOpen) {
  m_value->setEditable(isOpen);
  for (const Switch& pair : m_switches)
    pair.value->parentWidget()->setEnabled(isOpen);
}

QWidget* CurvePanel::makeSwitch(Switch& made) {
  auto* row = new QWidget;
  row->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  made.name = new QLabel(tr("Opacity over"));
  made.name->setForegroundRole(QPalette::PlaceholderText);
  made.value = makeButton(tr("Value"), tr("Opacity over value"),
                          tr("<p>How opaque tissue is by its value: the transfer function.</p>"));
  made.gradient = makeButton(tr("Gradient"), tr("Opacity over gradient"), {});
  layout->addWidget(made.name);
  layout->addSpacing(4);
  layout->addWidget(made.value);
  layout->addWidget(made.gradient);
  connect(made.value, &QAbstractButton::clicked, this, [this] { showGradient(false); });
  connect(made.gradient, &QAbstractButton::clicked, this, [this] { showGradient(true); });
  return row;
}

void CurvePanel::showGradient(bool shown) {
  const bool changes = shown != gradientIsShown();
  const bool hadFocus = currentWidget()->isAncestorOf(QApplication::focusWidget());
  setCurrentIndex(shown ? 1 : 0);
  setFocusProxy(currentWidget());
  for (const Switch& pair : m_switches) {
    pair.value->setChecked(!shown);
    pair.gradient->setChecked(shown);
  }
  if (!changes)
    return;
  if (hadFocus) // the keyboard stays on the switch
    (shown ? m_switches[1].gradient : m_switches[0].value)->setFocus();
  emit gradientShown(shown);
}

void CurvePanel::resizeEvent(QResizeEvent* event) {
  for (const Switch& pair : m_switches)
    pair.name->setVisible(width() >= 840);
  QStackedWidget::resizeEvent(event);
}

void CurvePanel::setGradientState(GradientState state) {
  const QString help =
      tr("<p>How much of the opacity is left by how fast the value changes, so that boundaries stay.</p>");
  const QString unused = tr("<p>This projection does not add up opacities along its rays; tissue does.</p>");
  for (const Switch& pair : m_switches) {
    const bool isBesideItsTick = &pair == &m_switches[1]; // which says whether the curve is used
    pair.gradient->setText(state == GradientState::unused ? tr("Gradient: unused")
                           : isBesideItsTick              ? tr("Gradient")
                           : state == GradientState::off  ? tr("Gradient: off")
                                                          : tr("Gradient: on"));
    pair.gradient->setToolTip(state == GradientState::unused ? help + unused : help);
  }
}

} // namespace limn
