#include <QTest>

#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/protocol/line_splitter.h"
#include "corpus.h"
#include "tests/suite/suite.h"

namespace tst_line_splitter {

using namespace usar;
using protocol::LineSplitter;
using Lines = std::vector<std::string>;

namespace {

Lines linesOf(LineSplitter& splitter, const std::vector<std::string>& chunks) {
    Lines lines;
    for (const std::string& chunk : chunks)
        splitter.feed(chunk, [&lines](std::string_view line) { lines.emplace_back(line); });
    return lines;
}

std::vector<std::string> cutAtRandom(const std::string& bytes, Random& random) {
    std::vector<std::string> chunks;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t length = 1 + random() % (random() % 4 == 0 ? 1500 : 7);
        chunks.push_back(bytes.substr(at, length));
        at += length;
    }
    return chunks;
}

} // namespace

class tst_LineSplitter : public QObject {
    Q_OBJECT
private slots:
    void everyTerminatorInTheWildEndsALine_data();
    void everyTerminatorInTheWildEndsALine();
    void anUnfinishedLineWaits();
    void chunkingChangesNothing();
    void splitGivesTheSameLinesAtOnce();
    void recordedChunksGiveTheSameLinesAsOnePiece();
    void dropsALineOverTheCapAndGoesOnBehindIt_data();
    void dropsALineOverTheCapAndGoesOnBehindIt();
    void theDefaultCapIsFourMebibytes();
    void resetForgetsTheUnfinishedLine();
};

void tst_LineSplitter::everyTerminatorInTheWildEndsALine_data() {
    QTest::addColumn<QByteArray>("terminator");
    QTest::newRow("carriage return, line feed") << QByteArray("\r\n");
    QTest::newRow("pyro's line feed, carriage return") << QByteArray("\n\r");
    QTest::newRow("AP2DX's blank line") << QByteArray("\r\n\n");
    QTest::newRow("netcat's line feed") << QByteArray("\n");
    QTest::newRow("carriage return alone") << QByteArray("\r");
}

void tst_LineSplitter::everyTerminatorInTheWildEndsALine() {
    QFETCH(QByteArray, terminator);
    const std::string end = terminator.toStdString();
    LineSplitter splitter;
    QCOMPARE(linesOf(splitter, {"STEP" + end + "DRIVE {Left 1}" + end}), (Lines{"STEP", "DRIVE {Left 1}"}));
    QCOMPARE(splitter.pending().size(), std::size_t(0));
}

void tst_LineSplitter::anUnfinishedLineWaits() {
    LineSplitter splitter;
    QVERIFY(linesOf(splitter, {"SEN {Range 2.37", "89"}).empty());
    QCOMPARE(splitter.pending().size(), std::size_t(17));
    QCOMPARE(linesOf(splitter, {",2.44}\r"}), Lines{"SEN {Range 2.3789,2.44}"});
    QVERIFY(linesOf(splitter, {"\n"}).empty());
}

void tst_LineSplitter::chunkingChangesNothing() {
    std::string bytes;
    Lines expected;
    for (const corpus::Line& line : corpus::infoLines()) {
        bytes += line.text + "\r\n";
        expected.push_back(line.text);
    }
    QVERIFY(expected.size() > 40);
    Random random = seeded(11, 1);
    for (int round = 0; round < 50; ++round) {
        LineSplitter splitter;
        QCOMPARE(linesOf(splitter, cutAtRandom(bytes, random)), expected);
    }
}

void tst_LineSplitter::splitGivesTheSameLinesAtOnce() {
    std::string bytes;
    for (const corpus::Line& line : corpus::infoLines())
        bytes += line.text + "\r\n";
    Random random = seeded(12, 1);
    for (int round = 0; round < 50; ++round) {
        LineSplitter one_by_one(200);
        LineSplitter at_once(200);
        std::vector<std::string_view> lines;
        for (const std::string& chunk : cutAtRandom(bytes, random)) {
            at_once.split(chunk, lines);
            QCOMPARE(Lines(lines.begin(), lines.end()), linesOf(one_by_one, {chunk}));
            QCOMPARE(at_once.pending(), one_by_one.pending());
        }
        QVERIFY(one_by_one.overlongCount() > 0);
        QCOMPARE(at_once.overlongCount(), one_by_one.overlongCount());
    }
}

void tst_LineSplitter::recordedChunksGiveTheSameLinesAsOnePiece() {
    const std::vector<std::string> chunks = corpus::recordedChunks();
    QVERIFY(chunks.size() > 10);
    std::string whole;
    for (const std::string& chunk : chunks)
        whole += chunk;
    LineSplitter by_chunk;
    LineSplitter at_once;
    const Lines lines = linesOf(by_chunk, chunks);
    QCOMPARE(lines, linesOf(at_once, {whole}));
    for (const std::string& line : lines)
        QVERIFY2(line.find('{') != std::string::npos, line.c_str());
}

void tst_LineSplitter::dropsALineOverTheCapAndGoesOnBehindIt_data() {
    QTest::addColumn<int>("chunk_bytes");
    QTest::newRow("in one piece") << 1000;
    QTest::newRow("in pieces shorter than the cap") << 7;
    QTest::newRow("byte by byte") << 1;
}

void tst_LineSplitter::dropsALineOverTheCapAndGoesOnBehindIt() {
    QFETCH(int, chunk_bytes);
    const std::string bytes = "first\r\n" + std::string(21, 'x') + "\r\n" + std::string(20, 'y') + "\nlast\n";
    std::vector<std::string> chunks;
    for (std::size_t at = 0; at < bytes.size(); at += static_cast<std::size_t>(chunk_bytes))
        chunks.push_back(bytes.substr(at, static_cast<std::size_t>(chunk_bytes)));
    LineSplitter splitter(20);
    QCOMPARE(linesOf(splitter, chunks), (Lines{"first", std::string(20, 'y'), "last"}));
    QCOMPARE(splitter.overlongCount(), std::size_t(1));
}

void tst_LineSplitter::theDefaultCapIsFourMebibytes() {
    const std::string longest(4u << 20, 'a');
    LineSplitter splitter;
    QCOMPARE(linesOf(splitter, {longest, "\n"}).size(), std::size_t(1));
    QVERIFY(linesOf(splitter, {longest, "b", "\n"}).empty());
    QCOMPARE(splitter.pending().size(), std::size_t(0));
    QCOMPARE(linesOf(splitter, {"NFO\n"}), Lines{"NFO"});
}

void tst_LineSplitter::resetForgetsTheUnfinishedLine() {
    LineSplitter splitter(8);
    linesOf(splitter, {"123456789"});
    splitter.reset();
    QCOMPARE(linesOf(splitter, {"half"}), Lines{});
    splitter.reset();
    QCOMPARE(linesOf(splitter, {"whole\n"}), Lines{"whole"});
}

USAR_TEST(tst_LineSplitter)

} // namespace tst_line_splitter

#include "tst_line_splitter.moc"
