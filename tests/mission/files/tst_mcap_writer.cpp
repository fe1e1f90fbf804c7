// MCAP files: what is written is read by a reader of the specification, chunk by chunk, whatever the sink takes.
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

#include "core/mission/files/mcap_schemas.h"
#include "core/mission/files/mcap_writer.h"
#include "tests/doubles/mcap_file.h"
#include "tests/suite/suite.h"

namespace tst_mcap_writer {

using namespace usar;
using namespace usar::mission;

namespace {

struct Written {
    std::string bytes;
    std::size_t longest_piece = 0;
    mapping::ByteSink sink() {
        return [this](const char* data, std::size_t size) {
            bytes.append(data, size);
            longest_piece = std::max(longest_piece, size);
            return true;
        };
    }
};

std::string message(int number) {
    return "{\"number\":" + std::to_string(number) + "}";
}

} // namespace

class tst_McapWriter : public QObject {
    Q_OBJECT
private slots:
    void whatIsWrittenIsRead_data() {
        QTest::addColumn<int>("messages");
        QTest::addColumn<int>("channels");
        QTest::addColumn<int>("chunk_bytes");
        QTest::addColumn<int>("chunks");
        QTest::newRow("nothing") << 0 << 0 << 1000 << 0;
        QTest::newRow("channels without messages") << 0 << 3 << 1000000 << 1;
        QTest::newRow("one message") << 1 << 1 << 1000000 << 1;
        QTest::newRow("several channels in one chunk") << 100 << 7 << 1000000 << 1;
        QTest::newRow("a chunk for each message") << 20 << 2 << 1 << 20;
        QTest::newRow("many chunks") << 5000 << 5 << 4096 << 61;
    }

    void whatIsWrittenIsRead() {
        QFETCH(int, messages);
        QFETCH(int, channels);
        QFETCH(int, chunk_bytes);
        QFETCH(int, chunks);
        Written written;
        McapWriter writer(written.sink(), static_cast<std::size_t>(chunk_bytes));
        std::vector<McapChannel> ids;
        for (int channel = 0; channel < channels; ++channel)
            ids.push_back(writer.addChannel("/topic" + std::to_string(channel),
                                            channel % 2 == 0 ? schemas::log() : schemas::range()));
        for (int number = 0; number < messages; ++number) {
            const auto time_ns = static_cast<std::uint64_t>(1000 - number % 10 + number); // Not in order.
            writer.write(ids[static_cast<std::size_t>(number % channels)], {time_ns, time_ns - 1}, message(number));
        }
        writer.finish();
        QVERIFY(writer.good());
        QCOMPARE(writer.size(), std::uint64_t(written.bytes.size()));
        std::string trouble;
        const auto file = doubles::readMcap(written.bytes, trouble);
        QVERIFY2(file, trouble.c_str());
        QCOMPARE(file->messages.size(), std::size_t(messages));
        QVERIFY2(std::abs(int(file->chunks) - chunks) <= chunks / 10, qPrintable(QString::number(file->chunks)));
        for (int number = 0; number < messages; ++number) {
            const doubles::McapMessage& read = file->messages[static_cast<std::size_t>(number)];
            QCOMPARE(read.topic, "/topic" + std::to_string(number % channels));
            QCOMPARE(read.data, message(number));
            QCOMPARE(read.logged_ns, std::uint64_t(1000 - number % 10 + number));
            QCOMPARE(read.published_ns, read.logged_ns - 1);
        }
    }

    void theReaderSeesEveryWrongByteOfTheFrame() {
        Written written;
        McapWriter writer(written.sink(), 200);
        const McapChannel channel = writer.addChannel("/a", schemas::range());
        for (int number = 0; number < 20; ++number)
            writer.write(channel, {std::uint64_t(number), 0}, message(number));
        writer.finish();
        const std::string library = "USAR Mission Control";
        const auto named = written.bytes.find(library);
        int unseen = 0;
        for (std::size_t at = 0; at < written.bytes.size(); ++at) {
            const bool is_free = at >= named && at < named + library.size() + 6;
            std::string wrong = written.bytes;
            wrong[at] = static_cast<char>(wrong[at] ^ 0x55);
            std::string trouble;
            unseen += !is_free && doubles::readMcap(wrong, trouble) ? 1 : 0;
        }
        QVERIFY2(unseen <= 4, qPrintable(QString::number(unseen))); // The data's checksum, which is not given.
    }

    void holdsNoMoreThanAChunk() {
        constexpr std::size_t chunk_bytes = 10000;
        Written written;
        McapWriter writer(written.sink(), chunk_bytes);
        const McapChannel channel = writer.addChannel("/a", schemas::range());
        for (int number = 0; number < 20000; ++number) {
            writer.write(channel, {std::uint64_t(number), 0}, message(number));
            QVERIFY(writer.size() - written.bytes.size() < chunk_bytes);
        }
        QVERIFY2(written.longest_piece < chunk_bytes + 100, "the pieces are chunks and their indexes");
    }

    void aSinkThatRefusesIsLeftAlone() {
        int calls = 0;
        McapWriter writer([&](const char*, std::size_t) { return ++calls < 3; }, 100);
        const McapChannel channel = writer.addChannel("/a", schemas::range());
        for (int number = 0; number < 1000; ++number)
            writer.write(channel, {}, message(number));
        writer.finish();
        QVERIFY(!writer.good());
        QCOMPARE(calls, 3);
    }

    void schemasAreJsonSchemasOfTheirNames_data() {
        QTest::addColumn<const McapSchema*>("schema");
        QTest::addColumn<QString>("name");
        const std::pair<const McapSchema*, const char*> all[] = {
            {&schemas::poseInFrame(), "foxglove.PoseInFrame"},
            {&schemas::posesInFrame(), "foxglove.PosesInFrame"},
            {&schemas::frameTransform(), "foxglove.FrameTransform"},
            {&schemas::laserScan(), "foxglove.LaserScan"},
            {&schemas::rawImage(), "foxglove.RawImage"},
            {&schemas::grid(), "foxglove.Grid"},
            {&schemas::log(), "foxglove.Log"},
            {&schemas::range(), "usar.Range"},
            {&schemas::command(), "usar.Command"},
            {&schemas::status(), "usar.Status"},
            {&schemas::plan(), "usar.Plan"}};
        for (const auto& [schema, name] : all)
            QTest::newRow(name) << schema << QString(name);
    }

    void schemasAreJsonSchemasOfTheirNames() {
        QFETCH(const McapSchema*, schema);
        QFETCH(QString, name);
        QCOMPARE(QString::fromStdString(std::string(schema->name)), name);
        const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(std::string(schema->json))).object();
        QCOMPARE(json["title"].toString(), name);
        QCOMPARE(json["type"].toString(), QString("object"));
        const QJsonObject properties = json["properties"].toObject();
        QVERIFY(json["required"].toArray().contains("timestamp"));
        for (const auto& required : json["required"].toArray())
            QVERIFY2(properties.contains(required.toString()), qPrintable(required.toString()));
        QVERIFY(properties["timestamp"].toObject()["properties"].toObject().contains("nsec"));
    }
};

USAR_TEST(tst_McapWriter)

} // namespace tst_mcap_writer

#include "tst_mcap_writer.moc"
