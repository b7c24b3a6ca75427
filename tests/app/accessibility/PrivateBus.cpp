// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/accessibility/PrivateBus.h"

#include "support/Places.h"
#include "support/Waiting.h"

#include <QDBusArgument>
#include <QDBusConnectionInterface>
#include <QDBusMessage>
#include <QDBusObjectPath>
#include <QDBusVariant>
#include <QFile>
#include <QStandardPaths>

namespace limn::test {
namespace {

const QString atspi = QStringLiteral("org.a11y.atspi.");
const QString rootPath = QStringLiteral("/org/a11y/atspi/accessible/root");
constexpr int answerMs = 60000; // of a program that is busy drawing

BusObject objectIn(const QDBusConnection& bus, const QDBusArgument& reference) {
  QString service;
  QDBusObjectPath path;
  reference.beginStructure();
  reference >> service >> path;
  reference.endStructure();
  return {bus, service, path.path()};
}

void collect(const BusObject& object, const std::function<bool(const BusObject&)>& wanted,
             std::vector<BusObject>& found) {
  if (wanted(object))
    found.push_back(object);
  for (const BusObject& child : object.children())
    collect(child, wanted, found);
}

} // namespace

QVariantList BusObject::call(const QString& interface, const QString& method,
                             const QVariantList& arguments) const {
  QDBusMessage message = QDBusMessage::createMethodCall(m_service, m_path, interface, method);
  message.setArguments(arguments);
  return m_bus.call(message, QDBus::Block, answerMs).arguments();
}

QVariant BusObject::property(const QString& interface, const QString& name) const {
  const QVariantList answer = call(QStringLiteral("org.freedesktop.DBus.Properties"), QStringLiteral("Get"),
                                   {atspi + interface, name});
  return answer.isEmpty() ? QVariant() : answer.first().value<QDBusVariant>().variant();
}

std::vector<BusObject> BusObject::children() const {
  std::vector<BusObject> children;
  const QVariantList answer = call(atspi + QStringLiteral("Accessible"), QStringLiteral("GetChildren"));
  if (answer.isEmpty() || answer.first().userType() != qMetaTypeId<QDBusArgument>())
    return children;
  const auto list = answer.first().value<QDBusArgument>();
  list.beginArray();
  while (!list.atEnd())
    children.push_back(objectIn(m_bus, list));
  list.endArray();
  return children;
}

BusObject BusObject::parent() const {
  return objectIn(m_bus,
                  property(QStringLiteral("Accessible"), QStringLiteral("Parent")).value<QDBusArgument>());
}

QString BusObject::name() const {
  return property(QStringLiteral("Accessible"), QStringLiteral("Name")).toString();
}

QString BusObject::description() const {
  return property(QStringLiteral("Accessible"), QStringLiteral("Description")).toString();
}

Role BusObject::role() const {
  const QVariantList answer = call(atspi + QStringLiteral("Accessible"), QStringLiteral("GetRole"));
  return static_cast<Role>(answer.isEmpty() ? 0u : answer.first().toUInt());
}

bool BusObject::hasState(int bit) const {
  const QVariantList answer = call(atspi + QStringLiteral("Accessible"), QStringLiteral("GetState"));
  QList<uint> words;
  if (!answer.isEmpty())
    answer.first().value<QDBusArgument>() >> words;
  return bit / 32 < words.size() && words[bit / 32] >> (bit % 32) & 1u;
}

QRect BusObject::place() const {
  const QVariantList answer =
      call(atspi + QStringLiteral("Component"), QStringLiteral("GetExtents"), {QVariant::fromValue(0u)});
  if (answer.isEmpty())
    return {};
  int x = 0, y = 0, width = 0, height = 0;
  const auto extents = answer.first().value<QDBusArgument>();
  extents.beginStructure();
  extents >> x >> y >> width >> height;
  extents.endStructure();
  return {x, y, width, height};
}

std::optional<double> BusObject::number(const QString& name) const {
  const QVariant value = property(QStringLiteral("Value"), name);
  return value.isValid() ? std::optional(value.toDouble()) : std::nullopt;
}

void BusObject::setNumber(double number) const {
  call(QStringLiteral("org.freedesktop.DBus.Properties"), QStringLiteral("Set"),
       {atspi + QStringLiteral("Value"), QStringLiteral("CurrentValue"),
        QVariant::fromValue(QDBusVariant(number))});
}

void BusObject::act() const {
  call(atspi + QStringLiteral("Action"), QStringLiteral("DoAction"), {0});
}

std::vector<BusObject> findAll(const BusObject& root, const std::function<bool(const BusObject&)>& wanted) {
  std::vector<BusObject> found;
  collect(root, wanted, found);
  return found;
}

BusEvents::BusEvents(QDBusConnection bus, const QString& kind) {
  bus.connect({}, {}, atspi + QStringLiteral("Event.Object"), QStringLiteral("PropertyChange"), this,
              SLOT(take(QDBusMessage)));
  // Programs tell only what somebody has registered for, and ask the registry again when it says so.
  QDBusMessage wish = QDBusMessage::createMethodCall(
      atspi + QStringLiteral("Registry"), QStringLiteral("/org/a11y/atspi/registry"),
      atspi + QStringLiteral("Registry"), QStringLiteral("RegisterEvent"));
  wish.setArguments({kind});
  bus.call(wish, QDBus::Block, answerMs);
}

void BusEvents::take(const QDBusMessage& event) {
  m_paths << event.path();
}

ProgramOnPrivateBus::ProgramOnPrivateBus(const QStringList& arguments) {
  startBus();
  if (!m_missing.isEmpty())
    return;
  m_program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
  m_program.setProcessEnvironment(m_daemon.processEnvironment());
  m_program.start(QString::fromStdString(programPath()), arguments);
}

ProgramOnPrivateBus::~ProgramOnPrivateBus() {
  for (QProcess* process : {&m_program, &m_daemon}) {
    process->terminate();
    process->waitForFinished(-1);
  }
}

void ProgramOnPrivateBus::startBus() {
  const QString daemon = QStandardPaths::findExecutable(QStringLiteral("dbus-daemon"));
  if (daemon.isEmpty())
    m_missing = QStringLiteral("there is no dbus-daemon; install the package dbus");
  else if (!QFile::exists(QStringLiteral("/usr/share/dbus-1/services/org.a11y.Bus.service")))
    m_missing = QStringLiteral("there is no bus for assistive technology; install the package at-spi2-core");
  if (!m_missing.isEmpty())
    return;
  const QString home = QString::fromStdString(m_folder.path().string()); // nobody else may enter it
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"HOME", "XDG_RUNTIME_DIR", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"})
    environment.insert(QLatin1String(name), home);
  environment.remove(QStringLiteral("AT_SPI_BUS_ADDRESS"));
  environment.insert(QStringLiteral("QT_LINUX_ACCESSIBILITY_ALWAYS_ON"), QStringLiteral("1"));
  m_daemon.setProcessEnvironment(environment);
  m_daemon.start(
      daemon, {QStringLiteral("--session"), QStringLiteral("--nofork"), QStringLiteral("--print-address")});
  if (!waitUntil([this] { return m_daemon.canReadLine() || m_daemon.state() == QProcess::NotRunning; }) ||
      !m_daemon.canReadLine()) {
    m_missing = QStringLiteral("dbus-daemon does not start here");
    return;
  }
  const QString address = QString::fromUtf8(m_daemon.readLine()).trimmed();
  environment.insert(QStringLiteral("DBUS_SESSION_BUS_ADDRESS"), address);
  m_daemon.setProcessEnvironment(environment); // for what starts beside it
  const QDBusConnection session = QDBusConnection::connectToBus(address, QStringLiteral("limn_session"));
  // The question starts the bus of assistive technology.
  const QDBusMessage answer = session.call(
      QDBusMessage::createMethodCall(QStringLiteral("org.a11y.Bus"), QStringLiteral("/org/a11y/bus"),
                                     QStringLiteral("org.a11y.Bus"), QStringLiteral("GetAddress")),
      QDBus::Block, answerMs);
  if (answer.type() != QDBusMessage::ReplyMessage)
    m_missing =
        QStringLiteral("the bus for assistive technology does not start here: ") + answer.errorMessage();
  else
    m_bus = QDBusConnection::connectToBus(answer.arguments().first().toString(), QStringLiteral("limn_a11y"));
}

std::optional<BusObject> ProgramOnPrivateBus::waitForProgram() {
  if (m_root)
    return m_root;
  const auto arrived = [this] {
    const QStringList services = m_bus.interface()->registeredServiceNames();
    for (const QString& service : services) {
      const BusObject root(m_bus, service, rootPath);
      if (m_bus.interface()->servicePid(service) == m_program.processId() && !root.children().empty()) {
        m_root = root;
        return true;
      }
    }
    return m_program.state() == QProcess::NotRunning;
  };
  (void)waitUntil(arrived);
  return m_root;
}

std::optional<BusObject>
ProgramOnPrivateBus::waitForObject(const std::function<bool(const BusObject&)>& wanted) {
  std::optional<BusObject> object;
  if (!waitForProgram())
    return object;
  (void)waitUntil([&] {
    const auto found = findAll(*m_root, wanted);
    if (!found.empty())
      object = found.front();
    return object || m_program.state() == QProcess::NotRunning;
  });
  return object;
}

} // namespace limn::test
