// What connections cost: how many lines a second one link takes from a real socket into values, and how much of a core
// sixteen robots at the rate of a real server need.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QEventLoop>
#include <QTcpServer>
#include <QTcpSocket>
#include <QThread>

#include "core/link/tcp_link.h"
#include "core/protocol/reader.h"
#include "tests/bench/bench_application.h"

namespace {

using namespace usar;

constexpr int lines_per_tick = 10;

/// One tick of a UT2004 server: ten lines with one scan, about 2.3 kB (protocol.md 1.8).
QByteArray oneTick() {
    QByteArray tick =
        "SEN {Time 395.38} {Type RangeScanner} {Name Scanner1} {Resolution 0.0174} {FOV 3.1415} {Range 1.5";
    for (int beam = 1; beam < 181; ++beam)
        tick += ",2.1924";
    tick += "}\r\n";
    for (const char* line :
         {"SEN {Time 395.6055} {Type Sonar} {Name F1 Range 4.5604} {Name F2 Range 2.4576} {Name F3 Range 1.8846}",
          "SEN {Type INS} {Name INS} {Location 4.50,1.90,1.80} {Orientation 0.00,0.00,0.00}",
          "SEN {Type Odometry} {Name Odometry} {Pose 0.0320,0.0000,0.0296}",
          "SEN {Type Encoder} {Name ECLeft Tick -71} {Name ECRight Tick -38} {Name ECTilt Tick 0} {Name ECPan Tick 0}",
          "SEN {Time 395.9927} {Type VictSensor} {Name VictSensor} {Status NoVictims}",
          "SEN {Time 395.7716} {Type GroundTruth} {Name G} {Location 4.56,1.90,1.85} {Orientation 0.00,0.01,0.08}",
          "SEN {Type GPS} {Name GPS} {Fix 0} {Satellites 0}",
          "MISSTA {Time 395.77} {Name CameraPanTilt} {Link 1} {Value 0.0000} {Torque -20.00} {Link 2} {Value 0.0000}",
          "STA {Type GroundVehicle} {Time 395.77} {FrontSteer 0.0000} {RearSteer 0.0000} {LightToggle False} "
          "{LightIntensity 0} {Battery 1200} {View -1}"})
        tick += QByteArray(line) + "\r\n";
    return tick;
}

/// A thread with a server that sends a tick to each client, `ticks` times, as fast as it can or every 200 ms.
class Feeder {
public:
    Feeder() {
        worker_.moveToThread(&thread_);
        thread_.start();
        QMetaObject::invokeMethod(
            &worker_, [this] { start(); }, Qt::BlockingQueuedConnection);
    }
    ~Feeder() {
        QMetaObject::invokeMethod(
            &worker_, [this] { server_.reset(); }, Qt::BlockingQueuedConnection);
        thread_.quit();
        thread_.wait();
    }
    quint16 port() const { return port_; }
    void feed(int ticks) {
        QMetaObject::invokeMethod(&worker_, [this, ticks] {
            for (int i = 0; i < ticks; ++i)
                for (QTcpSocket* client : clients_)
                    client->write(tick_);
            for (QTcpSocket* client : clients_)
                client->flush();
        });
    }

private:
    void start() {
        server_ = std::make_unique<QTcpServer>();
        QObject::connect(server_.get(), &QTcpServer::newConnection, server_.get(),
                         [this] { clients_.push_back(server_->nextPendingConnection()); });
        server_->listen(QHostAddress::LocalHost);
        port_ = server_->serverPort();
    }

    const QByteArray tick_ = oneTick();
    QThread thread_;
    QObject worker_;
    std::unique_ptr<QTcpServer> server_;
    std::vector<QTcpSocket*> clients_;
    quint16 port_ = 0;
};

/// Looks whether what is waited for has come; called after each tick of a client and each change of its link.
std::function<void()> look = [] {};

struct Client {
    explicit Client(quint16 port) {
        QObject::connect(&link, &link::TcpLink::statusChanged, [] { look(); });
        link.setLineTaker([this](std::string_view line) {
            benchmark::DoNotOptimize(&reader.read(line));
            if (++lines % lines_per_tick == 0)
                look();
        });
        link.open("127.0.0.1", port);
    }
    link::TcpLink link;
    protocol::Reader reader;
    qint64 lines = 0;
};

template <class Condition>
void runUntil(Condition&& condition) {
    if (condition())
        return;
    QEventLoop loop;
    look = [&] {
        if (condition())
            loop.quit();
    };
    loop.exec();
    look = [] {};
}

void oneLinkTakesAllItCan(benchmark::State& state) {
    bench::needApplication();
    constexpr int ticks = 2000;
    Feeder feeder;
    Client client(feeder.port());
    runUntil([&] { return client.link.status().state == link::LinkState::Connected; });
    feeder.feed(1);
    runUntil([&] { return client.lines == lines_per_tick; });
    qint64 expected = client.lines;
    for (auto _ : state) {
        expected += ticks * lines_per_tick;
        feeder.feed(ticks);
        runUntil([&] { return client.lines >= expected; });
    }
    state.SetItemsProcessed(state.iterations() * ticks * lines_per_tick);
    state.SetBytesProcessed(state.iterations() * ticks * oneTick().size());
}
BENCHMARK(oneLinkTakesAllItCan)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Thirty seconds of sixteen robots, without waiting for the clock: what is counted is the reading side's processor
/// time, as a share of the thirty seconds.
void sixteenConnectionsAtRealRates(benchmark::State& state) {
    bench::needApplication();
    constexpr int robots = 16;
    constexpr int ticks = 150;
    Feeder feeder;
    std::vector<std::unique_ptr<Client>> clients;
    for (int i = 0; i < robots; ++i)
        clients.push_back(std::make_unique<Client>(feeder.port()));
    runUntil([&] {
        return std::ranges::all_of(
            clients, [](const auto& one) { return one->link.status().state == link::LinkState::Connected; });
    });
    double cpu_s = 0.0;
    for (auto _ : state) {
        timespec before{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &before);
        const qint64 goal = clients.front()->lines + ticks * lines_per_tick;
        feeder.feed(ticks);
        runUntil([&] { return std::ranges::all_of(clients, [goal](const auto& one) { return one->lines >= goal; }); });
        timespec after{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &after);
        cpu_s += static_cast<double>(after.tv_sec - before.tv_sec) +
                 static_cast<double>(after.tv_nsec - before.tv_nsec) * 1e-9;
    }
    state.counters["core_pct"] = 100.0 * cpu_s / (static_cast<double>(state.iterations()) * ticks * 0.2);
    state.SetItemsProcessed(state.iterations() * robots * ticks * lines_per_tick);
}
BENCHMARK(sixteenConnectionsAtRealRates)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
