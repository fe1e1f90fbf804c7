#include <QTest>

#include <random>

#include <QTemporaryDir>

#include "core/mission/files/mission_file.h"
#include "tests/suite/suite.h"

namespace tst_mission_writer {

using namespace usar;
using namespace usar::mission;

namespace {

agent::ParameterSpec spec(const std::string& id, const std::string& unit, const agent::ParameterValue& value) {
    agent::ParameterSpec made;
    made.id = made.label = id;
    made.unit = unit;
    made.default_value = value;
    return made;
}

const std::vector<agent::ParameterSpec> specs{spec("turn_rad", "rad", 0.5), spec("altitude_m", "m", 6.5),
                                              spec("lanes", "", 3LL), spec("return_home", "", true),
                                              spec("corner", "", std::string("nearest"))};

Mission anyMission(std::mt19937& random) {
    std::uniform_real_distribution<double> metres(-300.0, 300.0);
    std::uniform_real_distribution<double> fraction(0.01, 0.99);
    Mission mission;
    mission.name = "Field \"north\" " + std::to_string(random() % 100);
    mission.start = "HillTop";
    mission.area_in_map.min_m = {std::round(metres(random) * 4.0) / 4.0, std::round(metres(random) * 4.0) / 4.0};
    mission.area_in_map.max_m = mission.area_in_map.min_m + Vec2(10.25, 7.5);
    mission.cell_size_m = 0.5;
    mission.parameters = {{"turn_rad", radians(static_cast<double>(random() % 179) + 0.5)},
                          {"altitude_m", fraction(random)},
                          {"lanes", static_cast<long long>(random() % 50)},
                          {"return_home", random() % 2 == 0},
                          {"corner", std::string("north")}};
    if (random() % 2)
        mission.faults = {"wind speed=4", "rotor from=60"};
    if (random() % 2)
        mission.limit_h = 0.5 + static_cast<double>(random() % 50);
    mission.isolate = true;
    mission.adjust = random() % 2 == 0;
    return mission;
}

} // namespace

class tst_MissionWriter : public QObject {
    Q_OBJECT
private slots:
    void whatIsWrittenIsReadBack() {
        std::mt19937 random(7);
        for (int i = 0; i < 200; ++i) {
            const Mission mission = anyMission(random);
            const auto back = readMission(writeMission(mission, specs), "back.json");
            QVERIFY2(back.has_value(), back ? "" : back.error().text().c_str());
            QCOMPARE(back->name, mission.name);
            QCOMPARE(back->start, mission.start);
            QVERIFY(back->area_in_map == mission.area_in_map);
            QCOMPARE(back->cell_size_m, mission.cell_size_m);
            QCOMPARE(back->faults, mission.faults);
            QCOMPARE(back->limit_h, mission.limit_h);
            QVERIFY(back->isolate);
            QCOMPARE(back->adjust, mission.adjust);
            auto parameters = withAnglesInRadians(back->parameters, specs);
            const double turn_rad = std::get<double>(parameters.at("turn_rad"));
            QVERIFY(std::abs(turn_rad - std::get<double>(mission.parameters.at("turn_rad"))) < 1e-12);
            parameters["turn_rad"] = mission.parameters.at("turn_rad");
            QVERIFY(parameters == mission.parameters);
        }
    }

    void anglesAreWrittenAsAPersonTypedThem() {
        Mission mission;
        mission.name = "Field";
        mission.area_in_map = {{0, 0}, {10, 10}};
        mission.parameters["turn_rad"] = radians(33.3);
        const QByteArray json = writeMission(mission, specs);
        QVERIFY2(json.contains("\"turn_rad\": 33.3\n"), json);
    }

    void aPlanInTheMissionsFolderMovesWithIt() {
        Mission mission;
        mission.name = "Field";
        mission.plan = "/data/field/plans/own.lap";
        QVERIFY(writeMission(mission, specs, "/data/field").contains("\"plan\": \"plans/own.lap\""));
        QVERIFY(writeMission(mission, specs, "/data/other").contains("\"plan\": \"/data/field/plans/own.lap\""));
        QCOMPARE(readMission(writeMission(mission, specs, "/data/field"), "/moved/m.json")->plan,
                 std::string("/moved/plans/own.lap"));
    }

    void aMissionWithoutAnAreaStaysWithoutOne() {
        Mission mission;
        mission.name = "Field";
        const auto back = readMission(writeMission(mission, specs), "back.json");
        QVERIFY2(back.has_value(), back ? "" : back.error().text().c_str());
        QVERIFY(back->area_in_map.empty());
    }

    void aFolderThatIsNotThereIsNamed() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("nowhere/mission.json");
        const auto saved = writeMissionFile({}, specs, path);
        QVERIFY(!saved.has_value());
        QCOMPARE(QString::fromStdString(saved.error().where), path);
    }
};

USAR_TEST(tst_MissionWriter)

} // namespace tst_mission_writer

#include "tst_mission_writer.moc"
