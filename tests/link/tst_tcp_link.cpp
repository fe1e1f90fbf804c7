#include <QSignalSpy>
#include <QTest>

#include "core/link/tcp_link.h"
#include "tests/doubles/fake_server.h"
#include "tests/suite/suite.h"

namespace tst_tcp_link {

using namespace usar;
using namespace usar::link;
using usar::test::FakeServer;

namespace {

constexpr char greeting[] = "NFO {Gametype BotDeathMatch} {Level DM-tall_test} {TimeLimit 0}\r\n";

/// Limits that a test can wait for; the proportions of the real ones.
LinkLimits quickLimits() {
    return {.connect_timeout = Seconds{0.3}, .first_retry = Seconds{0.02}, .longest_retry = Seconds{0.08}};
}

/// A port that nobody listens at: it was free a moment ago.
quint16 deadPort() {
    FakeServer server;
    server.listen();
    return server.port();
}

} // namespace

class tst_TcpLink : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();

    void connectsAndGivesWholeLines_data();
    void connectsAndGivesWholeLines();
    void showsTheLinesThatCameTogetherBeforeItGivesThem();
    void sendsLinesWithCrLf();
    void closeSendsWhatIsQueuedAndStaysClosed();
    void saysWhyItCannotConnect_data();
    void saysWhyItCannotConnect();
    void givesUpOnAHostThatDoesNotAnswer();
    void backsOffByDoublingUpToTheLongest();
    void reconnectsByItselfWhenTheServerIsBack();
    void saysSoWhenTheServerClosesInTheMiddleOfALine();
    void tellsWhatDoesNotSpeakUsarsim_data();
    void tellsWhatDoesNotSpeakUsarsim();
    void dropsAnEndlessLineAndGoesOn();
    void mayBeClosedAndReopenedByWhoTakesTheLines();
    void tellsTheTimeToTheServerAndBack();
    void sendingWithoutAConnectionIsHarmless();
    void aServerThatReadsNoMoreIsLeftBeforeMemoryIsFull();

private:
    std::unique_ptr<FakeServer> server_;
    std::unique_ptr<TcpLink> link_;
    QList<QByteArray> lines_;
};

void tst_TcpLink::init() {
    server_ = std::make_unique<FakeServer>();
    QVERIFY(server_->listen());
    link_ = std::make_unique<TcpLink>();
    link_->setLimits(quickLimits());
    link_->setLineTaker(
        [this](std::string_view line) { lines_.append(QByteArray(line.data(), static_cast<qsizetype>(line.size()))); });
    lines_.clear();
}

void tst_TcpLink::cleanup() {
    link_.reset();
    server_.reset();
}

void tst_TcpLink::connectsAndGivesWholeLines_data() {
    QTest::addColumn<int>("chunk_size");
    QTest::newRow("at once") << 100000;
    QTest::newRow("in halves of numbers") << 7;
    QTest::newRow("byte by byte") << 1;
}

void tst_TcpLink::connectsAndGivesWholeLines() {
    QFETCH(int, chunk_size);
    server_->on_connect = [&] {
        server_->sayInChunks(QByteArray(greeting) + "STA {Type AerialVehicle} {Time 1.25}\n\r\nSEN {Type INS}\r\n",
                             chunk_size);
    };
    QSignalSpy opened(link_.get(), &TcpLink::opened);
    link_->open("127.0.0.1", server_->port());
    QCOMPARE(link_->status().state, LinkState::Connecting);
    QTRY_COMPARE(lines_.size(), 3);
    QCOMPARE(lines_.at(0), QByteArray(greeting).trimmed());
    QCOMPARE(lines_.at(1), QByteArray("STA {Type AerialVehicle} {Time 1.25}"));
    QCOMPARE(lines_.at(2), QByteArray("SEN {Type INS}"));
    QCOMPARE(opened.size(), 1);
    QCOMPARE(link_->status().state, LinkState::Connected);
    QVERIFY(link_->status().reason.isEmpty());
}

void tst_TcpLink::showsTheLinesThatCameTogetherBeforeItGivesThem() {
    QList<QByteArray> ahead;
    link_->setAheadTaker([&](std::span<const std::string_view> lines) {
        for (const std::string_view line : lines)
            ahead.append(QByteArray::number(lines_.size()) + ' ' + QByteArray(line.data(), qsizetype(line.size())));
    });
    server_->on_connect = [&] { server_->say(greeting); };
    link_->open("127.0.0.1", server_->port());
    QTRY_COMPARE(lines_.size(), 1);
    server_->say("SEN {Type INS}\r\nSTA {Time 1}\r\nSTA {Ti");
    QTRY_COMPARE(lines_.size(), 3);
    server_->say("me 2}\r\n");
    QTRY_COMPARE(lines_.size(), 4);
    QCOMPARE(lines_.at(3), QByteArray("STA {Time 2}"));
    QCOMPARE(ahead, (QList<QByteArray>{"1 SEN {Type INS}", "1 STA {Time 1}"})); // Neither the greeting nor one alone.
}

void tst_TcpLink::sendsLinesWithCrLf() {
    QSignalSpy opened(link_.get(), &TcpLink::opened);
    link_->open("127.0.0.1", server_->port());
    QTRY_COMPARE(opened.size(), 1);
    link_->send("GETSTARTPOSES");
    link_->send("INIT {ClassName USARBot.AirRobot}");
    QTRY_COMPARE(server_->heard().size(), 2);
    QCOMPARE(server_->heard().at(1), QByteArray("INIT {ClassName USARBot.AirRobot}"));
}

void tst_TcpLink::closeSendsWhatIsQueuedAndStaysClosed() {
    QSignalSpy opened(link_.get(), &TcpLink::opened);
    QSignalSpy closed(link_.get(), &TcpLink::closed);
    link_->open("127.0.0.1", server_->port());
    QTRY_COMPARE(opened.size(), 1);
    link_->send("DRIVE {AltitudeVelocity 0}");
    link_->close();
    QCOMPARE(closed.size(), 1);
    QCOMPARE(link_->status().state, LinkState::Disconnected);
    QTRY_COMPARE(server_->heard().size(), 1);
    QTRY_VERIFY(!server_->hasClient());
    QCOMPARE(server_->connectionCount(), 1);
}

void tst_TcpLink::saysWhyItCannotConnect_data() {
    QTest::addColumn<QString>("host");
    QTest::addColumn<QString>("words");
    QTest::newRow("nobody listens") << "127.0.0.1"
                                    << "Nothing listens at 127.0.0.1:";
    QTest::newRow("no such host") << "no-such-host.invalid"
                                  << "There is no host named \"no-such-host.invalid\"";
    QTest::newRow("no host at all") << "  "
                                    << "There is no host named \"\"";
}

void tst_TcpLink::saysWhyItCannotConnect() {
    QFETCH(QString, host);
    QFETCH(QString, words);
    LinkLimits limits = quickLimits();
    limits.connect_timeout = Seconds{20.0}; // a resolver may take its time to say no
    link_->setLimits(limits);
    link_->open(host, deadPort());
    QTRY_COMPARE_WITH_TIMEOUT(link_->status().state, LinkState::Waiting, 20000);
    QVERIFY2(link_->status().reason.contains(words), qPrintable(link_->status().reason));
    QVERIFY2(link_->status().reason.contains("Check the spelling") || link_->status().reason.contains("check the port"),
             qPrintable(link_->status().reason));
    QVERIFY(link_->status().reason.contains("Retrying in"));
}

void tst_TcpLink::givesUpOnAHostThatDoesNotAnswer() {
    // A server whose queue of unaccepted connections is full does not answer the handshake.
    QTcpServer deaf;
    deaf.setListenBacklogSize(1);
    QVERIFY(deaf.listen(QHostAddress::LocalHost));
    deaf.pauseAccepting();
    std::vector<std::unique_ptr<QTcpSocket>> queue;
    for (int i = 0; i < 4; ++i) {
        queue.push_back(std::make_unique<QTcpSocket>());
        queue.back()->connectToHost(QHostAddress::LocalHost, deaf.serverPort());
    }
    QTRY_VERIFY(queue.front()->state() == QAbstractSocket::ConnectedState);
    link_->open("127.0.0.1", deaf.serverPort());
    QTRY_COMPARE(link_->status().state, LinkState::Waiting);
    const QString reason = link_->status().reason;
    QVERIFY2(reason.startsWith(QStringLiteral("No answer from 127.0.0.1:%1 after 0.3 s. Is USARSim running there?")
                                   .arg(deaf.serverPort())),
             qPrintable(reason));
}

void tst_TcpLink::backsOffByDoublingUpToTheLongest() {
    QSignalSpy changes(link_.get(), &TcpLink::statusChanged);
    link_->open("127.0.0.1", deadPort());
    QList<double> waits_s;
    const auto collect = [&] {
        waits_s.clear();
        for (const QList<QVariant>& change : changes)
            if (const auto status = change.at(0).value<LinkStatus>(); status.state == LinkState::Waiting)
                waits_s.append(status.retry_in.count());
        return waits_s.size();
    };
    QTRY_VERIFY(collect() >= 4);
    waits_s.resize(4);
    QCOMPARE(waits_s, (QList<double>{0.02, 0.04, 0.08, 0.08}));
}

void tst_TcpLink::reconnectsByItselfWhenTheServerIsBack() {
    const quint16 port = server_->port();
    server_->on_connect = [&] { server_->say(greeting); };
    QSignalSpy opened(link_.get(), &TcpLink::opened);
    QSignalSpy closed(link_.get(), &TcpLink::closed);
    link_->open("127.0.0.1", port);
    QTRY_COMPARE(lines_.size(), 1);
    server_->hangUp();
    server_->stopListening();
    QTRY_COMPARE(closed.size(), 1);
    QTRY_VERIFY(link_->status().reason.startsWith("Nothing listens"));
    QVERIFY(server_->listen(port));
    QTRY_COMPARE(opened.size(), 2);
    QTRY_COMPARE(lines_.size(), 2);
    QVERIFY(link_->status().reason.isEmpty());
}

void tst_TcpLink::saysSoWhenTheServerClosesInTheMiddleOfALine() {
    server_->on_connect = [&] {
        server_->stopListening();
        server_->say(QByteArray(greeting) + "SEN {Type RangeScanner} {Name Sc");
        server_->hangUp();
    };
    QSignalSpy closed(link_.get(), &TcpLink::closed);
    QSignalSpy changes(link_.get(), &TcpLink::statusChanged);
    link_->open("127.0.0.1", server_->port());
    QTRY_COMPARE(closed.size(), 1);
    QCOMPARE(lines_.size(), 1); // the half line is nobody's
    QStringList reasons;
    for (const QList<QVariant>& change : changes)
        reasons.append(change.at(0).value<LinkStatus>().reason);
    QVERIFY2(reasons.join('\n').contains("closed the connection. Did it end, change its map, or is it full?"),
             qPrintable(reasons.join('\n')));
}

void tst_TcpLink::tellsWhatDoesNotSpeakUsarsim_data() {
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<bool>("hangs_up");
    QTest::newRow("a web server") << QByteArray("HTTP/1.1 400 Bad Request\r\nServer: x\r\n\r\n") << true;
    QTest::newRow("a shell") << QByteArray("SSH-2.0-OpenSSH_9.2p1\r\n") << false;
    QTest::newRow("the image server") << QByteArray("\x01\x00\x00\x10\x20\xff\xd8\xff\xe0", 9) << false;
    QTest::newRow("one strange word and gone") << QByteArray("ERR unknown command\r\n") << true;
    QTest::newRow("a chat") << QByteArray("Hi there!\nWhat is\nyour name?\n") << false;
}

void tst_TcpLink::tellsWhatDoesNotSpeakUsarsim() {
    QFETCH(QByteArray, answer);
    QFETCH(bool, hangs_up);
    server_->on_connect = [&] {
        server_->say(answer);
        if (hangs_up)
            server_->hangUp();
    };
    link_->open("127.0.0.1", server_->port());
    QTRY_COMPARE(link_->status().state, LinkState::Waiting);
    QVERIFY2(link_->status().reason.contains("does not speak USARSim. Check the port"),
             qPrintable(link_->status().reason));
}

void tst_TcpLink::dropsAnEndlessLineAndGoesOn() {
    server_->on_connect = [&] {
        server_->say(QByteArray(greeting));
        server_->say(QByteArray("SEN {Type Kinect} {Data ") + QByteArray(5 << 20, '7'));
        server_->say(QByteArray(100, '7') + "}\r\nSTA {Time 2.00}\r\n");
    };
    link_->open("127.0.0.1", server_->port());
    QTRY_COMPARE(lines_.size(), 2);
    QCOMPARE(lines_.at(1), QByteArray("STA {Time 2.00}"));
    QCOMPARE(link_->overlongCount(), std::size_t(1));
    const protocol::TrafficCounts counts = link_->counts();
    QCOMPARE(counts.dropped, std::uint64_t(1));
    QCOMPARE(counts.lines_in, std::uint64_t(2));
    QVERIFY(counts.bytes_in > 5U << 20);
    server_->on_connect = [&] { server_->say(QByteArray(greeting)); };
    link_->open("127.0.0.1", server_->port());
    QTRY_COMPARE(lines_.size(), 3);
    QCOMPARE(link_->counts().dropped, std::uint64_t(0)); // of the new connection
    QCOMPARE(link_->counts().lines_in, std::uint64_t(1));
    QCOMPARE(link_->counts().bytes_in, std::uint64_t{sizeof greeting - 1});
}

void tst_TcpLink::mayBeClosedAndReopenedByWhoTakesTheLines() {
    server_->on_connect = [&] { server_->say(QByteArray(greeting) + "STA {Time 1.00}\r\nSTA {Ti"); };
    link_->setLineTaker([this](std::string_view line) {
        lines_.append(QByteArray(line.data(), static_cast<qsizetype>(line.size())));
        if (server_->connectionCount() == 1)
            link_->open("127.0.0.1", server_->port());
    });
    link_->open("127.0.0.1", server_->port());
    QTRY_COMPARE(lines_.size(), 3);
    QCOMPARE(server_->connectionCount(), 2);
    QCOMPARE(lines_.at(0), lines_.at(1)); // the greetings of both connections, and nothing of the first behind it
    QCOMPARE(lines_.at(2), QByteArray("STA {Time 1.00}"));
}

void tst_TcpLink::tellsTheTimeToTheServerAndBack() {
    QVERIFY(!link_->roundTrip());
    link_->open(QStringLiteral("127.0.0.1"), server_->port());
    QTRY_COMPARE(link_->status().state, LinkState::Connected);
    link_->send("GETSTARTPOSES");
    QTRY_VERIFY(link_->roundTrip());
    QVERIFY2(link_->roundTrip()->count() > 0.0 && link_->roundTrip()->count() < 1.0, // It is this machine.
             qPrintable(QString::number(link_->roundTrip()->count())));
    link_->close();
    QVERIFY(!link_->roundTrip());
}

void tst_TcpLink::sendingWithoutAConnectionIsHarmless() {
    link_->send("DRIVE {Left 1}");
    link_->close();
    QCOMPARE(link_->status().state, LinkState::Disconnected);
    QSignalSpy opened(link_.get(), &TcpLink::opened);
    link_->open("127.0.0.1", server_->port());
    QTRY_COMPARE(opened.size(), 1);
    link_->send("GETSTARTPOSES");
    QTRY_COMPARE(server_->heard(), QList<QByteArray>{"GETSTARTPOSES"});
}

void tst_TcpLink::aServerThatReadsNoMoreIsLeftBeforeMemoryIsFull() {
    LinkLimits limits = quickLimits();
    limits.most_unsent_bytes = 1u << 20;
    link_->setLimits(limits);
    link_->open("127.0.0.1", server_->port());
    QTRY_VERIFY(server_->hasClient() && link_->status().state == LinkState::Connected);
    server_->setDeaf(true);
    QString trouble;
    connect(link_.get(), &TcpLink::statusChanged, this, [&](const LinkStatus& status) {
        if (status.state == LinkState::Waiting)
            trouble = status.trouble;
    });
    const QByteArray line(60, 'x');
    std::size_t most_unsent = 0;
    const auto send_some = [&] {
        for (int i = 0; i < 2000; ++i)
            link_->send({line.data(), static_cast<std::size_t>(line.size())});
        most_unsent = std::max(most_unsent, link_->unsentBytes());
        return !trouble.isEmpty();
    };
    QTRY_VERIFY_WITH_TIMEOUT(send_some(), 20000);
    QVERIFY2(trouble.contains("reads no commands any more: 1."), qPrintable(trouble));
    QVERIFY(most_unsent < limits.most_unsent_bytes + 200'000);
    server_->setDeaf(false);
    QTRY_COMPARE(link_->status().state, LinkState::Connected); // it tries again
}

USAR_TEST(tst_TcpLink)

} // namespace tst_tcp_link

#include "tst_tcp_link.moc"
