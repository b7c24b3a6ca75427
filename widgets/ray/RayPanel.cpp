// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ray/RayPanel.h"

#include "widgets/plot/Axes.h"

#include <QKeyEvent>
#include <QLabel>
#include <QObject>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

// What a chart of a ray shows: three lanes above each other over one axis of depth.
struct ProfilePicture {
  const RayProfile& profile;
  ProfileNames names;
  PlotTransform depths; ///< the plot of all lanes; millimetres of depth from left to right
  ThemeColors colors;
  std::optional<double> half;      ///< mm, where half of the light is gathered
  std::optional<double> cursor;    ///< mm, what is read
  std::optional<double> crosshair; ///< mm, of the slices, where it lies on the ray
};

constexpr double laneTextHeight = 18.0;
constexpr double laneGap = 6.0;
constexpr double axisHeight = 20.0;
constexpr double axisSideRoom = 10.0;
constexpr double pixelsPerDepth = 64.0;

// The crosshair's, as in slices and picture.
const QColor crosshairColor(77, 163, 255);

// What of a ray falls into one column of pixels.
struct ProfileColumn {
  double lowest = 0.0, highest = 0.0; ///< values
  double opacity = 0.0;               ///< the largest
  double contribution = 0.0;          ///< per mm, the largest
  QColor opacityColor, contributionColor;
};

void take(ProfileColumn& column, const RayProfile::Sample& sample) {
  column.lowest = std::min(column.lowest, sample.value);
  column.highest = std::max(column.highest, sample.value);
  if (sample.opacityPerMm >= column.opacity) {
    column.opacity = sample.opacityPerMm;
    column.opacityColor = toQColor(sample.color);
  }
  if (contributionPerMm(sample) >= column.contribution) {
    column.contribution = contributionPerMm(sample);
    column.contributionColor = toQColor(sample.color);
  }
}

std::vector<ProfileColumn> columnsOf(const ProfilePicture& picture) {
  const PlotTransform& depths = picture.depths;
  const auto& samples = picture.profile.samples;
  std::vector<ProfileColumn> columns;
  for (int i = 0; i < static_cast<int>(depths.plot.width()); ++i) {
    const double from = valueAtX(depths, depths.plot.left() + i);
    const double to = valueAtX(depths, depths.plot.left() + i + 1.0);
    const RayProfile::Sample& middle = sampleAt(picture.profile, (from + to) / 2.0);
    ProfileColumn column{middle.value, middle.value, 0.0, 0.0, {}, {}};
    // A surface takes no length: it shows in its own column, not in all that it is nearest to.
    if (middle.lengthMm > 0.0)
      take(column, middle);
    auto sample = std::ranges::lower_bound(samples, from, {}, &RayProfile::Sample::depthMm);
    for (; sample != samples.end() && sample->depthMm < to; ++sample)
      take(column, *sample);
    columns.push_back(column);
  }
  return columns;
}

void paintLaneFrame(QPainter& painter, const ProfilePicture& picture, const QRectF& lane,
                    const LaneText& text) {
  painter.fillRect(lane, picture.colors.base);
  const QRectF line(lane.left(), lane.top() - laneTextHeight, lane.width(), laneTextHeight);
  painter.setPen(picture.colors.text);
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, text.title);
  const double room = line.width() - painter.fontMetrics().horizontalAdvance(text.title) - 12.0;
  painter.setPen(picture.colors.secondaryText);
  if (painter.fontMetrics().horizontalAdvance(text.range) <= room)
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, text.range);
}

void paintDepthAxis(QPainter& painter, const ProfilePicture& picture, const std::array<QRectF, 3>& lanes) {
  const QRectF& plot = picture.depths.plot;
  const int most = std::max(2, static_cast<int>(plot.width() / pixelsPerDepth));
  const QString title = picture.names.depthUnit.isEmpty()
                            ? QObject::tr("deep")
                            : QObject::tr("%1 deep").arg(picture.names.depthUnit);
  paintAxisAcross(painter, picture.depths, linearTicks(picture.depths.visible, most), title,
                  {lanes.begin(), lanes.end()}, plot.bottom(), axisHeight,
                  {picture.colors.grid, picture.colors.secondaryText, picture.colors.secondaryText});
}

void paintValues(QPainter& painter, const ProfilePicture& picture, const QRectF& lane,
                 const std::vector<ProfileColumn>& columns) {
  const ValueRange values = valuesOf(picture.profile);
  const double span = values.highest > values.lowest ? values.highest - values.lowest : 1.0;
  const auto yOf = [&](double value) {
    return lane.bottom() - 2.0 - (value - values.lowest) / span * (lane.height() - 4.0);
  };
  QPolygonF line;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double x = lane.left() + static_cast<double>(i) + 0.5;
    line << QPointF(x, yOf(columns[i].lowest));
    if (columns[i].highest > columns[i].lowest)
      line << QPointF(x, yOf(columns[i].highest));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(picture.colors.curve, 1.5));
  painter.drawPolyline(line);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

// Bars in the colours of the tissue below a line that stands out from them.
void paintBars(QPainter& painter, const ProfilePicture& picture, const QRectF& lane,
               const std::vector<double>& heights, const std::vector<QColor>& colors, double most) {
  QPolygonF edge;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double x = lane.left() + static_cast<double>(i);
    const double height = most > 0.0 ? heights[i] / most * (lane.height() - 2.0) : 0.0;
    if (height > 0.0)
      painter.fillRect(QRectF(x, lane.bottom() - height, 1.0, height), colors[i]);
    edge << QPointF(x + 0.5, lane.bottom() - height - 0.5);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(picture.colors.curve, 1.0));
  painter.drawPolyline(edge);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void paintDepth(QPainter& painter, const ProfilePicture& picture, double depth, const QPen& pen) {
  const QRectF& plot = picture.depths.plot;
  const double x = std::round(xOfValue(picture.depths, depth)) + 0.5;
  if (x < plot.left() || x > plot.right())
    return;
  painter.setPen(pen);
  for (const QRectF& lane : lanesOf(plot))
    painter.drawLine(QPointF(x, lane.top()), QPointF(x, lane.bottom()));
}

// "½" on a plate at the foot of its line.
void paintHalf(QPainter& painter, const ProfilePicture& picture) {
  paintDepth(painter, picture, *picture.half, QPen(picture.colors.accent, 2.0));
  const QRectF lane = lanesOf(picture.depths.plot).back();
  const double x = xOfValue(picture.depths, *picture.half);
  if (x < lane.left() || x > lane.right())
    return;
  const QSizeF size(18.0, 18.0);
  QRectF plate(QPointF(x + 3.0, lane.top() + 3.0), size);
  if (plate.right() > lane.right())
    plate.moveRight(x - 3.0);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(picture.colors.accent);
  painter.drawRoundedRect(plate, 3.0, 3.0);
  painter.setPen(picture.colors.accentText);
  painter.drawText(plate, Qt::AlignCenter, QStringLiteral("½"));
  painter.setRenderHint(QPainter::Antialiasing, false);
}

constexpr double chartZoomStep = 1.25;
constexpr double fastPixels = 10.0;

// The plot of a chart of this size: all but what the axis takes.
QRectF profilePlot(const QSizeF& size) {
  return {axisSideRoom, 0.0, std::max(20.0, size.width() - 2.0 * axisSideRoom),
          std::max(20.0, size.height() - axisHeight)};
}

// Paints lanes, axis, marks and texts.
void paintProfile(QPainter& painter, const ProfilePicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing, false);
  const std::array<QRectF, 3> lanes = lanesOf(picture.depths.plot);
  const std::array<LaneText, 3> texts = laneTexts(picture.profile, picture.names);
  for (std::size_t i = 0; i < lanes.size(); ++i)
    paintLaneFrame(painter, picture, lanes[i], texts[i]);
  paintDepthAxis(painter, picture, lanes);
  const std::vector<ProfileColumn> columns = columnsOf(picture);
  paintValues(painter, picture, lanes[0], columns);
  std::vector<double> opacities, contributions;
  std::vector<QColor> opacityColors, contributionColors;
  for (const ProfileColumn& column : columns) {
    opacities.push_back(column.opacity);
    opacityColors.push_back(column.opacityColor);
    contributions.push_back(column.contribution);
    contributionColors.push_back(column.contributionColor);
  }
  double opaque = 0.0, most = 0.0;
  for (const RayProfile::Sample& sample : picture.profile.samples) {
    opaque = std::max(opaque, sample.opacityPerMm);
    most = std::max(most, contributionPerMm(sample));
  }
  paintBars(painter, picture, lanes[1], opacities, opacityColors, opaque);
  paintBars(painter, picture, lanes[2], contributions, contributionColors, most);
  if (picture.crosshair)
    paintDepth(painter, picture, *picture.crosshair, QPen(crosshairColor, 1.0));
  if (picture.half)
    paintHalf(painter, picture);
  if (picture.cursor)
    paintDepth(painter, picture, *picture.cursor, QPen(picture.colors.text, 1.0, Qt::DashLine));
}

} // namespace

std::array<QRectF, 3> lanesOf(const QRectF& plot) {
  const double height = std::max(4.0, (plot.height() - 2.0 * laneGap) / 3.0 - laneTextHeight);
  std::array<QRectF, 3> lanes;
  for (std::size_t i = 0; i < lanes.size(); ++i)
    lanes[i] =
        QRectF(plot.left(),
               plot.top() + laneTextHeight + static_cast<double>(i) * (height + laneTextHeight + laneGap),
               plot.width(), height);
  return lanes;
}

ProfileChart::ProfileChart(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("profileChart"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Value, opacity and share of the light along the ray"));
}

void ProfileChart::setProfile(const std::optional<RayProfile>& profile, const ProfileNames& names,
                              const std::optional<double>& crosshairMm) {
  m_profile = profile;
  m_names = names;
  m_crosshair = crosshairMm;
  if (!m_profile)
    m_cursor.reset();
  else if (m_isZoomed)
    m_visible = {std::min(m_visible.lowest, m_profile->lengthMm / 2.0),
                 std::min(m_visible.highest, m_profile->lengthMm)};
  else
    showAll();
  if (m_cursor)
    m_cursor = std::min(*m_cursor, m_profile->lengthMm);
  update();
  emit cursorMoved();
}

PlotTransform ProfileChart::depths() const {
  return {profilePlot(size()), m_visible};
}

void ProfileChart::showAll() {
  m_isZoomed = false;
  m_visible = whole();
  update();
}

void ProfileChart::zoom(double x, double factor) {
  m_visible = zoomedAtX(depths(), x, factor, whole());
  m_isZoomed = m_visible != whole();
  update();
}

void ProfileChart::readAt(double depthMm) {
  const double depth = std::clamp(depthMm, 0.0, m_profile->lengthMm);
  m_visible = revealed(depths(), depth, 0.0, whole());
  update();
  if (std::exchange(m_cursor, depth) != depth)
    emit cursorMoved();
}

void ProfileChart::paintEvent(QPaintEvent*) {
  if (!m_profile)
    return;
  QPainter painter(this);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.92);
  painter.setFont(small);
  paintProfile(painter, {*m_profile, m_names, depths(), themeColors(palette()), halfLightDepth(*m_profile),
                         m_cursor, m_crosshair});
}

void ProfileChart::mouseMoveEvent(QMouseEvent* event) {
  if (m_profile)
    readAt(valueAtX(depths(), event->position().x()));
}

void ProfileChart::mousePressEvent(QMouseEvent* event) {
  if (!m_profile || event->button() != Qt::LeftButton)
    return;
  readAt(valueAtX(depths(), event->position().x()));
  emit depthChosen(*m_cursor);
}

void ProfileChart::mouseDoubleClickEvent(QMouseEvent* event) {
  if (m_profile && event->button() == Qt::LeftButton)
    showAll();
}

// What the keys read stays.
void ProfileChart::leaveEvent(QEvent*) {
  if (hasFocus() || !std::exchange(m_cursor, std::nullopt))
    return;
  update();
  emit cursorMoved();
}

void ProfileChart::wheelEvent(QWheelEvent* event) {
  if (!m_profile)
    return;
  zoom(event->position().x(), std::pow(chartZoomStep, event->angleDelta().y() / 120.0));
  event->accept();
}

void ProfileChart::keyPressEvent(QKeyEvent* event) {
  const bool isPlain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
  if (!m_profile || !isPlain || !obey(event->key(), event->modifiers() & Qt::ShiftModifier))
    QWidget::keyPressEvent(event);
}

bool ProfileChart::obey(int key, bool isFast) {
  const std::optional<double> half = halfLightDepth(*m_profile);
  const double now = m_cursor.value_or(half.value_or(m_profile->lengthMm / 2.0));
  const double step = valuePerPixel(depths()) * (isFast ? fastPixels : 1.0);
  switch (key) {
  case Qt::Key_Left:
    readAt(now - step);
    return true;
  case Qt::Key_Right:
    readAt(now + step);
    return true;
  case Qt::Key_Home:
    readAt(0.0);
    return true;
  case Qt::Key_End:
    readAt(m_profile->lengthMm);
    return true;
  case Qt::Key_H:
    if (half)
      readAt(*half);
    return true;
  case Qt::Key_Return:
  case Qt::Key_Enter:
    readAt(now);
    emit depthChosen(now);
    return true;
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    zoom(xOfValue(depths(), now), chartZoomStep);
    return true;
  case Qt::Key_Minus:
    zoom(xOfValue(depths(), now), 1.0 / chartZoomStep);
    return true;
  case Qt::Key_F:
    showAll();
    return true;
  default:
    return false;
  }
}

RayPanel::RayPanel(QWidget* parent)
    : QWidget(parent), m_summary(new QLabel), m_goToHalf(new QPushButton(tr("Go to that depth"))),
      m_chart(new ProfileChart), m_reading(new QLabel) {
  setAccessibleName(tr("Ray"));
  for (QLabel* label : {m_summary, m_reading}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::NoTextInteraction);
  }
  m_summary->setObjectName(QStringLiteral("raySummary"));
  m_reading->setObjectName(QStringLiteral("rayReading"));
  m_reading->setForegroundRole(QPalette::PlaceholderText);
  // Of all readings as high as the longest, so that the chart does not jump.
  m_reading->setMinimumHeight(3 * m_reading->fontMetrics().lineSpacing());
  m_reading->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_goToHalf->setObjectName(QStringLiteral("goToHalf"));
  m_goToHalf->setToolTip(
      tr("<p>The crosshair goes to where half of the light is gathered, in the slices and in "
         "the picture.</p>"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(m_summary);
  column->addWidget(m_goToHalf, 0, Qt::AlignLeft);
  column->addWidget(m_chart, 1);
  column->addWidget(m_reading);
  connect(m_chart, &ProfileChart::cursorMoved, this, &RayPanel::showReading);
  connect(m_chart, &ProfileChart::depthChosen, this,
          [this](double depth) { emit placeChosen(placeAt(*m_chart->profile(), depth)); });
  connect(m_goToHalf, &QAbstractButton::clicked, this, [this] {
    const RayProfile& profile = *m_chart->profile();
    emit placeChosen(placeAt(profile, *halfLightDepth(profile)));
  });
  setProfile(std::nullopt, {}, std::nullopt);
}

void RayPanel::setProfile(const std::optional<RayProfile>& profile, const ProfileNames& names,
                          const std::optional<double>& crosshairMm) {
  m_names = names;
  m_summary->setText(profile
                         ? profileSummary(*profile, names)
                         : tr("No ray is read. Hold Shift over the picture: what lies along the ray below "
                              "the pointer shows here, and stays."));
  m_goToHalf->setEnabled(profile && halfLightDepth(*profile));
  m_chart->setProfile(profile, names, crosshairMm);
  m_chart->setAccessibleDescription(m_summary->text());
}

void RayPanel::showReading() {
  const std::optional<RayProfile>& profile = m_chart->profile();
  const std::optional<double> depth = m_chart->cursor();
  m_reading->setText(!profile ? QString()
                     : depth  ? readingAt(*profile, m_names, *depth)
                              : tr("Point at the chart to read a depth; a click goes there."));
  if (profile && depth)
    m_chart->setAccessibleDescription(m_reading->text());
}

void RayPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit shown(true);
}

void RayPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  emit shown(false);
}

} // namespace limn
