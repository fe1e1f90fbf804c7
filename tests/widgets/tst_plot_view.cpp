#include <vector>

#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
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
    void legendReadsTheCurveAtTheMouse();
    void pauseKeepsRecording();
    void hiddenPlotRecordsButDoesNotDraw();
    void clockThatBeginsAgainIsDrawnAnew();
    void notANumberDoesNotBreakTheAxes();
    void deleteKeyRemovesFromTheLegend();
    void legendShowsTheNewestValueInDegrees();
    void legendSaysEachNameOnce();
    void addedTwiceIsThereOnce();
    void csvAndPictureAreWritten();
    void unwritableFileIsAnErrorThatNamesIt();
    void linesAreReadableInBothThemes();

private:
    void feed(double time_s, double range_m);
    QWidget* surface() const { return view_->canvas()->focusProxy(); }
    QStringList seriesPaths() const {
        QStringList paths;
        for (const Series& series : view_->store().series())
            paths << QString::fromStdString(series.path);
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
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
}

void tst_PlotView::cleanup() {
    view_.reset();
    applyTheme(Theme::Dark);
}

void tst_PlotView::feed(double time_s, double range_m) {
    const QString text = QStringLiteral("SEN {Time %1} {Type Sonar} {Name F1 Range %2} {Name F2 Range 1}");
    view_->take(reader_.read(text.arg(time_s).arg(range_m).toStdString()), Seconds(time_s));
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
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 10);
    feed(10, 1);
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 11);
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
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 3);
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
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 2);
    view_->restart();
    QCOMPARE(seriesPaths(), QStringList{f1});
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 0);
    feed(5000.5, 2); // of another robot: not older than anything here
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 1);
}

void tst_PlotView::legendNamesTheRobot() {
    view_->addSeries(f1);
    auto* legend = view_->findChild<QTreeWidget*>();
    QVERIFY(legend->isHeaderHidden());
    view_->setSource(QStringLiteral("R2"));
    QVERIFY(!legend->isHeaderHidden());
    QCOMPARE(legend->headerItem()->text(0), QStringLiteral("R2"));
}

void tst_PlotView::legendReadsTheCurveAtTheMouse() {
    view_->addSeries(f1);
    for (int i = 0; i <= 60; ++i)
        feed(i, i < 30 ? 1.0 : 2.0);
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 61);
    const auto value = [&] { return view_->findChild<QTreeWidget*>()->topLevelItem(0)->text(1); };
    const auto readout = [&] {
        for (const QLabel* label : view_->findChildren<QLabel*>())
            if (label->accessibleName() == QStringLiteral("Time at the mouse"))
                return label->text();
        return QString();
    };
    QVERIFY2(value().startsWith(QStringLiteral("2.00")), qPrintable(value()));
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
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 1);
    QTest::keyClick(surface(), Qt::Key_Space);
    QVERIFY(view_->paused());
    for (int i = 1; i < 5; ++i)
        feed(i, 1);
    QCOMPARE(view_->store().series()[0].samples.size(), 5U);
    view_->addSeries(f2); // asks for a picture, which must not let the new samples in
    QTRY_COMPARE(view_->canvas()->sampleCount(f2.toStdString()), 0);
    QCOMPARE(view_->canvas()->sampleCount(f1.toStdString()), 1);
    QTest::keyClick(surface(), Qt::Key_Space);
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 5);
}

void tst_PlotView::hiddenPlotRecordsButDoesNotDraw() {
    view_->addSeries(f1);
    view_->hide();
    feed(0, 1);
    feed(1, 1);
    QCOMPARE(view_->store().series()[0].samples.size(), 2U);
    QCOMPARE(view_->canvas()->sampleCount(f1.toStdString()), 0);
    view_->show();
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 2);
}

void tst_PlotView::clockThatBeginsAgainIsDrawnAnew() {
    view_->addSeries(f1);
    for (int i = 0; i < 10; ++i)
        feed(5000 + i, 1);
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 10);
    feed(0.5, 1);
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 1);
    QCOMPARE(view_->canvas()->visibleFrom().count(), 0.5);
}

void tst_PlotView::notANumberDoesNotBreakTheAxes() {
    view_->addSeries(f1);
    feed(0, std::nan(""));
    feed(1, std::nan(""));
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 2);
    feed(2, 4.0);
    QTRY_COMPARE(view_->canvas()->sampleCount(f1.toStdString()), 3);
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
    view_->take(reader_.read("SEN {Time 1} {Type GroundTruth} {Name G} {Location 1,2,3} {Orientation 0,0,-0.5}"),
                Seconds(1));
    auto* legend = view_->findChild<QTreeWidget*>();
    QTRY_COMPARE(legend->topLevelItem(0)->text(1), QString::fromUtf8("28.65 °"));
}

void tst_PlotView::legendSaysEachNameOnce() {
    for (const char* path : {"SEN INS/INS/yaw", "SEN Sonar/F1/range", "STA/battery"})
        view_->addSeries(QString::fromLatin1(path));
    const auto* legend = view_->findChild<QTreeWidget*>();
    QCOMPARE(legend->topLevelItem(0)->text(0), QStringLiteral("INS yaw"));
    QCOMPARE(legend->topLevelItem(1)->text(0), QStringLiteral("Sonar F1 range"));
    QCOMPARE(legend->topLevelItem(2)->text(0), QStringLiteral("STA battery"));
}

void tst_PlotView::addedTwiceIsThereOnce() {
    view_->addSeries(f1);
    view_->addSeries(f1);
    QCOMPARE(seriesPaths().size(), 1);
}

void tst_PlotView::csvAndPictureAreWritten() {
    QTemporaryDir folder;
    view_->addSeries(f1);
    feed(1, 2.5);
    const QString csv = folder.filePath(QStringLiteral("plot.csv"));
    QVERIFY(view_->exportCsv(csv));
    QFile file(csv);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("time_s,SEN Sonar/F1/range [m]\n1,2.5\n"));
    const QString png = folder.filePath(QStringLiteral("plot.png"));
    QVERIFY(view_->exportPicture(png));
    QVERIFY(QImage(png).width() > 200);
}

void tst_PlotView::unwritableFileIsAnErrorThatNamesIt() {
    const QString file = QStringLiteral("/no/such/folder/plot.csv");
    const auto csv = view_->exportCsv(file);
    QVERIFY(!csv);
    QCOMPARE(csv.error().where, file.toStdString());
    QVERIFY(!csv.error().mend.empty());
    QVERIFY(!view_->exportPicture(QStringLiteral("/no/such/folder/plot.png")));
}

void tst_PlotView::linesAreReadableInBothThemes() {
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        applyTheme(theme);
        for (int i = 0; i < 9; ++i)
            QVERIFY2(contrast(PlotCanvas::lineColor(i), tokens().surface) >= 3.0, qPrintable(QString::number(i)));
        QCOMPARE(view_->grab().toImage().pixelColor(400, 60), tokens().surface);
    }
}

USAR_TEST(tst_PlotView)

} // namespace tst_plot_view

#include "tst_plot_view.moc"
