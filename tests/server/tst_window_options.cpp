// The command line of mission-control.
#include <QTest>

#include "core/server/embedded/window_options.h"
#include "tests/suite/suite.h"

namespace tst_window_options {

using namespace usar;

class tst_WindowOptions : public QObject {
    Q_OBJECT
private slots:
    void withoutArgumentsTheEmbeddedSimulatorStarts() {
        const auto options = server::readWindowOptions({"mission-control"});
        QVERIFY(options);
        QVERIFY(options->server.embedded);
        QCOMPARE(options->theme + options->mission_file + options->recording + options->result_folder, QString());
        QVERIFY(options->plugin_folders.isEmpty());
    }

    void theFileIsTakenByItsKind_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QStringList>("taken"); // mission, recording, snapshot
        QTest::newRow("a mission") << "a.json" << QStringList{"a.json", "", ""};
        QTest::newRow("a plan") << "a.lap" << QStringList{"a.lap", "", ""};
        QTest::newRow("a recording") << "a.usarrec" << QStringList{"", "a.usarrec", ""};
        QTest::newRow("a snapshot") << "a.usarsnap" << QStringList{"", "", "a.usarsnap"};
    }

    void theFileIsTakenByItsKind() {
        QFETCH(QString, file);
        const auto options = server::readWindowOptions({"mission-control", "--out", "/scans", file});
        QVERIFY(options);
        QTEST((QStringList{options->mission_file, options->recording, options->server.simulator.snapshot}), "taken");
        QCOMPARE(options->result_folder, QString("/scans"));
    }

    void aMomentAndARobotAreTaken() {
        const auto options =
            server::readWindowOptions({"mission-control", "a.usarrec", "--at", "312.4", "--select", "R 1"});
        QVERIFY(options && options->at);
        QCOMPARE(options->at->count(), 312.4);
        QCOMPARE(options->select, QString("R 1"));
        const auto without = server::readWindowOptions({"mission-control", "a.usarrec"});
        QVERIFY(without && !without->at && without->select.isEmpty());
    }

    void wrongArgumentsAreNamed_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("named");
        QTest::newRow("a theme") << QStringList{"--theme", "pink"} << "--theme";
        QTest::newRow("a server") << QStringList{"--connect", "here:port"} << "--connect";
        QTest::newRow("a moment that is none") << QStringList{"a.usarrec", "--at", "soon"} << "--at";
        QTest::newRow("a moment before the first") << QStringList{"a.usarrec", "--at", "-1"} << "--at";
        QTest::newRow("a moment of a mission") << QStringList{"a.json", "--at", "3"} << "--at";
        QTest::newRow("an unknown option") << QStringList{"--colour"} << "colour";
    }

    void wrongArgumentsAreNamed() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, named);
        const auto options = server::readWindowOptions(QStringList("mission-control") + arguments);
        QVERIFY(!options);
        QVERIFY2(QString::fromStdString(options.error().text()).contains(named), options.error().text().c_str());
    }

    void aThemeAndMorePluginsAreTaken() {
        for (const char* const theme : {"light", "dark", "system"}) {
            const auto options = server::readWindowOptions({"mission-control", "--theme", theme});
            QVERIFY2(options && options->theme == theme, theme);
        }
        const auto options = server::readWindowOptions({"mission-control", "--theme", "light", "--plugins", "/mine"});
        QVERIFY(options);
        QCOMPARE(options->plugin_folders.last(), QString("/mine"));
    }
};

USAR_TEST(tst_WindowOptions)

} // namespace tst_window_options

#include "tst_window_options.moc"
