#include <QAbstractSocket>
#include <QByteArray>
#include <QElapsedTimer>
#include <QObject>
#include <QSignalSpy>
#include <QTcpSocket>
#include <QTest>

#include "tests/server/radio_world.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_radio_relay {

using namespace usar;
using namespace usar::server;

namespace {

/// All byte values, not the same twice in a row.
QByteArray bytes(qsizetype count) {
    QByteArray result(count, '\0');
    for (qsizetype i = 0; i < count; ++i)
        result[i] = static_cast<char>((i * 37 + i / 251) & 0xff);
    return result;
}

/// Two radios, R1 and R2, R2 listening, 20 m apart with no wall between; walls stand between x < -3 and x > 3.
struct Pair {
    RadioWorld world{6};
    Listener listener;
    quint16 door = 0;

    Pair() {
        world.place("R1", -30.0);
        near();
        door = world.relay.door("R1", "R2", listener.port());
    }
    void near() { world.place("R2", -10.0); }
    /// 430 m... behind five walls: -49.67 - 23 - 31.6 is below -93 dBm.
    void farAway() { world.place("R2", 190.0); }
};

} // namespace

class tst_RadioRelay : public QObject {
    Q_OBJECT

private slots:
    void bytesGoBothWaysWhateverTheChunks_data() {
        QTest::addColumn<int>("chunk");
        QTest::addColumn<int>("total");
        QTest::newRow("byte by byte") << 1 << 500;
        QTest::newRow("odd pieces") << 977 << 300000;
        QTest::newRow("more than what is held, at once") << 3000000 << 3000000;
    }

    void bytesGoBothWaysWhateverTheChunks() {
        QFETCH(int, chunk);
        QFETCH(int, total);
        Pair pair;
        Peer call(pair.door);
        QTRY_COMPARE(pair.listener.calls(), 1);
        const QByteArray there = bytes(total);
        const QByteArray back = bytes(total + 13).mid(13);
        for (int at = 0; at < total; at += chunk) {
            call.say(there.mid(at, chunk));
            pair.listener.peer.say(back.mid(at, chunk));
            test::turnEventLoop();
        }
        QTRY_COMPARE(pair.listener.peer.heard().size(), there.size());
        QTRY_COMPARE(call.heard().size(), back.size());
        QVERIFY(pair.listener.peer.heard() == there);
        QVERIFY(call.heard() == back);
    }

    void whatWasSaidBeforeClosingStillArrives() {
        Pair pair;
        Peer call(pair.door);
        QTRY_COMPARE(pair.listener.calls(), 1);
        call.say(bytes(400000));
        call.socket().disconnectFromHost();
        QTRY_COMPARE(pair.listener.peer.heard().size(), 400000);
        QTRY_VERIFY(!pair.listener.peer.open());
        QTRY_COMPARE(pair.world.relay.links(), std::size_t(0));
    }

    void aLinkIsDroppedOutOfReachAndComesBackForNewCalls() {
        Pair pair;
        QSignalSpy log(&pair.world.relay, &RadioRelay::logged);
        Peer call(pair.door);
        call.say("hello");
        QTRY_COMPARE(pair.listener.peer.heard(), QByteArray("hello"));
        pair.farAway();
        QTRY_VERIFY(!call.open());
        QTRY_VERIFY(!pair.listener.peer.open());
        QCOMPARE(pair.world.relay.links(), std::size_t(0));
        QVERIFY2(log.last().first().toString().startsWith("radio: R1 and R2 have lost their link at -"),
                 qPrintable(log.last().first().toString()));
        QVERIFY(call.heard().isEmpty()); // not a word

        Peer in_vain(pair.door);
        QTRY_COMPARE(in_vain.socket().error(), QAbstractSocket::ConnectionRefusedError);
        QCOMPARE(pair.listener.calls(), 1);

        pair.near();
        pair.listener.peer.forget();
        Peer again(pair.door);
        again.say("here I am");
        QTRY_COMPARE(pair.listener.peer.heard(), QByteArray("here I am"));
        QCOMPARE(pair.listener.calls(), 2);
    }

    void aDoorOfTwoWhoDoNotReachEachOtherOpensWhenTheyDo() {
        Pair pair;
        pair.farAway();
        Listener other;
        const quint16 door = pair.world.relay.door("R2", "R1", other.port());
        QVERIFY(door != 0);
        Peer in_vain(door);
        QTRY_COMPARE(in_vain.socket().error(), QAbstractSocket::ConnectionRefusedError);
        pair.near();
        Peer call(door);
        call.say("x");
        QTRY_COMPARE(other.peer.heard(), QByteArray("x"));
    }

    void aRobotThatLeavesTheWorldLosesItsLinks() {
        Pair pair;
        Peer call(pair.door);
        QTRY_COMPARE(pair.listener.calls(), 1);
        pair.world.takeAway("R2");
        QTRY_VERIFY(!call.open());
    }

    void whereNobodyListensTheCallEnds() {
        Pair pair;
        quint16 closed = 0;
        {
            const Listener gone;
            closed = gone.port();
        }
        Peer call(pair.world.relay.door("R1", "R2", closed));
        QTRY_COMPARE(call.socket().error(), QAbstractSocket::RemoteHostClosedError);
        QTRY_COMPARE(pair.world.relay.links(), std::size_t(0));
    }

    void whoDoesNotReadIsNotReadFor() {
        Pair pair;
        Peer call(pair.door);
        QTRY_COMPARE(pair.listener.calls(), 1);
        QObject::disconnect(&pair.listener.peer.socket(), &QTcpSocket::readyRead, nullptr, nullptr);
        pair.listener.peer.socket().setReadBufferSize(4096);
        const qint64 much = 64 << 20;
        call.say(QByteArray(much, 'x'));
        qint64 waiting = much;
        const auto stands = [&] {
            waiting = call.socket().bytesToWrite();
            const test::Beats beats(5);
            return test::holdsUntil([&] { return call.socket().bytesToWrite() == waiting; },
                                    [&] { return beats.count() >= 20; });
        };
        QVERIFY(QTest::qWaitFor(stands, 15000));
        QVERIFY(waiting > much / 2); // the rest is in the system's buffers and in our 128 KiB
        Peer other(pair.door);       // and others talk
        other.say("x");
        QTRY_COMPARE(pair.listener.calls(), 2);
        QTRY_COMPARE(pair.listener.peer.heard(), QByteArray("x"));
    }

    void eightPairsTalkAtOnce() {
        RadioWorld world;
        struct Talk {
            Listener listener;
            Peer call;
        };
        std::vector<std::unique_ptr<Talk>> talks;
        for (int i = 0; i < 8; ++i) {
            const std::string a = "A" + std::to_string(i);
            const std::string b = "B" + std::to_string(i);
            world.place(a, -20.0, 5.0 * i);
            world.place(b, 20.0, 5.0 * i);
            talks.push_back(std::make_unique<Talk>());
            talks.back()->call.call(world.relay.door(a, b, talks.back()->listener.port()));
        }
        for (const auto& talk : talks)
            QTRY_COMPARE(talk->listener.calls(), 1);
        QElapsedTimer wall;
        wall.start();
        const QByteArray said = bytes(1 << 20);
        for (const auto& talk : talks) {
            talk->call.say(said);
            talk->listener.peer.say(said);
        }
        for (const auto& talk : talks) {
            QTRY_COMPARE(talk->listener.peer.heard().size(), said.size());
            QTRY_COMPARE(talk->call.heard().size(), said.size());
            QVERIFY(talk->listener.peer.heard() == said && talk->call.heard() == said);
        }
        qInfo("16 MiB over 16 ways in %lld ms", static_cast<long long>(wall.elapsed()));
        QCOMPARE(world.relay.links(), std::size_t(8));
    }

    void linksOutliveTheDoorsOfARobotThatHasLeftTheServer() {
        Pair pair;
        Peer call(pair.door);
        QTRY_COMPARE(pair.listener.calls(), 1);
        pair.world.relay.closeDoorsOf("R2");
        QCOMPARE(pair.world.relay.doors(), std::size_t(0));
        call.say("still here");
        QTRY_COMPARE(pair.listener.peer.heard(), QByteArray("still here"));
    }

    void theServersMayEndBeforeTheirClients() {
        auto pair = std::make_unique<Pair>();
        Peer call(pair->door);
        Peer asks(pair->world.wireless_port);
        QTRY_COMPARE(pair->listener.calls(), 1);
        pair.reset();
        QTRY_VERIFY(!call.open() && !asks.open());
    }
};

USAR_TEST(tst_RadioRelay)

} // namespace tst_radio_relay

#include "tst_radio_relay.moc"
