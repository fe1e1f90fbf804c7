#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/pan_zoom.h"

namespace tst_pan_zoom {

using namespace usar::widgets;

namespace {

const QSizeF viewport(800.0, 600.0);

QRectF seen(const PanZoom& view) {
    return {view.corner, viewport / view.scale};
}

bool near(const QPointF& a, const QPointF& b) {
    return (a - b).manhattanLength() < 1e-6;
}

} // namespace

class tst_PanZoom : public QObject {
    Q_OBJECT
private slots:
    void screenAndDrawingAreInverse();
    void zoomKeepsThePlaceUnderTheCursor_data();
    void zoomKeepsThePlaceUnderTheCursor();
    void zoomStaysWithinLimits();
    void stepsOfTheWheelAddUp();
    void panGoesWithTheHand();
    void fitShowsAllOfIt_data();
    void fitShowsAllOfIt();
    void beginningIsReadable_data();
    void beginningIsReadable();
    void nothingChangesNothing();
    void nobodyGetsLost_data();
    void nobodyGetsLost();
    void scrollsNoFartherThanNecessary_data();
    void scrollsNoFartherThanNecessary();
};

void tst_PanZoom::screenAndDrawingAreInverse() {
    const PanZoom view{2.5, {30.0, -40.0}};
    QVERIFY(near(view.toScreen({30.0, -40.0}), {0.0, 0.0}));
    QVERIFY(near(view.toScreen({32.0, -36.0}), {5.0, 10.0}));
    QVERIFY(near(view.toDrawing(view.toScreen({7.0, 9.0})), {7.0, 9.0}));
}

void tst_PanZoom::zoomKeepsThePlaceUnderTheCursor_data() {
    QTest::addColumn<double>("factor");
    QTest::newRow("closer") << zoom_step::closer;
    QTest::newRow("farther") << zoom_step::farther;
    QTest::newRow("up to the limit") << 1000.0;
    QTest::newRow("down to the limit") << 0.0001;
}

void tst_PanZoom::zoomKeepsThePlaceUnderTheCursor() {
    QFETCH(double, factor);
    PanZoom view{1.0, {30.0, -40.0}};
    const QPointF cursor(600.0, 150.0);
    const QPointF there = view.toDrawing(cursor);
    view.zoomAt(cursor, factor);
    QVERIFY(view.scale != 1.0);
    QVERIFY(near(view.toDrawing(cursor), there));
}

void tst_PanZoom::zoomStaysWithinLimits() {
    PanZoom view;
    view.zoomAt({}, 1e9);
    QCOMPARE(view.scale, PanZoom::maximum_scale);
    view.zoomAt({}, 1e-9);
    QCOMPARE(view.scale, PanZoom::minimum_scale);
}

void tst_PanZoom::stepsOfTheWheelAddUp() {
    QCOMPARE(zoom_step::ofWheel(120), 1.2);
    QCOMPARE(zoom_step::ofWheel(0), 1.0);
    QCOMPARE(zoom_step::ofWheel(60) * zoom_step::ofWheel(60), 1.2);
    QCOMPARE(zoom_step::ofWheel(240) * zoom_step::ofWheel(-240), 1.0);
    QCOMPARE(zoom_step::closer * zoom_step::farther, 1.0);
}

void tst_PanZoom::panGoesWithTheHand() {
    PanZoom view{0.5, {30.0, -40.0}};
    const QPointF before = view.toScreen({7.0, 9.0});
    view.panBy({12.0, -5.0});
    QVERIFY(near(view.toScreen({7.0, 9.0}), before + QPointF(12.0, -5.0)));
}

void tst_PanZoom::fitShowsAllOfIt_data() {
    QTest::addColumn<QRectF>("bounds");
    QTest::addColumn<double>("scale");
    QTest::newRow("small: as it is") << QRectF(10, 20, 100, 100) << 1.0;
    QTest::newRow("wide") << QRectF(0, 0, 1536, 100) << 0.5;
    QTest::newRow("high") << QRectF(-50, 0, 100, 1136) << 0.5;
    QTest::newRow("huge") << QRectF(0, 0, 1e7, 1e3) << PanZoom::minimum_scale;
}

void tst_PanZoom::fitShowsAllOfIt() {
    QFETCH(QRectF, bounds);
    QFETCH(double, scale);
    PanZoom view{3.0, {1e6, 1e6}};
    view.fit(bounds, viewport);
    QCOMPARE(view.scale, scale);
    QVERIFY(near(seen(view).center(), bounds.center()));
    QVERIFY(scale == PanZoom::minimum_scale || seen(view).contains(bounds));
}

void tst_PanZoom::beginningIsReadable_data() {
    QTest::addColumn<QRectF>("bounds");
    QTest::addColumn<double>("scale");
    QTest::addColumn<bool>("whole");
    QTest::newRow("readable as a whole") << QRectF(0, 0, 850, 100) << 768.0 / 850.0 << true;
    QTest::newRow("too wide") << QRectF(5, 6, 5000, 100) << PanZoom::readable_scale << false;
    QTest::newRow("too high: as wide as it may be") << QRectF(5, 6, 850, 5000) << 768.0 / 850.0 << false;
    QTest::newRow("too high, narrow") << QRectF(5, 6, 100, 5000) << 1.0 << false;
}

void tst_PanZoom::beginningIsReadable() {
    QFETCH(QRectF, bounds);
    QFETCH(double, scale);
    QFETCH(bool, whole);
    PanZoom view;
    view.showBeginning(bounds, viewport);
    QCOMPARE(view.scale, scale);
    QCOMPARE(seen(view).contains(bounds), whole);
    if (!whole)
        QVERIFY(near(view.toScreen(bounds.topLeft()), {PanZoom::margin_px, PanZoom::margin_px}));
}

void tst_PanZoom::nothingChangesNothing() {
    const PanZoom before{0.5, {30.0, -40.0}};
    PanZoom view = before;
    view.fit({}, viewport);
    view.showBeginning({}, viewport);
    QCOMPARE(view, before);
}

void tst_PanZoom::nobodyGetsLost_data() {
    QTest::addColumn<QPointF>("corner");
    for (const QPointF& corner : {QPointF(-1e6, 0), QPointF(1e6, 0), QPointF(0, -1e6), QPointF(0, 1e6)})
        QTest::addRow("%g, %g", corner.x(), corner.y()) << corner;
}

void tst_PanZoom::nobodyGetsLost() {
    QFETCH(QPointF, corner);
    for (const QRectF& bounds : {QRectF(0, 0, 50, 50), QRectF(-3000, -3000, 9000, 9000)}) {
        PanZoom view{0.5, corner};
        view.keepInReach(bounds, viewport);
        QVERIFY(seen(view).intersects(bounds));
        const PanZoom reached = view;
        view.keepInReach(bounds, viewport);
        QCOMPARE(view, reached);
    }
}

void tst_PanZoom::scrollsNoFartherThanNecessary_data() {
    QTest::addColumn<QRectF>("box");
    QTest::addColumn<QPointF>("corner");
    QTest::newRow("is in view") << QRectF(100, 100, 50, 50) << QPointF(0, 0);
    QTest::newRow("to the right") << QRectF(900, 100, 50, 50) << QPointF(950 + 16 - 800, 0);
    QTest::newRow("above") << QRectF(100, -80, 50, 50) << QPointF(0, -80 - 16);
    QTest::newRow("larger than the view") << QRectF(100, 200, 2000, 2000) << QPointF(100 - 16, 200 - 16);
}

void tst_PanZoom::scrollsNoFartherThanNecessary() {
    QFETCH(QRectF, box);
    QFETCH(QPointF, corner);
    PanZoom view;
    QCOMPARE(view.bringIntoView(box, viewport), !corner.isNull());
    QVERIFY(near(view.corner, corner));
    QVERIFY(!view.bringIntoView(box, viewport));
}

USAR_TEST(tst_PanZoom)

} // namespace tst_pan_zoom

#include "tst_pan_zoom.moc"
