// The image client against servers good and bad.
#include <QByteArray>
#include <QHostAddress>
#include <QObject>
#include <QSignalSpy>
#include <QString>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <QtEndian>

#include "core/link/image_client.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_image_client {

using namespace usar;
using namespace usar::link;

namespace {

QByteArray frame(char type, const QByteArray& data) {
    const quint32 size = qToBigEndian(static_cast<quint32>(data.size()));
    return QByteArray(1, type) + QByteArray(reinterpret_cast<const char*>(&size), 4) + data;
}

/// Answers each OK with `answer`, or does as it is told.
class Server : public QObject {
public:
    Server() {
        connect(&server_, &QTcpServer::newConnection, this, [this] {
            client = server_.nextPendingConnection();
            ++connections;
            client->write(greeting);
            connect(client, &QTcpSocket::readyRead, this, [this] {
                const QByteArray said = client->readAll();
                requests += static_cast<int>(said.count("OK"));
                for (int i = 0; i < said.count("OK"); ++i)
                    client->write(answer);
            });
        });
        server_.listen(QHostAddress::LocalHost);
    }
    quint16 port() const { return server_.serverPort(); }
    void close() { server_.close(); }

    QTcpSocket* client = nullptr;
    QByteArray greeting;
    QByteArray answer;
    int requests = 0;
    int connections = 0;

private:
    QTcpServer server_;
};

/// A client in a hurry that is told what comes.
struct Asking {
    Asking() {
        client.setLimits({.first_retry = Seconds{0.05},
                          .longest_retry = Seconds{0.1},
                          .silence = Seconds{0.2},
                          .shortest_interval = Seconds{0.02},
                          .most_bytes = 1000});
        client.setWanted(true);
    }
    QString reason() const { return client.status().reason; }

    ImageClient client;
    QSignalSpy frames{&client, &ImageClient::frameReceived};
};

} // namespace

class tst_ImageClient : public QObject {
    Q_OBJECT

private slots:
    void asksAgainWithEachFrameAndCountsThem() {
        Server server;
        server.answer = frame(2, "picture");
        Asking asking;
        asking.client.open("127.0.0.1", server.port());
        QTRY_VERIFY(asking.frames.size() >= 5);
        QCOMPARE(asking.frames[0][1].toByteArray(), QByteArray("picture"));
        QCOMPARE(asking.client.status().state, ImageState::Live);
        QVERIFY(asking.client.status().frames_per_s > 0.0 && asking.client.status().frames_per_s <= 60.0);
        QVERIFY(server.requests <= asking.frames.size() + 1); // one at a time
    }

    void framesMayComeByteByByte() {
        Server server;
        Asking asking;
        asking.client.open("127.0.0.1", server.port());
        QTRY_COMPARE(server.requests, 1);
        for (const char byte : frame(3, "abcdefgh")) {
            server.client->write(&byte, 1);
            server.client->flush();
            test::turnEventLoop(); // so that it comes by itself, as far as the machine lets it
        }
        QTRY_COMPARE(asking.frames.size(), 1);
        QCOMPARE(asking.frames[0][1].toByteArray(), QByteArray("abcdefgh"));
        QCOMPARE(asking.frames[0][0].value<ImageType>(), ImageType::Normal);
    }

    void aFirstFrameThatNobodyAskedForIsWelcome() {
        Server server;
        server.greeting = frame(1, "first");
        server.answer = frame(1, "next");
        Asking asking;
        asking.client.open("127.0.0.1", server.port());
        QTRY_VERIFY(asking.frames.size() >= 3);
        QCOMPARE(asking.frames[0][1].toByteArray(), QByteArray("first"));
    }

    void asksForNothingWhileNothingIsWanted() {
        Server server;
        server.answer = frame(2, "picture");
        Asking asking;
        asking.client.setWanted(false);
        asking.client.open("127.0.0.1", server.port());
        QTRY_COMPARE(server.connections, 1);
        const test::Beats frames(1000 / 60); // as often as it asks when it wants them
        QVERIFY(test::holdsUntil([&] { return server.requests == 0; }, [&] { return frames.count() >= 5; }));
        asking.client.setWanted(true);
        QTRY_VERIFY(asking.frames.size() >= 2);
        asking.client.setWanted(false);
        QTRY_COMPARE(asking.client.status().state, ImageState::Quiet);
        const int requests = server.requests;
        const int until = frames.count() + 5;
        QVERIFY(test::holdsUntil([&] { return server.requests == requests; }, [&] { return frames.count() >= until; }));
        QCOMPARE(asking.client.status().state, ImageState::Quiet);
    }

    void whatIsNoImageServerIsSaid_data() {
        QTest::addColumn<QByteArray>("greeting");
        QTest::addColumn<QString>("words");
        QTest::newRow("a bot server") << QByteArray("NFO {Gametype BotDeathMatch}\r\n") << "protocol";
        QTest::newRow("an unknown type") << frame(6, "x") << "protocol";
        QTest::newRow("an empty picture") << frame(2, "") << "protocol";
        QTest::newRow("a huge picture") << QByteArray("\2\xFF\xFF\xFF\xFF", 5) << "4295.0 MB";
        QTest::newRow("just too big") << frame(2, QByteArray(1001, 'x')) << "announces";
    }

    void whatIsNoImageServerIsSaid() {
        QFETCH(QByteArray, greeting);
        QFETCH(QString, words);
        Server server;
        server.greeting = greeting;
        Asking asking;
        asking.client.open("127.0.0.1", server.port());
        QTRY_COMPARE(asking.client.status().state, ImageState::Waiting);
        QVERIFY2(asking.reason().contains(words) && asking.reason().contains("5003"), qPrintable(asking.reason()));
        QCOMPARE(asking.frames.size(), 0);
    }

    void reconnectsAfterTheServerHasGone() {
        Server server;
        server.answer = frame(2, "picture");
        Asking asking;
        asking.client.open("127.0.0.1", server.port());
        QTRY_VERIFY(asking.frames.size() >= 1);
        server.client->abort();
        QTRY_COMPARE(server.connections, 2);
        const qsizetype before = asking.frames.size();
        QTRY_VERIFY(asking.frames.size() > before + 1);
    }

    void halfAPictureIsForgottenWithItsConnection() {
        Server server;
        server.greeting = frame(2, "abcdefgh").left(9);
        Asking asking;
        asking.client.open("127.0.0.1", server.port());
        QTRY_COMPARE(server.connections, 1);
        server.greeting.clear();
        server.answer = frame(2, "whole");
        QTRY_VERIFY(server.client);
        server.client->disconnectFromHost();
        QTRY_VERIFY(asking.frames.size() >= 1);
        QCOMPARE(asking.frames[0][1].toByteArray(), QByteArray("whole"));
    }

    void silenceIsSaidAndTriedAgain() {
        Server server;
        Asking asking;
        asking.client.open("127.0.0.1", server.port());
        QTRY_COMPARE(asking.client.status().state, ImageState::Waiting);
        QVERIFY(asking.reason().contains("sends none"));
        QTRY_VERIFY(server.connections >= 2);
    }

    void nobodyListeningIsSaidWithTheMend() {
        Server server;
        const quint16 port = server.port();
        server.close();
        Asking asking;
        asking.client.open("127.0.0.1", port);
        QTRY_COMPARE(asking.client.status().state, ImageState::Waiting);
        QVERIFY2(asking.reason().contains("No image server listens at 127.0.0.1"), qPrintable(asking.reason()));
    }
};

USAR_TEST(tst_ImageClient)

} // namespace tst_image_client

#include "tst_image_client.moc"
