#include <QTemporaryDir>
#include <QTest>

#include "core/mission/files/mission_check.h"
#include "tests/suite/suite.h"

namespace tst_mission_check {

using namespace usar;
using namespace usar::mission;

namespace {

const Rectangle world{{-10.0, -10.0}, {10.0, 10.0}};

QString fileIn(const QTemporaryDir& folder, const QString& name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        qWarning("cannot write %s", qPrintable(name));
    return file.fileName();
}

} // namespace

/// What is found wrong in a mission file only when plugins and world are known is shown where it stands all the same.
class tst_MissionCheck : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        plugins_.scan({QString(USAR_BINARY_DIR) + "/tests/mission_plugins"});
        QVERIFY(plugins_.behavior("test/hop"));
    }

    void takesWhatIsRight();

    void rejectsWrongBehaviorsAndParametersWithTheirPlace_data();

    void rejectsWrongBehaviorsAndParametersWithTheirPlace();

    void ownParametersStandInPlaceOfThePresets_data() {
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<long long>("ticks");
        QTest::addColumn<double>("lean_rad");
        QTest::newRow("no preset") << QByteArray(R"("parameters": {})") << 5LL << 0.0;
        QTest::newRow("a preset") << QByteArray(R"("preset": "long")") << 500LL << 0.5;
        QTest::newRow("one that leaves some to the defaults") << QByteArray(R"("preset": "low")") << 2LL << 0.0;
        QTest::newRow("a preset, and a value of its own")
            << QByteArray(R"("preset": "long", "parameters": {"lean_rad": 45})") << 500LL << pi / 4;
    }

    void ownParametersStandInPlaceOfThePresets() {
        QFETCH(QByteArray, written);
        const auto prepared = prepareBehavior(
            read(R"("behavior": "test/hop", "area": {"x": 0, "y": 0, "width": 4, "height": 2}, )" + written), plugins_);
        QVERIFY2(prepared, prepared ? "" : prepared.error().text().c_str());
        QTEST(prepared->parameters.integer("ticks"), "ticks");
        QTEST(prepared->parameters.real("lean_rad"), "lean_rad");
    }

    void anUnknownPresetIsNamedWithItsPlace() {
        const auto prepared = prepareBehavior(read("\"behavior\": \"test/hop\",\n \"preset\": \"lung\""), plugins_);
        QVERIFY(!prepared);
        QCOMPARE(prepared.error().text(),
                 std::string("m.json:4:12: preset: test/hop has no preset \"lung\". Did you mean \"long\"? Known here: "
                             "long, low."));
    }

    void rejectsAnAreaEntirelyOutsideTheWorldWithItsPlace();

    void aPartOutsideTheWorldIsNamedAndNotFlown_data() {
        QTest::addColumn<Rectangle>("area");
        QTest::addColumn<QString>("notice");
        QTest::addColumn<Rectangle>("flown");
        QTest::newRow("inside") << Rectangle{{-10, -10}, {10, 10}} << QString() << Rectangle{{-10, -10}, {10, 10}};
        QTest::newRow("half of it") << Rectangle{{5, 5}, {15, 8}}
                                    << "50 % of the mission area (x 5.0..15.0 m, y 5.0..8.0 m) is outside the world, "
                                       "which spans x -10.0..10.0 m, y -10.0..10.0 m; only the part inside is flown."
                                    << Rectangle{{5, 5}, {10, 8}};
        QTest::newRow("beyond a corner") << Rectangle{{5, 5}, {15, 15}} << "75 % of the mission area"
                                         << Rectangle{{5, 5}, {10, 10}};
        QTest::newRow("a narrow strip") << Rectangle{{-10, -10}, {10.2, 10}} << "1.0 % of the mission area"
                                        << Rectangle{{-10, -10}, {10, 10}};
        QTest::newRow("next to nothing") << Rectangle{{-10, -10}, {10.001, 10}} << "Less than 0.1 % of the mission area"
                                         << Rectangle{{-10, -10}, {10, 10}};
    }

    void aPartOutsideTheWorldIsNamedAndNotFlown() {
        QFETCH(Rectangle, area);
        QFETCH(QString, notice);
        QFETCH(Rectangle, flown);
        const QString text = QString::fromStdString(beyondWorldNotice(area, world));
        QVERIFY2(text.startsWith(notice) && text.isEmpty() == notice.isEmpty(), qPrintable(text));
        QCOMPARE(areaWithin(area, world), flown);
        QVERIFY(checkAreaInWorld(area, world));
    }

    void aWorldOfUnknownSizeHasRoomForAll();

    void rejectsAnUnknownStartPoseWithItsPlace();

    void aMissionThatIsNoFileNamesTheThingItself() {
        Mission mission;
        mission.behavior = "test/hop";
        mission.parameters["ticks"] = 0LL;
        QCOMPARE(prepareBehavior(mission, plugins_).error().where, std::string("parameter ticks"));
        mission.behavior = "test/hip";
        QCOMPARE(prepareBehavior(mission, plugins_).error().where, std::string("behavior test/hip"));
    }

    void takesAPersonsOwnPlan();

    void refusesAPlanBeforeAnythingMoves_data() {
        QTest::addColumn<QByteArray>("behavior");
        QTest::addColumn<QByteArray>("text"); // of the plan; empty: no such file
        QTest::addColumn<QString>("says");
        const QByteArray planned = "test/planned";
        QTest::newRow("no such file") << planned << QByteArray() << "cannot read the plan";
        QTest::newRow("not a plan") << planned << QByteArray("((DC d (drives ((a Halt))))") << "1:28: error E203";
        QTest::newRow("not of this robot")
            << planned << QByteArray("((DC d (drives ((a Hlat)))))") << "1:20: error E304";
        QTest::newRow("nothing that a plan decides")
            << QByteArray("test/hop") << QByteArray("((DC d (drives ((a Halt)))))")
            << "this behavior is not run by a plan. Choose test/planned";
    }

    void refusesAPlanBeforeAnythingMoves();

    void aBehaviorThatNeedsAnAreaSaysSo();

private:
    /// The members stand on lines 3 and on.
    static Mission read(const QByteArray& members) {
        const QByteArray json = "{\n  \"name\": \"m\",\n" + members + "\n}";
        const auto mission = readMission(json, "m.json");
        if (!mission)
            qWarning("%s", mission.error().text().c_str());
        return mission.value_or(Mission{});
    }

    agent::PluginLoader plugins_;
};

void tst_MissionCheck::takesWhatIsRight() {
    const Mission mission = read(R"("behavior": "test/hop", "area": {"x": 0, "y": 0, "width": 4, "height": 2},
    "parameters": {"ticks": 3, "lean_rad": 45}, "start": "robot1")");
    const auto prepared = prepareBehavior(mission, plugins_);
    QVERIFY2(prepared.has_value(), prepared ? "" : prepared.error().text().c_str());
    QCOMPARE(prepared->parameters.real("lean_rad"), pi / 4);
    QVERIFY(checkAreaInWorld(mission, world));
    QVERIFY(startPoseOf(mission, {{{"Robot1", {}}}}));
}

void tst_MissionCheck::rejectsWrongBehaviorsAndParametersWithTheirPlace_data() {
    QTest::addColumn<QByteArray>("behavior");
    QTest::addColumn<QByteArray>("parameters");
    QTest::addColumn<QString>("said");
    const QByteArray hop = "test/hop";
    QTest::newRow("an unknown behavior") << QByteArray("test/hip") << QByteArray()
                                         << "m.json:3:13: behavior test/hip: no loaded plugin has this behavior.";
    QTest::newRow("an unknown parameter") << hop << QByteArray(R"("ticks": 3, "leen_rad": 3)")
                                          << "m.json:4:29: parameter leen_rad: there is no such parameter. "
                                             "Did you mean lean_rad?";
    QTest::newRow("a value out of range")
        << hop << QByteArray(R"("ticks": 0)") << "m.json:4:26: parameter ticks: 0 is out of range. Give 1 to ";
    QTest::newRow("a value of the wrong type")
        << hop << QByteArray(R"("ticks": "many")") << "m.json:4:26: parameter ticks: \"many\" is a text. Give a whole";
    QTest::newRow("an angle, told as it is written") << hop << QByteArray(R"("lean_rad": 46)")
                                                     << "m.json:4:29: parameter lean_rad: 46 is out of range. "
                                                        "Give 0 to 45 deg.";
}

void tst_MissionCheck::rejectsWrongBehaviorsAndParametersWithTheirPlace() {
    QFETCH(QByteArray, behavior);
    QFETCH(QByteArray, parameters);
    QFETCH(QString, said);
    const Mission mission = read("\"behavior\": \"" + behavior + "\",\n \"parameters\": {" + parameters +
                                 R"(}, "area": {"x": 0, "y": 0, "width": 4, "height": 2})");
    const auto prepared = prepareBehavior(mission, plugins_);
    QVERIFY(!prepared.has_value());
    const QString text = QString::fromStdString(prepared.error().text());
    QVERIFY2(text.startsWith(said), qPrintable(text));
}

void tst_MissionCheck::rejectsAnAreaEntirelyOutsideTheWorldWithItsPlace() {
    const auto inside = checkAreaInWorld(read(R"("area": {"x": 10, "y": 0, "width": 40, "height": 2})"), world);
    QVERIFY(!inside.has_value());
    QCOMPARE(inside.error().where, std::string("m.json:3:9"));
    QVERIFY2(inside.error().text().find("is entirely outside the world") != std::string::npos,
             inside.error().text().c_str());
}

void tst_MissionCheck::aWorldOfUnknownSizeHasRoomForAll() {
    const Mission mission = read(R"("area": {"x": 0, "y": 0, "width": 40, "height": 2})");
    QVERIFY(checkAreaInWorld(mission, {}));
    QVERIFY(beyondWorldNotice(mission.area_in_map, {}).empty());
    QCOMPARE(areaWithin(mission.area_in_map, {}), mission.area_in_map);
}

void tst_MissionCheck::rejectsAnUnknownStartPoseWithItsPlace() {
    const auto pose = startPoseOf(read(R"("start": "Roof", "area": {"x": 0, "y": 0, "width": 4, "height": 2})"),
                                  {{{"PlayerStart", {}}, {"robot1", {}}}});
    QVERIFY(!pose.has_value());
    QCOMPARE(QString::fromStdString(pose.error().text()),
             QString("m.json:3:10: Roof: the server knows no start pose with this name. It has PlayerStart, robot1."));
}

void tst_MissionCheck::takesAPersonsOwnPlan() {
    QTemporaryDir folder;
    const QByteArray text = "((DC own (drives ((first Tick)))))";
    const QString path = fileIn(folder, "own.lap", text);
    const Mission mission = read(R"("behavior": "test/planned", "plan": ")" + path.toUtf8() + '"');
    const auto prepared = prepareBehavior(mission, plugins_);
    QVERIFY2(prepared.has_value(), prepared ? "" : prepared.error().text().c_str());
    QVERIFY(prepared->plan == (agent::PlanText{path.toStdString(), text.toStdString()}));
    QVERIFY(!prepareBehavior(read(R"("behavior": "test/planned")"), plugins_)->plan);
}

void tst_MissionCheck::refusesAPlanBeforeAnythingMoves() {
    QFETCH(QByteArray, behavior);
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    QTemporaryDir folder;
    const QString path = text.isEmpty() ? folder.filePath("none.lap") : fileIn(folder, "own.lap", text);
    const auto prepared = prepareBehavior(read("\"behavior\": \"" + behavior + "\", \"plan\": \"" + path.toUtf8() +
                                               R"(", "area": {"x": 0, "y": 0, "width": 4, "height": 2})"),
                                          plugins_);
    QVERIFY(!prepared.has_value());
    const QString said = QString::fromStdString(prepared.error().text());
    QVERIFY2(said.startsWith("m.json:3:") && said.contains(says), qPrintable(said));
}

void tst_MissionCheck::aBehaviorThatNeedsAnAreaSaysSo() {
    const auto prepared = prepareBehavior(read(R"("behavior": "test/hop")"), plugins_);
    QVERIFY(!prepared.has_value());
    QCOMPARE(QString::fromStdString(prepared.error().text()),
             QString("m.json:3:13: test/hop: it needs a mission area. Add \"area\" with x, y, width and height in "
                     "meters to the mission."));
}

USAR_TEST(tst_MissionCheck)

} // namespace tst_mission_check

#include "tst_mission_check.moc"
