// Trees and buildings of the world below what is measured.
#include <QElapsedTimer>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/ground_picture.h"
#include "widgets/map/map_hits.h"
#include "widgets/map/scenery_painter.h"

namespace tst_scenery {

using namespace usar;
using namespace usar::widgets;

namespace {

MapTransform viewAt(double pixels_per_m) {
    return {MapOrientation::YUp, Vec2::Zero(), pixels_per_m, QSizeF(400.0, 400.0)};
}

SceneryPtr oneTree(double crown_m, double trunk_m = 0.2) {
    return std::make_shared<const Scenery>(Scenery{{{{5.0, 5.0}, trunk_m, crown_m}}, {}});
}

QImage picture(const Scenery& scenery, const MapTransform& transform) {
    QImage image(400, 400, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    paintScenery(painter, scenery, transform);
    return image;
}

int lit(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixelColor(x, y) != QColor(Qt::black);
    return count;
}

} // namespace

class tst_Scenery : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }
    void crownHasItsSizeAtItsPlace_data();
    void crownHasItsSizeAtItsPlace();
    void trunkIsInTheMiddle();
    void smallTreesAreStillSeen();
    void buildingsAreTurned();
    void layerIsHiddenAndFaded();
    void pictureIsKeptUntilTheViewMoves();
    void thousandsOfTreesAreQuick();
    void treeTellsItsSize();
};

void tst_Scenery::crownHasItsSizeAtItsPlace_data() {
    QTest::addColumn<double>("pixels_per_m");
    QTest::newRow("a stamp") << 5.0;
    QTest::newRow("a large stamp") << 11.0;
    QTest::newRow("drawn") << 20.0;
}

void tst_Scenery::crownHasItsSizeAtItsPlace() {
    QFETCH(double, pixels_per_m);
    const MapTransform transform = viewAt(pixels_per_m);
    const QImage image = picture(*oneTree(2.0), transform);
    const QPoint at = transform.toScreen(Vec2(5.0, 5.0)).toPoint();
    const double area_px = pi * std::pow(2.0 * pixels_per_m, 2.0);
    QVERIFY2(std::abs(lit(image) / area_px - 1.0) < 0.35, qPrintable(QString::number(lit(image) / area_px)));
    const int inside = int(1.6 * pixels_per_m);
    const int outside = int(2.0 * pixels_per_m) + 3;
    for (const QPoint way : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)}) {
        QVERIFY(image.pixelColor(at + inside * way) != QColor(Qt::black));
        QCOMPARE(image.pixelColor(at + outside * way), QColor(Qt::black));
    }
}

void tst_Scenery::trunkIsInTheMiddle() {
    const MapTransform transform = viewAt(30.0);
    const QPoint at = transform.toScreen(Vec2(5.0, 5.0)).toPoint();
    QCOMPARE(picture(*oneTree(2.0), transform).pixelColor(at), tokens().text_muted);
    QVERIFY(picture(*oneTree(2.0, 0.0), transform).pixelColor(at) != tokens().text_muted); // A bush.
}

void tst_Scenery::smallTreesAreStillSeen() {
    for (const double pixels_per_m : {0.02, 0.1, 0.5, 1.0, 3.0})
        QVERIFY(lit(picture(*oneTree(2.0), viewAt(pixels_per_m))) > 0);
}

void tst_Scenery::buildingsAreTurned() {
    Scenery scenery;
    scenery.buildings.push_back(outlineOfBox({{0.0, 0.0, 1.0}, 0.0, 0.0, pi / 4.0}, {10.0, 10.0, 2.0}));
    const QImage image = picture(scenery, viewAt(10.0));
    QVERIFY(image.pixelColor(200, 135) != QColor(Qt::black)); // A corner points up, 7 m from the middle.
    QCOMPARE(image.pixelColor(245, 155), QColor(Qt::black));
}

void tst_Scenery::layerIsHiddenAndFaded() {
    MapContent content;
    content.scenery = oneTree(2.0);
    const MapTransform transform = viewAt(20.0);
    const QPoint at = transform.toScreen(Vec2(5.0, 5.0)).toPoint() + QPoint(20, 0);
    const auto color = [&](const LayerState& state) {
        content.layers[static_cast<std::size_t>(MapLayer::Objects)] = state;
        QImage image(400, 400, QImage::Format_RGB32);
        QPainter painter(&image);
        GroundPicture().paint(painter, content, transform);
        return image.pixelColor(at);
    };
    const QColor full = color({true, 1.0});
    const QColor none = color({false, 1.0});
    QVERIFY(full.green() > none.green() + 20);
    const int faint = color({true, 0.5}).green();
    QVERIFY(faint > none.green() + 5 && faint < full.green() - 5);
}

void tst_Scenery::pictureIsKeptUntilTheViewMoves() {
    MapContent content;
    content.scenery = oneTree(2.0);
    GroundPicture ground;
    QImage image(400, 400, QImage::Format_RGB32);
    QPainter painter(&image);
    const auto paint = [&](double pixels_per_m) { ground.paint(painter, content, viewAt(pixels_per_m)); };
    paint(10.0);
    MapObject ball;
    ball.name = "Ball";
    for (int i = 0; i < 20; ++i) { // A ball that rolls and a robot that flies change nothing below them.
        ball.body_in_map.position_m.x() += 0.1;
        content.setObjects({ball});
        content.takeRobot({"R1", 1, {{0.1 * i, 0.0, 5.0}}});
        paint(10.0);
    }
    QCOMPARE(ground.times_made(), 1);
    paint(11.0);
    QCOMPARE(ground.times_made(), 2);
    content.scenery = oneTree(3.0); // Another world.
    paint(11.0);
    QCOMPARE(ground.times_made(), 3);
}

/// Ten times the trees of the largest world that comes with the program, all in sight while the map is dragged.
void tst_Scenery::thousandsOfTreesAreQuick() {
    Scenery wood;
    for (int i = 0; i < 20000; ++i)
        wood.trees.push_back({{(i % 200) - 100.0, (i / 200) - 50.0}, 0.15, 1.0 + 0.1 * (i % 17)});
    double best_ms = 1e9;
    for (int i = 0; i < 5; ++i) {
        QElapsedTimer clock;
        clock.start();
        (void)picture(wood, viewAt(2.0));
        best_ms = std::min(best_ms, double(clock.nsecsElapsed()) / 1e6);
    }
    QVERIFY2(best_ms < 100.0, qPrintable(QString("%1 ms").arg(best_ms))); // 10 ms on a quiet machine.
    qInfo("20000 trees in %.1f ms", best_ms);
}

void tst_Scenery::treeTellsItsSize() {
    MapContent content;
    content.scenery = oneTree(2.0);
    const MapTransform transform = viewAt(10.0);
    const MapHits hits(content, transform);
    const QString text = hits.toolTipAt(transform.toScreen(Vec2(5.5, 5.5)));
    QVERIFY2(text.contains("Tree") && text.contains("4.0 m") && text.contains("0.40 m"), qPrintable(text));
    QVERIFY(hits.toolTipAt(transform.toScreen(Vec2(0.0, 0.0))).isEmpty());
    content.layers[static_cast<std::size_t>(MapLayer::Objects)].visible = false;
    QVERIFY(hits.toolTipAt(transform.toScreen(Vec2(5.5, 5.5))).isEmpty());
}

USAR_TEST(tst_Scenery)

} // namespace tst_scenery

#include "tst_scenery.moc"
