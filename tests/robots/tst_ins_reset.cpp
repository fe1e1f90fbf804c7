#include <optional>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/ins_reset.h"
#include "tests/suite/suite.h"

namespace tst_ins_reset {

using namespace usar;
using namespace usar::airrobot;

class tst_InsReset : public QObject {
    Q_OBJECT

    std::optional<modules::RobotModules> robot;
    agent::CommandPort port;
    Settings settings;
    std::uint64_t line = 0;
    double now_s = 0.0;

    void tell(protocol::InfoMessage message) { robot->take({LineNumber{++line}, "", std::move(message), {}}); }
    void tick(InsReset& reset, const Vec3& truth_m, const Vec3& ins_m) {
        now_s += 0.2;
        tell(protocol::InsReading{{}, "INS", Pose{ins_m, 0, 0, 0}});
        tell(protocol::GroundTruthReading{Seconds(now_s), "GroundTruth", Pose{truth_m, 0, 0, 1.0}});
        protocol::RobotState state;
        state.time = Seconds(now_s);
        tell(state);
        reset.step(Seconds(now_s), *robot, port, settings);
    }
    std::vector<protocol::SetInsPose> sent() {
        std::vector<protocol::SetInsPose> found;
        for (const auto& caused : port.takeCommands())
            found.push_back(std::get<protocol::SetInsPose>(caused.command));
        return found;
    }

private slots:
    void init() {
        robot.emplace();
        port = {};
        settings = {};
        line = 0;
        now_s = 100.0;
    }

    void waitsAtRestThenSetsTheTruth() {
        InsReset reset;
        reset.start(Seconds(now_s));
        for (int i = 0; i < 18; ++i)
            tick(reset, {1, 2, 3}, {2, 2, 3});
        QVERIFY(sent().empty());
        for (int i = 0; i < 6; ++i)
            tick(reset, {1, 2, 3}, {2, 2, 3});
        const auto commands = sent();
        QCOMPARE(commands.size(), std::size_t(1));
        QCOMPARE(commands[0].sensor_name, std::string("INS"));
        QCOMPARE(commands[0].base_in_map.position_m, Vec3(1, 2, 3));
        QCOMPARE(commands[0].base_in_map.yaw_rad, 1.0);
        QCOMPARE(reset.state(), ResetState::Waiting);
    }

    void startsItsRestAnewWhenTheRobotIsMoved() {
        InsReset reset;
        reset.start(Seconds(now_s));
        for (int i = 0; i < 60; ++i)
            tick(reset, {0.1 * i, 0, 0}, {0, 0, 0});
        QVERIFY(sent().empty());
        QCOMPARE(reset.state(), ResetState::Resting);
    }

    void failsWhereTheRobotFindsNoRest() {
        InsReset reset;
        reset.start(Seconds(now_s));
        for (int i = 0; i < 500 && reset.state() == ResetState::Resting; ++i)
            tick(reset, {0.1 * i, 0, 0}, {0, 0, 0});
        QVERIFY(sent().empty());
        QCOMPARE(reset.state(), ResetState::Failed);
    }

    void waitsForARestThatHasBegun() {
        InsReset reset;
        reset.start(Seconds(now_s));
        for (int i = 0; i < 295; ++i)
            tick(reset, {0.1 * i, 0, 0}, {0, 0, 0});
        for (int i = 0; i < 30 && sent().empty(); ++i)
            tick(reset, {29.4, 0, 0}, {0, 0, 0});
        QCOMPARE(reset.state(), ResetState::Waiting);
    }

    void isDoneWhenTheServerSaysOk() {
        InsReset reset;
        reset.start(Seconds(now_s));
        while (reset.state() == ResetState::Resting)
            tick(reset, {1, 2, 3}, {2, 2, 3});
        tell(protocol::Response{Seconds(now_s), "INS", "INS", true});
        tick(reset, {1, 2, 3}, {2, 2, 3});
        QCOMPARE(reset.state(), ResetState::Done);
    }

    void triesAgainUnlessTheAnswerIsOk_data() {
        QTest::addColumn<bool>("answers");
        QTest::newRow("the server refuses") << true;
        QTest::newRow("the server is silent") << false;
    }
    void triesAgainUnlessTheAnswerIsOk() {
        QFETCH(bool, answers);
        settings.reset_attempts = 3;
        InsReset reset;
        reset.start(Seconds(now_s));
        for (int i = 0; i < 100; ++i) {
            if (answers)
                tell(protocol::Response{Seconds(now_s), "INS", "INS", false});
            tick(reset, {1, 2, 3}, {2, 2, 3});
        }
        QCOMPARE(sent().size(), std::size_t(3));
        QCOMPARE(reset.state(), ResetState::Failed);
    }

    void believesTheSensorWhereNoAnswerComes() {
        InsReset reset;
        reset.start(Seconds(now_s));
        while (reset.state() == ResetState::Resting)
            tick(reset, {1, 2, 3}, {2, 2, 3});
        for (int i = 0; i < 3; ++i)
            tick(reset, {1, 2, 3}, {1, 2, 3});
        QCOMPARE(reset.state(), ResetState::Done);
    }

    void failsWithoutGroundTruth() {
        InsReset reset;
        reset.start(Seconds(now_s));
        for (int i = 0; i < 40 && reset.state() != ResetState::Failed; ++i)
            reset.step(Seconds(now_s += 0.2), *robot, port, settings);
        QCOMPARE(reset.state(), ResetState::Failed);
        QVERIFY(sent().empty());
    }

    void doesNothingBeforeItIsStarted() {
        InsReset reset;
        for (int i = 0; i < 100; ++i)
            tick(reset, {1, 2, 3}, {2, 2, 3});
        QCOMPARE(reset.state(), ResetState::Idle);
        QVERIFY(sent().empty());
    }
};

USAR_TEST(tst_InsReset)

} // namespace tst_ins_reset

#include "tst_ins_reset.moc"
