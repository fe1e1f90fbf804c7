// Sensors whose values are missing, sent twice, empty, in another order, no numbers, or too large: what is kept of a
// line, and how many problems are reported.
#include <QTest>

#include <algorithm>
#include <string>

#include "core/base/numbers.h"
#include "core/protocol/fields.h"
#include "core/protocol/reader.h"
#include "core/protocol/writer.h"
#include "tests/suite/suite.h"

namespace tst_sensor_damage {

using namespace usar;
using namespace usar::protocol;

namespace {

/// "F1/range=4.560m; …", without the source.
QByteArray shown(const InfoMessage& message) {
    QByteArray text;
    for (const Field& field : fieldsOf(message)) {
        const std::string value = field.number ? fixed(*field.number, 3) : field.text;
        text += QByteArray::fromStdString((text.isEmpty() ? "" : "; ") + (field.item.empty() ? "" : field.item + "/") +
                                          field.field + "=" + value + field.unit);
    }
    return text;
}

int countOf(const Diagnostics& diagnostics, Severity severity) {
    return static_cast<int>(std::ranges::count(diagnostics, severity, &Diagnostic::severity));
}

/// A line that is read as its own type in spite of what is wrong with it.
void row(const char* name, const char* line, const char* expected, int warnings = 0) {
    QTest::newRow(name) << QByteArray(line) << QByteArray(expected) << warnings;
}

void rangeRows() {
    row("a sonar that sends no number", "SEN {Type Sonar} {Name F1 Range nan} {Name F2 Range 2}",
        "F1/range=nanm; F2/range=2.000m", 1);
    row("a sonar without a range", "SEN {Type Sonar} {Name F1} {Name F2 Range 2}", "F2/range=2.000m");
    row("a sonar with an empty range", "SEN {Type Sonar} {Name F1} {Range}", "F1/range=nanm", 1);
    row("a sonar twice", "SEN {Type Sonar} {Name F1 Range 1} {Name F1 Range 2}", "F1/range=1.000m; F1/range=2.000m");
    row("a range twice", "SEN {Type Sonar} {Name F1} {Range 1} {Range 2}", "F1/range=1.000m");
    row("a sonar without a name", "SEN {Type Sonar} {Range 2}", "range=2.000m");
    row("a range before its name", "SEN {Range 9} {Type Sonar} {Name F1} {Range 2}", "F1/range=2.000m");
    row("a range that nothing can sense", "SEN {Type IR} {Name A Range 1e16}", "A/range=nanm", 1);
    row("a range with a unit", "SEN {Type IR} {Name A Range 2m}", "A/range=2.000m", 1);
    row("a gap in a scan", "SEN {Type RangeScanner} {Name S} {Resolution 0.5} {FOV 1} {Range 1,,3}",
        "S/resolution=0.500rad; S/fov=1.000rad; S/count=3.000; S/minimum=1.000m; S/mean=2.000m; S/maximum=3.000m", 1);
    row("a scan of nothing", "SEN {Type RangeScanner} {Name S} {Resolution 0.5} {FOV 1} {Range}",
        "S/resolution=0.500rad; S/fov=1.000rad; S/count=0.000; S/minimum=nanm; S/mean=nanm; S/maximum=nanm");
    row("a comma after a scan", "SEN {Type RangeScanner} {Name S} {Resolution 0.5} {FOV 1} {Range 1,3,}",
        "S/resolution=0.500rad; S/fov=1.000rad; S/count=2.000; S/minimum=1.000m; S/mean=2.000m; S/maximum=3.000m");
    row("semicolons in a scan", "SEN {Type RangeScanner} {Name S} {Resolution 0.5} {FOV 1} {Range 1;2;3}",
        "S/resolution=0.500rad; S/fov=1.000rad; S/count=1.000; S/minimum=1.000m; S/mean=1.000m; S/maximum=1.000m", 1);
    row("a range too large in a scan", "SEN {Type RangeScanner} {Name S} {Resolution 0.5} {FOV 1} {Range 1e16,2}",
        "S/resolution=0.500rad; S/fov=1.000rad; S/count=2.000; S/minimum=2.000m; S/mean=2.000m; S/maximum=2.000m", 1);
    row("an angle of view twice", "SEN {Type RangeScanner} {Name S} {FOV 1} {FOV 2} {Range 2} {Resolution 0.5}",
        "S/resolution=0.500rad; S/fov=1.000rad; S/count=1.000; S/minimum=2.000m; S/mean=2.000m; S/maximum=2.000m");
}

void motionRows() {
    row("an acceleration twice", "SEN {Type Accel} {Name a} {Acceleration 1,2,3} {Acceleration 4,5,6}",
        "a/acceleration.x=1.000m/s²; a/acceleration.y=-2.000m/s²; a/acceleration.z=-3.000m/s²");
    row("the type at the end", "SEN {Acceleration 1,2,3} {Name a} {Type Accel}",
        "a/acceleration.x=1.000m/s²; a/acceleration.y=-2.000m/s²; a/acceleration.z=-3.000m/s²");
    row("orientation before location", "SEN {Type INS} {Name I} {Orientation 0,0,0} {Location 1,2,3}",
        "I/x=1.000m; I/y=-2.000m; I/z=-3.000m; I/roll=0.000rad; I/pitch=-0.000rad; I/yaw=-0.000rad");
    row("a location twice", "SEN {Type INS} {Name I} {Location 1,2,3} {Location 4,5,6} {Rotation 0,0,0}",
        "I/x=1.000m; I/y=-2.000m; I/z=-3.000m; I/roll=0.000rad; I/pitch=-0.000rad; I/yaw=-0.000rad");
    row("a yaw of many turns", "SEN {Type Odometry} {Name O} {Pose 1,2,400}",
        "O/x=1.000m; O/y=-2.000m; O/yaw=2.124rad");
    row("a compass without a number", "SEN {Type MagneticCompass} {Name c} {MagneticAngle}", "c/raw_angle=nan", 1);
    row("a compass with junk", "SEN {Type MagneticCompass} {Name c} {MagneticAngle 2x}", "c/raw_angle=2.000", 1);
    row("one of two altitudes", "SEN {Type AltitudeSensor} {Name a} {relativeAltitude high} {absoluteAltitude 5}",
        "a/above_sea=5.000m", 1);
    row("a wheel that is no number", "SEN {Type Tachometer} {Name T} {Vel 1,x} {Pos}",
        "T/speed.0=1.000rad/s; T/speed.1=nanrad/s", 1);
    row("ticks with a plus sign", "SEN {Type Encoder} {Name L Tick +5}", "L/ticks=5.000");
    row("satellites without a number", "SEN {Type GPS} {Name G} {Fix 1} {Satellites}", "G/fix=True", 1);
    row("a latitude of another letter",
        "SEN {Type GPS} {Name G} {Latitude 47,30.0000,X} {Longitude 122,18.0000,W} {Fix 1}",
        "G/longitude=-2.135rad; G/fix=True", 1);
    row("a latitude without a letter", "SEN {Type GPS} {Name G} {Latitude 47,30.0} {Fix 0}", "G/fix=False", 1);
    row("a position without Fix", "SEN {Type GPS} {Name G} {Latitude 47,30.0000,n} {Longitude 122,18.0000,w}",
        "G/latitude=0.829rad; G/longitude=-2.135rad; G/fix=True");
    row("a fix that is neither", "SEN {Type GPS} {Name G} {Fix maybe}", "G/fix=False", 1);
}

void findRows() {
    row("a tag twice", "SEN {Type RFID} {Name R} {ID 21} {ID 21}", "R ID 21/id=21.000; R ID 21/id=21.000");
    row("a memory before its tag", "SEN {Type RFID} {Name R} {Mem a} {ID 21}", "R ID 21/id=21.000");
    row("a place before its part", "SEN {Type VictSensor} {Name V} {Location 1,2,3} {PartName Leg}",
        "V PartName 1/part=Leg");
    row("touches as numbers", "SEN {Type Touch} {Name L Touch 1} {Name R Touch 0}", "L/touched=True; R/touched=False");
    row("a number of players that is none", "SEN {Type GroundTruthPlayers} {Name P} {Players many}", "", 1);
    row("a time before the mission", "SEN {Type MissionTime} {Name c} {Minutes -3}", "c/minutes=-3.000min");
    row("a sound without its length", "SEN {Type Sound} {Name S} {Loudness 5}", "S/loudness=5.000dB");
    row("a gas without its name", "SEN {Type CO2Sensor} {Name C} {Density 5}", "C/density=5.000");
    row("a ball that may be seen", "SEN {Type Helper} {Name b} {Pos3D 1,2,3} {Visible perhaps}",
        "b/position.x=1.000; b/position.y=2.000; b/position.z=3.000", 1);
    row("a probability below 0", "SEN {Type HumanMotion} {Name H} {Prob -1}", "H/probability=-1.000");
    row("a value before its link", "ASTA {Name Arm} {Value 5} {Link 1} {Value 2}",
        "Arm Link 1/link=1.000; Arm Link 1/value=2.000");
    row("a link without a number", "MISSTA {Name Cam} {Link 1} {Value nan}",
        "Cam Link 1/link=1.000; Cam Link 1/value=nan", 1);
}

void stateRows() {
    row("an empty battery segment", "STA {Battery} {Time 1}", "", 1);
    row("a battery that is no number", "STA {Time 1} {Battery nan}", "", 1);
    row("a light that is neither", "STA {Time 1} {LightToggle dim}", "", 1);
    row("a view beyond an int", "STA {Time 1} {View 1e10}", "", 1);
    row("two kinds of vehicle", "STA {Type GroundVehicle} {Type AerialVehicle} {Time 1}",
        "kind=GroundVehicle; kind=AerialVehicle");
    row("a steering angle", "STA {Time 1} {FrontSteer 0.5}", "front_steer=-0.500rad");
}

} // namespace

class tst_SensorDamage : public QObject {
    Q_OBJECT
private slots:
    void whatCanBeReadIsKept_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("expected");
        QTest::addColumn<int>("warnings");
        rangeRows();
        motionRows();
        findRows();
        stateRows();
    }

    void whatCanBeReadIsKept() {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, expected);
        QFETCH(int, warnings);
        Reader reader;
        const InfoLine result = reader.read(line.toStdString());
        QVERIFY(!std::holds_alternative<GenericMessage>(result.message));
        QCOMPARE(shown(result.message), expected);
        QCOMPARE(countOf(result.diagnostics, Severity::Warning), warnings);
        QCOMPARE(countOf(result.diagnostics, Severity::Error), 0);
    }

    void aLineWithoutDataIsGenericWithoutAWord_data() {
        QTest::addColumn<QByteArray>("line");
        for (const char* line :
             {"SEN {Type Accel} {Name a}", "SEN {Type Sonar}", "SEN {Type Sonar} {Name F1}",
              "SEN {Type MagneticCompass} {Name c}", "SEN {Type Encoder} {Name L Tick}", "SEN {Type Odometry} {Name O}",
              "SEN {Type GPS} {Name G} {Satellites 8}", "SEN {Type RFID} {Name R}", "SEN {Type Touch} {Name L}",
              "SEN {Time 1} {Type RangeScanner} {Name S}", "SEN {Type PCL} {Name p}", "MISSTA {Time 1} {Name Cam}",
              "EFF {Time 1} {Type Gripper} {Name G}"})
            QTest::newRow(line) << QByteArray(line);
    }

    void aLineWithoutDataIsGenericWithoutAWord() {
        QFETCH(QByteArray, line);
        Reader reader;
        const InfoLine result = reader.read(line.toStdString());
        QVERIFY(std::holds_alternative<GenericMessage>(result.message));
        QVERIFY(result.diagnostics.empty());
    }

    void whatCannotBeReadIsGenericWithItsReason_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("reason");
        const auto row = [](const char* line, const char* reason) {
            QTest::newRow(line) << QByteArray(line) << QByteArray(reason);
        };
        row("SEN {Type Accel} {Name a} {Acceleration}", "'' is not three numbers");
        row("SEN {Type Accel} {Name a} {Acceleration 1,nan,3}", "'1,nan,3' is not three numbers");
        row("SEN {Type Accel} {Name a} {Acceleration 1,1e16,3}", "'1,1e16,3' is not three numbers");
        row("SEN {Type Accel} {Name a} {Acceleration 1,2,3,4}", "'1,2,3,4' is not three numbers");
        row("SEN {Type IMU} {Name I} {AngularVel 0,0}", "'0,0' is not three numbers");
        row("SEN {Type INS} {Name I} {Location 1,2,3}", "a pose needs Location and Orientation");
        row("SEN {Type Sound} {Name S} {Duration 3}", "Loudness is missing");
        row("SEN {Type CO2Sensor} {Name C} {Gas CO2}", "Density is missing");
        row("SEN {Type Encoder} {Name L Tick 1e3}", "'1e3' is not a whole number");
        row("SEN {Type Encoder} {Name L Tick 99999999999999999999}", "'99999999999999999999' is not a whole number");
        row("SEN {Type Encoder} {Name L} {Tick 5} {Name R} {Tick}", "'' is not a whole number");
        row("SEN {Type Touch} {Name L} {Touch}", "'' is neither True nor False");
        row("SEN {Type RFID} {Name R} {ID}", "'' is not a whole number");
        row("SEN {Type MissionTime} {Name c} {Minutes 2.5}", "'2.5' is not a whole number");
        row("SEN {Type Odometry} {Name O} {Pose}", "'' is not three numbers");
        row("SEN {Type RangeScanner} {Name S} {FOV 1} {Range 1,2}", "a scan needs FOV, Resolution and Range");
        row("SEN {Type LineLaser} {Name l} {Location 1,2,3} {Orientation 0,0,0} {Points [1,2]}",
            "point 1 is not three numbers");
        row("MISSTA {Name Cam} {Link x} {Value 1}", "'x' is not a whole number");
        row("RES {Type INS} {Name INS}", "a result without Status");
        row("NFO {StartPoses 1} {A 1,2,3 0,0}", "the start pose 'A' needs six numbers");
    }

    void whatCannotBeReadIsGenericWithItsReason() {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, reason);
        Reader reader;
        const InfoLine result = reader.read(line.toStdString());
        QVERIFY(std::holds_alternative<GenericMessage>(result.message));
        QStringList reasons;
        for (const Diagnostic& diagnostic : result.diagnostics)
            reasons << QString::fromStdString(diagnostic.message);
        QVERIFY2(reasons.contains(QString(reason)), qPrintable(reasons.join(" | ")));
    }

    void aTimeIsKeptOnlyIfItIsANumber_data() {
        QTest::addColumn<QByteArray>("segment");
        QTest::addColumn<double>("time_s");
        QTest::addColumn<int>("warnings");
        const double none = -1e9;
        const auto row = [](const char* segment, double time_s, int warnings) {
            QTest::newRow(*segment ? segment : "no time") << QByteArray(segment) << time_s << warnings;
        };
        row("", none, 0);
        row("{Time 1.25}", 1.25, 0);
        row("{Time 1} {Time 2}", 1.0, 0);
        row("{Time -5}", -5.0, 0);
        row("{Time 3 s}", 3.0, 1);
        row("{Time}", none, 1);
        row("{Time soon}", none, 1);
        row("{Time nan}", none, 1);
        row("{Time 1e300}", none, 1);
    }

    void aTimeIsKeptOnlyIfItIsANumber() {
        QFETCH(QByteArray, segment);
        QFETCH(double, time_s);
        QFETCH(int, warnings);
        Reader reader;
        const InfoLine result =
            reader.read("SEN " + segment.toStdString() + " {Type MissionTime} {Name c} {Minutes 2}");
        QVERIFY(std::holds_alternative<MissionTimeReading>(result.message));
        const auto time = timeOf(result.message);
        QCOMPARE(time ? time->count() : -1e9, time_s);
        QCOMPARE(countOf(result.diagnostics, Severity::Warning), warnings);
    }

    void onlyTheFirstProblemsOfALineAreReported() {
        std::string line = "SEN {Type Sonar}";
        for (int sensor = 0; sensor < 100; ++sensor)
            line += " {Name F" + std::to_string(sensor) + " Range none}";
        Reader reader;
        const InfoLine result = reader.read(line);
        QCOMPARE(std::get<SonarReadings>(result.message).ranges.size(), std::size_t(100));
        QCOMPARE(result.diagnostics.size(), LineReading::most_diagnostics);
    }

    void udkSpellsAMessageItsOwnWay_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("expected");
        const auto row = [](const char* name, const char* line, const char* expected) {
            QTest::newRow(name) << QByteArray(line) << QByteArray(expected);
        };
        row("a line for each sonar", "SEN {Time 1.5} {Type Sonar} {Name F1 Range 4.5604} {Name F2 Range 2.4576}",
            "SEN {Time 1.5000} {Type Sonar} {Name F1} {Range 4.5604}\r\n"
            "SEN {Time 1.5000} {Type Sonar} {Name F2} {Range 2.4576}\r\n");
        row("a time for what has none", "SEN {Type Touch} {Name L Touch False} {Name R Touch True}",
            "SEN {Time 7.0000} {Type Touch} {Name L} {Touch False}\r\n"
            "SEN {Time 7.0000} {Type Touch} {Name R} {Touch True}\r\n");
        row("but not for an INS", "SEN {Type INS} {Name INS} {Location 4.50,1.90,1.80} {Orientation 0.00,0.50,3.01}",
            "SEN {Type INS} {Name INS} {Location 4.50,1.90,1.80} {Orientation 0.00,0.50,3.01}\r\n");
        row("the state of a ground vehicle",
            "STA {Type GroundVehicle} {Time 47.9754} {FrontSteer 0.2618} {LightToggle True} {LightIntensity 40} "
            "{Battery 99999.9} {View 2}",
            "STA {Time 47.9754} {Battery 99999} {Type GroundVehicle} {LightToggle True} {LightIntensity 100} "
            "{FrontSteer 0.2618}\r\n");
        row("a flying robot without its type", "STA {Type AerialVehicle} {Time 2} {LightToggle False} {Battery 10}",
            "STA {Time 2.0000} {Battery 10}\r\n");
        row("a legged robot by the newer word", "STA {Type LeggedRobot} {Time 2}",
            "STA {Time 2.0000} {Type LeggedVehicle}\r\n");
        row("a package without torques", "MISSTA {Time 1} {Name Cam} {Link 1} {Value 0.5} {Torque -20.00}",
            "ASTA {Time 1.0000} {Name Cam} {Link 1} {Value 0.5000}\r\n");
        row("a mount on the chassis by the robot's class",
            "GEO {Type Sonar} {Name F Location 1,0,0 Orientation 0,0,0 Mount HARD}",
            "GEO {Type Sonar} {Name F} {Location 1.00,0.00,0.00} {Orientation 0.00,0.00,0.00} {Mount P2DX}\r\n");
        row("Panning with two n", "CONF {Type Sonar} {Name R8} {MaxRange 5.0000} {Paning True}",
            "CONF {Type Sonar} {Name R8} {MaxRange 5.0000} {Panning True}\r\n");
        row("no answer about what is not there", "GEO {Type Sonar}", "");
        row("no configuration of it, either", "CONF {Type Sonar}", "");
        row("no results", "RES {Time 1} {Type INS} {Name INS} {Status OK}", "");
    }

    void udkSpellsAMessageItsOwnWay() {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, expected);
        Reader reader;
        std::string out;
        writeUdk(reader.read(line.toStdString()).message, Seconds{7.0}, {"P2DX"}, out);
        QCOMPARE(QByteArray::fromStdString(out), expected);
    }

    void sensorsThatSpeakOnlyWithNewsAreKnown_data() {
        QTest::addColumn<QByteArray>("type");
        QTest::addColumn<bool>("known");
        QTest::addColumn<bool>("speaks_always");
        const auto row = [](const char* type, bool known, bool speaks_always) {
            QTest::newRow(*type ? type : "nothing") << QByteArray(type) << known << speaks_always;
        };
        row("Sonar", true, true);
        row("sONAR", true, true);
        row("INS", true, true);
        row("TouchArray", true, true);
        row("RFID", true, false);
        row("rfidtag", true, false);
        row("VictSensor", true, false);
        row("VictRFID", true, false);
        row("Acoustic", true, false);
        row("Helper", true, false);
        row("ObjectSensor", true, false);
        row("Thermometer", false, true);
        row("", false, true);
    }

    void sensorsThatSpeakOnlyWithNewsAreKnown() {
        QFETCH(QByteArray, type);
        QFETCH(bool, known);
        QFETCH(bool, speaks_always);
        QCOMPARE(isKnownSensor(type.toStdString()), known);
        QCOMPARE(speaksAlways(type.toStdString()), speaks_always);
    }
};

USAR_TEST(tst_SensorDamage)

} // namespace tst_sensor_damage

#include "tst_sensor_damage.moc"
