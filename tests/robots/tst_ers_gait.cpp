#include <QObject>
#include <QTest>

#include "core/agent/behavior_host.h"
#include "core/protocol/reader.h"
#include "robots/ers/descriptions.h"
#include "robots/ers/gait.h"
#include "tests/suite/suite.h"

namespace tst_ers_gait {

using namespace usar;
using namespace usar::ers;

namespace {

double angleOf(const protocol::MultiDrive& drive, const std::string& joint) {
    for (const protocol::JointAngleTarget& target : drive.joints)
        if (target.joint.text() == joint)
            return target.angle_rad;
    return std::nan("");
}

/// Where a leg's joints put its paw.
PawPlace pawOf(const protocol::MultiDrive& drive, const std::string& leg) {
    const double thigh_rad = angleOf(drive, leg + "Leg1");
    const double shin_rad = thigh_rad - angleOf(drive, leg + "Leg3");
    return {0.071 * std::sin(thigh_rad) + 0.072 * std::sin(shin_rad),
            0.071 * std::cos(thigh_rad) + 0.072 * std::cos(shin_rad)};
}

/// A behavior in its host, and a ball that it sees or not.
struct Dog {
    agent::BehaviorHost host{
        ErsRobot()
            .createBehavior(
                "ers/cpp",
                {{"R1", {}, {}}, agent::ParameterSet::make(ErsRobot().description().behaviors[0].parameters).value()})
            .value(),
        "ers/test"};
    protocol::Reader reader;
    double now_s = 5.0;
    std::string state;
    std::vector<protocol::Command> commands;

    void tick(const std::string& ball) {
        now_s += 0.2;
        const std::string time = "{Time " + std::to_string(now_s) + "} ";
        host.receive(reader.read("SEN " + time + "{Type Helper} {Name Helper} " + ball));
        const auto output = host.receive(reader.read("STA {Type LeggedRobot} " + time));
        commands.clear();
        for (const agent::CausedCommand& caused : output.commands)
            commands.push_back(caused.command);
        for (const agent::Published& value : output.published)
            if (const auto* status = std::get_if<agent::BehaviorStatus>(&value))
                state = status->state;
    }
    void ticks(int count, const std::string& ball) {
        for (int i = 0; i < count; ++i)
            tick(ball);
    }
    /// The longest step of the left and right front paws in a cycle.
    Strides strides(const std::string& ball) {
        double low[2] = {9.0, 9.0}, high[2] = {-9.0, -9.0};
        for (int i = 0; i < 8; ++i) {
            tick(ball);
            for (const protocol::Command& command : commands)
                if (const auto* drive = std::get_if<protocol::MultiDrive>(&command))
                    for (int side = 0; side < 2; ++side) {
                        const double x_m = pawOf(*drive, side == 0 ? "LF" : "RF").forward_m;
                        low[side] = std::min(low[side], x_m);
                        high[side] = std::max(high[side], x_m);
                    }
        }
        return {high[0] - low[0], high[1] - low[1]};
    }
};

const std::string nothing = "{Pos3D 0,0,0} {Visible false}";
const std::string ahead = "{Pos3D 1.0,0,0.1} {Visible true}";
const std::string right = "{Pos3D 1.0,0.4,0.1} {Visible true}";
const std::string left = "{Pos3D 1.0,-0.4,0.1} {Visible true}";
const std::string below = "{Pos3D 0.2,0,0.1} {Visible true}";

} // namespace

class tst_ErsGait : public QObject {
    Q_OBJECT

private slots:
    void putsAPawWhereItIsTold_data() {
        QTest::addColumn<double>("forward_m");
        QTest::addColumn<double>("down_m");
        QTest::newRow("standing") << standing_paw.forward_m << standing_paw.down_m;
        QTest::newRow("in front") << 0.05 << 0.11;
        QTest::newRow("behind") << -0.04 << 0.1;
    }
    void putsAPawWhereItIsTold() {
        QFETCH(double, forward_m);
        QFETCH(double, down_m);
        protocol::MultiDrive drive;
        putPaw(drive, Leg::RightHind, {forward_m, down_m});
        QCOMPARE(drive.joints.size(), std::size_t(3));
        QVERIFY(std::abs(pawOf(drive, "RH").forward_m - forward_m) < 1e-6);
        QVERIFY(std::abs(pawOf(drive, "RH").down_m - down_m) < 1e-6);
    }

    void twoPawsOnADiagonalAreOnTheGroundAtEveryMoment() {
        Gait gait;
        Seconds now{0.0};
        int lifted_moves = 0;
        for (int move = 0; move < 40; ++move, now += Seconds(0.2)) {
            protocol::MultiDrive drive;
            QVERIFY(gait.next(now, {0.05, 0.05}, 0.012, drive));
            QVERIFY(!gait.next(now + Seconds(0.1), {0.05, 0.05}, 0.012, drive)); // too soon
            if (move < 8)
                continue;
            const auto lifted = [&](const char* leg) { return pawOf(drive, leg).down_m < 0.105; };
            QCOMPARE(lifted("LF"), lifted("RH"));
            QCOMPARE(lifted("RF"), lifted("LH"));
            QVERIFY(!(lifted("LF") && lifted("RF")));
            lifted_moves += lifted("LF") || lifted("RF") ? 1 : 0;
        }
        QCOMPARE(lifted_moves, 16);
    }

    void marksItsWayOnce() {
        Dog dog;
        dog.tick(nothing);
        const auto traces = [&] {
            return std::ranges::count_if(dog.commands,
                                         [](const auto& one) { return std::holds_alternative<protocol::Trace>(one); });
        };
        QCOMPARE(traces(), 1);
        dog.tick(nothing);
        QCOMPARE(traces(), 0);
    }

    void circlesUntilItSeesTheBallAndSteersOnItsImage() {
        Dog dog;
        dog.ticks(10, nothing);
        QVERIFY2(dog.state.starts_with("looking around"), dog.state.c_str());
        const Strides straight = dog.strides(ahead);
        QCOMPARE(dog.state, std::string("walking to the ball"));
        QVERIFY(std::abs(straight.left_m - straight.right_m) < 1e-6);
        const Strides to_right = dog.strides(right);
        QVERIFY(to_right.left_m > to_right.right_m + 0.01);
        const Strides to_left = dog.strides(left);
        QVERIFY(to_left.right_m > to_left.left_m + 0.01);
    }

    void lowersItsHeadAtANearBallAndKicksByWalkingOn() {
        Dog dog;
        dog.ticks(10, ahead);
        dog.ticks(6, below);
        QCOMPARE(dog.state, std::string("at the ball"));
        for (const protocol::Command& command : dog.commands)
            if (const auto* drive = std::get_if<protocol::MultiDrive>(&command))
                QVERIFY(angleOf(*drive, "HeadNod") + angleOf(*drive, "HeadTilt") < radians(-25.0));
        dog.ticks(3, nothing);
        QCOMPARE(dog.state, std::string("kicking"));
        dog.ticks(30, nothing);
        QVERIFY2(dog.state.starts_with("looking"), dog.state.c_str());
    }
};

USAR_TEST(tst_ErsGait)

} // namespace tst_ers_gait

#include "tst_ers_gait.moc"
