// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/CutBar.h"

#include "widgets/ValueText.h"

#include <QActionGroup>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>

namespace limn {
namespace {

// An eyeball has a radius of 12 mm, an ear reaches 30 mm from its middle.
constexpr int reachesMm[] = {5, 10, 15, 20, 30, 50, 80};

// Two buttons of which one is down.
void pair(QPushButton* first, QPushButton* second, QObject* parent) {
  auto* group = new QButtonGroup(parent);
  for (QPushButton* button : {first, second}) {
    button->setCheckable(true);
    group->addButton(button);
  }
}

} // namespace

CutBar::CutBar(QWidget* parent)
    : HintBar(tr("Cutting"), parent), m_inside(panelButton(tr("Inside"), QStringLiteral("choice"), this)),
      m_outside(panelButton(tr("Outside"), QStringLiteral("choice"), this)),
      m_through(panelButton(tr("Through all"), QStringLiteral("choice"), this)),
      m_seen(panelButton(tr("What is seen"), QStringLiteral("choice"), this)),
      m_less(panelButton(tr("Less"), QStringLiteral("choice"), this)), m_reach(new QActionGroup(this)),
      m_hide(panelButton(tr("Hide"), QStringLiteral("choice"), this)),
      m_alone(panelButton(tr("Only this"), QStringLiteral("choice"), this)),
      m_look(panelButton(tr("Its own curve"), QStringLiteral("choice"), this)) {
  pair(m_inside, m_outside, this);
  pair(m_through, m_seen, this);
  m_inside->setToolTip(tr("Takes away what the line goes around."));
  m_outside->setToolTip(tr("Takes away all that the line does not go around."));
  m_through->setToolTip(tr("Cuts through the whole volume."));
  m_seen->setToolTip(
      tr("Cuts only as deep as what is seen inside the line, and leaves what shows far behind through "
         "small gaps; in a slice, as deep as its slab, at least one slice."));
  m_hide->setToolTip(tr("Hides this piece."));
  m_alone->setToolTip(tr("Hides all but this piece."));
  m_look->setToolTip(tr("Gives this piece a curve of its own, which the curve panel then shows."));
  group(0)->addWidget(m_inside);
  group(0)->addWidget(m_outside);
  group(0)->addSpacing(6);
  makeMenuOfLess();
  for (QPushButton* button : {m_through, m_seen, m_less, m_hide, m_alone})
    group(1)->addWidget(button);
  group(2)->insertWidget(0, m_look);
  group(2)->insertSpacing(1, 6);
  connect(m_inside, &QPushButton::toggled, this, &CutBar::insideChosen);
  connect(m_seen, &QPushButton::toggled, this, &CutBar::depthChosen);
  connect(m_hide, &QPushButton::clicked, this, &CutBar::hideRequested);
  connect(m_alone, &QPushButton::clicked, this, &CutBar::aloneRequested);
  connect(m_look, &QPushButton::clicked, this, &CutBar::lookRequested);
}

void CutBar::showScissors(bool removesInside, bool onlySeen) {
  (removesInside ? m_inside : m_outside)->setChecked(true);
  (onlySeen ? m_seen : m_through)->setChecked(true);
  showButtons(true, false);
  showHint(tr("Draw around it, or click corners"),
           tr("Shift draws straight on; Enter, a double click or the first corner closes a line of "
              "corners, Backspace takes the last one back, Esc all."),
           false);
}

void CutBar::showPiece(const QString& text, bool isPicked) {
  showButtons(false, isPicked);
  showHint(text,
           tr("The wheel widens or narrows the range of values, with Shift its upper end alone; the value at "
              "the place that you clicked stays within it. Another click picks another piece, Esc none."),
           isPicked);
}

// An eyeball lies in muscle and fat, an ear hangs together with all of the skin: values alone tell neither.
void CutBar::makeMenuOfLess() {
  m_less->setToolTip(tr("Takes less of what hangs together: similar values, or what lies near."));
  auto* menu = new QMenu(m_less);
  QAction* similar = menu->addAction(tr("Values like those around the place"));
  connect(similar, &QAction::triggered, this, &CutBar::similarRequested);
  menu->addSeparator();
  const auto addReach = [&](const QString& text, const QVariant& mm) {
    QAction* reach = m_reach->addAction(menu->addAction(text));
    reach->setCheckable(true);
    reach->setData(mm);
  };
  addReach(tr("However far it reaches"), {});
  for (const int mm : reachesMm)
    addReach(tr("Within %1 of the place").arg(valueText(mm, tr("mm"), 0)), mm);
  forgetReach();
  connect(m_reach, &QActionGroup::triggered, this, &CutBar::reachChosen);
  m_less->setMenu(menu);
}

std::optional<double> CutBar::reachMm() const {
  const QVariant mm = m_reach->checkedAction()->data();
  return mm.isValid() ? std::optional(mm.toDouble()) : std::nullopt;
}

void CutBar::forgetReach() {
  m_reach->actions().front()->setChecked(true);
}

void CutBar::showButtons(bool ofScissors, bool ofPieces) {
  for (QPushButton* button : {m_inside, m_outside, m_through, m_seen})
    button->setVisible(ofScissors);
  for (QPushButton* button : {m_less, m_hide, m_alone, m_look})
    button->setVisible(ofPieces);
}

} // namespace limn
