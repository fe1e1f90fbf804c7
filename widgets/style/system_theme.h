// Whether the desktop is dark or light, as it says itself.
#pragma once

#include <QObject>
#include <QtDBus/QDBusConnection>
#include <QtDBus/QDBusVariant>

#include "widgets/style/theme.h"

namespace usar::widgets {

/// Asks the portal of the desktop (org.freedesktop.portal.Settings, `color-scheme`) and hears from it when that
/// changes. Nothing here waits: until the portal has answered, and where there is none or it has no preference, the
/// desktop's palette at the start of the program counts. GUI thread.
class SystemTheme : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Connects to the bus of the session in a pool thread, because a bus that hangs may take half a minute. Later
    /// calls do nothing.
    void follow();
    /// The same with a bus that is connected.
    void follow(QDBusConnection bus);

    /// What the desktop has said last.
    Theme theme() const { return theme_; }

signals:
    void changed(usar::widgets::Theme theme);

private slots:
    /// The portal's signal SettingChanged.
    void hear(const QString& group, const QString& key, const QDBusVariant& value);

private:
    void take(QVariant value);

    Theme theme_ = desktopTheme();
    bool asked_ = false;
};

} // namespace usar::widgets
