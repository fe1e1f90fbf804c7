#include <cmath>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/base/random.h"
#include "core/protocol/reader.h"
#include "robots/submarine/camera_sweep.h"
#include "robots/submarine/dead_reckoning.h"
#include "robots/submarine/level_rule.h"
#include "tests/suite/suite.h"

namespace tst_diver_rules {

using namespace usar;
using namespace usar::submarine;

namespace {

Echoes echo(double present_m) {
    return {present_m, present_m, Seconds(0.2)};
}

bool near(double value, double expected, double tolerance = 1e-9) {
    return std::abs(value - expected) <= tolerance;
}

protocol::PackageConfiguration mountOf(const std::vector<protocol::LinkConfiguration>& links) {
    return {"CameraPanTilt", links};
}

protocol::LinkConfiguration link(int number, double smallest, double largest, std::optional<double> speed = 1.0) {
    return {number, false, speed, {}, smallest, largest};
}

/// The values of this link in the commands of a sweep over `duration`, with their times.
std::vector<std::pair<Seconds, double>> sweep(const Limits& limits, Seconds half, Seconds duration, std::size_t index) {
    CameraSweep camera;
    std::vector<std::pair<Seconds, double>> values;
    for (Seconds now(50.0); now < Seconds(50.0) + duration; now += Seconds(0.25))
        if (const auto command = camera.next(now, half, limits))
            if (const auto* move = std::get_if<protocol::PackageDrive>(&*command))
                values.emplace_back(now, move->links.at(index).value);
    return values;
}

} // namespace

class tst_DiverRules : public QObject {
    Q_OBJECT

    const Settings settings; // 4 m, level within 0.6 m

private slots:
    void knowsWhereItIsTooHighOrTooLow_data() {
        QTest::addColumn<double>("height_m");
        QTest::addColumn<int>("level");
        QTest::newRow("at its height") << 4.0 << int(Level::Keep);
        QTest::newRow("at the top of the band") << 4.59 << int(Level::Keep);
        QTest::newRow("above the band") << 4.61 << int(Level::Descend);
        QTest::newRow("at the bottom of the band") << 3.41 << int(Level::Keep);
        QTest::newRow("below the band") << 3.39 << int(Level::Ascend);
        QTest::newRow("on the bottom") << 0.0 << int(Level::Ascend);
    }
    void knowsWhereItIsTooHighOrTooLow() {
        QFETCH(double, height_m);
        QFETCH(int, level);
        QCOMPARE(int(levelOf(echo(height_m), settings)), level);
        QCOMPARE(int(levelOf({height_m, {}, Seconds(0.2)}, settings)), int(Level::Descend)); // Now it hears nothing
    }

    void measuresItsClimbBetweenTwoEchoes_data() {
        QTest::addColumn<bool>("first");
        QTest::addColumn<bool>("second");
        QTest::addColumn<double>("apart_s");
        QTest::addColumn<double>("climb_m_s");
        QTest::newRow("half a second") << true << true << 0.5 << 2.0;
        QTest::newRow("a tick") << true << true << 0.2 << 5.0;
        QTest::newRow("at one time") << true << true << 0.0 << 0.0;
        QTest::newRow("time went backward") << true << true << -0.2 << 0.0;
        QTest::newRow("the first echo") << false << true << 0.2 << 0.0;
        QTest::newRow("the bottom is lost") << true << false << 0.2 << 0.0;
    }
    void measuresItsClimbBetweenTwoEchoes() {
        QFETCH(bool, first);
        QFETCH(bool, second);
        QFETCH(double, apart_s);
        QFETCH(double, climb_m_s);
        Echoes echoes{2.0, 3.0, Seconds(apart_s)};
        if (!first)
            echoes.last_m.reset();
        if (!second)
            echoes.present_m.reset();
        QVERIFY(near(echoes.climb_m_s(), climb_m_s));
    }

    void correctsEachEchoByThePitchAtItsTime() {
        const Echoes heights = plumb({8.0, 6.0, Seconds(0.3)}, radians(60.0), radians(-60.0));
        QVERIFY(near(*heights.last_m, 4.0) && near(*heights.present_m, 3.0));
        QCOMPARE(heights.apart, Seconds(0.3));
        const Echoes lost = plumb({8.0, {}, Seconds(0.3)}, 0.0, 1.0);
        QCOMPARE(*lost.last_m, 8.0);
        QVERIFY(!lost.present_m);
        QVERIFY(!plumb({}, 1.0, 1.0).last_m);
    }

    void seesNoDangerWithoutABottomAndNoHelpInOneThatFalls_data() {
        QTest::addColumn<double>("height_m");
        QTest::addColumn<double>("rise_m_s");
        QTest::addColumn<double>("foresight_s");
        QTest::addColumn<bool>("near");
        QTest::newRow("just above the least height") << 0.51 << 0.0 << 7.5 << false;
        QTest::newRow("just below it") << 0.49 << 0.0 << 7.5 << true;
        QTest::newRow("there in time") << 4.0 << 0.5 << 7.5 << true;
        QTest::newRow("not yet there") << 4.0 << 0.4 << 7.5 << false;
        QTest::newRow("the same without foresight") << 4.0 << 0.5 << 0.0 << false;
        QTest::newRow("below it over a falling bottom") << 0.49 << -5.0 << 7.5 << true;
    }
    void seesNoDangerWithoutABottomAndNoHelpInOneThatFalls() {
        QFETCH(double, height_m);
        QFETCH(double, rise_m_s);
        QFETCH(double, foresight_s);
        QFETCH(bool, near);
        QCOMPARE(tooNear(echo(height_m), rise_m_s, Seconds(foresight_s), settings), near);
        QVERIFY(!tooNear({}, rise_m_s, Seconds(foresight_s), settings));
    }

    void pitchesMoreTheFartherItIsFromItsHeight() {
        Random random = seeded(11, 1);
        for (int i = 0; i < 2000; ++i) {
            const double height_m = uniform(random, 0.0, 20.0);
            const double rise_m_s = uniform(random, -1.0, 1.0);
            const double speed_m_s = uniform(random, -0.5, 1.6);
            const double pitch_rad = wantedPitch_rad(echo(height_m), rise_m_s, speed_m_s, settings);
            QVERIFY(pitch_rad >= -settings.steepest_dive_rad && pitch_rad <= settings.steepest_climb_rad);
            QVERIFY(wantedPitch_rad(echo(height_m + 0.5), rise_m_s, speed_m_s, settings) <= pitch_rad);
            QVERIFY(wantedPitch_rad(echo(height_m), rise_m_s + 0.1, speed_m_s, settings) >= pitch_rad);
            QVERIFY(std::abs(wantedPitch_rad(echo(height_m), rise_m_s, 1.6, settings)) <= std::abs(pitch_rad) + 1e-12);
        }
    }

    void climbsAtTheRateThatItWants() {
        // One meter too low: 0.2 m/s are wanted, and the hull climbs with 0.6 of the sine of its pitch.
        QVERIFY(near(wantedPitch_rad(echo(3.0), 0.0, 1.0, settings), std::asin(0.2 / 0.6)));
        QVERIFY(near(wantedPitch_rad(echo(5.0), 0.1, 1.0, settings), std::asin(-0.1 / 0.6)));
        const double slow_rad = wantedPitch_rad(echo(3.9), 0.0, 0.4, settings);
        for (const double speed_m_s : {0.0, 0.2, -1.0}) // Not steeper than at the least speed
            QCOMPARE(wantedPitch_rad(echo(3.9), 0.0, speed_m_s, settings), slow_rad);
    }

    void theThesissRuleMovesPlanesOnlyToTheirLimitsOrLeavesThem() {
        Random random = seeded(12, 1);
        for (int i = 0; i < 2000; ++i) {
            const Echoes echoes{uniform(random, 0.0, 10.0), uniform(random, 0.0, 10.0), Seconds(0.2)};
            const double angle_rad = plumbPlane_rad(echoes, settings, 0.123, 0.35);
            const bool closer = (*echoes.present_m < *echoes.last_m) == (*echoes.present_m > settings.height_m);
            if (levelOf(echoes, settings) == Level::Keep)
                QCOMPARE(angle_rad, 0.0);
            else if (closer)
                QCOMPARE(angle_rad, 0.123);
            else
                QCOMPARE(angle_rad, *echoes.present_m > settings.height_m ? -0.35 : 0.35);
        }
    }

    void reachesTheSpeedAtWhichDragBalancesThrust_data() {
        QTest::addColumn<double>("share");
        for (const double share : {1.0, 0.8, 0.4, 0.0, -0.5, -1.0})
            QTest::addRow("%g of the propeller's speed", share) << share;
    }
    void reachesTheSpeedAtWhichDragBalancesThrust() {
        QFETCH(double, share);
        PitchModel hull;
        for (int i = 0; i < 1500; ++i)
            hull.step(Seconds(0.2), share, 0.0);
        QVERIFY(near(hull.speed_m_s(), share * std::sqrt(10.0 / 3.9), 0.005));
        QVERIFY(near(hull.pitch_rad(), 0.0) && near(hull.climb_m_s(), 0.0));
    }

    void reckonsTheSameInLongAndInShortTicks() {
        PitchModel usual, quick, slow;
        for (int i = 0; i < 1000; ++i) {
            const double plane_rad = i < 500 ? 0.1 : -0.2;
            quick.step(Seconds(0.02), 1.0, plane_rad);
            if (i % 10 == 9)
                usual.step(Seconds(0.2), 1.0, plane_rad);
            if (i % 50 == 49)
                slow.step(Seconds(1.0), 1.0, plane_rad);
        }
        for (const PitchModel* hull : {&usual, &slow}) {
            QVERIFY(near(hull->speed_m_s(), quick.speed_m_s(), 0.01));
            QVERIFY(near(hull->pitch_rad(), quick.pitch_rad(), 0.01));
            QVERIFY(near(hull->climb_m_s(), quick.climb_m_s(), 0.01));
        }
        const PitchModel before = quick;
        quick.step(Seconds(0.0), 1.0, 0.3);
        QCOMPARE(quick.speed_m_s(), before.speed_m_s());
        QCOMPARE(quick.pitch_rad(), before.pitch_rad());
    }

    void movesItsPlanesTheOtherWayWhenItGoesAstern() {
        PitchModel ahead, astern;
        for (int i = 0; i < 100; ++i) {
            ahead.step(Seconds(0.2), 1.0, 0.0);
            astern.step(Seconds(0.2), -1.0, 0.0);
        }
        QVERIFY(ahead.planeFor_rad(0.1) > 0.0);
        QVERIFY(near(astern.planeFor_rad(0.1), -ahead.planeFor_rad(0.1), 1e-6));
        QVERIFY(near(ahead.planeFor_rad(0.0), 0.0));
        QVERIFY(std::isfinite(PitchModel().planeFor_rad(0.1))); // At rest its planes have no effect
    }

    void turnsWithTheRootOfItsRudder_data() {
        QTest::addColumn<double>("rudder_share");
        QTest::addColumn<double>("turn_rad");
        QTest::newRow("hard right") << 1.0 << -1.255;
        QTest::newRow("a quarter to the right") << 0.25 << -0.6275;
        QTest::newRow("amidships") << 0.0 << 0.0;
        QTest::newRow("a quarter to the left") << -0.25 << 0.6275;
        QTest::newRow("hard left") << -1.0 << 1.255;
    }
    void turnsWithTheRootOfItsRudder() {
        QFETCH(double, rudder_share);
        QFETCH(double, turn_rad);
        Trail trail;
        for (int i = 0; i < 100; ++i)
            trail.step(0.1, rudder_share);
        QVERIFY(near(trail.bearingOf_rad({1e9, 0.0}), -turn_rad, 1e-6)); // A place far ahead of its start
    }

    void comesFullCircleWithItsRudderHardOver() {
        Trail trail;
        constexpr double radius_m = 1.0 / 0.1255;
        for (int i = 0; i < 1252; ++i) // A quarter
            trail.step(0.01, 1.0);
        QVERIFY(near(trail.distanceTo_m({0.0, 0.0}), std::sqrt(2.0) * radius_m, 0.05));
        QVERIFY(near(trail.bearingOf_rad({0.0, 0.0}), radians(-135.0), 0.02));
        for (int i = 1252; i < 5007; ++i)
            trail.step(0.01, 1.0);
        QVERIFY(trail.distanceTo_m({0.0, 0.0}) < 0.1);
    }

    void remembersTheNewestPlacesThatAreApart() {
        Trail trail;
        trail.keepPlace();
        trail.step(3.9, 0.0);
        trail.keepPlace(); // Too near to the first
        QVERIFY(near(trail.distanceTo_m(trail.placeBehind(0.0).value()), 3.9));
        trail.step(0.2, 0.0);
        trail.keepPlace();
        QVERIFY(near(trail.distanceTo_m(trail.placeBehind(1e9).value()), 4.1));
        QVERIFY(near(trail.distanceTo_m(trail.placeBehind(-1.0).value()), 0.0));
        for (int i = 0; i < 600; ++i) {
            trail.step(5.0, 0.0);
            trail.keepPlace();
        }
        QVERIFY(near(trail.distanceTo_m(trail.placeBehind(1e9).value()), 499 * 5.0, 1e-6)); // 500 are kept
    }

    void movesMountAndZoomInTurnEveryHalfSecond() {
        Limits limits;
        limits.mount = mountOf({link(1, -1.0, 1.0), link(2, -0.5, 0.5)});
        limits.camera = protocol::CameraConfiguration{.name = "Cam", .smallest_fov_rad = 0.3, .largest_fov_rad = 2.0};
        CameraSweep camera;
        std::vector<bool> moves;
        for (int i = 0; i <= 40; ++i)
            if (const auto command = camera.next(Seconds(10.0 + 0.25 * i), Seconds(40.0), limits))
                moves.push_back(std::holds_alternative<protocol::PackageDrive>(*command));
        QCOMPARE(moves.size(), std::size_t(20)); // In 10 s
        for (std::size_t i = 0; i < moves.size(); ++i)
            QCOMPARE(bool(moves[i]), i % 2 == 0);
    }

    void commandsOnlyWhatTheRobotHas_data() {
        QTest::addColumn<bool>("mount");
        QTest::addColumn<bool>("camera");
        QTest::addColumn<QString>("mount_name");
        QTest::addColumn<int>("links");
        QTest::addColumn<int>("commands");
        QTest::newRow("a mount and a camera") << true << true << "Mount" << 2 << 20;
        QTest::newRow("a mount with one link") << true << false << "Mount" << 1 << 10;
        QTest::newRow("a mount without links") << true << false << "Mount" << 0 << 0;
        QTest::newRow("a mount whose name no line can hold") << true << true << "My mount" << 2 << 10;
        QTest::newRow("only a camera") << false << true << "" << 0 << 10;
        QTest::newRow("nothing") << false << false << "" << 0 << 0;
    }
    void commandsOnlyWhatTheRobotHas() {
        QFETCH(bool, mount);
        QFETCH(bool, camera);
        QFETCH(QString, mount_name);
        QFETCH(int, links);
        QFETCH(int, commands);
        Limits limits;
        if (mount)
            limits.mount = protocol::PackageConfiguration{mount_name.toStdString(), {}};
        for (int i = 1; i <= links; ++i)
            limits.mount->links.push_back(link(i, -1.0, 1.0));
        if (camera)
            limits.camera = protocol::CameraConfiguration{.name = "Cam", .smallest_fov_rad = 0.3, .largest_fov_rad = 2};
        CameraSweep sweep;
        int sent = 0;
        for (int i = 0; i <= 40; ++i)
            sent += sweep.next(Seconds(0.25 * i), Seconds(40.0), limits) ? 1 : 0;
        QCOMPARE(sent, commands);
    }

    void pansNoFasterThanItsMountCan_data() {
        QTest::addColumn<double>("speed_rad_s");
        for (const double speed_rad_s : {0.02, 0.1, 0.5})
            QTest::addRow("%g rad/s", speed_rad_s) << speed_rad_s;
    }
    void pansNoFasterThanItsMountCan() {
        QFETCH(double, speed_rad_s);
        Limits limits;
        limits.mount = mountOf({link(1, -1.0, 1.5, speed_rad_s), link(2, -0.5, 0.7, speed_rad_s)});
        for (const std::size_t index : {std::size_t(0), std::size_t(1)}) {
            const auto values = sweep(limits, Seconds(5.0), Seconds(600.0), index);
            double fastest_rad_s = 0.0;
            for (std::size_t i = 1; i < values.size(); ++i)
                fastest_rad_s = std::max(fastest_rad_s, std::abs(values[i].second - values[i - 1].second) /
                                                            (values[i].first - values[i - 1].first).count());
            QVERIFY(values.size() > 500);
            QVERIFY2(fastest_rad_s < 0.81 * speed_rad_s, qPrintable(QString::number(fastest_rad_s)));
        }
    }

    void pansNoFartherThanALooseMountMay() {
        Limits limits;
        limits.mount = mountOf({{1, false, 1.0, {}, {}, {}}, link(2, -9.0, 9.0)});
        for (const std::size_t index : {std::size_t(0), std::size_t(1)}) {
            double least_rad = 9.0, most_rad = -9.0;
            for (const auto& [now, angle_rad] : sweep(limits, Seconds(20.0), Seconds(300.0), index)) {
                least_rad = std::min(least_rad, angle_rad);
                most_rad = std::max(most_rad, angle_rad);
            }
            QVERIFY(least_rad >= -2.0 && least_rad < -1.5);
            QVERIFY(most_rad <= 2.0 && most_rad > 1.5);
        }
    }

    /// All sets of questions that a server may leave unanswered, one bit for each.
    void takesUsualLimitsForWhatIsNotAnswered_data() {
        QTest::addColumn<int>("answered");
        for (int answered = 0; answered < 16; ++answered)
            QTest::addRow("answers %d", answered) << answered;
    }
    void takesUsualLimitsForWhatIsNotAnswered() {
        QFETCH(int, answered);
        const std::vector<std::string> answers{
            "CONF {Type NauticVehicle} {Name Submarine} {SteeringType VariableDepth} {Mass 37} {MaxPropellerSpeed 100} "
            "{MaxRudderAngle 0.2} {MaxSternPlaneAngle 0.3}",
            "CONF {Type Camera} {Name Camera} {CameraDefFov 1.4} {CameraMinFov 0.3} {CameraMaxFov 2.0}",
            "CONF {Type MisPkg} {Name CameraPanTilt} {Link 1} {JointType Revolute} {MaxSpeed 1} {MaxTorque 20} "
            "{MinRange -1} {MaxRange 1.5}",
            "CONF {Type Range} {Name Laser} {MaxRange 15} {MinRange 0.1}"};
        Questionnaire questions;
        modules::ConfigurationModule configuration;
        protocol::Reader reader;
        std::vector<std::string> asked;
        bool done = false;
        for (int tick = 0; tick < 200 && !done; ++tick) {
            done = questions.goOn(configuration);
            const auto question = configuration.next(Seconds(0.2 * tick));
            if (!question)
                continue;
            const std::string type = std::get<protocol::GetConfiguration>(*question).type.text();
            if (asked.empty() || asked.back() != type)
                asked.push_back(type);
            if (answered >> (asked.size() - 1) & 1)
                configuration.take(reader.read(answers.at(asked.size() - 1)));
        }
        QVERIFY(done && questions.goOn(configuration)); // It stays so
        QCOMPARE(asked, (std::vector<std::string>{"Robot", "Camera", "MisPkg", "Range"}));
        const Limits& limits = questions.limits();
        QCOMPARE(limits.propeller_rad_s, answered & 1 ? 100.0 : 160.0);
        QCOMPARE(limits.rudder_rad, answered & 1 ? 0.2 : 0.35);
        QCOMPARE(limits.stern_plane_rad, answered & 1 ? 0.3 : 0.35);
        QCOMPARE(limits.camera.has_value(), (answered & 2) != 0);
        QCOMPARE(limits.mount.has_value(), (answered & 4) != 0);
        QCOMPARE(limits.ray_reach_m, answered & 8 ? 15.0 : 20.0);
    }
};

USAR_TEST(tst_DiverRules)

} // namespace tst_diver_rules

#include "tst_diver_rules.moc"
