// The corrected path on the map: where its points are, apart from the trail, and of the robot whose map was corrected.
#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/map_overlay.h"
#include "widgets/map/map_view.h"
#include "widgets/style/theme.h"

namespace tst_corrected_path {

using namespace usar;
using namespace usar::widgets;

namespace {

const QString robot = QStringLiteral("R1");

SharedPath pathAlong(double y_m) {
    auto points_m = std::make_shared<std::vector<Vec2>>();
    for (double x_m = -30.0; x_m <= 30.0; x_m += 0.25)
        points_m->emplace_back(x_m, y_m);
    return points_m;
}

/// A row of columns of the picture in which a line stands out from the background, or does not.
struct Columns {
    int dark_and_light = 0; ///< as different as text is
    int empty = 0;
    int of_all = 0;
};

Columns columnsAlong(const MapView& view, const QImage& picture, double y_m) {
    Columns columns;
    const QPoint from = view.transform().toScreen(Vec2(-29.0, y_m)).toPoint();
    const QPoint to = view.transform().toScreen(Vec2(29.0, y_m)).toPoint();
    for (int x = from.x(); x < to.x(); ++x) {
        double most = 1.0;
        for (int dy = -2; dy <= 2; ++dy)
            most = std::max(most, contrast(picture.pixelColor(x, from.y() + dy), tokens().background));
        ++columns.of_all;
        columns.dark_and_light += most > 4.0 ? 1 : 0;
        columns.empty += most < 1.5 ? 1 : 0;
    }
    return columns;
}

} // namespace

class tst_CorrectedPath : public QObject {
    Q_OBJECT
private slots:
    void init() {
        applyTheme(Theme::Dark);
        view_ = std::make_unique<MapView>();
        view_->resize(800, 600);
        view_->setWorld({Vec2(-50, -50), Vec2(50, 50)}, QStringLiteral("tall_test"));
        view_->setOrientation(MapOrientation::YUp);
        for (const MapLayer layer : {MapLayer::World, MapLayer::Grid})
            view_->setLayer(layer, {false, 1.0});
        view_->setRobot({robot, 1, {{-40, -40, 0}, 0, 0, 0}});
        view_->show();
        QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    }
    void cleanup() {
        view_.reset();
        applyTheme(Theme::Dark);
    }

    void itIsADashedLineThroughItsPoints_data() {
        QTest::addColumn<Theme>("theme");
        QTest::newRow("dark") << Theme::Dark;
        QTest::newRow("light") << Theme::Light;
    }
    void itIsADashedLineThroughItsPoints() {
        QFETCH(Theme, theme);
        applyTheme(theme);
        QCOMPARE(columnsAlong(*view_, shown(), 10.0).dark_and_light, 0);
        view_->setCorrectedPath(robot, pathAlong(10.0));
        const Columns along = columnsAlong(*view_, shown(), 10.0);
        QVERIFY(along.of_all > 100);
        QVERIFY2(along.dark_and_light > along.of_all / 2 && along.empty > along.of_all / 5,
                 qPrintable(QString("%1 and %2 of %3").arg(along.dark_and_light).arg(along.empty).arg(along.of_all)));
        QCOMPARE(columnsAlong(*view_, shown(), 12.0).dark_and_light, 0);
    }

    void aLaterOneReplacesIt() {
        view_->setCorrectedPath(robot, pathAlong(10.0));
        view_->setCorrectedPath(robot, pathAlong(-10.0));
        QCOMPARE(columnsAlong(*view_, shown(), 10.0).dark_and_light, 0);
        QVERIFY(columnsAlong(*view_, shown(), -10.0).dark_and_light > 0);
    }

    void itGoesAndComes_data() {
        QTest::addColumn<std::function<void(MapView&)>>("make_go");
        QTest::newRow("declined") << std::function([](MapView& view) { view.setCorrectedPath(robot, nullptr); });
        QTest::newRow("hidden") << std::function([](MapView& view) {
            view.setLayer(MapLayer::Corrected, {false, 1.0});
        });
        QTest::newRow("robot removed") << std::function([](MapView& view) {
            view.removeRobot(robot);
            view.setRobot({robot, 1, {{-40, -40, 0}, 0, 0, 0}});
        });
    }
    void itGoesAndComes() {
        QFETCH(std::function<void(MapView&)>, make_go);
        const QImage without = shown();
        view_->setCorrectedPath(robot, pathAlong(10.0));
        QVERIFY(shown() != without);
        QVERIFY(legendsOf(view_->content(), view_->heights()).corrected_path);
        make_go(*view_);
        QCOMPARE(shown(), without);
        QVERIFY(!legendsOf(view_->content(), view_->heights()).corrected_path);
    }

    void aRobotThatIsNotOnTheMapHasNone() {
        const QImage without = shown();
        view_->setCorrectedPath(QStringLiteral("R2"), pathAlong(10.0));
        QCOMPARE(shown(), without);
        QVERIFY(!view_->content().robots.contains(QStringLiteral("R2")));
    }

    /// Parts of the view are painted alone, so the dashes may not depend on what part it is.
    void theDashesLieTheSameInEachPart() {
        const SharedPath path = pathAlong(10.0);
        const MapTransform& transform = view_->transform();
        QImage whole(800, 600, QImage::Format_ARGB32_Premultiplied), parts = whole;
        whole.fill(Qt::transparent);
        parts.fill(Qt::transparent);
        const QRectF all(QPointF(), transform.viewport);
        QPainter painter(&whole);
        paintCorrectedPath(painter, *path, transform, all);
        painter.end();
        painter.begin(&parts);
        for (const QRectF& part : {QRectF(0.0, 0.0, 301.0, 600.0), QRectF(301.0, 0.0, 499.0, 600.0)}) {
            painter.setClipRect(part);
            paintCorrectedPath(painter, *path, transform, part);
        }
        painter.end();
        QCOMPARE(parts, whole);
    }

private:
    QImage shown() { return view_->grab().toImage(); }

    std::unique_ptr<MapView> view_;
};

USAR_TEST(tst_CorrectedPath)

} // namespace tst_corrected_path

#include "tst_corrected_path.moc"
