#include <cmath>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/agent/behavior_host.h"
#include "core/protocol/reader.h"
#include "robots/ers/descriptions.h"
#include "robots/ers/kicker.h"
#include "tests/suite/suite.h"

namespace tst_kicker {

using namespace usar;
using namespace usar::ers;

namespace {

agent::ParameterSet parametersWith(const std::map<std::string, agent::ParameterValue>& values) {
    return agent::ParameterSet::make(Settings::parameters.specs(), values).value();
}

const std::string nothing = "{Pos3D 0,0,0} {Visible false}";
const std::string ahead = "{Pos3D 1.0,0,0.0} {Visible true}";
const std::string right = "{Pos3D 1.0,0.4,0.0} {Visible true}";
const std::string left = "{Pos3D 1.0,-0.4,0.0} {Visible true}";
const std::string below = "{Pos3D 0.2,0,0.1} {Visible true}";

/// A behavior in its host, and what it said since the last look.
struct Dog {
    explicit Dog(const std::map<std::string, agent::ParameterValue>& values = {})
        : host(ErsRobot().createBehavior("ers/cpp", {{"R1", {}, {}}, parametersWith(values)}).value(), "ers/test") {}

    void hear(const std::string& text) { take(host.receive(reader.read(text))); }
    void tick(const std::string& ball = nothing) {
        now_s += 0.2;
        const std::string time = "{Time " + std::to_string(now_s) + "} ";
        if (!ball.empty())
            hear("SEN " + time + "{Type Helper} {Name Helper} " + ball);
        hear("STA {Type LeggedRobot} " + time);
    }
    void ticks(int count, const std::string& ball = nothing) {
        for (int i = 0; i < count; ++i)
            tick(ball);
    }
    void lie(double roll_rad, double pitch_rad) {
        hear("SEN {Type INS} {Name INS} {Location 0,0,0} {Orientation " + std::to_string(roll_rad) + "," +
             std::to_string(pitch_rad) + ",0}");
    }
    void take(agent::RunningBehavior::Output output) {
        for (agent::CausedCommand& caused : output.commands)
            commands.push_back(std::move(caused.command));
        for (const agent::Published& value : output.published) {
            if (const auto* status = std::get_if<agent::BehaviorStatus>(&value))
                state = status->state;
            if (const auto* event = std::get_if<agent::BehaviorEvent>(&value))
                events.push_back(event->text);
            if (const auto* end = std::get_if<agent::BehaviorFinished>(&value))
                ending = *end;
        }
    }
    /// The commands of this type since the last look.
    template <class Wanted>
    std::vector<Wanted> look() {
        std::vector<Wanted> found;
        for (const protocol::Command& command : commands)
            if (const auto* one = std::get_if<Wanted>(&command))
                found.push_back(*one);
        commands.clear();
        return found;
    }

    agent::BehaviorHost host;
    protocol::Reader reader;
    double now_s = 5.0;
    std::string state;
    std::vector<std::string> events;
    std::optional<agent::BehaviorFinished> ending;
    std::vector<protocol::Command> commands;
};

double targetOf(const protocol::MultiDrive& drive, const std::string& joint) {
    for (const protocol::JointAngleTarget& target : drive.joints)
        if (target.joint.text() == joint)
            return target.angle_rad;
    return std::nan("");
}

/// How far the thigh of a front leg swings to and fro in these moves.
double swingOf(const std::vector<protocol::MultiDrive>& moves, const std::string& leg) {
    double least_rad = 9.0, most_rad = -9.0;
    for (const protocol::MultiDrive& move : moves) {
        least_rad = std::min(least_rad, targetOf(move, leg + "Leg1"));
        most_rad = std::max(most_rad, targetOf(move, leg + "Leg1"));
    }
    return most_rad - least_rad;
}

} // namespace

class tst_Kicker : public QObject {
    Q_OBJECT

private slots:
    void isRightedWhenItLiesOnItsSide_data() {
        QTest::addColumn<double>("roll_rad");
        QTest::addColumn<double>("pitch_rad");
        QTest::addColumn<bool>("fallen");
        QTest::newRow("upright") << 0.0 << 0.0 << false;
        QTest::newRow("swaying") << 0.5 << -0.5 << false;
        QTest::newRow("leaning far") << 1.05 << 1.05 << false;
        QTest::newRow("on its side") << 1.15 << 0.0 << true;
        QTest::newRow("on its other side") << -1.15 << 0.0 << true;
        QTest::newRow("on its nose") << 0.0 << 1.15 << true;
        QTest::newRow("on its back") << 3.1 << 0.0 << true;
    }
    void isRightedWhenItLiesOnItsSide() {
        QFETCH(double, roll_rad);
        QFETCH(double, pitch_rad);
        QFETCH(bool, fallen);
        Dog dog;
        dog.ticks(10);
        dog.lie(roll_rad, pitch_rad);
        dog.commands.clear();
        dog.ticks(3);
        QCOMPARE(dog.state == "fallen over", fallen);
        QCOMPARE(dog.look<protocol::DriveSwitches>().size(), std::size_t(fallen ? 3 : 0));
        QCOMPARE(dog.events.size(), std::size_t(fallen ? 1 : 0)); // It is told once
        dog.lie(0.0, 0.0);
        dog.tick();
        QCOMPARE(dog.state == "standing up", fallen);
        dog.ticks(10);
        QVERIFY2(dog.state.starts_with("looking"), dog.state.c_str());
        QVERIFY(dog.look<protocol::DriveSwitches>().empty());
    }

    void looksWhereTheBallWasLost_data() {
        QTest::addColumn<QString>("ball");
        QTest::addColumn<bool>("to_the_right");
        QTest::newRow("on the right") << QString::fromStdString(right) << true;
        QTest::newRow("on the left") << QString::fromStdString(left) << false;
    }
    void looksWhereTheBallWasLost() {
        QFETCH(QString, ball);
        QFETCH(bool, to_the_right);
        Dog dog;
        dog.ticks(20, ball.toStdString());
        QCOMPARE(dog.state, std::string("walking to the ball"));
        dog.ticks(4);
        dog.commands.clear();
        dog.ticks(8);
        QCOMPARE(dog.state, std::string("looking around for the ball"));
        const auto moves = dog.look<protocol::MultiDrive>();
        QCOMPARE(swingOf(moves, "LF") > swingOf(moves, "RF"), to_the_right); // The outer paws step farther
    }

    void changesBetweenTightAndWideCircles() {
        Dog dog({{"circle_s", 4.0}});
        std::vector<std::string> states;
        for (int i = 0; i < 90; ++i) {
            dog.tick();
            if (states.empty() || states.back() != dog.state)
                states.push_back(dog.state);
        }
        QCOMPARE(states, (std::vector<std::string>{"standing up", "looking around for the ball", "looking for the ball",
                                                   "looking around for the ball", "looking for the ball",
                                                   "looking around for the ball"}));
    }

    void believesNoBallThatItCannotSee_data() {
        QTest::addColumn<QString>("ball");
        QTest::newRow("not visible") << "{Pos3D 1.0,0,0.1} {Visible false}";
        QTest::newRow("no word about it") << "{Pos3D 1.0,0,0.1}";
        QTest::newRow("nowhere") << "{Visible true}";
        QTest::newRow("in the camera") << "{Pos3D 0.02,0,0.1} {Visible true}";
        QTest::newRow("behind the camera") << "{Pos3D -1.0,0,0.1} {Visible true}";
    }
    void believesNoBallThatItCannotSee() {
        QFETCH(QString, ball);
        Dog dog;
        dog.ticks(20, ball.toStdString());
        QVERIFY2(dog.state.starts_with("looking"), dog.state.c_str());
    }

    void forgetsABallOfWhichItHearsNothingMore() {
        Dog dog;
        dog.ticks(20, ahead);
        dog.ticks(2, "");
        QCOMPARE(dog.state, std::string("walking to the ball"));
        dog.ticks(2, "");
        QVERIFY2(dog.state.starts_with("looking"), dog.state.c_str());
    }

    void standsWhilePaused() {
        Dog dog;
        dog.ticks(20, ahead);
        dog.take(dog.host.order(agent::Order::Pause));
        dog.ticks(2, ahead);
        dog.commands.clear();
        dog.ticks(8, ahead);
        QCOMPARE(dog.state, std::string("paused"));
        const auto moves = dog.look<protocol::MultiDrive>();
        QVERIFY(moves.size() >= 7);
        QVERIFY(swingOf(moves, "LF") < 1e-9 && swingOf(moves, "RF") < 1e-9);
        dog.take(dog.host.order(agent::Order::Resume));
        dog.tick(ahead);
        QCOMPARE(dog.state, std::string("walking to the ball"));
    }

    void endsAfterItsTimeAndCountsItsKicks() {
        Dog dog({{"play_time_s", 20.0}});
        dog.ticks(15, ahead);
        for (int kick = 0; kick < 2; ++kick) {
            dog.ticks(10, below);
            QCOMPARE(dog.state, std::string("at the ball"));
            dog.ticks(5);
            QCOMPARE(dog.state, std::string("kicking"));
        }
        QVERIFY(!dog.ending);
        dog.commands.clear();
        dog.ticks(60);
        QVERIFY(dog.ending && dog.ending->success && dog.host.finished());
        QCOMPARE(dog.ending->reason, std::string("Played for 20 s; the ball was at the paws 2 times."));
        const auto moves = dog.look<protocol::MultiDrive>();
        QCOMPARE(moves.back().joints.size(), std::size_t(12)); // It stands on four paws
        QVERIFY(std::isnan(targetOf(moves.back(), "HeadNod")));
    }

    void marksItsWayAsTheSettingsSay() {
        Dog dog({{"trace", false}});
        dog.ticks(5);
        QVERIFY(dog.look<protocol::Trace>().empty());
        dog.host.setParameters(parametersWith({{"trace", true}, {"trace_interval_s", 2.0}}));
        dog.ticks(5);
        const auto on = dog.look<protocol::Trace>();
        QCOMPARE(on.size(), std::size_t(1));
        QVERIFY(on[0] == (protocol::Trace{true, Seconds(2.0), protocol::TraceColor::Yellow}));
        dog.host.setParameters(parametersWith({{"trace", true}, {"trace_interval_s", 3.0}}));
        dog.ticks(5);
        QCOMPARE(dog.look<protocol::Trace>().at(0).interval, std::optional(Seconds(3.0)));
        dog.host.setParameters(parametersWith({{"trace", false}, {"trace_interval_s", 3.0}}));
        dog.ticks(5);
        const auto off = dog.look<protocol::Trace>();
        QCOMPARE(off.size(), std::size_t(1));
        QVERIFY(off[0] == protocol::Trace{false});
    }

    void bowsWithItsNodFirst_data() {
        QTest::addColumn<double>("down_rad");
        QTest::addColumn<double>("nod_rad");
        QTest::addColumn<double>("tilt_rad");
        QTest::newRow("up") << -0.5 << 0.0 << 0.0;
        QTest::newRow("ahead") << 0.0 << 0.0 << 0.0;
        QTest::newRow("a little") << 0.2 << -0.2 << 0.0;
        QTest::newRow("as far as the nod goes") << 0.25 << -0.25 << 0.0;
        QTest::newRow("farther") << 0.8 << -0.25 << -0.55;
        QTest::newRow("too far") << 2.0 << -0.25 << -0.95;
    }
    void bowsWithItsNodFirst() {
        QFETCH(double, down_rad);
        QFETCH(double, nod_rad);
        QFETCH(double, tilt_rad);
        protocol::MultiDrive drive;
        bowHead(drive, down_rad);
        QVERIFY(std::abs(targetOf(drive, "HeadNod") - nod_rad) < 1e-9);
        QVERIFY(std::abs(targetOf(drive, "HeadTilt") - tilt_rad) < 1e-9);
        QCOMPARE(targetOf(drive, "HeadPan"), 0.0);
    }

    void pointsALegStraightAtAPlaceThatIsTooFar() {
        protocol::MultiDrive drive;
        putPaw(drive, Leg::LeftHind, {0.3, 0.1});
        QVERIFY(std::abs(targetOf(drive, "LHLeg3")) < 1e-9);
        QVERIFY(std::abs(targetOf(drive, "LHLeg1") - std::atan2(0.3, 0.1)) < 1e-9);
    }

    void standsUpSlowlyAndStaysWithoutStrides() {
        Gait gait;
        double knee_rad = -1.0;
        for (int move = 1; move <= 30; ++move) {
            protocol::MultiDrive drive;
            QVERIFY(gait.next(Seconds(0.2 * move), {}, 0.012, drive));
            QCOMPARE(gait.standing(), move >= 8);
            const double bent_rad = targetOf(drive, "RFLeg3");
            QVERIFY(move <= 8 ? bent_rad > knee_rad : bent_rad == knee_rad);
            knee_rad = bent_rad;
            for (const char* leg : {"LF", "LH", "RH"})
                QCOMPARE(targetOf(drive, std::string(leg) + "Leg3"), bent_rad);
        }
    }

    void walksBackwardAsItWalksForward() {
        std::vector<double> forward_rad, backward_rad;
        for (const double stride_m : {0.04, -0.04}) {
            Gait gait;
            for (int move = 0; move < 40; ++move) {
                protocol::MultiDrive drive;
                QVERIFY(gait.next(Seconds(0.2 * move), {stride_m, stride_m}, 0.0, drive));
                (stride_m > 0.0 ? forward_rad : backward_rad).push_back(targetOf(drive, "LFLeg1"));
            }
        }
        // The second move puts the paw in front, or behind; the fourth the other way round.
        for (std::size_t move = 8; move + 2 < forward_rad.size(); ++move)
            QVERIFY(std::abs(forward_rad[move] - backward_rad[move + 2]) < 1e-9);
    }
};

USAR_TEST(tst_Kicker)

} // namespace tst_kicker

#include "tst_kicker.moc"
