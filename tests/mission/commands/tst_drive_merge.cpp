// DRIVEs that wait together are merged, so that the server ends up as if it had received each; and what a command has
// set in motion is stopped.
#include <QTest>

#include "core/mission/commands/drive_merge.h"
#include "core/mission/commands/safe_stop.h"
#include "core/protocol/command_writer.h"
#include "tests/suite/suite.h"

namespace tst_drive_merge {

using namespace usar;
using namespace usar::mission;
using namespace usar::protocol;

namespace {

QString lineOf(const Command& command) {
    return QString::fromStdString(write(command)).remove(" {Normalized false}");
}

void row(const char* name, const Command& older, const Command& newer, const char* expected) {
    QTest::newRow(name) << QVariant::fromValue(older) << QVariant::fromValue(newer) << QString(expected);
}

} // namespace

class tst_DriveMerge : public QObject {
    Q_OBJECT
private slots:
    void termsThatANewerDriveLeavesOutAreKept_data() {
        QTest::addColumn<QVariant>("older");
        QTest::addColumn<QVariant>("newer");
        QTest::addColumn<QString>("expected");
        row("wheels of one side", SkidDrive{1.0, 2.0}, SkidDrive{.right_rad_s = 3.0}, "DRIVE {Left 1} {Right 3}");
        row("a zero is no gap", SkidDrive{1.0, 2.0}, SkidDrive{0.0, {}}, "DRIVE {Left 0} {Right 2}");
        row("steering", AckermannDrive{1.0, 0.5, 0.25}, AckermannDrive{.speed_rad_s = 4.0},
            "DRIVE {Speed 4} {FrontSteer -0.5} {RearSteer -0.25}");
        row("flight", AerialDrive{1.0, 2.0, 3.0, 4.0}, AerialDrive{.forward_m_s = 5.0},
            "DRIVE {AltitudeVelocity 1} {LinearVelocity 5} {LateralVelocity -3} {RotationalVelocity -4}");
        row("a boat", NauticDrive{20.0, 0.25, 0.5}, NauticDrive{.rudder_rad = 0.0},
            "DRIVE {Propeller 20} {Rudder 0} {SternPlane 0.5}");
        row("lights", DriveSwitches{.light_on = true}, DriveSwitches{.flip = true}, "DRIVE {Light true} {Flip true}");
        row("lights of a drive", SkidDrive{1.0, 1.0, false, {.light_on = true}}, SkidDrive{2.0, 2.0},
            "DRIVE {Left 2} {Right 2} {Light true}");
        row("percent and rad/s do not mix, but lights do", SkidDrive{50.0, 50.0, true, {.light_on = true}},
            SkidDrive{.left_rad_s = 1.0}, "DRIVE {Left 1} {Light true}");
        row("another wheel", OmniDrive{{{0, 1.0, 0.5}}}, OmniDrive{{{1, 2.0, {}}}},
            "DRIVE {WheelNumber 1} {WheelSpeed 2} {WheelNumber 0} {WheelSpeed 1} {WheelSteer -0.5}");
        row("the same wheel", OmniDrive{{{0, 1.0, 0.5}}}, OmniDrive{{{0, 2.0, {}}}},
            "DRIVE {WheelNumber 0} {WheelSpeed 2} {WheelSteer -0.5}");
        row("another joint", MultiDrive{{{"A", 1.0}}}, MultiDrive{{{"B", 2.0}}}, "MULTIDRIVE {B 2} {A 1}");
        row("the same joint", MultiDrive{{{"A", 1.0}}}, MultiDrive{{{"A", 2.0}}}, "MULTIDRIVE {A 2}");
        row("a joint's newer angle", JointDrive{"A", JointOrder::Angle, 1.0}, JointDrive{"A", JointOrder::Angle, 2.0},
            "DRIVE {Name A} {Order 0} {Value 2}");
        row("relative orders add up", JointDrive{"A", JointOrder::RelativeAngle, 0.5},
            JointDrive{"A", JointOrder::RelativeAngle, 0.25}, "DRIVE {Name A} {Order 10} {Value 0.75}");
        row("a relative order after another order", JointDrive{"A", JointOrder::Speed, 1.0},
            JointDrive{"A", JointOrder::RelativeSpeed, 0.25}, "DRIVE {Name A} {Order 11} {Value 0.25}");
        row("no drive at all", ResetSensor{"Odometry"}, ResetSensor{"Encoder"}, "SET {Type Encoder} {Opcode RESET}");
    }

    void termsThatANewerDriveLeavesOutAreKept() {
        QFETCH(QVariant, older);
        QFETCH(QVariant, newer);
        QFETCH(QString, expected);
        auto merged = newer.value<Command>();
        keepAbsentTerms(merged, older.value<Command>());
        QCOMPARE(lineOf(merged), expected);
    }

    void onlyADriveOfItsKindIsReplaced() {
        QVERIFY(replaces(SkidDrive{}, SkidDrive{1.0, 1.0}));
        QVERIFY(!replaces(SkidDrive{}, AerialDrive{}));
        QVERIFY(replaces(JointDrive{"A"}, JointDrive{"A"}));
        QVERIFY(!replaces(JointDrive{"A"}, JointDrive{"B"}));
        QVERIFY(replaces(MultiDrive{{{"A", 1.0}}}, MultiDrive{{{"B", 1.0}}}));
        QVERIFY(!replaces(JointDrive{"A"}, MultiDrive{{{"A", 1.0}}}));
    }

    void whatANewerDriveOfAnotherKindSetsIsTakenOut_data() {
        QTest::addColumn<QVariant>("older");
        QTest::addColumn<QVariant>("newer");
        QTest::addColumn<QString>("expected");
        const char* const nothing = "";
        row("lights", SkidDrive{1.0, 1.0, false, {.light_on = true, .flip = true}}, DriveSwitches{.light_on = false},
            "DRIVE {Left 1} {Right 1} {Flip true}");
        row("all that there was", DriveSwitches{.light_on = true}, SkidDrive{1.0, 1.0, false, {.light_on = false}},
            nothing);
        row("lights that the newer one leaves alone", DriveSwitches{.light_on = true}, SkidDrive{1.0, 1.0},
            "DRIVE {Light true}");
        row("a joint of several", MultiDrive{{{"A", 1.0}, {"B", 2.0}}}, JointDrive{"A", JointOrder::Speed, 1.0},
            "MULTIDRIVE {B 2}");
        row("the only joint", MultiDrive{{{"A", 1.0}}}, JointDrive{"A", JointOrder::Speed, 1.0}, nothing);
        row("a joint that is one of several", JointDrive{"A", JointOrder::Speed, 1.0}, MultiDrive{{{"A", 1.0}}},
            nothing);
        row("another joint than those", JointDrive{"A", JointOrder::Speed, 1.0}, MultiDrive{{{"B", 1.0}}},
            "DRIVE {Name A} {Order 1} {Value 1}");
    }

    void whatANewerDriveOfAnotherKindSetsIsTakenOut() {
        QFETCH(QVariant, older);
        QFETCH(QVariant, newer);
        QFETCH(QString, expected);
        auto left = older.value<Command>();
        const bool any_left = takeOutWhatIsOld(left, newer.value<Command>());
        QCOMPARE(any_left, !expected.isEmpty());
        if (any_left)
            QCOMPARE(lineOf(left), expected);
    }

    void whatWasSetInMotionIsStopped_data() {
        QTest::addColumn<QStringList>("sent");
        QTest::addColumn<QStringList>("stops");
        const auto row = [](const char* name, const QStringList& sent, const QStringList& stops) {
            QTest::newRow(name) << sent << stops;
        };
        row("nothing", {}, {});
        row("wheels, once", {"DRIVE {Left 1} {Right 1}", "DRIVE {Left 2}"}, {"DRIVE {Left 0} {Right 0}"});
        row("wheels one by one", {"DRIVE {WheelNumber 0} {WheelSpeed 1}", "DRIVE {WheelNumber 2} {WheelSpeed 1}"},
            {"DRIVE {WheelNumber 2} {WheelSpeed 0} {WheelNumber 0} {WheelSpeed 0}"});
        row("a joint at speed", {"DRIVE {Name A} {Order 1} {Value 2}"}, {"DRIVE {Name A} {Order 1} {Value 0}"});
        row("a joint on its way to an angle", {"DRIVE {Name A} {Order 0} {Value 2}"},
            {"DRIVE {Name A} {Order 10} {Value 0}"});
        row("a brake holds by itself", {"DRIVE {Name A} {Order 3} {Value 2}"}, {});
        row("several joints", {"MULTIDRIVE {A 1} {B 2}"},
            {"DRIVE {Name A} {Order 10} {Value 0}", "DRIVE {Name B} {Order 10} {Value 0}"});
        row("a joint that was set", {"SET {Type Joint} {Name A} {Opcode Torque} {Params 5}"},
            {"DRIVE {Name A} {Order 1} {Value 0}"});
        row("stiffness moves nothing", {"SET {Type Joint} {Name A} {Opcode Stiffness} {Params 1}"}, {});
        row("links at speed, not those at an angle",
            {"MISPKG {Name Arm} {Link 1} {Value 1} {Order 0} {Link 2} {Value 1} {Order 1}"},
            {"MISPKG {Name Arm} {Link 2} {Value 0} {Order 1}"});
        row("a camera that zooms", {"SET {Type Camera} {Opcode Zoom} {Params 0.5}"}, {});
        row("a word that nobody knows", {"HOVER {Now true}"}, {});
    }

    void whatWasSetInMotionIsStopped() {
        QFETCH(QStringList, sent);
        QFETCH(QStringList, stops);
        MovingParts parts;
        for (const QString& line : sent)
            parts.sent(RawCommand{line.toStdString()});
        QStringList lines;
        for (const Command& stop : parts.stops())
            lines << lineOf(stop);
        QCOMPARE(lines, stops);
        parts.reset();
        QVERIFY(parts.stops().empty());
    }
};

USAR_TEST(tst_DriveMerge)

} // namespace tst_drive_merge

#include "tst_drive_merge.moc"
