// The palette of the world in the real window: objects by mouse, and the marks of a robot under TRACE.
#include <algorithm>

#include <QComboBox>
#include <QMimeData>
#include <QTabBar>
#include <QTcpSocket>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "core/sim/world/world_writer.h"
#include "tests/doubles/fake_robot_server.h"
#include "tests/doubles/test_worlds.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_world {

using namespace usar;

namespace {

/// The dock and its map.
struct WorldPage : WindowPage {
    widgets::WorldPanel& panel() { return *window().views().world; }

    void open() {
        for (QTabBar* tabs : window().findChildren<QTabBar*>())
            for (int i = 0; i < tabs->count(); ++i)
                if (tabs->tabText(i) == "World")
                    QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(i).center());
    }
    bool isOpen() { return panel().isVisible() && panel().findChild<QTreeView*>()->isVisible(); }
    /// As far as a hand can aim: 20 pixels a meter around the origin.
    void lookAt(const Vec2& center_m) {
        widgets::MapTransform near = map().transform();
        near.center_m = center_m;
        near.pixels_per_m = 20.0;
        map().setTransform(near);
    }
    QPoint at(const Vec2& point_m) { return map().transform().toScreen(point_m).toPoint(); }
    QToolButton* button(const QString& name) {
        for (QToolButton* one : panel().findChildren<QToolButton*>())
            if (one->accessibleName() == name)
                return one;
        return nullptr;
    }
    void clickMap(const Vec2& point_m) { QTest::mouseClick(&map(), Qt::LeftButton, {}, at(point_m)); }
    void put(const QString& kind, const Vec2& point_m) {
        QTest::mouseClick(button(kind), Qt::LeftButton);
        clickMap(point_m);
    }
    int count() { return panel().model().rowCount(); }
    /// Of the first of that kind; the number of rows where there is none.
    int rowOf(const QString& kind) {
        int row = 0;
        while (row < count() && panel().model().row(row).kind != kind)
            ++row;
        return row;
    }
    Vec2 placeOf(int row) { return panel().model().row(row).body_in_map.position_m.head<2>(); }
    bool isNear(int row, const Vec2& point_m, double reach_m = 0.1) {
        return row < count() && (placeOf(row) - point_m).norm() < reach_m;
    }
};

/// Level ground and things of classes that no palette has.
sim::World yardWithStatues() {
    sim::World yard = doubles::flatWorld();
    yard.name = "yard";
    sim::WorldObject venus{.name = "Venus", .class_name = "Mine.Statue", .body = {}, .body_in_map = {}};
    venus.body.mass_kg = 40.0;
    venus.body.parts = {{sim::CylinderShape{0.3, 1.4}, {}}};
    venus.body_in_map.position_m = {3.0, 1.0, 0.7};
    sim::WorldObject nameless = venus; // no class at all
    nameless.name = "Apollo";
    nameless.class_name.clear();
    nameless.body_in_map.position_m = {-3.0, 1.0, 0.7};
    yard.objects = {venus, nameless};
    return yard;
}

/// Pixels of about this color in the middle of the map.
int countColor(widgets::MapView& map, const QColor& color) {
    const QImage image = map.grab().toImage();
    int found = 0;
    for (int y = 60; y < image.height() - 60; ++y)
        for (int x = 60; x < image.width() - 60; ++x) {
            const QColor pixel = image.pixelColor(x, y);
            found += std::abs(pixel.red() - color.red()) < 12 && std::abs(pixel.green() - color.green()) < 12 &&
                     std::abs(pixel.blue() - color.blue()) < 12;
        }
    return found;
}

} // namespace

class tst_WindowWorld : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }

    void anObjectIsDroppedMovedTurnedDeletedAndBroughtBack() {
        WorldPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        page.open();
        QTRY_VERIFY_WITH_TIMEOUT(page.isOpen(), soon_ms);
        page.lookAt({5, 5});
        page.put("Crate", {4, 6});
        QTRY_VERIFY_WITH_TIMEOUT(page.isNear(0, {4, 6}), soon_ms);
        QCOMPARE(page.panel().model().row(0).kind, QString("Crate"));
        QCOMPARE(page.map().tool(), widgets::MapTool::Pan);
        QTRY_COMPARE(page.map().content().objects.selected, QString("Crate1"));

        QTest::mousePress(&page.map(), Qt::LeftButton, {}, page.at({4, 6}));
        QTest::mouseMove(&page.map(), page.at({5, 7}));
        QTest::mouseMove(&page.map(), page.at({7, 8}));
        QTest::mouseRelease(&page.map(), Qt::LeftButton, {}, page.at({7, 8}));
        QTRY_VERIFY_WITH_TIMEOUT(page.isNear(0, {7, 8}), soon_ms);

        const double yaw_rad = page.panel().model().row(0).body_in_map.yaw_rad;
        QTest::mouseClick(page.button("Turn left"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(page.panel().model().row(0).body_in_map.yaw_rad - yaw_rad > 0.2, soon_ms);

        page.screenshot("world_palette");
        page.map().setFocus();
        QTest::keyClick(&page.map(), Qt::Key_Delete);
        QTRY_COMPARE_WITH_TIMEOUT(page.count(), 0, soon_ms);
        QVERIFY(!page.window().commands().action("world.delete")->isEnabled());
        page.pressKey(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(page.isNear(0, {7, 8}, 0.5), soon_ms); // it may have slid a little on its slope
        QAction* const redo = page.window().commands().action("edit.redo");
        QVERIFY(redo->isEnabled());
        redo->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(page.count(), 0, soon_ms);
        QVERIFY(!redo->isEnabled());
        QVERIFY(page.window().commands().action("edit.undo")->isEnabled());
    }

    void anObjectIsDraggedOutOfThePalette() {
        WorldPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        page.open();
        QTRY_VERIFY_WITH_TIMEOUT(page.isOpen(), soon_ms);
        page.lookAt({0, 0});
        // The platform's own drag loop is no friend of tests: what it sends to the map is sent here.
        QTest::mouseClick(page.button("Ball"), Qt::LeftButton);
        QMimeData data;
        data.setData(widgets::object_mime, "Ball");
        QDragEnterEvent enter(page.at({3, 3}), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&page.map(), &enter);
        QVERIFY(enter.isAccepted());
        QVERIFY(page.map().content().objects.ghost);
        QDropEvent drop(QPointF(page.at({3, 3})), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&page.map(), &drop);
        QTRY_COMPARE_WITH_TIMEOUT(page.count(), 1, soon_ms);
        QCOMPARE(page.panel().model().row(0).kind, QString("Ball"));
    }

    void anObjectGoesAlongItsWayPoints() {
        // The ground is level: once the object has arrived it lies there as any other, and slides on a slope.
        QTemporaryDir folder;
        QVERIFY(sim::writeWorld(yardWithStatues(), folder.filePath("yard").toStdString()));
        WorldPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        page.open();
        QTRY_VERIFY_WITH_TIMEOUT(page.isOpen(), soon_ms);
        page.dropFile(folder.filePath("yard"));
        QTRY_COMPARE_WITH_TIMEOUT(page.count(), 2, soon_ms);
        page.lookAt({0, 0});
        // The simulator tells of its objects before the window is connected to it.
        QTRY_VERIFY_WITH_TIMEOUT(page.window().commands().action("world.delete_all")->isEnabled(), soon_ms);
        page.put("Box", {-4, 2});
        QTRY_COMPARE_WITH_TIMEOUT(page.map().content().objects.selected, QString("Box1"), soon_ms);
        QVERIFY(!page.window().commands().action("world.go")->isEnabled());
        QTest::mouseClick(page.button("Add waypoints"), Qt::LeftButton);
        page.clickMap({4, 2});
        page.clickMap({4, -2});
        QTest::keyClick(&page.map(), Qt::Key_Escape);
        QCOMPARE(page.map().tool(), widgets::MapTool::Pan);
        QCOMPARE(page.panel().model().row(page.rowOf("Box")).waypoints_in_map_m.size(), std::size_t(2));
        page.chooseSpeed("10×");
        QTest::mouseClick(page.button("Start moving"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(page.isNear(page.rowOf("Box"), {4, -2}), flight_ms); // at 1×, without a robot
    }

    /// Defect D30 of the review: the window guessed at the class although the simulator had said what is in the way.
    void anObjectThatFindsNoRoomSaysWhy() {
        WorldPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        page.open();
        QTRY_VERIFY_WITH_TIMEOUT(page.isOpen(), soon_ms);
        const auto& trees = page.map().content().scenery->trees;
        const auto thick = std::ranges::max_element(trees, {}, &SceneryTree::trunk_radius_m);
        QVERIFY(thick != trees.end() && thick->trunk_radius_m > 0.1);
        page.lookAt(thick->center_m);
        page.put("Crate", thick->center_m);
        QTRY_VERIFY_WITH_TIMEOUT(!page.notified("Could not place Crate1").isEmpty(), soon_ms);
        const QString said = page.notified("Could not place Crate1");
        QVERIFY2(said.contains("such as a tree") && !said.contains("client"), qPrintable(said));
        for (int row = 0; row < page.window().views().notifications->model()->rowCount(); ++row)
            QVERIFY(!page.window().views().notifications->model()->row(row).text.startsWith("client "));
        QCOMPARE(page.count(), 0);
    }

    void wayPointsAreNotAddedWhileTheUserDrives() {
        WorldPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QVERIFY(page.spawnAt("PlayerStart"));
        page.open();
        QTRY_VERIFY_WITH_TIMEOUT(page.isOpen(), soon_ms);
        page.lookAt({0, 0});
        page.put("Conveyor", {0, 4});
        QTRY_COMPARE_WITH_TIMEOUT(page.map().content().objects.selected, QString("Conveyor1"), soon_ms);
        QAction* const add = page.window().commands().action("world.waypoints");
        QAction* const drive = page.window().commands().action("drive.take");
        QTRY_VERIFY(add->isEnabled());
        drive->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!add->isEnabled(), soon_ms);
        QVERIFY2(add->toolTip().contains("W drives forward"), qPrintable(add->toolTip()));
        drive->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(add->isEnabled(), soon_ms);
        QVERIFY2(add->toolTip().contains("waypoint"), qPrintable(add->toolTip()));
    }

    void aConveyorCarriesWhatLiesOnIt() {
        WorldPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        page.open();
        QTRY_VERIFY_WITH_TIMEOUT(page.isOpen(), soon_ms);
        page.lookAt({0, 0});
        page.put("Conveyor", {0, 2});
        QTRY_COMPARE_WITH_TIMEOUT(page.map().content().objects.selected, QString("Conveyor1"), soon_ms);
        page.put("Box", {-1, 2});
        QTRY_COMPARE_WITH_TIMEOUT(page.map().content().objects.selected, QString("Box1"), soon_ms);
        const auto box = [&] { return page.panel().model().row(page.rowOf("Box")).body_in_map.position_m; };
        QTRY_COMPARE_WITH_TIMEOUT(page.count(), 2, soon_ms);
        const double belt_m = page.panel().model().row(page.rowOf("Conveyor")).body_in_map.position_m.z();
        QVERIFY2(box().z() > belt_m + 0.3, "it lies on the belt, not in it");
        QVERIFY(!page.window().commands().action("world.go")->isEnabled()); // a box has nothing that runs
        page.clickMap({1, 2});
        QTRY_COMPARE(page.map().content().objects.selected, QString("Conveyor1"));
        QTest::mouseClick(page.button("Start moving"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(box().x() > -0.3, soon_ms);
        page.screenshot("world_conveyor");
        QTest::mouseClick(page.button("Stop moving"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(page.panel().model().row(page.rowOf("Box")).speed_m_s < 0.02, soon_ms);
        QVERIFY(box().z() > belt_m + 0.3);
        QVERIFY(page.isNear(page.rowOf("Conveyor"), {0, 2}));
    }

    void whatTheWorldBeganWithIsBroughtBack() {
        QTemporaryDir folder;
        QVERIFY(sim::writeWorld(yardWithStatues(), folder.filePath("yard").toStdString()));
        WorldPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        page.open();
        QTRY_VERIFY_WITH_TIMEOUT(page.isOpen(), soon_ms);
        page.dropFile(folder.filePath("yard"));
        const auto named = [&](const QString& name) {
            for (int row = 0; row < page.count(); ++row)
                if (page.panel().model().row(row).name == name)
                    return page.panel().model().row(row);
            return widgets::MapObject{};
        };
        QTRY_COMPARE_WITH_TIMEOUT(page.count(), 2, soon_ms);
        QAction* const delete_all = page.window().commands().action("world.delete_all");
        QTRY_VERIFY_WITH_TIMEOUT(delete_all->isEnabled(), soon_ms); // before, no server is connected yet
        QTRY_COMPARE_WITH_TIMEOUT(named("Venus").kind, QString("Statue"), soon_ms);
        const Vec3 size_m = named("Venus").size_m;
        QVERIFY(size_m.z() > 1.3);
        delete_all->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(page.count(), 0, soon_ms);
        QVERIFY(page.notified("cannot be brought back").isEmpty());
        page.window().commands().action("edit.undo")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(page.count(), 2, soon_ms);
        for (const auto& [name, x_m] : {std::pair("Venus", 3.0), std::pair("Apollo", -3.0)}) {
            QTRY_VERIFY_WITH_TIMEOUT((named(name).size_m - size_m).norm() < 0.02, soon_ms);
            QVERIFY(std::abs(named(name).body_in_map.position_m.x() - x_m) < 0.1);
        }
    }

    void marksOfSomebodyElsesRobotAreSeen() {
        WorldPage page;
        quint16 port = 0;
        connect(&page.window().control().simulator(), &server::SimulatorHost::ready, &page.window(),
                [&](quint16 bots) { port = bots; });
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses() && port != 0, soon_ms);
        QTcpSocket other;
        other.connectToHost(QHostAddress::LocalHost, port);
        QVERIFY(other.waitForConnected());
        other.write("INIT {ClassName USARBot.P2DX} {Name Stranger} {Start PlayerStart}\r\n"
                    "TRACE {On true} {Interval 0.2} {Color Blue}\r\nDRIVE {Left 6} {Right 6}\r\n");
        QTRY_VERIFY_WITH_TIMEOUT(page.map().traces().count() >= 5, soon_ms);
        QVERIFY(page.window().control().robots().empty());
        QVERIFY(page.window().commands().action("map.wipe_trace")->isEnabled());
        page.window().commands().action("map.wipe_trace")->trigger();
        QVERIFY(page.map().traces().count() < 3);
    }

    void aRobotPushesWhatLiesInItsWayAndLeavesATrace() {
        WorldPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        page.clickStartPose("PlayerStart");
        auto* const card = page.window().views().spawn_card;
        QTRY_VERIFY(card->isVisible());
        auto* const classes = card->findChild<QComboBox*>();
        classes->setFocus();
        for (int i = 0; classes->currentText() != "P2DX" && i < classes->count(); ++i)
            QTest::keyClick(classes, Qt::Key_Down);
        page.press("Spawn");
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned && page.robot(1)->base_in_map,
                                 soon_ms);
        page.open();
        QTRY_VERIFY_WITH_TIMEOUT(page.isOpen(), soon_ms);
        const Vec2 start_m = page.robot(1)->base_in_map->position_m.head<2>();
        page.lookAt(start_m);
        page.put("Ball", start_m + Vec2(1.5, 0.0));
        QTRY_COMPARE_WITH_TIMEOUT(page.count(), 1, soon_ms);
        QVERIFY(page.window().commands().action("robot.trace")->isEnabled());
        page.pressKey(Qt::Key_M, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(page.window().commands().action("robot.trace")->isChecked(), soon_ms);
        QVERIFY(
            page.window().control().sendLine(page.robot(1)->connection, "DRIVE {Left 6} {Right 6}", by::Other{"test"}));
        QTRY_VERIFY_WITH_TIMEOUT(page.isNear(0, page.placeOf(0)) && page.placeOf(0).x() > start_m.x() + 2.2, soon_ms);
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->base_in_map->position_m.x() > start_m.x() + 4.0, soon_ms);
        QTRY_VERIFY_WITH_TIMEOUT(page.map().traces().count() >= 5, soon_ms);
        QVERIFY(
            page.window().control().sendLine(page.robot(1)->connection, "DRIVE {Left 0} {Right 0}", by::Other{"test"}));
        page.screenshot("world_trace");
        const QColor red = widgets::traceColor(protocol::TraceColor::Red);
        const int seen = countColor(page.map(), red);
        QVERIFY2(seen > 30, qPrintable(QString::number(seen)));
        page.map().setLayer(widgets::MapLayer::Traces, {false, 1.0});
        QVERIFY(countColor(page.map(), red) < seen / 4);
        page.pressKey(Qt::Key_M, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!page.window().commands().action("robot.trace")->isChecked(), soon_ms);
    }

    void whoNeverOpensThePaletteCostsTheServerNothing() {
        test::FakeRobotServer server;
        QVERIFY(server.listen());
        WorldPage page;
        page.connectToServer("127.0.0.1", server.port());
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        const test::Beats beats(100);
        QVERIFY(
            test::holdsUntil([&] { return server.heardOf("CONTROL").isEmpty() && server.heardOf("INIT").isEmpty(); },
                             [&] { return beats.count() >= 5; }));
    }

    void aServerWithoutWorldControllerIsSaidInTheDock() {
        test::FakeRobotServer server;
        server.answers_init = false;
        QVERIFY(server.listen());
        WorldPage page;
        page.connectToServer("127.0.0.1", server.port());
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        page.open();
        QTRY_VERIFY_WITH_TIMEOUT(!page.notified("does not answer as a world controller").isEmpty(), soon_ms);
        QVERIFY(!page.isOpen());
        page.screenshot("world_refused");
    }
};

USAR_TEST(tst_WindowWorld)

} // namespace tst_window_world

#include "tst_window_world.moc"
