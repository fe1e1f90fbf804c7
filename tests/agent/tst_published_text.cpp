#include <limits>

#include <QTest>

#include "core/agent/published_text.h"
#include "tests/suite/suite.h"

namespace tst_published_text {

using namespace usar;
using namespace usar::agent;

class tst_PublishedText : public QObject {
    Q_OBJECT
private slots:
    void readsBackWhatItWrote_data();
    void readsBackWhatItWrote();
    void theTextsAreThoseOfTheDocument();
    void aStatusOfAnEarlierVersionHasNoRange();
    void whatIsNotANumberStaysNone();
    void rejectsTheRest_data();
    void rejectsTheRest();
};

void tst_PublishedText::readsBackWhatItWrote_data() {
    QTest::addColumn<agent::Published>("value");
    const Pose pose{{1.1, -2.0 / 3.0, 3e-9}, 0.1, -0.2, 3.14159};
    agent::BehaviorStatus status;
    QTest::newRow("a status that knows nothing") << agent::Published(status);
    status = {.time = Seconds{12.25},
              .elapsed = Seconds{3.5},
              .state = "scanning \"lane\" 4 of 9",
              .distance_to_goal_m = 1.5,
              .battery_used_pct = 30.25,
              .range_left_m = -0.5,
              .progress_pct = 1.0 / 3.0,
              .time_left = Seconds{99.0},
              .distance_flown_m = 412.0,
              .charges = 2,
              .paused = true,
              .time_left_range = TimeRange{Seconds{90.0}, Seconds{110.5}}};
    QTest::newRow("a status that knows all") << agent::Published(status);
    QTest::newRow("pose") << agent::Published(agent::PoseEstimate{Seconds{1.0}, pose});
    QTest::newRow("mark") << agent::Published(
        agent::MapMark{agent::MarkKind::GoalGivenUp, {1.0, 2.0, 3.0}, Seconds{4.0}, {5}});
    QTest::newRow("scan") << agent::Published(agent::ScanPlacement{{317}, pose});
    QTest::newRow("path") << agent::Published(agent::PlannedPath{{{1.0, 2.0}, {-3.0, 4.5}}});
    QTest::newRow("empty path") << agent::Published(agent::PlannedPath{});
    QTest::newRow("goal") << agent::Published(agent::CurrentGoal{Vec3{-1.0, 2.0, 3.0}});
    QTest::newRow("no goal") << agent::Published(agent::CurrentGoal{});
    QTest::newRow("zones") << agent::Published(
        agent::SonarZones{{{"F1", 0.5, 4.0, 5.0, 2.0, 1.0, agent::Risk::Low}, {"a b", -0.5, 1, 5, 2, 1, {}}}});
    QTest::newRow("event") << agent::Published(agent::BehaviorEvent{Severity::Error, "The wind,\nthe wind"});
    QTest::newRow("trace") << agent::Published(agent::PlanTrace{std::string("USAR\0\xff\n\"", 8)});
    QTest::newRow("halted at a breakpoint") << agent::Published(
        agent::PlanHalted{1234, Seconds{80.2}, agent::BreakpointId{3}, "/P:0/DC:0", "before robot ▸ work"});
    QTest::newRow("halted behind a step")
        << agent::Published(agent::PlanHalted{.cycle = 5, .time = Seconds{1.0}, .reason = "one cycle further"});
    QTest::newRow("resumed") << agent::Published(agent::PlanResumed{});
    QTest::newRow("a plan that was kept")
        << agent::Published(agent::PlanReplaced{agent::PlanFate::Kept, "a.lap", 7, {}, {}});
    posh::Finding open{posh::Code::EndOfFile, {9, 1, 200, 0}, "the file ends; write a \")\"", posh::Spot{1, 2, 1, 1}};
    QTest::newRow("a plan that was refused")
        << agent::Published(agent::PlanReplaced{agent::PlanFate::Refused,
                                                "b.lap",
                                                8,
                                                "It has errors.",
                                                {open, {posh::Code::NeverUsed, {2, 3, 14, 5}, "x", {}}}});
    QTest::newRow("finished") << agent::Published(agent::BehaviorFinished{true, "Landed."});
    QTest::newRow("finished without sensors")
        << agent::Published(agent::BehaviorFinished{false, "It lacks two.", {"INS", "Sonar L4"}});
}

void tst_PublishedText::readsBackWhatItWrote() {
    QFETCH(agent::Published, value);
    std::string text;
    appendText(text, value);
    QVERIFY(text.find('\n') == std::string::npos);
    const auto read = readPublished(text);
    QVERIFY2(read, text.c_str());
    QVERIFY2(*read == value, text.c_str());
}

void tst_PublishedText::theTextsAreThoseOfTheDocument() {
    std::string text;
    appendText(text, agent::ScanPlacement{{317}, {{1.0, -2.0, 3.5}, 0.0, 0.0, 1.5}});
    QCOMPARE(text, std::string("scan 317 1 -2 3.5 0 0 1.5"));
}

void tst_PublishedText::aStatusOfAnEarlierVersionHasNoRange() {
    const auto read = readPublished(R"(status 12 3 "scanning" - - - 40 99 412 2 0)");
    QVERIFY(read);
    const auto& status = std::get<agent::BehaviorStatus>(*read);
    QCOMPARE(status.time_left->count(), 99.0);
    QVERIFY(!status.time_left_range);
    QVERIFY(!readPublished(R"(status 12 3 "scanning" - - - 40 99 412 2 0 90)"));
}

void tst_PublishedText::whatIsNotANumberStaysNone() {
    std::string text;
    appendText(text, agent::PoseEstimate{Seconds{1.0}, {{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}}});
    const auto read = readPublished(text);
    QVERIFY2(read, text.c_str());
    QVERIFY(std::isnan(std::get<agent::PoseEstimate>(*read).base_in_map.position_m.x()));
}

void tst_PublishedText::rejectsTheRest_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("nothing") << QByteArray("");
    QTest::newRow("another word") << QByteArray("dance 1 2");
    QTest::newRow("a field missing") << QByteArray("pose 1 2 3 4 5 6");
    QTest::newRow("a field too many") << QByteArray("goal 1 2 3 4");
    QTest::newRow("a word for a number") << QByteArray("goal 1 two 3");
    QTest::newRow("half a point") << QByteArray("path 1 2 3");
    QTest::newRow("a mark of no kind") << QByteArray("mark 99 1 2 3 4 5");
    QTest::newRow("a text without quotes") << QByteArray("event 1 wind");
}

void tst_PublishedText::rejectsTheRest() {
    QFETCH(QByteArray, text);
    QVERIFY(!readPublished(text.toStdString()));
}

USAR_TEST(tst_PublishedText)

} // namespace tst_published_text

#include "tst_published_text.moc"
