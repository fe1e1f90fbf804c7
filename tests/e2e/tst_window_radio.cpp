// Radio links of robots and base stations in the real window: the dock, the map, and what is said when one is lost.
#include <algorithm>
#include <vector>

#include <QLabel>
#include <QRegularExpression>
#include <QTest>

#include "tests/doubles/fake_robot_server.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/style/empty_state.h"

namespace tst_window_radio {

using namespace usar;

namespace {

/// Answers an observer with one strength for every pair, but for those of the robot that is far away.
class WirelessDouble {
public:
    WirelessDouble() {
        server_.listen();
        server_.on_line = [this](const QByteArray& line) {
            if (line.startsWith("INIT"))
                return server_.say("INITREPLY {Status OK}\r\n");
            QByteArray reply = line;
            const bool is_far = !far.isEmpty() && line.contains(" " + far + "}");
            server_.say(reply.replace("GETSS", "SS") + " {Strength " + (is_far ? "-99.5" : strength) + "}\r\n");
        };
    }
    quint16 port() const { return server_.port(); }
    QByteArray strength = "-60.5";
    QByteArray far; ///< name of a robot that nobody hears; empty: there is none

private:
    test::FakeServer server_;
};

widgets::RadioView& radio(WindowPage& page) {
    return *page.window().views().radio;
}

/// Each on a connection of its own, which has to open first.
bool stations(WindowPage& page, const std::vector<const char*>& names) {
    bool spawned = true;
    for (const char* const name : names)
        spawned =
            spawned && QTest::qWaitFor(
                           [&] {
                               return page.window().control().spawn({"USARBot.ComStation", name, Pose{}}).has_value();
                           },
                           soon_ms);
    return spawned;
}

/// The one pair that there is.
std::optional<double> onlyStrength(WindowPage& page) {
    const auto& model = radio(page).model();
    return model.rowCount() == 1 ? model.row(0).link.strength_dbm : std::nullopt;
}

} // namespace

class tst_WindowRadio : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void aRobotAndABaseStationHearEachOther();
    void aLostLinkIsSaidAndCured();
    void moreLostLinksAreTheSameNotice();
    void withoutAWirelessServerTheDockSaysSo();
};

void tst_WindowRadio::aRobotAndABaseStationHearEachOther() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.pressKey(Qt::Key_F7);
    QTRY_VERIFY(radio(page).isVisible());
    QVERIFY(radio(page).emptyState()->isVisible());
    QVERIFY(radio(page).emptyState()->accessibleDescription().contains("Spawn two robots"));
    QVERIFY(page.spawnAt("PlayerStart"));
    QTRY_VERIFY(radio(page).emptyState()->accessibleDescription().contains("one more robot"));
    page.press("Spawn a base station"); // the button in the empty dock
    QTRY_VERIFY_WITH_TIMEOUT(onlyStrength(page), soon_ms);
    QVERIFY(*onlyStrength(page) < -30.0 && *onlyStrength(page) > -120.0);
    QVERIFY(!radio(page).emptyState()->isVisible());
    QVERIFY(page.robot(2)->figures.spawned); // it says nothing, and nobody waits for it to
    QVERIFY(page.notified("Nothing from Base").isEmpty());
    QVERIFY(!page.window().commands().action("mission.start")->isEnabled()); // it flies no mission
    QCOMPARE(page.window().selectedRobot(), RobotId{2});
    const auto clockRuns = [&] { // it hears no time; the simulator has one
        const QRegularExpression time("^\\d\\d:\\d\\d:\\d\\d");
        for (const QLabel* label : page.window().views().time->findChildren<QLabel*>())
            if (time.match(label->text()).hasMatch())
                return !label->text().startsWith("00:00:00");
        return false;
    };
    QTRY_VERIFY_WITH_TIMEOUT(clockRuns(), soon_ms);

    const QImage without = page.map().grab().toImage();
    page.pressKey(Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(page.map().layer(widgets::MapLayer::Radio).visible);
    QTRY_COMPARE(page.map().content().radio_links.size(), std::size_t(1));
    QVERIFY(page.map().grab().toImage() != without);
    page.screenshot("radio");
    page.window().control().remove({2});
    QTRY_VERIFY_WITH_TIMEOUT(radio(page).emptyState()->isVisible(), soon_ms);
    QTRY_VERIFY(page.map().content().radio_links.empty());
}

void tst_WindowRadio::aLostLinkIsSaidAndCured() {
    test::FakeRobotServer server;
    QVERIFY(server.listen());
    WirelessDouble wireless;
    WindowPage page({.wireless_port = wireless.port()});
    page.connectToServer("127.0.0.1", server.port());
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(stations(page, {"Base", "Relay"}));
    QTRY_VERIFY_WITH_TIMEOUT(onlyStrength(page) == -60.5, soon_ms);
    QVERIFY(page.notified("radio link").isEmpty());
    wireless.strength = "-94.2";
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("Base and Relay have lost their radio link: −94.2 dBm").isEmpty(), soon_ms);
    const auto* const model = page.window().views().notifications->model();
    const auto open = [&] {
        int rows = 0;
        for (int i = 0; i < model->rowCount(); ++i)
            rows += model->row(i).text.contains("radio link") && !model->row(i).cured ? 1 : 0;
        return rows;
    };
    QCOMPARE(open(), 1);
    wireless.strength = "-70";
    QTRY_COMPARE_WITH_TIMEOUT(open(), 0, soon_ms);
}

/// Defect D19 of the review: nine robots made 36 toasts about pairs that nobody had asked for.
void tst_WindowRadio::moreLostLinksAreTheSameNotice() {
    std::vector<bool> toasts; // Of each report about radio links, whether it came as a toast.
    test::FakeRobotServer server;
    QVERIFY(server.listen());
    WirelessDouble wireless;
    WindowPage page({.wireless_port = wireless.port()});
    page.connectToServer("127.0.0.1", server.port());
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(stations(page, {"Base", "Relay", "Third"}));
    QTRY_COMPARE_WITH_TIMEOUT(radio(page).model().rowCount(), 3, soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(radio(page).model().row(2).link.strength_dbm == -60.5, soon_ms);
    const auto* const model = page.window().views().notifications->model();
    connect(model, &widgets::NotificationModel::pushed, this, [&](const widgets::Notification& pushed) {
        if (pushed.text.contains("radio link"))
            toasts.push_back(pushed.toast);
    });
    wireless.far = "Third";
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("2 pairs of robots have lost their radio link").isEmpty(), soon_ms);
    wireless.strength = "-99.5";
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("3 pairs of robots have lost their radio link").isEmpty(), soon_ms);
    QVERIFY(toasts.size() >= 2 && toasts.front());
    QVERIFY2(std::ranges::count(toasts, true) == 1, "only the first loss is worth a toast");
    const auto rows = [&] {
        std::vector<widgets::Notification> found;
        for (int row = 0; row < model->rowCount(); ++row)
            if (model->row(row).text.contains("radio link"))
                found.push_back(model->row(row));
        return found;
    };
    QCOMPARE(rows().size(), std::size_t(1));
    wireless.far.clear();
    wireless.strength = "-60.5";
    QTRY_VERIFY_WITH_TIMEOUT(rows().front().cured, soon_ms);
}

void tst_WindowRadio::withoutAWirelessServerTheDockSaysSo() {
    test::FakeRobotServer server;
    QVERIFY(server.listen());
    quint16 closed = 0;
    {
        test::FakeServer gone;
        gone.listen();
        closed = gone.port();
    }
    WindowPage page({.wireless_port = closed});
    page.connectToServer("127.0.0.1", server.port());
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(stations(page, {"Base", "Relay"}));
    QTRY_VERIFY_WITH_TIMEOUT(radio(page).emptyState()->accessibleDescription().contains("Start WSS there"), soon_ms);
}

USAR_TEST(tst_WindowRadio)

} // namespace tst_window_radio

#include "tst_window_radio.moc"
