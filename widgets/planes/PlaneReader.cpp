// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneReader.h"

#include "scene/basics/Error.h"

#include <QMetaObject>

#include <chrono>
#include <new>
#include <utility>

namespace limn {

void PlaneReader::read(const PlaneReading& wanted) {
  if (wanted == m_inWork && !m_thread.get_stop_token().stop_requested())
    return;
  m_wanted = wanted;
  if (m_inWork)
    m_thread.request_stop();
  else
    start();
}

void PlaneReader::cancel() {
  m_wanted.reset();
  m_thread.request_stop();
}

void PlaneReader::start() {
  m_inWork = std::exchange(m_wanted, std::nullopt);
  m_thread = std::jthread([this, of = *m_inWork](const std::stop_token& stop) { work(of, stop); });
}

// On a worker thread. What there is no memory for stays as coarse as it is.
void PlaneReader::work(const PlaneReading& of, const std::stop_token& stop) {
  const auto begin = std::chrono::steady_clock::now();
  std::optional<PlaneImage> values;
  try {
    values =
        reformatted(*of.volume, of.plane, of.sampling, {0, [&stop] { return stop.stop_requested(); }, {}});
  } catch (const Cancelled&) {
  } catch (const std::bad_alloc&) {
  }
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  QMetaObject::invokeMethod(
      this,
      [this, of, values = std::move(values), ms = taken.count()] {
        m_inWork.reset();
        if (m_wanted)
          return start();
        if (values && !m_thread.get_stop_token().stop_requested())
          emit done(of, *values, ms);
      },
      Qt::QueuedConnection);
}

} // namespace limn
