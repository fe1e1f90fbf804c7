#include <QBuffer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "core/mission/reports/line_report.h"
#include "tests/suite/suite.h"

namespace tst_line_report {

using namespace usar;
using namespace usar::mission;

namespace {

QJsonObject reportOf(const QByteArray& line) {
    protocol::Reader reader;
    std::string out;
    const bool has_diagnostics = reportLine(reader, {line.data(), static_cast<std::size_t>(line.size())}, 7, out);
    const QJsonObject report = QJsonDocument::fromJson(QByteArray::fromStdString(out)).object();
    if (report.isEmpty() || has_diagnostics == report["diagnostics"].toArray().isEmpty())
        return {}; // no JSON, or not what it says
    return report;
}

Result<LineCounts> reported(QByteArray log, QByteArray& printed) {
    QBuffer input(&log);
    QBuffer output(&printed);
    if (!input.open(QIODevice::ReadOnly) || !output.open(QIODevice::WriteOnly))
        return failure("a buffer cannot be opened", "", "");
    return reportLines(input, output);
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

    void aScanHasItsTimeAndAllItsBeams() {
        const QJsonObject report = reportOf("SEN {Time 395.38} {Type RangeScanner} {Name Scanner1} {Resolution 0.0174} "
                                            "{FOV 3.1415} {Range 2.1924,2.1961,nan,20.0000}");
        QCOMPARE(report["time"].toDouble(), 395.38);
        const QJsonArray fields = report["fields"].toArray();
        QCOMPARE(fields.last().toObject(), (QJsonObject{{"item", "Scanner1"},
                                                        {"field", "values"},
                                                        {"unit", "m"},
                                                        {"values", QJsonArray{2.1924, 2.1961, "nan", 20.0}}}));
        QVERIFY(!reportOf("SEN {Type INS} {Name INS} {Location 1,2,3} {Orientation 0,0,0}").contains("time"));
    }

    void noWordIsDropped_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QJsonArray>("unread");
        const auto word = [](const char* key, const char* value) {
            return QJsonObject{{"key", key}, {"value", value}};
        };
        QTest::newRow("all known") << QByteArray("SEN {Type Sonar} {Name F1 Range 1.5}") << QJsonArray();
        QTest::newRow("in a segment of its own")
            << QByteArray("SEN {Type INS} {Name I} {Location 1,2,3} {Orientation 0,0,0} {Wobble 4}")
            << QJsonArray{word("Wobble", "4")};
        QTest::newRow("in a pair") << QByteArray("SEN {Type Sonar} {Name F1 Range 1.5 Echo 7}")
                                   << QJsonArray{word("Echo", "7")};
        QTest::newRow("the ball's place in the picture")
            << QByteArray("SEN {Type Helper} {Name b} {Pos3D 1,0,0} {Visible true} {Pos2D 0.5,-0.25} {Radius 0.1}")
            << QJsonArray();
        QTest::newRow("an unknown sensor keeps all as fields")
            << QByteArray("SEN {Type Geiger} {Dose 1} {X 2}") << QJsonArray();
    }
    void noWordIsDropped() {
        QFETCH(const QByteArray, line);
        QFETCH(const QJsonArray, unread);
        QCOMPARE(reportOf(line)["unread"].toArray(), unread);
    }

    void bytesBeyondAsciiAndQuotesStayValidJson() {
        const QByteArray line = "SEN {Type Geiger} {Name \"G\\1\"} {Word caf\xe9\x01}";
        QCOMPARE(reportOf(line)["text"].toString(), QString::fromLatin1(line));
    }

    void diagnosticsSayWhere() {
        const QJsonArray diagnostics = reportOf("STA {Time 1} {Battery abc}")["diagnostics"].toArray();
        QCOMPARE(diagnostics.size(), 1);
        QCOMPARE(diagnostics[0].toObject()["column"].toInteger(), 23);
        QCOMPARE(diagnostics[0].toObject()["severity"].toString(), QString("warning"));
    }

    void numbersTheLinesOfALog() {
        QByteArray log = "# a comment\r\n\r\nSTA {Time 1}\nDRIVE {Left 1}\r\nSEN {Type Sonar} {Name A Range x}";
        QByteArray printed;
        const auto counts = reported(log, printed);
        QVERIFY(counts);
        QCOMPARE(counts->lines, 3u);
        QCOMPARE(counts->with_diagnostics, 1u);
        QList<qint64> numbers;
        for (const QByteArray& json : printed.trimmed().split('\n'))
            numbers.append(QJsonDocument::fromJson(json).object()["line"].toInteger());
        QCOMPARE(numbers, (QList<qint64>{3, 4, 5}));
    }

    void aLogOfManyBlocksKeepsItsOrder() {
        constexpr int lines = 200'000; // 5 MB, which all cores share
        QByteArray log;
        for (int i = 1; i <= lines; ++i)
            log += "STA {Time " + QByteArray::number(i) + "} {Battery 7}\n";
        QByteArray printed;
        const auto counts = reported(log, printed);
        QVERIFY(counts);
        QCOMPARE(counts->lines, quint64{lines});
        QCOMPARE(counts->with_diagnostics, 0u);
        int number = 0;
        for (const QByteArray& json : printed.trimmed().split('\n')) {
            ++number;
            QVERIFY2(json.startsWith("{\"line\":" + QByteArray::number(number) + ",") &&
                         json.contains("\"text\":\"STA {Time " + QByteArray::number(number) + "} "),
                     json);
        }
        QCOMPARE(number, lines);
    }

    void anEndlessLineIsLeftOutAndSaidOnce() {
        QByteArray log = "SEN {Range " + QByteArray(9 << 20, '1') + "}\nSTA {Time 1}\n";
        QByteArray printed;
        const auto counts = reported(log, printed);
        QVERIFY(counts);
        QCOMPARE(counts->lines, 2u);
        QCOMPARE(counts->with_diagnostics, 1u);
        QVERIFY(printed.size() < 4096);
    }
};

USAR_TEST(tst_LineReport)

} // namespace tst_line_report

#include "tst_line_report.moc"
