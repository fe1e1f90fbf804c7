// What the map shows of the heights of two recordings that are replayed beside each other.
#include <chrono>
#include <string>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/agent/published_text.h"
#include "core/link/recording_format.h"
#include "core/mission/fleet/shown_heights.h"
#include "tests/doubles/plain_recording.h"
#include "tests/suite/suite.h"

namespace tst_shown_heights {

using namespace usar;
using namespace usar::mission;
using link::RecordKind;
using mapping::HeightScope;
using namespace std::chrono_literals;

namespace {

/// A scanner that looks down from this place and measures 5 m, at the second 1 of the recording.
std::string oneScan(const Vec3& scanner_m) {
    std::string file;
    doubles::appendOldHead(file);
    doubles::appendPlain(file, {.kind = RecordKind::Start, .bytes = "robot: R1\n"});
    doubles::appendPlain(file, {.kind = RecordKind::Opened, .bytes = "h:1"});
    doubles::appendPlain(file, {.kind = RecordKind::In,
                                .time = 1s,
                                .bytes = "SEN {Time 1.0} {Type RangeScanner} {Name S} {Resolution 0.01} "
                                         "{FOV 0.02} {Range 5.0,5.0,5.0}\r\n"});
    Pose down;
    down.position_m = scanner_m;
    down.pitch_rad = pi / 2;
    std::string placed;
    agent::appendText(placed, agent::ScanPlacement{{1}, down});
    const auto note = [&](link::RecordTime time, const std::string& name, const std::string& bytes) {
        doubles::appendPlain(file, {.kind = RecordKind::Note, .time = time, .line = {1}, .name = name, .bytes = bytes});
    };
    note(2s, "published", placed);
    note(4s, "fault", "wind");
    return file;
}

/// The heights as a layer of the map would collect them.
struct Shown {
    explicit Shown(const Fleet& fleet) : heights(fleet) {
        QObject::connect(&heights, &ShownHeights::begun, &heights, [this](double size_m) {
            cell_size_m = size_m;
            tiles.clear();
        });
        QObject::connect(&heights, &ShownHeights::grown, &heights, [this](const auto& grown, const auto&) {
            for (const auto& tile : grown)
                tiles[tile->index] = tile;
        });
    }
    std::optional<float> at(double x_m, double y_m) const {
        const auto probe = mapping::probeHeight(tiles, cell_size_m, {x_m, y_m});
        return probe ? std::optional(std::round(probe->height_m * 100.0f) / 100.0f) : std::nullopt;
    }

    ShownHeights heights;
    double cell_size_m = 0.25;
    mapping::HeightTiles tiles;
};

} // namespace

class tst_ShownHeights : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void allRobotsAreOneMap();
    void theSelectedRobotHasItsOwn();
    void selectingAnotherRobotLeavesTheFusedMapAlone();
    void aReplayThatGoesBackTakesItsHeightsBack();
    void aRemovedRobotTakesItsHeightsAlong();
    void liveRobotsAreNotMixedWithReplays();
    void tellsWhoKnowsAPlace();
    void tellsWhichLinesWroteAPlace();

private:
    /// Opens a recording with one scan from there, and waits until it was replayed.
    void replay(const Vec3& scanner_m);

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<Fleet> fleet_;
    std::unique_ptr<Shown> shown_;
};

/// At the origin robot 1 measures 2 m, and robot 2 measures 4 m.
void tst_ShownHeights::init() {
    folder_ = std::make_unique<QTemporaryDir>();
    fleet_ = std::make_unique<Fleet>(QString());
    shown_ = std::make_unique<Shown>(*fleet_);
    replay({0.1, 0.1, 7.0});
    replay({0.1, 0.1, 9.0});
    shown_->heights.select({1});
}

void tst_ShownHeights::cleanup() {
    shown_.reset();
    fleet_.reset();
    folder_.reset();
}

void tst_ShownHeights::replay(const Vec3& scanner_m) {
    QFile file(folder_->filePath(QString("R%1.usarrec").arg(fleet_->robots().size())));
    const std::string bytes = oneScan(scanner_m);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    file.close();
    const std::size_t before = fleet_->robots().size();
    fleet_->openRecording(file.fileName());
    QTRY_COMPARE(fleet_->robots().size(), before + 1);
    Robot* const robot = fleet_->robots().back();
    robot->orderReplay({.seek = Seconds(3.0)});
    QTRY_VERIFY(!robot->view().tiles.empty());
}

void tst_ShownHeights::allRobotsAreOneMap() {
    QTRY_COMPARE(shown_->at(0.1, 0.1), std::optional(3.0f));
    QCOMPARE(mapping::probeHeight(shown_->tiles, 0.25, {0.1, 0.1})->hits, 6); // three beams each
}

void tst_ShownHeights::theSelectedRobotHasItsOwn() {
    shown_->heights.setScope(HeightScope::SelectedRobot);
    QCOMPARE(shown_->at(0.1, 0.1), std::optional(2.0f));
    shown_->heights.select({2});
    QCOMPARE(shown_->at(0.1, 0.1), std::optional(4.0f));
    shown_->heights.select({});
    QVERIFY(shown_->tiles.empty());
    shown_->heights.select({2});
    shown_->heights.setScope(HeightScope::AllRobots);
    QTRY_COMPARE(shown_->at(0.1, 0.1), std::optional(3.0f));
}

void tst_ShownHeights::selectingAnotherRobotLeavesTheFusedMapAlone() {
    QTRY_COMPARE(shown_->at(0.1, 0.1), std::optional(3.0f));
    int begun = 0;
    connect(&shown_->heights, &ShownHeights::begun, this, [&] { ++begun; });
    shown_->heights.select({2});
    QCOMPARE(begun, 0);
    shown_->heights.select({2}); // Asks to show all again.
    QCOMPARE(begun, 1);
    QCOMPARE(shown_->at(0.1, 0.1), std::optional(3.0f));
}

void tst_ShownHeights::aReplayThatGoesBackTakesItsHeightsBack() {
    QTRY_COMPARE(shown_->at(0.1, 0.1), std::optional(3.0f));
    fleet_->robot({2})->orderReplay({.seek = Seconds(0.5)});
    QTRY_COMPARE(shown_->at(0.1, 0.1), std::optional(2.0f));
    shown_->heights.setScope(HeightScope::SelectedRobot);
    fleet_->robot({1})->orderReplay({.seek = Seconds(0.5)});
    QTRY_VERIFY(shown_->tiles.empty());
}

void tst_ShownHeights::aRemovedRobotTakesItsHeightsAlong() {
    QTRY_COMPARE(shown_->at(0.1, 0.1), std::optional(3.0f));
    fleet_->remove({1});
    shown_->heights.select({2});
    QTRY_COMPARE(shown_->at(0.1, 0.1), std::optional(4.0f));
    fleet_->remove({2});
    QTRY_VERIFY(shown_->tiles.empty());
}

void tst_ShownHeights::liveRobotsAreNotMixedWithReplays() {
    QTRY_COMPARE(shown_->at(0.1, 0.1), std::optional(3.0f));
    shown_->heights.select({}); // As if a live robot were selected: no replay is.
    QVERIFY(shown_->tiles.empty());
    QVERIFY(shown_->heights.knowing({0.1, 0.1}).empty());
}

void tst_ShownHeights::tellsWhoKnowsAPlace() {
    QCOMPARE(shown_->heights.knowing({0.1, 0.1}), (QStringList{"R1 replay", "R1 replay 2"}));
    QVERIFY(shown_->heights.knowing({5.0, 0.1}).empty());
    shown_->heights.setScope(HeightScope::SelectedRobot);
    QCOMPARE(shown_->heights.knowing({0.1, 0.1}), (QStringList{"R1 replay"}));
}

void tst_ShownHeights::tellsWhichLinesWroteAPlace() {
    QTRY_COMPARE(shown_->at(0.1, 0.1), std::optional(3.0f));
    QCOMPARE(mapping::probeHeight(shown_->tiles, 0.25, {0.1, 0.1})->line, LineNumber{}); // The fused map cannot tell.
    shown_->heights.select({2});
    const auto sources = shown_->heights.sourcesAt({0.1, 0.1});
    QCOMPARE(sources.size(), std::size_t(2));
    QCOMPARE(sources[0].first, RobotId{2}); // The selected one comes first.
    QCOMPARE(sources[1].first, RobotId{1});
    QCOMPARE(sources[0].second.line, LineNumber{1});
    QVERIFY(sources[0].second.height_m > sources[1].second.height_m);
    QCOMPARE(shown_->heights.knowing({0.1, 0.1}), (QStringList{"R1 replay", "R1 replay 2"}));
    shown_->heights.setScope(HeightScope::SelectedRobot);
    QCOMPARE(shown_->heights.sourcesAt({0.1, 0.1}).size(), std::size_t(1));
    QVERIFY(shown_->heights.sourcesAt({5.0, 0.1}).empty());
}

USAR_TEST(tst_ShownHeights)

} // namespace tst_shown_heights

#include "tst_shown_heights.moc"
