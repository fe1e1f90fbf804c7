#include <QTest>

#include <cmath>

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include "core/mission/files/json_positions.h"
#include "core/mission/files/mission_file.h"
#include "tests/suite/suite.h"

namespace tst_mission_file {

using namespace usar;
using namespace usar::mission;

namespace {

const QByteArray smallest = R"({"name": "Field", "area": {"x": -5, "y": 2.5, "width": 60, "height": 40}})";
const QByteArray area = R"("area": {"x": 0, "y": 0, "width": 60, "height": 40})";

void addRefusalColumns() {
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("where");
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("mend");
}

void refused(const char* row, const QByteArray& json, const QString& where, const QString& what, const QString& mend) {
    QTest::newRow(row) << json << where << what << mend;
}

void checkRefusal() {
    QFETCH(QByteArray, json);
    QFETCH(QString, where);
    QFETCH(QString, what);
    QFETCH(QString, mend);
    const auto mission = readMission(json, "m.json");
    QVERIFY(!mission.has_value());
    const QByteArray text = QByteArray::fromStdString(mission.error().text());
    QVERIFY2(QString::fromStdString(mission.error().where).startsWith(where), text);
    QVERIFY2(QString::fromStdString(mission.error().what).contains(what), text);
    QVERIFY2(QString::fromStdString(mission.error().mend).contains(mend), text);
}

} // namespace

class tst_MissionFile : public QObject {
    Q_OBJECT
private slots:
    void takesTheSmallestFileAndFillsInTheRest() {
        const auto mission = readMission(smallest, "m.json");
        QVERIFY2(mission.has_value(), mission ? "" : mission.error().text().c_str());
        QCOMPARE(mission->name, std::string("Field"));
        QVERIFY(mission->area_in_map == (Rectangle{{-5, 2.5}, {55, 42.5}}));
        QCOMPARE(mission->world, std::string("tall_test"));
        QCOMPARE(mission->start, std::string("PlayerStart"));
        QCOMPARE(mission->cell_size_m, 0.25);
        QVERIFY(mission->parameters.empty());
        QVERIFY(!mission->limit_h);
    }

    void takesEveryKey();

    void aPlanLiesBesideItsMission_data() {
        QTest::addColumn<QString>("written");
        QTest::addColumn<QString>("mission");
        QTest::addColumn<QString>("expected");
        QTest::newRow("name alone") << "own.lap"
                                    << "/data/field/m.json"
                                    << "/data/field/own.lap";
        QTest::newRow("folder above") << "../own.lap"
                                      << "/data/field/m.json"
                                      << "/data/own.lap";
        QTest::newRow("whole path") << "/plans/own.lap"
                                    << "/data/field/m.json"
                                    << "/plans/own.lap";
        QTest::newRow("mission of the present folder") << "own.lap"
                                                       << "m.json"
                                                       << "own.lap";
    }

    void aPlanLiesBesideItsMission();

    void parametersKeepTheirTypes();

    void anglesAreTurnedIntoRadians() {
        agent::ParameterSpec angle;
        angle.id = "tilt_rad";
        angle.unit = "rad";
        agent::ParameterSpec second = angle;
        second.id = "yaw_rad";
        agent::ParameterSpec length;
        length.id = "altitude_m";
        length.unit = "m";
        const auto values =
            withAnglesInRadians({{"tilt_rad", 90LL}, {"yaw_rad", -45.0}, {"altitude_m", 6LL}}, {angle, second, length});
        QCOMPARE(std::get<double>(values.at("tilt_rad")), pi / 2);
        QCOMPARE(std::get<double>(values.at("yaw_rad")), -pi / 4);
        QCOMPARE(std::get<long long>(values.at("altitude_m")), 6LL);
        QVERIFY(withAnglesInRadians({}, {angle}).empty());
    }

    void rejectsUnfitKeysAndSaysWhere_data();

    void rejectsUnfitKeysAndSaysWhere() { checkRefusal(); }

    void rejectsUnfitValuesAndSaysWhere_data();

    void rejectsUnfitValuesAndSaysWhere() { checkRefusal(); }

    void everyCutOffFileIsRefusedWithAPlace() {
        for (qsizetype length = 0; length < smallest.size(); ++length) {
            const auto mission = readMission(smallest.left(length), "m.json");
            QVERIFY(!mission.has_value());
            QVERIFY(QString::fromStdString(mission.error().where).startsWith("m.json:1:"));
        }
    }

    void aFileThatCannotBeReadIsNamed() {
        const auto mission = readMissionFile("/no/such/mission.json");
        QVERIFY(!mission.has_value());
        QCOMPARE(mission.error().where, std::string("/no/such/mission.json"));
        QVERIFY(!mission.error().mend.empty());
    }

    void aHugeFileIsNotRead() {
        QTemporaryDir folder;
        QFile file(folder.filePath("huge.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(2 << 20, ' '));
        file.close();
        const auto mission = readMissionFile(file.fileName());
        QVERIFY(!mission.has_value());
        QVERIFY(mission.error().what.find("larger") != std::string::npos);
    }

    void theMissionsThatComeWithTheProgramAreGood_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("world");
        QTest::addColumn<double>("area_m2");
        QTest::newRow("quick scan") << "quick_scan.json"
                                    << "tall_test" << 60.0 * 40.0;
        QTest::newRow("tall test") << "tall_test.json"
                                   << "tall_test" << 200.0 * 200.0;
        QTest::newRow("coast") << "coast_cliff.json"
                               << "point_lookout" << 80.0 * 80.0;
        QTest::newRow("volcano") << "whole_volcano.json"
                                 << "volcano" << 860.0 * 600.0;
        QTest::newRow("square kilometer") << "square_kilometer.json"
                                          << "point_lookout" << 1e6;
        QTest::newRow("the same by truth") << "square_kilometer_truth.json"
                                           << "point_lookout" << 1e6;
        QTest::newRow("warehouse") << "warehouse.json"
                                   << "warehouse" << 8.0 * 24.0;
        QTest::newRow("town") << "town.json"
                              << "town" << 110.0 * 110.0;
        QTest::newRow("quarry") << "quarry.json"
                                << "quarry" << 140.0 * 140.0;
    }

    void theMissionsThatComeWithTheProgramAreGood() {
        QFETCH(QString, file);
        QFETCH(double, area_m2);
        const auto mission = readMissionFile(USAR_SOURCE_DIR "/resources/missions/" + file);
        QVERIFY2(mission.has_value(), mission ? "" : mission.error().text().c_str());
        QCOMPARE(mission->area_in_map.area_m2(), area_m2);
        QTEST(QString::fromStdString(mission->world), "world");
    }

    void columnsCountCharacters() {
        QCOMPARE(lineAndColumn("abc", 0), QString("1:1"));
        QCOMPARE(lineAndColumn("a\nbc", 3), QString("2:2"));
        QCOMPARE(lineAndColumn("\xc3\xa4x", 2), QString("1:2")); // one letter of two bytes
        QCOMPARE(lineAndColumn("ab\n", 99), QString("2:1"));
    }

    void keysAreFoundInEveryCorner();

    void everyKeyKeepsItsPlace();

    void aHundredThousandKeysAreReadAtOnce();
};

void tst_MissionFile::takesEveryKey() {
    const auto mission = readMission(R"({"name": "a", "world": "b", "robot": "USARBot.C", "start": "d", "behavior": "e",
    "area": {"x": 1, "y": 2, "width": 3, "height": 4}, "parameters": {}, "cell_size_m": 0.1, "limit_h": 1.5,
    "faults": ["wind speed=4", "rotor from=60"],
    "isolate": true, "adjust": true, "preset": "fast"})",
                                     "m.json");
    QVERIFY(mission.has_value());
    QCOMPARE(mission->world, std::string("b"));
    QCOMPARE(mission->robot_class, std::string("USARBot.C"));
    QCOMPARE(mission->start, std::string("d"));
    QCOMPARE(mission->behavior, std::string("e"));
    QCOMPARE(mission->cell_size_m, 0.1);
    QCOMPARE(mission->limit_h, std::optional(1.5));
    QVERIFY(mission->isolate);
    QVERIFY(mission->adjust);
    QCOMPARE(mission->preset, std::string("fast"));
    QCOMPARE(readMission(writeMission(*mission, {}), "m.json")->preset, mission->preset);
    QCOMPARE(mission->faults, (std::vector<std::string>{"wind speed=4", "rotor from=60"}));
}

void tst_MissionFile::aPlanLiesBesideItsMission() {
    QFETCH(QString, written);
    QFETCH(QString, mission);
    QFETCH(QString, expected);
    QByteArray json = smallest;
    json.insert(json.size() - 1, ", \"plan\": \"" + written.toUtf8() + '"');
    const auto read = readMission(json, mission);
    QVERIFY2(read.has_value(), read ? "" : read.error().text().c_str());
    QCOMPARE(QString::fromStdString(read->plan), expected);
    QVERIFY(readMission(smallest, mission)->plan.empty());
}

void tst_MissionFile::parametersKeepTheirTypes() {
    QByteArray json = smallest;
    json.insert(json.size() - 1, R"(, "parameters": {"a_m": 6.5, "count": 3, "on": true, "mode": "slow", "f_m": -2})");
    const auto mission = readMission(json, "m.json");
    QVERIFY(mission.has_value());
    const std::map<std::string, agent::ParameterValue> expected{
        {"a_m", 6.5}, {"count", 3LL}, {"on", true}, {"mode", std::string("slow")}, {"f_m", -2LL}};
    QVERIFY(mission->parameters == expected);
}

void tst_MissionFile::rejectsUnfitKeysAndSaysWhere_data() {
    addRefusalColumns();
    const QByteArray good = "{\n  \"name\": \"a\",\n  " + area;
    refused("nothing", "", "m.json:1:1", "not JSON", "");
    refused("comma missing", "{\n  \"name\": \"a\"\n  \"world\": \"b\"\n}", "m.json:3:", "not JSON", "comma");
    refused("a list", "[1]", "m.json:1:1", "object in braces", "{");
    refused("misspelt key", good + ",\n  \"behaviour\": \"e\"\n}", "m.json:4:3", "\"behaviour\"", "\"behavior\"");
    refused("misspelt key of the area", R"({"name": "a", "area": {"x": 0, "widht": 60}})", "m.json:1:32", "\"widht\"",
            "\"width\"");
    refused("key given twice", good + ",\n  \"name\": \"b\"}", "m.json:4:3", "twice", "one");
    refused("parameter given twice", good + ",\n\"parameters\": {\"a\": 1, \"a\": 2}}", "m.json:4:24", "twice", "one");
    refused("name missing", "{" + area + "}", "m.json:1:1", "\"name\" is missing", "add");
    refused("height missing", R"({"name": "a", "area": {"x": 0, "y": 0, "width": 60}})", "m.json:1:23",
            "\"height\" is missing in \"area\"", "add");
}

void tst_MissionFile::rejectsUnfitValuesAndSaysWhere_data() {
    addRefusalColumns();
    const QByteArray good = "{\n  \"name\": \"a\",\n  " + area;
    const auto withArea = [](const QByteArray& members) { return R"({"name": "a", "area": {)" + members + "}}"; };
    refused("name is a number", "{\n\"name\": 7, " + area + "}", "m.json:2:9", "not a text", "quotes");
    refused("name is empty", R"({"name": " ", )" + area + "}", "m.json:1:10", "not a text", "empty");
    refused("area is a list", R"({"name": "a", "area": [0, 0, 60, 40]})", "m.json:1:23", "not an object", "braces");
    refused("number in quotes", withArea(R"("x": "0", "y": 0, "width": 6, "height": 4)"), "m.json:1:29",
            "\"x\" is not a number", "without quotes");
    refused("area without width", withArea("\"x\": 0, \"y\": 0,\n\"width\": 0, \"height\": 4"), "m.json:2:10",
            "no size", "\"width\"");
    refused("negative height", withArea("\"x\": 0, \"y\": 0, \"width\": 4,\n\"height\": -4"), "m.json:2:11", "no size",
            "\"height\"");
    refused("width not a number", withArea(R"("x": 0, "y": 0, "width": NaN, "height": 4)"), "m.json:1:", "not JSON",
            "");
    refused("area beyond every world", withArea(R"("x": 1e7, "y": 0, "width": 4, "height": 4)"), "m.json:1:23",
            "further away", "origin");
    refused("cell size zero", good + ",\n\"cell_size_m\": 0}", "m.json:4:16", "cell size", "0.25");
    refused("cell size a text", good + ",\n\"cell_size_m\": \"fine\"}", "m.json:4:16", "not a number", "meters");
    refused("limit zero", good + ",\n\"limit_h\": 0}", "m.json:4:12", "no time above 0", "hours");
    refused("limit too long", good + ",\n\"limit_h\": 10001}", "m.json:4:12", "between 0.000001 and 10000",
            "leave it out");
    refused("limit too short", good + ",\n\"limit_h\": 1e-9}", "m.json:4:12", "between 0.000001 and 10000", "hours");
    refused("limit negative", good + ",\n\"limit_h\": -2}", "m.json:4:12", "no time above 0", "leave it out");
    refused("limit with a unit", good + ",\n\"limit_h\": \"20h\"}", "m.json:4:12", "not a number", "in hours");
    refused("limit null", good + ",\n\"limit_h\": null}", "m.json:4:12", "not a number", "in hours");
    refused("parameter is a list", good + ",\n\"parameters\": {\"lanes\": [1]}}", "m.json:4:25",
            "\"lanes\" is no parameter", "number");
    refused("a fault alone", good + ",\n\"faults\": \"wind\"}", "m.json:4:11", "not a list", "square brackets");
    refused("isolation is a text", good + ",\n\"isolate\": \"yes\"}", "m.json:4:12", "neither true nor false",
            "without quotes");
    refused("a fault is a number", good + ",\n\"faults\": [1]}", "m.json:4:11", "not a text", "quotes");
    refused("parameters are a text", good + ",\n\"parameters\": \"fast\"}", "m.json:4:15", "not an object", "braces");
}

void tst_MissionFile::keysAreFoundInEveryCorner() {
    const QByteArray json = R"({ "a" : [ {"b":"}, \" :"}, [], {}, 1 ] , "c\u0041": { "d" : null },"e":true})";
    QStringList paths;
    for (const JsonKey& key : jsonKeys(json)) {
        paths << key.path();
        QCOMPARE(json[key.key_offset], '"');
    }
    QCOMPARE(paths, QStringList({"a", "a[0].b", "cA", "cA.d", "e"}));
    QVERIFY(jsonKeys("{}").empty());
    QVERIFY(jsonKeys("[]").empty());
}

void tst_MissionFile::everyKeyKeepsItsPlace() {
    const auto mission =
        readMission("{ \"name\": \"\xc3\xa4\",\n  " + area + ",\n\"parameters\":\n {\"lanes\":  3}}", "m.json");
    QVERIFY(mission.has_value());
    QCOMPARE(mission->places.at("name").key, std::string("m.json:1:3"));
    QCOMPARE(mission->places.at("name").value, std::string("m.json:1:11"));
    QCOMPARE(mission->places.at("area").key, std::string("m.json:2:3"));
    QCOMPARE(mission->places.at("area.y").value, std::string("m.json:2:25"));
    QCOMPARE(mission->places.at("parameters.lanes").key, std::string("m.json:4:3"));
    QCOMPARE(mission->places.at("parameters.lanes").value, std::string("m.json:4:13"));
    const Error wrong{"it is wrong", "parameter lanes", "Mend it"};
    QCOMPARE(atKey(*mission, "parameters.lanes", wrong).text(),
             std::string("m.json:4:3: parameter lanes: it is wrong. Mend it."));
    QCOMPARE(atValue(*mission, "parameters.lanes", wrong).where, std::string("m.json:4:13"));
    QCOMPARE(atValue(*mission, "start", wrong), wrong); // not in the file
}

void tst_MissionFile::aHundredThousandKeysAreReadAtOnce() {
    QByteArray json = "{\"name\": \"a\", " + area + ", \"parameters\": {\"first\": 0";
    for (int i = 0; i < 100000; ++i)
        json += ",\"" + QByteArray::number(i, 36) + "\":" + QByteArray::number(i % 10);
    QElapsedTimer timer;
    timer.start();
    const auto mission = readMission(json + "}}", "m.json");
    QVERIFY(mission.has_value());
    QCOMPARE(mission->parameters.size(), std::size_t(100001));
    QVERIFY2(timer.elapsed() < 60'000, qPrintable(QString::number(timer.elapsed()))); // it was minutes
}

USAR_TEST(tst_MissionFile)

} // namespace tst_mission_file

#include "tst_mission_file.moc"
