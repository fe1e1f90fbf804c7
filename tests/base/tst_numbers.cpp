#include <QTest>

#include <bit>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdint>

#include "core/base/numbers.h"
#include "core/base/plain_decimal.h"
#include "core/base/random.h"
#include "core/base/whole_number.h"
#include "tests/suite/suite.h"

namespace tst_numbers {

using namespace usar;

class tst_Numbers : public QObject {
    Q_OBJECT
private slots:
    void readsThePrefixThatIsANumber_data();
    void readsThePrefixThatIsANumber();
    void refusesWhatIsNotWhollyANumber_data();
    void refusesWhatIsNotWhollyANumber();
    void writesFixedDecimals_data();
    void writesFixedDecimals();
    void cuttingNeverMakesANumberLarger();
    void shortestTextReadsBackExactly();
    void plainDecimalsReadAsFromCharsReadsThem();
    void theWholeNumberBelowIsTheFloor();
    void ignoresTheLocale();
};

void tst_Numbers::readsThePrefixThatIsANumber_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("used");
    QTest::newRow("plain") << QByteArray("4.5604") << 4.5604 << 6;
    QTest::newRow("comma locale stops at the comma") << QByteArray("1,00") << 1.0 << 1;
    QTest::newRow("leading plus") << QByteArray("+1,00") << 1.0 << 2;
    QTest::newRow("leading dot") << QByteArray(".4") << 0.4 << 2;
    QTest::newRow("leading zeros") << QByteArray("020") << 20.0 << 3;
    QTest::newRow("exponent") << QByteArray("1.16338e-17,") << 1.16338e-17 << 11;
    QTest::newRow("words are no number") << QByteArray("abc") << 0.0 << 0;
    QTest::newRow("plus minus is no number") << QByteArray("+-1") << 0.0 << 0;
    QTest::newRow("nothing") << QByteArray("") << 0.0 << 0;
    QTest::newRow("nan") << QByteArray("nan") << qQNaN() << 3;
    QTest::newRow("inf is not a number to us") << QByteArray("-inf") << qQNaN() << 4;
    QTest::newRow("Windows indefinite") << QByteArray("-1.#IND,2") << qQNaN() << 7;
    QTest::newRow("Windows infinity") << QByteArray("1.#INF00") << qQNaN() << 8;
    QTest::newRow("too large") << QByteArray("1e999") << qQNaN() << 5;
}

void tst_Numbers::readsThePrefixThatIsANumber() {
    QFETCH(QByteArray, text);
    QFETCH(double, value);
    QFETCH(int, used);
    const NumberPrefix number = readNumberPrefix(text.toStdString());
    QCOMPARE(static_cast<int>(number.used), used);
    QVERIFY(number.value == value || (std::isnan(number.value) && std::isnan(value)));
}

void tst_Numbers::refusesWhatIsNotWhollyANumber_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("junk after the number") << QByteArray("12abc");
    QTest::newRow("two numbers") << QByteArray("1 2");
    QTest::newRow("nothing") << QByteArray("  ");
}

void tst_Numbers::refusesWhatIsNotWhollyANumber() {
    QFETCH(QByteArray, text);
    QVERIFY(!readNumber(text.toStdString()));
    QVERIFY(!readInteger(text.toStdString()));
}

void tst_Numbers::writesFixedDecimals_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QByteArray>("rounded");
    QTest::addColumn<QByteArray>("cut");
    QTest::newRow("pi") << 3.14159265 << 4 << QByteArray("3.1416") << QByteArray("3.1415");
    QTest::newRow("one degree") << 0.01745 << 4 << QByteArray("0.0175") << QByteArray("0.0174");
    QTest::newRow("what was read is written again") << 2.1924 << 4 << QByteArray("2.1924") << QByteArray("2.1924");
    QTest::newRow("negative") << -0.87266 << 4 << QByteArray("-0.8727") << QByteArray("-0.8726");
    QTest::newRow("minus zero keeps its sign") << -0.0 << 2 << QByteArray("-0.00") << QByteArray("-0.00");
    QTest::newRow("a tiny negative is minus zero") << -1e-9 << 4 << QByteArray("-0.0000") << QByteArray("-0.0000");
    QTest::newRow("leading zeros after the point") << 0.0503 << 4 << QByteArray("0.0503") << QByteArray("0.0503");
    QTest::newRow("large") << 123456789012345678.0 << 2 << QByteArray("123456789012345680.00")
                           << QByteArray("123456789012345680.00");
    QTest::newRow("no decimals") << 7.9 << 0 << QByteArray("8") << QByteArray("7");
    QTest::newRow("two decimals") << 4.5 << 2 << QByteArray("4.50") << QByteArray("4.50");
}

void tst_Numbers::writesFixedDecimals() {
    QFETCH(double, value);
    QFETCH(int, decimals);
    QFETCH(QByteArray, rounded);
    QFETCH(QByteArray, cut);
    std::string fixed_text;
    appendFixed(fixed_text, value, decimals);
    QCOMPARE(QByteArray::fromStdString(fixed_text), rounded);
    std::string cut_text;
    appendTruncated(cut_text, value, decimals);
    QCOMPARE(QByteArray::fromStdString(cut_text), cut);
}

void tst_Numbers::cuttingNeverMakesANumberLarger() {
    Random random = seeded(4, 1);
    for (int i = 0; i < 20000; ++i) {
        const double value = uniform(random, -1, 1) * std::pow(10.0, uniform(random, -6, 9));
        std::string text;
        appendTruncated(text, value, 4);
        const double cut = readNumber(text).value();
        QVERIFY2(std::abs(cut) <= std::abs(value) * (1 + 1e-15) && std::abs(value - cut) < 1.0001e-4, text.c_str());
        std::string again;
        appendTruncated(again, cut, 4);
        QCOMPARE(again, text);
    }
}

void tst_Numbers::plainDecimalsReadAsFromCharsReadsThem() {
    Random random = seeded(5, 1);
    const std::string alphabet = "0123456789....-e";
    for (int i = 0; i < 200000; ++i) {
        std::string text(1 + random() % 17, '0');
        for (char& c : text)
            c = alphabet[random() % alphabet.size()];
        double expected = 0.0;
        const char* const end = text.data() + text.size();
        const auto [behind, problem] = std::from_chars(text.data(), end, expected);
        const char* at = text.data();
        if (double value = 0.0; readPlainDecimal(at, end, value)) {
            QVERIFY2(problem == std::errc{} && at == behind, text.c_str());
            QVERIFY2(std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(expected), text.c_str());
        }
    }
    const std::string common = "4.5604,";
    const char* at = common.data();
    double value = 0.0;
    QVERIFY(readPlainDecimal(at, common.data() + common.size(), value) && value == 4.5604 && *at == ',');
}

void tst_Numbers::shortestTextReadsBackExactly() {
    Random random = seeded(3, 1);
    for (int i = 0; i < 10000; ++i) {
        const double value = uniform(random, -1, 1) * std::pow(10.0, uniform(random, -12, 12));
        std::string text;
        appendShortest(text, value);
        QCOMPARE(readNumber(text).value(), value);
    }
}

void tst_Numbers::theWholeNumberBelowIsTheFloor() {
    for (const double value : {0.0, -0.0, 1.0, -1.0, 0.999999, -0.999999, 1e15 + 0.5, -1e15 - 0.5, -4e18, 4e18})
        QCOMPARE(static_cast<double>(wholeBelow(value)), std::floor(value));
    Random random = seeded(4, 1);
    for (int i = 0; i < 10000; ++i) {
        const double value = uniform(random, -1, 1) * std::pow(10.0, uniform(random, -3, 9));
        QCOMPARE(static_cast<double>(wholeBelow(value)), std::floor(value));
    }
}

void tst_Numbers::ignoresTheLocale() {
    // Where no comma locale is installed the claim still holds; where one is, this is the row that would fail.
    for (const char* name : {"de_DE.UTF-8", "cs_CZ.UTF-8", "fr_FR.UTF-8"})
        std::setlocale(LC_ALL, name);
    QCOMPARE(readNumber("1.5").value(), 1.5);
    QCOMPARE(fixed(1.5, 2), std::string("1.50"));
    std::setlocale(LC_ALL, "C");
}

USAR_TEST(tst_Numbers)

} // namespace tst_numbers

#include "tst_numbers.moc"
