// Robots on the map at their true size, and as marks where that would be too small.
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/map_hits.h"
#include "widgets/map/map_labels.h"
#include "widgets/style/theme.h"

namespace tst_robot_outline {

using namespace usar;
using namespace usar::widgets;

namespace {

/// 0.8 x 0.4 m, with an arm to the front left that overlaps it.
std::vector<Outline> cart() {
    return {outlineOfBox({}, {0.8, 0.4, 0.3}), outlineOfBox({{0.4, 0.1, 0.2}}, {0.4, 0.1, 0.1})};
}

MapRobot robotWith(const FootprintPtr& footprint) {
    MapRobot robot{"R1", 1, {{2.0, 1.0, 0.0}, 0.0, 0.0, pi / 2.0}};
    robot.footprint = footprint;
    return robot;
}

/// 400 x 400 pixels around the robot, y up.
MapTransform near(double pixels_per_m) {
    return {MapOrientation::YUp, Vec2(2.0, 1.0), pixels_per_m, QSizeF(400.0, 400.0)};
}

QImage picture(const MapRobot& robot, const MapTransform& transform, bool selected = false) {
    QImage image(400, 400, QImage::Format_RGB32);
    image.fill(tokens().background);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    paintRobot(painter, robot, transform, selected);
    return image;
}

/// Bounding box of everything that is not background.
QRect inked(const QImage& image) {
    QRect box;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y) != tokens().background)
                box |= QRect(x, y, 1, 1);
    return box;
}

} // namespace

class tst_RobotOutline : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }
    void footprintIsTheUnionOfItsParts();
    void nothingCoversNothing();
    void fileComesBeforeWhatTheRobotTells();
    void markFadesIntoTheOutline_data();
    void markFadesIntoTheOutline();
    void isNeverSmallerThanAMark();
    void outlineIsTrueToScaleAndTurned();
    void selectionRingIsAround();
    void outlineIsClickedWhereItIsSeen();
    void poseAloneKeepsTheOutline();
    void labelIsBesideTheOutline();
};

void tst_RobotOutline::footprintIsTheUnionOfItsParts() {
    const FootprintPtr cart_shape = footprintOf(cart());
    QVERIFY(cart_shape);
    QVERIFY(std::abs(cart_shape->length_m - 1.0) < 1e-6); // From -0.4 to 0.6 m.
    QVERIFY(std::abs(cart_shape->reach_m - std::hypot(0.6, 0.15)) < 1e-6);
    QVERIFY(cart_shape->shape.contains(QPointF(-0.1, -0.55))); // The arm: ahead, to the left.
    QVERIFY(!cart_shape->shape.contains(QPointF(0.1, -0.55)));
    QCOMPARE(cart_shape->shape.toSubpathPolygons().size(), 1); // No line between the parts.
}

void tst_RobotOutline::nothingCoversNothing() {
    QVERIFY(!footprintOf({}));
    QVERIFY(!footprintOf({Outline{}}));
    QVERIFY(!footprintOf({outlineOfBox({}, Vec3::Zero())}));
    Footprints footprints;
    QVERIFY(!footprints.of("USARBot.P2AT", {}, std::nullopt));
    QVERIFY(!footprints.of("USARBot.P2AT", {}, Vec3(NAN, 1.0, 1.0)));
}

void tst_RobotOutline::fileComesBeforeWhatTheRobotTells() {
    Footprints footprints;
    const std::map<QString, std::vector<Outline>> files{{"Cart", cart()}};
    const FootprintPtr from_file = footprints.of("USARBot.Cart", files, Vec3(3.0, 2.0, 1.0));
    QVERIFY(std::abs(from_file->length_m - 1.0) < 1e-6);
    QCOMPARE(footprints.of("USARBot.Cart", files, std::nullopt), from_file); // Made once.
    const FootprintPtr told = footprints.of("USARBot.Cart", {}, Vec3(3.0, 2.0, 1.0));
    QVERIFY(std::abs(told->length_m - 3.0) < 1e-6);
    QVERIFY(told->shape.contains(QPointF(0.99, -1.49)) && !told->shape.contains(QPointF(1.2, 0.0)));
    QCOMPARE(footprints.of("USARBot.Cart", {}, Vec3(3.0, 2.0, 1.0)), told);
    const FootprintPtr other = footprints.of("USARBot.Cart", {}, Vec3(1.5, 1.0, 1.0)); // Two sizes of one class.
    QVERIFY(std::abs(other->length_m - 1.5) < 1e-6);
}

void tst_RobotOutline::markFadesIntoTheOutline_data() {
    QTest::addColumn<double>("pixels_per_m");
    QTest::addColumn<double>("share");
    QTest::newRow("far away") << 1.0 << 0.0;
    QTest::newRow("14 pixels long") << 14.0 << 0.0;
    QTest::newRow("half way") << 25.0 << 0.5;
    QTest::newRow("36 pixels long") << 36.0 << 1.0;
    QTest::newRow("close") << 200.0 << 1.0;
}

void tst_RobotOutline::markFadesIntoTheOutline() {
    QFETCH(double, pixels_per_m);
    QFETCH(double, share);
    const FootprintPtr footprint = footprintOf(cart());
    QVERIFY(std::abs(outlineShare(robotWith(footprint), near(pixels_per_m)) - share) < 1e-6);
    QCOMPARE(outlineShare(robotWith(nullptr), near(pixels_per_m)), 0.0);
    MapRobot station = robotWith(footprint);
    station.station = true;
    QCOMPARE(outlineShare(station, near(pixels_per_m)), 0.0);
}

void tst_RobotOutline::isNeverSmallerThanAMark() {
    for (const double length_m : {0.05, 0.5, 1.0, 5.0})
        for (double pixels_per_m = 0.1; pixels_per_m < 300.0; pixels_per_m *= 1.3) {
            const MapRobot robot = robotWith(footprintOf({outlineOfBox({}, {length_m, length_m, 1.0})}));
            if (length_m * pixels_per_m > 350.0)
                continue;
            const QRect seen = inked(picture(robot, near(pixels_per_m)));
            QVERIFY2(std::max(seen.width(), seen.height()) >= 18,
                     qPrintable(QString("%1 m at %2 px/m: %3 px").arg(length_m).arg(pixels_per_m).arg(seen.width())));
            QVERIFY(reach_px(robot, near(pixels_per_m), false) >= symbol::robot_px);
        }
}

void tst_RobotOutline::outlineIsTrueToScaleAndTurned() {
    const QImage image = picture(robotWith(footprintOf(cart())), near(200.0));
    // Its yaw is 90 degrees, so with y up it points up: 200 px long from 80 px below to 120 px above the middle.
    QCOMPARE(image.pixelColor(200, 270), robotColor(1));
    QCOMPARE(image.pixelColor(165, 190), robotColor(1));
    QCOMPARE(image.pixelColor(180, 90), robotColor(1)); // The arm: to the left.
    QCOMPARE(image.pixelColor(220, 90), tokens().background);
    QCOMPARE(image.pixelColor(200, 300), tokens().background);
    const QRect seen = inked(image);
    QVERIFY2(std::abs(seen.height() - 200) <= 6 && std::abs(seen.width() - 80) <= 6,
             qPrintable(QString("%1 x %2").arg(seen.width()).arg(seen.height())));
    MapRobot stale = robotWith(footprintOf(cart()));
    stale.stale = true;
    QCOMPARE(picture(stale, near(200.0)).pixelColor(200, 270), tokens().background);
}

void tst_RobotOutline::selectionRingIsAround() {
    const MapRobot robot = robotWith(footprintOf(cart()));
    const QRect seen = inked(picture(robot, near(200.0), true));
    QVERIFY(seen.width() / 2.0 > 0.618 * 200.0);
    QCOMPARE(reach_px(robot, near(1.0), true), symbol::ring_px);
}

void tst_RobotOutline::outlineIsClickedWhereItIsSeen() {
    MapContent content;
    content.takeRobot(robotWith(footprintOf(cart())));
    const MapTransform close = near(200.0);
    const MapHits hits(content, close);
    QCOMPARE(hits.robotAt({200, 200}), QString("R1"));
    QCOMPARE(hits.robotAt({200, 270}), QString("R1")); // Farther from its place than a mark reaches.
    QCOMPARE(hits.robotAt({180, 90}), QString("R1"));
    QCOMPARE(hits.robotAt({220, 90}), QString());
    const MapTransform far = near(10.0);
    QCOMPARE(MapHits(content, far).robotAt({212, 200}), QString("R1")); // As a mark.
}

void tst_RobotOutline::poseAloneKeepsTheOutline() {
    MapContent content;
    const FootprintPtr footprint = footprintOf(cart());
    content.takeRobot(robotWith(footprint));
    content.takeRobot(robotWith(nullptr));
    QCOMPARE(content.robots.at("R1").robot.footprint, footprint);
    const FootprintPtr other = footprintOf({outlineOfBox({}, {2, 2, 2})});
    content.takeRobot(robotWith(other));
    QCOMPARE(content.robots.at("R1").robot.footprint, other);
}

void tst_RobotOutline::labelIsBesideTheOutline() {
    MapContent content;
    content.takeRobot(robotWith(footprintOf(cart())));
    const QRectF label = placeMapLabels(content, near(200.0)).robots.at("R1");
    QVERIFY(!label.intersects(QRectF(160, 80, 80, 200)));
}

USAR_TEST(tst_RobotOutline)

} // namespace tst_robot_outline

#include "tst_robot_outline.moc"
