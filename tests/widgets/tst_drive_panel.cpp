// The dock that drives, its pads and its keys.
#include <QLabel>
#include <QLineEdit>
#include <QPointingDevice>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/drive/drive_keys.h"
#include "widgets/drive/drive_pad.h"
#include "widgets/drive/drive_panel.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_drive_panel {

using namespace usar;
using namespace usar::widgets;

namespace {

constexpr StickAxes all_axes{true, true, true, true};
constexpr StickAxes wheels{.forward = true, .turn = true};

DriveState takenRobot(const StickAxes& axes) {
    return {.robot = "R1", .control = {"R1", Driver::Person, {}}, .can_take = true, .taken = true, .axes = axes};
}

QPushButton* button(const QWidget& panel, const QString& text) {
    for (QPushButton* one : panel.findChildren<QPushButton*>())
        if (one->text() == text)
            return one;
    return nullptr;
}

bool shows(const QWidget& panel, const QString& text) {
    for (const QLabel* label : panel.findChildren<QLabel*>())
        if (label->isVisible() && label->text() == text)
            return true;
    return false;
}

QList<DrivePad*> shownPads(const DrivePanel& panel) {
    QList<DrivePad*> shown;
    for (DrivePad* pad : panel.findChildren<DrivePad*>())
        if (pad->isVisible())
            shown << pad;
    return shown;
}

struct KeyWindow : QWidget {
    KeyWindow() : line(this), keys(this) {
        setFocusPolicy(Qt::StrongFocus);
        show();
        activateWindow();
        ready = QTest::qWaitForWindowActive(this);
        setFocus();
        keys.setAxes(all_axes);
        keys.setActive(true);
    }
    QLineEdit line;
    DriveKeys keys;
    bool ready = false;
};

} // namespace

class tst_DrivePanel : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }
    void aPadSpringsBack();
    void aPadGoesNoFartherThanItsEdge();
    void aFingerHoldsAPad();
    void arrowKeysHoldAPad();
    void whateverTakesAPadAwayLetsItGo_data();
    void whateverTakesAPadAwayLetsItGo();
    void padsAreThoseOfTheRobotsAxes();
    void padsMoveNothingBeforeControlIsTaken();
    void figuresSayWhatIsAskedAndWhatIsDone();
    void theButtonSaysWhatItWillDo();
    void thereIsAlwaysAStop();
    void keysAddUpToAStick_data();
    void keysAddUpToAStick();
    void keysOfNoAxisAreNotTaken();
    void shiftDrivesSlower();
    void spaceStopsAndNothingIsHeldThen();
    void typedTextIsNotTaken();
    void whoDrivesIsSaidInAWord_data();
    void whoDrivesIsSaidInAWord();
};

void tst_DrivePanel::aPadSpringsBack() {
    DrivePad pad(PadShape::Both);
    pad.resize(180, 180);
    pad.show();
    QSignalSpy moved(&pad, &DrivePad::moved);
    QTest::mousePress(&pad, Qt::LeftButton, {}, {90, 50});
    QVERIFY(pad.value().y() > 0.3 && pad.value().x() == 0.0);
    QTest::mouseMove(&pad, {130, 90});
    QVERIFY(pad.value().x() > 0.3 && pad.value().y() == 0.0);
    QTest::mouseRelease(&pad, Qt::LeftButton, {}, {130, 90});
    QCOMPARE(pad.value(), QPointF());
    QCOMPARE(moved.last().front().toPointF(), QPointF());
    QTest::mousePress(&pad, Qt::RightButton, {}, {90, 50});
    QVERIFY(!pad.held());
}

void tst_DrivePanel::aPadGoesNoFartherThanItsEdge() {
    DrivePad pad(PadShape::Across);
    pad.resize(180, 40);
    pad.show();
    QTest::mousePress(&pad, Qt::LeftButton, {}, {90, 20});
    QTest::mouseMove(&pad, {900, -300});
    QCOMPARE(pad.value(), QPointF(1.0, 0.0));
    QTest::mouseRelease(&pad, Qt::LeftButton);
}

void tst_DrivePanel::aFingerHoldsAPad() {
    DrivePad pad(PadShape::Upright);
    pad.resize(40, 180);
    pad.show();
    QVERIFY(QTest::qWaitForWindowExposed(&pad));
    const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
    QTest::touchEvent(&pad, screen.get()).press(0, {20, 30}, &pad);
    QTRY_VERIFY(pad.value().y() > 0.5);
    QTest::touchEvent(&pad, screen.get()).move(0, {20, 150}, &pad);
    QTRY_VERIFY(pad.value().y() < -0.5);
    QTest::touchEvent(&pad, screen.get()).release(0, {20, 150}, &pad);
    QTRY_COMPARE(pad.value(), QPointF());
}

void tst_DrivePanel::arrowKeysHoldAPad() {
    DrivePad pad(PadShape::Both);
    pad.show();
    QTest::keyPress(&pad, Qt::Key_Up);
    QTest::keyPress(&pad, Qt::Key_Left);
    QCOMPARE(pad.value(), QPointF(-1.0, 1.0));
    QTest::keyRelease(&pad, Qt::Key_Up);
    QCOMPARE(pad.value(), QPointF(-1.0, 0.0));
    QTest::keyRelease(&pad, Qt::Key_Left);
    QVERIFY(!pad.held());
}

void tst_DrivePanel::whateverTakesAPadAwayLetsItGo_data() {
    using Away = std::function<void(DrivePad&)>;
    QTest::addColumn<Away>("away");
    QTest::newRow("hidden") << Away([](DrivePad& pad) { pad.hide(); });
    QTest::newRow("disabled") << Away([](DrivePad& pad) { pad.setEnabled(false); });
    QTest::newRow("focus lost") << Away([](DrivePad& pad) {
        QFocusEvent out(QEvent::FocusOut);
        QCoreApplication::sendEvent(&pad, &out);
    });
}

void tst_DrivePanel::whateverTakesAPadAwayLetsItGo() {
    QFETCH(std::function<void(DrivePad&)>, away);
    DrivePad pad(PadShape::Both);
    pad.resize(180, 180);
    pad.show();
    QTest::mousePress(&pad, Qt::LeftButton, {}, {90, 30});
    QVERIFY(pad.held());
    away(pad);
    QVERIFY(!pad.held());
    QCOMPARE(pad.value(), QPointF());
}

void tst_DrivePanel::padsAreThoseOfTheRobotsAxes() {
    DrivePanel panel;
    panel.resize(280, 600);
    panel.show();
    panel.setState(takenRobot(all_axes));
    QCOMPARE(shownPads(panel).size(), 3);
    QVERIFY(shows(panel, "Up"));
    panel.setState(takenRobot(wheels));
    QCOMPARE(shownPads(panel).size(), 1);
    QVERIFY(!shows(panel, "Up") && !shows(panel, "Left") && shows(panel, "Forward"));
}

void tst_DrivePanel::padsMoveNothingBeforeControlIsTaken() {
    DrivePanel panel;
    panel.resize(280, 600);
    panel.show();
    DriveState state = takenRobot(wheels);
    state.taken = false;
    panel.setState(state);
    DrivePad* const pad = shownPads(panel).front();
    QTest::mousePress(pad, Qt::LeftButton, {}, pad->rect().center() - QPoint(0, 40));
    QVERIFY(panel.stick().centered());
    panel.setState(takenRobot(wheels));
    QTest::mousePress(pad, Qt::LeftButton, {}, pad->rect().center() - QPoint(0, 40));
    QVERIFY(panel.stick().forward > 0.3);
    panel.setState(state); // taken away while it is held
    QVERIFY(panel.stick().centered());
}

void tst_DrivePanel::figuresSayWhatIsAskedAndWhatIsDone() {
    DrivePanel panel;
    panel.resize(280, 600);
    panel.show();
    DriveState state = takenRobot(wheels);
    state.sent = {.forward = 0.5, .turn = -1.0};
    state.top_speed_m_s = 1.6;
    state.note = "Stopped: the keys were let go.";
    panel.setState(state);
    panel.setVelocity({.forward_m_s = 0.314, .turn_rad_s = -0.5}, false);
    panel.setSpeedShare(0.5);
    for (const char* text :
         {"50 %", "−100 %", "0.31 m/s", "−29 °/s", "50 % · 0.8 m/s", "Stopped: the keys were let go."})
        QVERIFY2(shows(panel, text), text);
    panel.setVelocity({}, false);
    QVERIFY(shows(panel, "–"));
    panel.setEcho("DRIVE {Left 1} {Right 1}");
    QCOMPARE(panel.echo(), QString("DRIVE {Left 1} {Right 1}"));
}

void tst_DrivePanel::theButtonSaysWhatItWillDo() {
    DrivePanel panel;
    panel.resize(280, 600);
    panel.show();
    QSignalSpy take(&panel, &DrivePanel::takeRequested);
    DriveState state{.robot = "R1", .control = {"R1", Driver::Behavior, "Survey"}, .can_take = true, .axes = wheels};
    panel.setState(state);
    QTest::mouseClick(button(panel, "Take control"), Qt::LeftButton);
    QCOMPARE(take.last().front().toBool(), true);
    state.control.driver = Driver::Nobody;
    panel.setState(state);
    QVERIFY(button(panel, "Drive by hand"));
    panel.setState(takenRobot(wheels));
    QTest::mouseClick(button(panel, "Give control back"), Qt::LeftButton);
    QCOMPARE(take.last().front().toBool(), false);
}

void tst_DrivePanel::thereIsAlwaysAStop() {
    DrivePanel panel;
    panel.resize(280, 600);
    panel.show();
    QSignalSpy stop(&panel, &DrivePanel::stopRequested);
    panel.setEmpty("No robot yet", "Spawn one.");
    QVERIFY(button(panel, "STOP")->isVisible());
    QVERIFY(!button(panel, "STOP")->isEnabled()); // nobody to stop
    QVERIFY(panel.findChild<EmptyState*>()->isVisible());
    QVERIFY(shownPads(panel).isEmpty());
    panel.setEmpty({}, {});
    panel.setState(takenRobot(wheels));
    QVERIFY(!panel.findChild<EmptyState*>()->isVisible());
    QTest::mouseClick(button(panel, "STOP R1"), Qt::LeftButton);
    QCOMPARE(stop.size(), 1);
}

void tst_DrivePanel::keysAddUpToAStick_data() {
    QTest::addColumn<QList<int>>("keys");
    QTest::addColumn<QList<double>>("stick"); ///< forward, left, turn, up
    QTest::newRow("forward") << QList<int>{Qt::Key_W} << QList<double>{1, 0, 0, 0};
    QTest::newRow("back and to the right") << QList<int>{Qt::Key_S, Qt::Key_D} << QList<double>{-1, 0, -1, 0};
    QTest::newRow("both ways at once are none") << QList<int>{Qt::Key_W, Qt::Key_S} << QList<double>{0, 0, 0, 0};
    QTest::newRow("left, sideways and up") << QList<int>{Qt::Key_A, Qt::Key_Q, Qt::Key_R} << QList<double>{0, 1, 1, 1};
    QTest::newRow("right and down") << QList<int>{Qt::Key_E, Qt::Key_F} << QList<double>{0, -1, 0, -1};
}

void tst_DrivePanel::keysAddUpToAStick() {
    QFETCH(QList<int>, keys);
    QFETCH(QList<double>, stick);
    KeyWindow window;
    QVERIFY(window.ready);
    for (const int key : keys)
        QTest::keyPress(window.windowHandle(), static_cast<Qt::Key>(key));
    QCOMPARE(window.keys.stick(), (Stick{stick[0], stick[1], stick[2], stick[3]}));
    for (const int key : keys)
        QTest::keyRelease(window.windowHandle(), static_cast<Qt::Key>(key));
    QVERIFY(window.keys.stick().centered());
}

void tst_DrivePanel::keysOfNoAxisAreNotTaken() {
    KeyWindow window;
    QVERIFY(window.ready);
    window.keys.setAxes(wheels);
    QAction fit;
    fit.setShortcut(Qt::Key_F);
    QSignalSpy fitted(&fit, &QAction::triggered);
    window.addAction(&fit);
    QTest::keyClick(window.windowHandle(), Qt::Key_F);
    QCOMPARE(fitted.size(), 1);
    window.keys.setAxes(all_axes);
    QTest::keyClick(window.windowHandle(), Qt::Key_F);
    QCOMPARE(fitted.size(), 1);
    window.keys.setActive(false);
    QTest::keyClick(window.windowHandle(), Qt::Key_F);
    QCOMPARE(fitted.size(), 2);
}

void tst_DrivePanel::shiftDrivesSlower() {
    KeyWindow window;
    QVERIFY(window.ready);
    QTest::keyPress(window.windowHandle(), Qt::Key_Shift);
    QTest::keyPress(window.windowHandle(), Qt::Key_W, Qt::ShiftModifier);
    QCOMPARE(window.keys.stick().forward, 0.3);
    QTest::keyRelease(window.windowHandle(), Qt::Key_Shift);
    QCOMPARE(window.keys.stick().forward, 1.0);
    QTest::keyRelease(window.windowHandle(), Qt::Key_W);
    QVERIFY(window.keys.stick().centered());
}

void tst_DrivePanel::spaceStopsAndNothingIsHeldThen() {
    KeyWindow window;
    QVERIFY(window.ready);
    QSignalSpy stop(&window.keys, &DriveKeys::stopPressed);
    QTest::keyPress(window.windowHandle(), Qt::Key_W);
    QTest::keyClick(window.windowHandle(), Qt::Key_Space);
    QCOMPARE(stop.size(), 1);
    QVERIFY(window.keys.stick().centered());
}

void tst_DrivePanel::typedTextIsNotTaken() {
    KeyWindow window;
    QVERIFY(window.ready);
    QSignalSpy lost(&window.keys, &DriveKeys::focusLost);
    QTest::keyPress(window.windowHandle(), Qt::Key_W);
    window.line.setFocus();
    QCOMPARE(lost.size(), 1);
    QVERIFY(window.keys.stick().centered());
    QTest::keyClick(window.windowHandle(), Qt::Key_A);
    QCOMPARE(window.line.text(), QString("a"));
    QVERIFY(window.keys.stick().centered());
}

void tst_DrivePanel::whoDrivesIsSaidInAWord_data() {
    QTest::addColumn<int>("driver");
    QTest::addColumn<QString>("by");
    QTest::addColumn<QString>("text");
    QTest::newRow("nobody") << int(Driver::Nobody) << ""
                            << "R1: idle";
    QTest::newRow("a behavior") << int(Driver::Behavior) << "Terrain survey"
                                << "R1: Terrain survey drives";
    QTest::newRow("a person who holds nothing") << int(Driver::Person) << ""
                                                << "R1: you drive";
    QTest::newRow("keys") << int(Driver::Person) << "keys"
                          << "R1: you drive · keys";
}

void tst_DrivePanel::whoDrivesIsSaidInAWord() {
    QFETCH(int, driver);
    QFETCH(QString, by);
    QFETCH(QString, text);
    ControlBadge badge;
    QCOMPARE(badge.text(), QString("No robot"));
    badge.setWords({"R1", Driver(driver), by});
    QCOMPARE(badge.text(), text);
    QCOMPARE(badge.accessibleName(), text);
    QVERIFY(badge.toolTip().contains(text));
    QSignalSpy clicked(&badge, &ControlBadge::clicked);
    badge.show();
    QTest::mouseClick(&badge, Qt::LeftButton);
    QTest::keyClick(&badge, Qt::Key_Return);
    QCOMPARE(clicked.size(), 2);
}

USAR_TEST(tst_DrivePanel)

} // namespace tst_drive_panel

#include "tst_drive_panel.moc"
