// A gamepad in the real window: plugged in, driven with, and torn out. SDL's virtual joysticks stand for real ones.
#include <SDL.h>

#include <QRegularExpression>
#include <QTest>

#include "tests/e2e/drive_page.h"
#include "tests/e2e/gui_watchdog.h"

using namespace usar;

namespace {

/// Plugged in from its making to its end.
class VirtualPad {
public:
    VirtualPad() : index_(SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15, 0)) {
        stick_ = SDL_JoystickOpen(index_);
        for (int axis = 0; axis < 4; ++axis)
            SDL_JoystickSetVirtualAxis(stick_, axis, 0);
    }
    ~VirtualPad() { unplug(); }
    void unplug() {
        if (!stick_)
            return;
        for (int device = 0; device < SDL_NumJoysticks(); ++device)
            if (SDL_JoystickGetDeviceInstanceID(device) == SDL_JoystickInstanceID(stick_)) {
                SDL_JoystickDetachVirtual(device);
                break;
            }
        SDL_JoystickClose(std::exchange(stick_, nullptr));
    }
    bool made() const { return stick_ != nullptr; }
    /// -1..1, as SDL counts: to the right and down.
    void push(SDL_GameControllerAxis axis, double share) {
        SDL_JoystickSetVirtualAxis(stick_, axis, static_cast<Sint16>(share * 32767.0));
    }
    void press(SDL_GameControllerButton button, bool down) {
        SDL_JoystickSetVirtualButton(stick_, button, down ? 1 : 0);
    }

private:
    int index_;
    SDL_Joystick* stick_ = nullptr;
};

/// With a P2DX that the person has taken.
struct PadPage : DrivePage {
    bool ready() {
        if (!QTest::qWaitFor([this] { return hasStartPoses(); }, soon_ms) || !spawnClass("P2DX"))
            return false;
        openDock();
        bool started = false;
        QObject::connect(&window().drive().gamepad(), &app::Gamepad::started, &window(), [&] { started = true; });
        return takeControl() && QTest::qWaitFor([&] { return started; }, soon_ms);
    }
    QString padName() { return window().drive().gamepad().name(); }
};

} // namespace

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
    QElapsedTimer since;
    since.start();
    pad.unplug();
    QTRY_VERIFY(page.standsStill());
    QVERIFY2(since.elapsed() < 250, qPrintable(QString::number(since.elapsed())));
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
    for (int i = 0; i < 20; ++i) {
        pad.push(SDL_CONTROLLER_AXIS_LEFTY, i % 2 == 0 ? 0.1 : -0.1);
        QTest::qWait(20);
    }
    QCOMPARE(page.driveCount(), said);
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
    QTest::qWait(300);
    QVERIFY(page.standsStill()); // though the stick is still pushed
    pad.press(SDL_CONTROLLER_BUTTON_START, true);
    QTRY_COMPARE(page.control(), QString("R1: nobody drives"));
}

void tst_WindowGamepad::keysAndPadDoNotFight() {
    PadPage page;
    QVERIFY(page.ready());
    VirtualPad pad;
    QTRY_VERIFY_WITH_TIMEOUT(!page.padName().isEmpty(), soon_ms);
    page.hold(Qt::Key_W);
    QTRY_VERIFY(page.state().held == mission::HandSource::Keys);
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, 1.0); // backward
    QTest::qWait(300);
    QVERIFY(page.state().held == mission::HandSource::Keys && page.state().sent.forward > 0.0);
    page.release(Qt::Key_W);
    QTRY_VERIFY(page.standsStill());
    QTest::qWait(300);
    QVERIFY(!page.state().held); // it has to be let go first
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, 0.0);
    QTest::qWait(100);
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, 1.0);
    QTRY_VERIFY(page.state().held == mission::HandSource::Gamepad && page.state().sent.forward < 0.0);
}

USAR_E2E_MAIN(tst_WindowGamepad)
#include "tst_window_gamepad.moc"
