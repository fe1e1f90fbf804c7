#include <bit>
#include <cstdlib>

#include <QTest>

#include "core/base/byte_codec.h"
#include "tests/suite/suite.h"

namespace tst_byte_codec {

using namespace usar;

class tst_ByteCodec : public QObject {
    Q_OBJECT
private slots:
    void numbersAreCodedAsShortAsTheyAre_data();
    void numbersAreCodedAsShortAsTheyAre();
    void wordsAreCodedWithoutTheirZeros_data();
    void wordsAreCodedWithoutTheirZeros();
    void malformedValuesFail_data();
    void malformedValuesFail();
    void doublesComeBack();
};

void tst_ByteCodec::numbersAreCodedAsShortAsTheyAre_data() {
    QTest::addColumn<quint64>("number");
    QTest::addColumn<int>("bytes");
    QTest::newRow("zero") << quint64(0) << 1;
    QTest::newRow("seven bits") << quint64(127) << 1;
    QTest::newRow("eight bits") << quint64(128) << 2;
    QTest::newRow("fourteen bits") << quint64(16383) << 2;
    QTest::newRow("fifteen bits") << quint64(16384) << 3;
    QTest::newRow("33 bits") << (quint64(1) << 32) << 5;
    QTest::newRow("63 bits") << ((quint64(1) << 63) - 1) << 9;
    QTest::newRow("64 bits") << (quint64(1) << 63) << 10;
    QTest::newRow("all bits") << ~quint64(0) << 10;
}

void tst_ByteCodec::numbersAreCodedAsShortAsTheyAre() {
    QFETCH(quint64, number);
    QFETCH(int, bytes);
    std::string coded;
    appendVarint(coded, number);
    QCOMPARE(coded.size(), std::size_t(bytes));
    ByteReader reader(coded);
    QCOMPARE(quint64(reader.varint()), number);
    QVERIFY(reader.empty() && !reader.failed());
    const std::int64_t back = unzigzag(number); // Each number stands for one with a sign.
    QCOMPARE(quint64(zigzag(back)), number);
    QVERIFY(number > 200 || std::abs(back) <= 100);
    for (std::size_t size = 0; size < coded.size(); ++size) {
        ByteReader cut(std::string_view(coded).substr(0, size));
        cut.varint();
        QVERIFY(cut.failed());
    }
}

void tst_ByteCodec::wordsAreCodedWithoutTheirZeros_data() {
    QTest::addColumn<quint64>("word");
    QTest::addColumn<int>("bytes");
    QTest::newRow("zero") << quint64(0) << 1;
    QTest::newRow("one byte") << quint64(1) << 2;
    QTest::newRow("the highest byte") << (quint64(0x80) << 56) << 2;
    QTest::newRow("a byte in the middle") << quint64(0xFF00) << 2;
    QTest::newRow("a zero between two bytes") << quint64(0x10'0001) << 4;
    QTest::newRow("both ends") << ((quint64(1) << 63) | 1) << 9;
    QTest::newRow("the float 2.0") << quint64(std::bit_cast<std::uint64_t>(2.0)) << 2;
    QTest::newRow("the float 0.1") << quint64(std::bit_cast<std::uint64_t>(0.1)) << 9;
}

void tst_ByteCodec::wordsAreCodedWithoutTheirZeros() {
    QFETCH(quint64, word);
    QFETCH(int, bytes);
    std::string coded;
    appendBits(coded, word);
    QCOMPARE(coded.size(), std::size_t(bytes));
    ByteReader reader(coded);
    QCOMPARE(quint64(reader.bits()), word);
    QVERIFY(reader.empty() && !reader.failed());
}

void tst_ByteCodec::malformedValuesFail_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("varint");
    QTest::addColumn<bool>("bits");
    QTest::newRow("nothing") << QByteArray() << false << false;
    QTest::newRow("one that goes on") << QByteArray("\x80") << false << true; // All eight bytes are left out
    QTest::newRow("ten bytes that go on") << QByteArray(10, '\xFF') << false << false;
    QTest::newRow("more zeros than a word has") << QByteArray("\x45") << true << false;
    QTest::newRow("one byte of two is used") << QByteArray("\x52\x01\x02") << true << true;
    QTest::newRow("two bytes that are missing") << QByteArray("\x32\x01") << true << false;
}

void tst_ByteCodec::malformedValuesFail() {
    QFETCH(QByteArray, bytes);
    const std::string_view view(bytes.data(), static_cast<std::size_t>(bytes.size()));
    ByteReader number(view);
    number.varint();
    QTEST(!number.failed(), "varint");
    ByteReader word(view);
    word.bits();
    QTEST(!word.failed(), "bits");
    ByteReader text(view);
    QVERIFY(text.text(view.size() + 1).empty() && text.failed());
    QVERIFY(text.text(0).empty() && text.failed()); // It stays failed
}

void tst_ByteCodec::doublesComeBack() {
    std::string coded;
    for (const double number : {0.0, -0.0, 2.0, 0.1, -1e300, 395.38})
        appendDouble(coded, number);
    ByteReader reader(coded);
    for (const double number : {0.0, -0.0, 2.0, 0.1, -1e300, 395.38})
        QCOMPARE(std::bit_cast<std::uint64_t>(reader.number()), std::bit_cast<std::uint64_t>(number));
    QVERIFY(reader.empty() && reader.rest().empty() && !reader.failed());
}

USAR_TEST(tst_ByteCodec)

} // namespace tst_byte_codec

#include "tst_byte_codec.moc"
