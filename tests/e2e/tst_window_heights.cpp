// Two robots scan, and the map shows one height map of both; then both are replayed.
#include <algorithm>
#include <optional>

#include <QDir>
#include <QLineF>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_heights {

using namespace usar;

namespace {

const Rectangle west{{-22, -6}, {-6, 6}};
const Rectangle east{{6, -6}, {22, 6}};
constexpr double cell_m = 0.25;

using Heights = std::map<std::pair<int, int>, float>;

/// Known heights by cell, of an area that covers both missions.
template <class Probe>
Heights heightsBy(const Probe& probe) {
    Heights heights;
    for (int column = -160; column < 160; ++column)
        for (int row = -80; row < 80; ++row)
            if (const auto found = probe(Vec2(column + 0.5, row + 0.5) * cell_m))
                heights[{column, row}] = found->height_m;
    return heights;
}

Heights heightsOf(const mission::RobotView& view) {
    return heightsBy([&](const Vec2& at_m) { return mapping::probeHeight(view.tiles, cell_m, at_m); });
}

Heights shownIn(WindowPage& page) {
    return heightsBy([&](const Vec2& at_m) { return page.map().heights().probe(at_m); });
}

/// True if the map knows what one of both knows, and says the same wherever only one of them does.
bool isOneMap(const Heights& shown, const Heights& one, const Heights& other) {
    std::size_t known = one.size();
    for (const auto& [cell, height_m] : other)
        known += !one.contains(cell);
    if (shown.size() != known)
        return false;
    for (const auto& [cell, height_m] : shown) {
        const bool both = one.contains(cell) && other.contains(cell);
        if (!both && height_m != (one.contains(cell) ? one : other).at(cell))
            return false;
    }
    return true;
}

void begin(WindowPage& page, const std::string& start_pose, const Rectangle& area) {
    QVERIFY(page.spawnAt(start_pose));
    page.typeArea(area);
    page.press("Start");
}

/// A pixel of the map over a cell that robot 1 has scanned, away from robots and start poses.
std::optional<QPoint> openCell(WindowPage& page) {
    constexpr double clear_px = 40.0;
    const widgets::MapTransform& transform = page.map().transform();
    std::vector<QPointF> taken{transform.toScreen(Vec2(page.robot(1)->base_in_map->position_m.head<2>()))};
    for (const auto& pose : page.map().content().start_poses)
        taken.push_back(transform.toScreen(Vec2(pose.pose_in_map.position_m.head<2>())));
    for (const auto& [cell, height_m] : heightsOf(*page.robot(1))) {
        const QPoint at = transform.toScreen(Vec2(Vec2(cell.first + 0.5, cell.second + 0.5) * cell_m)).toPoint();
        const bool is_open =
            std::ranges::all_of(taken, [&](const QPointF& other) { return QLineF(other, at).length() > clear_px; });
        const auto probe = mapping::probeHeight(page.robot(1)->tiles, cell_m, transform.toMap(at));
        if (is_open && page.map().rect().contains(at) && !page.map().childAt(at) && probe)
            return at;
    }
    return std::nullopt;
}

} // namespace

class tst_WindowHeights : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void twoRobotsMakeOneMap();
    void twoReplaysMakeOneMap();
    void aCellLeadsToTheLineThatWroteIt();

private:
    QTemporaryDir folder_;
    Heights first_, second_; ///< what each robot scanned
};

void tst_WindowHeights::twoRobotsMakeOneMap() {
    WindowPage page({.result_folder = folder_.path()});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    begin(page, "PlayerStart", west);
    begin(page, page.map().content().start_poses.back().name, east);
    page.chooseSpeed("max");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished && page.robot(2)->finished, flight_ms);
    first_ = heightsOf(*page.robot(1));
    second_ = heightsOf(*page.robot(2));
    QVERIFY(!first_.empty() && !second_.empty() && first_ != second_);
    QTRY_VERIFY_WITH_TIMEOUT(isOneMap(shownIn(page), first_, second_), soon_ms);
    const auto& content = page.map().content();
    QVERIFY(content.marks.contains("R1") && content.marks.contains("R2"));
    QCOMPARE(content.robots.at("R1").area_in_map, west);
    page.screenshot("two_robots_one_map");

    page.pressKey(Qt::Key_H, Qt::ShiftModifier);
    QVERIFY(page.window().commands().action("map.selected_heights")->isChecked());
    QCOMPARE(page.window().selectedRobot(), RobotId{2});
    QTRY_VERIFY_WITH_TIMEOUT(shownIn(page) == second_, soon_ms);
    page.pressKey(Qt::Key_1);
    QTRY_VERIFY_WITH_TIMEOUT(shownIn(page) == first_, soon_ms);
    page.pressKey(Qt::Key_H, Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(isOneMap(shownIn(page), first_, second_), soon_ms);
    page.window().control().remove({1});
    QTRY_VERIFY_WITH_TIMEOUT(shownIn(page) == second_, soon_ms);
    page.window().control().remove({2});
    QTRY_VERIFY_WITH_TIMEOUT(shownIn(page).empty(), soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!page.window().control().anythingToSave(), soon_ms);
}

void tst_WindowHeights::twoReplaysMakeOneMap() {
    WindowPage page;
    const QStringList files = QDir(folder_.path()).entryList({"*.usarrec"}, QDir::Files, QDir::Name);
    QCOMPARE(files.size(), 2);
    for (int i = 0; i < 2; ++i) {
        page.window().control().openRecording(folder_.filePath(files.at(i)));
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(i + 1) && page.robot(i + 1)->figures.replay, soon_ms);
        const Seconds end = page.robot(i + 1)->figures.replay->span;
        page.window().control().robot({i + 1})->orderReplay({.seek = end});
    }
    QTRY_VERIFY_WITH_TIMEOUT(isOneMap(shownIn(page), first_, second_), flight_ms);
    page.window().control().robot({1})->orderReplay({.seek = Seconds(0.0)});
    QTRY_VERIFY_WITH_TIMEOUT(shownIn(page) == second_, soon_ms);
}

void tst_WindowHeights::aCellLeadsToTheLineThatWroteIt() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    begin(page, "PlayerStart", west);
    QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() >= 1, flight_ms);
    page.window().control().stopAll();
    QTRY_VERIFY_WITH_TIMEOUT(!page.window().control().robot({1})->running(), soon_ms);
    auto& views = page.window().views();
    page.window().commands().action("map.fit")->trigger();
    const std::optional<QPoint> at = openCell(page);
    QVERIFY2(at, "a scanned cell that nothing covers");
    const Vec2 at_m = page.map().transform().toMap(*at);
    const auto probe = mapping::probeHeight(page.robot(1)->tiles, cell_m, at_m);
    QVERIFY(probe && probe->line.value > 0);
    QTRY_VERIFY_WITH_TIMEOUT(views.messages->timeOf(page.robot(1)->connection, probe->line), soon_ms);
    views.messages_dock->hide();
    QTest::mouseClick(&page.map(), Qt::LeftButton, Qt::ControlModifier, *at);
    QTRY_VERIFY_WITH_TIMEOUT(views.messages_dock->isVisible(), soon_ms);
    const auto& list = *views.messages;
    QVERIFY(list.view()->currentIndex().isValid());
    const widgets::MessageRow& row = list.model().row(list.view()->currentIndex().row());
    QCOMPARE(row.number, mapping::probeHeight(page.robot(1)->tiles, cell_m, at_m)->line.value);
    QVERIFY2(row.type.starts_with("SEN"), row.type.c_str());

    views.messages->clear();
    QTest::mouseClick(&page.map(), Qt::LeftButton, Qt::ControlModifier, *at);
    QVERIFY(!page.notified("the messages do not keep it any longer").isEmpty());
}

USAR_TEST(tst_WindowHeights)

} // namespace tst_window_heights

#include "tst_window_heights.moc"
