// A session records everything, and a replay of the recording gives the same results.
#include <limits>
#include <map>
#include <set>

#include <QTemporaryDir>

#include "core/link/recording_reader.h"
#include "core/link/recording_text.h"
#include "core/mission/files/flown_mission.h"
#include "core/posh/trace/trace_codec.h"
#include "tests/mission/session/session_fixture.h"
#include "tests/suite/suite.h"

namespace tst_session_recording {

using namespace usar;
using namespace usar::mission;
using usar::test::SessionFixture;

namespace {

constexpr double as_fast_as_it_can = std::numeric_limits<double>::infinity();

/// Everything that a session reports in its updates, in order; cleared at each rewind.
struct Told {
    explicit Told(RobotSession& session) {
        QObject::connect(&session, &RobotSession::updated, &session, [this](const auto& update) { take(*update); });
    }
    void take(const SessionUpdate& update) {
        if (update.rewound)
            *this = {};
        for (const auto& line : update.lines)
            lines.push_back(std::to_string(line.number.value) + " " + line.text);
        for (const auto& command : update.commands)
            commands.push_back(std::to_string(command.after.value) + " " + toText(command.cause.source) + " " +
                               std::to_string(command.cause.trigger.value) + " " + command.text);
        published.insert(published.end(), update.published.begin(), update.published.end());
        for (const auto& tile : update.tiles)
            tiles[tile->index] = tile;
        if (update.task)
            task = update.task;
        figures = update.figures;
    }

    std::vector<std::string> lines;
    std::vector<std::string> commands;
    std::vector<agent::Published> published;
    std::map<mapping::GridIndex, std::shared_ptr<const mapping::HeightTile>> tiles;
    std::optional<ReplayedTask> task;
    SessionFigures figures;

private:
    Told() = default;
};

/// Drives at every tick and puts every scan on the map.
std::shared_ptr<test::Script> surveyor() {
    auto script = std::make_shared<test::Script>();
    script->on_info = [](const protocol::InfoLine& line, agent::CommandPort& port) {
        if (std::holds_alternative<protocol::RangeScan>(line.message))
            port.publish(agent::ScanPlacement{line.number, {{1.0, 2.0, 3.0}, 0.0, pi / 2, 0.0}});
    };
    script->on_tick = [](const agent::Tick& tick, agent::CommandPort& port) {
        port.send(protocol::AerialDrive{0.0, tick.now.count(), 0.0, 0.0}, "surveying");
        agent::BehaviorStatus status;
        status.time = tick.now;
        status.state = "surveying";
        port.publish(status);
        port.publish(agent::PoseEstimate{tick.now, {{tick.now.count(), 2.0, 3.0}}});
        port.publish(agent::MapMark{agent::MarkKind::Path, {tick.now.count(), 2.0, 0.0}, tick.now, tick.line});
    };
    return script;
}

std::vector<std::size_t> kindsOf(const std::vector<agent::Published>& values) {
    std::vector<std::size_t> kinds;
    for (const auto& value : values)
        kinds.push_back(value.index());
    return kinds;
}

} // namespace

class tst_SessionRecording : public QObject {
    Q_OBJECT
private slots:
    void everyByteHasItsTimeNumberAndCause() {
        SessionFixture live(SessionFixture::patientLimits());
        const QString path = recordAFlight(live, 3);
        QVERIFY(!path.isEmpty());
        const auto reader = link::RecordingReader::open(path);
        QVERIFY2(reader, reader ? "" : reader.error().text().c_str());
        QCOMPARE((*reader)->survey().facts.at("robot"), std::string("R1"));
        QVERIFY((*reader)->survey().ended);
        QByteArray in;
        QList<QByteArray> out;
        std::set<std::string> sources;
        std::string notes;
        while (const auto record = (*reader)->next()) {
            if (record->kind == link::RecordKind::In)
                in += QByteArray(record->bytes.data(), static_cast<qsizetype>(record->bytes.size()));
            if (record->kind == link::RecordKind::Note)
                notes += std::string(record->name) + " " + std::string(record->bytes) + "\n";
            if (record->kind != link::RecordKind::Out)
                continue;
            QVERIFY(record->bytes.ends_with("\r\n"));
            out.append(QByteArray(record->bytes.data(), static_cast<qsizetype>(record->bytes.size() - 2)));
            sources.insert(std::string(record->name));
            if (record->name == "test/scripted: surveying")
                QVERIFY(record->trigger.value > 0 && record->trigger <= record->line);
        }
        QCOMPARE(static_cast<std::uint64_t>(in.count("\r\n")), live.session.figures().lines_received);
        QCOMPARE(static_cast<std::uint64_t>(in.size()), live.session.figures().traffic.bytes_in);
        QTRY_COMPARE(live.server.heard(), out);
        for (const char* source : {"session: connect", "session: spawn", "test/scripted: surveying", "operator: stop"})
            QVERIFY2(sources.contains(source), source);
        QVERIFY2(notes.find("behavior test/scripted\tR1\t0 0 10 20\n") != std::string::npos, notes.c_str());
        QVERIFY2(notes.find("fault 3.0 s: fault begins: wind speed=5\n") != std::string::npos, notes.c_str());
        QVERIFY2(notes.find("finished 0 Stopped by the operator.\n") != std::string::npos, notes.c_str());
    }

    void aReplayIsWhatWasLive_data() {
        QTest::addColumn<double>("speed");
        QTest::newRow("as it was") << 1.0;
        QTest::newRow("a hundred times") << 100.0;
        QTest::newRow("as fast as it can") << as_fast_as_it_can;
    }

    void aReplayIsWhatWasLive() {
        QFETCH(double, speed);
        SessionFixture live(SessionFixture::patientLimits());
        Told was(live.session);
        const QString path = recordAFlight(live, 10);
        QVERIFY(!path.isEmpty());
        QTRY_COMPARE(was.lines.size(), live.session.figures().lines_received);

        RobotSession session;
        Told is(session);
        QVERIFY(playsToItsEnd(session, path, speed));
        QTRY_COMPARE(is.lines.size(), was.lines.size());
        QCOMPARE(is.lines, was.lines);
        QTRY_COMPARE(is.commands.size(), was.commands.size());
        for (std::size_t i = 0; i < was.commands.size(); ++i)
            QCOMPARE(QString::fromStdString(is.commands[i]), QString::fromStdString(was.commands[i]));
        QVERIFY(is.published == was.published);
        QCOMPARE(is.tiles.size(), was.tiles.size());
        QVERIFY(!is.tiles.empty());
        for (const auto& [index, tile] : was.tiles)
            QVERIFY(is.tiles.at(index)->line == tile->line);
        QVERIFY(session.record().path_m == live.session.record().path_m);
        QVERIFY(session.record().marks == live.session.record().marks);
        QCOMPARE(session.record().faults.size(), std::size_t(1));
        QVERIFY(session.record().faults == live.session.record().faults);
        QCOMPARE(session.record().behavior_id, live.session.record().behavior_id);
        QVERIFY(is.task && is.task->area_in_map == Rectangle({{0.0, 0.0}, {10.0, 20.0}}));
        QCOMPARE(session.figures().now, live.session.figures().now);
        QCOMPARE(session.figures().spawned, true);
        QTRY_VERIFY(is.figures.replay && !is.figures.replay->playing);
    }

    void aReplayCorrectsItsMapIfTheFlightDid_data() {
        QTest::addColumn<bool>("adjust");
        QTest::newRow("a corrected map") << true;
        QTest::newRow("the thesis's map") << false;
    }
    /// Nothing was received after the end, which is when most of the work is done.
    void aReplayCorrectsItsMapIfTheFlightDid() {
        QFETCH(bool, adjust);
        SessionFixture live(SessionFixture::patientLimits());
        live.session.setAdjust(adjust);
        Mission mission;
        mission.name = "m";
        mission.area_in_map = {{0.0, 0.0}, {10.0, 20.0}};
        mission.adjust = adjust;
        const QString path = recordAFlight(live, 10, noteOf({mission}));
        live.session.finishMap();
        QCOMPARE(live.session.record().adjustment.has_value(), adjust);

        RobotSession session;
        QVERIFY(playsToItsEnd(session, path));
        QTRY_COMPARE(session.record().adjustment.has_value(), adjust);
        if (adjust)
            QCOMPARE(session.record().adjustment->reason, live.session.record().adjustment->reason);
        session.orderReplay({.seek = Seconds{0.0}});
        QTRY_VERIFY(!session.record().adjustment);
    }

    /// It stays paused there, so no line does a part of the work.
    void afterAJumpToTheEndTheMapIsCorrected() {
        SessionFixture live(SessionFixture::patientLimits());
        Mission mission;
        mission.name = "m";
        mission.area_in_map = {{0.0, 0.0}, {10.0, 20.0}};
        mission.adjust = true;
        const QString path = recordAFlight(live, 10, noteOf({mission}));
        RobotSession session;
        session.openRecording(path);
        const Seconds span = link::RecordingReader::open(path).value()->survey().play_span;
        for (const Seconds to : {span, Seconds{0.0}, span}) {
            session.orderReplay({.seek = to});
            QTRY_COMPARE(session.record().adjustment.has_value(), to > Seconds{0.0});
        }
    }

    void seekingBackAndForthEndsInTheSame() {
        SessionFixture live(SessionFixture::patientLimits());
        const QString path = recordAFlight(live, 10);
        RobotSession straight;
        Told one(straight);
        QVERIFY(playsToItsEnd(straight, path));

        RobotSession session;
        Told other(session);
        session.openRecording(path);
        const Seconds span = link::RecordingReader::open(path).value()->survey().play_span;
        for (const double part : {0.9, 0.1, 0.5, 1.0}) {
            session.orderReplay({.seek = part * span});
            QTRY_VERIFY(other.figures.replay && !other.figures.replay->seeking &&
                        std::abs((other.figures.replay->position - part * span).count()) < 1e-6);
        }
        QTRY_COMPARE(other.lines.size(), one.lines.size());
        QCOMPARE(other.lines, one.lines);
        QVERIFY(session.record().path_m == straight.record().path_m);
        QVERIFY(session.record().marks == straight.record().marks);
        QVERIFY(session.record().status == straight.record().status);
        QCOMPARE(other.tiles.size(), one.tiles.size());
        // Statuses on the way are replaced by the newest one; marks and poses are all there.
        std::map<std::size_t, std::ptrdiff_t> count_one;
        std::map<std::size_t, std::ptrdiff_t> count_other;
        for (const auto kind : kindsOf(one.published))
            ++count_one[kind];
        for (const auto kind : kindsOf(other.published))
            ++count_other[kind];
        const auto mark = agent::Published(agent::MapMark{}).index();
        const auto pose = agent::Published(agent::PoseEstimate{}).index();
        QCOMPARE(count_other[mark], count_one[mark]);
        QCOMPARE(count_other[pose], count_one[pose]);
    }

    void aRecordingBegunInTheMiddleKnowsItsRobotAndNumbers() {
        SessionFixture live(SessionFixture::patientLimits());
        QVERIFY(live.spawnNow());
        live.session.startBehavior(test::hostOf(surveyor()), {"R1", {}, {}});
        QVERIFY(live.tickNow());
        live.server.say("STA {Type AerialVeh"); // a line is on its way
        const auto before = live.session.figures().lines_received;
        QVERIFY(live.answersAQuestion());
        const QString path = newPath();
        live.session.startRecording(path, {});
        live.server.say("icle} {Time 0.40} {Battery 1200}\r\n");
        QVERIFY(live.tickNow());
        live.session.stopRecording();
        const auto after = live.session.figures().lines_received;

        RobotSession session;
        Told told(session);
        QVERIFY(playsToItsEnd(session, path));
        QTRY_COMPARE(told.lines.size(), after - before);
        QCOMPARE(told.lines.front(),
                 std::to_string(before + 1) + " STA {Type AerialVehicle} {Time 0.40} {Battery 1200}");
        QVERIFY(session.figures().spawned && session.figures().behavior_running);
        QCOMPARE(session.record().behavior_id, std::string("test/scripted"));
    }

    void aRecordingBegunInTheMiddleKnowsWhatHoldsAndTheWholePlan() {
        SessionFixture live(SessionFixture::patientLimits());
        QVERIFY(live.spawnNow());
        const agent::PlannedPath path{{{1.0, 2.0}, {3.0, 4.0}}};
        const agent::CurrentGoal goal{{{3.0, 4.0, 5.0}}};
        const std::string trace_of_before = std::string(posh::trace_codec::magic) + "another plan";
        const std::string trace = std::string(posh::trace_codec::magic) + std::string(2'000'000, '\x01');
        auto script = std::make_shared<test::Script>();
        int ticks = 0;
        script->on_tick = [&](const agent::Tick& tick, agent::CommandPort& port) {
            if (++ticks == 1) {
                port.publish(agent::PlanTrace{trace_of_before});
                port.publish(agent::CurrentGoal{{{0.0, 0.0, 0.0}}});
                port.publish(path);
                port.publish(agent::MapMark{agent::MarkKind::Path, {7.0, 2.0, 0.0}, tick.now, tick.line});
                port.publish(agent::PlanTrace{trace});
                port.publish(goal);
                port.publish(agent::PlanHalted{.cycle = 3});
                port.publish(agent::PlanResumed{});
            }
            port.publish(agent::PlanTrace{std::to_string(ticks)});
        };
        live.session.startBehavior(test::hostOf(script), {"R1", {}, {}});
        for (int i = 0; i < 3; ++i)
            QVERIFY(live.tickNow());
        const QString file = newPath();
        QVERIFY(live.session.startRecording(file, {}));
        QVERIFY(live.tickNow());
        live.session.stopRecording();

        RobotSession session;
        Told told(session);
        QVERIFY(playsToItsEnd(session, file));
        const auto all = [&]<class Value>(const Value&) {
            std::vector<Value> values;
            for (const agent::Published& published : told.published)
                if (const auto* const value = std::get_if<Value>(&published))
                    values.push_back(*value);
            return values;
        };
        const auto traced = [&all] {
            std::string bytes;
            for (const agent::PlanTrace& piece : all(agent::PlanTrace{}))
                bytes += piece.bytes;
            return bytes;
        };
        QTRY_VERIFY(traced() == trace + "1234"); // what came before belongs to another plan
        QCOMPARE(all(agent::PlannedPath{}), std::vector{path});
        QCOMPARE(all(agent::CurrentGoal{}), std::vector{goal});
        QCOMPARE(all(agent::MapMark{}).size(), std::size_t(1));
        QVERIFY(all(agent::PlanHalted{}).empty());
    }

    void aRecordingBegunAfterTheBehaviorSaysNothingOfIt() {
        SessionFixture live(SessionFixture::patientLimits());
        QVERIFY(live.spawnNow());
        live.session.startBehavior(test::hostOf(surveyor()), {"R1", {}, {}});
        QVERIFY(live.tickNow());
        live.session.stop();
        const QString later = newPath();
        QVERIFY(live.session.startRecording(later, {}));
        QVERIFY(live.tickNow());
        live.session.stopRecording();
        const auto reader = link::RecordingReader::open(later);
        QVERIFY(reader);
        while (const auto record = (*reader)->next())
            QVERIFY(record->name != "published" && record->name != "behavior"); // nothing runs
    }

    void nothingCanBeSentInAReplayAndThatIsSaidOnce() {
        SessionFixture live(SessionFixture::patientLimits());
        const QString path = recordAFlight(live, 2);
        SessionFixture other;
        other.session.openRecording(path);
        const auto connections = other.server.connectionCount();
        for (int i = 0; i < 3; ++i) {
            other.session.sendCommand(protocol::Step{}, by::Operator{"box"});
            other.session.spawn({});
            other.session.startBehavior(test::hostOf(surveyor()), {});
            other.session.stop();
        }
        QCOMPARE(other.countSaid("This is a replay"), std::size_t{1});
        QCOMPARE(other.server.connectionCount(), connections);
        QVERIFY(!other.session.figures().behavior_running);
    }

    void aFileThatCannotBeOpenedIsNamed() {
        RobotSession session;
        QSignalSpy failed(&session, &RobotSession::replayFailed);
        session.openRecording(folder_.filePath("not_there.usarrec"));
        QCOMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toString().contains("not_there.usarrec"));
        session.orderReplay({.play = true}); // of nothing
    }

    void aRecordingThatCannotBeWrittenIsANoticeAndTheSessionGoesOn() {
        SessionFixture live(SessionFixture::patientLimits());
        QVERIFY(live.spawnNow());
        live.session.startRecording("/dev/null/r.usarrec", {});
        QVERIFY(live.said("/dev/null/r.usarrec"));
        QVERIFY(live.tickNow());
    }

    void whatHappenedUntilNowIsReadWhileTheSessionGoesOn() {
        SessionFixture live(SessionFixture::patientLimits());
        QSignalSpy flushed(&live.session, &RobotSession::recordingFlushed);
        live.session.flushRecording();
        QCOMPARE(flushed.takeFirst().at(0).toString(), QString()); // nothing is recorded
        const QString path = newPath();
        QVERIFY(live.session.startRecording(path, {}).has_value());
        QVERIFY(live.spawnNow());
        live.session.startBehavior(test::hostOf(surveyor()), {"R1", {}, {}});
        for (int i = 0; i < 5; ++i)
            QVERIFY(live.tickNow());
        const Seconds moment = live.session.figures().now;
        const auto lines = live.session.figures().lines_received;
        live.session.flushRecording();
        QTRY_COMPARE(flushed.size(), 1);
        QCOMPARE(flushed.first().at(0).toString(), path);
        QVERIFY(live.tickNow()); // it is recorded, too

        RobotSession replay;
        QSignalSpy opened(&replay, &RobotSession::replayOpened);
        Told told(replay);
        replay.openRecording(path);
        QCOMPARE(opened.first().at(1).toString(), QString()); // nothing is complained of
        replay.orderReplay({.seek_clock = moment});
        QTRY_VERIFY(told.figures.replay && !told.figures.replay->seeking && told.figures.now == moment);
        QCOMPARE(told.lines.size(), lines);
        QVERIFY(live.session.figures().behavior_running);
    }

    void aReplayCanBeLeftForALiveConnection() {
        SessionFixture live(SessionFixture::patientLimits());
        const QString path = recordAFlight(live, 2);
        SessionFixture other(SessionFixture::patientLimits());
        other.session.openRecording(path);
        other.session.orderReplay({.play = true});
        QVERIFY(other.spawnNow());
        QVERIFY(other.tickNow());
    }

    void aLostConnectionIsStaleInTheReplayAndOneWeClosedIsNot() {
        for (const bool lost : {true, false}) {
            SessionFixture live(SessionFixture::patientLimits());
            const QString path = newPath();
            QVERIFY(live.session.startRecording(path, {}));
            QVERIFY(live.spawnNow());
            QSignalSpy link(&live.session, &RobotSession::linkChanged);
            if (lost)
                live.server.hangUp();
            else
                live.session.close();
            QTRY_VERIFY(!link.isEmpty());
            live.session.stopRecording();
            RobotSession session;
            QVERIFY(playsToItsEnd(session, path));
            QCOMPARE(session.linkStatus().state, lost ? link::LinkState::Disconnected : link::LinkState::Connected);
            QCOMPARE(session.figures().spawned, !lost);
            QCOMPARE(session.linkStatus().trouble.contains("closed the connection"), lost);
        }
    }

    void aFaultHoldsOnTheServerOnWhichItWasMade_data() {
        QTest::addColumn<QString>("host"); ///< opened next
        QTest::addColumn<bool>("holds");
        QTest::newRow("the same server") << "127.0.0.1" << true;
        QTest::newRow("another server") << "localhost" << false;
    }
    void aFaultHoldsOnTheServerOnWhichItWasMade() {
        QFETCH(const QString, host);
        QFETCH(const bool, holds);
        SessionFixture live;
        QVERIFY(live.connectNow());
        live.session.noteFault("3.0 s: fault begins: wind speed=5");
        live.session.close();
        live.session.open(host, live.server.port(), false);
        QCOMPARE(faultsAtTheBeginning(live.session), holds ? 1 : 0);
    }

    void aFaultInAReplayIsNoneLater() {
        SessionFixture live;
        const QString path = recordAFlight(live, 3);
        QVERIFY(!path.isEmpty());
        RobotSession session;
        QVERIFY(playsToItsEnd(session, path));
        session.close();
        QCOMPARE(faultsAtTheBeginning(session), 0);
    }

private:
    /// Records nothing and counts the faults with which that begins.
    int faultsAtTheBeginning(RobotSession& session) {
        const QString path = newPath();
        if (!session.startRecording(path, {}))
            return -1;
        session.stopRecording();
        const auto reader = link::RecordingReader::open(path);
        if (!reader)
            return -1;
        int faults = 0;
        while (const auto record = (*reader)->next())
            faults += record->name == "fault" ? 1 : 0;
        return faults;
    }

    static bool playsToItsEnd(RobotSession& session, const QString& path, double speed = as_fast_as_it_can) {
        QSignalSpy ended(&session, &RobotSession::replayEnded);
        session.openRecording(path);
        session.orderReplay({.play = true, .speed = speed});
        return QTest::qWaitFor([&] { return ended.size() == 1; }, 20000);
    }

    QTemporaryDir folder_;
    int files_ = 0;
    QString newPath() { return folder_.filePath(QString("r%1.usarrec").arg(++files_)); }

    QString recordAFlight(SessionFixture& live, int ticks, const std::string& mission_note = {}) {
        const QString path = newPath();
        (void)live.session.startRecording(path, {{"robot", "R1"}, {"class", "USARBot.AirRobot"}});
        if (!live.spawnNow())
            return {};
        live.session.startBehavior(test::hostOf(surveyor()), {"R1", {}, {{0.0, 0.0}, {10.0, 20.0}}}, mission_note);
        for (int i = 0; i < ticks; ++i) {
            if (i == ticks / 2)
                live.session.noteFault("3.0 s: fault begins: wind speed=5");
            if (!live.tickNow())
                return {};
        }
        live.session.stop();
        live.session.stopRecording();
        return path;
    }
};

USAR_TEST(tst_SessionRecording)

} // namespace tst_session_recording

#include "tst_session_recording.moc"
