// What the simulator logs about its clients: bounded for each, with nothing in it that a terminal obeys; and how often
// a client may hold up the others.
#include <QObject>
#include <QString>
#include <QTest>

#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_server_log {

using namespace usar;
using namespace usar::sim;

namespace {

QStringList logOf(Simulation& simulation) {
    QStringList lines;
    for (const std::string& line : simulation.takeLog())
        lines << QString::fromStdString(line);
    return lines;
}

} // namespace

class tst_ServerLog : public QObject {
    Q_OBJECT

private slots:
    void aClientThatIsWrongAMillionTimesFillsNoLog_data() {
        QTest::addColumn<bool>("leaves");
        QTest::newRow("and leaves") << true;
        QTest::newRow("and is there when the server ends") << false;
    }

    void aClientThatIsWrongAMillionTimesFillsNoLog() {
        QFETCH(bool, leaves);
        const auto simulation = simulationOf(flatWorld());
        Talker noisy(*simulation);
        Talker quiet(*simulation);
        QStringList lines;
        for (int tick = 0; tick < 100; ++tick) {
            for (int i = 0; i < 10'000; ++i)
                noisy.say("DRIVE {Left 1}");
            simulation->step();
            lines += logOf(*simulation);
        }
        quiet.say("DRIVE {Left 1}");
        simulation->step();
        lines += logOf(*simulation);
        if (leaves)
            simulation->disconnect(noisy.id());
        else
            simulation->sumUpLog();
        lines += logOf(*simulation);
        QVERIFY2(lines.size() > 50 && lines.size() < 400, qPrintable(QString::number(lines.size())));
        long said = 0;
        for (const QString& line : lines)
            if (line.startsWith("client 1: ") && line.endsWith("more sentences about it were left out"))
                said += line.section(' ', 2, 2).toLong();
            else if (line.startsWith("client 1: "))
                ++said;
        QCOMPARE(said, 1'000'000); // each is told or counted
        QVERIFY(lines.filter("client 2: ignored 'DRIVE ").size() == 1);
    }

    void controlBytesAreShown() {
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        talker.say("INIT {ClassName \x1b[2J\x07Un\x7fseen} {Name R1}");
        simulation->step();
        const QString log = logOf(*simulation).join('\n');
        QVERIFY2(log.contains("\\x1b[2J\\x07Un\\x7fseen"), qPrintable(log));
        for (const QChar c : log)
            QVERIFY(c == '\n' || c.unicode() >= 0x20);
    }

    void whoHoldsTheOthersUpTwiceLosesTheRight() {
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        const auto says = [&](const QString& answer) {
            for (const std::string& line : talker.hearText())
                if (QString::fromStdString(line) == answer)
                    return true;
            return false;
        };
        for (const bool again : {true, false}) {
            talker.say("LOCKSTEP {On true}");
            QVERIFY(says("NFO {Lockstep True}"));
            simulation->releaseFromLockstep(talker.id());
            QVERIFY(says("NFO {Lockstep False}"));
            QCOMPARE(simulation->mayStep(talker.id()), again);
        }
        logOf(*simulation);
        talker.say("LOCKSTEP {On true}");
        QVERIFY(says("NFO {Lockstep False}"));
        QVERIFY(!simulation->hasLockstepClients());
        QVERIFY(logOf(*simulation).join(' ').contains("refused LOCKSTEP"));
    }
};

USAR_TEST(tst_ServerLog)

} // namespace tst_server_log

#include "tst_server_log.moc"
