#include <QTest>

#include "core/mission/files/flown_mission.h"
#include "tests/suite/suite.h"

namespace tst_flown_mission {

using namespace usar;
using namespace usar::mission;

class tst_FlownMission : public QObject {
    Q_OBJECT
private slots:
    void comesBackAsItWasNoted() {
        FlownMission flown;
        flown.mission.name = "Woods \"north\"\tside";
        flown.mission.world = "tall_test";
        flown.mission.start = "North";
        flown.mission.behavior = "airrobot/posh";
        flown.mission.area_in_map = {{-12.5, 3.25}, {20.125, 40.0}};
        flown.mission.parameters = {{"scan_altitude_m", 6.5}, {"lanes", 3LL}, {"charge", true}};
        flown.mission.cell_size_m = 0.5;
        flown.mission.faults = {"wind speed=5"};
        flown.mission.isolate = true;
        flown.seed = 18446744073709551615ULL;
        flown.continues = "/data/R1.usarrec";
        const std::string text = noteOf(flown);
        QVERIFY(text.find('\n') == std::string::npos);
        const auto read = readFlownMission(text, "r.usarrec");
        QVERIFY2(read.has_value(), read ? "" : read.error().text().c_str());
        QCOMPARE(read->mission.name, flown.mission.name);
        QCOMPARE(read->mission.start, flown.mission.start);
        QCOMPARE(read->mission.behavior, flown.mission.behavior);
        QCOMPARE(read->mission.area_in_map, flown.mission.area_in_map);
        QVERIFY(read->mission.parameters == flown.mission.parameters);
        QCOMPARE(read->mission.cell_size_m, flown.mission.cell_size_m);
        QCOMPARE(read->mission.faults, flown.mission.faults);
        QVERIFY(read->mission.isolate);
        QVERIFY(read->seed == flown.seed);
        QCOMPARE(read->continues, flown.continues);
    }

    void anglesAreNotedInDegrees() {
        FlownMission flown;
        flown.mission.name = "Turn";
        flown.mission.parameters = {{"tilt_rad", pi / 2}};
        agent::ParameterSpec spec;
        spec.id = "tilt_rad";
        spec.unit = "rad";
        const auto read = readFlownMission(noteOf(flown, {spec}), "r.usarrec");
        QVERIFY(read.has_value());
        QVERIFY(withAnglesInRadians(read->mission.parameters, {spec}) == flown.mission.parameters);
        QVERIFY(!read->seed && read->continues.isEmpty());
    }

    void aNoteThatIsNoneNamesTheFile_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("no JSON") << QByteArray("airrobot/cpp");
        QTest::newRow("no mission") << QByteArray("{\"seed\":\"3\"}");
        QTest::newRow("nothing") << QByteArray();
    }

    void aNoteThatIsNoneNamesTheFile() {
        QFETCH(QByteArray, text);
        const auto read = readFlownMission(text.toStdString(), "r.usarrec");
        QVERIFY(!read);
        QVERIFY2(read.error().text().find("r.usarrec") != std::string::npos, read.error().text().c_str());
    }
};

USAR_TEST(tst_FlownMission)

} // namespace tst_flown_mission

#include "tst_flown_mission.moc"
