// Small helpers for text, quoted bytes, spans of time and positions of problems.
#include <limits>

#include <QTest>

#include "core/base/clock.h"
#include "core/base/diagnostics.h"
#include "core/base/quoted_text.h"
#include "core/base/random.h"
#include "core/base/stick.h"
#include "core/base/text.h"
#include "core/base/type_name.h"
#include "tests/suite/suite.h"

namespace tst_text {

using namespace usar;

namespace {

QByteArray bytesOf(std::string_view text) {
    return QByteArray(text.data(), static_cast<qsizetype>(text.size()));
}

std::string_view viewOf(const QByteArray& bytes) {
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

constexpr double nan_share = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

} // namespace

class tst_Text : public QObject {
    Q_OBJECT
private slots:
    void wordsAreComparedWithoutCase_data() {
        QTest::addColumn<QByteArray>("a");
        QTest::addColumn<QByteArray>("b");
        QTest::addColumn<bool>("same");
        QTest::newRow("equal") << QByteArray("Sonar") << QByteArray("Sonar") << true;
        QTest::newRow("another case") << QByteArray("Sonar") << QByteArray("sONAR") << true;
        QTest::newRow("nothing and nothing") << QByteArray() << QByteArray() << true;
        QTest::newRow("one letter more") << QByteArray("Sonar") << QByteArray("Sonars") << false;
        QTest::newRow("another letter") << QByteArray("Sonar") << QByteArray("Solar") << false;
        QTest::newRow("brackets and braces are 32 apart, too") << QByteArray("[") << QByteArray("{") << false;
        QTest::newRow("at sign and backquote") << QByteArray("@") << QByteArray("`") << false;
        QTest::newRow("digits and underscores") << QByteArray("a_1") << QByteArray("A_1") << true;
        QTest::newRow("letters beyond ASCII keep their case") << QByteArray("\xc9") << QByteArray("\xe9") << false;
    }

    void wordsAreComparedWithoutCase() {
        QFETCH(QByteArray, a);
        QFETCH(QByteArray, b);
        QFETCH(bool, same);
        QCOMPARE(sameWord(viewOf(a), viewOf(b)), same);
        QCOMPARE(sameWord(viewOf(b), viewOf(a)), same);
        QCOMPARE(lowerCase(viewOf(a)) == lowerCase(viewOf(b)), same);
    }

    void spacesAroundATextGo_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("expected");
        QTest::newRow("nothing") << QByteArray() << QByteArray();
        QTest::newRow("spaces only") << QByteArray(" \t\r\n\v\f") << QByteArray();
        QTest::newRow("on both sides") << QByteArray("  a b\r\n") << QByteArray("a b");
        QTest::newRow("none") << QByteArray("a  b") << QByteArray("a  b");
        QTest::newRow("a zero byte is no space") << QByteArray(" \0 ", 3) << QByteArray("\0", 1);
    }

    void spacesAroundATextGo() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, expected);
        QCOMPARE(bytesOf(trimmed(viewOf(text))), expected);
    }

    void wordsAreTakenOneByOne() {
        std::string_view rest = "  SEN\t{Type  Sonar}\n";
        QCOMPARE(bytesOf(takeWord(rest)), QByteArray("SEN"));
        QCOMPARE(bytesOf(rest), QByteArray("\t{Type  Sonar}\n"));
        QCOMPARE(bytesOf(takeWord(rest)), QByteArray("{Type"));
        QCOMPARE(bytesOf(takeWord(rest)), QByteArray("Sonar}"));
        QVERIFY(takeWord(rest).empty());
        QVERIFY(takeWord(rest).empty());
    }

    void lettersAndDigitsAreThoseOfAscii() {
        for (int byte = 0; byte < 256; ++byte) {
            const char c = static_cast<char>(byte);
            QCOMPARE(isDigit(c), byte >= 48 && byte <= 57);
            QCOMPARE(isLetter(c), (byte >= 65 && byte <= 90) || (byte >= 97 && byte <= 122));
            QCOMPARE(isSpace(c), byte == 32 || (byte >= 9 && byte <= 13));
        }
    }

    void bytesAreQuotedAsPrintableText_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QByteArray>("quoted");
        QTest::newRow("nothing") << QByteArray() << QByteArray("\"\"");
        QTest::newRow("plain text") << QByteArray("STA {Time 1}") << QByteArray("\"STA {Time 1}\"");
        QTest::newRow("a quote") << QByteArray("a\"b") << QByteArray("\"a\\\"b\"");
        QTest::newRow("a backslash") << QByteArray("a\\b") << QByteArray("\"a\\\\b\"");
        QTest::newRow("a line end and a tab") << QByteArray("\r\n\t") << QByteArray("\"\\r\\n\\t\"");
        QTest::newRow("a zero byte") << QByteArray("\0", 1) << QByteArray("\"\\x00\"");
        QTest::newRow("delete") << QByteArray("\x7f") << QByteArray("\"\\x7f\"");
        QTest::newRow("the largest byte") << QByteArray("\xff") << QByteArray("\"\\xff\"");
    }

    void bytesAreQuotedAsPrintableText() {
        QFETCH(QByteArray, bytes);
        QFETCH(QByteArray, quoted);
        std::string text = "before ";
        appendQuoted(text, viewOf(bytes));
        QCOMPARE(QByteArray::fromStdString(text), "before " + quoted);
    }

    void anyBytesComeBackFromTheirQuotes() {
        Random random = seeded(7, 1);
        std::uniform_int_distribution<int> byte(0, 255);
        for (int length = 0; length < 300; ++length) {
            std::string bytes;
            for (int i = 0; i < length; ++i)
                bytes += static_cast<char>(byte(random));
            std::string text = "  ";
            appendQuoted(text, bytes);
            for (const char c : text)
                QVERIFY(c >= ' ' && c <= '~');
            text += " tail";
            std::string_view rest = text;
            std::string back = "what was here before";
            QVERIFY(takeQuoted(rest, back));
            QVERIFY(back == bytes);
            QCOMPARE(bytesOf(rest), QByteArray(" tail"));
        }
    }

    void malformedQuotesAreRefused_data() {
        QTest::addColumn<QByteArray>("text");
        for (const char* text : {"", "   ", "bare", "'single'", "\"open", "\"open\\\"", "\"\\", "\"\\q\"", "\"\\x\"",
                                 "\"\\x4\"", "\"\\xzz\"", "\t\"after a tab\""})
            QTest::newRow(*text ? text : "nothing") << QByteArray(text);
    }

    void malformedQuotesAreRefused() {
        QFETCH(QByteArray, text);
        std::string_view rest = viewOf(text);
        std::string bytes;
        QVERIFY(!takeQuoted(rest, bytes));
    }

    void problemsNameTheirColumnFromOne_data() {
        QTest::addColumn<int>("severity");
        QTest::addColumn<int>("offset");
        QTest::addColumn<QString>("expected");
        QTest::newRow("a note") << int(Severity::Note) << 0 << "note at column 1: odd";
        QTest::newRow("a warning") << int(Severity::Warning) << 41 << "warning at column 42: odd";
        QTest::newRow("an error") << int(Severity::Error) << 9 << "error at column 10: odd";
    }

    void problemsNameTheirColumnFromOne() {
        QFETCH(int, severity);
        QFETCH(int, offset);
        QFETCH(QString, expected);
        const Diagnostic odd{static_cast<Severity>(severity), static_cast<std::size_t>(offset), "odd"};
        QCOMPARE(QString::fromStdString(toText(odd)), expected);
    }

    void millisecondsAreCutTowardZero() {
        QCOMPARE(toMilliseconds(Seconds{1.9996}).count(), 1999);
        QCOMPARE(toMilliseconds(Seconds{-1.9996}).count(), -1999);
        QCOMPARE(toMilliseconds(Seconds{0.0004}).count(), 0);
    }

    void typesAreNamedWithoutTheirNamespace() {
        QCOMPARE(bytesOf(typeName<Diagnostic>()), QByteArray("Diagnostic"));
        QCOMPARE(bytesOf(typeName<Stick>()), QByteArray("Stick"));
    }

    void aStickStaysWithinItsRange_data() {
        QTest::addColumn<double>("asked");
        QTest::addColumn<double>("expected");
        QTest::newRow("within") << 0.25 << 0.25;
        QTest::newRow("too far") << 3.0 << 1.0;
        QTest::newRow("too far back") << -3.0 << -1.0;
        QTest::newRow("infinite") << infinite << 1.0;
        QTest::newRow("infinite, back") << -infinite << -1.0;
        QTest::newRow("not a number") << nan_share << 0.0;
    }

    void aStickStaysWithinItsRange() {
        QFETCH(double, asked);
        QFETCH(double, expected);
        QVERIFY(clamped({asked, asked, asked, asked}) == (Stick{expected, expected, expected, expected}));
    }

    void axesThatARobotLacksAreZero() {
        const Stick all{0.1, 0.2, 0.3, 0.4};
        QVERIFY(masked(all, {}).centered());
        QVERIFY(masked(all, {.forward = true, .turn = true}) == (Stick{.forward = 0.1, .turn = 0.3}));
        QVERIFY(masked(all, {.left = true, .up = true}) == (Stick{.left = 0.2, .up = 0.4}));
        QVERIFY(!StickAxes{}.any());
        QVERIFY((StickAxes{.up = true}.any()));
    }

    void aDeadZoneNeverMakesAStickJump() {
        double before = 0.0;
        for (int step = 0; step <= 1000; ++step) {
            double x = step / 1000.0;
            double y = 0.0;
            applyDeadZone(x, y, 0.15);
            QCOMPARE(y, 0.0);
            QVERIFY(x >= before && x - before < 0.002);
            QVERIFY(step > 150 || x == 0.0);
            before = x;
        }
        QCOMPARE(before, 1.0);
        double x = nan_share;
        double y = 0.5;
        applyDeadZone(x, y, 0.15);
        QVERIFY(x == 0.0 && y == 0.0);
    }

    void equalSeedsGiveEqualNumbers() {
        Random one = seeded(7, 1), same = seeded(7, 1), other_stream = seeded(7, 2), other_seed = seeded(1ULL << 40, 1);
        const auto first = one();
        QCOMPARE(same(), first);
        QVERIFY(other_stream() != first);
        QVERIFY(other_seed() != first);
        for (int i = 0; i < 1000; ++i) {
            const double value = uniform(one, -2.0, 3.0);
            QVERIFY(value >= -2.0 && value < 3.0);
        }
    }
};

USAR_TEST(tst_Text)

} // namespace tst_text

#include "tst_text.moc"
