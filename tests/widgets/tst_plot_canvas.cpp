#include <algorithm>
#include <cmath>
#include <limits>

#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "core/protocol/reader.h"
#include "tests/suite/suite.h"
#include "widgets/panels/plot_canvas.h"
#include "widgets/style/theme.h"

namespace tst_plot_canvas {

using namespace usar;
using namespace usar::widgets;

namespace {

const std::string range = "SEN Sonar/F1/range";
const std::string yaw = "SEN GroundTruth/G/yaw";

/// As the window system tells of a mouse that is moved there without a button.
void moveMouse(QWidget* target, QPointF at) {
    QMouseEvent event(QEvent::MouseMove, at, target->mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(target, &event);
}

} // namespace

class tst_PlotCanvas : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void linesAppearInTheirColors();
    void aRemovedLineIsGone();
    void theSecondUnitHasAnAxisOfItsOwn();
    void aGapIsNotBridged();
    void aTurningRingKeepsTheLineBounded();
    void wheelOverTheValueAxisLeavesTimeAlone();
    void wheelOverTimeTellsThatFollowingEnded();
    void dragPansTime();
    void valuesFitWhatIsSeen();
    void constantValueStillHasAHeight();
    void pictureIsLargerThanTheScreenAndLeavesItAlone();
    void themeChangesTheGround();
    void tenthLineIsDashed();
    void cursorFollowsTheMouse();
    void noTooltipLiesOverTheCurve();

private:
    void feed(double time_s, double range_m, double yaw_rad = 0.0);
    QWidget* surface() const { return canvas_->focusProxy(); }
    int pixelsLike(const QColor& color) const;
    void wheel(QPoint at);

    SeriesStore store_;
    std::unique_ptr<PlotCanvas> canvas_;
    protocol::Reader reader_;
};

void tst_PlotCanvas::initTestCase() {
    applyTheme(Theme::Dark);
}

void tst_PlotCanvas::init() {
    store_ = SeriesStore();
    canvas_ = std::make_unique<PlotCanvas>();
    canvas_->resize(600, 300);
    static_cast<QWidget*>(canvas_.get())->show();
    QVERIFY(QTest::qWaitForWindowExposed(canvas_.get()));
}

void tst_PlotCanvas::cleanup() {
    canvas_.reset();
    applyTheme(Theme::Dark);
}

void tst_PlotCanvas::feed(double time_s, double range_m, double yaw_rad) {
    const QString sonar = QStringLiteral("SEN {Time %1} {Type Sonar} {Name F1 Range %2}").arg(time_s).arg(range_m);
    const QString truth = QStringLiteral("SEN {Time %1} {Type GroundTruth} {Name G} {Location 0,0,0} "
                                         "{Orientation 0,0,%2}");
    store_.take(reader_.read(sonar.toStdString()), Seconds(time_s));
    store_.take(reader_.read(truth.arg(time_s).arg(-yaw_rad).toStdString()), Seconds(time_s));
}

/// The reddest, greenest … of the picture: antialiasing spoils exact colors, hues stay.
int tst_PlotCanvas::pixelsLike(const QColor& color) const {
    const QImage image = canvas_->grab().toImage();
    int like = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            like += pixel.hsvSaturation() > 100 && std::abs(pixel.hsvHue() - color.hsvHue()) < 12 ? 1 : 0;
        }
    return like;
}

void tst_PlotCanvas::wheel(QPoint at) {
    QWheelEvent event(at, surface()->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(surface(), &event);
}

void tst_PlotCanvas::linesAppearInTheirColors() {
    store_.add(range);
    store_.add(yaw);
    for (int i = 0; i < 60; ++i)
        feed(i, std::sin(i * 0.1) + 2.0, std::cos(i * 0.1));
    QCOMPARE(pixelsLike(PlotCanvas::lineColor(0)), 0);
    canvas_->show(store_);
    QVERIFY(pixelsLike(PlotCanvas::lineColor(0)) > 100);
    QVERIFY(pixelsLike(PlotCanvas::lineColor(1)) > 100);
}

void tst_PlotCanvas::aRemovedLineIsGone() {
    store_.add(range);
    for (int i = 0; i < 60; ++i)
        feed(i, i);
    canvas_->show(store_);
    store_.remove(range);
    canvas_->dropLines(store_);
    QCOMPARE(canvas_->sampleCount(range), 0);
    QCOMPARE(pixelsLike(PlotCanvas::lineColor(0)), 0);
}

void tst_PlotCanvas::theSecondUnitHasAnAxisOfItsOwn() {
    // Alone, a small angle fills the height; on a shared axis with a range of kilometres it would be a flat line.
    store_.add(range);
    store_.add(yaw);
    for (int i = 0; i < 60; ++i)
        feed(i, 5000.0, 0.001 * i);
    canvas_->show(store_);
    const QImage image = canvas_->grab().toImage();
    int top = image.height();
    int bottom = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (const QColor pixel = image.pixelColor(x, y);
                pixel.hsvSaturation() > 100 && std::abs(pixel.hsvHue() - PlotCanvas::lineColor(1).hsvHue()) < 12) {
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
    QVERIFY2(bottom - top > 150, qPrintable(QString::number(bottom - top)));
}

void tst_PlotCanvas::aGapIsNotBridged() {
    store_.add(range);
    for (int i = 0; i <= 60; ++i)
        feed(i, i > 20 && i < 40 ? std::numeric_limits<double>::quiet_NaN() : 1.0);
    canvas_->show(store_);
    const int with_gap = pixelsLike(PlotCanvas::lineColor(0));
    store_.clear();
    store_.add(range);
    for (int i = 0; i <= 60; ++i)
        feed(i, 1.0);
    canvas_->show(store_);
    QVERIFY(with_gap > 0);
    QVERIFY(with_gap < pixelsLike(PlotCanvas::lineColor(0)) * 4 / 5);
}

void tst_PlotCanvas::aTurningRingKeepsTheLineBounded() {
    store_ = SeriesStore(100);
    store_.add(range);
    for (int round = 0; round < 5; ++round) {
        for (int i = 0; i < 70; ++i)
            feed(round * 70 + i, 1.0);
        canvas_->show(store_);
        QVERIFY(canvas_->sampleCount(range) <= 100);
    }
    QCOMPARE(canvas_->sampleCount(range), 100);
}

void tst_PlotCanvas::wheelOverTheValueAxisLeavesTimeAlone() {
    store_.add(range);
    feed(0, 1);
    feed(60, 3);
    canvas_->show(store_);
    const Seconds from = canvas_->visibleFrom();
    wheel({4, 150});
    QVERIFY(canvas_->following());
    QCOMPARE(canvas_->visibleFrom(), from);
}

void tst_PlotCanvas::wheelOverTimeTellsThatFollowingEnded() {
    store_.add(range);
    feed(0, 1);
    feed(60, 3);
    canvas_->show(store_);
    QSignalSpy told(canvas_.get(), &PlotCanvas::followingChanged);
    wheel({300, 150});
    wheel({300, 150});
    QCOMPARE(told.count(), 1);
    QCOMPARE(told[0][0].toBool(), false);
}

void tst_PlotCanvas::dragPansTime() {
    store_.add(range);
    feed(0, 1);
    feed(100, 3);
    canvas_->show(store_);
    const double to = canvas_->visibleTo().count();
    QTest::mousePress(surface(), Qt::LeftButton, {}, {300, 150});
    QMouseEvent move(QEvent::MouseMove, QPointF(400, 150), surface()->mapToGlobal(QPointF(400, 150)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(surface(), &move);
    QTest::mouseRelease(surface(), Qt::LeftButton, {}, {400, 150});
    QVERIFY(!canvas_->following());
    QVERIFY(canvas_->visibleTo().count() < to - 5.0);
}

void tst_PlotCanvas::valuesFitWhatIsSeen() {
    // A spike long ago must not flatten what is seen now.
    store_.add(range);
    feed(0, 10'000.0);
    for (int i = 100; i <= 160; ++i)
        feed(i, 1.0 + 0.01 * (i % 2));
    canvas_->show(store_);
    const int fitted = pixelsLike(PlotCanvas::lineColor(0));
    canvas_->setWindow(Seconds(std::numeric_limits<double>::infinity()));
    canvas_->show(store_);
    QVERIFY(fitted > 2 * pixelsLike(PlotCanvas::lineColor(0)));
}

void tst_PlotCanvas::constantValueStillHasAHeight() {
    store_.add(range);
    for (int i = 0; i < 60; ++i)
        feed(i, 0.0);
    canvas_->show(store_);
    QVERIFY(pixelsLike(PlotCanvas::lineColor(0)) > 100);
}

void tst_PlotCanvas::pictureIsLargerThanTheScreenAndLeavesItAlone() {
    store_.add(range);
    for (int i = 0; i < 60; ++i)
        feed(i, i);
    canvas_->show(store_);
    const QImage before = canvas_->grab().toImage();
    const QPixmap picture = canvas_->picture();
    QCOMPARE(picture.width(), 2 * canvas_->width());
    canvas_->show(store_);
    QCOMPARE(canvas_->grab().toImage(), before);
}

void tst_PlotCanvas::themeChangesTheGround() {
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        applyTheme(theme);
        canvas_->show(store_);
        QCOMPARE(canvas_->grab().toImage().pixel(5, 5), tokens(theme).surface.rgb());
    }
}

void tst_PlotCanvas::tenthLineIsDashed() {
    QCOMPARE(PlotCanvas::lineColor(9), PlotCanvas::lineColor(0));
    for (int i = 0; i < 9; ++i)
        store_.add("SEN Sonar/X" + std::to_string(i) + "/range");
    store_.add(range);
    for (int i = 0; i < 60; ++i)
        feed(i, 1.0);
    canvas_->show(store_);
    const int dashed = pixelsLike(PlotCanvas::lineColor(0));
    store_.clear();
    store_.add(range);
    for (int i = 0; i < 60; ++i)
        feed(i, 1.0);
    canvas_->show(store_);
    QVERIFY(dashed > 0);
    QVERIFY(dashed < pixelsLike(PlotCanvas::lineColor(0)));
}

void tst_PlotCanvas::cursorFollowsTheMouse() {
    store_.add(range);
    for (int i = 0; i < 60; ++i)
        feed(i, 2.0);
    canvas_->show(store_);
    QVERIFY(!canvas_->cursor());
    QSignalSpy moved(canvas_.get(), &PlotCanvas::cursorMoved);
    const QImage before = canvas_->grab().toImage();
    moveMouse(surface(), surface()->rect().center());
    QCOMPARE(moved.count(), 1);
    QVERIFY(canvas_->cursor());
    QVERIFY(*canvas_->cursor() > canvas_->visibleFrom() && *canvas_->cursor() < canvas_->visibleTo());
    QVERIFY(canvas_->grab().toImage() != before);
    const Seconds at = *canvas_->cursor();
    for (int i = 60; i < 90; ++i)
        feed(i, 2.0);
    canvas_->show(store_); // The picture moves on below the mouse.
    QVERIFY(*canvas_->cursor() > at);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(surface(), &leave);
    QVERIFY(!canvas_->cursor());
}

void tst_PlotCanvas::noTooltipLiesOverTheCurve() {
    QVERIFY(canvas_->toolTip().isEmpty());
    QVERIFY(surface()->toolTip().isEmpty());
    QVERIFY(canvas_->accessibleDescription().contains(QStringLiteral("Space to pause")));
}

USAR_TEST(tst_PlotCanvas)

} // namespace tst_plot_canvas

#include "tst_plot_canvas.moc"
