// A server that sends 20,000 lines a second into the real window: none is lost, and the window stays free for the
// person. Three seconds of it; USAR_FLOOD_SECONDS=60 gives a minute.
#include <QElapsedTimer>
#include <QTest>
#include <QThread>
#include <QTimer>

#include <algorithm>
#include <atomic>

#include "tests/doubles/fake_robot_server.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_flood {

using namespace usar;

namespace {

constexpr int ticks_per_second = 4000; // of five lines each
constexpr int lines_per_tick = 5;

/// The server in a thread of its own, with the clock of the wall.
class FloodingServer {
public:
    FloodingServer() {
        server_ = new test::FakeRobotServer;
        // The window has a connection for the next robot, too; the flood is this one's.
        server_->on_command = [this](const QByteArray& line) {
            if (line.startsWith("INIT"))
                server_->keepClient();
        };
        server_->moveToThread(&thread_);
        thread_.start();
        QMetaObject::invokeMethod(
            server_, [this] { port_ = server_->listen() ? server_->port() : quint16(0); },
            Qt::BlockingQueuedConnection);
    }
    ~FloodingServer() {
        server_->deleteLater();
        thread_.quit();
        thread_.wait();
    }
    quint16 port() const { return port_; }
    bool done() const { return done_; }
    int ticks() const { return ticks_; }

    /// As many ticks as the time that has passed asks for, so that a late timer costs no line.
    void flood(int seconds) {
        QMetaObject::invokeMethod(server_, [this, seconds] {
            auto* const timer = new QTimer(server_);
            clock_.start();
            QObject::connect(timer, &QTimer::timeout, server_, [this, timer, seconds] {
                const qint64 due = std::min<qint64>(clock_.elapsed(), seconds * 1000) * ticks_per_second / 1000;
                while (sent_ < due) {
                    server_->tick();
                    ++sent_;
                }
                if (sent_ == static_cast<qint64>(seconds) * ticks_per_second) {
                    timer->stop();
                    ticks_ = server_->tickCount();
                    done_ = true;
                }
            });
            timer->start(2);
        });
    }

private:
    QThread thread_;
    test::FakeRobotServer* server_ = nullptr; ///< lives in thread_ and is deleted there
    QElapsedTimer clock_;
    qint64 sent_ = 0;
    quint16 port_ = 0;
    std::atomic<int> ticks_ = 0;
    std::atomic<bool> done_ = false;
};

} // namespace

class tst_WindowFlood : public QObject {
    Q_OBJECT
private slots:
    void twentyThousandLinesASecondAreAllReadAndTheWindowStaysFree();
};

void tst_WindowFlood::twentyThousandLinesASecondAreAllReadAndTheWindowStaysFree() {
    const int seconds = std::max(1, qEnvironmentVariableIntValue("USAR_FLOOD_SECONDS"));
    const int span_s = qEnvironmentVariableIsSet("USAR_FLOOD_SECONDS") ? seconds : 3;
    FloodingServer server;
    QVERIFY(server.port() != 0);
    WindowPage page;
    page.connectToServer("127.0.0.1", server.port());
    // Those of the embedded simulator may still be on the map: this one's are known by a name of its own.
    const auto connected = [&] {
        return std::ranges::any_of(page.map().content().start_poses,
                                   [](const protocol::StartPose& pose) { return pose.name == "robot1"; });
    };
    QVERIFY(QTest::qWaitFor(connected, soon_ms));
    QVERIFY(page.spawnAt("PlayerStart"));
    GuiWatchdog::instance().reset();
    QElapsedTimer wall;
    wall.start();
    server.flood(span_s);
    QVERIFY(QTest::qWaitFor([&] { return server.done(); }, span_s * 4000 + soon_ms));
    const auto lines = [&] { return page.robot(1)->figures.lines_received; };
    const auto expected = static_cast<std::uint64_t>(2 + lines_per_tick * server.ticks()); // greeting, start poses
    QTRY_COMPARE_WITH_TIMEOUT(lines(), expected, soon_ms);
    qInfo("%llu lines in %.1f s", static_cast<unsigned long long>(lines()),
          static_cast<double>(wall.elapsed()) / 1000.0);
    QCOMPARE(page.robot(1)->figures.lines_malformed, 0u);
    QCOMPARE(page.robot(1)->figures.lines_overlong, 0u);
    QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint());
}

USAR_TEST(tst_WindowFlood)

} // namespace tst_window_flood

#include "tst_window_flood.moc"
