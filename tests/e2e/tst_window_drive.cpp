// Driving by hand in the real window, against the real simulator over TCP: hold and it moves, let go and it stops.
#include <atomic>

#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QTest>
#include <QTimer>

#include "core/server/embedded/headless_simulator.h"
#include "tests/doubles/fake_robot_server.h"
#include "tests/doubles/meddling_relay.h"
#include "tests/doubles/own_thread.h"
#include "tests/e2e/drive_page.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/suite/suite.h"
#include "widgets/drive/drive_pad.h"
#include "widgets/style/empty_state.h"

namespace tst_window_drive {

using namespace usar;

class tst_WindowDrive : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void aHeldKeyDrivesAndLettingItGoStops();
    void thePadDrivesAsFarAsItIsDragged();
    void everyOtherEndOfAHoldStops_data();
    void everyOtherEndOfAHoldStops();
    void aBehaviorThatStartsTakesOver();
    void takingControlPausesABehavior();
    void aCutLinkEndsTheControl();
    void aClosingWindowStopsTheRobotFirst();
    void keysThatDriveAreOrdinaryKeysOtherwise();
    void typedTextDrivesNothing();
    void theSpeedLimitLimits();
    void itSaysWhatCannotBeDriven();
    void aFlyerTakesOffByKeys();
};

void tst_WindowDrive::aHeldKeyDrivesAndLettingItGoStops() {
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.openDock();
    QVERIFY(page.spawnClass("P2DX"));
    QCOMPARE(page.control(), QString("R1: idle"));
    QVERIFY(page.comesToRest());
    QVERIFY(page.takeControl());
    QCOMPARE(page.control(), QString("R1: you drive"));
    QVERIFY(page.driveBy(Qt::Key_W, 0.5));
    QCOMPARE(page.control(), QString("R1: you drive · keys"));
    QVERIFY2(page.panel().echo().startsWith("DRIVE {Left "), qPrintable(page.panel().echo()));
    QCOMPARE(page.lastCause(), QString("by hand: keys"));
    page.release(Qt::Key_W);
    QTRY_VERIFY(page.standsStill());
    QCOMPARE(page.lastCause(), QString("by hand: stop, the keys were let go"));
    QVERIFY(page.comesToRest()); // it brakes
    const Vec3 stood_m = page.position_m();
    QVERIFY(page.holdsWhileClockGoesOn([&] { return (page.position_m() - stood_m).norm() < 0.05; }, Seconds(0.8)));
    const QList<QLabel*> labels = page.panel().findChildren<QLabel*>();
    QVERIFY(std::ranges::any_of(labels,
                                [](const QLabel* label) { return label->text().contains("the keys were let go"); }));
    page.screenshot("drive");
    page.pressKey(Qt::Key_G); // Asks; the key again is the answer.
    QCOMPARE(page.control(), QString("R1: you drive"));
    page.pressKey(Qt::Key_G);
    QTRY_COMPARE(page.control(), QString("R1: idle"));
}

void tst_WindowDrive::thePadDrivesAsFarAsItIsDragged() {
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.openDock();
    QVERIFY(page.spawnClass("P2DX"));
    auto* const pad = page.panel().findChild<widgets::DrivePad*>();
    QVERIFY(!pad->isEnabled());
    page.press("Drive by hand");
    QTRY_VERIFY_WITH_TIMEOUT(pad->isEnabled(), soon_ms);
    const QPoint middle = pad->rect().center();
    QTest::mousePress(pad, Qt::LeftButton, {}, middle);
    QTest::mouseMove(pad, middle - QPoint(0, 30));
    QTRY_VERIFY(page.state().held == mission::HandSource::Pad && page.state().sent.forward > 0.2);
    QVERIFY(page.state().sent.forward < 0.7 && page.state().sent.turn == 0.0);
    QTest::mouseMove(pad, middle - QPoint(200, 0)); // beyond its edge: wholly to the left
    QTRY_VERIFY(page.state().sent.turn > 0.95);
    QTest::mouseRelease(pad, Qt::LeftButton, {}, middle - QPoint(200, 0));
    QTRY_VERIFY(page.standsStill());
    QCOMPARE(pad->value(), QPointF());
    pad->setFocus();
    QTest::keyPress(pad, Qt::Key_Up);
    QTRY_VERIFY(page.state().sent.forward > 0.9);
    QTest::keyRelease(pad, Qt::Key_Up);
    QTRY_VERIFY(page.standsStill());
}

void tst_WindowDrive::everyOtherEndOfAHoldStops_data() {
    QTest::addColumn<QString>("end");
    QTest::addColumn<QString>("words");
    QTest::newRow("the window loses the focus") << "focus"
                                                << "the window lost the focus";
    QTest::newRow("Space") << "space"
                           << "Space was pressed";
    QTest::newRow("text is typed") << "text"
                                   << "the window lost the focus";
    QTest::newRow("another robot is selected") << "select"
                                               << "control was given back";
    QTest::newRow("the stop button of the dock") << "stop"
                                                 << "stop";
    QTest::newRow("stop all") << "stop all"
                              << "stop";
    QTest::newRow("control is given back") << "give back"
                                           << "control was given back";
}

void tst_WindowDrive::everyOtherEndOfAHoldStops() {
    QFETCH(QString, end);
    QFETCH(QString, words);
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.openDock();
    if (end == "select") {
        QVERIFY(page.spawnAt("HillTop"));
        QVERIFY(page.spawnClass("P2DX", "PlayerStart", 2));
    } else {
        QVERIFY(page.spawnClass("P2DX"));
    }
    const int id = page.window().selectedRobot().value;
    QVERIFY(page.takeControl());
    page.hold(Qt::Key_W);
    QTRY_VERIFY(page.state(id).held && !page.standsStill(id));
    QWidget other;
    if (end == "focus") {
        other.show();
        other.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&other));
    } else if (end == "space") {
        page.pressKey(Qt::Key_Space);
    } else if (end == "text") {
        page.pressKey(Qt::Key_F4);
    } else if (end == "select") {
        page.pressKey(Qt::Key_1);
    } else if (end == "stop") {
        page.press("STOP R1");
    } else if (end == "stop all") {
        page.press("STOP ALL");
    } else {
        page.pressKey(Qt::Key_G);
        page.pressKey(Qt::Key_G);
    }
    QTRY_VERIFY2(page.standsStill(id), qPrintable(page.lastDrive(id)));
    QTRY_VERIFY2(page.lastCause(id).contains(words), qPrintable(page.lastCause(id)));
    QVERIFY(page.clockGoesOn(Seconds(0.2), id)); // a stop may be said twice
    const qsizetype said = page.driveCount(id);
    // The key is still down.
    QVERIFY(page.holdsWhileClockGoesOn([&] { return page.driveCount(id) == said; }, Seconds(0.6), id));
    QVERIFY(!page.state(id).held);
}

void tst_WindowDrive::aBehaviorThatStartsTakesOver() {
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.typeArea({{-20, -15}, {20, 15}});
    page.map().setFocus();
    QVERIFY(page.takeControl());
    page.hold(Qt::Key_R);
    QTRY_VERIFY(page.state().held.has_value());
    page.pressKey(Qt::Key_Return, Qt::ControlModifier);
    QTRY_COMPARE(page.control(), QString("R1: Terrain survey (C++) drives"));
    QVERIFY(!page.window().drive().taken());
    QTRY_VERIFY_WITH_TIMEOUT(page.lastCause().startsWith("airrobot/"), flight_ms);
    page.release(Qt::Key_R);
}

void tst_WindowDrive::takingControlPausesABehavior() {
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.typeArea({{-20, -15}, {20, 15}});
    page.map().setFocus();
    page.pressKey(Qt::Key_Return, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(page.lastCause().startsWith("airrobot/") && page.position_m().z() > 1.0, flight_ms);
    QVERIFY(page.takeControl());
    QTRY_VERIFY(page.robot(1)->paused);
    QTRY_VERIFY(!page.notified("is paused").isEmpty());
    QTRY_VERIFY2(!page.lastCause().startsWith("airrobot/"), qPrintable(page.lastCause()));
    const qsizetype said = page.driveCount();
    // No word of the behavior's comes through.
    QVERIFY(page.holdsWhileClockGoesOn([&] { return page.driveCount() == said; }, Seconds(1.0)));
    page.hold(Qt::Key_W);
    QTRY_COMPARE(page.lastCause(), QString("by hand: keys"));
    page.release(Qt::Key_W);
    page.pressKey(Qt::Key_P); // goes on
    QTRY_COMPARE(page.control(), QString("R1: Terrain survey (C++) drives"));
    QTRY_VERIFY_WITH_TIMEOUT(page.lastCause().startsWith("airrobot/"), flight_ms);
    QVERIFY(!page.robot(1)->paused);
}

void tst_WindowDrive::aCutLinkEndsTheControl() {
    auto simulator = server::HeadlessSimulator::start("tall_test", {.speed_x = 1.0});
    QVERIFY(simulator);
    test::MeddlingRelay relay((*simulator)->port());
    DrivePage page;
    page.connectToServer("127.0.0.1", relay.port());
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.openDock();
    QVERIFY(page.spawnAt("PlayerStart"));
    page.map().setFocus();
    QVERIFY(page.takeControl());
    page.hold(Qt::Key_R);
    QTRY_VERIFY(page.state().held.has_value());
    relay.die();
    QTRY_VERIFY_WITH_TIMEOUT(!page.window().drive().taken(), soon_ms);
    QTRY_COMPARE(page.control(), QString("R1: idle"));
    const auto* const empty = page.panel().findChild<widgets::EmptyState*>();
    QTRY_VERIFY2(empty->isVisible() && empty->accessibleName().contains("No link to R1"),
                 qPrintable(empty->accessibleName()));
    page.release(Qt::Key_R);
}

void tst_WindowDrive::aClosingWindowStopsTheRobotFirst() {
    test::FakeRobotServer server;
    QVERIFY(server.listen());
    {
        DrivePage page;
        page.connectToServer("127.0.0.1", server.port());
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        server.on_command = [&](const QByteArray& line) {
            if (line.startsWith("INIT"))
                server.keepClient();
        };
        page.doubleClickStartPose(page.map().content().start_poses.front().name);
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned, soon_ms);
        page.map().setFocus();
        QVERIFY(page.takeControl());
        page.hold(Qt::Key_W);
        QTRY_VERIFY(!server.heardOf("DRIVE").isEmpty() &&
                    server.heardOf("DRIVE").last().contains(QByteArray("{LinearVelocity")));
        page.window().quit();
    }
    const QRegularExpression moves("[1-9]");
    QTRY_VERIFY(!QString(server.heardOf("DRIVE").last()).contains(moves));
}

/// A draws the mission area, F fits the map; the arrow keys pan it all the time.
void tst_WindowDrive::keysThatDriveAreOrdinaryKeysOtherwise() {
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnClass("P2DX"));
    page.map().setFocus();
    const auto drawing = [&] { return page.window().commands().action("mission.area")->isChecked(); };
    page.pressKey(Qt::Key_A);
    QVERIFY(drawing());
    page.pressKey(Qt::Key_A);
    QVERIFY(!drawing());
    QVERIFY(page.takeControl());
    page.hold(Qt::Key_A);
    QTRY_VERIFY(page.state().asked.turn == 1.0);
    page.release(Qt::Key_A);
    QVERIFY(!drawing());
    const Vec2 middle_m = page.map().transform().toMap(page.map().rect().center());
    page.pressKey(Qt::Key_Right);
    QVERIFY(page.map().transform().toMap(page.map().rect().center()).x() > middle_m.x());
    page.pressKey(Qt::Key_G);
    page.pressKey(Qt::Key_G);
    QTRY_VERIFY(!page.panel().state().taken);
    page.pressKey(Qt::Key_A);
    QVERIFY(drawing());
}

void tst_WindowDrive::typedTextDrivesNothing() {
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnClass("P2DX"));
    page.map().setFocus();
    QVERIFY(page.takeControl());
    page.pressKey(Qt::Key_F4); // the command line
    auto* const line = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    QVERIFY(line);
    const qsizetype said = page.driveCount();
    QTest::keyClicks(line, "was");
    QCOMPARE(line->text(), QString("was"));
    QVERIFY(page.holdsWhileClockGoesOn([&] { return page.driveCount() == said; }, Seconds(0.4)));
}

void tst_WindowDrive::theSpeedLimitLimits() {
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.openDock();
    QVERIFY(page.spawnClass("P2DX"));
    page.map().setFocus();
    QVERIFY(page.takeControl());
    const auto spin = [&] {
        const auto found = QRegularExpression("\\{Left (-?[0-9.]+)").match(page.lastDrive());
        return found.captured(1).toDouble();
    };
    page.window().drive().setSpeedShare(0.2);
    page.hold(Qt::Key_W);
    QTRY_VERIFY(page.state().sent.forward == 1.0 && spin() > 3.2 && spin() < 3.4); // of 16.5 rad/s
    page.pressKey(Qt::Key_BracketRight);
    QTRY_VERIFY2(spin() > 4.8 && spin() < 5.1, qPrintable(page.lastDrive() + ": " + page.lastCause()));
    page.release(Qt::Key_W);
    QTRY_VERIFY(page.standsStill());
}

void tst_WindowDrive::itSaysWhatCannotBeDriven() {
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.openDock();
    const auto* const empty = page.panel().findChild<widgets::EmptyState*>();
    QVERIFY(empty->isVisible() && empty->accessibleName() == "No robot yet");
    QVERIFY(!page.window().commands().action("drive.take")->isEnabled());
    QCOMPARE(page.control(), QString("No robot"));
    page.screenshot("drive-empty");
    QTRY_VERIFY(page.window().commands().action("radio.station")->isEnabled());
    page.pressKey(Qt::Key_B, Qt::ControlModifier);
    QTRY_VERIFY(page.robot(1));
    QTRY_VERIFY2_WITH_TIMEOUT(empty->accessibleName().contains("does not move"), qPrintable(empty->accessibleName()),
                              soon_ms);
    QVERIFY(!page.window().commands().action("drive.take")->isEnabled());
}

void tst_WindowDrive::aFlyerTakesOffByKeys() {
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.openDock();
    QVERIFY(page.spawnAt("PlayerStart"));
    QVERIFY(page.takeControl());
    const double from_m = page.position_m().z();
    page.hold(Qt::Key_R);
    QTRY_VERIFY_WITH_TIMEOUT(page.position_m().z() > from_m + 1.5, soon_ms);
    page.release(Qt::Key_R);
    page.screenshot("drive-flying");
    QTRY_VERIFY(page.standsStill());
}

USAR_TEST(tst_WindowDrive)

} // namespace tst_window_drive

#include "tst_window_drive.moc"
