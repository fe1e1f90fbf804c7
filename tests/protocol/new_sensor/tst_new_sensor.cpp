// Adds a sensor as anybody would, by a file and a row of the table, and uses it everywhere a known one is used. The row
// is put into a copy of the table, with which core/protocol and core/modules are built once more.
#include <QTest>

#include "core/modules/queued_sensor.h"
#include "core/modules/sensor.h"
#include "core/modules/specific_sensor.h"
#include "core/protocol/command_grammar.h"
#include "core/protocol/fields.h"
#include "core/protocol/reader.h"
#include "core/protocol/writer.h"
#include "tests/suite/suite.h"

using namespace usar;
using namespace usar::protocol;

namespace {

constexpr const char* line = "SEN {Time 4.5} {Type Geiger} {Name G1} {Dose 0.25} {Source 1,2,3}";

} // namespace

class tst_NewSensor : public QObject {
    Q_OBJECT
private slots:
    void isReadIntoItsContainer();
    void isListedForPanelsAndPlots();
    void isWrittenByAServer();
    void isFiledByTheModules();
    void isOfferedToWhoeverAsks();
    void theOthersStayAsTheyAre();
};

void tst_NewSensor::isReadIntoItsContainer() {
    Reader reader;
    const InfoLine& result = reader.read(line);
    QVERIFY(result.diagnostics.empty());
    QVERIFY(std::get<GeigerReading>(result.message) ==
            (GeigerReading{Seconds(4.5), "G1", 0.25, Vec3(1.0, -2.0, -3.0)}));
}

void tst_NewSensor::isListedForPanelsAndPlots() {
    Reader reader;
    const std::vector<Field> fields = fieldsOf(reader.read(line).message);
    QCOMPARE(fields.size(), std::size_t(4));
    QCOMPARE(fields[0].path(), std::string("SEN Geiger/G1/dose"));
    QCOMPARE(fields[0].unit, std::string("Gy"));
    QCOMPARE(fields[3].path(), std::string("SEN Geiger/G1/source.z"));
    QCOMPARE(*fields[3].number, -3.0);
}

void tst_NewSensor::isWrittenByAServer() {
    std::string written;
    write(GeigerReading{Seconds(4.5), "G1", 0.25, std::nullopt}, written);
    QCOMPARE(written, std::string("SEN {Time 4.5000} {Type Geiger} {Name G1} {Dose 0.2500}"));
}

void tst_NewSensor::isFiledByTheModules() {
    Reader reader;
    modules::SensorModule newest;
    modules::QueuedSensorModule queued;
    modules::SpecificSensor<GeigerReading> geiger("G1");
    const InfoLine& result = reader.read(line);
    newest.take(result, Seconds(9));
    queued.take(result, Seconds(9));
    QVERIFY(geiger.take(result, Seconds(9)));
    QCOMPARE(newest.newest<GeigerReading>("G1")->value.dose_gy, 0.25);
    QCOMPARE(newest.newest<GeigerReading>("G1")->time.count(), 4.5);
    QCOMPARE(queued.takeAll<GeigerReading>("G1").size(), std::size_t(1));
    QCOMPARE(geiger.newest()->value.dose_gy, 0.25);
}

void tst_NewSensor::isOfferedToWhoeverAsks() {
    const std::vector<Completion> offered = completionsAt("GETGEO {Type gei", 16);
    QCOMPARE(offered.size(), std::size_t(1));
    QCOMPARE(offered[0].text, std::string("Geiger"));
}

void tst_NewSensor::theOthersStayAsTheyAre() {
    Reader reader;
    QVERIFY(std::holds_alternative<SonarReadings>(reader.read("SEN {Type Sonar} {Name F1 Range 1}").message));
    QVERIFY(std::holds_alternative<GenericMessage>(reader.read("SEN {Type Other} {Name X} {Dose 1}").message));
}

USAR_TEST(tst_NewSensor)
#include "tst_new_sensor.moc"
