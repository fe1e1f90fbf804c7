#include <QTest>

#include "core/mission/fleet/start_check.h"
#include "tests/suite/suite.h"

namespace tst_start_check {

using namespace usar;
using namespace usar::mission;

namespace {

const Rectangle small{{0.0, 0.0}, {4.0, 2.0}};
const Rectangle wide{{0.0, 0.0}, {40.0, 2.0}};
const Rectangle outside{{10.0, 0.0}, {40.0, 2.0}};

StartedBehavior startOf(const std::string& behavior_id, const Rectangle& area, long long ticks) {
    StartedBehavior start;
    start.id = behavior_id;
    start.area_in_map = area;
    start.parameters["ticks"] = ticks;
    return start;
}

const StartPlace somewhere{"tall_test", {{-10.0, -10.0}, {10.0, 10.0}}};

} // namespace

/// What a person starts in the window is checked before anything moves.
class tst_StartCheck : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        plugins_.scan({QString(USAR_BINARY_DIR) + "/tests/mission_plugins"});
        QVERIFY(plugins_.behavior("test/hop"));
    }

    void takesWhatIsRight() {
        const auto parameters = checkStart(startOf("test/hop", small, 3), plugins_, somewhere);
        QVERIFY2(parameters.has_value(), parameters ? "" : parameters.error().text().c_str());
        QCOMPARE(parameters->integer("ticks"), 3LL);
        QVERIFY(parameters->flag("succeeds"));
    }

    void refusesBeforeAnythingMoves_data() {
        QTest::addColumn<QString>("behavior");
        QTest::addColumn<Rectangle>("area");
        QTest::addColumn<int>("ticks");
        QTest::addColumn<QString>("said");
        QTest::newRow("an unknown behavior") << "test/hip" << small << 3 << "no loaded plugin has this behavior";
        QTest::newRow("no area") << "test/hop" << Rectangle{} << 3
                                 << "Hop: it needs a mission area. Draw one on the map with the area tool.";
        QTest::newRow("an area outside") << "test/hop" << outside << 3 << "is entirely outside the world";
        QTest::newRow("a parameter out of range") << "test/hop" << small << 0 << "parameter ticks: 0 is out of range";
    }

    void refusesBeforeAnythingMoves() {
        QFETCH(QString, behavior);
        QFETCH(Rectangle, area);
        QFETCH(int, ticks);
        QFETCH(QString, said);
        const auto parameters = checkStart(startOf(behavior.toStdString(), area, ticks), plugins_, somewhere);
        QVERIFY(!parameters.has_value());
        const QString text = QString::fromStdString(parameters.error().text());
        QVERIFY2(text.contains(said), qPrintable(text));
    }

    void takesAnAreaThatIsPartlyOutside() {
        QVERIFY(checkStart(startOf("test/hop", wide, 3), plugins_, somewhere));
        Mission mission = hop();
        mission.area_in_map = wide;
        QVERIFY(checkMission(mission, plugins_, somewhere));
    }

    void aWorldOfUnknownSizeHasRoomForAll() { QVERIFY(checkStart(startOf("test/hop", wide, 3), plugins_, {})); }

    void checksParametersAlone() {
        QVERIFY(checkParameters("test/hop", {{"ticks", 3LL}}, plugins_));
        QVERIFY(!checkParameters("test/hop", {{"tacks", 3LL}}, plugins_));
        QVERIFY(!checkParameters("test/hip", {}, plugins_));
    }

    void aMissionGetsItsAnglesInRadians() {
        Mission mission = hop();
        mission.parameters["lean_rad"] = 45.0;
        const auto parameters = checkMission(mission, plugins_, somewhere);
        QVERIFY2(parameters.has_value(), parameters ? "" : parameters.error().text().c_str());
        QCOMPARE(std::get<double>(parameters->at("lean_rad")), pi / 4);
    }

    void refusesAMissionThatCannotBeFlownHere_data() {
        QTest::addColumn<QString>("world");
        QTest::addColumn<QString>("behavior");
        QTest::addColumn<Rectangle>("area");
        QTest::addColumn<QString>("said");
        QTest::newRow("of another world")
            << "vmac_room"
            << "test/hop" << small
            << "This mission belongs to the world vmac_room. Here is tall_test; connect to a "
               "server with vmac_room.";
        QTest::newRow("an unknown behavior") << "tall_test"
                                             << "test/hip" << small << "no loaded plugin has this behavior";
        QTest::newRow("no area") << "tall_test"
                                 << "test/hop" << Rectangle{} << "it needs a mission area";
        QTest::newRow("an area outside") << "tall_test"
                                         << "test/hop" << outside << "is entirely outside the world";
    }

    void refusesAMissionThatCannotBeFlownHere() {
        QFETCH(QString, world);
        QFETCH(QString, behavior);
        QFETCH(Rectangle, area);
        QFETCH(QString, said);
        Mission mission = hop();
        mission.world = world.toStdString();
        mission.behavior = behavior.toStdString();
        mission.area_in_map = area;
        const auto parameters = checkMission(mission, plugins_, somewhere);
        QVERIFY(!parameters.has_value());
        const QString text = QString::fromStdString(parameters.error().text());
        QVERIFY2(text.contains(said), qPrintable(text));
    }

    void anUnknownWorldTakesEveryMission() {
        Mission mission = hop();
        mission.world = "vmac_room";
        mission.area_in_map = wide;
        QVERIFY(checkMission(mission, plugins_, {}));
    }

private:
    static Mission hop() {
        Mission mission;
        mission.name = "Hop";
        mission.behavior = "test/hop";
        mission.area_in_map = small;
        return mission;
    }

    agent::PluginLoader plugins_;
};

USAR_TEST(tst_StartCheck)

} // namespace tst_start_check

#include "tst_start_check.moc"
