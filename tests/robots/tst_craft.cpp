#include <algorithm>
#include <cmath>
#include <optional>

#include <QObject>
#include <QTest>

#include "tests/robots/craft_trial.h"
#include "tests/suite/suite.h"

namespace tst_craft {

using namespace usar;
using namespace usar::airrobot;

class tst_Craft : public QObject, private test::CraftTrial {
    Q_OBJECT
private slots:
    void init() { begin(); }

    /// A wire that it did not see tipped it over as it went on sinking (random survey 122038). One that hung on a rack
    /// and leaned more as it rose sank back each time, until it fell off (random survey 167709).
    void risesFromAWireAndStaysAboveIt_data() {
        QTest::addColumn<double>("leans_rad");
        QTest::newRow("it leans as before") << 0.15;
        QTest::newRow("it leans more as it rises") << 0.35;
    }
    void risesFromAWireAndStaysAboveIt() {
        QFETCH(double, leans_rad);
        protocol::AerialDrive drive;
        const auto tick = [&] {
            perceive(14.0, {});
            if (const auto told = fly(0.1); told.climb_m_s)
                drive = told;
        };
        for (int i = 0; i < 8; ++i) {
            tick();
            z_m -= 0.1;
        }
        QVERIFY(*drive.climb_m_s < -0.3);
        const double wire_m = z_m - 0.1;
        roll_rad = 0.15;
        for (int i = 0; i < 6 && *drive.climb_m_s < 0.0; ++i)
            tick();
        QVERIFY(*drive.climb_m_s > 0.3);
        roll_rad = leans_rad;
        for (int i = 0; i < 3; ++i) {
            tick();
            QVERIFY(*drive.climb_m_s > 0.3);
        }
        roll_rad = 0.0;
        for (int i = 0; i < 60; ++i) {
            tick();
            z_m += 0.2 * *drive.climb_m_s;
        }
        QVERIFY2(z_m > wire_m + 0.8, qPrintable(QString::number(z_m - wire_m)));
    }

    void climbsWhereNothingIsBeside() {
        perceive(5.0, {});
        QVERIFY(*fly().climb_m_s > 0.5);
    }

    /// A wire above it, which it had not seen, broke a rotor at 0.97 m/s (random survey 164038).
    void climbsStraightUpNoFasterThanItBears_data() {
        QTest::addColumn<double>("faces_rad");
        QTest::addColumn<double>("climb_m_s");
        QTest::newRow("on its way") << 0.0 << 1.0;
        QTest::newRow("as it turns on the spot") << pi << 0.7;
    }
    void climbsStraightUpNoFasterThanItBears() {
        QFETCH(double, faces_rad);
        QFETCH(double, climb_m_s);
        yaw_rad = faces_rad;
        roll_rad = 0.3; // It looks up.
        perceive(3.0, {});
        roll_rad = 0.0;
        perceive(3.0, {});
        QCOMPARE(*fly().climb_m_s, climb_m_s);
    }

    /// As it climbed on its way against the wind, it met a wire that its sonars looked below of (random survey 168982).
    void climbsSlowlyOnItsWayWhereItDoesNotHearWhatIsLevel_data() {
        QTest::addColumn<double>("leans_rad");
        QTest::addColumn<double>("climb_m_s");
        QTest::addColumn<double>("forward_m_s");
        QTest::newRow("level") << 0.0 << 1.0 << 1.0;
        QTest::newRow("as it speeds up") << 0.1 << 1.0 << 1.0;
        QTest::newRow("against the wind") << 0.25 << Overhead::careful_m_s << 0.5;
        QTest::newRow("with the wind") << -0.25 << 1.0 << 1.0;
    }
    void climbsSlowlyOnItsWayWhereItDoesNotHearWhatIsLevel() {
        QFETCH(double, leans_rad);
        QFETCH(double, climb_m_s);
        QFETCH(double, forward_m_s);
        pitch_rad = leans_rad;
        protocol::AerialDrive drive;
        for (int tick = 0; tick < 20; ++tick) {
            perceive(3.0, {});
            const auto sent = fly();
            drive = sent.forward_m_s ? sent : drive;
            move(drive);
        }
        QCOMPARE(*drive.climb_m_s, climb_m_s);
        QVERIFY2(std::abs(*drive.forward_m_s - forward_m_s) < 0.05, qPrintable(QString::number(*drive.forward_m_s)));
    }

    void doesNotClimbBesideWhatMayBeWiderAbove_data() {
        QTest::addColumn<double>("left_m");
        QTest::addColumn<double>("r4_m");
        QTest::newRow("a trunk that the scanner's level ray sees") << 1.8 << 5.0;
        QTest::newRow("a trunk that a side sonar sees") << 20.0 << 2.3;
    }
    void doesNotClimbBesideWhatMayBeWiderAbove() {
        QFETCH(double, left_m);
        QFETCH(double, r4_m);
        perceive(5.0, {{"R4", r4_m}}, left_m);
        perceive(5.0, {{"R4", r4_m}}, left_m); // A single beam is believed the second time.
        const auto drive = fly();
        QCOMPARE(*drive.climb_m_s, 0.0);
        QVERIFY(*drive.forward_m_s > 0.0); // but goes on: the ground is far enough
    }

    /// At 2 m/s, it once stopped so deep among crowns that it climbed into one.
    void isFastOnlyInTheOpen_data() {
        QTest::addColumn<std::string>("sonar");
        QTest::addColumn<double>("range_m");
        QTest::addColumn<double>("left_m");
        QTest::addColumn<double>("height_m");
        QTest::addColumn<double>("asked_m_s");
        QTest::addColumn<double>("speed_m_s");
        QTest::newRow("in the open") << std::string("R2") << 5.0 << 20.0 << 6.0 << 2.0 << 2.0;
        QTest::newRow("in the open, climbing") << std::string("R2") << 5.0 << 20.0 << 4.0 << 2.0 << 2.0;
        QTest::newRow("beside something") << std::string("R2") << 4.0 << 20.0 << 6.0 << 2.0 << 1.2;
        QTest::newRow("beside something, climbing") << std::string("R2") << 4.0 << 20.0 << 4.0 << 2.0 << 1.0;
        QTest::newRow("beside something on the left") << std::string("L2") << 4.0 << 20.0 << 6.0 << 2.0 << 1.2;
        QTest::newRow("beside something, in no hurry") << std::string("R2") << 4.0 << 20.0 << 6.0 << 1.6 << 1.6;
        QTest::newRow("past something abeam") << std::string("R2") << 5.0 << 4.5 << 6.0 << 2.0 << 2.0;
    }
    void isFastOnlyInTheOpen() {
        QFETCH(std::string, sonar);
        QFETCH(double, range_m);
        QFETCH(double, left_m);
        QFETCH(double, height_m);
        QFETCH(double, asked_m_s);
        QFETCH(double, speed_m_s);
        protocol::AerialDrive drive; // An unchanged command is not sent again.
        for (int tick = 0; tick < 40; ++tick) {
            perceive(height_m, {{sonar, range_m - 0.01 * (tick % 2)}}, left_m); // One that repeats itself hangs.
            const auto sent = fly(asked_m_s);
            drive = sent.forward_m_s ? sent : drive;
            x_m += 0.2 * drive.forward_m_s.value_or(0.0);
            z_m += 0.2 * drive.climb_m_s.value_or(0.0);
        }
        const double forward_m_s = drive.forward_m_s.value_or(0.0);
        QVERIFY2(std::abs(forward_m_s - speed_m_s) < 0.05, qPrintable(QString::number(forward_m_s)));
    }

    void waitsWhenMuchClimbIsWantingThere() {
        perceive(3.0, {}, 1.8);
        perceive(3.0, {}, 1.8);
        const auto drive = fly();
        QCOMPARE(*drive.climb_m_s, 0.0);
        QVERIFY(std::abs(*drive.forward_m_s) < 1e-9);
    }

    /// Beside a trunk on its right and low over the ground, the robot is to fly to the left.
    void waitsInAHurryOnlyRightBeforeSomething_data() {
        QTest::addColumn<double>("transit_m_s");
        QTest::addColumn<double>("left_m");
        QTest::addColumn<bool>("waits");
        QTest::newRow("in no hurry") << 1.6 << 20.0 << true;
        QTest::newRow("in a hurry") << 2.0 << 20.0 << false;
        QTest::newRow("in a hurry, with something far ahead") << 2.0 << 9.0 << false;
        QTest::newRow("in a hurry, right before something") << 2.0 << 4.5 << true;
    }
    void waitsInAHurryOnlyRightBeforeSomething() {
        QFETCH(double, transit_m_s);
        QFETCH(double, left_m);
        QFETCH(bool, waits);
        craft->settings.transit_speed_m_s = transit_m_s;
        perceive(3.0, {}, left_m, 1.8);
        perceive(3.0, {}, left_m, 1.8);
        const FlightState state = craft->fly({Vec2(0, 30), Vec2(0, 8), transit_m_s, "test"}, port);
        QCOMPARE(state == FlightState::Evading, waits);
        QCOMPARE(lastDrive().value().climb_m_s, std::optional(0.0));
    }

    void sinksBesideATrunkAllTheSame() {
        perceive(9.0, {}, 1.8);
        perceive(9.0, {}, 1.8);
        QVERIFY(*fly().climb_m_s < 0.0);
    }

    void climbsWithCareAfterAClimbOverSomething_data() {
        QTest::addColumn<double>("higher_m");
        QTest::newRow("on and on") << 0.0;
        QTest::newRow("again, after a while on the level") << 1.0;
    }
    void climbsWithCareAfterAClimbOverSomething() {
        QFETCH(double, higher_m);
        perceive(3.0, {});
        QVERIFY(*fly().climb_m_s > Overhead::careful_m_s);
        for (int tick = 0; tick < 100 && !craft->climbingOver(); ++tick) {
            perceive(6.0, {{"L1", 3.0}, {"M0", 3.0}, {"R1", 3.0}});
            fly();
        }
        QVERIFY(craft->climbingOver());
        double climb_m_s = 0.0; // An unchanged command is not sent again.
        for (int tick = 0; tick < 200 && craft->climbingOver(); ++tick) {
            perceive(higher_m > 0.0 ? z_m - 14.0 : 3.0, {});
            climb_m_s = fly().climb_m_s.value_or(climb_m_s);
            z_m += 0.2 * climb_m_s;
        }
        QVERIFY(!craft->climbingOver());
        if (higher_m > 0.0) {
            perceive(9.0, {});
            fly();
            z_m += higher_m;
        }
        double fastest_m_s = 0.0;
        for (int tick = 0; tick < 5; ++tick) {
            perceive(3.0, {});
            fastest_m_s = std::max(fastest_m_s, fly().climb_m_s.value_or(climb_m_s));
        }
        QVERIFY2(fastest_m_s <= Overhead::careful_m_s && fastest_m_s > 0.2, qPrintable(QString::number(fastest_m_s)));
    }

    /// It went aside within a crown instead of sinking out of it, and broke (random survey 171904).
    void sinksOutOfACrownThatAlsoHoldsItFromTheSide() {
        for (int tick = 0; tick < 100 && !craft->climbingOver(); ++tick) {
            perceive(6.0, {{"L1", 3.0}, {"M0", 3.0}, {"R1", 3.0}});
            fly();
        }
        double climb_m_s = 0.0; // An unchanged command is not sent again.
        for (int tick = 0; tick < 60 && z_m < 21.5; ++tick) {
            perceive(z_m - 14.0, {{"M0", 3.0}});
            climb_m_s = fly().climb_m_s.value_or(climb_m_s);
            z_m += 0.2 * climb_m_s;
        }
        QVERIFY(craft->climbingOver() && climb_m_s > 0.0);
        for (const double near_m : {0.35, 0.18, 0.16}) {
            perceive(z_m - 14.0, {{"M0", 3.0}, {"R3", near_m}, {"R4", near_m}});
            climb_m_s = fly().climb_m_s.value_or(climb_m_s);
            QVERIFY2(climb_m_s < 0.0, qPrintable(QString::number(near_m)));
        }
    }

    /// Among crowns at its height, a robot climbed into one that got wider above (`quick_scan`, seeds 411 and 673).
    void climbsOverSomethingOnlyWhereThereIsRoom_data() {
        QTest::addColumn<double>("transit_m_s");
        QTest::addColumn<double>("beside_m");
        QTest::addColumn<bool>("climbs_there");
        QTest::addColumn<bool>("resets_ins");
        QTest::newRow("before a lone tree") << 2.0 << 20.0 << true << false;
        QTest::newRow("at the end of a lane between trees") << 2.0 << 2.0 << false << false;
        QTest::newRow("the same, and it resets its INS on the way back") << 2.0 << 2.0 << false << true;
        QTest::newRow("the same in no hurry") << 1.0 << 2.0 << true << false;
    }
    void climbsOverSomethingOnlyWhereThereIsRoom() {
        QFETCH(double, transit_m_s);
        QFETCH(double, beside_m);
        QFETCH(bool, climbs_there);
        QFETCH(bool, resets_ins);
        craft->settings.transit_speed_m_s = transit_m_s;
        const auto beside = [&] { return x_m > 2.0 ? beside_m : 20.0; };
        for (x_m = -4.0; x_m < 12.0; x_m += 0.3) {
            perceive(6.0, {}, beside(), beside());
            fly();
        }
        for (int tick = 0; tick < 75 && !craft->climbingOver(); ++tick) {
            perceive(6.0, {{"L1", 3.0}, {"M0", 3.0}, {"R1", 3.0}}, beside(), beside());
            QVERIFY(fly().climb_m_s.value_or(0.0) <= 0.0);
        }
        QCOMPARE(craft->climbingOver(), climbs_there);
        if (climbs_there)
            return;
        if (resets_ins)
            craft->forgetPlaces();
        x_m = -3.0; // It has gone back, out of the trees.
        for (int tick = 0; tick < 3; ++tick) {
            perceive(6.0, {});
            fly();
        }
        QCOMPARE(craft->climbingOver(), !resets_ins);
    }

    void sinksOverItsPlaceOnly() {
        craft->touchdown.start();
        const auto descend = [&](double to_m, bool in_need = true) {
            craft->descend({x_m + to_m, 0}, in_need, port);
            return lastDrive().value();
        };
        perceive(6.0, {});
        const protocol::AerialDrive aside = descend(2.0);
        QCOMPARE(*aside.climb_m_s, 0.0);
        QVERIFY(*aside.forward_m_s > 0.0);
        perceive(6.0, {});
        QVERIFY(*descend(0.2).climb_m_s < 0.0);
        craft->touchdown.start();
        perceive(6.0, {});
        QVERIFY(*descend(2.0, false).climb_m_s < 0.0); // Over its base, the air is known.
        perceive(2.8, {});
        QCOMPARE(*descend(2.0, false).climb_m_s, 0.0);
    }

    /// It had not turned far enough, and landed on the edge of a box (survey 160541).
    void looksAroundBeforeItSinksTheLastMeter() {
        craft->touchdown.start();
        z_m = 2.5;
        const auto descend = [&] {
            perceive(z_m, {});
            craft->descend({x_m, 0}, false, port);
            return lastDrive().value_or(protocol::AerialDrive{});
        };
        descend();
        z_m = 1.0;
        protocol::AerialDrive drive;
        for (int tick = 0; tick < 3; ++tick)
            drive = descend();
        QCOMPARE(drive.climb_m_s.value_or(0.0), 0.0);
        QVERIFY(drive.yaw_rate_rad_s.value_or(1.0) > 0.3);
        for (int tick = 0; tick < 40; ++tick) {
            yaw_rad += 0.1;
            drive = descend();
            if (drive.climb_m_s.value_or(0.0) < 0.0)
                break;
        }
        QVERIFY(drive.climb_m_s.value_or(0.0) < 0.0 && yaw_rad > 2.9);
    }

    /// It sank below the terrace on which it was to land, and met its edge (survey 145399).
    void sinksOnItsWayToAPlaceUpToTheHeightOfThatOnly_data() {
        QTest::addColumn<double>("terrace_m");
        QTest::addColumn<bool>("sinks");
        QTest::newRow("on a terrace") << 5.0 << false;
        QTest::newRow("on the ground that it is over") << 0.0 << true;
    }
    void sinksOnItsWayToAPlaceUpToTheHeightOfThatOnly() {
        QFETCH(double, terrace_m);
        QFETCH(bool, sinks);
        z_m = 6.0;
        for (x_m = 6.0; x_m > 0.0; x_m -= 0.4)
            perceive(x_m > 4.0 ? z_m - terrace_m : z_m, {});
        craft->touchdown.start();
        craft->descend({6.0, 0.0}, false, port);
        QCOMPARE(*lastDrive().value().climb_m_s < 0.0, sinks);
    }

    /// Wind pressed it against a house beside its place, where it waited until it was turned over (survey 96774).
    void keepsOffWhatIsBesideItsPlace() {
        craft->touchdown.start();
        perceive(4.0, {{"R1", 0.2}, {"M0", 0.1}, {"L1", 0.2}});
        craft->descend({x_m + 2.0, 0.0}, false, port);
        const protocol::AerialDrive drive = lastDrive().value();
        QVERIFY2(*drive.forward_m_s < -0.1, qPrintable(QString::number(*drive.forward_m_s)));
        QCOMPARE(*drive.climb_m_s, 0.0);
    }

    void leavesTheGroundOnItsWayToAnotherPlace() {
        craft->touchdown.start();
        const auto climb_m_s = [&](double height_m) {
            perceive(height_m, {});
            craft->descend({x_m + 2.0, 0}, true, port);
            return lastDrive().value().climb_m_s;
        };
        QCOMPARE(climb_m_s(0.3), Overhead::gentle_m_s);
        QCOMPARE(climb_m_s(1.2), 0.0);
    }

    void tellsThatSomethingKeepsItFromItsPlace() {
        craft->touchdown.start();
        Descent descent = Descent::UnderWay;
        int ticks = 0;
        for (; ticks < 200 && descent == Descent::UnderWay; ++ticks) {
            perceive(6.0, {{"L1", 1.0}, {"M0", 1.0}, {"R1", 1.0}});
            descent = craft->descend({x_m + 3.0, 0}, true, port);
        }
        QCOMPARE(descent, Descent::KeptAway);
        QVERIFY2(ticks > 70 && ticks < 90, qPrintable(QString::number(ticks)));
    }

    /// A robot that knew no tree on its way flew into a wood at the height of the crowns, and climbed into one
    /// (`quick_scan`, seed 411, by POSH).
    void expectsTreesAsHighAsThoseThatItHasSeen_data() {
        QTest::addColumn<double>("transit_m_s");
        QTest::addColumn<double>("top_m");
        QTest::addColumn<double>("away_m");
        QTest::addColumn<bool>("has_flown");
        QTest::addColumn<bool>("climbs");
        QTest::newRow("in a hurry, by tall trees") << 2.0 << 24.0 << 18.0 << false << true;
        QTest::newRow("in a hurry, by low trees") << 2.0 << 17.0 << 18.0 << false << false;
        QTest::newRow("in a hurry, by tall trees far away") << 2.0 << 24.0 << 45.0 << false << false;
        QTest::newRow("in a hurry, after a charge") << 2.0 << 24.0 << 18.0 << true << false;
        QTest::newRow("in no hurry") << 1.0 << 24.0 << 18.0 << false << false;
    }
    void expectsTreesAsHighAsThoseThatItHasSeen() {
        QFETCH(double, transit_m_s);
        QFETCH(double, top_m);
        QFETCH(double, away_m);
        QFETCH(bool, has_flown);
        QFETCH(bool, climbs);
        craft->settings.transit_speed_m_s = transit_m_s;
        for (int take_off = 0; take_off < (has_flown ? 2 : 1); ++take_off) {
            if (take_off > 0)
                QVERIFY(craft->rise(z_m, {0.0, 0.0}, port));
            craft->forgetPlaces();
            craft->comeUp(); // It knows what is around, so it climbs at once.
            perceive(6.0, {});
        }
        Senses tree = craft->senses;
        tree.scan->hits_in_map_m.assign(1, Vec3(0.0, away_m, top_m));
        craft->memory.take(tree, {});
        QVERIFY(craft->rise(z_m, {0.0, 0.0}, port));
        craft->startAnew();
        perceive(6.0, {});
        const double climb_m_s = fly(transit_m_s).climb_m_s.value_or(0.0);
        QVERIFY2((climb_m_s > 0.3) == climbs, qPrintable(QString::number(climb_m_s)));
        for (; x_m < 40.0; x_m += 0.4) {
            perceive(6.0, {});
            fly(transit_m_s);
        }
        perceive(6.0, {});
        const double far_m_s = fly(transit_m_s).climb_m_s.value_or(0.0);
        QVERIFY2(far_m_s < 0.1, qPrintable(QString::number(far_m_s)));
    }

    /// A robot that rolled to the left, before its sonars had listened there, broke at a mast (survey 168086).
    void looksUpTowardWhereItsSonarsHaveListened() {
        craft->forgetPlaces();
        z_m = 0.3;
        double turned_rad = 0.0;
        protocol::AerialDrive drive;
        for (int tick = 0; tick < 100; ++tick) {
            perceive(z_m, {});
            craft->rise(6.3, {0.0, 0.0}, port);
            drive = lastDrive().value_or(drive); // An unchanged command is not sent again.
            if (const double left_m_s = drive.left_m_s.value_or(0.0); std::abs(left_m_s) > 0.5) {
                QVERIFY2(turned_rad > 0.3, qPrintable(QString::number(turned_rad)));
                QVERIFY2(left_m_s < 0.0, qPrintable(QString::number(left_m_s))); // It has turned left.
                return;
            }
            turned_rad += 0.2 * drive.yaw_rate_rad_s.value_or(0.0);
            move(drive);
        }
        QFAIL("It does not look up.");
    }

    /// A trunk that had been out of its sonars' reach, beside the place to which it went from another one, broke the
    /// robot by its crown (random survey 166034).
    void climbsApartFromTrunksThatItHearsOnItsWay_data() {
        QTest::addColumn<Vec2>("trunk_m");
        QTest::newRow("ahead") << Vec2(5.9, 0.3);
        QTest::newRow("aside") << Vec2(5.0, 2.6);
    }
    void climbsApartFromTrunksThatItHearsOnItsWay() {
        QFETCH(Vec2, trunk_m);
        const std::vector<Vec2> trunks_m{{-1.5, 0.0}, trunk_m};
        craft->forgetPlaces();
        z_m = 0.3;
        protocol::AerialDrive drive;
        for (int tick = 0; tick < 400 && z_m < 4.5; ++tick) {
            perceive(z_m, z_m > 1.5 ? hearing(trunks_m) : std::map<std::string, double>{});
            craft->rise(6.3, {0.0, 0.0}, port);
            drive = lastDrive().value_or(drive);
            move(drive);
        }
        QVERIFY(z_m >= 4.5);
        for (const Vec2& one_m : trunks_m) {
            const double away_m = (one_m - Vec2(x_m, y_m)).norm();
            QVERIFY2(away_m > 3.4, qPrintable(QString("%1 %2: %3").arg(x_m).arg(y_m).arg(away_m)));
        }
    }

    void fleesFromAHighRiskWithoutAChangeOfHeight() {
        perceive(5.0, {{"M0", 1.0}});
        const auto drive = fly();
        QVERIFY(*drive.forward_m_s < -0.5);
        QCOMPARE(*drive.climb_m_s, 0.0);
    }

    /// A single ray had met the tip of a tree (survey 159552).
    void stopsBeforeWhatASonarHasHeardCloseByOnce() {
        double forward_m_s = 0.0;
        for (int tick = 0; tick < 20; ++tick) {
            perceive(6.0, {});
            forward_m_s = fly().forward_m_s.value_or(forward_m_s);
            x_m += 0.2 * forward_m_s;
        }
        QVERIFY2(forward_m_s > 0.5, qPrintable(QString::number(forward_m_s)));
        perceive(6.0, {{"M0", 1.2}});
        for (int tick = 0; tick < 3; ++tick) {
            perceive(6.0, {});
            forward_m_s = fly().forward_m_s.value_or(forward_m_s);
        }
        QVERIFY2(forward_m_s < 0.2, qPrintable(QString::number(forward_m_s)));
    }

    void fleesBackwardNoFasterThanItMayTouchSomething() {
        double forward_m_s = 0.0;
        for (int tick = 0; tick < 6; ++tick) { // It backs away at 0.5 m/s.
            perceive(5.0, {{"M0", 1.0}});
            forward_m_s = fly().forward_m_s.value_or(forward_m_s);
            x_m -= 0.1;
        }
        QVERIFY2(forward_m_s < -0.2 && forward_m_s > -0.6, qPrintable(QString::number(forward_m_s)));
    }

    void fleesHarderWhereTheWindPushesItOn() {
        double hardest_m_s = 0.0;
        for (int tick = 0; tick < 15; ++tick) { // It moves on at 0.25 m/s, whatever it is told.
            perceive(5.0, {{"M0", 1.0}});
            hardest_m_s = std::min(hardest_m_s, fly().forward_m_s.value_or(0.0));
            x_m += 0.05;
        }
        QVERIFY2(hardest_m_s < -0.9, qPrintable(QString::number(hardest_m_s)));
    }

    void slowsDownTowardWhatItRemembers() {
        layout.sonars.resize(5); // left half and front only
        perceive(6.0, {{"M0", 2.4}});
        perceive(6.0, {{"M0", 2.4}});
        for (int i = 0; i < 10; ++i)
            perceive(6.0, {{"M0", 2.4}});
        QVERIFY(std::abs(*fly().forward_m_s) < 0.7);
    }

    void tellsWhenItIsTimeToGiveTheGoalUp() {
        craft->settings.give_up_after_s = 10.0;
        FlightState state = FlightState::Flying;
        int ticks = 0;
        for (; state != FlightState::Unreachable && ticks < 200; ++ticks) {
            perceive(6.0, {}); // the INS says that it never moves
            state = craft->fly({Vec2(30, 0), Vec2(5, 0), 1.0, "test"}, port);
        }
        QVERIFY(ticks > 45 && ticks < 60);
    }

    void staysWithinWhatTheRobotCanDo() {
        layout.maximum_climb_m_s = 0.4;
        perceive(3.0, {});
        QCOMPARE(*fly().climb_m_s, 0.4);
        QCOMPARE(craft->settings.climb_speed_m_s, 0.4);
    }
};

USAR_TEST(tst_Craft)

} // namespace tst_craft

#include "tst_craft.moc"
