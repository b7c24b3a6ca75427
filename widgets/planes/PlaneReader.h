// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/Reformat.h"

#include <QObject>

#include <memory>
#include <optional>
#include <thread>

namespace limn {

/// What of a volume is read for the picture of a slice.
struct PlaneReading {
  std::shared_ptr<const Volume> volume;
  PlaneGrid plane;
  PlaneSampling sampling;
  bool operator==(const PlaneReading&) const = default;
};

/// Reads slices that take long beside the event loop: one at a time, and of what is asked for meanwhile only
/// the last.
class PlaneReader : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  void read(const PlaneReading& wanted);

  /// Nothing is wanted any more.
  void cancel();

signals:
  /// `ms` is how long the reading took.
  void done(const limn::PlaneReading& of, const limn::PlaneImage& values, double ms);

private:
  void start();
  void work(const PlaneReading& of, const std::stop_token& stop);

  std::optional<PlaneReading> m_inWork;
  std::optional<PlaneReading> m_wanted; ///< after the one in work
  std::jthread m_thread;
};

} // namespace limn
