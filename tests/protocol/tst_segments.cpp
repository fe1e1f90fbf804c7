#include <QTest>

#include <cmath>

#include "core/base/numbers.h"
#include "core/base/random.h"
#include "core/protocol/segments.h"
#include "tests/suite/suite.h"

namespace tst_segments {

using namespace usar;
using namespace std::string_literals;
using protocol::NamedPairs;
using protocol::Segments;

namespace {

/// "WORD|key=value|key=value", and what was wrong after "!": one letter a diagnostic (N, W, E).
QByteArray summary(const std::string& line) {
    Segments segments;
    Diagnostics diagnostics;
    segments.read(line, diagnostics);
    std::string text(segments.typeWord());
    for (const protocol::Segment& segment : segments.all())
        text += "|" + std::string(segment.key) + "=" + std::string(segment.value);
    for (const Diagnostic& diagnostic : diagnostics)
        text += std::string("!") + "NWE"[static_cast<int>(diagnostic.severity)];
    return QByteArray::fromStdString(text);
}

} // namespace

class tst_Segments : public QObject {
    Q_OBJECT
private slots:
    void cutsALineAsServersDo_data();
    void cutsALineAsServersDo();
    void findsTheFirstKeyInAnyCase();
    void readsNumbersFromTheStartOfAValue_data();
    void readsNumbersFromTheStartOfAValue();
    void knowsWhereEachSegmentStarts();
    void tellsPairsFromValuesWithSpaces_data();
    void tellsPairsFromValuesWithSpaces();
    void survivesAnyBytes();
};

void tst_Segments::cutsALineAsServersDo_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const char* line, const char* expected) {
        QTest::newRow(name) << QByteArray(line) << QByteArray(expected);
    };
    row("type word alone", "GETSTARTPOSES", "GETSTARTPOSES");
    row("nothing", "", "");
    row("no space before the first brace", "INIT{ClassName X}", "INIT|ClassName=X");
    row("two spaces before the first brace", "GEO  {Name P3AT} ", "GEO|Name=P3AT");
    row("no space between segments", "A {B 1}{C 2}", "A|B=1|C=2");
    row("several spaces between segments", "A {B 1}   {C 2}", "A|B=1|C=2");
    row("text between segments", "A {B 1} stray {C 2} tail", "A|B=1|C=2");
    row("two commands on one line", "DRIVE {Left 1}DRIVE {Left 2}", "DRIVE|Left=1|Left=2");
    row("spaces inside", "A {  Pose   0.0,0.0  }", "A|Pose=0.0,0.0");
    row("a tab separates too", "A {Pose\t1}", "A|Pose=1");
    row("value with spaces", "RES {Mem visited by robot 2}", "RES|Mem=visited by robot 2");
    row("lone word", "SEN {None} {Far}", "SEN|None=|Far=");
    row("key with empty value", "GETGEO {Name } {Type X}", "GETGEO|Name=|Type=X");
    row("repeated keys keep their order", "M {Link 1} {Value 0} {Link 2} {Value 3}", "M|Link=1|Value=0|Link=2|Value=3");
    row("braces around nothing", "A {} {  } {B 1}", "A|B=1");
    row("stray closing brace", "A } {B 1} } {C 2}}", "A }|B=1|C=2");
    row("closing brace missing at the end", "INIT {Name r} {Rotation 0,0,0", "INIT|Name=r|Rotation=0,0,0!W");
    row("nothing after an opening brace", "INIT {Name r} {", "INIT|Name=r!W");
    row("brace inside a segment", "C {A 1 {B 2} {D 3}", "C|A=1 {B 2|D=3!W");
    row("value only", "SET {0.785398}", "SET|0.785398=");
    row("semicolon list without key", "SEN {1,2,3;4,5,6}", "SEN|1,2,3;4,5,6=");
}

void tst_Segments::cutsALineAsServersDo() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, expected);
    QCOMPARE(summary(line.toStdString()), expected);
}

void tst_Segments::findsTheFirstKeyInAnyCase() {
    Segments segments;
    Diagnostics diagnostics;
    segments.read("DRIVE {LEFT 1} {left 2}", diagnostics);
    QVERIFY(segments.find("Left"));
    QCOMPARE(std::string(segments.value("Left")), std::string("1"));
    QVERIFY(!segments.find("Right"));
    QVERIFY(!segments.find("Lef"));
    QVERIFY(segments.value("Right").empty());
}

void tst_Segments::readsNumbersFromTheStartOfAValue_data() {
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<bool>("is_number");
    QTest::addColumn<double>("number");
    QTest::newRow("plain") << QByteArray("1.5") << true << 1.5;
    QTest::newRow("decimal comma") << QByteArray("1,00") << true << 1.0;
    QTest::newRow("word") << QByteArray("abc") << false << 0.0;
    QTest::newRow("empty") << QByteArray("") << false << 0.0;
    QTest::newRow("nan") << QByteArray("-1.#IND") << true << qQNaN();
}

void tst_Segments::readsNumbersFromTheStartOfAValue() {
    QFETCH(QByteArray, value);
    QFETCH(bool, is_number);
    QFETCH(double, number);
    const std::string line = "A {B " + value.toStdString() + "}";
    Segments segments;
    Diagnostics diagnostics;
    segments.read(line, diagnostics);
    const NumberPrefix read = readNumberPrefix(segments.value("B"));
    QCOMPARE(read.used > 0, is_number);
    if (is_number)
        QVERIFY(read.value == number || (std::isnan(read.value) && std::isnan(number)));
    QVERIFY(readNumberPrefix(segments.value("missing")).used == 0);
}

void tst_Segments::knowsWhereEachSegmentStarts() {
    const std::string line = "STA {Type X} { Time 3}";
    Segments segments;
    Diagnostics diagnostics;
    segments.read(line, diagnostics);
    QCOMPARE(segments.all()[0].offset, std::size_t(5));
    QCOMPARE(segments.all()[1].offset, std::size_t(14));
    QCOMPARE(line.substr(segments.offsetOf(segments.value("Time"))), std::string("3}"));
}

void tst_Segments::tellsPairsFromValuesWithSpaces_data() {
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<QByteArray>("expected");
    QTest::newRow("one pair") << QByteArray("F1 Range 4.56") << QByteArray("F1|Range=4.56");
    QTest::newRow("three pairs") << QByteArray("F2 Location 1,2,3 Orientation 0,0,1 Mount HARD")
                                 << QByteArray("F2|Location=1,2,3|Orientation=0,0,1|Mount=HARD");
    QTest::newRow("a name alone") << QByteArray("Scanner1") << QByteArray("Scanner1");
    QTest::newRow("two words are a name with a space") << QByteArray("left one") << QByteArray("left one");
    QTest::newRow("a start pose called Name") << QByteArray("1,2,3 0,0,0") << QByteArray("1,2,3 0,0,0");
    QTest::newRow("numbers are no keys") << QByteArray("a 1 2") << QByteArray("a 1 2");
    QTest::newRow("spaces all over") << QByteArray("F1   Tick\t-3") << QByteArray("F1|Tick=-3");
    QTest::newRow("nothing") << QByteArray("") << QByteArray("");
}

void tst_Segments::tellsPairsFromValuesWithSpaces() {
    QFETCH(QByteArray, value);
    QFETCH(QByteArray, expected);
    const std::string text = value.toStdString();
    NamedPairs pairs(text);
    std::string seen(pairs.name());
    std::string_view key;
    std::string_view pair_value;
    while (pairs.next(key, pair_value))
        seen += "|" + std::string(key) + "=" + std::string(pair_value);
    QCOMPARE(QByteArray::fromStdString(seen), expected);
}

void tst_Segments::survivesAnyBytes() {
    Random random = seeded(12, 1);
    const std::string alphabet = "{} \t\0,.-ab1\xff\\\""s;
    Segments segments;
    for (int round = 0; round < 20000; ++round) {
        std::string line(random() % 40, ' ');
        for (char& c : line)
            c = alphabet[random() % alphabet.size()];
        Diagnostics diagnostics;
        segments.read(line, diagnostics);
        for (const protocol::Segment& segment : segments.all()) {
            QVERIFY(!segment.key.empty());
            QVERIFY(segment.text.find('}') == std::string_view::npos);
            QCOMPARE(line.compare(segment.offset, segment.text.size(), segment.text), 0);
        }
    }
}

USAR_TEST(tst_Segments)

} // namespace tst_segments

#include "tst_segments.moc"
