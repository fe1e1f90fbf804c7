// What a robot has, told from what it says.
#include <QTest>

#include "core/mission/fleet/equipment.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_equipment {

using namespace usar;
using namespace usar::mission;

namespace {

/// A robot that sends these lines ten times a second, for this long.
Equipment after(double seconds, const std::vector<std::string>& lines) {
    protocol::Reader reader;
    Equipment has;
    for (int i = 0; i <= 10 * seconds; ++i)
        for (const std::string& line : lines)
            has.take(reader.read(line), Seconds(100.0 + 0.1 * i));
    return has;
}

constexpr const char* submarine = "STA {Type NauticVehicle} {Time 1} {Battery 1200}";
constexpr const char* rover = "STA {Type GroundVehicle} {Time 1} {Battery 1200}";
constexpr const char* copter = "STA {Type AerialVehicle} {Time 1} {Battery 1200}";
constexpr const char* scan = "SEN {Time 1} {Type RangeScanner} {Name S1} {Resolution 0.1} {FOV 0.2} {Range 1,2,3}";
constexpr const char* sonar = "SEN {Time 1} {Type Sonar} {Name F1 Range 2.0}";

} // namespace

class tst_Equipment : public QObject {
    Q_OBJECT
private slots:
    void anythingMayComeBeforeTheRobotHasSpoken();
    void aSubmarineHasNoScannerAndDoesNotFly();
    void whatHasSpokenOnceIsThere();
    void geometryTellsOfASilentScanner();
    void onlyAStatusWithARangeRecharges();
};

void tst_Equipment::anythingMayComeBeforeTheRobotHasSpoken() {
    const Equipment unknown;
    QVERIFY(unknown.mayHaveScanner() && unknown.mayHaveSonars() && unknown.mayFly() && unknown.mayRecharge());
    const Equipment young = after(0.5, {submarine});
    QVERIFY(young.mayHaveScanner() && young.mayHaveSonars());
}

void tst_Equipment::aSubmarineHasNoScannerAndDoesNotFly() {
    const Equipment has = after(3.0, {submarine});
    QVERIFY(!has.mayHaveScanner());
    QVERIFY(!has.mayHaveSonars());
    QVERIFY(!has.mayFly());
    QVERIFY(!has.mayRecharge());
}

void tst_Equipment::whatHasSpokenOnceIsThere() {
    Equipment has = after(3.0, {copter, scan});
    QVERIFY(has.mayHaveScanner());
    QVERIFY(!has.mayHaveSonars());
    QVERIFY(has.mayFly());
    protocol::Reader reader;
    has.take(reader.read(sonar), Seconds(200.0));
    QVERIFY(has.mayHaveSonars());
}

void tst_Equipment::geometryTellsOfASilentScanner() {
    const Equipment has =
        after(3.0, {rover, "GEO {Type RangeScanner} {Name S1 Location 0,0,0 Orientation 0,0,0 Mount HARD}"});
    QVERIFY(has.mayHaveScanner());
    QVERIFY(!has.mayHaveSonars());
}

void tst_Equipment::onlyAStatusWithARangeRecharges() {
    Equipment has = after(3.0, {copter});
    QVERIFY(has.mayRecharge());
    agent::BehaviorStatus status;
    has.take(status);
    QVERIFY(!has.mayRecharge());
    status.range_left_m = 400.0;
    has.take(status);
    QVERIFY(has.mayRecharge());
}

USAR_TEST(tst_Equipment)

} // namespace tst_equipment

#include "tst_equipment.moc"
