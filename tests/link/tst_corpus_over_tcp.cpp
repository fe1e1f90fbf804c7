// The corpus through a real socket in random chunks: the same lines and the same values as read from memory.
#include <QTest>

#include "core/base/random.h"
#include "core/link/tcp_link.h"
#include "core/protocol/fields.h"
#include "core/protocol/line_splitter.h"
#include "core/protocol/reader.h"
#include "tests/doubles/fake_server.h"
#include "tests/protocol/corpus.h"
#include "tests/suite/suite.h"

namespace tst_corpus_over_tcp {

using namespace usar;

class tst_CorpusOverTcp : public QObject {
    Q_OBJECT
private slots:
    void chunksChangeNothing_data();
    void chunksChangeNothing();
};

void tst_CorpusOverTcp::chunksChangeNothing_data() {
    QTest::addColumn<int>("longest");
    QTest::newRow("single bytes and a few") << 3;
    QTest::newRow("parts of numbers") << 17;
    QTest::newRow("parts of lines") << 300;
    QTest::newRow("several lines") << 5000;
}

void tst_CorpusOverTcp::chunksChangeNothing() {
    QFETCH(int, longest);
    QByteArray bytes;
    std::vector<protocol::InfoLine> expected;
    protocol::LineSplitter splitter;
    protocol::Reader from_memory;
    for (const corpus::Line& line : corpus::infoLines())
        bytes += QByteArray::fromStdString(line.text) + "\r\n";
    splitter.feed({bytes.data(), static_cast<std::size_t>(bytes.size())},
                  [&](std::string_view line) { expected.push_back(from_memory.read(line)); });

    test::FakeServer server;
    QVERIFY(server.listen());
    link::TcpLink link;
    protocol::Reader from_socket;
    std::size_t count = 0;
    std::size_t different = 0;
    link.setLineTaker([&](std::string_view text) {
        const protocol::InfoLine& line = from_socket.read(text);
        const protocol::InfoLine& other = expected.at(count++);
        const bool same = line.text == other.text && line.number == other.number &&
                          line.diagnostics == other.diagnostics &&
                          protocol::fieldsOf(line.message) == protocol::fieldsOf(other.message);
        different += same ? 0 : 1;
    });
    link.open("127.0.0.1", server.port());
    QTRY_VERIFY(server.hasClient());
    Random random = seeded(3, static_cast<std::uint64_t>(longest));
    for (qsizetype at = 0; at < bytes.size();) {
        const auto size = static_cast<qsizetype>(1 + random() % static_cast<std::uint64_t>(longest));
        server.sayInChunks(bytes.mid(at, size), size);
        at += size;
    }
    QTRY_COMPARE(count, expected.size());
    QCOMPARE(different, std::size_t(0));
    QVERIFY(count > 40);
}

USAR_TEST(tst_CorpusOverTcp)

} // namespace tst_corpus_over_tcp

#include "tst_corpus_over_tcp.moc"
