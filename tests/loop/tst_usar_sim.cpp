// The simulator alone as a program: it serves, ends, and goes on where it ended.
#include <csignal>

#include <QProcess>
#include <QRegularExpression>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/signaling.h"
#include "tests/suite/suite.h"

namespace tst_usar_sim {

namespace {

const QString program = QString(USAR_BINARY_DIR) + "/bin/usar-sim";
constexpr int patience_ms = 60000;

/// Runs on free ports until it is interrupted or destroyed.
class Simulator {
public:
    explicit Simulator(const QStringList& arguments) {
        process_.setProcessChannelMode(QProcess::MergedChannels);
        process_.start(program, QStringList{"--port", "0", "--image-port", "0", "--wireless-port", "0",
                                            "--comserver-port", "0", "--cominterface-port", "0"} +
                                    arguments);
    }
    ~Simulator() { interrupt(); }

    /// Everything that it has printed, once these words are among it.
    QString printed(const QString& words) {
        const bool there = QTest::qWaitFor(
            [&] {
                text_ += QString::fromUtf8(process_.readAll());
                return text_.contains(words) || process_.state() == QProcess::NotRunning;
            },
            patience_ms);
        return there && text_.contains(words) ? text_ : QString();
    }
    quint16 port() {
        const auto match = QRegularExpression("on 127\\.0\\.0\\.1:(\\d+) - connect").match(printed(" - connect"));
        return static_cast<quint16>(match.captured(1).toUInt());
    }
    int interrupt() {
        usar::test::sendSignal(process_.processId(), SIGINT); // one that has ended needs none
        return exitCode();
    }
    /// Once it has ended by itself.
    int exitCode() {
        if (process_.state() == QProcess::Running && !process_.waitForFinished(patience_ms))
            process_.kill();
        return process_.exitStatus() == QProcess::NormalExit ? process_.exitCode() : -1;
    }

private:
    QProcess process_;
    QString text_;
};

/// The newest time that a robot's STA has told, above `least_s`; negative where none came.
double heardTime(QTcpSocket& socket, double least_s) {
    QByteArray heard;
    double newest_s = -1.0;
    const QRegularExpression state("STA \\{Type \\w+\\} \\{Time ([0-9.]+)\\}");
    (void)QTest::qWaitFor(
        [&] {
            heard += socket.readAll();
            for (auto it = state.globalMatch(QString::fromUtf8(heard)); it.hasNext();)
                newest_s = it.next().captured(1).toDouble();
            return newest_s > least_s;
        },
        patience_ms);
    return newest_s;
}

} // namespace

class tst_UsarSim : public QObject {
    Q_OBJECT

private slots:
    void everyProgramTellsItsVersion_data() {
        QTest::addColumn<QString>("path");
        for (const char* const path : {"bin/usar-sim", "bin/usar-mission", "bin/mission-control",
                                       "bin/usar-behavior-host", "tools/usar-make-world"})
            QTest::newRow(path) << QString(path);
    }
    void everyProgramTellsItsVersion() {
        QFETCH(const QString, path);
        QProcess process;
        process.start(QString(USAR_BINARY_DIR) + "/" + path, {"--version"});
        QVERIFY(process.waitForFinished(patience_ms));
        QCOMPARE(process.exitCode(), 0);
        const QString said = QString::fromUtf8(process.readAllStandardOutput());
        QVERIFY2(QRegularExpression("^[a-z-]+ \\d+\\.\\d+\\.\\d+\\n$").match(said).hasMatch(), qPrintable(said));
        QVERIFY(said.startsWith(path.section('/', 1)));
    }

    /// In a bare environment, as over ssh.
    void everyProgramHelpsWithoutADisplayAndWithoutWarningsOfQt_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("argument");
        QTest::addColumn<int>("exit_code");
        QTest::addColumn<QString>("words");
        QTest::newRow("usar-sim") << "usar-sim"
                                  << "--help" << 0 << "usar-sim [options]";
        QTest::newRow("usar-mission") << "usar-mission"
                                      << "--help" << 0 << "usar-mission run MISSION.json";
        QTest::newRow("mission-control") << "mission-control"
                                         << "--help" << 0 << "mission-control [options]";
        QTest::newRow("usar-behavior-host") << "usar-behavior-host"
                                            << "--help" << 0 << "usar-mission run --isolate";
        QTest::newRow("a window without a display") << "mission-control"
                                                    << "--theme=dark" << 2 << "there is no display";
    }
    void everyProgramHelpsWithoutADisplayAndWithoutWarningsOfQt() {
        QFETCH(const QString, path);
        QFETCH(const QString, argument);
        QFETCH(const int, exit_code);
        QFETCH(const QString, words);
        QProcess process;
        QProcessEnvironment bare;
        bare.insert("PATH", "/usr/bin:/bin");
        process.setProcessEnvironment(bare);
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(QString(USAR_BINARY_DIR "/bin/") + path, {argument});
        QVERIFY(process.waitForFinished(patience_ms));
        const QString said = QString::fromUtf8(process.readAll());
        QCOMPARE(process.exitCode(), exit_code);
        QVERIFY2(said.contains(words) && !said.contains("QStandardPaths"), qPrintable(said));
    }

    void itIsOpenToOtherMachinesOnlyIfBothOptionsSaySo() {
        Simulator open({"--bind", "0.0.0.0", "--allow", "192.0.2.0/24"});
        QVERIFY(open.printed("Open to this machine and to 192.0.2.0/24").contains(" on 0.0.0.0:"));
        Simulator shut({"--bind", "0.0.0.0"});
        QVERIFY(shut.printed("--allow 192.168.1.0/24").contains("nobody would be allowed to connect"));
        QCOMPARE(shut.exitCode(), 2);
    }

    void goesOnWhereItWasSaved();
    void aFileThatIsNoSnapshotIsRefused();
    void aWrongFaultIsRefused();
};

void tst_UsarSim::goesOnWhereItWasSaved() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("run.usarsnap");
    double saved_s = 0.0;
    {
        Simulator simulator({"--save", file, "--speed", "10"});
        QTcpSocket socket;
        socket.connectToHost("127.0.0.1", simulator.port());
        QVERIFY(socket.waitForConnected());
        socket.write("INIT {ClassName USARBot.P2DX} {Name R7} {Start PlayerStart}\r\n");
        saved_s = heardTime(socket, 5.0);
        QVERIFY(saved_s > 5.0);
        QCOMPARE(simulator.interrupt(), 0);
    }
    Simulator simulator({"--resume", file});
    QVERIFY(!simulator.printed("USARBot.P2DX R7 waits").isEmpty());
    QTcpSocket socket;
    socket.connectToHost("127.0.0.1", simulator.port());
    QVERIFY(socket.waitForConnected());
    socket.write("INIT {ClassName USARBot.P2DX} {Name R7} {Location 9,9,-9}\r\n");
    QVERIFY(heardTime(socket, 0.0) >= saved_s);
}

void tst_UsarSim::aFileThatIsNoSnapshotIsRefused() {
    Simulator simulator({"--resume", program});
    QVERIFY(!simulator.printed("line 1: this is not a snapshot").isEmpty());
    QCOMPARE(simulator.exitCode(), 2);
}

void tst_UsarSim::aWrongFaultIsRefused() {
    Simulator simulator({"--fault", "wind sped=3"});
    QVERIFY(!simulator.printed("Did you mean 'speed'?").isEmpty());
    QCOMPARE(simulator.exitCode(), 2);
}

USAR_TEST(tst_UsarSim)

} // namespace tst_usar_sim

#include "tst_usar_sim.moc"
