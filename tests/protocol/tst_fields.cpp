#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/numbers.h"
#include "core/protocol/fields.h"
#include "core/protocol/reader.h"
#include "corpus.h"
#include "tests/suite/suite.h"

namespace tst_fields {

using namespace usar;
using namespace usar::protocol;

namespace {

InfoMessage messageOf(const std::string& line) {
    Reader reader;
    return reader.read(line).message;
}

/// "path=value unit" a field, joined by "; ".
QByteArray shown(const std::string& line) {
    QByteArray text;
    for (const Field& field : fieldsOf(messageOf(line))) {
        std::string value = field.text;
        if (field.number) {
            value.clear();
            appendFixed(value, *field.number, 2);
        }
        text += QByteArray::fromStdString((text.isEmpty() ? "" : "; ") + field.path() + "=" + value + field.unit);
    }
    return text;
}

void row(const char* name, const char* line, const char* expected) {
    QTest::newRow(name) << QByteArray(line) << QByteArray(expected);
}

void newsAndReadings() {
    row("greeting", "NFO {Gametype G} {Level L} {TimeLimit 20}",
        "NFO/game_type=G; NFO/level=L; NFO/time_limit=20.00min");
    row("start poses", "NFO {StartPoses 1} {A 1,2,3 0,0,0.5}",
        "NFO StartPoses/A/x=1.00m; NFO StartPoses/A/y=-2.00m; NFO StartPoses/A/z=-3.00m; NFO "
        "StartPoses/A/roll=0.00rad; "
        "NFO StartPoses/A/pitch=-0.00rad; NFO StartPoses/A/yaw=-0.50rad");
    row("lockstep", "NFO {Lockstep True}", "NFO/lockstep=True");
    row("aerial state",
        "STA {Type AerialVehicle} {Time 1} {LightToggle False} {LightIntensity 5} {Battery 1180} {View -1}",
        "STA/kind=AerialVehicle; STA/battery=1180.00s; STA/light=False; STA/light_intensity=5.00%; STA/view=-1.00");
    row("joints", "STA {Time 1} {FrontSteer 0.25} {RearSteer 0.5} {FLFlipper 0.75}",
        "STA/front_steer=-0.25rad; STA/rear_steer=-0.50rad; STA/FLFlipper/angle=0.75rad");
    row("state with more than we know",
        "STA {Type Submarine} {Time 1} {Battery 5} {Mode Dive} {Drift 1,2,3} {CountPer1sec 10}",
        "STA/battery=5.00s; STA/kind=Submarine; STA/Mode=Dive; STA/Drift.x=1.00; STA/Drift.y=2.00; "
        "STA/Drift.z=3.00; STA/CountPer1sec=10.00");
    row("sonars without a range", "SEN {Type Sonar} {Name F1} {Echo 0.5}", "SEN Sonar/F1/Echo=0.50");
    row("sonars", "SEN {Type Sonar} {Name F1 Range 4.5} {Name F2 Range nan}",
        "SEN Sonar/F1/range=4.50m; SEN Sonar/F2/range=nanm");
    row("odometry", "SEN {Type Odometry} {Name O} {Pose 1,2,0.5}",
        "SEN Odometry/O/x=1.00m; SEN Odometry/O/y=-2.00m; SEN Odometry/O/yaw=-0.50rad");
    row("an odometry without news", "SEN {Type Odometry} {Name O}", "");
    row("encoders", "SEN {Type Encoder} {Name L Tick -30}", "SEN Encoder/L/ticks=-30.00");
    row("ground truth", "SEN {Type GroundTruth} {Name G} {Location 1,2,3} {Orientation 0.1,0.2,0.3}",
        "SEN GroundTruth/G/x=1.00m; SEN GroundTruth/G/y=-2.00m; SEN GroundTruth/G/z=-3.00m; "
        "SEN GroundTruth/G/roll=0.10rad; SEN GroundTruth/G/pitch=-0.20rad; SEN GroundTruth/G/yaw=-0.30rad");
    row("INS has a stream of its own", "SEN {Type INS} {Name I} {Location 1,2,3} {Orientation 0,0,0}",
        "SEN INS/I/x=1.00m; SEN INS/I/y=-2.00m; SEN INS/I/z=-3.00m; SEN INS/I/roll=0.00rad; SEN INS/I/pitch=-0.00rad; "
        "SEN INS/I/yaw=-0.00rad");
}

void answersAndUnknowns() {
    row("geometry of a robot",
        "GEO {Type GroundVehicle} {Name P} {Dimensions 1,2,3} {COG 0,1,2} {WheelRadius 4} "
        "{WheelSeparation 5} {WheelBase 6}",
        "GEO GroundVehicle/P/length=1.00m; GEO GroundVehicle/P/width=2.00m; GEO GroundVehicle/P/height=3.00m; "
        "GEO GroundVehicle/P/center_x=0.00m; GEO GroundVehicle/P/center_y=-1.00m; GEO GroundVehicle/P/center_z=-2.00m; "
        "GEO GroundVehicle/P/wheel_radius=4.00m; GEO GroundVehicle/P/wheel_separation=5.00m; "
        "GEO GroundVehicle/P/wheel_base=6.00m");
    row("geometry of a sonar", "GEO {Type Sonar} {Name F Location 1,0,0 Orientation 0,0,0 Mount HARD}",
        "GEO Sonar/F/x=1.00m; GEO Sonar/F/y=-0.00m; GEO Sonar/F/z=-0.00m; GEO Sonar/F/roll=0.00rad; "
        "GEO Sonar/F/pitch=-0.00rad; GEO Sonar/F/yaw=-0.00rad; GEO Sonar/F/mount=HARD");
    row("configuration", "CONF {Type Sonar} {Name F} {MaxRange 5.0} {Paning True}",
        "CONF Sonar/F/MaxRange=5.00; CONF Sonar/F/Paning=True");
    row("response", "RES {Type INS} {Name I} {Status Failed}", "RES INS/I/status=Failed");
    row("generic number and text", "SEN {Time 1} {Type Geiger} {Name C} {Source Radon} {Dose 0.5}",
        "SEN Geiger/C/Source=Radon; SEN Geiger/C/Dose=0.50");
    row("generic vectors stay in the wire's frame",
        "SEN {Type X} {Name N} {Location 1,2,3} {Orientation 0,1,2} {Vel 1,2}",
        "SEN X/N/Location.x=1.00; SEN X/N/Location.y=2.00; SEN X/N/Location.z=3.00; SEN X/N/Orientation.roll=0.00; "
        "SEN X/N/Orientation.pitch=1.00; SEN X/N/Orientation.yaw=2.00; SEN X/N/Vel.0=1.00; SEN X/N/Vel.1=2.00");
    row("generic groups", "SEN {Time 1} {Type Arm} {Name Cam} {Link 1} {Value 0.5} {Link 2} {Value 0.25}",
        "SEN Arm/Cam Link 1/Link=1.00; SEN Arm/Cam Link 1/Value=0.50; SEN Arm/Cam Link 2/Link=2.00; "
        "SEN Arm/Cam Link 2/Value=0.25");
    row("generic pairs", "SEN {Type Feeler} {Name A Depth 0.5} {Name B Depth 1.#INF}",
        "SEN Feeler/A/Depth=0.50; SEN Feeler/B/Depth=nan");
    row("generic composite", "SEN {Type Star} {Name G} {Latitude 39,8.03,N}", "SEN Star/G/Latitude=39,8.03,N");
    row("generic lone word", "SEN {Type Lamp} {Name V} {On}", "SEN Lamp/V/On=");
    row("generic long list", "SEN {Type Depth} {Name D} {Values 1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,}",
        "SEN Depth/D/Values.count=17.00; SEN Depth/D/Values.minimum=1.00; SEN Depth/D/Values.mean=9.00; "
        "SEN Depth/D/Values.maximum=17.00");
}

} // namespace

class tst_Fields : public QObject {
    Q_OBJECT
private slots:
    void namesEveryValueOfAMessage_data();
    void namesEveryValueOfAMessage();
    void aScanIsSummedUpWithoutItsGaps();
    void everyLineOfTheCorpusShowsItsNews();
    void tellsTheTimeOfAnyMessage_data();
    void tellsTheTimeOfAnyMessage();
};

void tst_Fields::namesEveryValueOfAMessage_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("expected");
    newsAndReadings();
    answersAndUnknowns();
}

void tst_Fields::namesEveryValueOfAMessage() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, expected);
    QCOMPARE(shown(line.toStdString()), expected);
}

void tst_Fields::aScanIsSummedUpWithoutItsGaps() {
    QCOMPARE(shown("SEN {Type RangeScanner} {Name S} {Resolution 0.5} {FOV 1} {Range 1,nan,3}"),
             QByteArray("SEN RangeScanner/S/resolution=0.50rad; SEN RangeScanner/S/fov=1.00rad; "
                        "SEN RangeScanner/S/count=3.00; SEN RangeScanner/S/minimum=1.00m; "
                        "SEN RangeScanner/S/mean=2.00m; SEN RangeScanner/S/maximum=3.00m"));
    QVERIFY(shown("SEN {Type RangeScanner} {Name S} {Resolution 0.5} {FOV 1} {Range nan}").contains("minimum=nanm"));
    QVERIFY(shown("SEN {Type IRScanner} {Name S} {Resolution 0.5} {FOV 1} {Range 1}").contains("SEN IRScanner/S/fov="));
}

void tst_Fields::everyLineOfTheCorpusShowsItsNews() {
    Reader reader;
    for (const corpus::Line& line : corpus::infoLines()) {
        const InfoMessage message = reader.read(line.text).message;
        const std::vector<Field> fields = fieldsOf(message);
        std::set<std::string> paths;
        for (const Field& field : fields) {
            QVERIFY2(!field.source.empty() && !field.field.empty(), line.place.c_str());
            QVERIFY2(!field.number || std::isfinite(*field.number), line.place.c_str());
            paths.insert(field.path());
        }
        const auto* const generic = std::get_if<GenericMessage>(&message);
        const bool news = generic && std::ranges::any_of(generic->segments, [](const KeyValue& segment) {
                              return segment.key != "Type" && segment.key != "Time" && segment.key != "Name";
                          });
        QVERIFY2(!news || !fields.empty(), line.place.c_str());
    }
}

void tst_Fields::tellsTheTimeOfAnyMessage_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<double>("time_s"); // negative for none
    QTest::newRow("state") << QByteArray("STA {Type AerialVehicle} {Time 2.5}") << 2.5;
    QTest::newRow("a sensor without time") << QByteArray("SEN {Type INS} {Location 1,2,3} {Orientation 0,0,0}") << -1.0;
    QTest::newRow("scan") << QByteArray("SEN {Time 3.5} {Type RangeScanner} {FOV 1} {Resolution 1} {Range 1}") << 3.5;
    QTest::newRow("generic") << QByteArray("SEN {Time 4.5} {Type Camera} ") << 4.5;
    QTest::newRow("generic nonsense") << QByteArray("SEN {Time nan} {Type Camera} ") << -1.0;
    QTest::newRow("start poses have none") << QByteArray("NFO {StartPoses 0}") << -1.0;
}

void tst_Fields::tellsTheTimeOfAnyMessage() {
    QFETCH(QByteArray, line);
    QFETCH(double, time_s);
    QCOMPARE(timeOf(messageOf(line.toStdString())).value_or(Seconds(-1.0)).count(), time_s);
}

USAR_TEST(tst_Fields)

} // namespace tst_fields

#include "tst_fields.moc"
