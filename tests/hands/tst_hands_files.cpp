// A double-click in a file manager starts the program with the file: each kind of file opens.
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_files {

using namespace usar::hands;

namespace {

const QString source = USAR_SOURCE_DIR "/resources/";
const QString build = USAR_BINARY_DIR;

/// A flight that is given up after some seconds: its recording is whole.
void recordTo(const QString& file, const QString& results) {
    QProcess flight;
    flight.start(build + "/bin/usar-mission",
                 {"run", source + "missions/quick_scan.json", "--limit", "20s", "--record", file, "--out", results});
    QVERIFY(flight.waitForFinished(60000));
    QVERIFY2(QFile::exists(file), flight.readAllStandardError());
}

void saveSnapshotTo(const QString& file) {
    QProcess simulator;
    simulator.setProcessChannelMode(QProcess::MergedChannels);
    QStringList arguments{"--world", "vmac_room", "--save", file};
    for (const char* const port :
         {"--port", "--image-port", "--wireless-port", "--comserver-port", "--cominterface-port"})
        arguments << port << "0";
    simulator.start(build + "/bin/usar-sim", arguments);
    QVERIFY(simulator.waitForReadyRead(60000));
    simulator.terminate();
    QVERIFY(simulator.waitForFinished(60000));
    QVERIFY2(QFile::exists(file), simulator.readAll());
}

} // namespace

class tst_HandsFiles : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void aFileOpens_data();
    void aFileOpens();

private:
    QTemporaryDir folder_;
};

void tst_HandsFiles::initTestCase() {
    recordTo(folder_.filePath("flight.usarrec"), folder_.filePath("results"));
    saveSnapshotTo(folder_.filePath("run.usarsnap"));
    QVERIFY(QFile::copy(source + "missions/quick_scan.json", folder_.filePath("scan.mission.json")));
    QVERIFY(QFile::copy(source + "plans/airrobot.lap", folder_.filePath("survey.lap")));
    QVERIFY(QFile::copy(build + "/share/worlds/warehouse/world.sdf", folder_.filePath("world.sdf")));
}

void tst_HandsFiles::aFileOpens_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("words"); // that the window says then, and not without the file
    QTest::newRow("a recording") << "flight.usarrec"
                                 << "R1 replay";
    QTest::newRow("a snapshot") << "run.usarsnap"
                                << "vmac_room";
    QTest::newRow("a mission") << "scan.mission.json"
                               << "2400 m²";
    QTest::newRow("a plan") << "survey.lap"
                            << "survey.lap";
    QTest::newRow("a world") << "world.sdf"
                             << "warehouse";
}

void tst_HandsFiles::aFileOpens() {
    QFETCH(QString, file);
    QFETCH(QString, words);
    Program program({1280, 800}, {folder_.filePath(file)});
    QVERIFY2(program.trouble().isEmpty(), qPrintable(program.trouble()));
    QVERIFY2(program.says(words), qPrintable("The window does not say " + words));
}

USAR_TEST(tst_HandsFiles)

} // namespace tst_hands_files

#include "tst_hands_files.moc"
