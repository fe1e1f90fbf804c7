// Figures of the selected robot and of no other, the same wherever they are shown: after a mission, and of a robot
// that has done nothing yet.
#include <algorithm>
#include <cmath>
#include <limits>

#include <QCheckBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/scratch_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_figures {

using namespace usar;

namespace {

double lengthOf(const std::vector<Vec2>& points_m) {
    double length_m = 0.0;
    for (std::size_t i = 1; i < points_m.size(); ++i)
        if (const double step_m = (points_m[i] - points_m[i - 1]).norm(); std::isfinite(step_m))
            length_m += step_m;
    return length_m;
}

/// From the nearest place of the line; a point of NaN is a gap in it.
double distance_m(const std::vector<Vec2>& line_m, const Vec2& point_m) {
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < line_m.size(); ++i) {
        const Vec2& from_m = line_m[i];
        const Vec2 along_m =
            i + 1 < line_m.size() && line_m[i + 1].allFinite() ? Vec2(line_m[i + 1] - from_m) : Vec2(Vec2::Zero());
        const double square_m2 = along_m.squaredNorm();
        const double part = square_m2 > 0.0 ? std::clamp((point_m - from_m).dot(along_m) / square_m2, 0.0, 1.0) : 0.0;
        const double there_m = (point_m - from_m - part * along_m).norm();
        least_m = there_m < least_m ? there_m : least_m; // No comparison with NaN holds.
    }
    return least_m;
}

} // namespace

class tst_WindowFigures : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void theLegendHasTheRangeOfTheSavedMap_data();
    void theLegendHasTheRangeOfTheSavedMap();
    void theTrailOfAFastFlightCutsNoCorners();
    void aFinishedRobotShowsItsOwnLastFigures();
    void theBatteryIsTheSameInListAndInstruments();
    void heightsAreColoredAndGrayIsOneClickAway();
    void aLineOnTheMapTellsItsLengthAndHeights();

private:
    QString figure(const QString& caption) const;
    const widgets::Meter* battery() const;
    QString state() const { return page_->window().views().status->accessibleDescription(); }
    void select(int robot) {
        page_->pressKey(robot == 1 ? Qt::Key_1 : Qt::Key_2);
        QCOMPARE(page_->window().selectedRobot(), RobotId{robot});
    }

    std::unique_ptr<WindowPage> page_;
};

/// R1 has flown its mission, R2 stands where it was spawned.
void tst_WindowFigures::initTestCase() {
    page_ = std::make_unique<WindowPage>();
    QTRY_VERIFY_WITH_TIMEOUT(page_->hasStartPoses(), soon_ms);
    QVERIFY(page_->spawnAt("PlayerStart"));
    page_->typeArea({{-12, -9}, {12, 9}});
    page_->chooseSpeed("max");
    page_->press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page_->robot(1)->finished.has_value(), flight_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!filesIn(page_->resultFolder(), ".json").isEmpty(), soon_ms);
    QVERIFY(page_->spawnAt(page_->map().content().start_poses.back().name));
}

QString tst_WindowFigures::figure(const QString& caption) const {
    for (const widgets::Readout* readout : page_->window().views().status->findChildren<widgets::Readout*>())
        if (readout->accessibleName() == caption)
            return readout->text().trimmed();
    return QStringLiteral("(not there)");
}

const widgets::Meter* tst_WindowFigures::battery() const {
    for (const widgets::Meter* meter : page_->window().views().status->findChildren<widgets::Meter*>())
        if (meter->accessibleName() == QStringLiteral("Battery"))
            return meter;
    return nullptr;
}

/// Defect D23 of the review: the picture and its JSON had another range than the map in the window.
void tst_WindowFigures::theLegendHasTheRangeOfTheSavedMap_data() {
    QTest::addColumn<bool>("only_selected");
    QTest::newRow("heights of all robots") << false;
    QTest::newRow("heights of the selected robot") << true;
}

void tst_WindowFigures::theLegendHasTheRangeOfTheSavedMap() {
    QFETCH(bool, only_selected);
    select(1);
    QAction* const scope = page_->window().commands().action("map.selected_heights");
    if (scope->isChecked() != only_selected)
        scope->trigger();
    QCOMPARE(scope->isChecked(), only_selected);
    QFile file(QDir(page_->resultFolder()).filePath(filesIn(page_->resultFolder(), ".json").first()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject map = QJsonDocument::fromJson(file.readAll()).object()["map"].toObject();
    const mapping::HeightRange shown = page_->map().heights().range();
    QVERIFY2(map.contains("minimum_m") && map.contains("maximum_m"), qPrintable(map.keys().join(' ')));
    QVERIFY2(std::abs(shown.minimum_m - map["minimum_m"].toDouble()) < 0.01,
             qPrintable(QString::number(shown.minimum_m)));
    QVERIFY2(std::abs(shown.maximum_m - map["maximum_m"].toDouble()) < 0.01,
             qPrintable(QString::number(shown.maximum_m)));
    if (only_selected)
        scope->trigger(); // As the other tests expect it.
}

/// Defect D24: each frame of a fast simulation has many poses, and all belong to the trail.
void tst_WindowFigures::theTrailOfAFastFlightCutsNoCorners() {
    const std::vector<Vec2>& shown = page_->map().content().robots.at("R1").trail.points_m();
    const std::vector<Vec2>& flown = page_->robot(1)->trail_m;
    QVERIFY(flown.size() > 50);
    for (const Vec2& point_m : flown)
        QVERIFY2(distance_m(shown, point_m) < 0.25, qPrintable(QStringLiteral("%1 m beside x %2, y %3")
                                                                   .arg(distance_m(shown, point_m))
                                                                   .arg(point_m.x())
                                                                   .arg(point_m.y())));
    QVERIFY2(lengthOf(shown) < 1.1 * lengthOf(flown), "a trail that goes to and fro would pass all points, too");
}

/// Defect D1: R1's own end is shown with it, and nothing of it with R2.
void tst_WindowFigures::aFinishedRobotShowsItsOwnLastFigures() {
    select(2);
    for (const char* caption : {"elapsed", "flown", "range left", "charges"})
        QCOMPARE(figure(caption), QStringLiteral("–"));
    QCOMPARE(state(), QStringLiteral("Idle"));
    select(1);
    const agent::BehaviorStatus& last = *page_->robot(1)->status;
    QCOMPARE(figure("flown"), QString::number(last.distance_flown_m, 'f', 0));
    QCOMPARE(figure("charges"), QString::number(last.charges));
    QVERIFY2(figure("elapsed").contains(':'), qPrintable(figure("elapsed")));
    QCOMPARE(state(), QString::fromStdString(page_->robot(1)->finished->reason));
    select(2);
    QCOMPARE(figure("flown"), QStringLiteral("–"));
}

/// Defect D28: one said how much was used, the other how much is left, and a robot that had not flown said nothing.
void tst_WindowFigures::theBatteryIsTheSameInListAndInstruments() {
    for (const int robot : {1, 2}) {
        select(robot);
        const widgets::RobotListModel& rows = page_->window().views().robots->model();
        const auto in_list_pct = [&] { return rows.row(*rows.indexOf({robot})).battery_pct; };
        QTRY_VERIFY_WITH_TIMEOUT(in_list_pct() && battery()->value(), soon_ms);
        QCOMPARE(*battery()->value(), *in_list_pct());
        QVERIFY(*battery()->value() <= 100.0 && (robot == 1 ? *battery()->value() < 99.0 : true));
    }
}

/// Defect D10: the scan was gray on a gray relief, and nothing in the window could change that.
void tst_WindowFigures::heightsAreColoredAndGrayIsOneClickAway() {
    select(1);
    const auto colored_pct = [this] { // It counts places whose height is known.
        const QImage map = page_->map().grab().toImage();
        int known = 0;
        int colored = 0;
        for (double x_m = -11.0; x_m < 11.0; x_m += 0.5)
            for (double y_m = -8.0; y_m < 8.0; y_m += 0.5)
                if (const QPoint at = page_->map().transform().toScreen(Vec2(x_m, y_m)).toPoint();
                    page_->map().heights().probe(Vec2(x_m, y_m)) && map.rect().contains(at)) {
                    ++known;
                    colored += map.pixelColor(at).saturation() > 60 ? 1 : 0;
                }
        return known > 100 ? 100 * colored / known : -1;
    };
    page_->map().setFocus();
    page_->pressKey(Qt::Key_F);
    QTRY_VERIFY(!page_->map().heights().busy());
    // The middle of cividis is nearly gray.
    QTRY_VERIFY2(colored_pct() > 40, qPrintable(QString::number(colored_pct())));
    const int before = colored_pct();
    page_->window().commands().action("view.dock.layers")->trigger();
    QCheckBox* gray = nullptr;
    for (QCheckBox* box : page_->window().views().layers->findChildren<QCheckBox*>())
        if (box->accessibleName() == QStringLiteral("Gray heights"))
            gray = box;
    QVERIFY(gray && gray->isVisible());
    QTest::mouseClick(gray, Qt::LeftButton, {}, QPoint(8, gray->height() / 2));
    QVERIFY(gray->isChecked());
    QTRY_VERIFY2(colored_pct() < before - 20, qPrintable(QString::number(colored_pct()))); // Lanes and path are.
    QTest::mouseClick(gray, Qt::LeftButton, {}, QPoint(8, gray->height() / 2));
    QTRY_VERIFY2(colored_pct() > before - 5, qPrintable(QString::number(colored_pct())));
}

void tst_WindowFigures::aLineOnTheMapTellsItsLengthAndHeights() {
    page_->pressKey(Qt::Key_F);
    page_->pressKey(Qt::Key_M);
    QVERIFY(page_->window().commands().action("map.measure")->isChecked());
    const widgets::MapTransform& transform = page_->map().transform();
    const QPoint from = transform.toScreen(Vec2(-10.0, 0.0)).toPoint();
    const QPoint to = transform.toScreen(Vec2(10.0, 0.0)).toPoint();
    const QImage before = page_->map().grab().toImage();
    QTest::mousePress(&page_->map(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&page_->map(), (from + to) / 2);
    QTest::mouseMove(&page_->map(), to);
    QTest::mouseRelease(&page_->map(), Qt::LeftButton, {}, to);
    const QString said = page_->map().accessibleDescription();
    const double length_m = said.section(' ', 1, 1).toDouble();
    QVERIFY2(std::abs(length_m - 20.0) < 0.5 && said.contains("heights") && !said.contains("unknown"),
             qPrintable(said));
    QVERIFY(page_->map().grab().toImage() != before);
    page_->screenshot("measured");
    page_->pressKey(Qt::Key_Escape);
    QVERIFY(!page_->window().commands().action("map.measure")->isChecked());
    QVERIFY(!page_->map().content().measured);
}

USAR_TEST(tst_WindowFigures)

} // namespace tst_window_figures

#include "tst_window_figures.moc"
