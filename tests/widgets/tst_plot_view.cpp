#include <functional>
#include <vector>

#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QWheelEvent>

#include "core/protocol/reader.h"
#include "tests/suite/suite.h"
#include "widgets/panels/plot_canvas.h"
#include "widgets/panels/plot_view.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_plot_view {

using namespace usar;
using namespace usar::widgets;

namespace {

const QString f1 = QStringLiteral("SEN Sonar/F1/range");
const QString f2 = QStringLiteral("SEN Sonar/F2/range");

SeriesKey key(const QString& path) {
    return {"R1", path.toStdString()};
}

void wheel(QWidget* target, QPoint at, int delta) {
    QWheelEvent event(at, target->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(target, &event);
}

/// As the window system tells of a mouse that is moved there without a button.
void moveMouse(QWidget* target, QPointF at) {
    QMouseEvent event(QEvent::MouseMove, at, target->mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(target, &event);
}

} // namespace

class tst_PlotView : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void emptyPlotSaysHowToFillIt();
    void dropAddsFields();
    void otherDropsAreRefused();
    void samplesReachTheCanvas();
    void followsTheNewest();
    void windowChoosesHowMuchIsSeen();
    void allShowsEverything();
    void wheelZoomsTimeAndStopsFollowing();
    void doubleClickFollowsAgain();
    void keysPanZoomPauseAndFollow();
    void ownKeysComeBeforeTheWindowsShortcuts();
    void keysWorkInTheLegendToo();
    void restartKeepsTheSeries();
    void legendNamesTheRobot();
    void anotherRobotHasItsPast();
    void keysMeasure();
    void statisticsAreShownOnRequest();
    void aDropGoesToTheCanvasBelowTheMouse();
    void aLayoutIsRestored();
    void editsAreToldAndTakenBack();
    void whatAPersonDidNotDoIsNoEdit();
    void aReplayIsSentToTheCursor();
    void legendReadsTheCurveAtTheMouse();
    void pauseKeepsRecording();
    void hiddenPlotRecordsButDoesNotDraw();
    void clockThatBeginsAgainIsDrawnAnew();
    void notANumberDoesNotBreakTheAxes();
    void deleteKeyRemovesFromTheLegend();
    void legendShowsTheNewestValueInDegrees();
    void legendSaysEachNameOnce();
    void addedTwiceIsThereOnce();
    void tablePageAndPictureAreWritten();
    void unwritableFileIsAnErrorThatNamesIt_data();
    void unwritableFileIsAnErrorThatNamesIt();
    void linesAreReadableInBothThemes();

private:
    void feed(double time_s, double range_m);
    QWidget* surface() const { return view_->canvas()->focusProxy(); }
    PlotLegend* legend() const { return view_->findChild<PlotLegend*>(); }
    /// Clicks the button whose name begins with these words.
    void press(const QString& words) const {
        for (QToolButton* button : view_->findChildren<QToolButton*>())
            if (button->accessibleName().startsWith(words))
                return button->click();
        QFAIL(qPrintable(words));
    }
    QStringList seriesPaths() const {
        QStringList paths;
        for (const Series& series : view_->store().series())
            paths << QString::fromStdString(series.key.path);
        return paths;
    }

    std::unique_ptr<PlotView> view_;
    protocol::Reader reader_;
};

void tst_PlotView::initTestCase() {
    applyTheme(Theme::Dark);
}

void tst_PlotView::init() {
    view_ = std::make_unique<PlotView>();
    view_->resize(800, 300);
    view_->setRobot(QStringLiteral("R1"));
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
}

void tst_PlotView::cleanup() {
    view_.reset();
    applyTheme(Theme::Dark);
}

void tst_PlotView::feed(double time_s, double range_m) {
    const QString text = QStringLiteral("SEN {Time %1} {Type Sonar} {Name F1 Range %2} {Name F2 Range 1}");
    view_->take(QStringLiteral("R1"), reader_.read(text.arg(time_s).arg(range_m).toStdString()), Seconds(time_s));
}

void tst_PlotView::emptyPlotSaysHowToFillIt() {
    QVERIFY(view_->findChild<EmptyState*>()->isVisible());
    QVERIFY(view_->findChild<EmptyState*>()->accessibleDescription().contains(QStringLiteral("Drag")));
    view_->addSeries(f1);
    QVERIFY(!view_->findChild<EmptyState*>()->isVisible());
    view_->clear();
    QVERIFY(view_->findChild<EmptyState*>()->isVisible());
}

void tst_PlotView::dropAddsFields() {
    QMimeData mime;
    mime.setData(QLatin1String(field_mime_type), (f1 + u'\n' + f2).toUtf8());
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view_.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({100, 100}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view_.get(), &drop);
    QCOMPARE(seriesPaths(), (QStringList{f1, f2}));
}

void tst_PlotView::otherDropsAreRefused() {
    QMimeData mime;
    mime.setText(f1);
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QCoreApplication::sendEvent(view_.get(), &enter);
    QVERIFY(!enter.isAccepted());
}

void tst_PlotView::samplesReachTheCanvas() {
    view_->addSeries(f1);
    for (int i = 0; i < 10; ++i)
        feed(i, i);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 10);
    feed(10, 1);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 11);
}

void tst_PlotView::followsTheNewest() {
    view_->addSeries(f1);
    feed(1000, 1);
    QTRY_COMPARE(view_->canvas()->visibleFrom().count(), 1000.0);
    QCOMPARE(view_->canvas()->visibleTo().count(), 1060.0);
    for (int i = 1; i <= 200; ++i)
        feed(1000 + i, 1);
    QTRY_COMPARE(view_->canvas()->visibleTo().count(), 1200.0);
    QCOMPARE(view_->canvas()->visibleFrom().count(), 1140.0);
}

void tst_PlotView::windowChoosesHowMuchIsSeen() {
    view_->addSeries(f1);
    feed(0, 1);
    feed(500, 1);
    QTRY_COMPARE(view_->canvas()->visibleTo().count(), 500.0);
    view_->findChild<QComboBox*>()->setCurrentIndex(0);
    QCOMPARE(view_->canvas()->visibleFrom().count(), 490.0);
    QCOMPARE(view_->canvas()->visibleTo().count(), 500.0);
}

void tst_PlotView::allShowsEverything() {
    view_->addSeries(f1);
    feed(3, 1);
    feed(500, 1);
    QTRY_COMPARE(view_->canvas()->visibleTo().count(), 500.0);
    auto* window = view_->findChild<QComboBox*>();
    window->setCurrentIndex(window->count() - 1);
    QCOMPARE(view_->canvas()->visibleFrom().count(), 3.0);
    QCOMPARE(view_->canvas()->visibleTo().count(), 500.0);
}

void tst_PlotView::wheelZoomsTimeAndStopsFollowing() {
    view_->addSeries(f1);
    feed(0, 1);
    feed(100, 1);
    QTRY_COMPARE(view_->canvas()->visibleTo().count(), 100.0);
    wheel(surface(), surface()->rect().center(), 120);
    QVERIFY(!view_->canvas()->following());
    const double from = view_->canvas()->visibleFrom().count();
    const double to = view_->canvas()->visibleTo().count();
    QVERIFY(to - from < 59.0);
    feed(200, 1);
    QTRY_VERIFY(view_->model().newest_s() == 200.0);
    QCOMPARE(view_->canvas()->visibleFrom().count(), from);
    QCOMPARE(view_->canvas()->visibleTo().count(), to);
}

void tst_PlotView::doubleClickFollowsAgain() {
    view_->addSeries(f1);
    feed(0, 1);
    feed(100, 1);
    QTRY_COMPARE(view_->canvas()->visibleTo().count(), 100.0);
    view_->canvas()->panTime(-0.5);
    QVERIFY(!view_->canvas()->following());
    QTest::mouseDClick(surface(), Qt::LeftButton, {}, surface()->rect().center());
    QVERIFY(view_->canvas()->following());
    QCOMPARE(view_->canvas()->visibleTo().count(), 100.0);
}

void tst_PlotView::keysPanZoomPauseAndFollow() {
    view_->addSeries(f1);
    feed(0, 1);
    feed(100, 1);
    QTRY_COMPARE(view_->canvas()->visibleTo().count(), 100.0);
    QTest::keyClick(surface(), Qt::Key_Left);
    QCOMPARE(view_->canvas()->visibleTo().count(), 94.0);
    QTest::keyClick(surface(), Qt::Key_Right);
    QCOMPARE(view_->canvas()->visibleTo().count(), 100.0);
    QTest::keyClick(surface(), Qt::Key_Plus);
    QCOMPARE((view_->canvas()->visibleTo() - view_->canvas()->visibleFrom()).count(), 48.0);
    QVERIFY(!view_->canvas()->following());
    QTest::keyClick(surface(), Qt::Key_F);
    QVERIFY(view_->canvas()->following());
    QTest::keyClick(surface(), Qt::Key_Space);
    QVERIFY(view_->paused());
}

void tst_PlotView::ownKeysComeBeforeTheWindowsShortcuts() {
    QAction fit;
    fit.setShortcut(QKeySequence(Qt::Key_F));
    view_->addAction(&fit); // its context is the whole window
    QSignalSpy fitted(&fit, &QAction::triggered);
    QTest::keyClick(surface(), Qt::Key_F);
    QVERIFY(!view_->canvas()->following());
    surface()->setFocus();
    QTest::keyClick(surface(), Qt::Key_F);
    QVERIFY(view_->canvas()->following());
    QCOMPARE(fitted.count(), 0);
}

void tst_PlotView::keysWorkInTheLegendToo() {
    view_->addSeries(f1);
    QTest::keyClick(surface(), Qt::Key_F);
    QVERIFY(!view_->canvas()->following());
    QTest::keyClick(view_->findChild<QTreeWidget*>(), Qt::Key_F);
    QVERIFY(view_->canvas()->following());
}

void tst_PlotView::restartKeepsTheSeries() {
    view_->addSeries(f1);
    feed(5000, 1);
    feed(5001, 1);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 2);
    view_->restart(QStringLiteral("R1"));
    QCOMPARE(seriesPaths(), QStringList{f1});
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 0);
    feed(5000.5, 2); // of another robot: not older than anything here
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 1);
}

void tst_PlotView::legendNamesTheRobot() {
    view_->addSeries(f1);
    const auto label = [&] { return legend()->item(0)->text(PlotLegend::Name); };
    QCOMPARE(label(), QStringLiteral("R1 · Sonar F1 range"));
    view_->setRobot(QStringLiteral("R2"));
    QCOMPARE(label(), QStringLiteral("R2 · Sonar F1 range"));
    press(QStringLiteral("Follow the selected robot"));
    QCOMPARE(label(), QStringLiteral("R1 · Sonar F1 range"));
    view_->setRobot(QStringLiteral("R3"));
    QCOMPARE(label(), QStringLiteral("R1 · Sonar F1 range"));
}

void tst_PlotView::anotherRobotHasItsPast() {
    view_->addSeries(f1);
    feed(1, 1.0);
    view_->take(QStringLiteral("R2"), reader_.read("SEN {Time 1} {Type Sonar} {Name F1 Range 7}"), Seconds(1));
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 1);
    view_->setRobot(QStringLiteral("R2"));
    QTRY_COMPARE(view_->canvas()->pointCount({"R2", f1.toStdString()}), 1);
    QVERIFY(legend()->item(0)->text(PlotLegend::Now).startsWith(QStringLiteral("7.00")));
}

void tst_PlotView::keysMeasure() {
    view_->addSeries(f1);
    for (int i = 0; i <= 60; ++i)
        feed(i, i);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 61);
    QVERIFY(legend()->isColumnHidden(PlotLegend::AtA));
    QTest::keyClick(surface(), Qt::Key_A);
    QVERIFY(!legend()->isColumnHidden(PlotLegend::AtA));
    QVERIFY(legend()->isColumnHidden(PlotLegend::Difference));
    QTest::keyClick(surface(), Qt::Key_B);
    const double at_s = *view_->model().cursors().b_s;
    for (int i = 0; i < 5; ++i)
        QTest::keyClick(surface(), Qt::Key_Right, Qt::ShiftModifier);
    QTest::keyClick(surface(), Qt::Key_Left);
    const PlotCursors cursors = view_->model().cursors();
    QCOMPARE(*cursors.a_s, at_s);
    QVERIFY(*cursors.b_s > at_s + 2.0);
    QVERIFY(view_->canvas()->following()); // the keys moved the cursor and not the picture
    const double a = std::floor(*cursors.a_s);
    const double b = std::floor(*cursors.b_s);
    QCOMPARE(legend()->item(0)->text(PlotLegend::AtA), QStringLiteral("%1 m").arg(a, 0, 'f', 2));
    QCOMPARE(legend()->item(0)->text(PlotLegend::AtB), QStringLiteral("%1 m").arg(b, 0, 'f', 2));
    QCOMPARE(legend()->item(0)->text(PlotLegend::Difference), QStringLiteral("+%1 m").arg(b - a, 0, 'f', 2));
    QVERIFY(legend()->item(0)->text(PlotLegend::Slope).endsWith(QStringLiteral("m/s")));
    QVERIFY(legend()->headerItem()->text(PlotLegend::AtA).startsWith(QStringLiteral("A 00:00:")));
    QTest::keyClick(surface(), Qt::Key_Delete);
    QVERIFY(legend()->isColumnHidden(PlotLegend::AtB));
    QTest::keyClick(surface(), Qt::Key_Delete);
    QVERIFY(legend()->isColumnHidden(PlotLegend::AtA));
    QTest::keyClick(surface(), Qt::Key_Left);
    QVERIFY(!view_->canvas()->following()); // without a cursor the keys pan again
}

void tst_PlotView::statisticsAreShownOnRequest() {
    view_->addSeries(f1);
    for (int i = 1; i <= 4; ++i)
        feed(i, i);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 4);
    QVERIFY(legend()->isColumnHidden(PlotLegend::Count));
    press(QStringLiteral("Statistics"));
    QVERIFY(!legend()->isColumnHidden(PlotLegend::Count));
    const QStringList expected{QStringLiteral("4"), QStringLiteral("1.00 m"), QStringLiteral("4.00 m"),
                               QStringLiteral("2.50 m"), QStringLiteral("1.29 m")};
    for (int i = 0; i < expected.size(); ++i)
        QCOMPARE(legend()->item(0)->text(PlotLegend::Count + i), expected[i]);
}

void tst_PlotView::aDropGoesToTheCanvasBelowTheMouse() {
    view_->addSeries(f1);
    view_->addCanvas();
    QTRY_COMPARE(view_->canvas()->canvasAt({100, view_->canvas()->height() - 60}), 1U);
    view_->canvas()->choose(0);
    QMimeData mime;
    mime.setData(QLatin1String(field_mime_type), f2.toUtf8());
    const QPoint at = view_->canvas()->mapTo(view_.get(), QPoint(100, view_->canvas()->height() - 60));
    QDragEnterEvent enter(at, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view_.get(), &enter);
    QDropEvent drop(at, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view_.get(), &drop);
    QCOMPARE(view_->canvas()->chosen(), 1U);
    QCOMPARE(view_->model().shown().back().canvas, 1U);
    QCOMPARE(view_->model().layout().canvases[1].size(), 1U);
    QCOMPARE(legend()->topLevelItemCount(), 2); // a group for each canvas
    view_->removeCanvas();                      // the one that was dropped on is chosen
    QCOMPARE(seriesPaths(), QStringList{f1});
}

void tst_PlotView::aLayoutIsRestored() {
    view_->addSeries(f1);
    view_->addCanvas();
    view_->addSeries(f2);
    press(QStringLiteral("Statistics"));
    const QJsonObject layout = view_->plotLayout();
    PlotView other;
    QVERIFY(other.setPlotLayout(layout));
    QCOMPARE(other.plotLayout(), layout);
    QCOMPARE(other.model().shown().size(), 2U);
    QVERIFY(!other.setPlotLayout({{QStringLiteral("canvases"), 5}}));
    QCOMPARE(other.plotLayout(), layout);
}

void tst_PlotView::editsAreToldAndTakenBack() {
    QSignalSpy edited(view_.get(), &PlotView::edited);
    const auto removeFirst = [this] {
        legend()->topLevelItem(0)->child(0)->setSelected(true);
        QTest::keyClick(legend(), Qt::Key_Delete);
    };
    const std::pair<QString, std::function<void()>> edits[] = {
        {"plot " + f1, [this] { view_->addSeries(f1); }},
        {"add plot", [this] { press(QStringLiteral("Add a plot")); }},
        {"plot " + f2, [this] { view_->addSeries(f2); }},
        {"remove " + f1 + " from plots", removeFirst},
        {"remove plot", [this] { press(QStringLiteral("Remove the chosen plot")); }},
        {"plot " + f2, [this] { view_->addSeries(f2); }},
        {"remove all lines from plots", [this] { press(QStringLiteral("Remove all lines")); }}};
    for (const auto& [text, run] : edits) {
        const QJsonArray before = view_->plotLayout()["canvases"].toArray();
        run();
        const QJsonArray after = view_->plotLayout()["canvases"].toArray();
        QVERIFY(after != before);
        QCOMPARE(edited.count(), 1);
        const QList<QVariant> told = edited.takeFirst();
        QCOMPARE(told[0].toString(), text);
        QCOMPARE(told[1].toJsonArray(), before);
        QCOMPARE(told[2].toJsonArray(), after);
        press(QStringLiteral("Statistics")); // An option that taking back must not change.
        const bool statistics = view_->model().layout().statistics;
        view_->setCanvases(before);
        QCOMPARE(view_->plotLayout()["canvases"].toArray(), before);
        QCOMPARE(view_->model().layout().statistics, statistics);
        view_->setCanvases(after);
        QCOMPARE(view_->plotLayout()["canvases"].toArray(), after);
    }
    QCOMPARE(edited.count(), 0);
}

void tst_PlotView::whatAPersonDidNotDoIsNoEdit() {
    view_->addSeries(f1);
    QSignalSpy edited(view_.get(), &PlotView::edited);
    view_->addSeries(f1);  // It is there.
    view_->removeCanvas(); // It is the only one.
    view_->setRobot(QStringLiteral("R2"));
    feed(0, 1);
    const QJsonObject layout = view_->plotLayout();
    QVERIFY(view_->setPlotLayout({}));
    QVERIFY(view_->setPlotLayout(layout));
    QCOMPARE(edited.count(), 0);
}

void tst_PlotView::aReplayIsSentToTheCursor() {
    QSignalSpy wanted(view_.get(), &PlotView::momentRequested);
    view_->addSeries(f1);
    feed(0, 1);
    QTest::keyClick(surface(), Qt::Key_A);
    QTest::keyClick(surface(), Qt::Key_Return);
    QCOMPARE(wanted.count(), 0);
    view_->setMoment(Seconds(3.0));
    QTest::keyClick(surface(), Qt::Key_Return);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].value<Seconds>().count(), *view_->model().cursors().a_s);
}

void tst_PlotView::legendReadsTheCurveAtTheMouse() {
    view_->addSeries(f1);
    for (int i = 0; i <= 60; ++i)
        feed(i, i < 30 ? 1.0 : 2.0);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 61);
    const auto value = [&] { return view_->findChild<QTreeWidget*>()->topLevelItem(0)->text(PlotLegend::Now); };
    const auto readout = [&] {
        for (const QLabel* label : view_->findChildren<QLabel*>())
            if (label->accessibleName() == QStringLiteral("Time at the mouse"))
                return label->text();
        return QString();
    };
    QTRY_VERIFY2(value().startsWith(QStringLiteral("2.00")), qPrintable(value()));
    QVERIFY2(readout().contains(QStringLiteral("Wheel")), qPrintable(readout()));
    moveMouse(surface(), QPointF(surface()->width() / 4.0, surface()->height() / 2.0));
    QVERIFY2(value().startsWith(QStringLiteral("1.00")), qPrintable(value()));
    QVERIFY2(readout().startsWith(QStringLiteral("at 00:00:")), qPrintable(readout()));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(surface(), &leave);
    QVERIFY2(value().startsWith(QStringLiteral("2.00")), qPrintable(value()));
}

void tst_PlotView::pauseKeepsRecording() {
    view_->addSeries(f1);
    feed(0, 1);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 1);
    QTest::keyClick(surface(), Qt::Key_Space);
    QVERIFY(view_->paused());
    for (int i = 1; i < 5; ++i)
        feed(i, 1);
    QCOMPARE(view_->store().series()[0].samples.size(), std::uint64_t(5));
    view_->addSeries(f2); // asks for a picture, which must not let the new samples in
    QTRY_COMPARE(view_->canvas()->pointCount(key(f2)), 0);
    QCOMPARE(view_->canvas()->pointCount(key(f1)), 1);
    QTest::keyClick(surface(), Qt::Key_Space);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 5);
}

void tst_PlotView::hiddenPlotRecordsButDoesNotDraw() {
    view_->addSeries(f1);
    view_->hide();
    feed(0, 1);
    feed(1, 1);
    QCOMPARE(view_->store().series()[0].samples.size(), std::uint64_t(2));
    QCOMPARE(view_->canvas()->pointCount(key(f1)), 0);
    view_->show();
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 2);
}

void tst_PlotView::clockThatBeginsAgainIsDrawnAnew() {
    view_->addSeries(f1);
    for (int i = 0; i < 10; ++i)
        feed(5000 + i, 1);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 10);
    feed(0.5, 1);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 1);
    QCOMPARE(view_->canvas()->visibleFrom().count(), 0.5);
}

void tst_PlotView::notANumberDoesNotBreakTheAxes() {
    view_->addSeries(f1);
    feed(0, std::nan(""));
    feed(1, std::nan(""));
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 2);
    feed(2, 4.0);
    QTRY_COMPARE(view_->canvas()->pointCount(key(f1)), 3);
    QVERIFY(!view_->grab().isNull());
}

void tst_PlotView::deleteKeyRemovesFromTheLegend() {
    view_->addSeries(f1);
    view_->addSeries(f2);
    auto* legend = view_->findChild<QTreeWidget*>();
    view_->activateWindow();
    legend->setFocus();
    legend->setCurrentItem(legend->topLevelItem(0));
    QTRY_VERIFY(legend->hasFocus());
    QTest::keyClick(legend, Qt::Key_Delete);
    QCOMPARE(seriesPaths(), QStringList{f2});
    QCOMPARE(legend->topLevelItemCount(), 1);
}

void tst_PlotView::legendShowsTheNewestValueInDegrees() {
    view_->addSeries(QStringLiteral("SEN GroundTruth/G/yaw"));
    view_->take(QStringLiteral("R1"),
                reader_.read("SEN {Time 1} {Type GroundTruth} {Name G} {Location 1,2,3} {Orientation 0,0,-0.5}"),
                Seconds(1));
    auto* legend = view_->findChild<QTreeWidget*>();
    QTRY_COMPARE(legend->topLevelItem(0)->text(PlotLegend::Now), QString::fromUtf8("28.65 °"));
}

void tst_PlotView::legendSaysEachNameOnce() {
    for (const char* path : {"SEN INS/INS/yaw", "SEN Sonar/F1/range", "STA/battery"})
        view_->addSeries(QString::fromLatin1(path));
    const auto* legend = view_->findChild<QTreeWidget*>();
    QCOMPARE(legend->topLevelItem(0)->text(0), QStringLiteral("R1 · INS yaw"));
    QCOMPARE(legend->topLevelItem(1)->text(0), QStringLiteral("R1 · Sonar F1 range"));
    QCOMPARE(legend->topLevelItem(2)->text(0), QStringLiteral("R1 · STA battery"));
}

void tst_PlotView::addedTwiceIsThereOnce() {
    view_->addSeries(f1);
    view_->addSeries(f1);
    QCOMPARE(seriesPaths().size(), 1);
}

void tst_PlotView::tablePageAndPictureAreWritten() {
    QTemporaryDir folder;
    view_->addSeries(f1);
    feed(1, 2.5);
    QSignalSpy saved(view_.get(), &PlotView::saved);
    const auto bytesOf = [&](const QString& name) {
        const QString path = folder.filePath(name);
        view_->save(path);
        if (!QTest::qWaitFor([&] { return saved.count() > 0; }, 60'000))
            return QByteArray();
        saved.clear();
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    QCOMPARE(bytesOf(QStringLiteral("plot.csv")), QByteArray("time_s,R1 SEN Sonar/F1/range [m]\n1,2.5\n"));
    QVERIFY(QImage::fromData(bytesOf(QStringLiteral("plot.png"))).width() > 200);
    QVERIFY(bytesOf(QStringLiteral("plot.pdf")).startsWith("%PDF-"));
}

void tst_PlotView::unwritableFileIsAnErrorThatNamesIt_data() {
    QTest::addColumn<QString>("file");
    for (const char* file : {"/no/such/folder/plot.csv", "/no/such/folder/plot.png", "/no/such/folder/plot.pdf"})
        QTest::newRow(file) << QString::fromLatin1(file);
    QTest::newRow("a name without a kind") << QStringLiteral("/tmp/plot");
}

void tst_PlotView::unwritableFileIsAnErrorThatNamesIt() {
    QFETCH(QString, file);
    QSignalSpy failed(view_.get(), &PlotView::failed);
    view_->addSeries(f1);
    view_->save(file);
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, 60'000);
    QVERIFY2(failed[0][0].toString().contains(file), qPrintable(failed[0][0].toString()));
}

void tst_PlotView::linesAreReadableInBothThemes() {
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        applyTheme(theme);
        for (int i = 0; i < 9; ++i)
            QVERIFY2(contrast(plotLineColor(i, theme), tokens().surface) >= 3.0, qPrintable(QString::number(i)));
        QCOMPARE(view_->grab().toImage().pixelColor(400, 60), tokens().surface);
    }
}

USAR_TEST(tst_PlotView)

} // namespace tst_plot_view

#include "tst_plot_view.moc"
