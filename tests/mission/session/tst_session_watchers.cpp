#include <cmath>
#include <set>

#include <QTest>

#include "core/mission/session/incoming.h"
#include "core/mission/session/stream_name.h"
#include "core/mission/session/vigil.h"
#include "tests/suite/suite.h"

namespace tst_session_watchers {

using namespace usar;
using namespace usar::mission;

namespace {

protocol::InfoLine line(std::uint64_t number, protocol::InfoMessage message, const std::string& complaint = {}) {
    protocol::InfoLine result{{number}, "SEN {Type Sonar} {Name F1 Range nan}", std::move(message), {}};
    if (!complaint.empty())
        result.diagnostics.push_back({Severity::Warning, 0, complaint});
    return result;
}

} // namespace

class tst_SessionWatchers : public QObject {
    Q_OBJECT
private slots:
    void aSilentSensorIsReportedOncePerSilence() {
        SensorWatch watch(Seconds{3.0});
        watch.saw(protocol::InsReading{}, Seconds{10.0});
        watch.saw(protocol::RangeScan{}, Seconds{12.0});
        QCOMPARE(watch.newlySilent(Seconds{13.0}), std::vector<std::string>{});
        QCOMPARE(watch.newlySilent(Seconds{13.2}), std::vector<std::string>{"INS"});
        QCOMPARE(watch.newlySilent(Seconds{14.0}), std::vector<std::string>{});
        QCOMPARE(watch.saw(protocol::InsReading{}, Seconds{14.0}), std::vector<std::string>{"INS"});
        QCOMPARE(watch.saw(protocol::InsReading{}, Seconds{14.1}), std::vector<std::string>{});
        QCOMPARE(watch.newlySilent(Seconds{17.2}), (std::vector<std::string>{"INS", "RangeScanner"}));
    }

    void aSensorHeardBeforeTheClockIsNotSilentForHours() {
        SensorWatch watch(Seconds{3.0});
        watch.saw(protocol::InsReading{}, Seconds{0.0});
        QCOMPARE(watch.newlySilent(Seconds{7200.0}), std::vector<std::string>{});
        QCOMPARE(watch.newlySilent(Seconds{7203.2}), std::vector<std::string>{"INS"});
    }

    void oneDeadSonarOfManyIsNamed() {
        SensorWatch watch(Seconds{3.0});
        watch.saw(protocol::SonarReadings{.ranges = {{"F1", 5.0}, {"F2", 4.0}, {"F3", 3.0}}}, Seconds{10.0});
        watch.saw(protocol::SonarReadings{.ranges = {{"F1", 5.0}, {"F2", std::nan("")}}}, Seconds{14.0});
        QCOMPARE(watch.newlySilent(Seconds{14.0}), (std::vector<std::string>{"Sonar F2", "Sonar F3"}));
        QCOMPARE(watch.saw(protocol::SonarReadings{.ranges = {{"F3", 3.0}}}, Seconds{15.0}),
                 std::vector<std::string>{"Sonar F3"});
    }

    void sensorsAreToldApartByName() {
        SensorWatch watch(Seconds{3.0});
        watch.saw(protocol::RangeScan{.name = "Belly"}, Seconds{10.0});
        watch.saw(protocol::RangeScan{.name = "Front"}, Seconds{10.0});
        watch.saw(protocol::RangeScan{.name = "Front", .type = "IRScanner"}, Seconds{14.0});
        watch.saw(protocol::RangeScan{.name = "Belly"}, Seconds{14.0});
        QCOMPARE(watch.newlySilent(Seconds{14.0}), std::vector<std::string>{"RangeScanner Front"});
    }

    void unknownTypesAreWatchedToo() {
        SensorWatch watch(Seconds{3.0});
        watch.saw(protocol::GenericMessage{.type_word = "SEN", .type = "Geiger", .name = "Nose"}, Seconds{1.0});
        QCOMPARE(watch.newlySilent(Seconds{5.0}), std::vector<std::string>{"Geiger Nose"});
    }

    void typesThatSpeakOnlyOnEventsAreNot_data() {
        QTest::addColumn<QString>("type_word");
        QTest::addColumn<QString>("type");
        QTest::newRow("RFID, on change") << "SEN"
                                         << "RFID";
        QTest::newRow("victims in any case") << "SEN"
                                             << "victsensor";
        QTest::newRow("a damaged line of a known sensor") << "SEN"
                                                          << "Sonar";
        QTest::newRow("no sensor at all") << "MISSTA"
                                          << "MisPkg";
        QTest::newRow("without a type") << "SEN"
                                        << "";
    }

    void typesThatSpeakOnlyOnEventsAreNot() {
        QFETCH(QString, type_word);
        QFETCH(QString, type);
        SensorWatch watch(Seconds{3.0});
        watch.saw(protocol::GenericMessage{.type_word = type_word.toStdString(), .type = type.toStdString()},
                  Seconds{1.0});
        QVERIFY(watch.newlySilent(Seconds{100.0}).empty());
    }

    void onlySensorsThatSpokeAreMissed() {
        SensorWatch watch(Seconds{3.0});
        watch.saw(protocol::RobotState{}, Seconds{1.0});
        QVERIFY(watch.newlySilent(Seconds{100.0}).empty());
        watch.saw(protocol::InsReading{}, Seconds{100.0});
        watch.reset();
        QVERIFY(watch.newlySilent(Seconds{200.0}).empty());
    }

    void thereIsAnEndOfSensors() {
        SensorWatch watch(Seconds{3.0});
        for (int i = 0; i < 1000; ++i)
            watch.saw(protocol::RangeScan{.name = "x" + std::to_string(i)}, Seconds{1.0});
        QCOMPARE(watch.newlySilent(Seconds{100.0}).size(), SensorWatch::sensor_limit);
    }

    void eachKindOfDamageIsSaidOnceAndAllAreCounted() {
        ComplaintBook book;
        const auto first = book.take(line(7, protocol::SonarReadings{}, "Range of \"F1\" is 1.#QNAN"));
        QVERIFY(first);
        QVERIFY2(first->text.find("Line 7 ") != std::string::npos, first->text.c_str());
        QVERIFY2(first->text.find("Range of \"F1\" is 1.#QNAN") != std::string::npos, first->text.c_str());
        QVERIFY(!book.take(line(8, protocol::SonarReadings{}, "Range of \"F2\" is 1.#QNAN")));
        const auto unclosed = book.take(line(9, protocol::SonarReadings{}, "no closing brace"));
        const auto unclosed_scan = book.take(line(10, protocol::RangeScan{}, "no closing brace"));
        QVERIFY(unclosed && unclosed_scan);
        const std::set<std::string> kinds{first->kind, unclosed->kind, unclosed_scan->kind};
        QCOMPARE(kinds.size(), std::size_t(3));
        QVERIFY(!book.take(line(11, protocol::RangeScan{})));
        QCOMPARE(book.count(), std::uint64_t(4));
    }

    void notesAreNoComplaints() {
        ComplaintBook book;
        protocol::InfoLine noted = line(1, protocol::RobotState{});
        noted.diagnostics.push_back({Severity::Note, 0, "an unknown key"});
        QVERIFY(!book.take(noted));
        QCOMPARE(book.count(), std::uint64_t(0));
    }

    void whatIsNoMessageAtAllIsAComplaint() {
        ComplaintBook book;
        QVERIFY(book.take(line(1, protocol::GenericMessage{.type_word = "1.2,3.4}"})));
        QVERIFY(book.take(line(2, protocol::GenericMessage{})) == std::nullopt); // the same kind: no message
        QVERIFY(!book.take(line(3, protocol::GenericMessage{.type_word = "MISSTA"})));
        QCOMPARE(book.count(), std::uint64_t(2));
    }

    void thereIsAnEndOfComplaints() {
        ComplaintBook book;
        std::size_t said = 0;
        for (std::uint64_t i = 0; i < 100; ++i)
            said += book.take(line(i, protocol::RobotState{}, std::string(i + 1, 'x'))) ? 1 : 0;
        QCOMPARE(said, ComplaintBook::kind_limit);
        QCOMPARE(book.count(), std::uint64_t(100));
    }

    void excerptsStayPlainAndShort() {
        ComplaintBook book;
        protocol::InfoLine garbled = line(1, protocol::RobotState{}, "garbled");
        garbled.text = "STA {Ti\x01\xff" + std::string(5000, 'a');
        const auto said = book.take(garbled);
        QVERIFY(said);
        QVERIFY(said->text.size() < 250);
        QVERIFY2(said->text.find("STA {Ti??aaa") != std::string::npos, said->text.c_str());
    }

    void streamsAreNamedInTheWordsOfTheWire() {
        QCOMPARE(streamName(protocol::RobotState{}), std::string("STA"));
        QCOMPARE(streamName(protocol::SonarReadings{}), std::string("SEN Sonar"));
        QCOMPARE(streamName(protocol::RangeScan{.type = "IRScanner"}), std::string("SEN IRScanner"));
        QCOMPARE(streamName(protocol::GenericMessage{.type_word = "SEN", .type = "RFID"}), std::string("SEN RFID"));
        QCOMPARE(streamName(protocol::GenericMessage{.type_word = "MISSTA"}), std::string("MISSTA"));
    }

    void gameInfoIsNoRobotData() {
        QVERIFY(!isRobotData(protocol::GameInfo{}));
        QVERIFY(!isRobotData(protocol::StartPoses{}));
        QVERIFY(!isRobotData(protocol::GenericMessage{.type_word = "CONF"}));
        QVERIFY(isRobotData(protocol::GenericMessage{.type_word = "sen"}));
        QVERIFY(isRobotData(protocol::InsReading{}));
    }
};

USAR_TEST(tst_SessionWatchers)

} // namespace tst_session_watchers

#include "tst_session_watchers.moc"
