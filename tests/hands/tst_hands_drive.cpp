// Driving with a real keyboard: a held key moves the robot, and whatever takes the key away stops it.
#include <QElapsedTimer>
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_drive {

using namespace usar::hands;

class tst_HandsDrive : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void aKeyTakesControl();
    void aHeldKeyDrivesAndLettingItGoStops();
    void aFieldThatGetsTheKeysStopsTheRobot();
    void controlIsGivenUpOnlyAfterAQuestion();

private:
    /// True while the list says that a key drives R1.
    bool held() const { return program_.row("R1").contains("keys"); }
    bool taken() const { return program_.row("R1").contains("you drive"); }
    QPoint place() const {
        return program_.read()
            .find([](const Seen& seen) { return seen.name == "Robot R1"; })
            .value_or(Seen{})
            .at.center();
    }
    bool comesToRest() const;

    Program program_;
};

constexpr int patience_ms = 30000;

/// True once the robot is seen within a pixel of one place for a second. It keeps its place against wind and noise, so
/// two looks in a row may differ by a pixel at any time.
bool tst_HandsDrive::comesToRest() const {
    constexpr qint64 rest_ms = 1000;
    QPoint rest = place();
    QElapsedTimer since;
    since.start();
    return QTest::qWaitFor(
        [&] {
            const QPoint now = place();
            if (const QPoint apart = now - rest; std::max(std::abs(apart.x()), std::abs(apart.y())) > 1) {
                rest = now;
                since.restart();
            }
            return since.elapsed() >= rest_ms;
        },
        patience_ms);
}

void tst_HandsDrive::initTestCase() {
    QVERIFY2(program_.trouble().isEmpty(), qPrintable(program_.trouble()));
    QVERIFY(program_.spawnByKeys("PlayerStart", "R1"));
    QTRY_VERIFY2_WITH_TIMEOUT(program_.row("R1").contains("idle"), qPrintable(program_.row("R1")), patience_ms);
}

void tst_HandsDrive::aKeyTakesControl() {
    QVERIFY(program_.lookAtWorld());
    program_.desk().key("g");
    QTRY_VERIFY2_WITH_TIMEOUT(taken(), qPrintable(program_.row("R1")), patience_ms);
    QVERIFY2(!held(), qPrintable(program_.row("R1")));
}

void tst_HandsDrive::aHeldKeyDrivesAndLettingItGoStops() {
    const QPoint before = place();
    program_.desk().press("r"); // Up, and then ahead.
    QTRY_VERIFY2_WITH_TIMEOUT(held(), qPrintable(program_.row("R1")), patience_ms);
    program_.desk().press("w");
    QTRY_VERIFY_WITH_TIMEOUT((place() - before).manhattanLength() > 12, patience_ms);
    program_.screenshot("driving");
    program_.desk().letGo("w");
    program_.desk().letGo("r");
    QTRY_VERIFY2_WITH_TIMEOUT(!held(), qPrintable(program_.row("R1")), patience_ms);
    QVERIFY2(taken(), qPrintable(program_.row("R1")));
    QVERIFY2(comesToRest(), "it does not come to rest");
}

/// The key is still down when the line for raw commands gets the keys.
void tst_HandsDrive::aFieldThatGetsTheKeysStopsTheRobot() {
    QVERIFY(program_.lookAtWorld());
    program_.desk().press("r");
    QTRY_VERIFY2_WITH_TIMEOUT(held(), qPrintable(program_.row("R1")), patience_ms);
    program_.desk().key("F4");
    QTRY_VERIFY2_WITH_TIMEOUT(!held(), qPrintable(program_.row("R1")), patience_ms);
    program_.desk().letGo("r");
    QVERIFY2(taken(), qPrintable(program_.row("R1")));
}

void tst_HandsDrive::controlIsGivenUpOnlyAfterAQuestion() {
    QVERIFY(program_.lookAtWorld());
    program_.desk().key("g");
    QVERIFY(program_.says("Give up control of R1?"));
    QVERIFY2(taken(), qPrintable(program_.row("R1")));
    QVERIFY(program_.press("Give up control"));
    QTRY_VERIFY2_WITH_TIMEOUT(!taken(), qPrintable(program_.row("R1")), patience_ms);
}

USAR_TEST(tst_HandsDrive)

} // namespace tst_hands_drive

#include "tst_hands_drive.moc"
