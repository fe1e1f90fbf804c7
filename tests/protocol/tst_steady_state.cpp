// Reading costs no allocation per line once every kind of line has been seen: counted at the operator itself.
#include <QTest>

#include <string>
#include <vector>

#include "core/protocol/line_splitter.h"
#include "core/protocol/reader.h"
#include "tests/doubles/allocation_counter.h"
#include "tests/suite/suite.h"

namespace tst_steady_state {

using namespace usar;
using namespace usar::protocol;

class tst_SteadyState : public QObject {
    Q_OBJECT
private slots:
    void readingATickAllocatesNothing_data();
    void readingATickAllocatesNothing();
    void theCounterCounts();
};

void tst_SteadyState::readingATickAllocatesNothing_data() {
    QTest::addColumn<QByteArray>("tick");
    QByteArray scan =
        "SEN {Time 395.38} {Type RangeScanner} {Name Scanner1} {Resolution 0.0174} {FOV 3.1415} {Range 1.5";
    for (int beam = 1; beam < 181; ++beam)
        scan += ",2.1924";
    scan += "}\r\n";
    QTest::newRow("UT2004") << QByteArray(
        "SEN {Time 395.6055} {Type Sonar} {Name F1 Range 4.5604} {Name F2 Range 2.4576} {Name F3 Range 1.8846}\r\n" +
        scan +
        "SEN {Type INS} {Name INS} {Location 4.50,1.90,1.80} {Orientation 0.00,0.00,0.00}\r\n"
        "SEN {Type Odometry} {Name Odometry} {Pose 0.0320,0.0000,0.0296}\r\n"
        "SEN {Type Encoder} {Name ECLeft Tick -71} {Name ECRight Tick -38} {Name ECTilt Tick 0}\r\n"
        "SEN {Time 395.9927} {Type VictSensor} {Name VictSensor} {Status NoVictims}\r\n"
        "SEN {Time 395.7716} {Type GroundTruth} {Name GroundTruth} {Location 4.56,1.90,1.85} {Orientation "
        "0,0.01,0.08}\r\n"
        "SEN {Type GPS} {Name GPS} {Fix 0} {Satellites 0}\r\n"
        "MISSTA {Time 395.77} {Name CameraPanTilt} {Link 1} {Value 0.0000} {Torque -20.00} {Link 2} {Value 0.0000} "
        "{Torque -20.00}\r\n"
        "STA {Type GroundVehicle} {Time 395.77} {FrontSteer 0.0000} {RearSteer 0.0000} {LightToggle False} "
        "{LightIntensity 0} {Battery 1200} {View -1}\r\n");
    QTest::newRow("UDK") << QByteArray(
        "STA {Time 223.2125} {Battery 1199} {Type GroundVehicle} {LightToggle False} {LightIntensity 100} {FrontSteer "
        "0} "
        "{RearSteer 0}\r\n"
        "SEN {Time 223.2125} {Type GroundTruth} {Name GndTruth} {Location -1.85,1.01,1.65} {Orientation 0,0,0}\r\n"
        "SEN {Time 223.2125} {Type Odometry} {Name Odometer} {Pose 0.0008,0.0000,-0.0002}\r\n" +
        scan +
        "SEN {Time 223.2125} {Type Camera} \r\n"
        "SEN {Time 223.2125} {Type Tachometer} {Name TachTest} {Vel 0.02,0.01,0.01,0.00} {Pos 0.00,0.00,0.00,0.00}\r\n"
        "SEN {Time 3843.9387} {Type IMU} {Name IMU} {XYZAcceleration 0,0,-0.0000} {AngularVel 0,0,0} {Rotation "
        "0,0,0}\r\n"
        "SEN {Time 223.2125} {Type Encoder} {Name W1} {Tick 0}\r\n"
        "SEN {Time 223.2125} {Type Encoder} {Name W2} {Tick 0}\r\n");
}

void tst_SteadyState::readingATickAllocatesNothing() {
    QFETCH(QByteArray, tick);
    LineSplitter splitter;
    Reader reader;
    std::size_t lines = 0;
    const std::string_view bytes(tick.data(), static_cast<std::size_t>(tick.size()));
    const auto feed = [&] {
        for (std::size_t at = 0; at < bytes.size(); at += 1024)
            splitter.feed(bytes.substr(at, 1024), [&](std::string_view line) {
                reader.read(line);
                ++lines;
            });
    };
    for (int warm_up = 0; warm_up < 3; ++warm_up)
        feed();
    const std::size_t before = allocations;
    lines = 0;
    for (int round = 0; round < 100; ++round)
        feed();
    const std::size_t cost = allocations - before;
    QVERIFY(lines >= 900);
    QCOMPARE(cost, std::size_t(0));
}

void tst_SteadyState::theCounterCounts() {
    const std::size_t before = allocations;
    const std::vector<int> one(1000);
    QCOMPARE(one.size(), std::size_t(1000));
    QVERIFY(allocations > before);
}

USAR_TEST(tst_SteadyState)

} // namespace tst_steady_state

#include "tst_steady_state.moc"
