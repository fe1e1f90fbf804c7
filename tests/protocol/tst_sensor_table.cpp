// Every row of the table of sensors: what is read from the wire, in our frame and units, and that it is written back.
#include <QTest>

#include <algorithm>
#include <string>

#include "core/base/numbers.h"
#include "core/protocol/fields.h"
#include "core/protocol/reader.h"
#include "core/protocol/writer.h"
#include "tests/suite/suite.h"

namespace tst_sensor_table {

using namespace usar;
using namespace usar::protocol;

namespace {

/// "F1/range=4.5600m; …", without the source.
QByteArray shown(const InfoMessage& message) {
    QByteArray text;
    for (const Field& field : fieldsOf(message)) {
        std::string value = field.text;
        if (field.number) {
            value.clear();
            appendFixed(value, *field.number, 3);
        }
        text += QByteArray::fromStdString((text.isEmpty() ? "" : "; ") + (field.item.empty() ? "" : field.item + "/") +
                                          field.field + "=" + value + field.unit);
    }
    return text;
}

void row(const char* name, const char* container, const char* line, const char* expected) {
    QTest::newRow(name) << QByteArray(container) << QByteArray(line) << QByteArray(expected);
}

void rangesAndPoints() {
    row("IR, grouped", "RangeReadings", "SEN {Time 1.5} {Type IR} {Name A Range 0.5122} {Name B Range 0.8}",
        "A/range=0.512m; B/range=0.800m");
    row("single ray", "RangeReadings", "SEN {Time 41.6} {Type Range} {Name ray} {Range 4.2119}", "ray/range=4.212m");
    row("scanner", "RangeScan", "SEN {Time 1} {Type RangeScanner} {Name S} {Resolution 0.5} {FOV 1} {Range 1,2,3}",
        "S/resolution=0.500rad; S/fov=1.000rad; S/count=3.000; S/minimum=1.000m; S/mean=2.000m; S/maximum=3.000m");
    row("scanner of two axes", "Scan3d",
        "SEN {Time 1} {Type RangeScanner3D} {Name S} {Resolution 0.5,0.25} {FOV 1,0.5} {Range 1,2,3}",
        "S/resolution.0=0.500rad; S/resolution.1=0.250rad; S/fov.0=1.000rad; S/fov.1=0.500rad; S/range.0=1.000m; "
        "S/range.1=2.000m; S/range.2=3.000m");
    row("depth image", "RangeImage",
        "SEN {Time 30.3} {Type RangeImager} {Name k} {Resolution 2,1} {FOV 1.5,0.75} {Frames 2} {Frame 0} {Range "
        "3.5,2.5,}",
        "k/size.0=2.000px; k/size.1=1.000px; k/fov.0=1.500rad; k/fov.1=0.750rad; k/frames=2.000; k/frame=0.000; "
        "k/depth.0=3.500m; k/depth.1=2.500m");
    row("idle depth camera", "RangeImage",
        "SEN {Time 30.2} {Type RangeImager} {Name k} {Resolution 320,240} {FOV 1.5,0.75} {Frames 0} {Frame 0}",
        "k/size.0=320.000px; k/size.1=240.000px; k/fov.0=1.500rad; k/fov.1=0.750rad; k/frames=0.000; k/frame=0.000");
    row("point cloud in Unreal units", "PointCloud",
        "SEN {Time 34.7} {Type PCL} {Name p} {250.00,-500.00,125.00;500.00,-250.00,250.00}",
        "p/count=2.000; p/smallest.x=1.000m; p/smallest.y=1.000m; p/smallest.z=0.500m; p/largest.x=2.000m; "
        "p/largest.y=2.000m; p/largest.z=1.000m");
    row("line of light", "LineLaserReading",
        "SEN {Time 34.5} {Type LineLaser} {Name l} {Location 1,2,3} {Orientation 0,0,1.5} {Points "
        "[1.000,0.500,0.000][2.000,0.250,-1.000]}",
        "l/x=1.000m; l/y=-2.000m; l/z=-3.000m; l/roll=0.000rad; l/pitch=-0.000rad; l/yaw=-1.500rad; l/count=2.000; "
        "l/smallest.x=1.000m; l/smallest.y=-0.500m; l/smallest.z=-0.000m; l/largest.x=2.000m; l/largest.y=-0.250m; "
        "l/largest.z=1.000m");
}

void posesAndMotion() {
    row("attitude only", "InuReading", "SEN {Type INU} {Name I} {Orientation 0.00,0.25,1.50}",
        "I/orientation.roll=0.000rad; I/orientation.pitch=-0.250rad; I/orientation.yaw=-1.500rad");
    row("position fix", "GpsReading",
        "SEN {Type GPS} {Name G} {Latitude 47,30.0000,N} {Longitude 122,18.0000,W} {Fix 1} {Satellites 8}",
        "G/latitude=0.829rad; G/longitude=-2.135rad; G/fix=True; G/satellites=8.000");
    row("position fix without a space", "GpsReading",
        "SEN {Time 31.5} {Type GPS} {Name G} {Latitude 39,0.0000,S} {Longitude 77,0.0000,E}{Fix 1} {Satellites 9}",
        "G/latitude=-0.681rad; G/longitude=1.344rad; G/fix=True; G/satellites=9.000");
    row("no fix", "GpsReading", "SEN {Type GPS} {Name G} {Fix 0} {Satellites 3}", "G/fix=False; G/satellites=3.000");
    row("wheel speeds", "TachometerReading", "SEN {Time 48} {Type Tachometer} {Name T} {Vel 0.5,-0.25} {Pos 1,2}",
        "T/speed.0=0.500rad/s; T/speed.1=-0.250rad/s; T/angle.0=1.000rad; T/angle.1=2.000rad");
    row("acceleration", "AccelerationReading", "SEN {Time 32} {Type Accel} {Name a} {Acceleration 1,2,3}",
        "a/acceleration.x=1.000m/s²; a/acceleration.y=-2.000m/s²; a/acceleration.z=-3.000m/s²");
    row("an accelerometer at rest points up", "AccelerometerReading",
        "SEN {Time 32} {Type AcceleroMeter} {Name a} {ProperAcceleration 0,0,-9.8065}",
        "a/proper_acceleration.x=0.000m/s²; a/proper_acceleration.y=-0.000m/s²; "
        "a/proper_acceleration.z=9.806m/s²");
    row("IMU", "ImuReading",
        "SEN {Time 1} {Type IMU} {Name I} {XYZAcceleration 1,2,3} {AngularVel 0,0,0.5} {AngularAccel 0,0.25,0} "
        "{Rotation 0,0.5,1}",
        "I/acceleration.x=1.000m/s²; I/acceleration.y=-2.000m/s²; I/acceleration.z=-3.000m/s²; "
        "I/angular_velocity.x=0.000rad/s; I/angular_velocity.y=-0.000rad/s; I/angular_velocity.z=-0.500rad/s; "
        "I/angular_acceleration.x=0.000rad/s²; I/angular_acceleration.y=-0.250rad/s²; "
        "I/angular_acceleration.z=-0.000rad/s²; I/orientation.roll=0.000rad; I/orientation.pitch=-0.500rad; "
        "I/orientation.yaw=-1.000rad");
    row("altitude is up on the wire, too", "AltitudeReading",
        "SEN {Time 32.1} {Type AltitudeSensor} {Name a} {relativeAltitude 1.25} {absoluteAltitude 141.25}",
        "a/above_start=1.250m; a/above_sea=141.250m");
    row("compass", "CompassReading", "SEN {Time 1} {Type MagneticCompass} {Name c} {MagneticAngle 2}",
        "c/raw_angle=2.000");
    row("players", "PlayersReading",
        "SEN {Time 67} {Type GroundTruthPlayers} {Name P} {Players 1}{PlayerNum 4} {Anchor None} {IsPlayer True} "
        "{Location 3,-1,1.5} {UTLocation 750,-250,-375} ",
        "P/count=1.000; P PlayerNum 4/number=4.000; P PlayerNum 4/anchor=None; P PlayerNum 4/is_player=True; "
        "P PlayerNum 4/x=3.000m; P PlayerNum 4/y=1.000m; P PlayerNum 4/z=-1.500m; "
        "P PlayerNum 4/position_uu.x=750.000; P PlayerNum 4/position_uu.y=-250.000; "
        "P PlayerNum 4/position_uu.z=-375.000");
}

void thingsFound() {
    row("touch, grouped", "TouchReadings", "SEN {Type Touch} {Name L Touch False} {Name R Touch True}",
        "L/touched=False; R/touched=True");
    row("ring of bumpers", "TouchReadings", "SEN {Time 31} {Type TouchArray} {Name ring} {Touch True}",
        "ring/touched=True");
    row("tags", "RfidReading",
        "SEN {Time 8} {Type RFID} {Name R} {ID 21} {Location 3,4.5,0.25} {Mem seen by robot 2} {ID 22}",
        "R ID 21/id=21.000; R ID 21/x=3.000m; R ID 21/y=-4.500m; R ID 21/z=-0.250m; R ID 21/memory=seen by robot 2; "
        "R ID 22/id=22.000");
    row("tags by another name", "RfidReading", "SEN {Time 8} {Type RFIDTag} {Name R} {ID 17} {Location 1,0,0}",
        "R ID 17/id=17.000; R ID 17/x=1.000m; R ID 17/y=-0.000m; R ID 17/z=-0.000m");
    row("victim parts", "VictimReading",
        "SEN {Time 1} {Type VictSensor} {Name V} {PartName Leg} {Location 2,0.25,0.5} {PartName Head} {Location 1,0,0}",
        "V PartName 1/part=Leg; V PartName 1/x=2.000m; V PartName 1/y=-0.250m; V PartName 1/z=-0.500m; "
        "V PartName 2/part=Head; V PartName 2/x=1.000m; V PartName 2/y=-0.000m; V PartName 2/z=-0.000m");
    row("no victims, no name", "VictimReading", "SEN {Time 1} {Type VictSensor} {Status NoVictims}",
        "status=NoVictims");
    row("victims with tags", "VictimTagReading",
        "SEN {Time 1} {Type VictRFID} {Name V} {ID None} {Status None} {Location 3,2,-1} {ID Becky} {Status ok} "
        "{Location 2,-1,0}",
        "V ID 1/id=None; V ID 1/status=None; V ID 1/x=3.000m; V ID 1/y=-2.000m; V ID 1/z=1.000m; V ID 2/id=Becky; "
        "V ID 2/status=ok; V ID 2/x=2.000m; V ID 2/y=1.000m; V ID 2/z=-0.000m");
    row("human motion", "HumanMotionReading", "SEN {Time 1} {Type HumanMotion} {Name H} {Prob 0.25}",
        "H/probability=0.250");
    row("sound", "SoundReading", "SEN {Time 1} {Type Sound} {Name S} {Loudness 12.5} {Duration 3.25}",
        "S/loudness=12.500dB; S/duration=3.250s");
    row("silence", "AcousticReading", "SEN {Time 1} {Type Acoustic} {Name A} {None}", "A/silence=True");
    row("a near and a far sound", "AcousticReading",
        "SEN {Time 1} {Type Acoustic} {Name A} {Direction 0,1,0} {Volume 0.5} {Duration 1.5} {Delay 0.25} {Far}",
        "A/silence=False; A Direction 1/far=False; A Direction 1/direction.x=0.000; A Direction 1/direction.y=-1.000; "
        "A Direction 1/direction.z=-0.000; A Direction 1/volume=0.500; A Direction 1/duration=1.500s; "
        "A Direction 1/delay=0.250s; A Direction 2/far=True");
}

void surroundings() {
    row("gas", "GasReading", "SEN {Time 1} {Type CO2Sensor} {Name C} {Gas CO2} {Density 0.25}",
        "C/gas=CO2; C/density=0.250");
    row("ball", "BallReading", "SEN {Time 67.2} {Type Helper} {Name b} {Pos3D 1.2,0.1,0} {Visible true}",
        "b/position.x=1.200; b/position.y=0.100; b/position.z=0.000; b/visible=True");
    row("mission time", "MissionTimeReading", "SEN {Time 33} {Type MissionTime} {Name c} {Minutes 2}",
        "c/minutes=2.000min");
    row("objects", "ObjectsReading",
        "SEN {Time 34} {Type ObjectSensor} {Name o} {Object Box1}{Location 3,1,1.5}{Orientation 0,0,1.5}{HitLoc "
        "3,1,1}{Material M_Wood} {Object P}{Location 5,-2,1}{Orientation 0,0,0}{HitLoc 4,-1,1}{Material None}",
        "o Object 1/tag=Box1; o Object 1/x=3.000m; o Object 1/y=-1.000m; o Object 1/z=-1.500m; o Object "
        "1/roll=0.000rad; "
        "o Object 1/pitch=-0.000rad; o Object 1/yaw=-1.500rad; o Object 1/hit.x=3.000m; o Object 1/hit.y=-1.000m; "
        "o Object 1/hit.z=-1.000m; o Object 1/material=M_Wood; o Object 2/tag=P; o Object 2/x=5.000m; "
        "o Object 2/y=2.000m; o Object 2/z=-1.000m; o Object 2/roll=0.000rad; o Object 2/pitch=-0.000rad; "
        "o Object 2/yaw=-0.000rad; o Object 2/hit.x=4.000m; o Object 2/hit.y=1.000m; o Object 2/hit.z=-1.000m; "
        "o Object 2/material=None");
}

void equipment() {
    row("package", "PackageState", "MISSTA {Time 1} {Name Cam} {Link 1} {Value 0.5} {Torque -20.00} {Link 2} {Value 0}",
        "Cam Link 1/link=1.000; Cam Link 1/value=0.500; Cam Link 1/torque=-20.000N m; Cam Link 2/link=2.000; "
        "Cam Link 2/value=0.000");
    row("actuator", "PackageState", "ASTA {Time 1} {Name Arm} {Link 1} {Value -0.5}",
        "Arm Link 1/link=1.000; Arm Link 1/value=-0.500");
    row("gripper", "EffecterState", "EFF {Time 41.2} {Type Gripper} {Name G} {Status CLOSED}", "G/closed=True");
    row("tool changer with a tool", "EffecterState",
        "EFF {Time 41} {Type ToolChanger} {Name T} {Status CLOSED}{ToolType Gripper} {Tool Gripper1}",
        "T/closed=True; T/tool=Gripper1; T/tool_type=Gripper");
    row("effecter that is on", "EffecterState", "EFF {Time 41} {Type Effector} {Name V} {On}", "V/on=True");
    row("path nodes", "PathNodes", "NFO {PathNodes 1} {Door1 4.5,2,1.5 0,0,-1.5}",
        "Door1/x=4.500m; Door1/y=-2.000m; Door1/z=-1.500m; Door1/roll=0.000rad; Door1/pitch=-0.000rad; "
        "Door1/yaw=1.500rad");
    row("closest path node", "ClosestPathNode", "NFO {Pathnode Door1} {Location 4.5,2,1.5}",
        "Door1/x=4.500m; Door1/y=-2.000m; Door1/z=-1.500m");
    row("zooms of two cameras", "Response",
        "RES {Time 1} {Type Camera} {Name A} {FOV 1.5} {Status Failed} {Name B} {FOV 0.75} {Status OK}",
        "A/status=Failed; A/fov=1.500rad; A/part_status=Failed; B/fov=0.750rad; B/part_status=OK");
    row("viewports", "Response",
        "RES {Time 1} {Type Viewports} {Config SingleView} {Status OK} {Viewport1 Camera} {Status OK}",
        "status=OK; Config SingleView/part_status=OK; Viewport1 Camera/part_status=OK");
    row("a tag that was read", "Response",
        "RES {Time 1} {Type RFID} {Name R} {status OK} {ID 118} {Mem visited by robot 2}",
        "R/status=OK; R/tag_id=118.000; R/memory=visited by robot 2");
}

} // namespace

class tst_SensorTable : public QObject {
    Q_OBJECT
private slots:
    void readsEveryTypeIntoItsContainer_data();
    void readsEveryTypeIntoItsContainer();
    void everyTypeComesBackFromTheWire_data() { readsEveryTypeIntoItsContainer_data(); }
    void everyTypeComesBackFromTheWire();
    void everyTypeIsReadInAnyCase_data() { readsEveryTypeIntoItsContainer_data(); }
    void everyTypeIsReadInAnyCase();
    void damageLeavesTheLineGenericAndSaysWhy_data();
    void damageLeavesTheLineGenericAndSaysWhy();
};

void tst_SensorTable::readsEveryTypeIntoItsContainer_data() {
    QTest::addColumn<QByteArray>("container");
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("expected");
    rangesAndPoints();
    posesAndMotion();
    thingsFound();
    surroundings();
    equipment();
}

void tst_SensorTable::readsEveryTypeIntoItsContainer() {
    QFETCH(QByteArray, container);
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, expected);
    Reader reader;
    const InfoLine result = reader.read(line.toStdString());
    for (const Diagnostic& diagnostic : result.diagnostics)
        QFAIL(toText(diagnostic).c_str());
    QCOMPARE(QByteArray::fromStdString(std::string(containerOf(result.message))), container);
    QCOMPARE(shown(result.message), expected);
}

void tst_SensorTable::everyTypeComesBackFromTheWire() {
    QFETCH(QByteArray, line);
    Reader reader;
    const InfoMessage once = reader.read(line.toStdString()).message;
    std::string written;
    write(once, written);
    const InfoLine twice = reader.read(written);
    QVERIFY2(twice.diagnostics.empty(), written.c_str());
    QCOMPARE(shown(twice.message), shown(once));
    QCOMPARE(timeOf(twice.message), timeOf(once));
}

void tst_SensorTable::everyTypeIsReadInAnyCase() {
    QFETCH(QByteArray, container);
    QFETCH(QByteArray, line);
    Reader reader;
    const InfoLine upper = reader.read(line.toUpper().toStdString());
    QCOMPARE(QByteArray::fromStdString(std::string(containerOf(upper.message))), container);
    QVERIFY(upper.diagnostics.empty());
}

void tst_SensorTable::damageLeavesTheLineGenericAndSaysWhy_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("a vector of two") << QByteArray("SEN {Type Accel} {Name a} {Acceleration 1,2}");
    QTest::newRow("a pose without its orientation")
        << QByteArray("SEN {Type ObjectSensor} {Name o} {Object B} {Location 1,2,3}");
    QTest::newRow("a group without its value") << QByteArray("MISSTA {Time 1} {Name Cam} {Link 1}");
    QTest::newRow("a tag without a number") << QByteArray("SEN {Type RFID} {Name R} {ID abc}");
    QTest::newRow("neither true nor false") << QByteArray("SEN {Type Touch} {Name L Touch maybe}");
    QTest::newRow("a point of two") << QByteArray("SEN {Type PCL} {Name p} {1,2,3;4,5}");
    QTest::newRow("minutes that are none") << QByteArray("SEN {Type MissionTime} {Name c} {Minutes soon}");
}

void tst_SensorTable::damageLeavesTheLineGenericAndSaysWhy() {
    QFETCH(QByteArray, line);
    Reader reader;
    const InfoLine result = reader.read(line.toStdString());
    QVERIFY(std::holds_alternative<GenericMessage>(result.message));
    QCOMPARE(std::ranges::count(result.diagnostics, Severity::Error, &Diagnostic::severity), 1);
    QCOMPARE(result.text, line.toStdString());
}

USAR_TEST(tst_SensorTable)

} // namespace tst_sensor_table

#include "tst_sensor_table.moc"
