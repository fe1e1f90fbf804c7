// `usar-mission server-files` as a program, and what a mission says on a server whose robot lacks sensors.
#include <QDir>
#include <QTest>

#include "core/server/embedded/headless_simulator.h"
#include "tests/doubles/meddling_relay.h"
#include "tests/loop/program_folder.h"
#include "tests/suite/suite.h"

namespace tst_usar_server_files {

using namespace usar;
using test::ProgramFolder;

namespace {

/// A made-up file of a server whose AirRobot has two sonars and a camera.
constexpr char stock[] = R"([USARBot.AirRobot]
MisPkgs=(PkgName="CameraPanTilt",PkgClass=class'USARMisPkg.CameraPanTilt')
Sensors=(ItemClass=class'USARBot.SonarSensor',ItemName="F1",Position=(X=0,Y=0,Z=0),Direction=(Y=0,Z=-1.57,X=0))
Sensors=(ItemClass=class'USARBot.INS',ItemName="INS",Position=(X=0,Y=0,Z=0),Direction=(Y=0,Z=0,X=0))
)";

QByteArray bytesIn(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class tst_UsarServerFiles : public QObject {
    Q_OBJECT
private slots:
    void writesTheFilesThatAreInstalled() {
        const auto ended = folder_.run({"server-files", folder_.path("made/here")});
        QVERIFY2(ended.exit_code == 0, ended.err);
        for (const QString name : {"USARBot.ini", "DefaultUSAR.ini"}) {
            const QByteArray made = bytesIn(folder_.path("made/here/") + name);
            QVERIFY(!made.isEmpty());
            QCOMPARE(made, bytesIn(QString(USAR_BINARY_DIR "/share/robots/usarsim/") + name));
        }
        QVERIFY2(ended.err.contains("ERS: Helper"), ended.err); // What a server cannot have is said.
    }

    /// The way of the page: look, merge, look again.
    void aMergedFileLacksNothing() {
        folder_.write("USARBot.ini", stock);
        const auto before =
            folder_.run({"server-files", "--check", folder_.path("USARBot.ini"), "--robot", "AirRobot"});
        QCOMPARE(before.exit_code, 1);
        QCOMPARE(
            folder_.run({"server-files", "--merge", folder_.path("USARBot.ini"), folder_.path("merged")}).exit_code, 0);
        const auto after =
            folder_.run({"server-files", "--check", folder_.path("merged/USARBot.ini"), "--robot", "AirRobot"});
        QVERIFY2(after.exit_code == 0, after.err);
        QCOMPARE(bytesIn(folder_.path("USARBot.ini")), QByteArray(stock)); // The original is as it was.
    }

    void refusalsNameTheFileAndTheMend_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        QTest::newRow("no folder") << QStringList{} << "Write usar-mission server-files";
        QTest::newRow("no such file") << QStringList{"--check", "none.ini"} << "none.ini";
        QTest::newRow("no robots in it") << QStringList{"--check", "empty.ini"} << "no section of a robot";
        QTest::newRow("no such robot") << QStringList{"--check", "USARBot.ini", "--robot", "Zeppelin"} << "Zeppelin";
        QTest::newRow("into itself") << QStringList{"--merge", "USARBot.ini", "."} << "keep the original";
        QTest::newRow("both") << QStringList{"--merge", "USARBot.ini", "--check", "USARBot.ini"}
                              << "not how to call it";
        QTest::newRow("a file for a folder") << QStringList{"empty.ini"} << "Choose another";
    }
    void refusalsNameTheFileAndTheMend() {
        QFETCH(const QStringList, arguments);
        QFETCH(const QString, words);
        folder_.write("USARBot.ini", stock);
        folder_.write("empty.ini", "[URL]\nPort=7777\n");
        const auto ended = folder_.run(QStringList{"server-files"} + arguments);
        QCOMPARE(ended.exit_code, 2);
        QVERIFY2(ended.err.contains(words.toUtf8()), ended.err);
    }

    void aMissionNamesWhatTheRobotLacksAndTheFile() {
        const auto simulator = server::HeadlessSimulator::start("tall_test", {.speed_x = 20.0});
        QVERIFY(simulator);
        test::MeddlingRelay relay((*simulator)->port());
        relay.meddle = [](const QByteArray& line) {
            if (!line.contains("{Type RangeScanner}"))
                return line;
            return line.startsWith("SEN") ? QByteArray() : line.left(line.indexOf(' ')) + " {Type RangeScanner}\r\n";
        };
        folder_.write("small.json", test::small_mission);
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(ProgramFolder::program(),
                      {"run", "small.json", "--connect", "127.0.0.1:" + QString::number(relay.port()), "--out", "out"});
        QTRY_VERIFY_WITH_TIMEOUT(process.state() == QProcess::NotRunning, ProgramFolder::patience_ms);
        const QByteArray said = process.readAllStandardError();
        QCOMPARE(process.exitCode(), 1);
        QVERIFY2(said.contains("needs the sensor RangeScanner"), said);
        QVERIFY2(said.contains("share/robots/usarsim"), said);
    }

private:
    ProgramFolder folder_;
};

USAR_TEST(tst_UsarServerFiles)

} // namespace tst_usar_server_files

#include "tst_usar_server_files.moc"
