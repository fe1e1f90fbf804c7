// A server that falls silent, or goes and comes back: every view shows what was heard before as out of date.
#include <QTest>

#include "core/server/embedded/headless_simulator.h"
#include "tests/doubles/meddling_relay.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/panels/instrument_panel.h"

namespace tst_window_silence {

using namespace usar;

class tst_WindowSilence : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void everyViewIsFreshWhileTheRobotSpeaks();
    void everyViewSaysThatTheRobotIsSilent();
    void everyViewIsFreshAgainWhenItSpeaks();
    void nothingComesBackToLifeWithTheConnection();
    void theBatteryOfARobotThatDoesNothingIsOutOfDateToo();

private:
    /// Names of the views that show the robot as heard just now.
    QStringList fresh();
    QStringList all() const {
        return {"row", "marker", "status", "attitude", "laser", "terrain", "ring", "sonars", "sensors"};
    }

    std::unique_ptr<server::HeadlessSimulator> simulator_;
    std::unique_ptr<test::MeddlingRelay> relay_;
    std::unique_ptr<WindowPage> page_;
};

void tst_WindowSilence::initTestCase() {
    auto started = server::HeadlessSimulator::start("tall_test", {.speed_x = 5.0});
    QVERIFY2(started, started ? "" : started.error().text().c_str());
    simulator_ = *std::move(started);
    relay_ = std::make_unique<test::MeddlingRelay>(simulator_->port());
    page_ = std::make_unique<WindowPage>();
    page_->connectToServer("127.0.0.1", relay_->port());
    QTRY_VERIFY_WITH_TIMEOUT(page_->hasStartPoses(), soon_ms);
    QVERIFY(page_->spawnAt("PlayerStart"));
    page_->typeArea({{-20, -15}, {20, 15}});
    page_->press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page_->knownTiles() >= 1, flight_ms);
}

QStringList tst_WindowSilence::fresh() {
    const widgets::WindowViews& views = page_->window().views();
    QStringList found;
    const auto note = [&](const char* view, bool stale) {
        if (!stale)
            found << view;
    };
    note("row", views.robots->model().row(0).stale);
    note("marker", page_->map().content().robots.at("R1").robot.stale);
    note("status", views.status->stale());
    const std::pair<const char*, const widgets::Instrument*> instruments[] = {
        {"attitude", views.instruments->attitude()},
        {"laser", views.laser},
        {"terrain", views.terrain},
        {"ring", views.instruments->ring()},
        {"sonars", views.sonars}};
    for (const auto& [name, view] : instruments)
        note(name, view->stale());
    const QAbstractItemModel& sensors = views.sensors->model();
    const auto ins = sensors.match(sensors.index(0, 0), Qt::DisplayRole, "INS");
    if (ins.isEmpty())
        return found << "no INS";
    const QModelIndex value = sensors.index(0, 0, ins.front());
    note("sensors", value.data(Qt::AccessibleDescriptionRole).toString() == "out of date");
    return found;
}

void tst_WindowSilence::everyViewIsFreshWhileTheRobotSpeaks() {
    QTRY_COMPARE_WITH_TIMEOUT(fresh(), all(), soon_ms);
}

/// Defect D2 of the review: the connection stands, but nothing comes.
void tst_WindowSilence::everyViewSaysThatTheRobotIsSilent() {
    relay_->meddle = [](const QByteArray&) { return QByteArray(); };
    QTRY_COMPARE_WITH_TIMEOUT(fresh(), QStringList(), soon_ms);
    QVERIFY(page_->connectionText().contains("Connected"));
    QCOMPARE(page_->window().views().robots->model().row(0).state, QStringLiteral("silent"));
    page_->screenshot("silent");
}

void tst_WindowSilence::everyViewIsFreshAgainWhenItSpeaks() {
    relay_->meddle = {};
    QTRY_COMPARE_WITH_TIMEOUT(fresh(), all(), soon_ms);
}

/// Defect D3 of the review: the robot has gone with its connection, whatever the next one says.
void tst_WindowSilence::nothingComesBackToLifeWithTheConnection() {
    const std::uint64_t before = page_->robot(1)->figures.traffic.lines_in;
    relay_->die();
    QTRY_COMPARE_WITH_TIMEOUT(fresh(), QStringList(), soon_ms);
    relay_->revive();
    QTRY_VERIFY_WITH_TIMEOUT(page_->robot(1)->link.state == link::LinkState::Connected, soon_ms);
    QVERIFY(!page_->robot(1)->figures.spawned);
    // The count of lines starts at 0 on each connection, so the views were told of the new one by then.
    const auto greeted = [&] {
        const std::uint64_t lines = page_->robot(1)->figures.traffic.lines_in;
        return lines > 0 && lines < before;
    };
    QVERIFY(test::holdsUntil([&] { return fresh().isEmpty(); }, greeted, soon_ms));
    QCOMPARE(fresh(), QStringList());
}

void tst_WindowSilence::theBatteryOfARobotThatDoesNothingIsOutOfDateToo() {
    test::MeddlingRelay relay(simulator_->port());
    WindowPage page;
    page.connectToServer("127.0.0.1", relay.port());
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    mission::SpawnRequest request{"USARBot.AirRobot", "Idler", page.map().content().start_poses.back().pose_in_map};
    QVERIFY(page.window().control().spawn(request));
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.battery_left_pct, soon_ms);
    const widgets::StatusStrip* const status = page.window().views().status;
    QTRY_VERIFY_WITH_TIMEOUT(!status->stale(), soon_ms);
    relay.meddle = [](const QByteArray&) { return QByteArray(); };
    QTRY_VERIFY_WITH_TIMEOUT(status->stale(), soon_ms);
}

USAR_TEST(tst_WindowSilence)

} // namespace tst_window_silence

#include "tst_window_silence.moc"
