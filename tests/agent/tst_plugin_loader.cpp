#include <csignal>

#include <sys/wait.h>
#include <unistd.h>

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QIODevice>
#include <QObject>
#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

#include "core/agent/plugins/plugin_loader.h"
#include "tests/suite/suite.h"

namespace tst_plugin_loader {

using namespace usar;
using namespace usar::agent;

class tst_PluginLoader : public QObject {
    Q_OBJECT

    const QString built = QString(USAR_BINARY_DIR) + "/tests/plugins/";
    const QString robots = QString(USAR_BINARY_DIR) + "/robots/";
    const QString dangerous = built + "dangerous/crashes_in_the_program.so";
    const QString host = QString(USAR_BINARY_DIR) + "/bin/usar-behavior-host";

    /// A refusal says what to do.
    const QRegularExpression mends{"(Rebuild|Add|Remove|Fix|Build|Make|Give|Rename|Keep) [^.]+[.]$"};

    /// A folder with these plugins only, copied under new names so that their order is known.
    static void fill(const QTemporaryDir& folder, const QStringList& sources) {
        for (int i = 0; i < sources.size(); ++i)
            QVERIFY(
                QFile::copy(sources[i], folder.filePath(QString::number(i) + "_" + QFileInfo(sources[i]).fileName())));
    }

    /// Keeps the file and changes what is in it.
    static void overwrite(const QString& file, const QString& source) {
        QFile from(source);
        QFile to(file);
        QVERIFY(from.open(QIODevice::ReadOnly));
        QVERIFY(to.open(QIODevice::WriteOnly | QIODevice::Truncate));
        QVERIFY(to.write(from.readAll()) > 0);
    }

private slots:
    void loadsAGoodPlugin() {
        QTemporaryDir folder;
        fill(folder, {built + "good.so"});
        PluginLoader loader;
        loader.scan({folder.path()});
        QCOMPARE(loader.records().size(), std::size_t(1));
        const PluginRecord& record = loader.records().front();
        QVERIFY2(record.state == PluginState::Loaded, qPrintable(record.reason));
        QCOMPARE(record.metadata.value("name").toString(), QString("Test robot"));
        QCOMPARE(loader.robots().front().class_name, std::string("USARBot.Test"));
        QVERIFY(loader.behavior("test/idle"));
        const auto plugin = loader.pluginFor("test/idle");
        QVERIFY(plugin);
        QVERIFY(*plugin == record.plugin);
        QVERIFY((*plugin)->createBehavior("test/idle", {}).has_value());
        QVERIFY(!(*plugin)->createBehavior("test/other", {}).has_value());
    }

    void refusesABadOneAndSaysWhy_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("reason");
        QTest::newRow("another interface") << "wrong_interface.so"
                                           << "org.example.ImageFilter/1";
        QTest::newRow("a newer interface") << "wrong_version.so"
                                           << "version 1 of the plugin interface";
        QTest::newRow("metadata without behaviors") << "missing_metadata.so"
                                                    << "lack \"behaviors\"";
        QTest::newRow("behaviors that are not there") << "promises_more.so"
                                                      << "test/dance";
        QTest::newRow("throws in description") << "throws_in_description.so"
                                               << "no idea who I am";
        QTest::newRow("throws when made") << "throws_when_made.so"
                                          << "while it was being made";
        QTest::newRow("a default out of range") << "bad_default.so"
                                                << "9 is out of range";
        QTest::newRow("a preset out of range") << "bad_preset.so"
                                               << "The preset quick of its behavior test/idle is bad";
        QTest::newRow("interface only claimed") << "no_interface.so"
                                                << "Q_INTERFACES";
        QTest::newRow("a symbol that is nowhere") << "unresolved.so"
                                                  << "neverDefined";
    }
    void refusesABadOneAndSaysWhy() {
        QFETCH(QString, file);
        QFETCH(QString, reason);
        QTemporaryDir folder;
        fill(folder, {built + file});
        PluginLoader loader;
        loader.scan({folder.path()});
        QCOMPARE(loader.records().size(), std::size_t(1));
        const PluginRecord& record = loader.records().front();
        QVERIFY(record.state == PluginState::Rejected);
        QVERIFY2(record.reason.contains(reason), qPrintable(record.reason));
        QVERIFY2(mends.match(record.reason).hasMatch(), qPrintable(record.reason));
        QVERIFY(!record.plugin);
        QVERIFY(loader.robots().empty());
    }

    void refusesGarbageThatIsNamedLikeALibrary() {
        QTemporaryDir folder;
        QFile garbage(folder.filePath("garbage.so"));
        QVERIFY(garbage.open(QIODevice::WriteOnly));
        garbage.write(QByteArray(4096, 'x'));
        garbage.close();
        PluginLoader loader;
        loader.scan({folder.path()});
        QCOMPARE(loader.records().size(), std::size_t(1));
        QVERIFY(loader.records().front().reason.contains("no Qt plugin"));
        QVERIFY(mends.match(loader.records().front().reason).hasMatch());
    }

    void refusesAPluginThatWasCutShort() {
        QTemporaryDir folder;
        QFile whole(built + "good.so");
        QVERIFY(whole.open(QIODevice::ReadOnly));
        QFile cut(folder.filePath("cut.so"));
        QVERIFY(cut.open(QIODevice::WriteOnly));
        cut.write(whole.read(2048));
        cut.close();
        PluginLoader loader;
        loader.scan({folder.path()});
        QCOMPARE(loader.records().size(), std::size_t(1));
        QVERIFY(loader.records().front().state == PluginState::Rejected);
    }

    void givesADisputedIdToTheFirst() {
        QTemporaryDir folder;
        fill(folder, {built + "twin.so", built + "good.so"});
        PluginLoader loader;
        loader.scan({folder.path()});
        QCOMPARE(loader.records().size(), std::size_t(2));
        QVERIFY(loader.records()[0].state == PluginState::Loaded);
        QVERIFY(loader.records()[1].state == PluginState::Rejected);
        QVERIFY2(loader.records()[1].reason.contains("test/idle"), qPrintable(loader.records()[1].reason));
        QVERIFY(*loader.pluginFor("test/idle") == loader.records()[0].plugin);
    }

    void aFileThatIsWrittenAnewIsTheNewCodeAndTheOldOneRunsOn() {
        QTemporaryDir folder;
        const QString file = folder.filePath("robot.so");
        overwrite(file, built + "good.so");
        PluginLoader loader;
        loader.scan({folder.path()});
        QCOMPARE(loader.robots().front().name, std::string("Test robot"));
        const RobotPlugin* const old = *loader.pluginFor("test/idle");
        const auto running = old->createBehavior("test/idle", {});
        QVERIFY(running);

        overwrite(file, built + "rebuilt.so"); // into the same file, as some linkers do it
        const auto changes = loader.rescan();
        QCOMPARE(changes.size(), std::size_t(1));
        QVERIFY(changes.front().news == PluginNews::Rebuilt);
        QCOMPARE(changes.front().record.file, file);
        QCOMPARE(loader.robots().front().name, std::string("Rebuilt robot"));
        QVERIFY(*loader.pluginFor("test/idle") != old);
        QVERIFY((*running)->safeCommand() == protocol::Command(protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}));
    }

    void aSecondScanTellsWhatIsNewAndWhatIsGone() {
        QTemporaryDir folder;
        overwrite(folder.filePath("one.so"), built + "good.so");
        PluginLoader loader;
        loader.scan({folder.path()});
        const RobotPlugin* const first = *loader.pluginFor("test/idle");
        QVERIFY(loader.rescan().empty());
        QVERIFY(*loader.pluginFor("test/idle") == first);

        overwrite(folder.filePath("two.so"), built + "wrong_version.so");
        auto changes = loader.rescan();
        QCOMPARE(changes.size(), std::size_t(1));
        QVERIFY(changes.front().news == PluginNews::Refused);
        QVERIFY(changes.front().record.reason.contains("version 1 of the plugin interface"));
        QVERIFY(loader.rescan().empty()); // said once

        QVERIFY(QFile::remove(folder.filePath("one.so")));
        changes = loader.rescan();
        QCOMPARE(changes.size(), std::size_t(1));
        QVERIFY(changes.front().news == PluginNews::Removed);
        QVERIFY(!loader.pluginFor("test/idle"));
    }

    void whatWasRefusedIsTakenOnceItIsMended() {
        QTemporaryDir folder;
        const QString file = folder.filePath("robot.so");
        overwrite(file, built + "unresolved.so");
        PluginLoader loader;
        loader.scan({folder.path()});
        QVERIFY(!loader.behavior("test/idle"));
        overwrite(file, built + "good.so");
        const auto changes = loader.rescan();
        QCOMPARE(changes.size(), std::size_t(1));
        QVERIFY(changes.front().news == PluginNews::Added);
        QVERIFY(loader.behavior("test/idle"));
        QCOMPARE(loader.recordOf("test/idle")->file, file);
    }

    void behaviorsOfOneKindOfRobotComeTogetherFromAllPlugins() {
        QTemporaryDir folder;
        fill(folder, {built + "good.so", built + "faulty.so", robots + "airrobot.so"});
        PluginLoader loader;
        loader.scan({folder.path()});
        QCOMPARE(loader.robots().size(), std::size_t(3));
        const auto kinds = loader.kinds();
        QCOMPARE(kinds.size(), std::size_t(2));
        QCOMPARE(kinds[1].class_name, std::string("USARBot.AirRobot"));
        QCOMPARE(kinds[1].behaviors.front().id, std::string("faulty/none"));
        QCOMPARE(kinds[1].behaviors.back().id, std::string("airrobot/posh"));
    }

    void livesWithAMissingFolderAndSkipsOtherFiles() {
        QTemporaryDir folder;
        QFile note(folder.filePath("README.txt"));
        QVERIFY(note.open(QIODevice::WriteOnly));
        note.close();
        PluginLoader loader;
        loader.scan({"/nowhere/at/all", folder.path()});
        QVERIFY(loader.records().empty());
    }

    void namesWhatIsThereWhenABehaviorIsMissing() {
        QTemporaryDir folder;
        fill(folder, {built + "good.so", built + "missing_metadata.so"});
        PluginLoader loader;
        loader.scan({folder.path()});
        const auto plugin = loader.pluginFor("airrobot/cpp");
        QVERIFY(!plugin);
        const QString text = QString::fromStdString(plugin.error().text());
        QVERIFY2(text.contains("airrobot/cpp"), qPrintable(text));
        QVERIFY2(text.contains("There are: test/idle"), qPrintable(text));
        QVERIFY2(text.contains("1_missing_metadata.so was refused"), qPrintable(text));
        QVERIFY(!loader.behavior("airrobot/cpp"));
    }

    void whereThereIsNoPluginAtAllTheMendIsTold() {
        PluginLoader loader;
        loader.scan({"/no/robots", "/none/here"});
        const auto plugin = loader.pluginFor("airrobot/cpp");
        QVERIFY(!plugin);
        QCOMPARE(
            QString::fromStdString(plugin.error().text()),
            QString("behavior airrobot/cpp: no loaded plugin has this behavior. No robot plugin could be loaded from "
                    "/no/robots or /none/here; build or install the program again."));
    }

    void whatEndedTheProgramIsSkippedAtTheNextStart() {
        QTemporaryDir folder;
        QTemporaryDir marks;
        fill(folder, {dangerous, built + "good.so"});
        const auto scan = [&](const QStringList& isolated) {
            auto loader = std::make_unique<PluginLoader>();
            loader->setPolicy({host, isolated, PluginMarks(marks.path())});
            loader->scan({folder.path()});
            return loader;
        };
        const pid_t program = ::fork();
        if (program == 0) {
            ::signal(SIGSEGV, SIG_DFL); // or it would be a failed test
            scan({});
            ::_exit(0);
        }
        int status = 0;
        QCOMPARE(::waitpid(program, &status, 0), program);
        QVERIFY(WIFSIGNALED(status) && WTERMSIG(status) == SIGSEGV);

        const auto next = scan({});
        const PluginRecord& skipped = next->records().front();
        QVERIFY(skipped.dangerous && skipped.state == PluginState::Rejected);
        QVERIFY2(skipped.reason.contains("ended the program when it was loaded the last time"),
                 qPrintable(skipped.reason));
        QVERIFY2(mends.match(skipped.reason).hasMatch(), qPrintable(skipped.reason));
        QVERIFY(next->records().back().state == PluginState::Loaded); // the others are as well as before
        QVERIFY(scan({})->records().front().dangerous);               // and so it stays

        next->setPolicy({host, {"Crashing robot", "Test robot"}, PluginMarks(marks.path())});
        const auto changes = next->rescan();
        QVERIFY(next->records().front().isolated && !next->records().front().dangerous);
        QVERIFY(!next->records().back().isolated); // its code is here already
        QCOMPARE(changes.size(), std::size_t(2));  // both claim one id, and the first of them has it from now on

        overwrite(folder.filePath("0_crashes_in_the_program.so"), built + "twin.so"); // rebuilt, and without the fault
        QVERIFY(!scan({})->records().front().dangerous);
        QVERIFY(QDir(marks.path()).isEmpty());
    }

    void forgetsTheOldRecordsWhenItScansAgain() {
        QTemporaryDir folder;
        fill(folder, {built + "good.so"});
        PluginLoader loader;
        loader.scan({folder.path()});
        loader.scan({folder.path()});
        QCOMPARE(loader.records().size(), std::size_t(1));
        QCOMPARE(loader.robots().size(), std::size_t(1));
        loader.scan({});
        QVERIFY(loader.records().empty());
        QVERIFY(!loader.pluginFor("test/idle"));
    }
};

USAR_TEST(tst_PluginLoader)

} // namespace tst_plugin_loader

#include "tst_plugin_loader.moc"
