#include <QByteArray>
#include <QObject>
#include <QTest>

#include "core/server/relayed_link.h"
#include "tests/server/radio_world.h"
#include "tests/suite/suite.h"

namespace tst_com_server {

using namespace usar;
using namespace usar::server;

class tst_ComServer : public QObject {
    Q_OBJECT

private slots:
    void everyRequestHasItsReply_data() {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("reply");
        const auto row = [](const char* name, const char* request, const char* reply) {
            QTest::newRow(name) << QByteArray(request) << QByteArray(reply);
        };
        row("a new robot", "REGISTER R3 127.0.0.1", "OK");
        row("a robot again, at the same address", "REGISTER R1 127.0.0.1", "OK");
        row("a robot again, at another address", "REGISTER R1 10.0.0.1", "Fail: Robot with name R1 already registered");
        row("a robot without address", "REGISTER R3", "Fail: Incorrect Message");
        row("words in any case, and lines", "\r\nregister R3 127.0.0.1", "OK");
        row("a new port", "LISTEN R2 6001", "OK");
        row("a port again", "LISTEN R2 6000", "Fail: Robot with name R2 already listening at port 6000");
        row("a port of nobody", "LISTEN R9 6000", "Fail: Robot R9 not registered");
        row("no port", "LISTEN R2", "Fail: Incorrect Message");
        row("a port that is a word", "LISTEN R2 x", "Fail: Incorrect Message");
        row("a call where nobody listens", "OPEN R1 5000 R2 7777", "Fail: R2 not listening on port 7777");
        row("a call out of reach", "OPEN R1 5000 Far 8000", "Fail: Cannot connect to Far");
        row("a call from a port that is a word", "OPEN R1 x R2 6000", "Fail: Incorrect Message");
        row("a call of too few words", "OPEN R1 R2 6000", "Fail: Incorrect Message");
        row("a strength: 20 m, no wall", "GETSS R1 R2", "OK:-59.67");
        row("a strength to one who is not there", "GETSS R1 R9", "Fail: Could not calculate signal strength");
        row("a strength between strangers", "GETSS R8 R9", "Fail: Server does not accept third party requests");
        row("a strength of too few words", "GETSS R1", "Fail: Incorrect Message");
        row("a word of data links", "SEND 5 hello", "Fail: Unknown message");
        row("an unknown word", "HELLO", "Fail: Unknown message");
    }

    void everyRequestHasItsReply() {
        QFETCH(QByteArray, request);
        QFETCH(QByteArray, reply);
        RadioWorld world(6);
        world.place("R1", -30.0);
        world.place("R2", -10.0);
        world.place("Far", 190.0);
        Peer peer(world.com_port);
        for (const char* const set_up : {"REGISTER R1 127.0.0.1;", "REGISTER R2 127.0.0.1;", "REGISTER Far 127.0.0.1;",
                                         "LISTEN R2 6000;", "LISTEN Far 8000;"})
            QCOMPARE(peer.ask(set_up, ";"), QByteArray("OK"));
        QCOMPARE(peer.ask(request + ";", ";"), reply);
    }

    void namesOutliveTheirConnection() {
        RadioWorld world;
        auto first = std::make_unique<Peer>(world.com_port);
        QCOMPARE(first->ask("REGISTER R1 127.0.0.1;", ";"), QByteArray("OK"));
        first.reset();
        Peer second(world.com_port);
        QCOMPARE(second.ask("LISTEN R1 5000;", ";"), QByteArray("OK"));
    }

    void aFloodOfNamesLeavesRoomForTheRobotsInTheWorld() {
        RadioWorld world;
        world.place("R1", 0.0);
        Peer flood(world.com_port), r1(world.com_port);
        QCOMPARE(r1.ask("REGISTER R1 127.0.0.1;", ";"), QByteArray("OK"));
        QByteArray names;
        for (int i = 0; i < 2000; ++i)
            names += "REGISTER X" + QByteArray::number(i) + " 1.2.3.4;";
        flood.say(names);
        QTRY_COMPARE(flood.heard(), QByteArray("OK;").repeated(2000));
        QCOMPARE(r1.ask("LISTEN R1 5000;", ";"), QByteArray("OK"));
        QCOMPARE(r1.ask("REGISTER R2 127.0.0.1;", ";"), QByteArray("OK"));
    }

    void openCallsBothAndCarriesWhatTheySend() {
        RadioWorld world(6);
        world.place("R1", -30.0);
        world.place("R2", -10.0);
        Listener one, other;
        Peer peer(world.com_port);
        peer.ask("REGISTER R1 127.0.0.1;", ";");
        peer.ask("REGISTER R2 127.0.0.1;", ";");
        QCOMPARE(peer.ask("LISTEN R2 " + other.portText() + ";", ";"), QByteArray("OK"));
        const QByteArray open = "OPEN R1 " + one.portText() + " R2 " + other.portText() + ";";
        QCOMPARE(peer.ask(open, ";"), QByteArray("OK"));
        QTRY_COMPARE(one.calls() + other.calls(), 2);
        one.peer.say("SEND 5 hel");
        one.peer.say("lo;SEND 3 a;b;");
        other.peer.say("SEND 2 ok;");
        QTRY_COMPARE(other.peer.heard(), QByteArray("helloa;b"));
        QTRY_COMPARE(one.peer.heard(), QByteArray("ok"));
        // One LISTEN is one link.
        QCOMPARE(peer.ask(open, ";"), "Fail: R2 not listening on port " + other.portText());
        one.peer.say("CLOSE;");
        QTRY_VERIFY(!one.peer.open() && !other.peer.open());
        QTRY_COMPARE(world.relay.links(), std::size_t(0));
    }

    void aLinkOutOfReachIsClosed() {
        RadioWorld world(6);
        world.place("R1", -30.0);
        world.place("R2", -10.0);
        Listener one, other;
        Peer peer(world.com_port);
        peer.ask("REGISTER R1 127.0.0.1;", ";");
        peer.ask("REGISTER R2 127.0.0.1;", ";");
        peer.ask("LISTEN R2 " + other.portText() + ";", ";");
        peer.ask("OPEN R1 " + one.portText() + " R2 " + other.portText() + ";", ";");
        QTRY_COMPARE(one.calls() + other.calls(), 2);
        world.place("R2", 190.0);
        QTRY_VERIFY(!one.peer.open() && !other.peer.open());
    }

    void framesAreReadInAnyChunks_data() {
        QTest::addColumn<QByteArray>("said");
        QTest::addColumn<QByteArray>("payload");
        QTest::addColumn<bool>("open");
        const auto row = [](const char* name, const QByteArray& said, const QByteArray& payload, bool open = true) {
            QTest::newRow(name) << said << payload << open;
        };
        row("one message", "SEND 5 hello;", "hello");
        row("two, with a line between", "SEND 1 a;\r\nSEND 2 bc;", "abc");
        row("a payload of semicolons", "SEND 4 ;;;;;SEND 1 x;", ";;;;x");
        row("a payload with zeros", QByteArray("SEND 3 a\0b;SEND 1 c;", 20), QByteArray("a\0bc", 4));
        row("an empty message", "SEND 0 ;SEND 1 x;", "x");
        row("an end that is no semicolon", "SEND 1 a\nSEND 1 b;", "ab");
        row("an unknown word is skipped", "HELLO world;SEND 1 x;", "x");
        row("a short word is skipped", "HI;SEND 1 x;", "x");
        row("a length that is none is skipped", "SEND five hello;SEND 1 x;", "x");
        row("a length beyond reason is skipped", "SEND 99999999999 h;SEND 1 x;", "x");
        row("the end", "SEND 1 x;CLOSE;SEND 1 y;", "x", false);
        row("an end that has not ended", "CLOSE", "");
    }

    void framesAreReadInAnyChunks() {
        QFETCH(QByteArray, said);
        QFETCH(QByteArray, payload);
        QFETCH(bool, open);
        for (const qsizetype chunk : {qsizetype(1), qsizetype(3), said.size()}) {
            ComFrames frames;
            QByteArray taken;
            bool still_open = true;
            for (qsizetype at = 0; at < said.size(); at += chunk) {
                const QByteArray piece = said.mid(at, chunk);
                still_open = frames.feed(
                    {piece.constData(), static_cast<std::size_t>(piece.size())},
                    [&](std::string_view part) { taken.append(part.data(), static_cast<qsizetype>(part.size())); });
            }
            QCOMPARE(taken, payload);
            QCOMPARE(still_open, open);
        }
    }
};

USAR_TEST(tst_ComServer)

} // namespace tst_com_server

#include "tst_com_server.moc"
