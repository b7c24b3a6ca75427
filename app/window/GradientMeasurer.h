// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Histogram.h"

#include <QObject>
#include <QString>

#include <memory>
#include <thread>
#include <vector>

namespace limn {

/// Counts a volume's gradients on a worker thread. Only the volume asked for last counts; signals come on the
/// thread the measurer lives in.
class GradientMeasurer : public QObject {
  Q_OBJECT

public:
  explicit GradientMeasurer(QObject* parent = nullptr);

  /// Measures a volume; one that is measured or under way is not measured again. Null forgets.
  void measure(const std::shared_ptr<const Volume>& volume);

  /// The volume asked for last; null for none.
  const std::shared_ptr<const Volume>& volume() const { return m_volume; }

signals:
  void measured(const limn::Histogram& gradients);
  void failed(const QString& sentence);

private:
  void run(const std::shared_ptr<const Volume>& volume);

  std::shared_ptr<const Volume> m_volume; ///< asked for last
  std::vector<std::jthread> m_threads;
};

} // namespace limn
