// What a person does to the world: heights, commands, names, and what can be brought back.
#include <QTest>

#include "core/mission/world/object_edits.h"
#include "core/mission/world/world_edits.h"
#include "core/mission/world/world_inventory.h"
#include "tests/suite/suite.h"

namespace tst_world_edits {

using namespace usar;
using namespace usar::mission;
using protocol::Command;
using protocol::CreateObject;
using protocol::KillObject;

namespace {

/// Knows crates, of a meter.
std::optional<Vec3> sizeOfClass(std::string_view name) {
    return name == "Crate" ? std::optional<Vec3>(Vec3::Ones()) : std::nullopt;
}

WorldThing thing(const std::string& name, const std::string& class_name, std::optional<Vec3> size_m = {}) {
    WorldThing made{.name = name, .class_name = class_name, .size_m = size_m, .body_in_map = {}};
    made.body_in_map.position_m = {1.0, 2.0, 3.0};
    return made;
}

CreateObject creation(const char* name, double x_m = 0.0) {
    CreateObject made{tokenOf("Crate")};
    made.object_name = protocol::Name::mended(name);
    made.start = Pose{Vec3(x_m, 0.0, 0.0)};
    return made;
}

/// A slope of one meter in ten along x.
double slope(const Vec2& at_m) {
    return at_m.x() / 10.0;
}

/// Edits whose commands are kept, and a world that they look at.
struct Bin {
    EditHistory history;
    std::vector<Command> sent;
    std::map<std::string, CreateObject> world;
    ObjectEdits edits{history, [this](const Command& command) { sent.push_back(command); },
                      [this](const std::string& name) -> std::optional<CreateObject> {
                          const auto found = world.find(name);
                          return found == world.end() ? std::nullopt : std::optional(found->second);
                      }};
};

} // namespace

class tst_WorldEdits : public QObject {
    Q_OBJECT
private slots:
    void theGroundComesFromTheBestSourceThatKnowsIt_data() {
        QTest::addColumn<bool>("has_terrain");
        QTest::addColumn<bool>("has_scans");
        QTest::addColumn<bool>("has_poses");
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("height_m");
        QTest::newRow("the terrain") << true << true << true << 0.1 << 7.0;
        QTest::newRow("scans beyond the terrain") << true << true << true << 5.1 << 2.5;
        QTest::newRow("scans") << false << true << true << 0.1 << 1.5;
        QTest::newRow("the nearest start pose") << false << false << true << 8.0 << -4.0;
        QTest::newRow("the nearest start pose where nothing was scanned") << false << true << true << 60.0 << -4.0;
        QTest::newRow("nothing") << false << false << false << 0.1 << 0.0;
    }

    void theGroundComesFromTheBestSourceThatKnowsIt() {
        QFETCH(bool, has_terrain);
        QFETCH(bool, has_scans);
        QFETCH(bool, has_poses);
        QFETCH(double, x_m);
        QFETCH(double, height_m);
        mapping::HeightMap map(0.5);
        map.write({0, 0}, 1.5f, {});
        map.write({10, 0}, 2.5f, {});
        mapping::HeightTiles tiles;
        for (const auto& tile : map.takeChangedTiles())
            tiles[tile->index] = tile;
        const std::vector<protocol::StartPose> poses{{"A", Pose{Vec3(0.0, 0.0, 3.0)}},
                                                     {"B", Pose{Vec3(9.0, 0.0, -4.0)}}};
        GroundSources sources;
        if (has_terrain)
            sources.terrain_m = [](const Vec2& at_m) { return at_m.x() < 5.0 ? std::optional(7.0) : std::nullopt; };
        if (has_scans)
            sources.tiles = &tiles;
        sources.cell_size_m = 0.5;
        if (has_poses)
            sources.start_poses = poses;
        QCOMPARE(groundHeight_m(sources, Vec2(x_m, 0.1)), height_m);
    }

    void anObjectIsPlacedOnTheGround_data() {
        QTest::addColumn<bool>("conveyor");
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("center_m");
        QTest::newRow("a thing falls a little") << false << 1.0 << 5.52;
        QTest::newRow("a larger one stands higher") << false << 2.0 << 6.02;
        QTest::newRow("a conveyor stands") << true << 1.0 << 5.5;
    }

    void anObjectIsPlacedOnTheGround() {
        QFETCH(bool, conveyor);
        QFETCH(double, scale);
        QFETCH(double, center_m);
        const Vec3 factors = Vec3::Constant(scale);
        const auto made = placed({"Crate", "Crate1", factors, factors, conveyor}, Vec2(1.0, 2.0), 5.0);
        QVERIFY(made);
        QCOMPARE(made->class_name.text(), std::string("Crate"));
        QCOMPARE(made->object_name.text(), std::string("Crate1"));
        const Vec3 at_m = std::get<Pose>(made->start).position_m;
        QVERIFY((at_m - Vec3(1.0, 2.0, center_m)).norm() < 1e-9);
        QCOMPARE(made->scale.has_value(), scale != 1.0);
    }

    void aClassThatNoLineCarriesIsRefused() {
        const auto refused = placed({.class_name = "two words", .name = "X1"}, Vec2::Zero(), 0.0);
        QVERIFY(!refused && !refused.error().text().empty());
        QCOMPARE(tokenOf("two words").text(), std::string("unnamed"));
    }

    void whatIsMovedKeepsItsHeightOverTheGround() {
        Pose body{Vec3(10.0, 0.0, 1.5)}; // half a meter over the slope
        body.yaw_rad = 0.3;
        const Pose moved = movedTo(body, Vec2(30.0, 4.0), slope);
        QVERIFY((moved.position_m - Vec3(30.0, 4.0, 3.5)).norm() < 1e-9);
        QCOMPARE(moved.yaw_rad, 0.3);
        QVERIFY((waypointAt(body, Vec2(20.0, 1.0), slope) - Vec3(20.0, 1.0, 2.5)).norm() < 1e-9);
    }

    void aConveyorWithoutAWayRunsItsBelt_data() {
        using protocol::FollowWaypoints;
        using protocol::RunConveyor;
        QTest::addColumn<bool>("conveyor");
        QTest::addColumn<bool>("way");
        QTest::addColumn<bool>("moving");
        QTest::addColumn<Command>("expected");
        const auto along = [](bool moving) {
            return Command(FollowWaypoints{"It", protocol::WaypointSpeed{0.5}, true, {}, moving});
        };
        QTest::newRow("a belt backward") << true << false << true << Command(RunConveyor{"It", -0.5});
        QTest::newRow("a belt stops") << true << false << false << Command(RunConveyor{"It", 0.0});
        QTest::newRow("a conveyor with a way goes along it") << true << true << true << along(true);
        QTest::newRow("a thing goes along its way") << false << true << true << along(true);
        QTest::newRow("a thing stops") << false << false << false << along(false);
    }

    void aConveyorWithoutAWayRunsItsBelt() {
        QFETCH(bool, conveyor);
        QFETCH(bool, way);
        QFETCH(bool, moving);
        QFETCH(Command, expected);
        QVERIFY(motionOf("It", conveyor, way, {-0.5, true, moving}) == expected);
    }

    void namesAreFreeUntilTheyAreUsed() {
        WorldInventory inventory(sizeOfClass);
        inventory.setThings({thing("Crate2", "Crate")});
        QCOMPARE(inventory.unusedName("Mine.Crate"), std::string("Crate1"));
        inventory.useName("Crate1");
        QCOMPARE(inventory.unusedName("Crate"), std::string("Crate3"));
        inventory.setThings({}); // the server has not reported Crate1 yet
        QCOMPARE(inventory.unusedName("Crate"), std::string("Crate2"));
    }

    void waysAreForgottenWithTheirObject() {
        WorldInventory inventory(sizeOfClass);
        inventory.setThings({thing("A", "Crate"), thing("B", "Crate")});
        inventory.setWay("A", {Vec2(1.0, 2.0)});
        inventory.setWay("B", {Vec2(3.0, 4.0)});
        inventory.setThings({thing("B", "Crate")});
        QVERIFY(inventory.way_m("A").empty());
        QCOMPARE(inventory.way_m("B"), std::vector<Vec2>{Vec2(3.0, 4.0)});
        inventory.setWay("B", {});
        QVERIFY(inventory.way_m("B").empty());
    }

    void aSpinIsTurnedOnAndOff() {
        WorldInventory inventory(sizeOfClass);
        QVERIFY(inventory.toggleSpin("A"));
        QVERIFY(inventory.toggleSpin("B"));
        QVERIFY(!inventory.toggleSpin("A"));
    }

    void theServerIsAskedForEveryClassOnce() {
        WorldInventory inventory(sizeOfClass);
        inventory.setOwn({{"Box1", "USARPhysObj.Box"}, {"Mars", "Mine.Statue"}, {"Venus", "Mine.Statue"}});
        QCOMPARE(inventory.classesToAskFor({"Box", "Ball"}), (std::vector<std::string>{"Box", "Ball", "Statue"}));
    }

    void anObjectIsMadeAgainAsItIs_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("class_name"); ///< empty: it cannot be made
        QTest::addColumn<double>("scale");       ///< 0: none is told
        QTest::newRow("in its usual size") << "Crate1"
                                           << "Crate" << 0.0;
        QTest::newRow("twice as large") << "Crate2"
                                        << "Crate" << 2.0;
        QTest::newRow("of no known size") << "Crate3"
                                          << "Crate" << 0.0;
        QTest::newRow("of a class that is not ours") << "Statue1"
                                                     << "Statue" << 0.0;
        QTest::newRow("of no class") << "Thing"
                                     << "" << 0.0;
        QTest::newRow("the world's own") << "Venus"
                                         << "Mine.Statue" << 0.0;
        QTest::newRow("the world's own without a class") << "Apollo"
                                                         << "unnamed" << 0.0;
        QTest::newRow("another one with the name of the world's own") << "Mars"
                                                                      << "Crate" << 2.0;
        QTest::newRow("gone") << "Nobody"
                              << "" << 0.0;
    }

    void anObjectIsMadeAgainAsItIs() {
        QFETCH(QString, name);
        QFETCH(QString, class_name);
        QFETCH(double, scale);
        WorldInventory inventory(sizeOfClass);
        const Vec3 large_m = Vec3::Constant(2.0);
        inventory.setThings({thing("Crate1", "Crate", Vec3(1.0, 1.01, 1.0)), thing("Crate2", "Crate", large_m),
                             thing("Crate3", "Crate"), thing("Statue1", "Statue", large_m), thing("Thing", ""),
                             thing("Venus", "Statue", large_m), thing("Apollo", ""), thing("Mars", "Crate", large_m)});
        inventory.setOwn({{"Venus", "Mine.Statue"}, {"Apollo", ""}, {"Mars", "Mine.Statue"}});
        const auto made = inventory.creationOf(name.toStdString());
        QCOMPARE(made.has_value(), !class_name.isEmpty());
        if (!made)
            return;
        QCOMPARE(QString::fromStdString(made->class_name.text()), class_name);
        QCOMPARE(QString::fromStdString(made->object_name.text()), name);
        QCOMPARE(std::get<Pose>(made->start).position_m, Vec3(1.0, 2.0, 3.0));
        QCOMPARE(made->scale.value_or(Vec3::Zero()).x(), scale);
    }

    void anotherServerKnowsNothingOfThis() {
        WorldInventory inventory(sizeOfClass);
        inventory.setThings({thing("Apollo", "")});
        inventory.setOwn({{"Apollo", "Statue"}});
        inventory.useName("Crate1");
        inventory.setWay("Apollo", {Vec2(1.0, 2.0)});
        inventory.clear();
        QVERIFY(!inventory.creationOf("Apollo"));
        QVERIFY(inventory.way_m("Apollo").empty());
        QCOMPARE(inventory.unusedName("Crate"), std::string("Crate1"));
    }

    void whatWasDeletedIsBroughtBack() {
        Bin bin;
        QVERIFY(!bin.history.canUndo());
        bin.edits.remove(KillObject{"A"}, {creation("A")});
        bin.edits.remove(protocol::KillAllObjects{}, {creation("B"), creation("C")});
        QVERIFY(bin.history.canUndo() && !bin.history.canRedo());
        bin.history.undo();
        bin.history.undo();
        QVERIFY(!bin.history.canUndo() && bin.history.canRedo());
        const std::vector<Command> expected{KillObject{"A"}, protocol::KillAllObjects{}, creation("B"), creation("C"),
                                            creation("A")};
        QVERIFY(bin.sent == expected);
        bin.edits.forget();
        QVERIFY(!bin.history.canUndo() && !bin.history.canRedo());
    }

    void whatWasBroughtBackIsDeletedAgainByName() {
        Bin bin;
        bin.edits.remove(protocol::KillAllObjects{}, {creation("A"), creation("B")});
        bin.history.undo();
        bin.sent.clear();
        bin.history.redo();
        QVERIFY(bin.sent == (std::vector<Command>{KillObject{"A"}, KillObject{"B"}})); // not what came since
        bin.history.undo();
        bin.edits.remove(KillObject{"C"}, {creation("C")});
        QVERIFY(!bin.history.canRedo());
    }

    void whatWasMovedMeanwhileComesBackWhereItWas() {
        Bin bin;
        bin.edits.remove(KillObject{"A"}, {creation("A", 1.0)});
        bin.history.undo();
        bin.world.emplace("A", creation("A", 5.0));
        bin.history.redo();
        bin.history.undo();
        QVERIFY(bin.sent.back() == Command(creation("A", 5.0)));
        bin.world.clear(); // the server has not reported it yet
        bin.history.redo();
        bin.history.undo();
        QVERIFY(bin.sent.back() == Command(creation("A", 5.0)));
    }

    void withoutAnObjectThereIsNothingToBringBack() {
        Bin bin;
        bin.edits.remove(KillObject{"A"}, {});
        QVERIFY(bin.sent == std::vector<Command>{KillObject{"A"}});
        QVERIFY(!bin.history.canUndo());
    }

    void theOldestDeletionsAreForgotten() {
        Bin bin;
        for (int i = 0; i < 220; ++i)
            bin.edits.remove(KillObject{"A"}, {creation("A", i)});
        int undone = 0;
        for (; bin.history.canUndo(); ++undone)
            bin.history.undo();
        QCOMPARE(undone, 200);
        QVERIFY(bin.sent.back() == Command(creation("A", 20.0)));
    }

    void eachEditOfAnObjectIsTakenBack_data() {
        using Do = std::function<void(Bin&)>;
        QTest::addColumn<Do>("edit");
        QTest::addColumn<QString>("text");
        QTest::addColumn<std::vector<Command>>("sent");
        const Pose here{Vec3(1.0, 2.0, 3.0)};
        const Pose there{Vec3(4.0, 5.0, 3.0)};
        Pose left;
        left.yaw_rad = 0.5;
        Pose right;
        right.yaw_rad = -0.5;
        QTest::newRow("placing") << Do([](Bin& bin) { bin.edits.place(creation("A")); }) << "place A"
                                 << std::vector<Command>{creation("A"), KillObject{"A"}, creation("A")};
        QTest::newRow("moving") << Do([=](Bin& bin) { bin.edits.move("A", here, there); }) << "move A"
                                << std::vector<Command>{protocol::PlaceObject{"A", there},
                                                        protocol::PlaceObject{"A", here},
                                                        protocol::PlaceObject{"A", there}};
        QTest::newRow("turning") << Do([](Bin& bin) { bin.edits.turn("A", 0.5); }) << "turn A"
                                 << std::vector<Command>{protocol::ShiftObject{"A", left},
                                                         protocol::ShiftObject{"A", right},
                                                         protocol::ShiftObject{"A", left}};
        QTest::newRow("deleting") << Do([](Bin& bin) { bin.edits.remove(KillObject{"A"}, {creation("A")}); })
                                  << "delete A"
                                  << std::vector<Command>{KillObject{"A"}, creation("A"), KillObject{"A"}};
    }

    void eachEditOfAnObjectIsTakenBack() {
        QFETCH(std::function<void(Bin&)>, edit);
        QFETCH(QString, text);
        QFETCH(std::vector<Command>, sent);
        Bin bin;
        edit(bin);
        QCOMPARE(bin.history.undoText(), text);
        bin.history.undo();
        QVERIFY(!bin.history.canUndo());
        bin.history.redo();
        QVERIFY(bin.sent == sent);
    }

    void waypointsAreTakenBackOneByOne() {
        Bin bin;
        std::vector<std::vector<Vec2>> ways;
        const auto set = [&](const std::vector<Vec2>& way_m) { ways.push_back(way_m); };
        const Vec2 a(1.0, 0.0);
        const Vec2 b(2.0, 0.0);
        bin.edits.setWay("A", {}, {a}, set);
        bin.edits.setWay("A", {a}, {a, b}, set);
        QCOMPARE(bin.history.undoText(), QString("add waypoint of A"));
        bin.history.undo();
        bin.history.undo();
        QVERIFY(ways == (std::vector<std::vector<Vec2>>{{a}, {a, b}, {a}, {}}));
        bin.edits.setWay("A", {a}, {}, set);
        QCOMPARE(bin.history.undoText(), QString("clear waypoints of A"));
    }
};

USAR_TEST(tst_WorldEdits)

} // namespace tst_world_edits

#include "tst_world_edits.moc"
