// Objects of the world as the list shows them and as the map draws them, and what is under a point of the map.
#include <random>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/map_hits.h"
#include "widgets/models/map/object_list_model.h"
#include "widgets/style/icons.h"

namespace tst_map_objects {

using namespace usar;
using namespace usar::widgets;

namespace {

MapObject crate(const QString& name, double x_m = 0.0, double y_m = 0.0) {
    MapObject object;
    object.name = name;
    object.kind = "Crate";
    object.body_in_map.position_m = {x_m, y_m, 0.0};
    return object;
}

QString cellOf(const ObjectListModel& model, int row, int column, int role = Qt::DisplayRole) {
    return model.data(model.index(row, column), role).toString();
}

double areaOf(const std::vector<Vec2>& hull) {
    double twice = 0.0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2& a = hull[i];
        const Vec2& b = hull[(i + 1) % hull.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2.0;
}

/// A robot, a start pose and an object, each alone, and all three on one place.
MapContent crowded() {
    MapContent content;
    MapRobot robot{"R2", 2, {}};
    robot.base_in_map = {{10.0, 0.0, 1.5}, 0.0, 0.0, pi / 2.0};
    content.takeRobot(robot);
    content.start_poses = {{"A", {{20.0, 0.0, 0.0}}}, {"B", {{10.0, 0.0, 0.0}}}};
    content.setObjects({crate("C1", 30.0, 0.0), crate("C2", 10.0, 0.0), crate("C3", 30.0, 0.0)});
    return content;
}

} // namespace

class tst_MapObjects : public QObject {
    Q_OBJECT
private slots:
    void listIsSortedWithNumbersInOrder();
    void cellsShowPlaceAndSpeed_data();
    void cellsShowPlaceAndSpeed();
    void headsNameTheColumns();
    void namesCarryKindAndSize_data();
    void namesCarryKindAndSize();
    void kindsHaveIcons_data();
    void kindsHaveIcons();
    void viewsAreToldNoMoreThanNeeded();
    void modelIsSoundThroughAllChanges();
    void boxKeepsItsAreaHoweverItIsTurned();
    void hullCoversWhatIsInside();
    void rotationOfABallDoesNotMatter();
    void hullOfNothingCoversNothing();
    void robotsAreHitWithinReach_data();
    void robotsAreHitWithinReach();
    void nearestOfSeveralIsHit();
    void poseThatIsNoNumberIsNeverHit();
    void hiddenLayersAreNotHit();
    void topmostObjectIsHit();
    void toolTipNamesTheFirstOfRobotStartPoseAndObject_data();
    void toolTipNamesTheFirstOfRobotStartPoseAndObject();
};

void tst_MapObjects::listIsSortedWithNumbersInOrder() {
    ObjectListModel model;
    model.setObjects({crate("Crate10"), crate("Ball2"), crate("Crate2"), crate("Ball10"), crate("Crate1")});
    QStringList names;
    for (int row = 0; row < model.rowCount(); ++row)
        names << model.row(row).name;
    QCOMPARE(names, QStringList({"Ball2", "Ball10", "Crate1", "Crate2", "Crate10"}));
    QCOMPARE(model.indexOf("Crate2"), std::optional(3));
    QVERIFY(!model.indexOf("Crate3"));
    QVERIFY(!model.indexOf({}));
}

void tst_MapObjects::cellsShowPlaceAndSpeed_data() {
    QTest::addColumn<double>("x_m");
    QTest::addColumn<double>("y_m");
    QTest::addColumn<double>("speed_m_s");
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("speed");
    QTest::newRow("still") << 1.5 << -2.0 << 0.0 << "1.5  −2.0"
                           << "0.0";
    QTest::newRow("moving") << 0.0 << 0.0 << 0.5 << "0.0  0.0"
                            << "0.5";
    QTest::newRow("unknown speed") << 100.0 << 7.0 << -1.0 << "100.0  7.0"
                                   << "";
    QTest::newRow("no place") << qQNaN() << 7.0 << -1.0 << "–  7.0"
                              << "";
}

void tst_MapObjects::cellsShowPlaceAndSpeed() {
    QFETCH(double, x_m);
    QFETCH(double, y_m);
    QFETCH(double, speed_m_s);
    MapObject object = crate("Crate1", x_m, y_m);
    if (speed_m_s >= 0.0)
        object.speed_m_s = speed_m_s;
    ObjectListModel model;
    model.setObjects({object});
    QCOMPARE(cellOf(model, 0, ObjectListModel::Name), QStringLiteral("Crate1"));
    QTEST(cellOf(model, 0, ObjectListModel::Place), "place");
    QTEST(cellOf(model, 0, ObjectListModel::Speed), "speed");
}

void tst_MapObjects::headsNameTheColumns() {
    const ObjectListModel model;
    const QStringList names{"Object", "x, y m", "m/s"};
    for (int column = 0; column < ObjectListModel::column_count; ++column)
        QCOMPARE(model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(), names[column]);
    QVERIFY(!model.headerData(0, Qt::Vertical, Qt::DisplayRole).isValid());
    QCOMPARE(model.headerData(0, Qt::Horizontal, Qt::TextAlignmentRole).toInt(),
             static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter));
    QCOMPARE(model.headerData(1, Qt::Horizontal, Qt::TextAlignmentRole).toInt(),
             static_cast<int>(Qt::AlignRight | Qt::AlignVCenter));
    QCOMPARE(model.rowCount(), 0);
}

void tst_MapObjects::namesCarryKindAndSize_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("spoken");
    QTest::addColumn<QString>("tip");
    QTest::newRow("known kind") << "Crate"
                                << "Box1, Crate"
                                << "Box1 (Crate): 2.00 × 1.00 × 0.50 m, z 0.25 m, yaw 90°";
    QTest::newRow("unknown kind") << ""
                                  << "Box1, unknown kind"
                                  << "Box1 (unknown kind): 2.00 × 1.00 × 0.50 m, z 0.25 m, yaw 90°";
}

void tst_MapObjects::namesCarryKindAndSize() {
    QFETCH(QString, kind);
    MapObject object = crate("Box1");
    object.kind = kind;
    object.size_m = {2.0, 1.0, 0.5};
    object.body_in_map.position_m.z() = 0.25;
    object.body_in_map.yaw_rad = pi / 2.0;
    ObjectListModel model;
    model.setObjects({object});
    QTEST(cellOf(model, 0, ObjectListModel::Name, Qt::AccessibleTextRole), "spoken");
    QTEST(cellOf(model, 0, ObjectListModel::Speed, Qt::ToolTipRole), "tip");
    QVERIFY(model.data(model.index(0, ObjectListModel::Name), Qt::DecorationRole).isValid());
    QVERIFY(!model.data(model.index(0, ObjectListModel::Place), Qt::DecorationRole).isValid());
    QVERIFY(!model.data({}, Qt::DisplayRole).isValid());
}

void tst_MapObjects::kindsHaveIcons_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("name");
    QTest::newRow("same word") << "Crate"
                               << "crate";
    QTest::newRow("two words") << "SoccerBall"
                               << "soccer-ball";
    QTest::newRow("unknown") << "USARModels.Pallet"
                             << "help";
    QTest::newRow("none") << ""
                          << "help";
}

void tst_MapObjects::kindsHaveIcons() {
    QFETCH(QString, kind);
    QTEST(kindIcon(kind), "name");
    QVERIFY(iconNames().contains(kindIcon(kind)));
}

void tst_MapObjects::viewsAreToldNoMoreThanNeeded() {
    ObjectListModel model;
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    model.setObjects({crate("A"), crate("B")});
    QCOMPARE(reset.count(), 1);
    model.setObjects({crate("B"), crate("A")}); // Only the order differs.
    QCOMPARE(reset.count(), 1);
    QCOMPARE(changed.count(), 0);
    model.setObjects({crate("A", 1.0), crate("B")});
    QCOMPARE(reset.count(), 1);
    QCOMPARE(changed.count(), 1);
    model.setObjects({crate("A", 1.0)});
    QCOMPARE(reset.count(), 2);
    model.setObjects({});
    QCOMPARE(reset.count(), 3);
    model.setObjects({});
    QCOMPARE(reset.count(), 3);
    QCOMPARE(changed.count(), 1);
}

void tst_MapObjects::modelIsSoundThroughAllChanges() {
    ObjectListModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    std::mt19937 random(7);
    for (int round = 0; round < 100; ++round) {
        std::vector<MapObject> objects;
        for (int i = 0; i < 12; ++i)
            if (random() % 2)
                objects.push_back(crate(QString("Crate%1").arg(i), static_cast<double>(random() % 5)));
        model.setObjects(objects);
        QCOMPARE(model.rowCount(), static_cast<int>(objects.size()));
        for (const MapObject& object : objects)
            QVERIFY(model.row(model.indexOf(object.name).value()) == object);
    }
}

void tst_MapObjects::boxKeepsItsAreaHoweverItIsTurned() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> angle(-pi, pi);
    std::uniform_real_distribution<double> length(0.1, 20.0);
    for (int i = 0; i < 200; ++i) {
        MapObject box = crate("box", angle(random), angle(random));
        box.size_m = {length(random), length(random), length(random)};
        box.body_in_map.yaw_rad = angle(random);
        const double area_m2 = box.size_m.x() * box.size_m.y();
        const double found_m2 = areaOf(outlineOf(box)); // Positive: counter-clockwise.
        QVERIFY2(std::abs(found_m2 - area_m2) < 1e-9 * std::max(1.0, area_m2), qPrintable(QString::number(found_m2)));
    }
}

void tst_MapObjects::hullCoversWhatIsInside() {
    std::mt19937 random(13);
    std::uniform_real_distribution<double> angle(-pi, pi);
    std::uniform_real_distribution<double> share(-0.49, 0.49);
    for (const ObjectForm form : {ObjectForm::Box, ObjectForm::Sphere, ObjectForm::Cylinder})
        for (int i = 0; i < 100; ++i) {
            MapObject object = crate("thing", 3.0, -2.0);
            object.form = form;
            object.size_m = {2.0, 2.0, 1.0};
            object.body_in_map.roll_rad = angle(random) / 4.0;
            object.body_in_map.yaw_rad = angle(random);
            const std::vector<Vec2> hull = outlineOf(object);
            QVERIFY(areaOf(hull) > 0.0);
            QVERIFY(covers(hull, object.body_in_map.position_m.head<2>()));
            // A point of the inscribed cylinder, as seen from above.
            const Vec3 inside(share(random), share(random), share(random));
            if (form != ObjectForm::Sphere)
                QVERIFY(covers(hull, (object.body_in_map * inside).head<2>()));
            QVERIFY(!covers(hull, Vec2(3.0 + 2.0, -2.0)));
        }
}

void tst_MapObjects::rotationOfABallDoesNotMatter() {
    MapObject ball = crate("ball", 1.0, 2.0);
    ball.form = ObjectForm::Sphere;
    const std::vector<Vec2> still = outlineOf(ball);
    ball.body_in_map.roll_rad = 0.7;
    ball.body_in_map.pitch_rad = -0.3;
    ball.body_in_map.yaw_rad = 2.0;
    const std::vector<Vec2> rolled = outlineOf(ball);
    QCOMPARE(rolled.size(), still.size());
    for (std::size_t i = 0; i < still.size(); ++i)
        QVERIFY((rolled[i] - still[i]).norm() < 1e-12);
}

void tst_MapObjects::hullOfNothingCoversNothing() {
    QVERIFY(!covers({}, Vec2::Zero()));
    QVERIFY(!covers({Vec2(0.0, 0.0), Vec2(1.0, 0.0)}, Vec2(0.5, 0.0)));
    MapObject point = crate("point");
    point.size_m.setZero();
    QVERIFY(!covers(outlineOf(point), Vec2::Zero()));
    const std::vector<Vec2> square{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    QVERIFY(covers(square, Vec2(1.0, 0.5))); // On its edge.
    QVERIFY(covers(square, Vec2(0.0, 0.0))); // At its corner.
    QVERIFY(!covers(square, Vec2(1.0001, 0.5)));
}

void tst_MapObjects::robotsAreHitWithinReach_data() {
    QTest::addColumn<double>("away_px");
    QTest::addColumn<QString>("name");
    QTest::newRow("on it") << 0.0 << "R2";
    QTest::newRow("beside it") << 15.9 << "R2";
    QTest::newRow("too far") << 16.1 << "";
}

void tst_MapObjects::robotsAreHitWithinReach() {
    QFETCH(double, away_px);
    const MapContent content = crowded();
    const MapTransform transform;
    const QPointF at = transform.toScreen(Vec2(10.0, 0.0));
    const MapHits hits(content, transform);
    QTEST(hits.robotAt(at + QPointF(away_px, 0.0)), "name");
    QTEST(hits.robotAt(at - QPointF(0.0, away_px)), "name");
}

void tst_MapObjects::nearestOfSeveralIsHit() {
    MapContent content = crowded();
    MapRobot neighbor{"R3", 3, {}};
    neighbor.base_in_map.position_m = {12.0, 0.0, 0.0}; // 10 pixels away.
    content.takeRobot(neighbor);
    const MapTransform transform;
    const MapHits hits(content, transform);
    QCOMPARE(hits.robotAt(transform.toScreen(Vec2(10.9, 0.0))), QStringLiteral("R2"));
    QCOMPARE(hits.robotAt(transform.toScreen(Vec2(11.1, 0.0))), QStringLiteral("R3"));
    QCOMPARE(hits.startPoseAt(transform.toScreen(Vec2(19.0, 0.0))), std::optional<std::size_t>(0));
    QCOMPARE(hits.startPoseAt(transform.toScreen(Vec2(11.0, 0.0))), std::optional<std::size_t>(1));
}

void tst_MapObjects::poseThatIsNoNumberIsNeverHit() {
    MapContent content;
    MapRobot robot{"R1", 1, {}};
    robot.base_in_map.position_m.setConstant(qQNaN());
    content.takeRobot(robot);
    const MapTransform transform;
    for (const double x_px : {0.0, 320.0, 640.0})
        QVERIFY(MapHits(content, transform).robotAt(QPointF(x_px, 240.0)).isEmpty());
}

void tst_MapObjects::hiddenLayersAreNotHit() {
    MapContent content = crowded();
    const MapTransform transform;
    const MapHits hits(content, transform);
    const QPointF start = transform.toScreen(Vec2(20.0, 0.0));
    const QPointF object = transform.toScreen(Vec2(30.0, 0.0));
    QVERIFY(hits.startPoseAt(start));
    QVERIFY(!hits.objectAt(object).isEmpty());
    QVERIFY(!hits.toolTipAt(start).isEmpty());
    content.layers[static_cast<std::size_t>(MapLayer::StartPoses)].visible = false;
    content.layers[static_cast<std::size_t>(MapLayer::Objects)].visible = false;
    QVERIFY(!hits.startPoseAt(start));
    QVERIFY(hits.objectAt(object).isEmpty());
    QVERIFY(hits.toolTipAt(start).isEmpty());
    QVERIFY(!hits.gripAt(start)); // There is no area.
}

void tst_MapObjects::topmostObjectIsHit() {
    MapContent content = crowded();
    const MapTransform transform;
    const MapHits hits(content, transform);
    QCOMPARE(hits.objectAt(transform.toScreen(Vec2(30.0, 0.0))), QStringLiteral("C3"));
    content.setObjects({crate("C3", 30.0, 0.0), crate("C1", 30.0, 0.0)});
    QCOMPARE(hits.objectAt(transform.toScreen(Vec2(30.0, 0.0))), QStringLiteral("C1"));
    QVERIFY(hits.objectAt(transform.toScreen(Vec2(50.0, 0.0))).isEmpty());
}

void tst_MapObjects::toolTipNamesTheFirstOfRobotStartPoseAndObject_data() {
    QTest::addColumn<double>("x_m");
    QTest::addColumn<QString>("text");
    QTest::newRow("robot above all") << 10.0 << "R2, z 1.50 m, yaw 90°. Click selects it (key 2).";
    QTest::newRow("start pose") << 20.0 << "Start pose A. Double-click spawns a robot here; one click asks which.";
    QTest::newRow("object") << 30.0 << "Crate C3, 1.00 × 1.00 × 1.00 m. Drag moves it, Delete removes it.";
    QTest::newRow("open ground") << -20.0 << "";
}

void tst_MapObjects::toolTipNamesTheFirstOfRobotStartPoseAndObject() {
    QFETCH(double, x_m);
    const MapContent content = crowded();
    const MapTransform transform;
    QTEST(MapHits(content, transform).toolTipAt(transform.toScreen(Vec2(x_m, 0.0))), "text");
}

USAR_TEST(tst_MapObjects)

} // namespace tst_map_objects

#include "tst_map_objects.moc"
