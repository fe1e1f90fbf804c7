// What becomes of malformed info lines: each row of protocol.md 1.6 and 1.7, and a hostile server.
#include <QTest>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/protocol/line_splitter.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_bad_lines {

using namespace usar;
using namespace usar::protocol;

namespace {

QByteArray joined(const GenericMessage& message) {
    QByteArray text = QByteArray::fromStdString(message.type_word);
    for (const KeyValue& segment : message.segments)
        text += "|" + QByteArray::fromStdString(segment.key) + "=" + QByteArray::fromStdString(segment.value);
    return text;
}

} // namespace

class tst_BadLines : public QObject {
    Q_OBJECT
private slots:
    void malformedSegmentsAreRepaired_data();
    void malformedSegmentsAreRepaired();
    void numbersInAllSpellings_data();
    void numbersInAllSpellings();
    void neverInventsAPose_data();
    void neverInventsAPose();
    void aHostileLineCostsOneDiagnostic_data();
    void aHostileLineCostsOneDiagnostic();
    void anEndlessLineIsDroppedAndReadingGoesOn();
};

void tst_BadLines::malformedSegmentsAreRepaired_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("segments");
    QTest::addColumn<int>("diagnostics");
    const auto row = [](const char* name, const char* line, const char* segments, int diagnostics) {
        QTest::newRow(name) << QByteArray(line) << QByteArray(segments) << diagnostics;
    };
    row("unknown type word", "HELLO {A 1}", "HELLO|A=1", 0);
    row("repeated key", "X {A 1} {A 2}", "X|A=1|A=2", 0);
    row("a lone word is a key", "X {abc} {B 2}", "X|abc=|B=2", 0);
    row("a key without a value", "X {Name } {B 2}", "X|Name=|B=2", 0);
    row("missing brace at the end", "X {A 1} {B 2", "X|A=1|B=2", 1);
    row("stray closing brace", "X } {A 1} } {B 2}", "X }|A=1|B=2", 0);
    row("a brace inside", "X {A 1 {B 2}", "X|A=1 {B 2", 1);
    row("braces around nothing", "X {} { } {A 1}", "X|A=1", 0);
    row("no spaces", "X{A 1}{B 2}", "X|A=1|B=2", 0);
    row("double and trailing spaces", "X  {A  1}  {B 2 } ", "X|A=1|B=2", 0);
    row("text between segments", "X {A 1} junk {B 2}", "X|A=1|B=2", 0);
    row("value only", "X {0.785398}", "X|0.785398=", 0);
    row("bytes above 127", "X {Mem caf\xe9}", "X|Mem=caf\xe9", 0);
}

void tst_BadLines::malformedSegmentsAreRepaired() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, segments);
    QFETCH(int, diagnostics);
    Reader reader;
    const InfoLine result = reader.read(line.toStdString());
    QCOMPARE(joined(std::get<GenericMessage>(result.message)), segments);
    QCOMPARE(static_cast<int>(result.diagnostics.size()), diagnostics);
}

void tst_BadLines::numbersInAllSpellings_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<double>("value");
    QTest::addColumn<bool>("clean");
    const auto row = [](const char* name, const char* text, double value, bool clean) {
        QTest::newRow(name) << QByteArray(text) << value << clean;
    };
    const double none = std::nan("");
    row("two decimals", "395.38", 395.38, true);
    row("whole", "1200", 1200.0, true);
    row("negative zero", "-0.00", -0.0, true);
    row("an exponent", "1.16338e-17", 1.16338e-17, true);
    row("leading plus", "+1.5", 1.5, true);
    row("leading dot", ".4", 0.4, true);
    row("leading zeros", "020", 20.0, true);
    row("decimal comma", "1,00", 1.0, false);
    row("junk after the number", "5m", 5.0, false);
    row("a word", "abc", none, false);
    row("nan", "nan", none, false);
    row("INF", "INF", none, false);
    row("Windows: indefinite", "-1.#IND", none, false);
    row("Windows: quiet", "1.#QNAN", none, false);
    row("Windows: infinite", "1.#INF", none, false);
    row("larger than anything sensed", "1e308", none, false);
    row("overflow", "1e999", none, false);
}

void tst_BadLines::numbersInAllSpellings() {
    QFETCH(QByteArray, text);
    QFETCH(double, value);
    QFETCH(bool, clean);
    Reader reader;
    const InfoLine result = reader.read("SEN {Type Sonar} {Name F1} {Range " + text.toStdString() + "}");
    const double range_m = std::get<SonarReadings>(result.message).ranges.front().range_m;
    QVERIFY(std::isnan(value) ? std::isnan(range_m) : range_m == value);
    QCOMPARE(static_cast<int>(result.diagnostics.size()), clean ? 0 : 1);
}

void tst_BadLines::aHostileLineCostsOneDiagnostic_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("a million segments") << QByteArray("SEN {Type X} ") + QByteArray("{A 1} ").repeated(1'000'000);
    QTest::newRow("a million opening braces")
        << QByteArray("SEN {Type X} {A ") + QByteArray("{").repeated(1'000'000) + "}";
    QTest::newRow("a scan of nonsense") << QByteArray(
                                               "SEN {Type RangeScanner} {Name S} {Resolution 0.1} {FOV 1} {Range ") +
                                               QByteArray("NaN,1e308,-,").repeated(50'000) + "1}";
    QTest::newRow("binary") << QByteArray("\x01\x02\xff\xfe\x00\x80{\x03", 8) + QByteArray("}");
    QTest::newRow("one huge number") << QByteArray("STA {Time ") + QByteArray("9").repeated(100'000) + "}";
}

void tst_BadLines::aHostileLineCostsOneDiagnostic() {
    QFETCH(QByteArray, line);
    Reader reader;
    const InfoLine result = reader.read(line.toStdString());
    QCOMPARE(static_cast<int>(result.diagnostics.size()), 1);
    QVERIFY(result.diagnostics.front().message.size() < 200);
    if (const auto* const generic = std::get_if<GenericMessage>(&result.message))
        QVERIFY(generic->segments.size() <= Segments::most_segments);
    const InfoLine next = reader.read("STA {Time 1} {Battery 5}");
    QVERIFY(next.diagnostics.empty());
}

void tst_BadLines::anEndlessLineIsDroppedAndReadingGoesOn() {
    LineSplitter splitter;
    std::vector<std::string> lines;
    const std::string piece(1 << 20, 'x');
    for (int mebibytes = 0; mebibytes < 64; ++mebibytes) {
        splitter.feed(piece, [&](std::string_view line) { lines.emplace_back(line); });
        QVERIFY(splitter.pending().size() <= LineSplitter::default_cap_bytes);
    }
    splitter.feed("\r\nSTA {Time 1}\r\n", [&](std::string_view line) { lines.emplace_back(line); });
    QCOMPARE(splitter.overlongCount(), std::size_t(1));
    QVERIFY(lines == std::vector<std::string>{"STA {Time 1}"});
}

void tst_BadLines::neverInventsAPose_data() {
    QTest::addColumn<QByteArray>("line");
    const auto row = [](const char* name, const char* line) { QTest::newRow(name) << QByteArray(line); };
    row("a missing number", "SEN {Type INS} {Name I} {Location 1,2} {Orientation 0,0,0}");
    row("a number too many", "SEN {Type INS} {Name I} {Location 1,2,3,4} {Orientation 0,0,0}");
    row("not a number", "SEN {Type GroundTruth} {Name G} {Location 1,nan,3} {Orientation 0,0,0}");
    row("infinite", "SEN {Type GroundTruth} {Name G} {Location 1,2,3} {Orientation 0,0,1.#INF}");
    row("junk after a number", "SEN {Type GroundTruth} {Name G} {Location 1,2x,3} {Orientation 0,0,0}");
    row("no orientation", "SEN {Type INS} {Name I} {Location 1,2,3}");
    row("no location", "SEN {Type GroundTruth} {Name I} {Orientation 1,2,3}");
    row("a word", "SEN {Type Odometry} {Name O} {Pose here}");
    row("a start pose cut short", "NFO {StartPoses 1} {A 1,2,3 0,0}");
    row("a start pose with junk", "NFO {StartPoses 1} {A 1,2,3 0,b,0 B 1,2,3 0,0,0}");
    row("a named start pose without orientation", "NFO {StartPoses 1} {Name A Location 1,2,3}");
    row("a mount that is nowhere", "GEO {Type Sonar} {Name F1 Location 1,x,3 Orientation 0,0,0 Mount HARD}");
    row("a mount without location", "GEO {Type Sonar} {Name F1} {Orientation 0,0,0} {Mount HARD}");
    row("a robot without size", "GEO {Type GroundVehicle} {Name P} {Dimensions 1,2}");
    row("a scanner without angles", "SEN {Type RangeScanner} {Name S} {Range 1,2,3}");
    row("a scanner of nan angles", "SEN {Type RangeScanner} {Name S} {FOV nan} {Resolution 1} {Range 1,2,3}");
    row("half a tick", "SEN {Type Encoder} {Name L Tick 1.5}");
    row("a result without status", "RES {Type INS} {Name INS}");
}

void tst_BadLines::neverInventsAPose() {
    QFETCH(QByteArray, line);
    Reader reader;
    const InfoLine result = reader.read(line.toStdString());
    QVERIFY(std::holds_alternative<GenericMessage>(result.message));
    QVERIFY(std::ranges::count(result.diagnostics, Severity::Error, &Diagnostic::severity) >= 1);
    for (const Diagnostic& diagnostic : result.diagnostics)
        QVERIFY(diagnostic.offset <= static_cast<std::size_t>(line.size()));
}

USAR_TEST(tst_BadLines)

} // namespace tst_bad_lines

#include "tst_bad_lines.moc"
