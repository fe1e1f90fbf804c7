#include <QTest>

#include "core/protocol/dialect_detector.h"
#include "corpus.h"
#include "tests/suite/suite.h"

namespace tst_dialect_detector {

using namespace usar;
using namespace usar::protocol;

namespace {

constexpr const char* ut2004_state = "STA {Type GroundVehicle} {Time 395.38} {FrontSteer 0.0000} {Battery 1200}";
constexpr const char* udk_state = "STA {Time 47.9754} {Battery 1200} {Type GroundVehicle} {LightToggle False}";

QByteArray told(const DialectDetector& detector) {
    if (!detector.dialect())
        return "unknown";
    return *detector.dialect() == Dialect::Udk ? "UDK" : "UT2004";
}

} // namespace

class tst_DialectDetector : public QObject {
    Q_OBJECT
private slots:
    void oneLineIsEnough_data();
    void oneLineIsEnough();
    void anAnswerAboutCamerasTellsNothing_data();
    void anAnswerAboutCamerasTellsNothing();
    void oddLinesDoNotTurnItRound();
    void anotherServerIsNoticed();
    void tellsRecordedSessionsApart();
    void twoConnectionsAtOnceAreToldApart();
};

void tst_DialectDetector::oneLineIsEnough_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const char* line, const char* expected) {
        QTest::newRow(name) << QByteArray(line) << QByteArray(expected);
    };
    row("state, type first", ut2004_state, "UT2004");
    row("state, time first", udk_state, "UDK");
    row("state without anything", "STA", "unknown");
    row("states of objects", "STA {Name Box1} {Size 1,1,1} {Location 1,2,3", "unknown");
    row("a result", "RES {Time 1} {Type INS} {Name INS} {Status OK}", "UT2004");
    row("a package with torque", "MISSTA {Time 1} {Name Pan} {Link 1} {Value 0} {Torque -20}", "UT2004");
    row("a package without torque", "MISSTA {Time 1} {Name Pan} {Link 1} {Value 0}", "unknown");
    row("an actuator", "ASTA {Time 1} {Name Arm} {Link 1} {Value 0}", "UDK");
    row("an effecter", "EFF {Time 1} {Type Gripper} {Name G} {Status OPEN}", "UDK");
    row("a camera nobody asked for", "CONF {Type Camera} {Name Camera}{TextureOffsetX 0}", "UDK");
    row("another configuration", "CONF {Type Sonar} {Name Camera}", "unknown");
    row("a sensor", "SEN {Time 1} {Type Camera} ", "unknown");
    row("the greeting", "NFO {Gametype BotDeathMatch} {Level X} {TimeLimit 0}", "unknown");
    row("nothing", "", "unknown");
    row("no brace at the end", "STA {Type", "UT2004");
    row("odd spacing and case", "sta{type  GroundVehicle}{time 1}", "UT2004");
}

void tst_DialectDetector::oneLineIsEnough() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, expected);
    DialectDetector detector;
    detector.take(line.toStdString());
    QCOMPARE(told(detector), expected);
}

void tst_DialectDetector::anAnswerAboutCamerasTellsNothing_data() {
    QTest::addColumn<bool>("raw");
    QTest::newRow("asked by a program") << false;
    QTest::newRow("asked by a person") << true;
}

void tst_DialectDetector::anAnswerAboutCamerasTellsNothing() {
    QFETCH(bool, raw);
    DialectDetector detector;
    detector.sent(raw ? Command(RawCommand{"getconf {type Camera}"}) : Command(GetConfiguration{"Camera"}));
    detector.take("CONF {Type Camera} {Name Camera} {CameraDefFov 0.8}");
    QCOMPARE(told(detector), QByteArray("unknown"));
}

void tst_DialectDetector::oddLinesDoNotTurnItRound() {
    DialectDetector detector;
    detector.take(ut2004_state);
    for (int round = 0; round < 50; ++round) {
        detector.take(udk_state);
        QCOMPARE(told(detector), QByteArray("UT2004"));
        detector.take(ut2004_state);
        QCOMPARE(told(detector), QByteArray("UT2004"));
    }
}

void tst_DialectDetector::anotherServerIsNoticed() {
    DialectDetector detector;
    for (int line = 0; line < 10000; ++line)
        detector.take(ut2004_state);
    int lines = 0;
    for (; lines < 100 && told(detector) == "UT2004"; ++lines)
        detector.take(udk_state);
    QVERIFY(lines > 3 && lines < 20);
    detector.take(ut2004_state);
    QCOMPARE(told(detector), QByteArray("UDK"));
}

/// The collection's headers name the server where a session was recorded from one.
void tst_DialectDetector::tellsRecordedSessionsApart() {
    std::map<std::string, DialectDetector> detectors;
    for (const corpus::Line& line : corpus::infoLines()) {
        const bool one_server =
            line.source.find("UT2004") == std::string::npos || line.source.find("UDK") == std::string::npos;
        if (line.captured && one_server)
            detectors[line.source].take(line.text);
    }
    for (const auto& [source, detector] : detectors) {
        if (source.find("UT2004") != std::string::npos)
            QCOMPARE(told(detector), QByteArray("UT2004"));
        if (source.find("UDK") != std::string::npos)
            QCOMPARE(told(detector), QByteArray("UDK"));
    }
}

void tst_DialectDetector::twoConnectionsAtOnceAreToldApart() {
    DialectDetector ut2004;
    DialectDetector udk;
    for (int tick = 0; tick < 20; ++tick) {
        ut2004.take(ut2004_state);
        udk.take(udk_state);
    }
    QCOMPARE(told(ut2004), QByteArray("UT2004"));
    QCOMPARE(told(udk), QByteArray("UDK"));
}

USAR_TEST(tst_DialectDetector)

} // namespace tst_dialect_detector

#include "tst_dialect_detector.moc"
