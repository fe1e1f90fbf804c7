#include <QObject>
#include <QString>
#include <QTest>

#include "core/agent/behavior_host.h"
#include "core/protocol/reader.h"
#include "robots/submarine/camera_sweep.h"
#include "robots/submarine/dead_reckoning.h"
#include "robots/submarine/descriptions.h"
#include "robots/submarine/level_rule.h"
#include "tests/suite/suite.h"

namespace tst_submarine_senses {

using namespace usar;
using namespace usar::submarine;

namespace {

/// A behavior in its host, spoken to by lines.
struct Sub {
    explicit Sub(const std::map<std::string, agent::ParameterValue>& values = {})
        : host(SubmarineRobot()
                   .createBehavior("submarine/cpp", {{"R1", {}, {}},
                                                     agent::ParameterSet::make(
                                                         SubmarineRobot().description().behaviors[0].parameters, values)
                                                         .value()})
                   .value(),
               "submarine/test") {}

    std::vector<protocol::Command> hear(const std::string& text) {
        const agent::BehaviorHost::Output output = host.receive(reader.read(text));
        std::vector<protocol::Command> commands;
        for (const agent::CausedCommand& caused : output.commands)
            commands.push_back(caused.command);
        for (const agent::Published& value : output.published)
            if (const auto* status = std::get_if<agent::BehaviorStatus>(&value))
                state = status->state;
        return commands;
    }
    std::vector<protocol::Command> tick() {
        now_s += 0.2;
        return hear("STA {Type NauticVehicle} {Time " + std::to_string(now_s) + "} {SternPlaneAngle 0}");
    }
    void echo(double range_m) {
        hear("SEN {Time " + std::to_string(now_s) + "} {Type Range} {Name Laser Range " + std::to_string(range_m) +
             "}");
    }

    agent::BehaviorHost host;
    protocol::Reader reader;
    double now_s = 10.0;
    std::string state;
};

template <class Wanted>
std::vector<Wanted> only(const std::vector<protocol::Command>& commands) {
    std::vector<Wanted> found;
    for (const protocol::Command& command : commands)
        if (const auto* one = std::get_if<Wanted>(&command))
            found.push_back(*one);
    return found;
}

const std::vector<std::pair<std::string, std::string>> answers{
    {"Robot", "CONF {Type NauticVehicle} {Name Submarine} {SteeringType VariableDepth} {Mass 37} {MaxPropellerSpeed "
              "100} {MaxRudderAngle 0.2} {MaxSternPlaneAngle 0.3}"},
    {"Camera", "CONF {Type Camera} {Name Camera} {CameraDefFov 1.4} {CameraMinFov 0.3} {CameraMaxFov 2.0}"},
    {"MisPkg", "CONF {Type MisPkg} {Name CameraPanTilt} {Link 1} {JointType Revolute} {MaxSpeed 1} {MaxTorque 20} "
               "{MinRange -1} {MaxRange 1.5} {Link 2} {JointType Revolute} {MaxSpeed 1} {MaxTorque 20} {MinRange -0.5} "
               "{MaxRange 0.7}"},
    {"Range", "CONF {Type Range} {Name Laser} {MaxRange 15} {MinRange 0.1}"}};

Echoes echoes(double last_m, double present_m) {
    return {last_m, present_m, Seconds(0.2)};
}

} // namespace

class tst_SubmarineSenses : public QObject {
    Q_OBJECT

private slots:
    void asksOneQuestionACallAndWaitsForTheAnswer() {
        Sub sub;
        for (const auto& [type, answer] : answers) {
            auto asked = only<protocol::GetConfiguration>(sub.tick());
            QCOMPARE(asked.size(), std::size_t(1));
            QCOMPARE(asked[0].type.text(), type);
            QVERIFY(only<protocol::GetConfiguration>(sub.tick()).empty()); // it waits
            QCOMPARE(sub.state, std::string("asking for its configuration"));
            sub.hear(answer);
            if (type != answers.back().first)
                QVERIFY(only<protocol::GetConfiguration>(sub.tick()).empty()); // that call took the answer
        }
        sub.echo(9.0);
        sub.tick();
        QCOMPARE(sub.state, std::string("descending, 9.0 m over the bottom"));
    }

    void drivesWithinTheLimitsThatItLearnt() {
        Sub sub({{"propeller_pct", 50.0}});
        learn(sub);
        sub.echo(12.0);
        const auto drives = only<protocol::NauticDrive>(sub.tick());
        QCOMPARE(drives.size(), std::size_t(1));
        QCOMPARE(*drives[0].propeller_rad_s, 50.0);
        QCOMPARE(*drives[0].stern_plane_rad, -0.3);
    }

    void turnsByTheRudderWhereItIsLevelAndToTheOtherSideAfterAWhile() {
        Sub sub;
        learn(sub);
        std::map<double, int> ticks; // by the rudder
        for (int i = 0; i < 1000; ++i) {
            sub.echo(4.0);
            ++ticks[*only<protocol::NauticDrive>(sub.tick()).at(0).rudder_rad];
        }
        QCOMPARE(ticks.size(), std::size_t(2));
        QVERIFY(ticks[0.2] > 450 && ticks[-0.2] > 450);
    }

    void looksAroundWithinTheLimitsOfItsMount() {
        Sub sub;
        learn(sub);
        double lowest = 9.0, highest = -9.0, narrowest = 9.0, widest = -9.0;
        for (int i = 0; i < 1500; ++i) {
            sub.echo(4.0);
            const auto commands = sub.tick();
            for (const auto& move : only<protocol::PackageDrive>(commands)) {
                QVERIFY(move.links.at(0).value >= -1.0 && move.links.at(0).value <= 1.5);
                QVERIFY(move.links.at(1).value >= -0.5 && move.links.at(1).value <= 0.7);
                lowest = std::min(lowest, move.links[0].value);
                highest = std::max(highest, move.links[0].value);
            }
            for (const auto& zoom : only<protocol::ZoomCamera>(commands)) {
                QVERIFY(zoom.field_of_view_rad >= 0.3 && zoom.field_of_view_rad <= 2.0);
                narrowest = std::min(narrowest, zoom.field_of_view_rad);
                widest = std::max(widest, zoom.field_of_view_rad);
            }
        }
        QVERIFY(lowest < -0.8 && highest > 1.3);
        QVERIFY(narrowest < 0.6 && widest > 1.7);
    }

    void waitsWhileItsRayIsSilent() {
        Sub sub;
        learn(sub);
        sub.echo(6.0);
        QVERIFY(*only<protocol::NauticDrive>(sub.tick()).at(0).propeller_rad_s > 0.0);
        for (int i = 0; i < 50; ++i)
            sub.tick();
        QVERIFY(*only<protocol::NauticDrive>(sub.tick()).at(0).propeller_rad_s <= 0.0);
        for (int i = 0; i < 200; ++i)
            sub.tick();
        QCOMPARE(*only<protocol::NauticDrive>(sub.tick()).at(0).propeller_rad_s, 0.0);
        QVERIFY(sub.state.starts_with("waiting for the ray"));
    }

    void backsOffBelowHalfAMeterAndFromABottomThatRisesFast_data() {
        QTest::addColumn<double>("height_m");
        QTest::addColumn<double>("rise_m_s");
        QTest::addColumn<bool>("near");
        QTest::newRow("near") << 0.45 << 0.0 << true;
        QTest::newRow("rising fast") << 3.0 << 1.0 << true;
        QTest::newRow("rising slowly") << 3.0 << 0.3 << false;
        QTest::newRow("falling") << 0.7 << -1.0 << false;
    }
    void backsOffBelowHalfAMeterAndFromABottomThatRisesFast() {
        QFETCH(double, height_m);
        QFETCH(double, rise_m_s);
        QFETCH(bool, near);
        QCOMPARE(tooNear(echoes(height_m, height_m), rise_m_s, Seconds(3.0), {}), near);
    }

    void goesBackWhereItsRayLosesTheBottomThatItCouldFollow_data() {
        QTest::addColumn<int>("ticks");
        QTest::addColumn<QString>("state");
        QTest::newRow("for a long way") << 400 << "going back";
        QTest::newRow("never") << 0 << "looking for the bottom";
    }
    void goesBackWhereItsRayLosesTheBottomThatItCouldFollow() {
        QFETCH(int, ticks);
        QFETCH(QString, state);
        Sub sub;
        learn(sub);
        for (int i = 0; i < ticks; ++i) {
            sub.echo(4.0);
            sub.tick();
        }
        sub.echo(15.0); // the end of its reach
        sub.tick();
        sub.tick();
        QCOMPARE(sub.state, state.toStdString());
    }

    void remembersPlacesBehindIt() {
        Trail trail;
        QVERIFY(!trail.placeBehind(30.0));
        for (int i = 0; i < 60; ++i) {
            trail.keepPlace();
            trail.step(1.0, 0.0);
        }
        QVERIFY(std::abs(trail.distanceTo_m(trail.placeBehind(80.0).value()) - 60.0) < 1e-9); // the oldest
        const auto place_m = trail.placeBehind(30.0);
        QVERIFY(place_m);
        QVERIFY(std::abs(trail.distanceTo_m(*place_m) - 32.0) < 2.1);
        QVERIFY(std::abs(trail.bearingOf_rad(*place_m)) > radians(179.0));
    }

    void comesBackToAPlaceByItsOwnReckoning() {
        Trail trail;
        trail.keepPlace();
        for (int i = 0; i < 400; ++i)
            trail.step(0.1, 0.5);
        for (int i = 0; i < 400; ++i)
            trail.step(0.1, -0.5);
        for (int i = 0; i < 300; ++i)
            trail.step(0.1, 0.0);
        const Vec2 place_m = trail.placeBehind(20.0).value();
        for (int i = 0; i < 3000 && trail.distanceTo_m(place_m) > 5.0; ++i)
            trail.step(0.1, std::clamp(-trail.bearingOf_rad(place_m) / 0.3, -1.0, 1.0));
        QVERIFY(trail.distanceTo_m(place_m) <= 5.0);
    }

    void theThesissRuleMovesThePlanesOnlyWhereTheRayGoesTheWrongWay() {
        const Settings settings;
        QCOMPARE(plumbPlane_rad(echoes(8.0, 8.1), settings, 0.0, 0.3), -0.3);
        QCOMPARE(plumbPlane_rad(echoes(8.1, 8.0), settings, -0.1, 0.3), -0.1);
        QCOMPARE(plumbPlane_rad(echoes(2.1, 2.0), settings, 0.0, 0.3), 0.3);
        QCOMPARE(plumbPlane_rad(echoes(2.0, 2.1), settings, 0.2, 0.3), 0.2);
        QCOMPARE(plumbPlane_rad(echoes(4.0, 4.1), settings, 0.2, 0.3), 0.0);
    }

    void neverWantsToDiveSteeperThanTheSettingsAllow() {
        const Settings settings;
        QCOMPARE(wantedPitch_rad(echoes(15.0, 15.0), 0.0, 1.2, settings), -settings.steepest_dive_rad);
        QCOMPARE(wantedPitch_rad({}, 0.0, 1.2, settings), -settings.steepest_dive_rad);
        QCOMPARE(wantedPitch_rad(echoes(1.0, 1.0), 0.5, 1.2, settings), settings.steepest_climb_rad);
        QVERIFY(std::abs(wantedPitch_rad(echoes(4.0, 4.0), 0.0, 1.2, settings)) < 1e-9);
        QVERIFY(wantedPitch_rad(echoes(4.0, 4.0), 0.3, 1.2, settings) > radians(10.0)); // the bottom rises
    }

    void reckonsThePitchThatItsPlanesHold() {
        PitchModel hull;
        for (int i = 0; i < 300; ++i)
            hull.step(Seconds(0.2), 0.8, std::clamp(hull.planeFor_rad(radians(-12.0)), -0.35, 0.35));
        QVERIFY(std::abs(hull.pitch_rad() - radians(-12.0)) < radians(1.0));
        QVERIFY(std::abs(hull.speed_m_s() - 1.28) < 0.02);
        QVERIFY2(hull.climb_m_s() < -0.1 && hull.climb_m_s() > -0.2, "its planes hold it up"); // points at -0.27 m/s
        for (int i = 0; i < 300; ++i)
            hull.step(Seconds(0.2), 0.0, 0.0);
        QVERIFY(std::abs(hull.pitch_rad()) < radians(2.0)); // it rights itself
    }

private:
    static void learn(Sub& sub) {
        for (const auto& answer : answers) {
            sub.tick();
            sub.hear(answer.second);
            sub.tick();
        }
    }
};

USAR_TEST(tst_SubmarineSenses)

} // namespace tst_submarine_senses

#include "tst_submarine_senses.moc"
