// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/GradientMeasurer.h"

#include "scene/light/GradientHistogram.h"

#include <QMetaObject>

#include <exception>

namespace limn {

GradientMeasurer::GradientMeasurer(QObject* parent) : QObject(parent) {}

void GradientMeasurer::measure(const std::shared_ptr<const Volume>& volume) {
  if (volume == m_volume)
    return;
  m_volume = volume;
  if (volume)
    m_threads.emplace_back([this, volume] { run(volume); });
}

void GradientMeasurer::run(const std::shared_ptr<const Volume>& volume) {
  Histogram gradients;
  QString problem;
  try {
    gradients = gradientHistogram(*volume);
  } catch (const std::exception& error) {
    problem = tr("The volume's gradients cannot be counted: %1.").arg(QString::fromLocal8Bit(error.what()));
  }
  QMetaObject::invokeMethod(
      this,
      [this, volume, gradients, problem] {
        if (volume != m_volume)
          return;
        if (problem.isEmpty())
          emit measured(gradients);
        else
          emit failed(problem);
      },
      Qt::QueuedConnection);
}

} // namespace limn
