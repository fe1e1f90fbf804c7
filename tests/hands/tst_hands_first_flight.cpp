// A newcomer's first flight: from a start pose on the map to files on the disk.
#include <QDir>
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_first_flight {

using namespace usar::hands;

class tst_HandsFirstFlight : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void aDoubleClickOnAStartPoseSpawnsARobot();
    void anAreaAndStartMakeItFly();
    void atTheEndACardShowsTheResult();
    void itsFilesAreInTheResultFolder();

private:
    Program program_;
};

constexpr int flight_ms = 120000; ///< of a small area, as fast as a busy machine can

void tst_HandsFirstFlight::initTestCase() {
    QVERIFY2(program_.trouble().isEmpty(), qPrintable(program_.trouble()));
    QVERIFY(program_.says("Connected"));
}

void tst_HandsFirstFlight::aDoubleClickOnAStartPoseSpawnsARobot() {
    QVERIFY(program_.spawnAt("PlayerStart", "R1"));
    QVERIFY(program_.read().find([](const Seen& seen) { return seen.name == "Robot R1"; }));
}

void tst_HandsFirstFlight::anAreaAndStartMakeItFly() {
    QVERIFY(program_.fly());
    QTRY_VERIFY2_WITH_TIMEOUT(program_.row("R1").contains("drives"), qPrintable(program_.row("R1")), 30000);
    program_.screenshot("flying");
}

void tst_HandsFirstFlight::atTheEndACardShowsTheResult() {
    program_.desk().key("ctrl+0"); // as fast as the machine can
    QVERIFY(program_.says("R1: mission complete", flight_ms));
    QVERIFY2(program_.row("R1").contains("done"), qPrintable(program_.row("R1")));
    QVERIFY2(program_.number("Coverage") > 90.0, qPrintable(program_.figure("Coverage")));
    QVERIFY(program_.read().find("push button", "Open folder"));
    QVERIFY(program_.read().find("push button", "Fly again"));
    program_.screenshot("done");
}

void tst_HandsFirstFlight::itsFilesAreInTheResultFolder() {
    const QDir results(program_.resultFolder());
    for (const QString& kind : QStringList{"*_height.png", "*_picture.png", "*.bil", "*.json", "*.usarrec"})
        QVERIFY2(!results.entryList({kind}).isEmpty(),
                 qPrintable(kind + " is not in " + results.entryList().join(' ')));
}

USAR_TEST(tst_HandsFirstFlight)

} // namespace tst_hands_first_flight

#include "tst_hands_first_flight.moc"
