// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneBar.h"

#include "planes/GreyWindows.h"
#include "scene/presets/PresetFit.h"
#include "widgets/ValueText.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/Popups.h"
#include "widgets/theme/Icons.h"
#include "widgets/theme/Theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr int fieldWidth = 64; // pixels
constexpr int betweenGroups = 12;
constexpr int betweenRows = 4;
constexpr QMargins around(6, 2, 6, 2);
constexpr double anyNumber = 1e9;
constexpr double widestTyped = 100.0; // of the range of the values

// Of PlaneTool.
constexpr std::array toolIcons{"crosshair", "tool-window-level", "tool-scissors", "tool-piece", "distance",
                               "angle",     "ellipse",           "mark"};

// Of a tool that measures: its name with its key, and what it does.
QString measureToolName(PlaneTool tool) {
  switch (tool) {
  case PlaneTool::angle:
    return PlaneBar::tr("Angle (G)");
  case PlaneTool::ellipse:
    return PlaneBar::tr("Ellipse (E)");
  case PlaneTool::mark:
    return PlaneBar::tr("Mark (N)");
  default:
    return PlaneBar::tr("Distance (D)");
  }
}

QString measureToolHelp(PlaneTool tool) {
  switch (tool) {
  case PlaneTool::angle:
    return PlaneBar::tr("Left drag: from one end to the corner; then a click sets the other end.");
  case PlaneTool::ellipse:
    return PlaneBar::tr("Left drag: mean, deviation and area of what lies in an ellipse.");
  case PlaneTool::mark:
    return PlaneBar::tr("Click: marks a place with a number; a double click in its list names it.");
  default:
    return PlaneBar::tr("Left drag: measures from one end to the other; Delete takes it away.");
  }
}

QHBoxLayout* rowIn(QWidget& group) {
  auto* row = new QHBoxLayout(&group);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  return row;
}

NumberField* makeField(double lowest, double highest, const QString& name, const QString& help) {
  auto* field = new NumberField(lowest, highest, 1);
  field->setFixedWidth(fieldWidth);
  field->setAccessibleName(name);
  field->setToolTip(help);
  return field;
}

void addLabelled(QHBoxLayout& row, const QString& text, QWidget* field) {
  auto* label = new QLabel(text);
  label->setForegroundRole(QPalette::PlaceholderText);
  label->setBuddy(field);
  row.addWidget(label);
  row.addWidget(field);
}

QString nameOfWindow(TissueWindow tissue) {
  switch (tissue) {
  case TissueWindow::softTissue:
    return PlaneBar::tr("Soft tissue");
  case TissueWindow::lung:
    return PlaneBar::tr("Lung");
  case TissueWindow::bone:
    return PlaneBar::tr("Bone");
  case TissueWindow::brain:
    return PlaneBar::tr("Brain");
  }
  return {};
}

} // namespace

PlaneBar::PlaneBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("planeBar"));
  m_groups = {makeToolGroup(), makeGreyGroup(), makeWindowsGroup(), makeSlabGroup(), makeLastGroup()};
  for (QWidget* group : m_groups)
    group->setParent(this);
  setTool(PlaneTool::crosshair);
  setEnabled(false); // there is no volume yet
  showIcons();
}

QWidget* PlaneBar::makeToolGroup() {
  auto* group = new QWidget;
  QHBoxLayout* row = rowIn(*group);
  const std::array names{tr("Crosshair (C)"), tr("Window/level (W)")};
  const std::array helps{
      tr("Left drag: the place that all slices and the mark in the picture show."),
      tr("Left drag: right widens the window, up raises its level. The right button always does.")};
  for (std::size_t i = 0; i < m_tools.size(); ++i) {
    auto* button = m_tools[i] = new QToolButton;
    button->setCheckable(true);
    button->setAccessibleName(names[i]);
    button->setToolTip(QStringLiteral("<p><b>%1</b></p><p>%2</p>").arg(names[i], helps[i]));
    connect(button, &QToolButton::clicked, this,
            [this, i] { emit toolRequested(static_cast<PlaneTool>(i)); });
    row->addWidget(button);
  }
  row->addWidget(makeMeasureButton());
  return group;
}

QWidget* PlaneBar::makeGreyGroup() {
  auto* group = new QWidget;
  QHBoxLayout* row = rowIn(*group);
  m_width = makeField(0.0, anyNumber, tr("Window width"), tr("How many values lie between black and white."));
  m_centre = makeField(-anyNumber, anyNumber, tr("Window level"),
                       tr("The value in the middle between black and white."));
  addLabelled(*row, tr("W"), m_width);
  addLabelled(*row, tr("L"), m_centre);
  connect(m_width, &NumberField::numberEdited, this, [this](double width) {
    edit([&](PlaneSettings& s) {
      s.window = withWidth(windowOf(m_content), m_content.volume->range(), width);
    });
  });
  connect(m_centre, &NumberField::numberEdited, this, [this](double centre) {
    edit([&](PlaneSettings& s) { s.window = GreyWindow{centre, windowOf(m_content).width}; });
  });
  return group;
}

QWidget* PlaneBar::makeWindowsGroup() {
  auto* group = new QWidget;
  m_windows = new QToolButton;
  m_windows->setText(tr("Window"));
  m_windows->setToolTip(tr("Grey windows to choose from."));
  m_windows->setPopupMode(QToolButton::InstantPopup);
  m_windows->setMenu(new QMenu(m_windows));
  looksIdleAfterMenu(*m_windows);
  rowIn(*group)->addWidget(m_windows);
  return group;
}

QToolButton* PlaneBar::makeMeasureButton() {
  m_measure = new QToolButton;
  m_measure->setObjectName(QStringLiteral("measureTool"));
  m_measure->setCheckable(true);
  m_measure->setPopupMode(QToolButton::MenuButtonPopup);
  auto* menu = new QMenu(m_measure);
  menu->setToolTipsVisible(true);
  for (const Measurement::Kind kind : measurementKinds) {
    QAction* action = menu->addAction(measureToolName(toolOf(kind)));
    action->setObjectName(QStringLiteral("plane-tool-") + QLatin1String(nameOf(kind)));
    action->setToolTip(measureToolHelp(toolOf(kind)));
    connect(action, &QAction::triggered, this, [this, kind] { emit toolRequested(toolOf(kind)); });
  }
  m_measure->setMenu(menu);
  looksIdleAfterMenu(*m_measure);
  connect(m_measure, &QToolButton::clicked, this, [this] { emit toolRequested(m_measureTool); });
  return m_measure;
}

QWidget* PlaneBar::makeSlabGroup() {
  auto* group = new QWidget;
  QHBoxLayout* row = rowIn(*group);
  m_thickness = makeField(0.0, thickestSlabMm, tr("Slab thickness in mm"),
                          tr("<p>How thick a slice is, mm: its pixels show the mean or the maximum over that "
                             "thickness. 0 is the plane itself.</p>"));
  m_thickness->setSuffix(tr(" mm"));
  addLabelled(*row, tr("Slab"), m_thickness);
  connect(m_thickness, &NumberField::numberEdited, this,
          [this](double mm) { edit([&](PlaneSettings& s) { s.slab.thicknessMm = mm; }); });
  m_mode = new QuietComboBox;
  m_mode->addItems({tr("Mean"), tr("Maximum")});
  m_mode->setAccessibleName(tr("Slab shows"));
  m_mode->setToolTip(tr("What a slab shows of the values across it."));
  connect(m_mode, &QComboBox::activated, this,
          [this](int mode) { edit([&](PlaneSettings& s) { s.slab.mode = static_cast<Slab::Mode>(mode); }); });
  row->addWidget(m_mode);
  return group;
}

QWidget* PlaneBar::makeLastGroup() {
  auto* group = new QWidget;
  QHBoxLayout* row = rowIn(*group);
  m_tint = new QToolButton;
  m_tint->setText(tr("Tint"));
  m_tint->setCheckable(true);
  m_tint->setToolTip(
      tr("<p>Colours slices by the transfer function, as strongly as a centimetre of that tissue is "
         "opaque.</p>"));
  connect(m_tint, &QToolButton::clicked, this,
          [this](bool on) { edit([&](PlaneSettings& s) { s.isTinted = on; }); });
  row->addWidget(m_tint);
  row->addWidget(makeMoreButton());
  return group;
}

QToolButton* PlaneBar::makeMoreButton() {
  auto* more = new QToolButton;
  more->setText(tr("More"));
  more->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(more);
  menu->setToolTipsVisible(true);
  more->setMenu(menu);
  looksIdleAfterMenu(*more);
  const auto addSwitch = [&](const char* name, const QString& text, const auto& change) {
    QAction* action = menu->addAction(text);
    action->setObjectName(QLatin1String(name));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this,
            [this, change](bool on) { edit([&](PlaneSettings& s) { change(s, on); }); });
    return action;
  };
  QAction* smooth =
      addSwitch("plane-interpolate", tr("Interpolate between voxels"), [](PlaneSettings& s, bool on) {
        s.interpolation = on ? PlaneInterpolation::linear : PlaneInterpolation::nearest;
      });
  QAction* outline = addSwitch("plane-outline", tr("Outline labels, kept region and crop box"),
                               [](PlaneSettings& s, bool on) { s.outlinesRegion = on; });
  outline->setToolTip(tr("Labels in their own colours, what is kept in orange, and the crop box in dashed "
                         "white."));
  menu->addSeparator();
  menu->addAction(tr("Crosshair to the middle"), this,
                  [this] { edit([](PlaneSettings& s) { s.crosshairMm.reset(); }); });
  QAction* removeAll = menu->addAction(tr("Remove all measurements"), this, [this] {
    emit measurementsEdited({{}, std::nullopt, {nextGestureId(), tr("remove all measurements")}});
  });
  connect(menu, &QMenu::aboutToShow, this, [this, smooth, outline, removeAll] {
    smooth->setChecked(m_content.settings.interpolation == PlaneInterpolation::linear);
    outline->setChecked(m_content.settings.outlinesRegion);
    removeAll->setEnabled(!m_content.measured.empty());
  });
  return more;
}

void PlaneBar::fillWindowMenu() {
  QMenu& menu = *m_windows->menu();
  menu.clear();
  const auto withNumbers = [](const QString& name, const GreyWindow& window, int decimals) {
    return tr("%1 (W %2 L %3)")
        .arg(name, valueText(window.width, {}, decimals), valueText(window.centre, {}, decimals));
  };
  const auto add = [&](const QString& text, const std::optional<GreyWindow>& window) {
    menu.addAction(text, this, [this, window] { edit([&](PlaneSettings& s) { s.window = window; }); });
  };
  if (looksLikeHounsfield(*m_content.volume))
    for (const TissueWindow tissue : tissueWindows) {
      const GreyWindow window = windowOf(tissue);
      add(withNumbers(nameOfWindow(tissue), window, 0), window);
    }
  else {
    // Values mean nothing by themselves: halves of what is seen at first show more of what differs little
    // there.
    const GreyWindow first = m_content.firstWindow;
    const int decimals = decimalsFor(first.width / 100.0);
    const GreyWindow dark = rounded({first.centre - 0.25 * first.width, 0.5 * first.width});
    const GreyWindow bright = rounded({first.centre + 0.25 * first.width, 0.5 * first.width});
    add(tr("As at first"), std::nullopt);
    add(withNumbers(tr("Dark tissue"), dark, decimals), dark);
    add(withNumbers(tr("Bright tissue"), bright, decimals), bright);
  }
  add(tr("Full range"), fullWindow(m_content.volume->range()));
}

void PlaneBar::setContent(const PlaneContent& content) {
  if (content == m_content)
    return; // or what somebody is typing would go
  const bool isOther = content.volume != m_content.volume || content.firstWindow != m_content.firstWindow;
  m_content = content;
  setEnabled(content.volume != nullptr);
  if (!content.volume)
    return;
  if (isOther)
    fillWindowMenu();
  const GreyWindow window = windowOf(content);
  // A window that is far wider than the values still has a centre among them.
  const ValueRange range = content.volume->range();
  const double span = range.highest > range.lowest ? range.highest - range.lowest : window.width;
  const int decimals = decimalsFor(std::min(window.width, span) / 500.0);
  // Beyond these slices would be all black, white or grey; a window that lies there already is shown.
  m_width->setLimits(std::pow(10.0, -decimals), std::max(widestTyped * span, window.width), decimals);
  m_centre->setLimits(std::min(range.lowest, window.centre), std::max(range.highest, window.centre),
                      decimals);
  m_width->setNumber(window.width);
  m_centre->setNumber(window.centre);
  m_thickness->setNumber(content.settings.slab.thicknessMm);
  m_mode->setCurrentIndex(static_cast<int>(content.settings.slab.mode));
  m_mode->setEnabled(content.settings.slab.thicknessMm > 0.0);
  m_tint->setChecked(content.settings.isTinted);
}

void PlaneBar::setTool(PlaneTool tool) {
  for (std::size_t i = 0; i < m_tools.size(); ++i)
    m_tools[i]->setChecked(i == static_cast<std::size_t>(tool));
  m_measure->setChecked(kindOf(tool).has_value());
  if (kindOf(tool))
    m_measureTool = tool;
  const QString name = measureToolName(m_measureTool);
  m_measure->setAccessibleName(name);
  m_measure->setToolTip(
      QStringLiteral("<p><b>%1</b></p><p>%2</p>").arg(name, measureToolHelp(m_measureTool)));
  showIcons();
}

// Before the last, which has what is left.
void PlaneBar::addButton(QAction& action) {
  auto* button = new QToolButton;
  button->setDefaultAction(&action);
  auto* row = static_cast<QHBoxLayout*>(m_groups.back()->layout());
  row->insertWidget(row->count() - 1, button);
}

void PlaneBar::edit(const std::function<void(PlaneSettings&)>& change) {
  PlaneSettings settings = m_content.settings;
  change(settings);
  emit settingsEdited(settings);
}

void PlaneBar::showIcons() {
  for (std::size_t i = 0; i < m_tools.size(); ++i)
    m_tools[i]->setIcon(themedIcon(QLatin1String(toolIcons[i]), palette()));
  const auto icon = [this](PlaneTool tool) {
    return themedIcon(QLatin1String(toolIcons[static_cast<std::size_t>(tool)]), palette());
  };
  m_measure->setIcon(icon(m_measureTool));
  const QList<QAction*> entries = m_measure->menu()->actions();
  for (const Measurement::Kind kind : measurementKinds)
    entries[static_cast<qsizetype>(kind)]->setIcon(icon(toolOf(kind)));
}

void PlaneBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange)
    showIcons();
}

std::vector<QRect> PlaneBar::placesAt(int width) const {
  std::vector<QRect> places;
  int height = 0;
  for (const QWidget* group : m_groups)
    height = std::max(height, group->sizeHint().height());
  QPoint next(around.left(), around.top());
  for (const QWidget* group : m_groups) {
    const int wide = group->sizeHint().width();
    if (!places.empty() && next.x() + wide > width - around.right())
      next = {around.left(), next.y() + height + betweenRows};
    places.emplace_back(next, QSize(wide, height));
    next.rx() += wide + betweenGroups;
  }
  return places;
}

int PlaneBar::heightAt(int width) const {
  return placesAt(width).back().bottom() + 1 + around.bottom();
}

void PlaneBar::arrange() {
  const std::vector<QRect> places = placesAt(width());
  for (std::size_t i = 0; i < m_groups.size(); ++i)
    m_groups[i]->setGeometry(places[i]);
}

bool PlaneBar::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) // a group became wider
    arrange();
  return QWidget::event(event);
}

void PlaneBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void PlaneBar::paintEvent(QPaintEvent*) {
  QPainter(this).fillRect(rect(), themeColors(palette()).window);
}

} // namespace limn
