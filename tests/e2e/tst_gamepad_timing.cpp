// How soon a robot stops whose gamepad is torn out, in wall-clock time.
#include <QElapsedTimer>
#include <QTest>

#include "tests/e2e/pad_page.h"
#include "tests/suite/suite.h"

namespace tst_gamepad_timing {

class tst_GamepadTiming : public QObject {
    Q_OBJECT
private slots:
    void aPadThatIsTornOutStopsTheRobotWithin250Ms();
};

void tst_GamepadTiming::aPadThatIsTornOutStopsTheRobotWithin250Ms() {
    PadPage page;
    QVERIFY(page.ready());
    VirtualPad pad;
    QTRY_VERIFY_WITH_TIMEOUT(!page.padName().isEmpty(), soon_ms);
    pad.push(SDL_CONTROLLER_AXIS_LEFTY, -1.0);
    QTRY_VERIFY(page.state().held && !page.standsStill());
    QElapsedTimer since;
    since.start();
    pad.unplug();
    QTRY_VERIFY(page.standsStill());
    QVERIFY2(since.elapsed() < 250, qPrintable(QString::number(since.elapsed())));
}

USAR_TEST(tst_GamepadTiming)

} // namespace tst_gamepad_timing

#include "tst_gamepad_timing.moc"
