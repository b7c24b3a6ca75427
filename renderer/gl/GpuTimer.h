// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"

#include <functional>
#include <optional>
#include <string>

namespace limn {

/// Measures how long drawing takes, by the method that is honest on this driver. Needs the same context
/// current for every call, construction and destruction.
class GpuTimer {
public:
  enum class Method {
    timerQuery, ///< the driver's elapsed-time query (ARB_timer_query): the graphics card's own time
    finish      ///< the processor's clock until glFinish returns: everything drawing makes one wait for
  };

  /// Asks the driver for a timer query; without one it is glFinish.
  GpuTimer();

  /// Draws a typical picture three times by both methods and drops a timer query that contradicts the clock:
  /// a software renderer may count only a part of its threads' work. Leaves the timer as it was where there
  /// is no query.
  void calibrate(const std::function<void()>& work);

  /// The time of `work`, ms. Waits until all that was drawn before is done, and for the work itself.
  double measureMs(const std::function<void()>& work);

  Method method() const { return m_method; }

  /// The method, and why not the other one, a phrase.
  const std::string& description() const { return m_description; }

private:
  struct Sample {
    double queryMs = 0.0; ///< 0 where there is no query
    double wallMs = 0.0;
  };
  Sample sample(const std::function<void()>& work);

  std::optional<GlQuery> m_query;
  Method m_method = Method::finish;
  std::string m_description;
};

/// Whether a query's time can be that of work for which the clock counted `wallMs`: not longer, and not so
/// much shorter that handing the work to a driver (2 ms) does not explain it.
bool agreesWithClock(double queryMs, double wallMs);

} // namespace limn
