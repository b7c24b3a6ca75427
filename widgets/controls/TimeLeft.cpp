// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/TimeLeft.h"

#include "widgets/ValueText.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double leastSeconds = 2.0; // that tell something, and of which something is told

// No finer than such a time is known: of two digits the last is 0 or 5.
double coarse(double number) {
  const double unit = number < 10.0 ? 1.0 : 5.0;
  return unit * std::max(1.0, std::round(number / unit));
}

} // namespace

QString aboutText(double seconds) {
  if (seconds < 90.0)
    return QObject::tr("about %1 s", "a time").arg(fixedNumber(coarse(seconds), 0));
  if (const double minutes = seconds / 60.0; minutes < 90.0)
    return QObject::tr("about %1 min", "a time").arg(fixedNumber(coarse(minutes), 0));
  const double hours = seconds / 3600.0;
  return QObject::tr("about %1 h", "a time").arg(fixedNumber(hours, hours < 10.0 ? 1 : 0));
}

std::optional<double> secondsLeft(double fraction, double seconds, double telling) {
  if (fraction < telling || seconds < leastSeconds)
    return std::nullopt;
  return seconds * (1.0 - fraction) / fraction;
}

void TimeLeft::begin(std::size_t pictures, double telling) {
  m_telling = telling;
  m_pictures = std::max(1.0, static_cast<double>(pictures));
  m_last.reset();
  m_clock.start();
}

QString TimeLeft::text(double fraction) {
  const double seconds = m_clock.isValid() ? 1e-3 * static_cast<double>(m_clock.elapsed()) : 0.0;
  const std::optional<double> still = left(fraction, seconds);
  return still && *still >= leastSeconds
             ? QLatin1Char(' ') + QObject::tr("(%1 left)", "a time").arg(aboutText(*still))
             : QString();
}

std::optional<double> TimeLeft::left(double fraction, double seconds) {
  constexpr double rounding = 1e-9; // of the share that is done as the last picture begins
  const double ofLast = fraction * m_pictures - (m_pictures - 1.0);
  if (ofLast < rounding)
    return std::nullopt;
  if (!m_last)
    m_last = {ofLast, seconds};
  const double rest = 1.0 - m_last->fraction;
  return rest > 0.0 ? secondsLeft((ofLast - m_last->fraction) / rest, seconds - m_last->seconds, m_telling)
                    : std::nullopt;
}

} // namespace limn
