// Frames about plugins, every enumerator that crosses, and frames that are damaged.
#include <QByteArray>
#include <QTest>

#include "core/agent/process/behavior_frames.h"
#include "core/base/random.h"
#include "tests/suite/suite.h"

namespace tst_frame_contents {

using namespace usar;
using namespace usar::agent;
using namespace usar::agent::frames;

namespace {

constexpr qsizetype kind_at = 7;   ///< last byte of the index of a request or reply
constexpr qsizetype value_at = 11; ///< last byte of a request that is only an enumerator

RobotDescription rover() {
    BehaviorDescription behavior;
    behavior.id = "toy/posh";
    behavior.name = "Spähen";
    behavior.help = "It looks around.";
    behavior.needs_area = true;
    behavior.parameters = {{"time_s", "Time", "Run", "s", 1.5, 0.0, 9.0, "How long.", {}},
                           {"shape", "Shape", "Run", "", std::string("lanes"), 0.0, 0.0, "", {"lanes", "spiral"}},
                           {"count", "Count", "", "", -3LL, -9.0, 9.0, "", {}, "none"},
                           {"loud", "Loud", "", "", true, 0.0, 0.0, "", {}}};
    behavior.plan_name = "own.lap";
    behavior.plan_text = "((DC d))";
    PrimitiveDescription sense;
    sense.name = "Near";
    sense.parameters = {PoshParameter::number("than", 0.5, "m", 0.0, 20.0, "Limit."),
                        PoshParameter::symbol("side", "left", {"left", "right"})};
    sense.answer = AnswerType::Symbol;
    sense.unit = "m";
    sense.needs = {"Sonar", "INS"};
    sense.minimum = -1.0;
    sense.maximum = 1e300;
    sense.choices = {"yes", "no"};
    PrimitiveDescription act;
    act.name = "Halt";
    act.kind = PrimitiveKind::Act;
    return {"USARBot.Toy", "Toy", {"INS"}, {behavior, {}}, {sense, act}};
}

Job job() {
    return {.behavior_id = "toy/posh",
            .task = {"R1", {{1.0, 2.0, 3.0}, 0.1, 0.2, 0.3}, {{0.0, 0.0}, {5.0, 6.0}}},
            .parameters = {{"time_s", 2.5}},
            .plan = {}};
}

} // namespace

class tst_FrameContents : public QObject {
    Q_OBJECT
private slots:
    void aDescriptionCrossesWithoutLoss() {
        const RobotDescription sent = rover();
        const auto read = readReply(write(Reply(sent)));
        QVERIFY(read && std::holds_alternative<RobotDescription>(*read));
        const RobotDescription& got = std::get<RobotDescription>(*read);
        QCOMPARE(got.class_name, sent.class_name);
        QCOMPARE(got.name, sent.name);
        QVERIFY(got.sensors_needed == sent.sensors_needed);
        QVERIFY(got.primitives == sent.primitives);
        QCOMPARE(got.behaviors.size(), sent.behaviors.size());
        for (std::size_t i = 0; i < sent.behaviors.size(); ++i) {
            QCOMPARE(got.behaviors[i].id, sent.behaviors[i].id);
            QCOMPARE(got.behaviors[i].name, sent.behaviors[i].name);
            QCOMPARE(got.behaviors[i].help, sent.behaviors[i].help);
            QCOMPARE(got.behaviors[i].needs_area, sent.behaviors[i].needs_area);
            QVERIFY(got.behaviors[i].parameters == sent.behaviors[i].parameters);
            QCOMPARE(got.behaviors[i].plan_name, sent.behaviors[i].plan_name);
            QCOMPARE(got.behaviors[i].plan_text, sent.behaviors[i].plan_text);
        }
    }

    void aPreviewAndItsRequestCrossWithoutLoss() {
        const auto asked = readRequest(write(Request(job())));
        QVERIFY(asked && std::holds_alternative<Job>(*asked));
        QCOMPARE(std::get<Job>(*asked).behavior_id, job().behavior_id);
        QVERIFY(std::get<Job>(*asked).task == job().task);
        QVERIFY(std::get<Job>(*asked).parameters == job().parameters);
        QVERIFY(!std::get<Job>(*asked).plan);
        TaskPreview sent{{{1.0, -2.0}, {1e-300, 4.0}}, 12.5, Seconds{90.25}, "6 lanes"};
        sent.outlook = {{Seconds(80.5), Seconds(99.75)}, 3, 4, 92.5, 98.25};
        const auto read = readReply(write(Reply(sent)));
        QVERIFY(read && std::holds_alternative<TaskPreview>(*read));
        const TaskPreview& got = std::get<TaskPreview>(*read);
        QVERIFY(got.path_in_map_m == sent.path_in_map_m);
        QCOMPARE(got.length_m, sent.length_m);
        QCOMPARE(got.duration.count(), sent.duration.count());
        QCOMPARE(got.summary, sent.summary);
        QVERIFY(got.outlook == sent.outlook);
    }

    void linesAndValuesCrossWithoutLoss_data() {
        QTest::addColumn<quint64>("number");
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("a line") << quint64(41) << QByteArray("STA {Time 1.5}");
        QTest::newRow("an empty one") << quint64(0) << QByteArray();
        QTest::newRow("bytes that are no text") << quint64(1) << QByteArray("\0\xff\r\n{", 5);
        QTest::newRow("the last number") << ~quint64(0) << QByteArray("x");
        QTest::newRow("a long one") << quint64(2) << QByteArray(1 << 20, 'x');
    }
    void linesAndValuesCrossWithoutLoss() {
        QFETCH(quint64, number);
        QFETCH(QByteArray, text);
        const auto read = readRequest(write(Request(Line{{number}, text.toStdString()})));
        QVERIFY(read && std::holds_alternative<Line>(*read));
        QCOMPARE(std::get<Line>(*read).number.value, number);
        QCOMPARE(QByteArray::fromStdString(std::get<Line>(*read).text), text);
    }

    void anEnumeratorBeyondTheLastIsRefused_data() {
        QTest::addColumn<QByteArray>("frame");
        QTest::addColumn<int>("last");
        QTest::newRow("orders") << write(Request(Order::Pause)) << int(Order::LandNow);
        QByteArray step = write(Request(PlanControl(PlanStep::Halt)));
        QTest::newRow("steps") << step << int(PlanStep::Cycle);
    }
    void anEnumeratorBeyondTheLastIsRefused() {
        QFETCH(QByteArray, frame);
        QFETCH(int, last);
        for (int value = 0; value < 6; ++value) {
            frame.back() = static_cast<char>(value);
            QCOMPARE(readRequest(frame).has_value(), value <= last);
        }
        frame.back() = static_cast<char>(-1); // the others are 0, so this is 255
        QVERIFY(!readRequest(frame));
        QVERIFY(frame.size() >= value_at + 1);
    }

    void anUnknownKindOfFrameIsRefused() {
        QByteArray request = write(Request(Order::Pause));
        request[kind_at] = static_cast<char>(std::variant_size_v<Request>);
        QVERIFY(!readRequest(request));
        QByteArray reply = write(Reply(Dying{9}));
        reply[kind_at] = static_cast<char>(std::variant_size_v<Reply>);
        QVERIFY(!readReply(reply));
    }

    void everyPrefixIsRefused_data() {
        QTest::addColumn<QByteArray>("frame");
        QTest::addColumn<bool>("is_request");
        QTest::newRow("a description") << write(Reply(rover())) << false;
        QTest::newRow("a preview") << write(Reply(TaskPreview{{{1.0, 2.0}}, 3.0, Seconds{4.0}, "5"})) << false;
        QTest::newRow("a start") << write(Request(Start{"/a.so", job()})) << true;
        QTest::newRow("a job") << write(Request(job())) << true;
        QTest::newRow("a question") << write(Request(Describe{"/a.so"})) << true;
    }
    void everyPrefixIsRefused() {
        QFETCH(QByteArray, frame);
        QFETCH(bool, is_request);
        for (qsizetype bytes = 0; bytes < frame.size(); ++bytes) {
            const QByteArray prefix = frame.left(bytes);
            QVERIFY2(is_request ? !readRequest(prefix) : !readReply(prefix), QByteArray::number(bytes));
        }
        QVERIFY(is_request ? readRequest(frame).has_value() : readReply(frame).has_value());
    }

    void damagedBytesNeverCrash() {
        Random random = seeded(5, 1);
        const QByteArray frames[] = {write(Reply(rover())), write(Request(Start{"/a.so", job()}))};
        std::uniform_int_distribution<int> byte(0, 255);
        for (int i = 0; i < 4000; ++i) {
            QByteArray damaged = frames[i % 2];
            std::uniform_int_distribution<qsizetype> place(4, damaged.size() - 1);
            for (int change = 0; change < 3; ++change)
                damaged[place(random)] = static_cast<char>(byte(random));
            if (i % 2 == 0) {
                if (const auto read = readReply(damaged))
                    QVERIFY(readReply(write(*read)));
            } else if (const auto read = readRequest(damaged)) {
                QVERIFY(readRequest(write(*read)));
            }
        }
    }
};

USAR_TEST(tst_FrameContents)

} // namespace tst_frame_contents

#include "tst_frame_contents.moc"
