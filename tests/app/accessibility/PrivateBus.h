// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/TemporaryFolder.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QObject>
#include <QProcess>
#include <QRect>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

namespace limn::test {

/// Roles of AT-SPI by their numbers (atspi-constants.h); names differ between programs.
enum class Role : unsigned {
  canvas = 6,
  checkBox = 7,
  panel = 39,
  pushButton = 43,
  radioButton = 44,
  slider = 51,
  spinButton = 52,
  toggleButton = 62
};

/// What the bus of assistive technology says of one object (AT-SPI 2, interfaces Accessible, Component,
/// Value). Every question is asked anew.
class BusObject {
public:
  BusObject() = default;
  BusObject(const QDBusConnection& bus, const QString& service, const QString& path)
      : m_bus(bus), m_service(service), m_path(path) {}

  std::vector<BusObject> children() const;
  BusObject parent() const;
  QString name() const;
  QString description() const;
  Role role() const;

  /// A bit of GetState (atspi-constants.h), such as 12 for focused.
  bool hasState(int bit) const;

  /// On the screen, pixels.
  QRect place() const;

  /// A property of the interface Value, such as CurrentValue; absent where the object has none.
  std::optional<double> number(const QString& property = QStringLiteral("CurrentValue")) const;

  /// Sets CurrentValue as assistive technology does.
  void setNumber(double number) const;

  /// Does the first action, such as taking the focus.
  void act() const;

  const QString& path() const { return m_path; }

private:
  QVariant property(const QString& interface, const QString& name) const;
  QVariantList call(const QString& interface, const QString& method,
                    const QVariantList& arguments = {}) const;

  QDBusConnection m_bus{QString()};
  QString m_service;
  QString m_path;
};

/// Listens to events of one kind, named as assistive technology registers for them.
class BusEvents : public QObject {
  Q_OBJECT

public:
  BusEvents(QDBusConnection bus, const QString& kind);

  /// The objects they were about so far.
  const QStringList& paths() const { return m_paths; }

private slots:
  void take(const QDBusMessage& event);

private:
  QStringList m_paths;
};

/// Every object below `root` for which `wanted` holds, in the order of the tree.
std::vector<BusObject> findAll(const BusObject& root, const std::function<bool(const BusObject&)>& wanted);

/// A session bus of this process's own with the bus of assistive technology on it, and the built program as
/// it is shipped, which shows its window to both. Where a package is missing, `missing` names it.
class ProgramOnPrivateBus {
public:
  explicit ProgramOnPrivateBus(const QStringList& arguments);
  ~ProgramOnPrivateBus();

  /// Why there is no bus; empty where there is one.
  const QString& missing() const { return m_missing; }

  /// The program's root, once it has a window on the bus; absent where it ended before.
  std::optional<BusObject> waitForProgram();

  /// The first below the program for which `wanted` holds, once there is one.
  std::optional<BusObject> waitForObject(const std::function<bool(const BusObject&)>& wanted);

  const QDBusConnection& bus() const { return m_bus; }

private:
  void startBus();

  TemporaryFolder m_folder;
  QString m_missing;
  QProcess m_daemon;
  QProcess m_program;
  QDBusConnection m_bus{QString()};
  std::optional<BusObject> m_root;
};

} // namespace limn::test
