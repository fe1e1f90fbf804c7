// Recordings of version 2: blocks of compressed records, groups, and the index at the end.
#include <QTemporaryDir>
#include <QTest>

#include "core/base/random.h"
#include "core/link/recording_packing.h"
#include "core/link/recording_reader.h"
#include "core/link/recording_text.h"
#include "core/link/recording_writer.h"
#include "tests/suite/suite.h"

namespace tst_packed_recording {

using namespace usar;
using namespace usar::link;
using namespace std::chrono_literals;

namespace {

constexpr int ticks = 4000;

/// Ticks of a robot that moves, a fifth of a second apart; long enough for several groups.
std::string tick(int i, Random& random) {
    std::uniform_int_distribution<int> digit(1000, 9999);
    std::string text = "SEN {Time " + std::to_string(i / 5) + "." + std::to_string(i % 5 * 2) + "} {Type Sonar}";
    for (int beam = 0; beam < 10; ++beam)
        text += " {Name F" + std::to_string(beam) + "} {Range 4." + std::to_string(digit(random)) + "}";
    return text + "\r\n";
}

struct Made {
    std::string bytes;
    std::vector<std::size_t> block_ends; ///< of those with records
    std::vector<std::size_t> groups;     ///< where each begins
    std::vector<std::size_t> records;    ///< how many there are up to the end of each block
};

/// A recording as the writer makes it, with a block for every fifth tick.
Made made(int count = ticks, bool with_index = true) {
    Random random = seeded(7, 1);
    Made file;
    recording::appendHead(file.bytes);
    RecordPacker packer;
    BlockWriter blocks(file.bytes.size());
    std::size_t records = 0;
    const auto flush = [&] {
        const PackedBatch batch = packer.take();
        std::size_t at = file.bytes.size();
        blocks.append(file.bytes, batch);
        ByteReader bytes(batch.bytes);
        for (PackedBefore before; !bytes.empty();) {
            takePacked(bytes, before);
            ++records;
            const bool group_ends = std::ranges::find(batch.groups, bytes.used()) != batch.groups.end();
            if (!group_ends && !bytes.empty())
                continue;
            const auto block = recording::takeBlock(std::string_view(file.bytes).substr(at));
            if (block.kind == recording::BlockKind::First)
                file.groups.push_back(at);
            file.block_ends.push_back(at += block.size);
            file.records.push_back(records);
        }
    };
    packer.add({.kind = RecordKind::Start, .line = {3}, .bytes = "robot: R1\nhost: h\n"});
    packer.add({.kind = RecordKind::Opened, .line = {3}, .bytes = "h:3000"});
    flush();
    for (int i = 0; i < count; ++i) {
        const LineNumber line{static_cast<std::uint64_t>(3 + i)};
        packer.add({.kind = RecordKind::In, .time = 200ms * i, .line = line, .bytes = tick(i, random)});
        packer.add({.kind = RecordKind::Out,
                    .time = 200ms * i,
                    .line = {line.value + 1},
                    .trigger = line,
                    .name = "me",
                    .bytes = "STEP\r\n"});
        if (i % 5 == 4)
            flush();
    }
    packer.add({.kind = RecordKind::End, .time = 200ms * count});
    flush();
    if (with_index)
        blocks.appendIndex(file.bytes);
    return file;
}

/// The one that most tests need, made once.
const Made& wholeOne() {
    static const Made file = made();
    return file;
}

std::string textOf(RecordingReader& reader) {
    std::string text;
    while (const auto record = reader.next())
        recording::appendText(text, *record);
    return text;
}

} // namespace

class tst_PackedRecording : public QObject {
    Q_OBJECT
private slots:
    void theBytesAreThoseOfTheDocument();
    void aRecordingOfVersionOneIsRead();
    void indexAndScanAndReadingAgree();
    void aCutCostsTheBlockThatItHit();
    void damageCostsTheRestOfItsGroup_data();
    void damageCostsTheRestOfItsGroup();
    void quickOpeningMeetsDamageLater();
    void everyDamagedByteIsSeen();
    void aSeekFindsEveryMoment();
    void aSeekFindsTheFirstRecordBehindDamage();
    void recordsOfAnyNumbersComeBack();
    void hostileBlocksAreDamage_data();
    void hostileBlocksAreDamage();
    void aGroupThatGoesOnForEverIsDamage();
    void aFastStretchIsPackedToo();

private:
    void put(const std::string& bytes) {
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes.data(), static_cast<qint64>(bytes.size())), static_cast<qint64>(bytes.size()));
    }
    std::unique_ptr<RecordingReader> open(OpenMode mode = OpenMode::Thorough) {
        auto reader = RecordingReader::open(path(), mode);
        if (!reader)
            QTest::qFail(reader.error().text().c_str(), __FILE__, __LINE__);
        return reader ? *std::move(reader) : nullptr;
    }
    QString path() const { return folder_.filePath("r.usarrec"); }
    void compare(const RecordingSurvey& one, const RecordingSurvey& other);

    QTemporaryDir folder_;
};

void tst_PackedRecording::compare(const RecordingSurvey& one, const RecordingSurvey& other) {
    QVERIFY(one.facts == other.facts && one.clock == other.clock && one.first_line == other.first_line);
    QCOMPARE(one.records, other.records);
    QCOMPARE(one.bytes_in, other.bytes_in);
    QCOMPARE(one.bytes_out, other.bytes_out);
    QCOMPARE(one.commands, other.commands);
    QCOMPARE(one.span, other.span);
    QCOMPARE(one.play_span, other.play_span);
    QCOMPARE(one.ended, other.ended);
}

void tst_PackedRecording::theBytesAreThoseOfTheDocument() {
    std::string file;
    recording::appendHead(file);
    QCOMPARE(QByteArray::fromStdString(file).toHex(' '), QByteArray("89 55 53 41 52 0d 0a 1a 02 00 00 00"));
    recording::appendBlock(file, recording::BlockKind::Next, "ab");
    QCOMPARE(QByteArray::fromStdString(file.substr(12, 4)).toHex(' '), QByteArray("02 00 00 00"));
    QCOMPARE(file.substr(20), std::string("\x02"
                                          "ab"));
    RecordPacker packer;
    packer.add({.kind = RecordKind::In, .time = 300ns, .line = {2}, .bytes = "A"});
    packer.add({.kind = RecordKind::Out, .time = 301ns, .line = {3}, .trigger = {2}, .name = "me", .bytes = "B"});
    const PackedBatch batch = packer.take();
    QCOMPARE(QByteArray::fromStdString(batch.bytes).toHex(' '),
             QByteArray("04 ac 02 04 01 41 05 01 02 02 02 6d 65 01 42"));
    QCOMPARE(batch.groups, std::vector<std::size_t>{0});
}

/// It was recorded by the last version of the program that wrote version 1: a robot that spawns and takes off.
void tst_PackedRecording::aRecordingOfVersionOneIsRead() {
    const QString old = QStringLiteral(USAR_SOURCE_DIR "/tests/data/recordings/version_1.usarrec");
    for (const OpenMode mode : {OpenMode::Quick, OpenMode::Thorough}) {
        const auto reader = RecordingReader::open(old, mode);
        QVERIFY2(reader, reader ? "" : reader.error().text().c_str());
        const RecordingSurvey& survey = (*reader)->survey();
        QCOMPARE(survey.complaint(), std::string());
        QCOMPARE(survey.facts.at("mission"), std::string("Quick scan"));
        QCOMPARE(survey.records, 158u);
        QVERIFY(survey.ended && survey.clock.at(Seconds{3.0}));
        QCOMPARE(std::ranges::count(textOf(**reader), '\n'), 158);
    }
}

void tst_PackedRecording::indexAndScanAndReadingAgree() {
    const Made& file = wholeOne();
    QVERIFY(file.groups.size() > 3);
    put(file.bytes);
    const auto indexed = open(OpenMode::Quick);
    put(made(ticks, false).bytes);
    const auto scanned = open(OpenMode::Quick);
    RecordCounter counter;
    while (const auto record = scanned->next())
        counter.take(*record);
    QVERIFY(indexed->survey().ended);
    QCOMPARE(indexed->survey().records, std::uint64_t(2 * ticks + 3));
    compare(indexed->survey(), counter.survey());
    compare(scanned->survey(), counter.survey());
    QCOMPARE(indexed->survey().complaint(), std::string());
    QCOMPARE(scanned->survey().complaint(), std::string());
}

void tst_PackedRecording::aCutCostsTheBlockThatItHit() {
    const Made& file = wholeOne();
    Random random = seeded(9, 1);
    std::uniform_int_distribution<std::size_t> anywhere(file.block_ends.front(), file.bytes.size() - 1);
    std::vector<std::size_t> cuts{file.block_ends[4], file.block_ends[4] + 1, file.block_ends[4] - 1,
                                  file.groups[2],     file.groups[2] + 8,     file.block_ends.back()};
    for (int i = 0; i < 60; ++i)
        cuts.push_back(anywhere(random));
    for (const std::size_t cut : cuts) {
        put(file.bytes.substr(0, cut));
        const auto blocks = static_cast<std::size_t>(
            std::ranges::count_if(file.block_ends, [&](std::size_t end) { return end <= cut; }));
        for (const OpenMode mode : {OpenMode::Quick, OpenMode::Thorough}) {
            const auto reader = open(mode);
            QCOMPARE(reader->survey().records, file.records[blocks - 1]);
            QCOMPARE(reader->survey().tail_lost_bytes, cut - file.block_ends[blocks - 1]);
            QCOMPARE(std::size_t(std::ranges::count(textOf(*reader), '\n')), file.records[blocks - 1]);
        }
    }
}

void tst_PackedRecording::damageCostsTheRestOfItsGroup_data() {
    QTest::addColumn<int>("group");
    QTest::addColumn<int>("behind"); // bytes behind where it begins
    QTest::newRow("the size of a first block") << 1 << 1;
    QTest::newRow("its kind") << 1 << 8;
    QTest::newRow("the state in it") << 2 << 12;
    QTest::newRow("what is compressed in it") << 2 << 500;
    QTest::newRow("a later block") << 1 << 4000;
    QTest::newRow("the first group") << 0 << 300;
}

void tst_PackedRecording::damageCostsTheRestOfItsGroup() {
    QFETCH(int, group);
    QFETCH(int, behind);
    Made file = wholeOne();
    const auto number = static_cast<std::size_t>(group);
    const std::size_t at = file.groups[number] + static_cast<std::size_t>(behind);
    const std::size_t good = file.groups[number + 1];
    QVERIFY(at < good);
    file.bytes[at] = static_cast<char>(file.bytes[at] ^ 0x55);
    put(file.bytes);
    const auto reader = open();
    const std::size_t hit = *std::prev(std::ranges::upper_bound(file.block_ends, at));
    const std::size_t begin = std::max(hit, std::size_t{recording::head_bytes});
    QCOMPARE(reader->survey().damage.size(), std::size_t(1));
    QCOMPARE(reader->survey().damage[0].offset, begin);
    QCOMPARE(reader->survey().damage[0].bytes, good - begin);
    const auto lines = [&](std::size_t end) {
        return file
            .records[static_cast<std::size_t>(std::ranges::find(file.block_ends, end) - file.block_ends.begin())];
    };
    const std::size_t lost = lines(good) - lines(begin);
    QCOMPARE(reader->survey().records, file.records.back() - lost);
    QCOMPARE(std::size_t(std::ranges::count(textOf(*reader), '\n')), file.records.back() - lost);
    QVERIFY(reader->survey().complaint().find("are damaged") != std::string::npos);
}

void tst_PackedRecording::quickOpeningMeetsDamageLater() {
    Made file = wholeOne();
    file.bytes[file.groups[2] + 500] ^= 1;
    put(file.bytes);
    const auto reader = open(OpenMode::Quick);
    QCOMPARE(reader->survey().complaint(), std::string());
    textOf(*reader);
    const std::string said = reader->survey().complaint();
    QCOMPARE(said, open()->survey().complaint());
    QVERIFY(said.find("damaged") != std::string::npos);
    reader->seek(0s);
    textOf(*reader);
    QCOMPARE(reader->survey().complaint(), said);
}

void tst_PackedRecording::everyDamagedByteIsSeen() {
    Made file = made(30);
    for (std::size_t at = recording::head_bytes; at < file.bytes.size(); ++at) {
        std::string damaged = file.bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
        put(damaged);
        const auto reader = RecordingReader::open(path());
        QVERIFY2(!reader || !(*reader)->survey().damage.empty(), qPrintable(QString("byte %1").arg(at)));
    }
}

void tst_PackedRecording::aSeekFindsEveryMoment() {
    put(wholeOne().bytes);
    const auto reader = open(OpenMode::Quick);
    Random random = seeded(11, 1);
    std::uniform_int_distribution<int> moment(0, 200 * ticks - 1);
    for (int i = 0; i < 200; ++i) {
        const auto wanted = std::chrono::milliseconds(moment(random));
        reader->seek(wanted);
        const auto record = reader->next();
        QVERIFY(record && record->time >= wanted && record->time < wanted + 200ms);
        QCOMPARE(record->kind, record->time == RecordTime{0} ? RecordKind::Start : record->kind);
    }
    reader->seek(200ms * ticks);
    QCOMPARE(reader->next()->kind, RecordKind::End);
    reader->seek(200ms * ticks + 1ns);
    QVERIFY(!reader->next());
}

void tst_PackedRecording::aSeekFindsTheFirstRecordBehindDamage() {
    Made file = wholeOne();
    put(file.bytes);
    const auto whole = open();
    file.bytes[file.groups[1] + 500] ^= 1;
    put(file.bytes);
    const auto reader = open();
    const auto wanted = [&] { // a moment in the group that is gone
        whole->seek(0s);
        while (const auto record = whole->next())
            if (whole->offset() > file.groups[1])
                return record->time;
        return RecordTime{0};
    }();
    reader->seek(wanted);
    const auto record = reader->next();
    QVERIFY(record && record->time > wanted);
    QCOMPARE(reader->offset(), file.groups[2]);
    const auto next = reader->next();
    QVERIFY(next && next->time >= record->time);
}

void tst_PackedRecording::recordsOfAnyNumbersComeBack() {
    Random random = seeded(3, 1);
    std::uniform_int_distribution<std::uint64_t> number;
    std::uniform_int_distribution<int> kind(1, 255);
    std::uniform_int_distribution<std::size_t> length(0, 600);
    RecordPacker packer;
    std::vector<Record> records;
    std::vector<std::unique_ptr<std::string>> texts;
    for (int i = 0; i < 3000; ++i) {
        Record record{.kind = static_cast<RecordKind>(kind(random)),
                      .time = RecordTime(static_cast<std::int64_t>(number(random) >> 1)),
                      .line = {number(random)}};
        texts.push_back(std::make_unique<std::string>(length(random), static_cast<char>(kind(random))));
        record.bytes = *texts.back();
        if (recording::hasLabel(record.kind)) {
            record.trigger = {number(random)};
            record.name = std::string_view(*texts.back()).substr(0, 30);
        }
        packer.add(record);
        records.push_back(record);
    }
    const PackedBatch batch = packer.take();
    PackedBefore before;
    ByteReader bytes(batch.bytes);
    for (const Record& record : records) {
        if (std::ranges::find(batch.groups, bytes.used()) != batch.groups.end())
            before = {};
        QVERIFY(takePacked(bytes, before) == record);
    }
    QVERIFY(bytes.empty() && !bytes.failed() && batch.groups.size() > 2);
}

void tst_PackedRecording::hostileBlocksAreDamage_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("a state beyond the end") << QByteArray("\x00\x7f", 2);
    QTest::newRow("a state of garbage") << QByteArray("\x00\x02\xff\xff", 4);
    QTest::newRow("no compressed bytes") << QByteArray("\x00\x00garbage", 9);
}

void tst_PackedRecording::hostileBlocksAreDamage() {
    QFETCH(QByteArray, body);
    Made file = made(30, false);
    const std::size_t good = file.bytes.size();
    recording::appendBlock(file.bytes, recording::BlockKind::First, body.toStdString());
    const std::size_t size = file.bytes.size() - good;
    put(file.bytes);
    for (const OpenMode mode : {OpenMode::Quick, OpenMode::Thorough}) {
        const auto reader = open(mode);
        QCOMPARE(reader->survey().records, file.records.back());
        QCOMPARE(reader->survey().tail_lost_bytes, size);
    }
}

/// Else a small file could unpack to gigabytes.
void tst_PackedRecording::aGroupThatGoesOnForEverIsDamage() {
    std::string file;
    recording::appendHead(file);
    RecordPacker packer;
    BlockWriter blocks(file.size());
    packer.add({.kind = RecordKind::In, .bytes = std::string(RecordPacker::group_bytes, 'x')});
    blocks.append(file, packer.take());
    const std::size_t good = file.size();
    packer.add({.kind = RecordKind::In, .time = 1s, .bytes = "STA {Time 1}\r\n"});
    PackedBatch more = packer.take();
    QCOMPARE(more.groups, std::vector<std::size_t>{0}); // Here the writer begins another group.
    more.groups.clear();
    blocks.append(file, more);
    put(file);
    const auto reader = open();
    QCOMPARE(reader->survey().records, 1u);
    QCOMPARE(reader->survey().tail_lost_bytes, file.size() - good);
}

/// Much at once: many groups within two seconds, which are compressed the fast way, and records of the longest kind.
void tst_PackedRecording::aFastStretchIsPackedToo() {
    const std::string longest(recording::longest_payload_bytes + 17, 'x');
    Random random = seeded(5, 1);
    std::string line;
    for (int i = 0; i < 200; ++i)
        line += tick(i, random);
    {
        QFile::remove(path());
        auto writer = RecordingWriter::create(path(), {}, {});
        QVERIFY2(writer, writer ? "" : writer.error().text().c_str());
        for (int i = 0; i < 100; ++i)
            (*writer)->write({.kind = RecordKind::In, .bytes = line});
        (*writer)->write({.kind = RecordKind::In, .bytes = longest});
    }
    const auto reader = open();
    QCOMPARE(reader->survey().records, 104u);
    QCOMPARE(reader->survey().bytes_in, 100 * line.size() + longest.size());
    QVERIFY(reader->survey().file_bytes < 100 * line.size() / 2);
    reader->next();
    for (int i = 0; i < 100; ++i)
        QVERIFY(reader->next()->bytes == line);
    QCOMPARE(reader->next()->bytes.size(), recording::longest_payload_bytes);
    QCOMPARE(reader->next()->bytes.size(), std::size_t(17));
}

USAR_TEST(tst_PackedRecording)

} // namespace tst_packed_recording

#include "tst_packed_recording.moc"
