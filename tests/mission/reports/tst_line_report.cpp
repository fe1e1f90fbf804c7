#include <QBuffer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include "core/mission/reports/line_report.h"
#include "tests/suite/suite.h"

namespace tst_line_report {

using namespace usar;
using namespace usar::mission;

namespace {

QJsonObject reportOf(const QByteArray& line) {
    protocol::Reader reader;
    return reportLine(reader, {line.data(), static_cast<std::size_t>(line.size())}, 7);
}

} // namespace

class tst_LineReport : public QObject {
    Q_OBJECT
private slots:
    void saysWhatALineIs_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("direction");
        QTest::addColumn<QString>("type");
        QTest::addColumn<QString>("container");
        const auto row = [](const char* name, const char* line, const char* direction, const char* type,
                            const char* container) {
            QTest::newRow(name) << QByteArray(line) << direction << type << container;
        };
        row("a sensor", "SEN {Type Sonar} {Name F1 Range 1.5}", "in", "SEN Sonar", "SonarReadings");
        row("an unknown sensor", "SEN {Type Geiger} {Name G} {Dose 1}", "in", "SEN Geiger", "GenericMessage");
        row("a state", "STA {Time 1} {Battery 5}", "in", "STA", "RobotState");
        row("a drive", "DRIVE {Left 1.0} {Right 1.0}", "out", "DRIVE", "SkidDrive");
        row("a setting", "SET {Type INS} {Name INS} {Opcode POSE} {Params 1,2,3,0,0,1}", "out", "SET INS",
            "SetInsPose");
        row("any case", "getstartposes", "out", "getstartposes", "GetStartPoses");
        row("a word of no server", "HELLO {World 1}", "in", "HELLO", "GenericMessage");
    }

    void saysWhatALineIs() {
        QFETCH(QByteArray, line);
        QFETCH(QString, direction);
        QFETCH(QString, type);
        QFETCH(QString, container);
        const QJsonObject report = reportOf(line);
        QCOMPARE(report["line"].toInteger(), 7);
        QCOMPARE(report["direction"].toString(), direction);
        QCOMPARE(report["type"].toString(), type);
        QCOMPARE(report["container"].toString(), container);
        QCOMPARE(report["text"].toString(), QString::fromLatin1(line));
        QVERIFY(report["diagnostics"].toArray().isEmpty());
    }

    void fieldsHaveUnitsAndItems() {
        const QJsonArray fields =
            reportOf("SEN {Type Sonar} {Name F1 Range 1.5} {Name F2 Range nan}")["fields"].toArray();
        QCOMPARE(fields[0].toObject(),
                 (QJsonObject{{"item", "F1"}, {"field", "range"}, {"value", 1.5}, {"unit", "m"}}));
        QCOMPARE(fields[1].toObject()["value"].toString(), QString("nan"));
    }

    void diagnosticsSayWhere() {
        const QJsonArray diagnostics = reportOf("STA {Time 1} {Battery abc}")["diagnostics"].toArray();
        QCOMPARE(diagnostics.size(), 1);
        QCOMPARE(diagnostics[0].toObject()["column"].toInteger(), 23);
        QCOMPARE(diagnostics[0].toObject()["severity"].toString(), QString("warning"));
    }

    void numbersTheLinesOfALog() {
        QByteArray log = "# a comment\r\n\r\nSTA {Time 1}\nDRIVE {Left 1}\r\nSEN {Type Sonar} {Name A Range x}";
        QBuffer input(&log);
        QVERIFY(input.open(QIODevice::ReadOnly));
        QByteArray printed;
        QBuffer output(&printed);
        QVERIFY(output.open(QIODevice::WriteOnly));
        const auto counts = reportLines(input, output);
        QVERIFY(counts);
        QCOMPARE(counts->lines, 3u);
        QCOMPARE(counts->with_diagnostics, 1u);
        QList<qint64> numbers;
        for (const QByteArray& json : printed.trimmed().split('\n'))
            numbers.append(QJsonDocument::fromJson(json).object()["line"].toInteger());
        QCOMPARE(numbers, (QList<qint64>{3, 4, 5}));
    }

    void anEndlessLineIsLeftOutAndSaidOnce() {
        QByteArray log = "SEN {Range " + QByteArray(9 << 20, '1') + "}\nSTA {Time 1}\n";
        QBuffer input(&log);
        QVERIFY(input.open(QIODevice::ReadOnly));
        QByteArray printed;
        QBuffer output(&printed);
        QVERIFY(output.open(QIODevice::WriteOnly));
        const auto counts = reportLines(input, output);
        QVERIFY(counts);
        QCOMPARE(counts->lines, 2u);
        QCOMPARE(counts->with_diagnostics, 1u);
        QVERIFY(printed.size() < 4096);
    }
};

USAR_TEST(tst_LineReport)

} // namespace tst_line_report

#include "tst_line_report.moc"
