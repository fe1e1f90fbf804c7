#include <algorithm>

#include <QPushButton>
#include <QTest>

#include "core/mapping/height_map.h"
#include "tests/suite/suite.h"
#include "widgets/map/map_labels.h"
#include "widgets/map/map_overlay.h"
#include "widgets/map/map_painter.h"
#include "widgets/map/map_view.h"

namespace tst_map_sight {

using namespace usar;
using namespace usar::widgets;

namespace {

const Rectangle world{Vec2(-50, -50), Vec2(50, 50)};

void place(MapView& view, double x, double y) {
    view.setRobot({QStringLiteral("R1"), 1, {{x, y, 0}, 0, 0, 0}});
}

} // namespace

/// What is in sight: after the start of a mission, beside the legends, and when the world is out of the view.
class tst_MapSight : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void aStartedMissionIsSeenWhole_data();
    void aStartedMissionIsSeenWhole();
    void aMissionStaysInSightWhenTheViewIsResized();
    void labelsLieBesideEachOtherAndTheLegends_data();
    void labelsLieBesideEachOtherAndTheLegends();
    void namesOfStartPosesKeepClear_data();
    void namesOfStartPosesKeepClear();
    void aNarrowViewShortensTheSummary();
    void legendsLeaveASmallMapFree();
    void aLandingIsARingAsInExportedPictures();
    void aWayLeadsBackFromTheEmptyMap();

private:
    std::unique_ptr<MapView> view_;
};

void tst_MapSight::init() {
    view_ = std::make_unique<MapView>();
    view_->resize(800, 600);
    view_->setWorld(world, QStringLiteral("tall_test"));
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
}

void tst_MapSight::cleanup() {
    view_.reset();
}

void tst_MapSight::aStartedMissionIsSeenWhole_data() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QPointF>("robot_m");
    for (const QSize size : {QSize(372, 372), QSize(800, 600), QSize(1200, 500), QSize(500, 900)})
        for (const QPointF robot_m : {QPointF(-40, -30), QPointF(45, 45), QPointF(-40, 45), QPointF(15, 12)})
            QTest::addRow("%d x %d px, robot at %g %g", size.width(), size.height(), robot_m.x(), robot_m.y())
                << size << robot_m;
}

void tst_MapSight::aStartedMissionIsSeenWhole() {
    QFETCH(QSize, size);
    QFETCH(QPointF, robot_m);
    view_->resize(size);
    QTRY_COMPARE(view_->size(), size);
    const Rectangle area{Vec2(10, 10), Vec2(30, 25)};
    view_->setArea(area);
    place(*view_, robot_m.x() + 1.0, robot_m.y()); // Where it began
    place(*view_, robot_m.x(), robot_m.y());
    view_->selectRobot(QStringLiteral("R1"));
    view_->fit();
    const MapTransform& transform = view_->transform();
    QPolygonF seen = QPolygonF(transform.toScreen(area));
    seen << transform.toScreen(Vec2(robot_m.x(), robot_m.y()))
         << transform.toScreen(Vec2(robot_m.x() + 1, robot_m.y()));
    const QRectF needed = seen.boundingRect();
    QVERIFY(QRectF(view_->rect()).adjusted(20, 20, -20, -20).contains(needed));
    for (const QRectF& legend : OverlayPlaces(legendsOfAMission(view_->content()), transform).all())
        QVERIFY2(!legend.intersects(needed), "a legend lies over the mission");
    QVERIFY2(std::max(needed.width(), needed.height()) > 100.0, "the mission is large enough to be read");
}

/// A dock that opens takes room from the map.
void tst_MapSight::aMissionStaysInSightWhenTheViewIsResized() {
    const Rectangle area{Vec2(-40, 10), Vec2(-10, 40)};
    view_->setArea(area);
    view_->fit();
    const auto resizeTo = [&](const QSize& size) {
        view_->resize(size);
        QTRY_COMPARE(view_->size(), size);
    };
    for (const QSize size : {QSize(800, 380), QSize(420, 380), QSize(900, 600)}) {
        resizeTo(size);
        const QRectF seen = view_->transform().toScreen(area);
        QVERIFY(QRectF(view_->rect()).contains(seen));
        QVERIFY(std::max(seen.width() / view_->width(), seen.height() / view_->height()) > 0.3);
    }
    view_->zoomIn(); // A view of the user's own stays as it is.
    const double chosen_scale = view_->transform().pixels_per_m;
    resizeTo(QSize(800, 380));
    QCOMPARE(view_->transform().pixels_per_m, chosen_scale);
    view_->fitWorld();
    resizeTo(QSize(500, 500));
    QVERIFY(QRectF(view_->rect()).contains(view_->transform().toScreen(world)));
}

void tst_MapSight::labelsLieBesideEachOtherAndTheLegends_data() {
    QTest::addColumn<Rectangle>("area");
    QTest::newRow("above a robot") << Rectangle{Vec2(4, -10), Vec2(20, 10)};
    QTest::newRow("at the lower edge") << Rectangle{Vec2(-50, -10), Vec2(-40, 10)};
    QTest::newRow("at the right edge") << Rectangle{Vec2(10, -50), Vec2(20, -45)};
    QTest::newRow("in the corner of the legends") << Rectangle{Vec2(-50, -50), Vec2(-40, -40)};
    QTest::newRow("in the corner of the axes") << Rectangle{Vec2(40, -50), Vec2(50, -40)};
    QTest::newRow("everywhere") << Rectangle{Vec2(-50, -50), Vec2(50, 50)};
}

void tst_MapSight::labelsLieBesideEachOtherAndTheLegends() {
    QFETCH(Rectangle, area);
    view_->setArea(area);
    view_->setAreaSummary(QStringLiteral("9 lanes · 412 m · 6 min 12 s"));
    place(*view_, 0, 0);
    view_->setStartPoses({{"PlayerStart", {{0, 0, 0}, 0, 0, 0}}, {"FarCorner", {{46, -46, 0}, 0, 0, 0}}});
    const OverlayPlaces places(legendsOfAMission(view_->content()), view_->transform());
    const MapLabels labels = placeMapLabels(view_->content(), view_->transform(), places.all());
    std::vector<QRectF> boxes = places.all();
    boxes.push_back(labels.area);
    boxes.push_back(labels.robots.at(QStringLiteral("R1")));
    for (const auto& name : labels.start_poses)
        if (name)
            boxes.push_back(*name);
    QVERIFY(!labels.area.isEmpty());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t k = i + 1; k < boxes.size(); ++k)
            QVERIFY2(!boxes[i].intersects(boxes[k]), qPrintable(QStringLiteral("%1 and %2").arg(i).arg(k)));
    for (std::size_t i = places.all().size(); i < boxes.size(); ++i)
        QVERIFY(QRectF(view_->rect()).contains(boxes[i]));
}

/// Defect D27 of the review: names were cut at the edge, and lay under the axes and the legends.
void tst_MapSight::namesOfStartPosesKeepClear_data() {
    QTest::addColumn<QPointF>("at_px");
    MapTransform transform;
    transform.viewport = QSizeF(800, 600);
    const OverlayPlaces places(legendsOfAMission(MapContent()), transform);
    QTest::newRow("at the left edge") << QPointF(4, 300);
    QTest::newRow("at the right edge") << QPointF(796, 300);
    QTest::newRow("at the upper edge") << QPointF(400, 4);
    QTest::newRow("at the lower edge") << QPointF(400, 596);
    QTest::newRow("beside the axes") << QPointF(places.axes.left() - 12, places.axes.center().y() - 20);
    QTest::newRow("above the scale bar") << QPointF(places.scale_bar.center().x(), places.scale_bar.top() - 12);
    QTest::newRow("above the legend of heights") << QPointF(places.heights.center().x(), places.heights.top() - 12);
    QTest::newRow("beside the legend of marks") << QPointF(places.marks.left() - 12, places.marks.center().y());
}

void tst_MapSight::namesOfStartPosesKeepClear() {
    QFETCH(QPointF, at_px);
    QCOMPARE(view_->size(), QSize(800, 600));
    const Vec2 at_m = view_->transform().toMap(at_px);
    view_->setStartPoses({{"FarCorner", {{at_m.x(), at_m.y(), 0}, 0, 0, 0}}});
    QVERIFY((view_->transform().toScreen(at_m) - at_px).manhattanLength() < 1.0);
    const std::vector<QRectF> legends = OverlayPlaces(legendsOfAMission(view_->content()), view_->transform()).all();
    const MapLabels labels = placeMapLabels(view_->content(), view_->transform(), legends);
    QVERIFY2(labels.start_poses.front(), "there is room beside it");
    const QRectF name = *labels.start_poses.front();
    QVERIFY2(QRectF(view_->rect()).contains(name), "the edge cuts it");
    for (const QRectF& legend : legends)
        QVERIFY2(!legend.intersects(name), "a legend lies over it");
}

void tst_MapSight::aNarrowViewShortensTheSummary() {
    view_->setArea(Rectangle{Vec2(-20, -10), Vec2(20, 10)});
    view_->setAreaSummary(QStringLiteral("9 lanes · 412 m · 6 min 12 s"));
    QVERIFY(placeMapLabels(view_->content(), view_->transform()).area_text.endsWith(QStringLiteral("12 s")));
    MapTransform narrow = view_->transform();
    narrow.viewport = QSizeF(240, 300);
    const MapLabels labels = placeMapLabels(view_->content(), narrow);
    QVERIFY(QRectF(0, 0, 240, 300).contains(labels.area));
    QVERIFY(labels.area_text.startsWith(QStringLiteral("x ")) && !labels.area_text.endsWith(QStringLiteral("12 s")));
}

void tst_MapSight::legendsLeaveASmallMapFree() {
    MapTransform small;
    small.viewport = QSizeF(372, 372);
    double covered = 0.0;
    for (const QRectF& legend : OverlayPlaces(legendsOfAMission(view_->content()), small).all())
        covered += legend.width() * legend.height();
    QVERIFY(covered < 0.2 * 372 * 372);
}

void tst_MapSight::aLandingIsARingAsInExportedPictures() {
    QImage picture(80, 80, QImage::Format_RGB32);
    picture.fill(Qt::gray);
    QPainter painter(&picture);
    paintMark(painter, agent::MarkKind::Landing, QPointF(40, 40), 60.0);
    painter.end();
    QCOMPARE(picture.pixelColor(40, 40), QColor(Qt::gray));
    QCOMPARE(picture.pixelColor(40, 18), markColor(agent::MarkKind::Landing));
}

void tst_MapSight::aWayLeadsBackFromTheEmptyMap() {
    auto* const way_back = view_->findChild<QPushButton*>(QString(), Qt::FindDirectChildrenOnly);
    QVERIFY(way_back && way_back->isHidden());
    view_->setTransform({{}, Vec2(500, 0), 5.0, {}});
    QVERIFY(way_back->isVisible());
    QTest::mouseClick(way_back, Qt::LeftButton);
    QVERIFY(way_back->isHidden());
    QVERIFY(QRectF(view_->rect()).contains(view_->transform().toScreen(world)));
    for (int i = 0; i < 20; ++i)
        QTest::keyClick(view_.get(), Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(way_back->isVisible());
    place(*view_, view_->transform().center_m.x(), view_->transform().center_m.y());
    QVERIFY2(way_back->isHidden(), "the robot is in sight");
}

USAR_TEST(tst_MapSight)

} // namespace tst_map_sight

#include "tst_map_sight.moc"
