// What a session is told of a recording that is played into it.
#include <limits>

#include <QTemporaryDir>
#include <QTest>

#include "core/agent/published_text.h"
#include "core/link/recording_writer.h"
#include "core/mission/session/replay_feed.h"
#include "tests/suite/suite.h"

namespace tst_replay_feed {

using namespace usar;
using namespace usar::mission;
using link::RecordKind;

namespace {

/// Writes down what it is told.
struct Stage : ReplayStage {
    void replayRewound() override { told << "rewound"; }
    void replayBegan(std::optional<double> cell_size_m, const std::string& level) override {
        told << QString("began %1 %2").arg(cell_size_m.value_or(-1.0)).arg(QString::fromStdString(level));
    }
    void replayLinkChanged(const link::LinkStatus& status) override {
        told << QString("link %1 %2").arg(static_cast<int>(status.state)).arg(status.reason).trimmed();
    }
    void replayConnected() override { told << "connected"; }
    void replayClosed(bool lost) override { told << (lost ? "lost" : "closed"); }
    void replayLine(std::string_view text, LineNumber number) override {
        told << QString("%1: %2").arg(number.value).arg(QString::fromStdString(std::string(text)));
    }
    protocol::Dialect replaySpelling() const override { return protocol::Dialect::Ut2004; }
    void replayCommand(const agent::CausedCommand& command, std::string text, LineNumber after) override {
        told << QString("%1 > %2: %3")
                    .arg(after.value)
                    .arg(QString::fromStdString(toText(command.cause.source)), QString::fromStdString(text));
    }
    void replayPublished(const agent::Published& value) override { told << QString("published %1").arg(value.index()); }
    void replayPassed(const agent::BehaviorStatus& status) override {
        told << "passed " + QString::fromStdString(status.state);
    }
    void replayMission(std::string_view note) override {
        told << "mission " + QString::fromUtf8(note.data(), int(note.size()));
    }
    void replayTask(const ReplayedTask& task, const std::string& robot_name) override {
        told << QString("task %1 %2 %3")
                    .arg(QString::fromStdString(task.behavior_id), QString::fromStdString(robot_name))
                    .arg(task.area_in_map.max_m.y());
    }
    void replayFinished(const agent::BehaviorFinished& finished) override {
        told << QString("finished %1 %2").arg(finished.success).arg(QString::fromStdString(finished.reason));
    }
    void replayFault(const std::string& sentence) override { told << "fault " + QString::fromStdString(sentence); }
    void replaySeeks(bool on) override { told << (on ? "seeks" : "arrives"); }
    void replayChanged() override {}
    void replayDamaged(const std::string& complaint) override {
        told << "damaged " + QString::fromStdString(complaint);
    }
    void replayEnds() override { ended = true; }

    QStringList told;
    bool ended = false;
};

constexpr int disconnected = static_cast<int>(link::LinkState::Disconnected);
constexpr int connecting = static_cast<int>(link::LinkState::Connecting);
constexpr int connected = static_cast<int>(link::LinkState::Connected);

std::string textOf(const agent::Published& value) {
    std::string text;
    agent::appendText(text, value);
    return text;
}

agent::BehaviorStatus scanning() {
    agent::BehaviorStatus status;
    status.state = "scanning";
    return status;
}

struct Fed {
    /// `closing` is why the connection was closed; empty: by us.
    explicit Fed(std::string_view closing = {}) {
        const QString path = folder.filePath("a.usar");
        {
            auto writer = *link::RecordingWriter::create(
                path, {{"host", "sim"}, {"port", "3000"}, {"cell_size_m", "0.5"}, {"level", "flat"}}, {});
            writer->write({.kind = RecordKind::Opened, .bytes = "sim:3000"});
            writer->write({.kind = RecordKind::Out, .name = "session: connect", .bytes = "GETSTARTPOSES\r\n"});
            writer->write({.kind = RecordKind::In, .bytes = "NFO {Level flat}\r\n"});
            writer->write({.kind = RecordKind::Note, .line = {1}, .name = "fault", .bytes = "wind"});
            writer->write({.kind = RecordKind::Note, .line = {1}, .name = "mission", .bytes = "{}"});
            writer->write(
                {.kind = RecordKind::Note, .line = {1}, .name = "behavior", .bytes = "airrobot/cpp\tR1\t0 0 3 4"});
            writer->write({.kind = RecordKind::Note, .line = {1}, .name = "published", .bytes = textOf(scanning())});
            writer->write(
                {.kind = RecordKind::Note, .line = {1}, .name = "published", .bytes = textOf(agent::MapMark{})});
            writer->write({.kind = RecordKind::Note, .line = {1}, .name = "finished", .bytes = "1 Done."});
            writer->write({.kind = RecordKind::Closed, .line = {1}, .bytes = closing});
        }
        feed.begin(*link::RecordingReader::open(path));
    }
    bool playAll() {
        feed.order({.play = true, .speed = std::numeric_limits<double>::infinity()});
        return QTest::qWaitFor([this] { return stage.ended; });
    }

    QTemporaryDir folder;
    Stage stage;
    ReplayFeed feed{stage};
};

} // namespace

class tst_ReplayFeed : public QObject {
    Q_OBJECT
private slots:
    void aReplayBeginsWithItsFacts() {
        Fed fed;
        QVERIFY(fed.feed.on() && fed.feed.figures());
        QCOMPARE(fed.stage.told, (QStringList{"rewound", "began 0.5 flat", QString("link %1").arg(connecting)}));
        QCOMPARE(fed.feed.linkStatus().host, QString("sim"));
        QCOMPARE(fed.feed.linkStatus().port, quint16(3000));
    }

    void everyRecordBecomesWhatItWas() {
        Fed fed;
        fed.stage.told.clear();
        QVERIFY(fed.playAll());
        QCOMPARE(fed.stage.told,
                 (QStringList{"connected", QString("link %1").arg(connected), "0 > session: connect: GETSTARTPOSES",
                              "1: NFO {Level flat}", "fault wind", "mission {}", "task airrobot/cpp R1 4",
                              QString("published %1").arg(agent::Published(scanning()).index()),
                              QString("published %1").arg(agent::Published(agent::MapMark{}).index()),
                              "finished 1 Done.", "closed"}));
        QCOMPARE(fed.feed.traffic().lines_in, std::uint64_t(1));
        QCOMPARE(fed.feed.traffic().lines_out, std::uint64_t(1));
        QCOMPARE(fed.feed.traffic().bytes_out, std::uint64_t(15)); // with its line end
    }

    void aLostConnectionIsTold() {
        Fed fed("It hung up.");
        QVERIFY(fed.playAll());
        QCOMPARE(fed.stage.told.mid(fed.stage.told.size() - 2),
                 (QStringList{"lost", QString("link %1 It hung up.").arg(disconnected)}));
    }

    void onTheWayOnlyTheNewestOfAKindIsPassedOn() {
        Fed fed;
        fed.stage.told.clear();
        fed.feed.order({.seek = fed.feed.figures()->span});
        QVERIFY(QTest::qWaitFor([&] { return fed.stage.told.contains("arrives"); }));
        const QStringList& told = fed.stage.told;
        const QString status = QString("published %1").arg(agent::Published(scanning()).index());
        const QString mark = QString("published %1").arg(agent::Published(agent::MapMark{}).index());
        QCOMPARE(told.first(), QString("seeks"));
        QVERIFY(told.indexOf("passed scanning") > 0);
        QVERIFY2(told.indexOf(mark) < told.indexOf("arrives"), "what adds up is taken on the way");
        QVERIFY2(told.indexOf(status) > told.indexOf("arrives"), "of the rest the newest is enough");
        QVERIFY2(told.indexOf(QString("link %1").arg(connected)) > told.indexOf("arrives"), "and so of the link");
    }

    void theEndForgetsTheReplay() {
        Fed fed;
        fed.feed.end();
        QVERIFY(!fed.feed.on() && !fed.feed.figures());
        fed.stage.told.clear();
        fed.feed.order({.step = true});
        QVERIFY(fed.stage.told.isEmpty());
    }
};

USAR_TEST(tst_ReplayFeed)

} // namespace tst_replay_feed

#include "tst_replay_feed.moc"
