// The desktop's choice of a dark or light theme, told by a portal on a connection of our own.
#include <QElapsedTimer>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTest>
#include <QtDBus/QDBusServer>

#include "tests/suite/suite.h"
#include "widgets/commands/theme_chooser.h"

namespace tst_system_theme {

using namespace usar::widgets;

/// What a desktop's portal offers of its settings; without a scheme it answers with an error.
class Portal : public QObject {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.portal.Settings")
public:
    std::optional<uint> scheme;
    int questions = 0;

    void change(uint to) {
        scheme = to;
        emit SettingChanged("org.freedesktop.appearance", "accent-color", QDBusVariant(0u));
        emit SettingChanged("org.freedesktop.appearance", "color-scheme", QDBusVariant(to));
    }

public slots:
    QDBusVariant Read(const QString& group, const QString& key) {
        ++questions;
        if (!scheme || group != "org.freedesktop.appearance" || key != "color-scheme")
            return QDBusVariant(QString("none"));
        return QDBusVariant(QVariant::fromValue(QDBusVariant(*scheme)));
    }

signals:
    void SettingChanged(const QString& group, const QString& key, const QDBusVariant& value);
};

/// A bus with a portal, or with nobody, in this process.
class Desktop {
public:
    explicit Desktop(Portal* portal) {
        QObject::connect(&server_, &QDBusServer::newConnection, &server_, [portal](QDBusConnection to) {
            if (portal)
                to.registerObject("/org/freedesktop/portal/desktop", portal,
                                  QDBusConnection::ExportAllSlots | QDBusConnection::ExportAllSignals);
            static QList<QDBusConnection> kept; // A connection that nobody keeps is closed.
            kept << to;
        });
    }
    ~Desktop() { QDBusConnection::disconnectFromPeer(name_); }

    QDBusConnection bus() { return QDBusConnection::connectToPeer(server_.address(), name_); }

private:
    QDBusServer server_;
    QString name_ = QStringLiteral("desktop %1").arg(quintptr(this));
};

class tst_SystemTheme : public QObject {
    Q_OBJECT
private slots:
    void init() { applyTheme(Theme::Dark); }
    void cleanup() { applyTheme(Theme::Dark); }
    void theDesktopsChoiceIsTaken_data();
    void theDesktopsChoiceIsTaken();
    void aChangeIsHeard();
    void aMissingPortalBlocksNothing();
    void theWindowFollowsOnlyWhereThatIsChosen();
};

void tst_SystemTheme::theDesktopsChoiceIsTaken_data() {
    QTest::addColumn<uint>("said");
    QTest::addColumn<Theme>("theme");
    QTest::newRow("no preference") << 0u << desktopTheme();
    QTest::newRow("dark") << 1u << Theme::Dark;
    QTest::newRow("light") << 2u << Theme::Light;
    QTest::newRow("a number of later versions") << 7u << desktopTheme();
}

void tst_SystemTheme::theDesktopsChoiceIsTaken() {
    QFETCH(uint, said);
    Portal portal;
    portal.scheme = said;
    Desktop desktop(&portal);
    SystemTheme system;
    QCOMPARE(system.theme(), desktopTheme());
    system.follow(desktop.bus());
    QTRY_COMPARE(portal.questions, 1);
    QTest::qWait(20); // An answer that changes nothing is not seen.
    QFETCH(Theme, theme);
    QTRY_COMPARE(system.theme(), theme);
}

void tst_SystemTheme::aChangeIsHeard() {
    Portal portal;
    portal.scheme = 1;
    Desktop desktop(&portal);
    SystemTheme theme;
    const QSignalSpy changes(&theme, &SystemTheme::changed);
    theme.follow(desktop.bus());
    QTRY_COMPARE(theme.theme(), Theme::Dark);
    portal.change(2);
    QTRY_COMPARE(theme.theme(), Theme::Light);
    portal.change(1);
    QTRY_COMPARE(theme.theme(), Theme::Dark);
    QVERIFY(changes.size() >= 2);
}

void tst_SystemTheme::aMissingPortalBlocksNothing() {
    Desktop empty(nullptr);
    SystemTheme theme;
    QElapsedTimer clock;
    clock.start();
    theme.follow(empty.bus());
    QVERIFY2(clock.elapsed() < 1000, qPrintable(QString::number(clock.elapsed())));
    QTest::qWait(50);
    QCOMPARE(theme.theme(), desktopTheme());
    SystemTheme without_bus;
    without_bus.follow(QDBusConnection("nobody has connected this"));
    QCOMPARE(without_bus.theme(), desktopTheme());
}

void tst_SystemTheme::theWindowFollowsOnlyWhereThatIsChosen() {
    Portal portal;
    portal.scheme = 2;
    Desktop desktop(&portal);
    QMainWindow window;
    CommandRegistry commands(&window);
    ThemeChooser chooser(commands);
    chooser.registerCommands();
    chooser.system().follow(desktop.bus());
    QTRY_COMPARE(chooser.system().theme(), Theme::Light);
    chooser.choose("dark");
    QCOMPARE(currentTheme(), Theme::Dark);
    commands.action("view.system_theme")->trigger();
    QCOMPARE(chooser.name(), QString("system"));
    QCOMPARE(currentTheme(), Theme::Light);
    QVERIFY(!commands.action("view.dark")->isChecked());
    portal.change(1);
    QTRY_COMPARE(currentTheme(), Theme::Dark);
    QVERIFY(commands.action("view.dark")->isChecked() && commands.action("view.system_theme")->isChecked());
    commands.action("view.dark")->trigger(); // A choice of one's own ends it.
    QCOMPARE(chooser.name(), QString("light"));
    QVERIFY(!commands.action("view.system_theme")->isChecked());
    portal.change(2);
    portal.change(1);
    QTRY_COMPARE(chooser.system().theme(), Theme::Dark);
    QCOMPARE(currentTheme(), Theme::Light);
    chooser.choose("anything else");
    QCOMPARE(currentTheme(), Theme::Dark);
}

USAR_TEST(tst_SystemTheme)

} // namespace tst_system_theme

#include "tst_system_theme.moc"
