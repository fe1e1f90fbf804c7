// What the radio servers have in common: cutting requests, limits for each client, and room for new ones.
#include <QTcpSocket>
#include <QTest>

#include "core/server/request_server.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_request_server {

using namespace usar;
using namespace usar::server;

namespace {

/// Answers "<request>" and notes who leaves.
class Echo : public RequestServer {
public:
    Echo() : RequestServer(";\n", "--echo-port", nullptr) {}
    int left = 0;

private:
    std::string answer(int, std::string_view request) override { return "<" + std::string(request) + ">"; }
    void leave(int) override { ++left; }
};

class Caller {
public:
    explicit Caller(quint16 port) {
        socket_.connectToHost("127.0.0.1", port);
        socket_.waitForConnected(2000);
    }
    void say(const QByteArray& bytes) {
        socket_.write(bytes);
        socket_.flush();
    }
    const QByteArray& heard() { return heard_ += socket_.readAll(); }
    bool gone() const { return socket_.state() == QAbstractSocket::UnconnectedState; }
    void leave() { socket_.disconnectFromHost(); }

private:
    QTcpSocket socket_;
    QByteArray heard_;
};

} // namespace

class tst_RequestServer : public QObject {
    Q_OBJECT
private slots:
    void requestsAreCutAtTheirEnds_data() {
        QTest::addColumn<QByteArray>("said");
        QTest::addColumn<QByteArray>("heard"); // up to the answer to the last request, which is "end"
        QTest::newRow("one") << QByteArray("a;") << QByteArray("<a>");
        QTest::newRow("two at once") << QByteArray("a;b;") << QByteArray("<a><b>");
        QTest::newRow("another end") << QByteArray("a\nb;") << QByteArray("<a><b>");
        QTest::newRow("blanks around it") << QByteArray(" \ta b\r ;") << QByteArray("<a b>");
        QTest::newRow("empty ones have no answer") << QByteArray(";;\n  ;a;;") << QByteArray("<a>");
        QTest::newRow("zeros are bytes like others") << QByteArray("a\0b;", 4) << QByteArray("<a\0b>", 5);
        QTest::newRow("the longest") << QByteArray(4096, 'x') + ';' << '<' + QByteArray(4096, 'x') + '>';
        QTest::newRow("a longer one is dropped") << QByteArray(4097, 'x') + ";b;" << QByteArray("<b>");
        QTest::newRow("one of many pieces is dropped") << QByteArray(100000, 'x') + ";b;" << QByteArray("<b>");
    }
    void requestsAreCutAtTheirEnds() {
        QFETCH(QByteArray, said);
        QFETCH(QByteArray, heard);
        Echo server;
        Caller caller(*server.listen(0));
        caller.say(said + "end;");
        QTRY_VERIFY(caller.heard().endsWith("<end>"));
        QCOMPARE(caller.heard(), heard + "<end>");
    }

    void aRequestMayComeInPieces() {
        Echo server;
        Caller caller(*server.listen(0));
        for (const char* const piece : {"he", "llo", " wor", "ld"}) {
            caller.say(piece);
            test::turnEventLoop();
        }
        QVERIFY(caller.heard().isEmpty());
        caller.say(";");
        QTRY_COMPARE(caller.heard(), QByteArray("<hello world>"));
    }

    void clientsHaveRequestsOfTheirOwn() {
        Echo server;
        const quint16 port = *server.listen(0);
        Caller one(port);
        Caller other(port);
        one.say("on");
        other.say("oth");
        one.say("e;");
        other.say("er;");
        QTRY_COMPARE(one.heard(), QByteArray("<one>"));
        QTRY_COMPARE(other.heard(), QByteArray("<other>"));
    }

    void theLastRequestOfAClientThatLeavesIsHeard() {
        Echo server;
        Caller caller(*server.listen(0));
        caller.say("bye;");
        QTRY_COMPARE(caller.heard(), QByteArray("<bye>"));
        QCOMPARE(server.left, 0);
        caller.leave();
        QTRY_COMPARE(server.left, 1);
    }

    void whoHasAskedNothingMakesRoom() {
        Echo server;
        server.setMostClients(1);
        const quint16 port = *server.listen(0);
        Caller silent(port);
        test::turnEventLoop();
        Caller second(port);
        second.say("a;");
        QTRY_COMPARE(second.heard(), QByteArray("<a>"));
        QTRY_VERIFY(silent.gone());
        QCOMPARE(server.left, 0); // the silent one was not a client that left
        Caller third(port);
        QTRY_VERIFY(third.gone());
        second.say("b;");
        QTRY_COMPARE(second.heard(), QByteArray("<a><b>"));
    }

    void aPortInUseNamesTheOption() {
        Echo first;
        const quint16 port = *first.listen(0);
        QCOMPARE(first.port(), port);
        Echo second;
        const auto refused = second.listen(port);
        QVERIFY(!refused);
        QCOMPARE(QString::fromStdString(refused.error().text()),
                 QString("127.0.0.1:%1: port %1 is already in use. Choose another one with --echo-port, or end the "
                         "program that listens there.")
                     .arg(port));
    }

    void portsAreWholeNumbersOf16Bits_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("port"); // -1: none
        QTest::newRow("the smallest") << QByteArray("0") << 0;
        QTest::newRow("the largest") << QByteArray("65535") << 65535;
        QTest::newRow("blanks around it") << QByteArray(" 5000 ") << 5000;
        QTest::newRow("too large") << QByteArray("65536") << -1;
        QTest::newRow("negative") << QByteArray("-1") << -1;
        QTest::newRow("with decimals") << QByteArray("5000.0") << -1;
        QTest::newRow("with a word") << QByteArray("5000 tcp") << -1;
        QTest::newRow("beyond any number") << QByteArray("99999999999999999999") << -1;
        QTest::newRow("nothing") << QByteArray() << -1;
        QTest::newRow("a word") << QByteArray("http") << -1;
    }
    void portsAreWholeNumbersOf16Bits() {
        QFETCH(QByteArray, text);
        QFETCH(int, port);
        const auto read = readPort(text.toStdString());
        QCOMPARE(read ? int(*read) : -1, port);
    }
};

USAR_TEST(tst_RequestServer)

} // namespace tst_request_server

#include "tst_request_server.moc"
