#include "tests/hands/desktop.h"

#include <ranges>

#include <QDBusMessage>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTest>
#include <QUuid>
#include <QtEndian>

#include <sys/prctl.h>

#include <csignal>

namespace usar::hands {

namespace {

constexpr int start_ms = 20000;
constexpr int between_ms = 30; ///< of a quick person's gestures; Qt takes events that come closer for one

QString numbers(const QPoint& point) {
    return QStringLiteral("%1 %2").arg(point.x()).arg(point.y());
}

} // namespace

void endWithUs(QProcess& process) {
    process.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGKILL); });
}

Desktop::Desktop(const QSize& size_px) : size_px_(size_px), environment_(QProcessEnvironment::systemEnvironment()) {
    // The buses leave their sockets there, and programs their settings, so that runs beside each other share nothing.
    environment_.insert("XDG_RUNTIME_DIR", folder_.path());
    environment_.insert("HOME", folder_.path());
    environment_.insert("XDG_CONFIG_HOME", folder_.filePath("config"));
    environment_.remove("QT_QPA_PLATFORM");
    QFile::setPermissions(folder_.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);

    // Without -noreset the server starts over when its last client leaves, as the accessibility bus does after a
    // moment, and throws out a window manager that has just come.
    QProcess* const screen = start("Xvfb", {"-noreset", "-displayfd", "1", "-screen", "0",
                                            QStringLiteral("%1x%2x24").arg(size_px.width()).arg(size_px.height()),
                                            "-nolisten", "tcp", "-fbdir", folder_.path()});
    if (!screen)
        return;
    environment_.insert("DISPLAY", ":" + firstLine(screen));
    QProcess* const bus = start("dbus-daemon", {"--session", "--nofork", "--nopidfile", "--print-address=1"});
    if (!bus)
        return;
    environment_.insert("DBUS_SESSION_BUS_ADDRESS", firstLine(bus));
    environment_.insert("QT_LINUX_ACCESSIBILITY_ALWAYS_ON", "1");
    if (!start("/usr/libexec/at-spi-bus-launcher", {"--launch-immediately"}) || !start("openbox", {}))
        return;
    const QString session_name = QUuid::createUuid().toString();
    QDBusConnection session =
        QDBusConnection::connectToBus(environment_.value("DBUS_SESSION_BUS_ADDRESS"), session_name);
    const auto asked = QDBusMessage::createMethodCall("org.a11y.Bus", "/org/a11y/bus", "org.a11y.Bus", "GetAddress");
    QString address;
    if (!QTest::qWaitFor([&] { return !(address = session.call(asked).arguments().value(0).toString()).isEmpty(); },
                         start_ms))
        trouble_ = "The accessibility bus does not answer: " + session.call(asked).errorMessage();
    QDBusConnection::disconnectFromBus(session_name);
    bus_name_ = QUuid::createUuid().toString();
    if (!QDBusConnection::connectToBus(address, bus_name_).isConnected())
        trouble_ = "The accessibility bus takes no connection.";
}

Desktop::~Desktop() {
    if (!bus_name_.isEmpty())
        QDBusConnection::disconnectFromBus(bus_name_);
    for (const auto& process : running_ | std::views::reverse) {
        process->terminate();
        if (!process->waitForFinished(3000)) {
            process->kill();
            process->waitForFinished();
        }
    }
}

QProcess* Desktop::start(const QString& program, const QStringList& arguments) {
    auto process = std::make_unique<QProcess>();
    process->setProcessEnvironment(environment_);
    process->setStandardErrorFile(QProcess::nullDevice());
    endWithUs(*process);
    process->start(program, arguments);
    if (!process->waitForStarted(start_ms)) {
        trouble_ = program + " does not start (tests/run installs it): " + process->errorString();
        return nullptr;
    }
    return running_.emplace_back(std::move(process)).get();
}

QString Desktop::firstLine(QProcess* process) {
    while (!process->canReadLine() && process->waitForReadyRead(start_ms)) {
    }
    return QString::fromLocal8Bit(process->readLine()).trimmed();
}

QDBusConnection Desktop::accessibility() const {
    return QDBusConnection(bus_name_);
}

void Desktop::xdotool(const QStringList& arguments) const {
    QProcess process;
    process.setProcessEnvironment(environment_);
    process.start("xdotool", arguments);
    if (!process.waitForFinished(start_ms) || process.exitCode() != 0)
        QTest::qFail(qPrintable("xdotool " + arguments.join(' ') + ": " + process.errorString() +
                                QString::fromLocal8Bit(process.readAllStandardError())),
                     __FILE__, __LINE__);
    QTest::qWait(between_ms);
}

void Desktop::moveTo(const QPoint& at) {
    xdotool(QStringList{"mousemove"} + numbers(at).split(' '));
}

void Desktop::click(const QPoint& at, int button) {
    moveTo(at);
    xdotool({"click", QString::number(button)});
}

void Desktop::doubleClick(const QPoint& at) {
    moveTo(at);
    xdotool({"click", "--repeat", "2", "--delay", "60", "1"});
}

void Desktop::drag(const QPoint& from, const QPoint& to) {
    constexpr int steps = 8;
    moveTo(from);
    xdotool({"mousedown", "1"});
    for (int step = 1; step <= steps; ++step)
        moveTo(from + (to - from) * step / steps);
    xdotool({"mouseup", "1"});
}

void Desktop::key(const QString& chord) {
    xdotool({"key", chord});
}

void Desktop::press(const QString& key) {
    xdotool({"keydown", key});
}

void Desktop::letGo(const QString& key) {
    xdotool({"keyup", key});
}

void Desktop::keyTwice(const QString& chord) {
    xdotool({"key", "--delay", "80", chord, chord});
}

void Desktop::type(const QString& text) {
    xdotool({"type", "--delay", "20", text});
}

QStringList Desktop::windows(const QString& title) const {
    QProcess process;
    process.setProcessEnvironment(environment_);
    process.start("xdotool", {"search", "--onlyvisible", "--name", title});
    process.waitForFinished(start_ms);
    return QString::fromLocal8Bit(process.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
}

void Desktop::resize(const QString& window, const QSize& size_px) {
    xdotool({"windowsize", "--sync", window, QString::number(size_px.width()), QString::number(size_px.height())});
}

/// Xvfb keeps the screen in a file in the format of xwd: a header of 32-bit big-endian numbers, a table of colors, and
/// the pixels.
QImage Desktop::screenshot() const {
    QFile file(folder_.filePath("Xvfb_screen0"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray bytes = file.readAll();
    const auto number = [&bytes](int index) {
        return static_cast<qsizetype>(qFromBigEndian<quint32>(bytes.constData() + 4 * index));
    };
    constexpr qsizetype bytes_per_color = 12;
    const qsizetype start = number(0) + number(19) * bytes_per_color;
    if (bytes.size() < start + number(5) * number(12))
        return {};
    return QImage(reinterpret_cast<const uchar*>(bytes.constData() + start), static_cast<int>(number(4)),
                  static_cast<int>(number(5)), number(12), QImage::Format_RGB32)
        .copy();
}

} // namespace usar::hands
