// A craft below something that it cannot see climbs with care, sinks away from it and stays below.
#include <algorithm>
#include <cmath>
#include <optional>

#include <QObject>
#include <QTest>

#include "tests/robots/craft_trial.h"
#include "tests/suite/suite.h"

namespace tst_craft_ceilings {

using namespace usar;
using namespace usar::airrobot;

class tst_CraftCeilings : public QObject, private test::CraftTrial {
    Q_OBJECT
private slots:
    void init() { begin(); }

    void climbsStraightUpWithCareWhereNobodyHasLooked() {
        perceive(3.0, {});
        const auto climb = [&] {
            craft->fly({Vec2(x_m, 0), Vec2(x_m, 0), 0.0, "test"}, port);
            return *lastDrive().value().climb_m_s;
        };
        QCOMPARE(climb(), Overhead::careful_m_s);
    }

    void sinksStraightAwayFromARoofThatItHasTouched() {
        protocol::AerialDrive drive;
        for (int tick = 0; tick < 9; ++tick) { // It is told to climb, and does not.
            perceive(3.0, {});
            if (const auto told = fly(); told.climb_m_s)
                drive = told;
            QVERIFY(*drive.climb_m_s > 0.0 || craft->overhead.hasCeiling());
        }
        QVERIFY(craft->overhead.hasCeiling());
        QCOMPARE(*drive.climb_m_s, -Overhead::gentle_m_s);
        z_m -= 0.4;
        perceive(2.6, {});
        QVERIFY(*fly().forward_m_s > 0.0);
    }

    void sinksStraightUnderALidAndStaysThere() {
        craft->forgetPlaces();
        craft->ways.startAnew(14.0);
        perceive(6.0, {});
        QVERIFY(!craft->ways.isNarrow());
        craft->goUnder({0.0, 0.0});
        perceive(6.0, {});
        protocol::AerialDrive drive = fly();
        QCOMPARE(*drive.climb_m_s, -Overhead::gentle_m_s);
        QVERIFY(std::abs(*drive.forward_m_s) < 0.05);
        z_m = 16.5;                                    // The lid is at 17.2 m.
        for (int tick = 0; tick < 5; ++tick) {         // The ground asks it to climb, and the lid forbids it.
            perceive(2.2, {{"R4", 0.9}, {"L4", 0.9}}); // It is in a door.
            if (const auto told = fly(); told.climb_m_s)
                drive = told;
            QVERIFY(*drive.climb_m_s <= 0.0);
        }
        QVERIFY2(*drive.forward_m_s > 0.2 && *drive.forward_m_s < 1.3 * Ways::door_m_s,
                 qPrintable(QString::number(*drive.forward_m_s)));
        craft->comeUp();
        perceive(2.2, {{"R4", 0.9}, {"L4", 0.9}});
        QCOMPARE(craft->threats.risk, agent::Risk::High);
        QVERIFY(craft->mayClimb());
    }

    /// On its way to where it was to sink, it pressed ever harder against a wall, because it took that for wind, until
    /// it broke (random survey 168861).
    void takesNoWallInARoomForWind() {
        craft->forgetPlaces();
        craft->ways.startAnew(14.0);
        craft->goUnder({6.0, 0.0});
        protocol::AerialDrive drive;
        const auto tick = [&](const std::map<std::string, double>& near_m) {
            perceive(6.0, near_m);
            const auto told = fly(0.5);
            drive = told.forward_m_s ? told : drive; // An unchanged command is not sent again.
            x_m += 0.001;                            // A pose that repeats itself hangs.
        };
        for (int i = 0; i < 25; ++i)
            tick({});
        QVERIFY2(*drive.forward_m_s > 0.8, qPrintable(QString::number(*drive.forward_m_s)));
        for (int i = 0; i < 3; ++i)
            tick({{"M0", 0.1 + 0.001 * i}});
        for (int i = 0; i < 6; ++i)
            tick({});
        QVERIFY2(*drive.forward_m_s < 0.35, qPrintable(QString::number(*drive.forward_m_s)));
    }

    /// Where no way leads home, it retraces its flight, whatever its goal is, and no faster than it bears a touch.
    void fliesBackAsItCame() {
        craft->settings.climb_over = false;
        protocol::AerialDrive drive;
        const auto tick = [&] {
            perceive(6.0, {});
            const auto told = fly();
            drive = told.forward_m_s ? told : drive; // An unchanged command is not sent again.
            move(drive);
        };
        QVERIFY(!craft->retrace()); // It has been nowhere.
        for (int i = 0; i < 60 && x_m < 6.0; ++i)
            tick();
        QVERIFY(x_m >= 6.0);
        QVERIFY(craft->retrace());
        for (int i = 0; i < 20; ++i) // It turns around.
            tick();
        for (int i = 0; i < 100 && x_m > 1.0; ++i) {
            tick();
            QVERIFY2(*drive.forward_m_s < 1.2 * Ways::door_m_s, qPrintable(QString::number(*drive.forward_m_s)));
        }
        QVERIFY2(x_m <= 1.0, qPrintable(QString::number(x_m)));
    }

    /// In a room it stood for minutes, because something was within five meters all around (random survey 168085).
    void fliesOnInARoomWhereSomethingIsAllAround() {
        craft->settings.climb_over = false;
        protocol::AerialDrive drive;
        const auto fly_for = [&](int ticks, double front_m) {
            for (int tick = 0; tick < ticks; ++tick) {
                const double off_m = 0.01 * (tick % 2); // A sonar that repeats itself hangs.
                perceive(6.0, {{"L3", 1.5 + off_m},
                               {"L2", 1.7 + off_m},
                               {"L1", front_m + off_m},
                               {"M0", front_m + off_m},
                               {"R1", front_m + off_m},
                               {"R2", 1.7 + off_m}});
                const auto told = fly();
                drive = told.forward_m_s ? told : drive; // An unchanged command is not sent again.
            }
        };
        fly_for(20, 3.5);
        QVERIFY2(drive.forward_m_s.value_or(0.0) < 0.1, qPrintable(QString::number(*drive.forward_m_s)));
        fly_for(20, 3.5);
        QVERIFY2(*drive.forward_m_s > 0.2, qPrintable(QString::number(*drive.forward_m_s)));
        QVERIFY2(*drive.forward_m_s < 1.1 * Ways::door_m_s, qPrintable(QString::number(*drive.forward_m_s)));
        fly_for(5, 1.0);
        QVERIFY2(*drive.forward_m_s < 0.1, qPrintable(QString::number(*drive.forward_m_s)));
    }

    /// Its lid is no roof: it felt nothing of the rack under it, and tipped over (survey 145237).
    void risesFromARackOnItsWayUnderALid() {
        craft->forgetPlaces();
        craft->ways.startAnew(14.0);
        craft->goUnder({0.0, 0.0});
        double climb_m_s = 0.0;
        for (int tick = 0; tick < 10; ++tick) {
            perceive(6.0, {});
            climb_m_s = fly().climb_m_s.value_or(climb_m_s);
            z_m += 0.2 * climb_m_s;
        }
        QCOMPARE(climb_m_s, -Overhead::gentle_m_s);
        roll_rad = 0.12;
        for (int tick = 0; tick < 5; ++tick) {
            perceive(0.4, {});
            climb_m_s = fly().climb_m_s.value_or(climb_m_s);
        }
        QVERIFY2(climb_m_s > 0.0, qPrintable(QString::number(climb_m_s)));
    }

    /// A floor on posts beside the start ended the climb there for good, and the survey under it
    /// (`tst_random_surveys_campaign`, number 1013).
    void climbsElsewhereWhereACeilingIsLow() {
        craft->forgetPlaces();
        craft->comeUp(); // It knows what is around, so it climbs at once.
        z_m = 16.5;
        constexpr double goal_z_m = 20.0;
        for (int tick = 0; tick < 40 && !craft->overhead.hasCeiling(); ++tick) {
            perceive(z_m - 13.8, {});
            QVERIFY(!craft->rise(goal_z_m, {0.0, 0.0}, port));
            z_m = std::min(z_m + 0.08, 16.9); // There is something above it.
        }
        QVERIFY(craft->overhead.hasCeiling());
        QVERIFY(craft->column_m());
        const Vec2 aim_m = *craft->column_m();
        QVERIFY(aim_m.norm() > 3.0);
        QVERIFY(std::isinf(craft->overhead.limit_m(aim_m)));
        perceive(z_m - 13.8, {});
        QVERIFY(!craft->rise(goal_z_m, {0.0, 0.0}, port)); // It is not there yet.
        craft->startAnew();
        QVERIFY(craft->overhead.limit_m(aim_m) < 17.0); // Under way, it counts on the ceiling again.
        z_m = 17.1;                                     // Its height has drifted, so it seems to be above it.
        perceive(z_m - 13.8, {});
        craft->startAnew();
        QVERIFY(craft->overhead.limit_m(aim_m) < 17.0);
    }

    /// A trunk that no sensor had heard before stood on its way, and it climbed right there, into the crown of another
    /// one (survey 118314).
    void choosesItsPlaceAnewBeforeATrunkThatItDidNotKnow() {
        craft->forgetPlaces();
        craft->comeUp();
        z_m = 16.5;
        for (int tick = 0; tick < 40 && !craft->overhead.hasCeiling(); ++tick) {
            perceive(z_m - 13.0, {});
            craft->rise(20.0, {0.0, 0.0}, port);
            z_m = std::min(z_m + 0.08, 16.9);
        }
        QVERIFY(craft->column_m());
        yaw_rad = bearingOf(*craft->column_m());
        perceive(z_m - 13.0, {});
        craft->rise(20.0, {0.0, 0.0}, port);
        const Vec2 aim_m = *craft->column_m();
        QVERIFY(aim_m.norm() > 3.0);
        for (int tick = 0; tick < 3; ++tick) { // A single echo may be wrong.
            perceive(z_m - 13.0, {{"M0", 1.0}, {"L1", 1.0}, {"R1", 1.0}});
            craft->rise(20.0, {0.0, 0.0}, port);
        }
        QVERIFY((*craft->column_m() - aim_m).norm() > 1.0);
        QVERIFY(craft->column_m()->norm() > 1.0);
    }

    /// With its height 0.85 m too low, it climbed into a roof at 1 m/s (survey 118541).
    void creepsWhereARoofMayBeNearerThanItKnows() {
        craft->settings.scan_altitude_m = 12.0;
        for (int tick = 0; tick < 9; ++tick) {
            perceive(8.0, {});
            fly();
        }
        const double limit_m = craft->overhead.limit_m({0.0, 0.0});
        protocol::AerialDrive drive; // An unchanged command is not sent again.
        const auto forward_m_s = [&] {
            z_m = limit_m - 1.0;
            drive = {};
            for (int tick = 0; tick < 15; ++tick) {
                x_m += 0.2 * drive.forward_m_s.value_or(0.0);
                z_m += 0.1 * drive.climb_m_s.value_or(0.0); // at half the rate, so that it does not arrive
                perceive(z_m - 12.0, {});
                const auto sent = fly(1.0);
                drive = sent.forward_m_s ? sent : drive;
            }
            return drive.forward_m_s.value_or(0.0);
        };
        QVERIFY2(forward_m_s() > 0.5, qPrintable(QString::number(*drive.forward_m_s)));
        for (int there = 0; there < 10; ++there) { // 300 m, of which it believes each at the third look
            x_m += there % 2 == 0 ? 30.0 : -30.0;
            for (int look = 0; look < 4; ++look)
                perceive(z_m - 12.0, {});
        }
        QVERIFY2(forward_m_s() < 0.4, qPrintable(QString::number(*drive.forward_m_s)));
        QVERIFY(*drive.climb_m_s > 0.0);
    }

    /// It sank and climbed before the same wall for minutes, and looked for no way around it.
    void staysUpWhereAClimbBelowACeilingWasInVain() {
        for (int tick = 0; tick < 9; ++tick) { // It is told to climb, and does not.
            perceive(3.0, {});
            fly();
        }
        const double limit_m = craft->overhead.limit_m({0.0, 0.0});
        QVERIFY(limit_m < 20.0);
        z_m = limit_m - 2.0;
        const auto fly_s = [&](double seconds, double before_m) {
            double lowest_m = z_m;
            protocol::AerialDrive drive; // An unchanged command is not sent again.
            for (double past_s = 0.0; past_s < seconds; past_s += 0.2) {
                perceive(z_m - limit_m + 8.0, {{"M0", before_m - 0.01 * std::fmod(5.0 * past_s, 2.0)}});
                craft->fly({Vec2(x_m + 30, 0), Vec2(x_m + 8, 0), 1.0, "test"}, port);
                drive = lastDrive().value_or(drive);
                x_m += before_m < 5.0 ? 0.0 : 0.2 * drive.forward_m_s.value_or(0.0);
                z_m += 0.2 * drive.climb_m_s.value_or(0.0);
                lowest_m = std::min(lowest_m, z_m);
            }
            return lowest_m;
        };
        fly_s(30.0, 2.0);
        QVERIFY2(z_m > limit_m - 0.4, qPrintable(QString::number(limit_m - z_m)));
        QVERIFY(!craft->mayClimb());
        const double lowest_m = fly_s(11.0, 5.0); // It keeps its height for some meters.
        QVERIFY2(lowest_m > limit_m - 0.25, qPrintable(QString::number(limit_m - lowest_m)));
    }

    void leavesARoofEvenWithoutAPose() {
        const auto brace = [&] {
            craft->brace(port, "test");
            const auto drive = lastDrive();
            return drive ? drive->climb_m_s : std::nullopt;
        };
        perceive(3.0, {});
        QCOMPARE(brace(), std::optional(0.0));
        for (int tick = 0; tick < 9; ++tick) {
            perceive(3.0, {});
            fly();
        }
        QVERIFY(craft->overhead.hasCeiling());
        QCOMPARE(brace().value_or(-Overhead::gentle_m_s), -Overhead::gentle_m_s);
        tells_pose = false;
        std::optional<double> climb_m_s;
        for (int tick = 0; tick < 40; ++tick) { // A robot that sees nothing does not sink for ever.
            perceive(3.0, {});
            climb_m_s = brace().value_or(climb_m_s.value_or(-Overhead::gentle_m_s));
        }
        QCOMPARE(climb_m_s, std::optional(0.0));
    }
};

USAR_TEST(tst_CraftCeilings)

} // namespace tst_craft_ceilings

#include "tst_craft_ceilings.moc"
