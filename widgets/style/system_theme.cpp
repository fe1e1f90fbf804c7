#include "widgets/style/system_theme.h"

#include <chrono>
#include <utility>

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>
#include <QThreadPool>
#include <QtDBus/QDBusMessage>
#include <QtDBus/QDBusPendingCallWatcher>
#include <QtDBus/QDBusPendingReply>

#include "core/base/hand_over.h"

namespace usar::widgets {

namespace {

const QString portal = QStringLiteral("org.freedesktop.portal.Desktop");
const QString portal_path = QStringLiteral("/org/freedesktop/portal/desktop");
const QString settings = QStringLiteral("org.freedesktop.portal.Settings");
const QString appearance = QStringLiteral("org.freedesktop.appearance");
const QString color_scheme = QStringLiteral("color-scheme");
constexpr std::chrono::milliseconds patience = std::chrono::seconds(25);

/// Without an address libdbus would start a bus of its own, on which nobody answers.
bool hasSessionBus() {
    return qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS") ||
           QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR", "/nowhere") + QStringLiteral("/bus"));
}

} // namespace

void SystemTheme::follow() {
    if (std::exchange(asked_, true) || !hasSessionBus())
        return;
    QThreadPool::globalInstance()->start(HandedOver([self = QPointer(this)] {
        const QDBusConnection bus = QDBusConnection::sessionBus();
        QMetaObject::invokeMethod(qApp, HandedOver([self, bus] {
                                      if (self) // It is looked at in its own thread only.
                                          self->follow(bus);
                                  }));
    }));
}

void SystemTheme::follow(QDBusConnection bus) {
    asked_ = true;
    if (!bus.isConnected())
        return;
    bus.connect(QString(), portal_path, settings, QStringLiteral("SettingChanged"), this,
                SLOT(hear(QString, QString, QDBusVariant)));
    QDBusMessage question =
        QDBusMessage::createMethodCall(portal, portal_path, settings, QStringLiteral("Read")); // Since its version 1.
    question << appearance << color_scheme;
    auto* const answer = new QDBusPendingCallWatcher(bus.asyncCall(question, int(patience.count())), this);
    connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
        answer->deleteLater();
        if (const QDBusPendingReply<QDBusVariant> reply = *answer; !reply.isError())
            take(reply.value().variant());
    });
}

void SystemTheme::hear(const QString& group, const QString& key, const QDBusVariant& value) {
    if (group == appearance && key == color_scheme)
        take(value.variant());
}

void SystemTheme::take(QVariant value) {
    while (value.metaType() == QMetaType::fromType<QDBusVariant>()) // `Read` wraps it twice.
        value = value.value<QDBusVariant>().variant();
    constexpr uint dark = 1;
    constexpr uint light = 2;
    const uint scheme = value.toUInt();
    const Theme said = scheme == dark ? Theme::Dark : scheme == light ? Theme::Light : desktopTheme();
    if (std::exchange(theme_, said) != said)
        emit changed(said);
}

} // namespace usar::widgets
