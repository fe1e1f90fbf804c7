// The window says what is true: whose figures these are, and whether they still are (window-review D1-D3).
#include <csignal>

#include <QRegularExpression>
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_truth {

using namespace usar::hands;

namespace {

/// usar-sim as a process that can be frozen, as a network can, and killed.
class Simulator {
public:
    explicit Simulator(int port = 0) {
        process_.start(USAR_BINARY_DIR "/bin/usar-sim", {"--port", QString::number(port)});
        static const QRegularExpression number(R"(on 127\.0\.0\.1:(\d+))");
        QByteArray said;
        while (port_ == 0 && process_.waitForReadyRead(15000)) {
            said += process_.readAll();
            if (const auto match = number.match(QString::fromLocal8Bit(said)); match.hasMatch())
                port_ = match.captured(1).toInt();
        }
    }
    ~Simulator() {
        process_.kill();
        process_.waitForFinished();
    }
    int port() const { return port_; }
    void freeze() { ::kill(static_cast<pid_t>(process_.processId()), SIGSTOP); }
    void kill() {
        process_.kill();
        process_.waitForFinished();
    }

private:
    QProcess process_;
    int port_ = 0;
};

} // namespace

class tst_HandsTruth : public QObject {
    Q_OBJECT
private slots:
    void instrumentsShowTheirRobotsFiguresAlone();
    void silenceIsSeenEverywhere();
};

void tst_HandsTruth::instrumentsShowTheirRobotsFiguresAlone() {
    Program program;
    QVERIFY2(program.trouble().isEmpty(), qPrintable(program.trouble()));
    QVERIFY(program.spawnAt("PlayerStart", "R1"));
    QVERIFY(program.fly());
    QVERIFY(program.says("Status of R1"));
    program.screenshot("flying");
    const auto map = program.read().find([](const Seen& seen) { return seen.name == "Map"; });
    QVERIFY(map);
    program.desk().click(map->at.bottomLeft() + QPoint(20, -20)); // The keys are the map's again.
    program.desk().key("Home");
    const auto other = program.read().find(
        [](const Seen& seen) { return seen.name.startsWith("Start pose ") && seen.name != "Start pose PlayerStart"; });
    QVERIFY(other);
    QVERIFY(program.spawnAt(other->name.mid(11), "R2"));
    QVERIFY(program.says("Status of R2"));
    QTRY_COMPARE_WITH_TIMEOUT(program.figure("flown"), QStringLiteral("– m"), 5000);
    program.desk().key("1");
    QVERIFY(program.says("Status of R1"));
    QVERIFY(program.figure("flown").section(' ', 0, 0).toDouble() > 0.0);
}

void tst_HandsTruth::silenceIsSeenEverywhere() {
    Simulator simulator;
    QVERIFY(simulator.port() > 0);
    Program program({1280, 800}, {"--connect", QStringLiteral("127.0.0.1:%1").arg(simulator.port())});
    QVERIFY2(program.trouble().isEmpty(), qPrintable(program.trouble()));
    QVERIFY(program.spawnAt("PlayerStart", "R1"));
    QVERIFY(program.fly());
    const QStringList instruments{"elapsed", "flown", "Laser scan", "Sonars"};
    for (const QString& one : instruments)
        QVERIFY2(!program.figure(one).contains("out of date"), qPrintable(one));
    simulator.freeze();
    for (const QString& one : instruments)
        QTRY_VERIFY2_WITH_TIMEOUT(program.figure(one).contains("out of date"), qPrintable(one), 8000);
    const auto robot = program.read().find([](const Seen& seen) { return seen.name == "Robot R1"; });
    QVERIFY(robot && robot->description.contains("out of date"));
    program.screenshot("silent");
    simulator.kill();
    const Simulator again(simulator.port());
    QVERIFY(program.says("Connected", 30000));
    for (const QString& one : instruments)
        QVERIFY2(program.figure(one).contains("out of date"), qPrintable(one));
    program.screenshot("after_reconnect");
}

USAR_TEST(tst_HandsTruth)

} // namespace tst_hands_truth

#include "tst_hands_truth.moc"
