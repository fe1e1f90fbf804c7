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

QColor lineColor(int index) {
    return plotLineColor(index, currentTheme());
}

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
    void aLongLineHasFewPointsAndItsPeak();
    void wheelOverTheValueAxisLeavesTimeAlone();
    void wheelOverTimeTellsThatFollowingEnded();
    void dragPansTime();
    void clickPlacesA();
    void dragMovesACursorAndNotTheTime();
    void keysMoveTheActiveCursor();
    void doubleClickLeavesCursorsAlone();
    void cursorsAreReadOut();
    void allCanvasesShowTheSameTime();
    void aClickChoosesTheCanvas();
    void timeStaysWhenASeriesIsAdded();
    void aReplayIsSentToAClickOnTheTime();
    void thirdUnitHasAnAxisToo();
    void aPageIsAPdf();
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

    /// Drags with the left button from one place to another.
    void drag(QPoint from, QPoint to);

    std::unique_ptr<PlotModel> model_;
    std::unique_ptr<PlotCanvas> canvas_;
    protocol::Reader reader_;
};

void tst_PlotCanvas::initTestCase() {
    applyTheme(Theme::Dark);
}

void tst_PlotCanvas::init() {
    model_ = std::make_unique<PlotModel>();
    canvas_ = std::make_unique<PlotCanvas>(*model_);
    canvas_->resize(600, 300);
    canvas_->show();
    QVERIFY(QTest::qWaitForWindowExposed(canvas_.get()));
}

void tst_PlotCanvas::cleanup() {
    canvas_.reset();
    model_.reset();
    applyTheme(Theme::Dark);
}

void tst_PlotCanvas::feed(double time_s, double range_m, double yaw_rad) {
    const QString sonar = QStringLiteral("SEN {Time %1} {Type Sonar} {Name F1 Range %2}").arg(time_s).arg(range_m);
    const QString truth = QStringLiteral("SEN {Time %1} {Type GroundTruth} {Name G} {Location 0,0,0} "
                                         "{Orientation 0,0,%2}");
    model_->take("", reader_.read(sonar.toStdString()), Seconds(time_s));
    model_->take("", reader_.read(truth.arg(time_s).arg(-yaw_rad).toStdString()), Seconds(time_s));
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
    model_->add(0, range);
    model_->add(0, yaw);
    for (int i = 0; i < 60; ++i)
        feed(i, std::sin(i * 0.1) + 2.0, std::cos(i * 0.1));
    QCOMPARE(pixelsLike(lineColor(0)), 0);
    canvas_->draw();
    QVERIFY(pixelsLike(lineColor(0)) > 100);
    QVERIFY(pixelsLike(lineColor(1)) > 100);
}

void tst_PlotCanvas::aRemovedLineIsGone() {
    model_->add(0, range);
    for (int i = 0; i < 60; ++i)
        feed(i, i);
    canvas_->draw();
    model_->remove(0, {"", range});
    canvas_->draw();
    QCOMPARE(canvas_->pointCount({"", range}), 0);
    QCOMPARE(pixelsLike(lineColor(0)), 0);
}

void tst_PlotCanvas::theSecondUnitHasAnAxisOfItsOwn() {
    // Alone, a small angle fills the height; on a shared axis with a range of kilometres it would be a flat line.
    model_->add(0, range);
    model_->add(0, yaw);
    for (int i = 0; i < 60; ++i)
        feed(i, 5000.0, 0.001 * i);
    canvas_->draw();
    const QImage image = canvas_->grab().toImage();
    int top = image.height();
    int bottom = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (const QColor pixel = image.pixelColor(x, y);
                pixel.hsvSaturation() > 100 && std::abs(pixel.hsvHue() - lineColor(1).hsvHue()) < 12) {
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
    QVERIFY2(bottom - top > 150, qPrintable(QString::number(bottom - top)));
}

void tst_PlotCanvas::aGapIsNotBridged() {
    model_->add(0, range);
    for (int i = 0; i <= 60; ++i)
        feed(i, i > 20 && i < 40 ? std::numeric_limits<double>::quiet_NaN() : 1.0);
    canvas_->draw();
    const int with_gap = pixelsLike(lineColor(0));
    model_->clear();
    model_->add(0, range);
    for (int i = 0; i <= 60; ++i)
        feed(i, 1.0);
    canvas_->draw();
    QVERIFY(with_gap > 0);
    QVERIFY(with_gap < pixelsLike(lineColor(0)) * 4 / 5);
}

void tst_PlotCanvas::aLongLineHasFewPointsAndItsPeak() {
    model_ = std::make_unique<PlotModel>(SeriesStore(1000, 64));
    canvas_ = std::make_unique<PlotCanvas>(*model_);
    canvas_->resize(600, 300);
    canvas_->show();
    model_->setWindow(std::numeric_limits<double>::infinity());
    model_->add(0, range);
    for (int i = 0; i < 20'000; ++i)
        feed(i * 0.1, i == 3'333 ? 50.0 : 1.0);
    canvas_->draw();
    QVERIFY(canvas_->pointCount({"", range}) > 100);
    QVERIFY(canvas_->pointCount({"", range}) < 4 * 600);
    const QImage image = canvas_->grab().toImage();
    const double x = canvas_->pixelOf(333.3);
    int drawn = 0; // of the spike, which is as tall as the canvas
    for (int y = 0; y < image.height(); ++y)
        for (int dx = -3; dx <= 3; ++dx)
            drawn += image.pixelColor(static_cast<int>(x) + dx, y).hsvSaturation() > 60 ? 1 : 0;
    QVERIFY2(drawn > 150, qPrintable(QString::number(drawn)));
}

void tst_PlotCanvas::wheelOverTheValueAxisLeavesTimeAlone() {
    model_->add(0, range);
    feed(0, 1);
    feed(60, 3);
    canvas_->draw();
    const Seconds from = canvas_->visibleFrom();
    wheel({4, 150});
    QVERIFY(canvas_->following());
    QCOMPARE(canvas_->visibleFrom(), from);
}

void tst_PlotCanvas::wheelOverTimeTellsThatFollowingEnded() {
    model_->add(0, range);
    feed(0, 1);
    feed(60, 3);
    canvas_->draw();
    QSignalSpy told(canvas_.get(), &PlotCanvas::followingChanged);
    wheel({300, 150});
    wheel({300, 150});
    QCOMPARE(told.count(), 1);
    QCOMPARE(told[0][0].toBool(), false);
}

void tst_PlotCanvas::drag(QPoint from, QPoint to) {
    QTest::mousePress(surface(), Qt::LeftButton, {}, from);
    for (const QPoint at : {(from + to) / 2, to}) {
        QMouseEvent move(QEvent::MouseMove, QPointF(at), surface()->mapToGlobal(QPointF(at)), Qt::NoButton,
                         Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(surface(), &move);
    }
    QTest::mouseRelease(surface(), Qt::LeftButton, {}, to);
}

void tst_PlotCanvas::dragPansTime() {
    model_->add(0, range);
    feed(0, 1);
    feed(100, 3);
    canvas_->draw();
    const double to = canvas_->visibleTo().count();
    drag({300, 150}, {400, 150});
    QVERIFY(!canvas_->following());
    QVERIFY(canvas_->visibleTo().count() < to - 5.0);
    QVERIFY(model_->cursors() == PlotCursors{}); // a drag is no click
}

void tst_PlotCanvas::clickPlacesA() {
    QSignalSpy changed(canvas_.get(), &PlotCanvas::cursorsChanged);
    QTest::mouseClick(surface(), Qt::LeftButton, {}, {300, 150});
    QVERIFY(model_->cursors().a_s);
    QVERIFY(std::abs(canvas_->pixelOf(*model_->cursors().a_s) - 300.0) < 0.5);
    QVERIFY(!model_->cursors().b_s);
    QTest::mouseClick(surface(), Qt::LeftButton, Qt::ShiftModifier, {400, 150});
    QVERIFY(std::abs(canvas_->pixelOf(*model_->cursors().b_s) - 400.0) < 0.5);
    QCOMPARE(changed.count(), 2);
    QVERIFY(canvas_->following()); // measuring does not stop the picture
}

void tst_PlotCanvas::dragMovesACursorAndNotTheTime() {
    QTest::mouseClick(surface(), Qt::LeftButton, {}, {300, 150});
    QTest::mouseClick(surface(), Qt::LeftButton, Qt::ShiftModifier, {400, 150});
    const Seconds from = canvas_->visibleFrom();
    drag({402, 100}, {450, 120});
    QVERIFY(std::abs(canvas_->pixelOf(*model_->cursors().b_s) - 450.0) < 0.5);
    QVERIFY(std::abs(canvas_->pixelOf(*model_->cursors().a_s) - 300.0) < 0.5);
    QCOMPARE(canvas_->visibleFrom(), from);
    drag({200, 150}, {260, 150}); // beside them: pans again
    QVERIFY(canvas_->visibleFrom() < from);
}

void tst_PlotCanvas::keysMoveTheActiveCursor() {
    QVERIFY(!canvas_->moveCursor(1.0));
    canvas_->placeCursor(CursorName::A);
    const double at_px = canvas_->pixelOf(*model_->cursors().a_s);
    QVERIFY(canvas_->moveCursor(-7.0));
    QVERIFY(std::abs(canvas_->pixelOf(*model_->cursors().a_s) - (at_px - 7.0)) < 0.01);
    QVERIFY(canvas_->removeCursor());
    QVERIFY(!canvas_->removeCursor());
}

void tst_PlotCanvas::doubleClickLeavesCursorsAlone() {
    QTest::mouseClick(surface(), Qt::LeftButton, {}, {300, 150});
    const PlotCursors before = model_->cursors();
    QTest::mouseClick(surface(), Qt::LeftButton, {}, {200, 150}); // the first click of the two
    QTest::mouseDClick(surface(), Qt::LeftButton, {}, {200, 150});
    QVERIFY(model_->cursors() == before);
}

void tst_PlotCanvas::cursorsAreReadOut() {
    model_->add(0, range);
    for (int i = 0; i < 60; ++i)
        feed(i, 2.0);
    canvas_->draw();
    QTest::mouseClick(surface(), Qt::LeftButton, {}, {300, 150});
    QVERIFY(surface()->accessibleDescription().startsWith(QStringLiteral("Cursor A is at ")));
    QVERIFY(surface()->accessibleDescription().contains(QStringLiteral("Sonar F1 range: at A 2.00 m")));
}

void tst_PlotCanvas::allCanvasesShowTheSameTime() {
    model_->addCanvas();
    model_->add(0, range);
    model_->add(1, yaw);
    for (int i = 0; i < 60; ++i)
        feed(i, std::sin(i * 0.1), std::cos(i * 0.1));
    canvas_->draw();
    const QPoint upper(300, 60);
    const QPoint lower(300, 230);
    QCOMPARE(canvas_->canvasAt(upper), 0U);
    QCOMPARE(canvas_->canvasAt(lower), 1U);
    // Both lines end at the same pixel, whatever the width of the numbers beside the axes.
    const QImage image = canvas_->grab().toImage();
    const auto endOf = [&](int index) {
        for (int x = image.width() - 1; x >= 0; --x)
            for (int y = 10; y < image.height(); ++y)
                if (const QColor pixel = image.pixelColor(x, y);
                    pixel.hsvSaturation() > 100 && std::abs(pixel.hsvHue() - lineColor(index).hsvHue()) < 12)
                    return x;
        return -1;
    };
    QVERIFY(endOf(0) > 0);
    QVERIFY2(std::abs(endOf(0) - endOf(1)) <= 2, qPrintable(QStringLiteral("%1 %2").arg(endOf(0)).arg(endOf(1))));
    const Seconds from = canvas_->visibleFrom();
    wheel(lower);
    QVERIFY(canvas_->visibleFrom() > from);
    const double span = (canvas_->visibleTo() - canvas_->visibleFrom()).count();
    wheel(upper);
    QVERIFY((canvas_->visibleTo() - canvas_->visibleFrom()).count() < span);
    QVERIFY(canvas_->pointCount({"", yaw}) > 10);
    model_->removeCanvas(0);
    canvas_->draw();
    QCOMPARE(canvas_->canvasAt(lower), 0U);
    QCOMPARE(canvas_->pointCount({"", range}), 0);
}

void tst_PlotCanvas::aClickChoosesTheCanvas() {
    model_->addCanvas();
    canvas_->draw();
    QCOMPARE(canvas_->chosen(), 0U);
    QTest::mouseClick(surface(), Qt::LeftButton, {}, {300, 230});
    QCOMPARE(canvas_->chosen(), 1U);
}

void tst_PlotCanvas::timeStaysWhenASeriesIsAdded() {
    model_->add(0, range);
    for (int i = 0; i < 100; ++i)
        feed(i, 1.0);
    canvas_->draw();
    canvas_->zoomTime(4.0);
    canvas_->panTime(-0.3);
    const Seconds from = canvas_->visibleFrom();
    const Seconds to = canvas_->visibleTo();
    model_->add(0, yaw);
    feed(100, 1.0, 0.5);
    canvas_->draw();
    model_->addCanvas();
    canvas_->draw();
    QCOMPARE(canvas_->visibleFrom(), from);
    QCOMPARE(canvas_->visibleTo(), to);
}

void tst_PlotCanvas::aReplayIsSentToAClickOnTheTime() {
    QSignalSpy wanted(canvas_.get(), &PlotCanvas::momentRequested);
    const QPoint times(300, 292);
    QTest::mouseClick(surface(), Qt::LeftButton, {}, times);
    QCOMPARE(wanted.count(), 0); // no replay
    const QImage before = canvas_->grab().toImage();
    canvas_->setMoment(20.0);
    QTRY_VERIFY(canvas_->grab().toImage() != before);
    QTest::mouseClick(surface(), Qt::LeftButton, {}, times);
    QTest::mouseClick(surface(), Qt::LeftButton, Qt::ControlModifier, {200, 150});
    QCOMPARE(wanted.count(), 2);
    QVERIFY(std::abs(canvas_->pixelOf(wanted[0][0].value<Seconds>().count()) - 300.0) < 0.5);
    QVERIFY(std::abs(canvas_->pixelOf(wanted[1][0].value<Seconds>().count()) - 200.0) < 0.5);
    QVERIFY(!model_->cursors().a_s);
}

void tst_PlotCanvas::thirdUnitHasAnAxisToo() {
    const std::string battery = "STA/battery";
    for (const std::string& path : {range, yaw, battery})
        model_->add(0, path);
    for (int i = 0; i < 60; ++i) {
        feed(i, 5000.0 + i, -0.001 * i);
        const int battery_s = 100 + (i < 20 ? 0 : i < 40 ? 50 : 20);
        model_->take(
            "", reader_.read("STA {Time " + std::to_string(i) + "} {Battery " + std::to_string(battery_s) + "}"), {});
    }
    canvas_->draw();
    // Each line fills the height, so each has a scale of its own.
    const QImage image = canvas_->grab().toImage();
    for (int index = 0; index < 3; ++index) {
        int top = image.height();
        int bottom = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (const QColor pixel = image.pixelColor(x, y);
                    pixel.hsvSaturation() > 100 && std::abs(pixel.hsvHue() - lineColor(index).hsvHue()) < 12) {
                    top = std::min(top, y);
                    bottom = std::max(bottom, y);
                }
        QVERIFY2(bottom - top > 150, qPrintable(QStringLiteral("%1: %2").arg(index).arg(bottom - top)));
    }
}

void tst_PlotCanvas::aPageIsAPdf() {
    model_->add(0, range);
    model_->addCanvas();
    model_->add(1, yaw);
    for (int i = 0; i < 60; ++i)
        feed(i, i, 0.1);
    canvas_->draw();
    const QImage before = canvas_->grab().toImage();
    const QByteArray page = canvas_->pdf(QStringLiteral("R1"));
    QVERIFY(page.startsWith("%PDF-"));
    QVERIFY(page.size() > 2000);
    QCOMPARE(canvas_->grab().toImage(), before); // the screen is as it was
}

void tst_PlotCanvas::valuesFitWhatIsSeen() {
    // A spike long ago must not flatten what is seen now.
    model_->add(0, range);
    feed(0, 10'000.0);
    for (int i = 100; i <= 160; ++i)
        feed(i, 1.0 + 0.01 * (i % 2));
    canvas_->draw();
    const int fitted = pixelsLike(lineColor(0));
    model_->setWindow(std::numeric_limits<double>::infinity());
    canvas_->draw();
    QVERIFY(fitted > 2 * pixelsLike(lineColor(0)));
}

void tst_PlotCanvas::constantValueStillHasAHeight() {
    model_->add(0, range);
    for (int i = 0; i < 60; ++i)
        feed(i, 0.0);
    canvas_->draw();
    QVERIFY(pixelsLike(lineColor(0)) > 100);
}

void tst_PlotCanvas::pictureIsLargerThanTheScreenAndLeavesItAlone() {
    model_->add(0, range);
    for (int i = 0; i < 60; ++i)
        feed(i, i);
    canvas_->draw();
    const QImage before = canvas_->grab().toImage();
    const QPixmap picture = canvas_->picture(QStringLiteral("R1"));
    QCOMPARE(picture.width(), 2 * canvas_->width());
    canvas_->draw();
    QCOMPARE(canvas_->grab().toImage(), before);
}

void tst_PlotCanvas::themeChangesTheGround() {
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        applyTheme(theme);
        canvas_->draw();
        QCOMPARE(canvas_->grab().toImage().pixel(5, 5), tokens(theme).surface.rgb());
    }
}

void tst_PlotCanvas::tenthLineIsDashed() {
    QCOMPARE(lineColor(9), lineColor(0));
    for (int i = 0; i < 9; ++i)
        model_->add(0, "SEN Sonar/X" + std::to_string(i) + "/range");
    model_->add(0, range);
    for (int i = 0; i < 60; ++i)
        feed(i, 1.0);
    canvas_->draw();
    const int dashed = pixelsLike(lineColor(0));
    model_->clear();
    model_->add(0, range);
    for (int i = 0; i < 60; ++i)
        feed(i, 1.0);
    canvas_->draw();
    QVERIFY(dashed > 0);
    QVERIFY(dashed < pixelsLike(lineColor(0)));
}

void tst_PlotCanvas::cursorFollowsTheMouse() {
    model_->add(0, range);
    for (int i = 0; i < 60; ++i)
        feed(i, 2.0);
    canvas_->draw();
    QVERIFY(!canvas_->mouseTime());
    QSignalSpy moved(canvas_.get(), &PlotCanvas::readoutChanged);
    const QImage before = canvas_->grab().toImage();
    moveMouse(surface(), surface()->rect().center());
    QCOMPARE(moved.count(), 1);
    QVERIFY(canvas_->mouseTime());
    QVERIFY(*canvas_->mouseTime() > canvas_->visibleFrom() && *canvas_->mouseTime() < canvas_->visibleTo());
    QVERIFY(canvas_->grab().toImage() != before);
    const Seconds at = *canvas_->mouseTime();
    for (int i = 60; i < 90; ++i)
        feed(i, 2.0);
    canvas_->draw(); // The picture moves on below the mouse.
    QVERIFY(*canvas_->mouseTime() > at);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(surface(), &leave);
    QVERIFY(!canvas_->mouseTime());
}

void tst_PlotCanvas::noTooltipLiesOverTheCurve() {
    QVERIFY(canvas_->toolTip().isEmpty());
    QVERIFY(surface()->toolTip().isEmpty());
    QVERIFY(canvas_->accessibleDescription().contains(QStringLiteral("Space to pause")));
}

USAR_TEST(tst_PlotCanvas)

} // namespace tst_plot_canvas

#include "tst_plot_canvas.moc"
