// Both ends in one thread, without a server of the system.
#include <random>

#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include "core/link/in_process_socket.h"
#include "core/link/tcp_link.h"
#include "tests/suite/suite.h"

namespace tst_in_process_socket {

using namespace usar;
using namespace usar::link;

namespace {

/// Keeps all clients' ends and what they have sent.
struct Served {
    InProcessServer taker() {
        return [this](QTcpSocket* accepted) {
            accepted->setParent(&owner);
            ends.push_back(accepted);
            QObject::connect(accepted, &QTcpSocket::readyRead, accepted, [this, accepted] {
                const QByteArray bytes = accepted->readAll();
                heard += bytes;
                if (answer)
                    answer(*accepted, bytes);
            });
            QObject::connect(accepted, &QTcpSocket::disconnected, accepted, [this] { ++gone; });
        };
    }

    QObject owner;
    std::vector<QTcpSocket*> ends;
    QByteArray heard;
    int gone = 0;
    std::function<void(QTcpSocket& end, const QByteArray& bytes)> answer;
};

QByteArray someBytes(std::mt19937_64& random, int most) {
    QByteArray bytes(static_cast<qsizetype>(random() % static_cast<unsigned>(most)) + 1, '\0');
    for (char& byte : bytes)
        byte = static_cast<char>(random());
    return bytes;
}

} // namespace

class tst_InProcessSocket : public QObject {
    Q_OBJECT
private slots:
    void init() {
        served_ = std::make_unique<Served>();
        client_ = std::make_unique<InProcessSocket>(served_->taker());
    }
    void cleanup() {
        client_.reset();
        served_.reset();
    }

    void connectsInTheEventLoop() {
        QSignalSpy connected(client_.get(), &QTcpSocket::connected);
        client_->connectToHost("nowhere", 1);
        QCOMPARE(client_->state(), QAbstractSocket::ConnectingState);
        QVERIFY(served_->ends.empty());
        QTRY_COMPARE(connected.size(), 1);
        QCOMPARE(client_->state(), QAbstractSocket::ConnectedState);
        QCOMPARE(served_->ends.size(), std::size_t(1));
    }

    void bytesArriveInTheirOrderBothWays() {
        std::mt19937_64 random(3);
        QVERIFY(connectNow());
        served_->answer = [](QTcpSocket& end, const QByteArray& bytes) { end.write(bytes); };
        QByteArray sent, back;
        connect(client_.get(), &QTcpSocket::readyRead, this, [&] {
            char some[37]; // Less than what waits, so that it is read in pieces.
            for (qint64 count = 0; (count = client_->read(some, sizeof some)) > 0;)
                back.append(some, count);
        });
        for (int i = 0; i < 200; ++i) {
            const QByteArray bytes = someBytes(random, 3000);
            QCOMPARE(client_->write(bytes), bytes.size());
            sent += bytes;
            if (random() % 5 == 0)
                QTRY_COMPARE(back.size(), sent.size());
        }
        QTRY_COMPARE(back.size(), sent.size());
        QVERIFY(back == sent && served_->heard == sent);
    }

    void whoWritesIsNotInterrupted() {
        QVERIFY(connectNow());
        bool writing = false, interrupted = false;
        served_->answer = [&](QTcpSocket& end, const QByteArray&) {
            interrupted |= writing;
            end.write("b");
            interrupted |= client_->bytesAvailable() == 0;
        };
        writing = true;
        client_->write("a");
        client_->flush();
        QCOMPARE(client_->bytesToWrite(), 1);
        writing = false;
        QTRY_COMPARE(client_->bytesAvailable(), 1);
        QCOMPARE(client_->bytesToWrite(), 0);
        QVERIFY(!interrupted);
    }

    void othersGetTheirTurnWhileBothTalk() {
        QVERIFY(connectNow());
        int rounds = 0;
        served_->answer = [](QTcpSocket& end, const QByteArray& bytes) { end.write(bytes); };
        connect(client_.get(), &QTcpSocket::readyRead, this, [&] {
            ++rounds;
            client_->write(client_->readAll());
        });
        QTimer timer;
        QSignalSpy timeouts(&timer, &QTimer::timeout);
        timer.start(1);
        client_->write("x");
        QTRY_VERIFY(timeouts.size() >= 3);
        QVERIFY2(rounds > 100, qPrintable(QString::number(rounds))); // In one turn of the event loop there are many.
    }

    void theClientsEndIsHeardAfterItsLastBytes() {
        QVERIFY(connectNow());
        client_->write("last");
        client_->disconnectFromHost();
        QCOMPARE(client_->state(), QAbstractSocket::UnconnectedState);
        QCOMPARE(served_->ends.front()->write("to nobody"), 9); // It has not heard of it yet.
        QTRY_COMPARE(served_->gone, 1);
        QCOMPARE(served_->heard, "last");
    }

    void theServersEndIsHeardAfterItsLastBytes() {
        QVERIFY(connectNow());
        QByteArray heard;
        QList<QAbstractSocket::SocketError> errors;
        connect(client_.get(), &QTcpSocket::readyRead, this, [&] { heard += client_->readAll(); });
        connect(client_.get(), &QTcpSocket::errorOccurred, this, [&](auto error) { errors << error; });
        served_->ends.front()->write("last");
        served_->ends.front()->abort();
        QTRY_COMPARE(client_->state(), QAbstractSocket::UnconnectedState);
        QCOMPARE(heard, "last");
        QCOMPARE(errors, QList{QAbstractSocket::RemoteHostClosedError});
    }

    void aConnectionOutlivesTheOneBefore() {
        QVERIFY(connectNow());
        served_->ends.front()->write("late");
        client_->disconnectFromHost();
        QVERIFY(connectNow());
        QTRY_COMPARE(served_->gone, 1);
        QCOMPARE(client_->state(), QAbstractSocket::ConnectedState);
        QCOMPARE(client_->bytesAvailable(), 0);
        client_->write("a");
        QTRY_COMPARE(served_->heard, "a");
        QCOMPARE(served_->ends.size(), std::size_t(2));
    }

    /// A link connects again in the slot that hears of the error.
    void aNewConnectionMayBeginInTheSlotOfTheError() {
        QVERIFY(connectNow());
        connect(client_.get(), &QTcpSocket::errorOccurred, this, [&] {
            client_->abort();
            client_->connectToHost("nowhere", 1);
        });
        served_->ends.front()->abort();
        QTRY_COMPARE(served_->ends.size(), std::size_t(2));
        QTRY_COMPARE(client_->state(), QAbstractSocket::ConnectedState);
    }

    /// After a cut the client reads what came before it, and answers nobody.
    void anEndThatLeftHearsNothing() {
        QVERIFY(connectNow());
        connect(client_.get(), &QTcpSocket::readyRead, this, [&] { client_->write(client_->readAll()); });
        served_->ends.front()->write("last");
        served_->ends.front()->abort();
        QTRY_COMPARE(client_->state(), QAbstractSocket::UnconnectedState);
        QVERIFY(connectNow()); // It waited behind all that was to be delivered before.
        QCOMPARE(served_->heard, "");
    }

    void aSlotMayRunAnEventLoop() {
        QVERIFY(connectNow());
        served_->answer = [](QTcpSocket& end, const QByteArray& bytes) { end.write(bytes); };
        QByteArray back;
        connect(client_.get(), &QTcpSocket::readyRead, this, [&] {
            back += client_->readAll();
            if (back == "a") {
                client_->write("b");
                QVERIFY(QTest::qWaitFor([&] { return back == "ab"; }));
            }
        });
        client_->write("a");
        QTRY_COMPARE(back, "ab");
    }

    void anEndMayGoWhileItIsTold_data() {
        QTest::addColumn<QString>("which");
        for (const char* which : {"the client's in the server's slot", "the server's later",
                                  "the client's as it connects", "the client's in its own slot"})
            QTest::newRow(which) << which;
    }
    void anEndMayGoWhileItIsTold() {
        QFETCH(QString, which);
        if (which.endsWith("as it connects")) {
            connect(client_.get(), &QTcpSocket::connected, this, [&] { client_.reset(); });
            client_->connectToHost("nowhere", 1);
            QTRY_COMPARE(served_->gone, 1);
            return;
        }
        QVERIFY(connectNow());
        const bool by_server = which.startsWith("the server's");
        const bool in_its_own = which.endsWith("its own slot");
        connect(client_.get(), &QTcpSocket::readyRead, this, [&] { client_.reset(); });
        served_->answer = [&](QTcpSocket& end, const QByteArray&) {
            if (in_its_own)
                end.write("b");
            else if (by_server)
                end.deleteLater();
            else
                client_.reset();
        };
        client_->write("a");
        QTRY_COMPARE(served_->heard, "a");
        if (by_server)
            QTRY_COMPARE(client_->state(), QAbstractSocket::UnconnectedState);
        else
            QTRY_COMPARE(served_->gone, 1);
    }

    void aLinkUsesItAndConnectsAgain() {
        served_->answer = [](QTcpSocket& end, const QByteArray&) {
            end.write("NFO {Gametype BotDeathMatch} {Level DM-tall_test} {TimeLimit 0}\r\n");
        };
        TcpLink link;
        link.setLimits({.first_retry = Seconds{0.01}, .longest_retry = Seconds{0.02}});
        QList<QByteArray> lines;
        link.setLineTaker([&](std::string_view line) { lines << QByteArray(line.data(), qsizetype(line.size())); });
        link.useInProcess(served_->taker());
        link.open("127.0.0.1", 3000);
        QTRY_COMPARE(link.status().state, LinkState::Connected);
        link.send("GETSTARTPOSES");
        QTRY_COMPARE(lines.size(), 1);
        QVERIFY(lines.front().startsWith("NFO "));
        QCOMPARE(served_->heard, "GETSTARTPOSES\r\n");
        QVERIFY(!link.roundTrip());
        served_->ends.front()->abort();
        QTRY_COMPARE(served_->ends.size(), std::size_t(2));
        QTRY_COMPARE(link.status().state, LinkState::Connected);
    }

private:
    bool connectNow() {
        client_->connectToHost("nowhere", 1);
        return QTest::qWaitFor([&] { return client_->state() == QAbstractSocket::ConnectedState; });
    }

    std::unique_ptr<Served> served_;
    std::unique_ptr<QTcpSocket> client_;
};

USAR_TEST(tst_InProcessSocket)

} // namespace tst_in_process_socket

#include "tst_in_process_socket.moc"
