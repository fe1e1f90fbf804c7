#include <QTest>

#include <algorithm>
#include <set>

#include "core/base/random.h"
#include "core/protocol/reader.h"
#include "core/protocol/writer.h"
#include "corpus.h"
#include "tests/suite/suite.h"

namespace tst_reader_corpus {

using namespace usar;
using namespace std::string_literals;
using namespace usar::protocol;

namespace {

/// Stays generic: of no server's robot port, or a word whose content nobody knows.
bool isForeign(const GenericMessage& message) {
    static const std::set<std::string> words = {"INITREPLY", "SS", "DNSREPLY", "REVERSEDNSREPLY", "ERROR"};
    return words.contains(message.type_word);
}

bool hasNews(const GenericMessage& message) {
    for (const KeyValue& segment : message.segments) {
        if (segment.key != "Type" && segment.key != "Time" && segment.key != "Name")
            return true;
    }
    return false;
}

GenericMessage genericOf(const std::string& line) {
    Segments segments;
    Diagnostics diagnostics;
    segments.read(line, diagnostics);
    GenericMessage message{std::string(segments.typeWord()), std::string(segments.value("Type")), "", {}};
    for (const Segment& segment : segments.all())
        message.segments.push_back({std::string(segment.key), std::string(segment.value)});
    return message;
}

/// A small negative number is written as -0.00, but it is read as a zero without a sign.
QByteArray withoutSignsOfZeros(const std::string& line) {
    QByteArray text = QByteArray::fromStdString(line);
    for (const char* const zero : {"-0.00,", "-0.00}", "-0.00 "})
        text.replace(zero, zero + 1);
    return text;
}

} // namespace

class tst_ReaderCorpus : public QObject {
    Q_OBJECT
private slots:
    void capturedLinesReadCleanlyIntoTheirContainers_data();
    void capturedLinesReadCleanlyIntoTheirContainers();
    void everyCleanLineHasAContainer();
    void everyLineIsKeptWhole();
    void everyPrefixOfEveryLineIsRead();
    void everyDamagedByteOfTwoHundredLinesIsRead();
    void damageNeverBreaksReading();
    void writingWhatWasReadReadsTheSameAgain();
};

void tst_ReaderCorpus::capturedLinesReadCleanlyIntoTheirContainers_data() {
    QTest::addColumn<QByteArray>("line");
    bool any = false;
    for (const corpus::Line& line : corpus::infoLines()) {
        // Ours are all sound; of the larger collection the captured ones are, the rest holds odd samples on purpose.
        if (line.captured || line.source.find("our own") != std::string::npos) {
            QTest::newRow(line.place.c_str()) << QByteArray::fromStdString(line.text);
            any = true;
        }
    }
    QVERIFY(any);
}

void tst_ReaderCorpus::capturedLinesReadCleanlyIntoTheirContainers() {
    QFETCH(QByteArray, line);
    Reader reader;
    const InfoLine result = reader.read(line.toStdString());
    for (const Diagnostic& diagnostic : result.diagnostics)
        QFAIL(toText(diagnostic).c_str());
    const GenericMessage* const generic = std::get_if<GenericMessage>(&result.message);
    if (!generic || !hasNews(*generic))
        return;
    QVERIFY2(isForeign(*generic), line.constData());
}

void tst_ReaderCorpus::everyCleanLineHasAContainer() {
    Reader reader;
    for (const corpus::Line& line : corpus::infoLines()) {
        const InfoLine& result = reader.read(line.text);
        const GenericMessage* const generic = std::get_if<GenericMessage>(&result.message);
        const bool says_nothing = line.text == "GEO {Deprecated call to mission package api}";
        if (generic && hasNews(*generic) && result.diagnostics.empty() && !says_nothing)
            QVERIFY2(isForeign(*generic), line.place.c_str());
    }
}

void tst_ReaderCorpus::everyLineIsKeptWhole() {
    Reader reader;
    for (const corpus::Line& line : corpus::infoLines()) {
        const InfoLine result = reader.read(line.text);
        QCOMPARE(result.text, line.text);
        if (const GenericMessage* const generic = std::get_if<GenericMessage>(&result.message))
            QVERIFY2(generic->segments == genericOf(line.text).segments, line.place.c_str());
    }
}

void tst_ReaderCorpus::everyPrefixOfEveryLineIsRead() {
    Reader reader;
    for (const corpus::Line& line : corpus::infoLines()) {
        for (std::size_t length = 0; length <= line.text.size(); ++length) {
            const InfoLine result = reader.read(line.text.substr(0, length));
            QCOMPARE(result.text.size(), length);
            for (const Diagnostic& diagnostic : result.diagnostics)
                QVERIFY2(diagnostic.offset <= length, line.place.c_str());
        }
    }
}

void tst_ReaderCorpus::everyDamagedByteOfTwoHundredLinesIsRead() {
    const std::vector<corpus::Line> lines = corpus::infoLines();
    const std::string damage = "{} ,x9\0\xff"s;
    const std::size_t stride = std::max<std::size_t>(1, lines.size() / 200);
    Reader reader;
    for (std::size_t i = 0; i < lines.size(); i += stride) {
        std::string text = lines[i].text;
        for (char& byte : text) {
            const char whole = byte;
            for (const char wrong : damage) {
                byte = wrong;
                const InfoLine& result = reader.read(text);
                QCOMPARE(result.text, text);
                for (const Diagnostic& diagnostic : result.diagnostics)
                    QVERIFY2(diagnostic.offset <= text.size(), lines[i].place.c_str());
            }
            byte = whole;
        }
    }
}

void tst_ReaderCorpus::damageNeverBreaksReading() {
    const std::vector<corpus::Line> lines = corpus::infoLines();
    const std::string damage = "{} ,.-+e#\0\xff"s + "0naNIf";
    Random random = seeded(21, 1);
    Reader reader;
    for (int round = 0; round < 20000; ++round) {
        std::string text = lines[random() % lines.size()].text;
        for (std::size_t hits = 1 + random() % 4; hits > 0 && !text.empty(); --hits) {
            const std::size_t at = random() % text.size();
            if (random() % 3 == 0)
                text.erase(at, 1 + random() % 5);
            else
                text[at] = damage[random() % damage.size()];
        }
        const InfoLine result = reader.read(text);
        QCOMPARE(result.text, text);
        if (const auto* truth = std::get_if<GroundTruthReading>(&result.message))
            QVERIFY2(truth->base_in_map.position_m.allFinite(), text.c_str());
    }
}

void tst_ReaderCorpus::writingWhatWasReadReadsTheSameAgain() {
    Reader reader;
    for (const corpus::Line& line : corpus::infoLines()) {
        std::string once;
        std::string twice;
        write(reader.read(line.text).message, once);
        write(reader.read(once).message, twice);
        QCOMPARE(withoutSignsOfZeros(twice), withoutSignsOfZeros(once));
    }
}

USAR_TEST(tst_ReaderCorpus)

} // namespace tst_reader_corpus

#include "tst_reader_corpus.moc"
