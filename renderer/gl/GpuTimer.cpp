// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GpuTimer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

namespace limn {
namespace {

bool hasTimerQuery() {
  if (epoxy_gl_version() < 33 && !epoxy_has_gl_extension("GL_ARB_timer_query"))
    return false;
  GLint bits = 0;
  glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
  return bits > 0;
}

} // namespace

bool agreesWithClock(double queryMs, double wallMs) {
  constexpr double overheadMs = 2.0;
  const bool isTooLong = queryMs > 1.05 * wallMs + 0.1;
  const bool isTooShort = queryMs < 0.9 * wallMs && wallMs - queryMs > overheadMs;
  return queryMs > 0.0 && !isTooLong && !isTooShort;
}

GpuTimer::GpuTimer() {
  if (hasTimerQuery()) {
    m_query.emplace();
    m_method = Method::timerQuery;
    m_description = "GPU timer query";
  } else {
    m_description = "clock around glFinish (this driver has no timer query)";
  }
}

GpuTimer::Sample GpuTimer::sample(const std::function<void()>& work) {
  Sample sample;
  glFinish();
  const auto start = std::chrono::steady_clock::now();
  if (m_query)
    glBeginQuery(GL_TIME_ELAPSED, m_query->name());
  work();
  if (m_query)
    glEndQuery(GL_TIME_ELAPSED);
  glFinish();
  sample.wallMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  if (m_query) {
    // 32 bits would overflow after four seconds, and some drivers return 0 by that getter.
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(m_query->name(), GL_QUERY_RESULT, &nanoseconds);
    sample.queryMs = static_cast<double>(nanoseconds) * 1e-6;
  }
  return sample;
}

void GpuTimer::calibrate(const std::function<void()>& work) {
  if (m_method != Method::timerQuery)
    return;
  std::array<Sample, 3> samples;
  for (Sample& one : samples)
    one = sample(work);
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.queryMs * b.wallMs < b.queryMs * a.wallMs; });
  // The middle ratio: a single interruption decides nothing.
  const Sample& typical = samples[1];
  if (agreesWithClock(typical.queryMs, typical.wallMs))
    return;
  m_query.reset();
  m_method = Method::finish;
  char text[160];
  std::snprintf(text, sizeof text,
                "clock around glFinish (this driver's timer query counts %.1f of %.1f ms and is not used)",
                typical.queryMs, typical.wallMs);
  m_description = text;
}

double GpuTimer::measureMs(const std::function<void()>& work) {
  const Sample measured = sample(work);
  return m_method == Method::timerQuery ? measured.queryMs : measured.wallMs;
}

} // namespace limn
