// A newcomer's first flight.
#include <QDir>
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_first_flight {

using namespace usar::hands;

class tst_HandsFirstFlight : public QObject {
    Q_OBJECT
private slots:
    void fiveGesturesLeadToAMap();
    void aMissionIsOpenedByItsPath();
};

void tst_HandsFirstFlight::fiveGesturesLeadToAMap() {
    Program program;
    QVERIFY2(program.trouble().isEmpty(), qPrintable(program.trouble()));
    QVERIFY(program.says("Connected"));
    program.screenshot("start");
    QVERIFY(program.spawnAt("PlayerStart", "R1"));
    QVERIFY(program.fly());
    program.desk().key("ctrl+0"); // as fast as the machine can
    QTRY_VERIFY_WITH_TIMEOUT(program.figure("Coverage").section(' ', 0, 0).toDouble() > 90.0, 110000);
    program.screenshot("scan");
    const QDir results(program.resultFolder());
    QTRY_VERIFY_WITH_TIMEOUT(!results.entryList({"*_height.png"}).isEmpty(), 110000);
    QTRY_VERIFY_WITH_TIMEOUT(!results.entryList({"*.bil"}).isEmpty(), 15000);
    program.screenshot("done");
}

void tst_HandsFirstFlight::aMissionIsOpenedByItsPath() {
    Program program;
    QVERIFY2(program.trouble().isEmpty(), qPrintable(program.trouble()));
    QVERIFY(program.says("Connected"));
    program.desk().key("ctrl+o");
    QVERIFY(program.says("Open mission"));
    program.screenshot("open_mission");
    program.desk().type(USAR_SOURCE_DIR "/resources/missions/quick_scan.json");
    program.desk().key("Return");
    QVERIFY(program.says("5 lanes"));
}

USAR_TEST(tst_HandsFirstFlight)

} // namespace tst_hands_first_flight

#include "tst_hands_first_flight.moc"
