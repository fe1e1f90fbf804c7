#include <QPushButton>
#include <QTest>

#include "core/mapping/height_map.h"
#include "tests/suite/suite.h"
#include "widgets/map/map_labels.h"
#include "widgets/map/map_overlay.h"
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
