#include <cmath>
#include <deque>
#include <functional>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/link_probe.h"
#include "tests/suite/suite.h"

namespace tst_link_probe {

using namespace usar;
using namespace usar::airrobot;

namespace {

/// A server that answers with the next tick, over a link that is late by a time, both ways together.
struct ToyServer {
    /// Runs for so many ticks of 0.2 s. `loses` says whether the question of a number gets lost.
    void run(int ticks, double late_s, const std::function<bool(int)>& loses = {}) {
        for (int tick = 0; tick < ticks; ++tick) {
            now_s += 0.2;
            for (; !answers.empty() && answers.front().first <= now_s + 1e-6; answers.pop_front())
                probe.hear(answers.front().second);
            probe.step(Seconds(now_s), port);
            for (const agent::CausedCommand& asked : port.takeCommands())
                if (!loses || !loses(count++))
                    answers.emplace_back(now_s + late_s + 0.2, answerTo(asked.command));
        }
    }

    static protocol::InfoMessage answerTo(const protocol::Command& command) {
        if (const auto* const geometry = std::get_if<protocol::GetGeometry>(&command))
            return protocol::GeometryInfo{.type = geometry->type.text()};
        return protocol::ConfigurationInfo{.type = std::get<protocol::GetConfiguration>(command).type.text()};
    }

    double late_s() const { return probe.late().value_or(Seconds(-1.0)).count(); }

    LinkProbe probe;
    agent::CommandPort port;
    std::deque<std::pair<double, protocol::InfoMessage>> answers;
    double now_s = 0.0;
    int count = 0;
};

} // namespace

class tst_LinkProbe : public QObject {
    Q_OBJECT

private slots:
    void measuresHowLateTheLinkIs_data() {
        QTest::addColumn<double>("late_s");
        for (const double late_s : {0.0, 0.6, 1.6, 3.0})
            QTest::addRow("%.1f s", late_s) << late_s;
    }
    void measuresHowLateTheLinkIs() {
        QFETCH(double, late_s);
        ToyServer server;
        server.run(50, late_s);
        QVERIFY2(std::abs(server.late_s() - late_s) < 0.25, qPrintable(QString::number(server.late_s())));
    }

    // By the echo of the robot's motion it took seven seconds, in which the robot flew on.
    void noticesALinkThatGetsLateWithinTwoSeconds() {
        ToyServer server;
        server.run(50, 0.0);
        QCOMPARE(server.late_s(), 0.0);
        server.run(10, 2.4);
        QVERIFY2(server.late_s() > 0.5, qPrintable(QString::number(server.late_s())));
        server.run(40, 2.4);
        QVERIFY2(std::abs(server.late_s() - 2.4) < 0.25, qPrintable(QString::number(server.late_s())));
        server.run(30, 0.0);
        QCOMPARE(server.late_s(), 0.0);
    }

    // After a link was silent, all of the time's lines come at once, and none of the commands given for them is obeyed.
    void knowsABacklogByTheQuestionsThatStayOpen() {
        ToyServer server;
        server.run(50, 0.0);
        const double held_until_s = server.now_s + 16.0;
        for (int tick = 0; tick < 80; ++tick)
            server.run(1, held_until_s - server.now_s);
        QVERIFY2(server.late_s() > 14.0, qPrintable(QString::number(server.late_s())));
        server.run(10, 0.0);
        QCOMPARE(server.late_s(), 0.0);
    }

    void takesAQuestionThatGotLostForNoDelay() {
        ToyServer server;
        for (int tick = 0; tick < 300; ++tick) {
            server.run(1, 0.0, [](int number) { return number % 3 == 2; });
            QVERIFY2(server.late_s() <= 0.0, qPrintable(QString::number(server.late_s())));
        }
        QVERIFY(server.count > 50);
    }

    void saysNothingWhereNobodyAnswers() {
        ToyServer server;
        server.run(300, 0.0, [](int) { return true; });
        QVERIFY(!server.probe.late());
    }
};

USAR_TEST(tst_LinkProbe)

} // namespace tst_link_probe

#include "tst_link_probe.moc"
