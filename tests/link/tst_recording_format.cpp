#include <QTest>

#include "core/base/random.h"
#include "core/link/recording_format.h"
#include "core/link/recording_text.h"
#include "tests/doubles/plain_recording.h"
#include "tests/suite/suite.h"

namespace tst_recording_format {

using namespace usar;
using namespace usar::link;
using namespace std::chrono_literals;

namespace {

QByteArray hex(std::string_view bytes) {
    return QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())).toHex(' ');
}

std::string encoded(const Record& record) {
    std::string bytes;
    doubles::appendPlain(bytes, record);
    return bytes;
}

/// The same record whose texts somebody keeps.
struct Kept {
    Record record;
    std::string name;
    std::string bytes;
};

std::string randomText(Random& random, std::size_t most) {
    std::uniform_int_distribution<std::size_t> size(0, most);
    std::uniform_int_distribution<int> byte(0, 255);
    std::string text(size(random), ' ');
    for (char& c : text)
        c = static_cast<char>(byte(random));
    return text;
}

Kept randomRecord(Random& random) {
    std::uniform_int_distribution<int> kind(1, 9);
    std::uniform_int_distribution<std::uint64_t> number;
    Kept kept;
    kept.record.kind = static_cast<RecordKind>(kind(random));
    kept.record.time = RecordTime(static_cast<std::int64_t>(number(random) >> 1));
    kept.record.line = {number(random)};
    kept.bytes = randomText(random, 300);
    if (kept.record.kind == RecordKind::Out || kept.record.kind == RecordKind::Note) {
        kept.record.trigger = {number(random)};
        kept.name = randomText(random, 40);
    }
    return kept;
}

} // namespace

class tst_RecordingFormat : public QObject {
    Q_OBJECT
private slots:
    void theBytesAreThoseOfTheDocument();
    void theChecksumIsThatOfZlib();
    void recordsAreReadAsTheyWereWritten();
    void everyCutIsCutOffAndEveryFlippedBitIsSeen();
    void bytesBeyondALimitGoIntoFurtherRecords();
    void textAndBackIsTheSameRecord();
    void textIsOneReadableLine();
    void rejectsBrokenTextAndSaysWhere_data();
    void rejectsBrokenTextAndSaysWhere();
};

void tst_RecordingFormat::theBytesAreThoseOfTheDocument() {
    std::string file;
    doubles::appendOldHead(file);
    QCOMPARE(hex(file), QByteArray("89 55 53 41 52 0d 0a 1a 01 00 00 00"));
    const std::string in = encoded({.kind = RecordKind::In, .time = 258ns, .line = {3}, .bytes = "A\r\n"});
    QCOMPARE(hex(in).left(11), QByteArray("03 00 00 00"));
    QCOMPARE(hex(in).mid(24), QByteArray("04 02 01 00 00 00 00 00 00 03 00 00 00 00 00 00 00 41 0d 0a"));
    const std::string out =
        encoded({.kind = RecordKind::Out, .time = 1ns, .line = {2}, .trigger = {1}, .name = "me", .bytes = "B"});
    QCOMPARE(hex(out).mid(75), QByteArray("01 00 00 00 00 00 00 00 02 00 6d 65 42"));
}

void tst_RecordingFormat::theChecksumIsThatOfZlib() {
    QCOMPARE(recording::checksum(""), 0u);
    QCOMPARE(recording::checksum("123456789"), 0xCBF43926u);
    QCOMPARE(recording::checksum("The quick brown fox jumps over the lazy dog"), 0x414FA339u);
}

void tst_RecordingFormat::recordsAreReadAsTheyWereWritten() {
    Random random = seeded(1, 1);
    for (int i = 0; i < 2000; ++i) {
        Kept kept = randomRecord(random);
        kept.record.name = kept.name;
        kept.record.bytes = kept.bytes;
        const std::string bytes = encoded(kept.record);
        const std::string and_more = bytes + "more"; // what was taken looks into it
        const auto taken = recording::take(and_more);
        QCOMPARE(taken.fit, recording::Fit::Whole);
        QCOMPARE(taken.size, bytes.size());
        QVERIFY(taken.record == kept.record);
        QCOMPARE(recording::sizeAt(bytes).value_or(0), bytes.size());
    }
}

void tst_RecordingFormat::everyCutIsCutOffAndEveryFlippedBitIsSeen() {
    const std::string bytes = encoded({.kind = RecordKind::Out,
                                       .time = 5s,
                                       .line = {7},
                                       .trigger = {6},
                                       .name = "who",
                                       .bytes = "DRIVE {Left 1}\r\n"});
    for (std::size_t size = 0; size < bytes.size(); ++size)
        QCOMPARE(recording::take(std::string_view(bytes).substr(0, size)).fit, recording::Fit::CutOff);
    for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
        std::string damaged = bytes;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        QVERIFY(recording::take(damaged).fit != recording::Fit::Whole);
    }
}

void tst_RecordingFormat::bytesBeyondALimitGoIntoFurtherRecords() {
    const std::string many(3 * recording::longest_payload_bytes - 5, 'x');
    const std::string bytes =
        encoded({.kind = RecordKind::Out, .time = 1s, .trigger = {3}, .name = "who", .bytes = many});
    std::string_view rest = bytes;
    std::string together;
    while (!rest.empty()) {
        const auto taken = recording::take(rest);
        QCOMPARE(taken.fit, recording::Fit::Whole);
        QVERIFY(taken.record.name == "who" && taken.record.trigger == LineNumber{3});
        together += taken.record.bytes;
        rest.remove_prefix(taken.size);
    }
    QVERIFY(together == many);
}

void tst_RecordingFormat::textAndBackIsTheSameRecord() {
    Random random = seeded(2, 1);
    recording::TextRecord reader;
    for (int i = 0; i < 2000; ++i) {
        Kept kept = randomRecord(random);
        kept.record.name = kept.name;
        kept.record.bytes = kept.bytes;
        std::string text;
        recording::appendText(text, kept.record);
        QVERIFY(text.ends_with('\n'));
        text.pop_back();
        QVERIFY(text.find_first_of("\r\n") == std::string::npos);
        const auto read = reader.read(text);
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QVERIFY(*read == kept.record);
        std::string again;
        recording::appendText(again, *read);
        QCOMPARE(again, text + '\n');
    }
}

void tst_RecordingFormat::textIsOneReadableLine() {
    std::string text;
    recording::appendText(text, {.kind = RecordKind::Out,
                                 .time = 12s + 345ns,
                                 .line = {9},
                                 .trigger = {8},
                                 .name = "operator: \"stop\"",
                                 .bytes = "DRIVE {Left 0}\r\n\x01\xff"});
    QCOMPARE(text, std::string("out 12.000000345 9 8 \"operator: \\\"stop\\\"\" \"DRIVE {Left 0}\\r\\n\\x01\\xff\"\n"));
}

void tst_RecordingFormat::rejectsBrokenTextAndSaysWhere_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("nothing") << QByteArray("") << QByteArray("column 1: the line does not begin");
    QTest::newRow("unknown word") << QByteArray("inn 0.000000000 0 \"\"") << QByteArray("kind of record");
    QTest::newRow("kind zero") << QByteArray("0 0.000000000 0 \"\"") << QByteArray("kind of record");
    QTest::newRow("kind too large") << QByteArray("256 0.000000000 0 \"\"") << QByteArray("kind of record");
    QTest::newRow("seconds without decimals") << QByteArray("in 1 0 \"\"") << QByteArray("column 5: the time");
    QTest::newRow("too few decimals") << QByteArray("in 1.5 0 \"\"") << QByteArray("nine decimals");
    QTest::newRow("negative time") << QByteArray("in -1.000000000 0 \"\"") << QByteArray("the time");
    QTest::newRow("endless time") << QByteArray("in 99999999999999999999.000000000 0 \"\"") << QByteArray("the time");
    QTest::newRow("no line number") << QByteArray("in 1.000000000 \"\"") << QByteArray("the line number");
    QTest::newRow("no trigger") << QByteArray("out 1.000000000 1 \"a\" \"b\"") << QByteArray("the triggering line");
    QTest::newRow("no name") << QByteArray("out 1.000000000 1 1 b") << QByteArray("the name");
    QTest::newRow("bytes without quotes") << QByteArray("in 1.000000000 1 b") << QByteArray("the bytes");
    QTest::newRow("open quotes") << QByteArray("in 1.000000000 1 \"b") << QByteArray("the bytes");
    QTest::newRow("unknown escape") << QByteArray("in 1.000000000 1 \"\\q\"") << QByteArray("the bytes");
    QTest::newRow("half an escape") << QByteArray("in 1.000000000 1 \"\\x1\"") << QByteArray("the bytes");
    QTest::newRow("something behind") << QByteArray("in 1.000000000 1 \"b\" c") << QByteArray("the bytes");
}

void tst_RecordingFormat::rejectsBrokenTextAndSaysWhere() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, words);
    recording::TextRecord reader;
    const auto read = reader.read(line.toStdString());
    QVERIFY(!read);
    QVERIFY2(QByteArray::fromStdString(read.error().text()).contains(words), read.error().text().c_str());
    QVERIFY(!read.error().mend.empty());
}

USAR_TEST(tst_RecordingFormat)

} // namespace tst_recording_format

#include "tst_recording_format.moc"
