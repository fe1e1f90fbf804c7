#include <QTest>

#include "core/modules/sensor.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_sensor {

using namespace usar;

namespace {

/// A module fed line by line at growing clock times 1, 2, 3 … s.
struct Fed {
    protocol::Reader reader;
    modules::SensorModule sensors;
    double now_s = 0.0;

    explicit Fed(std::initializer_list<const char*> lines) {
        for (const char* line : lines)
            sensors.take(reader.read(line), Seconds(++now_s));
    }
};

} // namespace

class tst_Sensor : public QObject {
    Q_OBJECT
private slots:
    void knowsNothingAtFirst();
    void filesSonarsByName();
    void aNewReadingReplacesTheOldOfItsName();
    void theFirstScannerAnswersToNoName();
    void stampsWithOwnTimeElseWithTheClock();
    void keepsPoseSensorsApart();
    void noNewsReplacesNothing_data();
    void noNewsReplacesNothing();
    void keepsUnknownSensorsByTypeAndName();
    void aDamagedReadingReplacesNoGoodOne();
    void groupedUnknownSensorsDoNotPileUp();
    void tellsSensorsOfOneNameApartByType();
    void aFloodOfNamesIsBounded();
};

void tst_Sensor::knowsNothingAtFirst() {
    const modules::SensorModule sensors;
    QVERIFY(!sensors.sonar("F1") && !sensors.scan() && !sensors.ins() && !sensors.groundTruth());
    QVERIFY(!sensors.odometry() && !sensors.encoder("L") && !sensors.generic("GPS", "GPS"));
    QVERIFY(sensors.all<protocol::SonarReadings>().empty());
}

void tst_Sensor::filesSonarsByName() {
    const Fed fed({"SEN {Time 5} {Type Sonar} {Name F1 Range 4.5} {Name F2 Range 2.5}",
                   "SEN {Time 6} {Type Sonar} {Name Rear} {Range 1.5}"});
    QCOMPARE(fed.sensors.all<protocol::SonarReadings>().size(), std::size_t(3));
    QCOMPARE(fed.sensors.sonar("F2")->value.range_m, 2.5);
    QCOMPARE(fed.sensors.sonar("Rear")->time.count(), 6.0);
    QVERIFY(!fed.sensors.sonar("F3"));
}

void tst_Sensor::aNewReadingReplacesTheOldOfItsName() {
    const Fed fed({"SEN {Time 5} {Type Sonar} {Name F1 Range 4.5} {Name F2 Range 2.5}",
                   "SEN {Time 6} {Type Sonar} {Name F1 Range 4.0}"});
    QCOMPARE(fed.sensors.sonar("F1")->value.range_m, 4.0);
    QCOMPARE(fed.sensors.sonar("F1")->line.value, 2u);
    QCOMPARE(fed.sensors.sonar("F2")->value.range_m, 2.5);
    QCOMPARE(fed.sensors.sonar("F2")->line.value, 1u);
}

void tst_Sensor::theFirstScannerAnswersToNoName() {
    const Fed fed({"SEN {Type RangeScanner} {Name Belly} {Resolution 1} {FOV 2} {Range 1,2,3}",
                   "SEN {Type RangeScanner} {Name Anterior} {Resolution 1} {FOV 2} {Range 4,5,6}"});
    QCOMPARE(fed.sensors.scan()->value.name, std::string("Belly"));
    QCOMPARE(fed.sensors.scan("Anterior")->value.ranges_m[0], 4.0);
    QVERIFY(!fed.sensors.scan("Posterior"));
}

void tst_Sensor::stampsWithOwnTimeElseWithTheClock() {
    const Fed fed({"SEN {Type INS} {Name INS} {Location 1,2,3} {Orientation 0,0,0}",
                   "SEN {Time 77.5} {Type GroundTruth} {Name GT} {Location 1,2,3} {Orientation 0,0,0}"});
    QCOMPARE(fed.sensors.ins()->time.count(), 1.0);
    QCOMPARE(fed.sensors.groundTruth()->time.count(), 77.5);
}

void tst_Sensor::keepsPoseSensorsApart() {
    const Fed fed({"SEN {Type INS} {Name INS} {Location 1,0,0} {Orientation 0,0,0}",
                   "SEN {Time 2} {Type GroundTruth} {Name GT} {Location 2,0,0} {Orientation 0,0,0}",
                   "SEN {Type Odometry} {Name O} {Pose 3,0,0}", "SEN {Type Encoder} {Name L Tick 4} {Name R Tick 5}"});
    QCOMPARE(fed.sensors.ins()->value.base_in_map.position_m.x(), 1.0);
    QCOMPARE(fed.sensors.groundTruth()->value.base_in_map.position_m.x(), 2.0);
    QCOMPARE(fed.sensors.odometry()->value.base_in_start->position_m.x(), 3.0);
    QCOMPARE(fed.sensors.encoder("L")->value.ticks, 4);
    QCOMPARE(fed.sensors.encoder("R")->value.ticks, 5);
}

void tst_Sensor::noNewsReplacesNothing_data() {
    QTest::addColumn<QByteArray>("head");
    QTest::newRow("odometry") << QByteArray("SEN {Time 9} {Type Odometry} ");
    QTest::newRow("tachometer") << QByteArray("SEN {Time 9} {Type Tachometer} {Name T}");
    QTest::newRow("sonar") << QByteArray("SEN {Time 9} {Type Sonar} ");
    QTest::newRow("ground truth") << QByteArray("SEN {Time 9} {Type GroundTruth} ");
}

void tst_Sensor::noNewsReplacesNothing() {
    QFETCH(QByteArray, head);
    Fed fed({"SEN {Type Odometry} {Name O} {Pose 3,0,0}", "SEN {Type Tachometer} {Name T} {Vel 1,2}",
             "SEN {Type Sonar} {Name F1 Range 1}",
             "SEN {Time 2} {Type GroundTruth} {Name GT} {Location 2,0,0} {Orientation 0,0,0}"});
    fed.sensors.take(fed.reader.read(head.toStdString()), Seconds(9));
    QCOMPARE(fed.sensors.odometry()->line.value, 1u);
    QCOMPARE(fed.sensors.newest<protocol::TachometerReading>("T")->line.value, 2u);
    QCOMPARE(fed.sensors.sonar("F1")->line.value, 3u);
    QCOMPARE(fed.sensors.groundTruth()->line.value, 4u);
}

void tst_Sensor::keepsUnknownSensorsByTypeAndName() {
    const Fed fed({"SEN {Type Dosis} {Name A} {Dose 0}", "SEN {Type dosis} {Name A} {Dose 1}",
                   "SEN {Type Dosis} {Name B} {Dose 0}", "EFF {Type Dosis} {Name A} {On}"});
    QCOMPARE(fed.sensors.generic("Dosis", "A")->line.value, 2u);
    QCOMPARE(fed.sensors.generic("DOSIS", "B")->line.value, 3u);
    QVERIFY(!fed.sensors.generic("Dosis", "C"));
}

void tst_Sensor::aDamagedReadingReplacesNoGoodOne() {
    const Fed fed({"SEN {Type INS} {Name INS} {Location 1,2,3} {Orientation 0,0,0}",
                   "SEN {Type INS} {Name INS} {Location 1,nan,3} {Orientation 0,0,0}"});
    QCOMPARE(fed.sensors.ins()->line.value, 1u);
    QCOMPARE(fed.sensors.generic("INS", "INS")->line.value, 2u);
}

void tst_Sensor::groupedUnknownSensorsDoNotPileUp() {
    const Fed fed({"SEN {Type Feeler} {Name Left Feels False} {Name Right Feels False}",
                   "SEN {Type Feeler} {Name Left Feels True} {Name Right Feels False}"});
    QCOMPARE(fed.sensors.generic("Feeler", "Left")->line.value, 2u);
    QVERIFY(!fed.sensors.generic("Feeler", "Left Feels False"));
}

void tst_Sensor::tellsSensorsOfOneNameApartByType() {
    const Fed fed({"SEN {Type RangeScanner} {Name S} {Resolution 0.1} {FOV 0.2} {Range 1,1,1}",
                   "SEN {Type IRScanner} {Name S} {Resolution 0.1} {FOV 0.2} {Range 2,2,2}",
                   "SEN {Type IMU} {Name S} {AngularVel 0,0,0.5}"});
    QCOMPARE(fed.sensors.all<protocol::RangeScan>().size(), std::size_t(2));
    QCOMPARE(fed.sensors.scan("S")->value.ranges_m[0], 1.0);
    QCOMPARE(fed.sensors.all<protocol::RangeScan>()[1].content.value.ranges_m[0], 2.0);
    QCOMPARE(fed.sensors.newest<protocol::ImuReading>()->value.angular_velocity_rad_s->z(), -0.5);
}

void tst_Sensor::aFloodOfNamesIsBounded() {
    Fed fed({});
    for (int i = 0; i < 1000; ++i)
        fed.sensors.take(fed.reader.read("SEN {Type Sonar} {Name S" + std::to_string(i) + " Range 1}"), Seconds(1));
    QCOMPARE(fed.sensors.all<protocol::SonarReadings>().size(), std::size_t(256));
}

USAR_TEST(tst_Sensor)

} // namespace tst_sensor

#include "tst_sensor.moc"
