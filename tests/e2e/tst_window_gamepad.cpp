// A gamepad in the real window: plugged in, driven with, and torn out. SDL's virtual joysticks stand for real ones.
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/pad_page.h"
#include "tests/suite/suite.h"

namespace tst_window_gamepad {

using namespace usar;

class tst_WindowGamepad : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void aPushedStickDrivesAndIsNamed();
    void aPadThatIsTornOutStopsTheRobot();
    void aRestingStickThatNeverQuiteRestsDrivesNothing();
    void itsButtonsStopAndGiveBack();
    void keysAndPadDoNotFight();
};

void tst_WindowGamepad::aPushedStickDrivesAndIsNamed() {
    PadPage page;
    QVERIFY(page.ready());
    QVERIFY(page.panel().gamepadText().contains("none plugged in"));
    VirtualPad pad;
    QVERIFY2(pad.made(), SDL_GetError());
    QTRY_VERIFY_WITH_TIMEOUT(!page.padName().isEmpty(), soon_ms);
    QVERIFY(page.panel().gamepadText().contains(page.padName()));
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, -1.0);
    QTRY_VERIFY(page.state().held == mission::HandSource::Gamepad && page.state().sent.forward > 0.95);
    QCOMPARE(page.control(), QString("R1: you drive · %1").arg(page.padName()));
    QCOMPARE(page.lastCause(), QString("by hand: gamepad %1").arg(page.padName()));
    pad.push(SDL_CONTROLLER_AXIS_LEFTX, -0.7);
    QTRY_VERIFY(page.state().sent.turn > 0.3); // to the left
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, 0.0);
    pad.push(SDL_CONTROLLER_AXIS_LEFTX, 0.0);
    QTRY_VERIFY(page.standsStill());
    QVERIFY(page.lastCause().contains("the gamepad was let go"));
}

void tst_WindowGamepad::aPadThatIsTornOutStopsTheRobot() {
    PadPage page;
    QVERIFY(page.ready());
    VirtualPad pad;
    QTRY_VERIFY_WITH_TIMEOUT(!page.padName().isEmpty(), soon_ms);
    const QString name = page.padName();
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, -1.0);
    QTRY_VERIFY(page.state().held && !page.standsStill());
    pad.unplug();
    QTRY_VERIFY(page.standsStill());
    QVERIFY2(page.lastCause().contains("unplugged"), qPrintable(page.lastCause()));
    QTRY_VERIFY(page.panel().gamepadText().contains("none plugged in"));
    VirtualPad again; // plugged in anew, it drives at once
    QTRY_COMPARE_WITH_TIMEOUT(page.padName(), name, soon_ms);
    again.push(SDL_CONTROLLER_AXIS_LEFTY, -1.0);
    QTRY_VERIFY(page.state().held && !page.standsStill());
}

void tst_WindowGamepad::aRestingStickThatNeverQuiteRestsDrivesNothing() {
    PadPage page;
    QVERIFY(page.ready());
    VirtualPad pad;
    QTRY_VERIFY_WITH_TIMEOUT(!page.padName().isEmpty(), soon_ms);
    const qsizetype said = page.driveCount();
    int looks = 0;
    const auto trembles = [&] {
        pad.push(SDL_CONTROLLER_AXIS_LEFTY, ++looks % 2 == 0 ? 0.1 : -0.1);
        return page.driveCount() == said;
    };
    QVERIFY(page.holdsWhileClockGoesOn(trembles, Seconds(0.6)));
    QVERIFY(!page.state().held);
}

void tst_WindowGamepad::itsButtonsStopAndGiveBack() {
    PadPage page;
    QVERIFY(page.ready());
    VirtualPad pad;
    QTRY_VERIFY_WITH_TIMEOUT(!page.padName().isEmpty(), soon_ms);
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, -1.0);
    QTRY_VERIFY(page.state().held && !page.standsStill());
    pad.press(SDL_CONTROLLER_BUTTON_B, true);
    QTRY_VERIFY(page.standsStill());
    // Though the stick is still pushed.
    QVERIFY(page.holdsWhileClockGoesOn([&] { return page.standsStill(); }, Seconds(0.4)));
    pad.press(SDL_CONTROLLER_BUTTON_START, true);
    QTRY_COMPARE(page.control(), QString("R1: idle"));
}

void tst_WindowGamepad::keysAndPadDoNotFight() {
    PadPage page;
    QVERIFY(page.ready());
    VirtualPad pad;
    QTRY_VERIFY_WITH_TIMEOUT(!page.padName().isEmpty(), soon_ms);
    page.hold(Qt::Key_W);
    QTRY_VERIFY(page.state().held == mission::HandSource::Keys);
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, 1.0); // backward
    QVERIFY(page.holdsWhileClockGoesOn(
        [&] { return page.state().held == mission::HandSource::Keys && page.state().sent.forward > 0.0; },
        Seconds(0.4)));
    page.release(Qt::Key_W);
    QTRY_VERIFY(page.standsStill());
    // It has to be let go first.
    QVERIFY(page.holdsWhileClockGoesOn([&] { return !page.state().held; }, Seconds(0.4)));
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, 0.0);
    QVERIFY(page.clockGoesOn(Seconds(0.2)));
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, 1.0);
    QTRY_VERIFY(page.state().held == mission::HandSource::Gamepad && page.state().sent.forward < 0.0);
}

USAR_TEST(tst_WindowGamepad)

} // namespace tst_window_gamepad

#include "tst_window_gamepad.moc"
