#include <QObject>
#include <QString>
#include <QTest>

#include "core/protocol/trace_pen.h"
#include "core/sim/physics/scene.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_trace {

using namespace usar;
using namespace usar::sim;

class tst_Trace : public QObject {
    Q_OBJECT

private slots:
    void aPenMarksEachIntervalWhileItMoves() {
        protocol::TracePen pen;
        QVERIFY(!pen.markAt(Seconds{0.0}, Vec3::Zero()));
        pen.obey({true, Seconds{0.4}, protocol::TraceColor::Green});
        QCOMPARE(pen.markAt(Seconds{0.2}, Vec3::Zero()), std::optional(protocol::TraceColor::Green));
        QVERIFY(!pen.markAt(Seconds{0.4}, Vec3(1, 0, 0)));    // too soon
        QVERIFY(pen.markAt(Seconds{0.6}, Vec3(1, 0, 0)));     // 0.2 + 0.4, whatever rounding says
        QVERIFY(!pen.markAt(Seconds{2.0}, Vec3(1.02, 0, 0))); // too near
        QVERIFY(pen.markAt(Seconds{2.2}, Vec3(1.03, 0, 0)));
        QVERIFY(pen.markAt(Seconds{0.1}, Vec3(2, 0, 0))); // another run of the clock
        QVERIFY(!pen.markAt(Seconds{9.0}, Vec3::Constant(std::nan(""))));
        pen.obey({false, {}, {}});
        QVERIFY(!pen.markAt(Seconds{9.0}, Vec3(5, 0, 0)));
        pen.obey({true, {}, {}});
        QCOMPARE(pen.markAt(Seconds{9.0}, Vec3(5, 0, 0)), std::optional(protocol::TraceColor::Green));
    }

    void aRobotLeavesMarksBehindItInItsColor() {
        auto simulation = simulationOf(flatWorld());
        Talker robot(*simulation);
        robot.say(init_p2dx);
        robot.say("Trace {On true} {Interval 0.4} {Color Cyan}");
        robot.say("DRIVE {Left 3} {Right 3}");
        steps(*simulation, 25);
        const std::vector<TraceMark> marks = simulation->traceMarksSince(0);
        QVERIFY2(marks.size() >= 11 && marks.size() <= 13, qPrintable(QString::number(marks.size())));
        for (std::size_t i = 1; i < marks.size(); ++i) {
            QVERIFY(marks[i].position_in_map_m.x() > marks[i - 1].position_in_map_m.x());
            QCOMPARE(marks[i].color, protocol::TraceColor::Cyan);
            QCOMPARE(marks[i].robot_name, std::string("R1"));
        }
        QCOMPARE(simulation->traceMarksMade(), std::uint64_t(marks.size()));
        QVERIFY(simulation->traceMarksSince(marks.size() - 2) == std::vector(marks.end() - 2, marks.end()));
        QVERIFY(simulation->traceMarksSince(marks.size()).empty());
        robot.say("Trace {On false}");
        steps(*simulation, 5);
        QCOMPARE(simulation->traceMarksSince(0).size(), marks.size());
        for (const std::string& sentence : simulation->takeLog())
            QVERIFY2(sentence.find("ignored") == std::string::npos, sentence.c_str());
    }

    void aUdkServerDoesNotKnowTrace() {
        SimulationOptions options;
        options.profile = protocol::Dialect::Udk;
        auto simulation = simulationOf(flatWorld(), options);
        Talker robot(*simulation);
        robot.say(init_p2dx);
        robot.say("Trace {On true} {Interval 0.2} {Color Red}");
        robot.say("DRIVE {Left 3} {Right 3}");
        steps(*simulation, 10);
        QVERIFY(simulation->traceMarksSince(0).empty());
    }
};

USAR_TEST(tst_Trace)

} // namespace tst_trace

#include "tst_trace.moc"
