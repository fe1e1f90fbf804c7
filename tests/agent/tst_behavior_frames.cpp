#include <QByteArray>
#include <QObject>
#include <QTest>

#include "core/agent/process/behavior_frames.h"
#include "tests/suite/suite.h"

namespace tst_behavior_frames {

using namespace usar;
using namespace usar::agent;
using namespace usar::agent::frames;

namespace {

PlanControl passed(const PlanControl& control) {
    const auto read = readRequest(write(Request(control)));
    return read && std::holds_alternative<PlanControl>(*read) ? std::get<PlanControl>(*read) : PlanControl();
}

Answer fullAnswer() {
    Answer answer;
    const Cause cause{by::Plan{"robot/posh", "work ▸ fly", "low"}, {41}};
    answer.output.commands = {{protocol::AerialDrive{0.1, 1.0 / 3.0, {}, -0.25}, cause},
                              {protocol::GetConfiguration{.type = "Sonar", .name = "F1"}, cause},
                              {protocol::RawCommand{"DRIVE {Left 1.0} {Right 2.0}"}, cause}};
    BehaviorStatus status;
    status.time = Seconds{1.5};
    status.state = "flying";
    answer.output.published = {status, PlanTrace{std::string("\0\x7f\xff\n", 4)}, BehaviorFinished{true, "Done."}};
    answer.safe = protocol::SkidDrive{0.0, 0.0};
    answer.halted = answer.finished = true;
    return answer;
}

} // namespace

class tst_BehaviorFrames : public QObject {
    Q_OBJECT
private slots:
    void answersCrossWithoutLoss() {
        const Answer answer = fullAnswer();
        const auto read = readReply(write(Reply(answer)));
        QVERIFY(read && std::holds_alternative<Answer>(*read));
        const Answer& got = std::get<Answer>(*read);
        QVERIFY(got.output.commands == answer.output.commands); // a raw line stays raw
        QVERIFY(got.output.published == answer.output.published);
        QVERIFY(got.safe == answer.safe);
        QVERIFY(got.halted && got.finished);
    }

    void aStartCrossesWithoutLoss() {
        const Start start{
            .plugin_file = "/robots/a b.so",
            .job = {.behavior_id = "a/b",
                    .task = {"R1", {{1.0, -2.0, 0.3}, 0.1, 0.2, 0.3}, {{-1.0, -2.0}, {3.0, 4.0}}},
                    .parameters = {{"flag", true}, {"whole", -7LL}, {"real", 0.1}, {"text", std::string("grüße\n")}},
                    .plan = PlanText{"own.lap", "((DC d))"}}};
        const auto read = readRequest(write(Request(start)));
        QVERIFY(read && std::holds_alternative<Start>(*read));
        const Start& got = std::get<Start>(*read);
        QCOMPARE(got.plugin_file, start.plugin_file);
        QCOMPARE(got.job.behavior_id, start.job.behavior_id);
        QVERIFY(got.job.task == start.job.task);
        QVERIFY(got.job.parameters == start.job.parameters);
        QVERIFY(got.job.plan == start.job.plan);
    }

    void everyControlOfAPlanCrossesWithoutLoss() {
        const PlanControl controls[]{ReplacePlan{{"new.lap", "((DC d (drives ((a b)))))"}},
                                     SetBreakpoints{{{3,
                                                      {.path = "/P:0/DC:0",
                                                       .names = "robot ▸ work",
                                                       .on = posh::BreakOn::Result,
                                                       .result = posh::ActResult::Running,
                                                       .key = "lane",
                                                       .condition = "(distance 0.3 <)",
                                                       .skip = 7,
                                                       .once = true,
                                                       .enabled = false}}}},
                                     SetPins{.senses = {{"near(1)", posh::Value(0.5)},
                                                        {"color", posh::Value(posh::Symbol{"red"})},
                                                        {"none", posh::Value()},
                                                        {"count", posh::Value(std::int64_t{1} << 40)}},
                                             .acts = {{"fly(\"lake\")", posh::ActResult::Finished}},
                                             .drives_off = {{"/P:0", "d"}}},
                                     PlanStep::Cycle};
        for (const PlanControl& control : controls)
            QVERIFY(passed(control) == control);
    }

    void refusalsAndLastWordsCross() {
        const Error error{"what", "where", "mend"};
        QVERIFY(std::get<Error>(*readReply(write(Reply(error)))) == error);
        QCOMPARE(std::get<Dying>(*readReply(write(Reply(Dying{11})))).signal, 11);
        QVERIFY(std::get<Order>(*readRequest(write(Request(Order::LandNow)))) == Order::LandNow);
    }

    void refusesEveryPrefixAndAnotherVersion() {
        const QByteArray whole = write(Reply(fullAnswer()));
        for (qsizetype bytes = 0; bytes < whole.size(); ++bytes)
            QVERIFY2(!readReply(whole.left(bytes)), QByteArray::number(bytes));
        QByteArray newer = whole;
        newer[3] = static_cast<char>(version + 1);
        QVERIFY(!readReply(newer));
        QVERIFY(!readRequest(QByteArray(64, '\xff')));
    }
};

USAR_TEST(tst_BehaviorFrames)

} // namespace tst_behavior_frames

#include "tst_behavior_frames.moc"
