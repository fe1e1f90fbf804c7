#include <QTest>

#include "core/modules/queued_sensor.h"
#include "core/modules/specific_sensor.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_queued_sensor {

using namespace usar;
using namespace usar::modules;

namespace {

std::string sonars(double front_m, double back_m) {
    return "SEN {Type Sonar} {Name Front Range " + std::to_string(front_m) + "} {Name Back Range " +
           std::to_string(back_m) + "}";
}

} // namespace

class tst_QueuedSensor : public QObject {
    Q_OBJECT
private slots:
    void losesNothingBetweenTwoLooks();
    void eachSensorHasAQueueOfItsOwn();
    void pastItsCapacityTheOldestGoesAndIsCounted();
    void keepsSensorsThatNoTableKnows();
    void bareHeadsAndOtherLinesAreNoReadings();
    void aSpecificSensorHearsItsOwnAlone();
    void aSpecificSensorWithoutANameFollowsAny();
};

void tst_QueuedSensor::losesNothingBetweenTwoLooks() {
    protocol::Reader reader;
    QueuedSensorModule queued;
    for (int i = 1; i <= 5; ++i)
        queued.take(reader.read(sonars(i, 0.5)), Seconds(i));
    const auto front = queued.takeAll<protocol::SonarReadings>("Front");
    QCOMPARE(front.size(), std::size_t(5));
    for (std::size_t i = 0; i < 5; ++i) {
        QCOMPARE(front[i].value.range_m, static_cast<double>(i + 1));
        QCOMPARE(front[i].time.count(), static_cast<double>(i + 1));
        QCOMPARE(front[i].line.value, i + 1);
    }
    QVERIFY(queued.takeAll<protocol::SonarReadings>("Front").empty());
    QCOMPARE(queued.overflowCount(), 0u);
}

void tst_QueuedSensor::eachSensorHasAQueueOfItsOwn() {
    protocol::Reader reader;
    QueuedSensorModule queued;
    queued.take(reader.read(sonars(1, 2)), Seconds(1));
    queued.take(reader.read("SEN {Time 7.5} {Type INS} {Name INS} {Location 1,2,3} {Orientation 0,0,0}"), Seconds(1));
    QCOMPARE(queued.takeAll<protocol::SonarReadings>("Back").size(), std::size_t(1));
    QCOMPARE(queued.takeAll<protocol::SonarReadings>("Front").size(), std::size_t(1));
    const auto ins = queued.takeAll<protocol::InsReading>();
    QCOMPARE(ins.size(), std::size_t(1));
    QCOMPARE(ins[0].time.count(), 7.5);
    QVERIFY(queued.takeAll<protocol::RangeScan>().empty());
}

void tst_QueuedSensor::pastItsCapacityTheOldestGoesAndIsCounted() {
    protocol::Reader reader;
    QueuedSensorModule queued;
    for (std::size_t i = 0; i < QueuedSensorModule::capacity + 3; ++i)
        queued.take(reader.read("SEN {Type Encoder} {Name L Tick " + std::to_string(i) + "}"), Seconds(1));
    QCOMPARE(queued.overflowCount(), 3u);
    const auto ticks = queued.takeAll<protocol::EncoderReadings>("L");
    QCOMPARE(ticks.size(), QueuedSensorModule::capacity);
    QCOMPARE(ticks.front().value.ticks, 3);
}

void tst_QueuedSensor::keepsSensorsThatNoTableKnows() {
    protocol::Reader reader;
    QueuedSensorModule queued;
    queued.take(reader.read("SEN {Type Geiger} {Name G} {Dose 1}"), Seconds(1));
    queued.take(reader.read("SEN {Type Geiger} {Name G} {Dose 2}"), Seconds(2));
    const auto doses = queued.takeAllGeneric("geiger", "G");
    QCOMPARE(doses.size(), std::size_t(2));
    QCOMPARE(doses[1].value.segments.back().value, std::string("2"));
}

void tst_QueuedSensor::bareHeadsAndOtherLinesAreNoReadings() {
    protocol::Reader reader;
    QueuedSensorModule queued;
    queued.take(reader.read("SEN {Time 9} {Type Odometry} "), Seconds(1));
    queued.take(reader.read("STA {Time 9} {Battery 5}"), Seconds(1));
    QVERIFY(queued.takeAll<protocol::OdometryReading>().empty());
    QVERIFY(queued.takeAllGeneric("Odometry", "").empty());
}

void tst_QueuedSensor::aSpecificSensorHearsItsOwnAlone() {
    protocol::Reader reader;
    SpecificSensor<protocol::SonarReadings> back("Back");
    QVERIFY(!back.newest());
    QVERIFY(back.take(reader.read(sonars(1, 2)), Seconds(3)));
    QVERIFY(!back.take(reader.read("SEN {Type Sonar} {Name Front Range 9}"), Seconds(4)));
    QVERIFY(!back.take(reader.read("SEN {Type IR} {Name Back Range 9}"), Seconds(4)));
    QCOMPARE(back.newest()->value.range_m, 2.0);
    QCOMPARE(back.newest()->time.count(), 3.0);
    QCOMPARE(back.count(), 1u);
}

void tst_QueuedSensor::aSpecificSensorWithoutANameFollowsAny() {
    protocol::Reader reader;
    SpecificSensor<protocol::BallReading> ball;
    QVERIFY(ball.take(reader.read("SEN {Type Helper} {Name ballHelper} {Pos3D 1,2,3} {Visible true}"), Seconds(1)));
    QVERIFY(*ball.newest()->value.visible);
}

USAR_TEST(tst_QueuedSensor)

} // namespace tst_queued_sensor

#include "tst_queued_sensor.moc"
