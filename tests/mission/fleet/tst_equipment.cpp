// What kind of robot it is, told from what it says.
#include <QTest>

#include "core/mission/fleet/equipment.h"
#include "core/mission/fleet/equipment_questions.h"
#include "core/protocol/command_writer.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_equipment {

using namespace usar;
using namespace usar::mission;

namespace {

Equipment after(const std::vector<std::string>& lines) {
    protocol::Reader reader;
    Equipment has;
    for (const std::string& line : lines)
        has.take(reader.read(line));
    return has;
}

constexpr const char* copter = "STA {Type AerialVehicle} {Time 1} {Battery 1200}";
constexpr const char* udk_copter = "STA {Time 1} {Battery 1200}";

/// What is asked at `now_s` of a robot that has sent these lines ten times a second since second 100.
struct Asked {
    protocol::Reader reader;
    EquipmentQuestions questions;

    void hear(const std::vector<std::string>& lines, double from_s, double to_s) {
        for (double s = from_s; s < to_s; s += 0.1)
            for (const std::string& line : lines)
                questions.take(reader.read(line), Seconds(s));
    }
    QStringList at(double now_s) {
        QStringList texts;
        for (const protocol::Command& command : questions.next(Seconds(now_s)))
            texts << QString::fromStdString(protocol::write(command));
        return texts;
    }
};

} // namespace

class tst_Equipment : public QObject {
    Q_OBJECT
private slots:
    void anythingMayComeBeforeTheRobotHasSpoken();
    void whoFlies_data();
    void whoFlies();
    void onlyAStatusWithARangeRecharges();
    void nothingIsAskedInTheFirstSecond();
    void whatWasHeardIsAskedOnceTheRobotFirst();
    void aSensorThatIsNotThereIsNotAskedAgain();
};

void tst_Equipment::anythingMayComeBeforeTheRobotHasSpoken() {
    const Equipment unknown;
    QVERIFY(unknown.mayFly() && unknown.mayRecharge());
    QVERIFY(unknown.kind() == protocol::VehicleKind::Unknown);
}

void tst_Equipment::whoFlies_data() {
    QTest::addColumn<QStringList>("lines");
    QTest::addColumn<bool>("flies");
    QTest::newRow("UT2004 AirRobot") << QStringList{copter} << true;
    QTest::newRow("UDK AirRobot, whose STA has no type") << QStringList{udk_copter} << true;
    QTest::newRow("UDK AirRobot after GETGEO")
        << QStringList{"GEO {Type AerialVehicle} {Name AirRobot} {Dimensions 1,1,0.2} {COG 0,0,0}", udk_copter} << true;
    QTest::newRow("an untyped STA after CONF of a rover")
        << QStringList{"CONF {Name P2AT} {Type GroundVehicle} {SteeringType SkidSteered} {Mass 14}", udk_copter}
        << false;
    QTest::newRow("P2DX") << QStringList{"STA {Type GroundVehicle} {Time 1} {Battery 1200}"} << false;
    QTest::newRow("Submarine") << QStringList{"STA {Type NauticVehicle} {Time 1} {Battery 1200}"} << false;
    QTest::newRow("ERS") << QStringList{"STA {Type LeggedRobot} {Time 1} {Battery 1200}"} << false;
}

void tst_Equipment::whoFlies() {
    QFETCH(QStringList, lines);
    std::vector<std::string> texts;
    for (const QString& line : lines)
        texts.push_back(line.toStdString());
    const Equipment has = after(texts);
    QTEST(has.mayFly(), "flies");
    QTEST(has.mayRecharge(), "flies"); // Until a behavior says what it can.
}

void tst_Equipment::onlyAStatusWithARangeRecharges() {
    Equipment has = after({copter});
    QVERIFY(has.mayRecharge());
    agent::BehaviorStatus status;
    has.take(status);
    QVERIFY(!has.mayRecharge());
    status.range_left_m = 400.0;
    has.take(status);
    QVERIFY(has.mayRecharge());
}

void tst_Equipment::nothingIsAskedInTheFirstSecond() {
    Asked asked;
    asked.hear({copter, "SEN {Time 1} {Type Sonar} {Name F1 Range 2.0}"}, 100.0, 100.9);
    QVERIFY(asked.at(100.9).isEmpty());
    QVERIFY(!asked.at(101.1).isEmpty());
}

void tst_Equipment::whatWasHeardIsAskedOnceTheRobotFirst() {
    Asked asked;
    asked.hear({"SEN {Time 1} {Type Encoder} {Name L Tick 3}", copter, "SEN {Time 1} {Type Sonar} {Name F1 Range 2}"},
               100.0, 101.5);
    protocol::Reader& reader = asked.reader;
    QStringList all;
    for (double s = 101.5; s < 108.0; s += 0.1) {
        const QStringList now = asked.at(s);
        all << now;
        for (const QString& question : now) { // The server answers at once.
            const bool where = question.startsWith("GETGEO");
            const std::string type = question.contains("Robot")   ? "AerialVehicle"
                                     : question.contains("Sonar") ? "Sonar"
                                                                  : "Encoder";
            asked.questions.take(
                reader.read(where ? "GEO {Type " + type + "} {Name F1 Location 0,0,0 Orientation 0,0,0 Mount HARD}"
                                  : "CONF {Type " + type + "} {Name F1} {MaxRange 5.0}"),
                Seconds(s));
        }
    }
    all.removeDuplicates();
    QCOMPARE(all.filter("GETGEO").join(", "), QStringLiteral("GETGEO {Type Robot}, GETGEO {Type Sonar}"));
    QCOMPARE(all.filter("GETCONF").size(), 3);
    QVERIFY(all.contains("GETCONF {Type Encoder}") && all.contains("GETCONF {Type Sonar}"));
}

void tst_Equipment::aSensorThatIsNotThereIsNotAskedAgain() {
    Asked asked;
    QStringList all;
    for (double s = 100.0; s < 140.0; s += 0.1) {
        asked.hear({copter}, s, s + 0.05);
        all << asked.at(s); // Nobody answers.
    }
    QCOMPARE(all.count("GETGEO {Type Robot}"), 3);
    QCOMPARE(all.count("GETCONF {Type Robot}"), 3);
}

USAR_TEST(tst_Equipment)

} // namespace tst_equipment

#include "tst_equipment.moc"
